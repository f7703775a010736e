"""Numbers of SymPy expressions by SymPy's own functions; nothing of :mod:`cardan.ir`. Loads SymPy.

They are the judge of what was compiled, and so may share no code with it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import sympy


def numbers(expressions: Sequence[sympy.Expr], values: Mapping[sympy.Expr, float]) -> list[float]:
    """Values of expressions; NaN where one has none among real numbers.

    Args:
        expressions: In SymPy.
        values: Symbol, function of time or derivative -> its value.
    """
    evaluator = _Numbers(values)
    return [evaluator.of(sympy.sympify(e, strict=True)) for e in expressions]


class _Numbers:
    """Values of all parts of some expressions, each found once."""

    def __init__(self, values: Mapping[sympy.Expr, float]) -> None:
        self.done: dict[sympy.Expr, float] = dict(values)
        self.leaves = {x: sympy.Float(value) for x, value in values.items()}

    def of(self, root: sympy.Expr) -> float:
        stack, done = [root], self.done
        while stack:
            e = stack[-1]
            waiting = [x for x in e.args if x not in done] if e not in done and _parted(e) else []
            if waiting:
                stack.extend(waiting)
                continue
            if e not in done:
                done[e] = self._value(e)
            stack.pop()
        return done[root]

    def _value(self, e: sympy.Expr) -> float:
        """Value of an expression whose parts are known."""
        done = self.done
        try:
            if isinstance(e, sympy.Add):
                return math.fsum(done[x] for x in e.args)
            if isinstance(e, sympy.Mul):
                return math.prod(done[x] for x in e.args)
            if isinstance(e, sympy.Pow):
                power = done[e.base] ** done[e.exp]
                return power if isinstance(power, float) else math.nan
            if not _parted(e):
                # SymPy decides between cases
                return float(e if e.is_Atom else e.xreplace(self.leaves))
            return float(e.func(*(sympy.Float(done[x]) for x in e.args)))
        except (TypeError, ValueError, OverflowError, ZeroDivisionError):
            return math.nan


def _parted(e: sympy.Expr) -> bool:
    """True when the parts of an expression are numbers themselves."""
    return not (e.is_Atom or isinstance(e, (sympy.Piecewise, sympy.logic.boolalg.Boolean)))
