"""The scenes: every two features, and every feature and use, meet in one of them."""

from __future__ import annotations

from collections.abc import Iterable

from .covering import covering
from .features import PRESENT
from .uses import USES

SIZE = 7


def ordered(names: Iterable[str]) -> tuple[str, ...]:
    """Features in the order of the table, then uses; what they require is added to the scene."""
    every = {*names}
    return tuple(name for name in (*PRESENT, *USES) if name in every)


SCENES: tuple[tuple[str, ...], ...] = tuple(covering((*PRESENT, *USES), SIZE, ordered))
