"""The passes: each takes a Function and gives one of the same value that runs faster."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ..ir.function import Function, Staged
from ..ir.grammar import check
from .fold import fold
from .reassociate import reassociate
from .schedule import schedule
from .stage import stage
from .trig import trig
from .unroll import unroll

PASSES: dict[str, Callable[[Function], Function]] = {
    "unroll": unroll,
    "trig": trig,
    "fold": fold,
    "reassociate": reassociate,
}

# run when nothing else is asked for: the others are exact too, but in the recursions of rigid
# bodies they save an operation in a thousand (trig, fold) or cost more than they give (reassociate)
STANDARD = ("unroll",)


def optimize(function: Function, passes: Sequence[str] = STANDARD) -> Staged:
    """Run passes, then separate the parameters' part and order the statements.

    Args:
        function: The function as it was derived.
        passes: Names from ``PASSES``, in their order.

    Raises:
        ValueError: the function, or what a pass made of it, breaks a rule of the grammar.
    """
    check(function)
    for name in passes:
        made = PASSES[name](function)
        function = made if made is function else check(made)
    return schedule(stage(function))


__all__ = ["PASSES", "STANDARD", "Staged", "optimize", "schedule", "stage"]
