"""The scenes: every two features, and every feature and use, meet in one of them."""

from __future__ import annotations

from collections.abc import Iterable

from .covering import covering
from .features import PRESENT, closed
from .uses import USES

SIZE = 7


def complete(names: Iterable[str]) -> tuple[str, ...]:
    """Features with what they require, then uses."""
    every = [*names]
    uses = tuple(use for use in USES if use in every)
    return (*closed(name for name in every if name not in USES), *uses)


SCENES: tuple[tuple[str, ...], ...] = tuple(covering((*PRESENT, *USES), SIZE, complete))
