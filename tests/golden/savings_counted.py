"""What every rewrite and every pass saves, counted on a function."""

from __future__ import annotations

from typing import NamedTuple

from cardan.equations.record import EquationRecord
from cardan.ir.function import Function
from cardan.ir.stage import stage
from cardan.passes import PASSES, standard


class Saving(NamedTuple):
    """What one rewrite or pass does.

    Attributes:
        name: Of the rewrite or pass.
        operations: Operations at every call less than before.
        critical_path: Cost of the longest chain of dependent operations less than before.
    """

    name: str
    operations: int
    critical_path: float


def savings(equations: EquationRecord, name: str, of: str | None = None) -> list[Saving]:
    """The rewrites that a function was derived from and the passes it went through.

    A rewrite saves what the function would take more without it; a pass, what it takes off what
    those before it left. Factorizations are unrolled first, so that they are counted.
    """
    applied = equations.rewritten(name, of)
    function = equations.function(name, of)
    whole = PASSES["unroll"](function)
    found: list[Saving] = []
    for rewrite in applied:
        rest = equations.with_rewrites(tuple(key for key in applied if key != rewrite))
        found.append(_saving(rewrite, PASSES["unroll"](rest.function(name, of)), whole))
    for key in (key for key in standard(function) if key in PASSES and key != "unroll"):
        before, whole = whole, PASSES[key](whole)
        found.append(_saving(key, before, whole))
    return found


def _saving(name: str, before: Function, after: Function) -> Saving:
    a, b = stage(before), stage(after)
    fewer = sum(a.operations().values()) - sum(b.operations().values())
    return Saving(name, fewer, a.critical_path() - b.critical_path())
