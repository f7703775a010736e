"""The passes: each takes a Function and gives one of the same value that runs faster."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ..ir.function import Function, Staged
from .fold import fold
from .schedule import schedule
from .stage import stage
from .unroll import unroll

PASSES: dict[str, Callable[[Function], Function]] = {
    "unroll": unroll,
    "fold": fold,
}

STANDARD = ("unroll",)


def optimize(function: Function, passes: Sequence[str] = STANDARD) -> Staged:
    """Run passes by name, then separate the parameters' part and order the statements."""
    for name in passes:
        function = PASSES[name](function)
    return schedule(stage(function))


__all__ = [
    "PASSES",
    "STANDARD",
    "Function",
    "Staged",
    "fold",
    "optimize",
    "schedule",
    "stage",
    "unroll",
]
