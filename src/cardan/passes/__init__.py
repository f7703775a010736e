"""The passes: each takes a Function and gives one of the same value that runs faster."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ..ir.function import Function, Staged
from ..ir.grammar import check
from ..ir.stage import stage
from .fold import fold
from .reassociate import reassociate
from .trig import trig
from .unroll import unroll

PASSES: dict[str, Callable[[Function], Function]] = {
    "unroll": unroll,
    "trig": trig,
    "fold": fold,
    "reassociate": reassociate,
}

# rows of the systems that joints with several speeds bring
SMALL = 6


def standard(function: Function) -> tuple[str, ...]:
    """Passes that pay for a function, as measured.

    Factorizations are unrolled, and sums reassociated where no large factorization dominates.
    ``trig`` and ``fold`` are exact too, but save an operation in a thousand in the recursions of
    rigid bodies.
    """
    nodes = function.graph.nodes
    kinds = (nodes[i][1:3] for i in function.live() if nodes[i][0] == "solve")
    rows = [n for kind, n in kinds if kind == "spd"]
    unrolled = ("unroll",) if rows else ()
    return unrolled if max(rows, default=0) > SMALL else (*unrolled, "reassociate")


def optimize(function: Function, passes: Sequence[str] | None = None) -> Staged:
    """Run passes, then separate the parameters' part.

    Statements keep the order of creation, which goes from body to body: depth-first from the
    results was measured up to 12 % slower in the C that is written.

    Args:
        function: The function as it was derived.
        passes: Names from ``PASSES``, in their order; by default those of :func:`standard`.

    Raises:
        ValueError: the function, or what a pass made of it, breaks a rule of the grammar.
    """
    check(function)
    for name in standard(function) if passes is None else passes:
        made = PASSES[name](function)
        function = made if made is function else check(made)
    return stage(function)


__all__ = ["PASSES", "Staged", "optimize", "stage", "standard"]
