"""Mutants of saved motions and ensembles: damage is found, malice does no harm."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from hostile import saved_kinds
from hostile.harness import Kind, campaign

SEED = 23
KINDS: dict[str, Callable[[Path], Kind]] = {
    **{
        f"motion {name}": (lambda folder, name=name: saved_kinds.motion(name, folder))
        for name in saved_kinds.MOTIONS
    },
    "ensemble": saved_kinds.ensemble,
    "checkpoint": saved_kinds.checkpoint,
    "part": saved_kinds.part,
}
QUICK = ("motion ball", "motion archived ball", "motion blade", "ensemble", "checkpoint", "part")


def _quick(names: tuple[str, ...]) -> list[object]:
    marks = [pytest.mark.slow]
    return [pytest.param(n, marks=[] if n in names else marks) for n in KINDS]


@pytest.mark.parametrize("name", _quick(QUICK))
def test_mutants_of_saved_files_do_no_harm(name: str, tmp_path: Path) -> None:
    tally = campaign(KINDS[name](tmp_path / "good"), 50, SEED, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)


@pytest.mark.slow
@pytest.mark.parametrize("name", KINDS)
def test_two_thousand_mutants_of_saved_files(name: str, tmp_path: Path) -> None:
    tally = campaign(KINDS[name](tmp_path / "good"), 2000, SEED + 1, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)
