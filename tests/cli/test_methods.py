"""The command line names every formalism."""

from __future__ import annotations

from cardan.cli.options import scene
from cardan.equations.formalisms import FORMALISMS


def test_help_lists_every_formalism() -> None:
    assert [name.partition(" ")[0] for name in scene.METHODS] == ["auto", *FORMALISMS]
