"""Constraints of written equations: their rates, and which of them are told twice. Loads SymPy."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
import sympy

from ...arrays import Array
from ...errors import ModelError
from ...records import dataclass
from .names import DERIVED, Names
from .numbers import numbers
from .sources import Source

# of the rows of a constraint Jacobian, each of length 1
DEPENDENT = 1e-9
# of a position on the constraints
CLOSED = 1e-13
STEPS = 60


@dataclass(frozen=True)
class Bound:
    """Kinematics and constraints in plain symbols, which have the names of what they stand for.

    Attributes:
        q, u: Symbols.
        rates: q' in them.
        positions, speeds: By name, what is kept at 0.
        input_rates: Symbol of an input that constraints have -> symbol of its derivative.
    """

    q: tuple[sympy.Expr, ...]
    u: tuple[sympy.Expr, ...]
    rates: tuple[sympy.Expr, ...]
    positions: Mapping[str, sympy.Expr]
    speeds: Mapping[str, sympy.Expr]
    input_rates: Mapping[sympy.Expr, sympy.Expr]

    def rate(self, expressions: Sequence[sympy.Expr]) -> list[sympy.Expr]:
        """Time derivatives at u' = 0."""
        moving = [*zip(self.q, self.rates, strict=True), (sympy.Symbol("t"), sympy.Integer(1))]
        moving += self.input_rates.items()
        return [
            sympy.Add(*(e.diff(x) * along for x, along in moving if e.has(x))) for e in expressions
        ]

    @cached_property
    def velocities(self) -> list[sympy.Expr]:
        """Everything that vanishes at velocity level: rates of positions, then speeds."""
        return [*self.rate([*self.positions.values()]), *self.speeds.values()]

    @cached_property
    def jacobian(self) -> list[sympy.Expr]:
        """G, row by row."""
        return [e.diff(x) for e in self.velocities for x in self.u]

    @cached_property
    def gamma(self) -> list[sympy.Expr]:
        """G u' = gamma."""
        return [-e for e in self.rate(self.velocities)]

    def at(self, expressions: Sequence[sympy.Expr], values: Mapping[sympy.Expr, float]) -> Array:
        """Numbers of expressions in plain symbols."""
        return np.array(numbers(expressions, values), dtype=np.float64)

    def matrix(self, values: Mapping[sympy.Expr, float]) -> Array:
        """G (m, nu) as numbers."""
        return self.at(self.jacobian, values).reshape(-1, len(self.u))

    def moved(self, values: Mapping[sympy.Expr, float]) -> dict[sympy.Expr, float] | None:
        """The values with q and u on the constraints; None where Newton's method fails."""
        solution = dict(values)
        positions = [*self.positions.values()]
        slopes = [e.diff(x) for e in positions for x in self.q]
        for _ in range(STEPS if positions else 0):
            g = self.at(positions, solution)
            slope = self.at(slopes, solution).reshape(len(positions), -1)
            if not (np.isfinite(g).all() and np.isfinite(slope).all()):
                return None
            step = np.linalg.lstsq(slope, -g)[0]
            solution |= {x: solution[x] + float(d) for x, d in zip(self.q, step, strict=True)}
            if np.abs(step).max(initial=0.0) <= CLOSED:
                break
        else:
            if positions:
                return None
        missing = self.at(self.velocities, solution)
        G = self.matrix(solution)
        if not (np.isfinite(G).all() and np.isfinite(missing).all()):
            return None
        step = np.linalg.lstsq(G, -missing)[0] if len(G) else np.zeros(len(self.u))
        return solution | {x: solution[x] + float(d) for x, d in zip(self.u, step, strict=True)}

    def independent(self, G: Array) -> list[str]:
        """Names of the constraints of speeds that do not follow from positions.

        Args:
            G: (m, nu) at a position on the constraints, rows as of :attr:`velocities`.

        Raises:
            ModelError: they do not have the derivatives of positions among them.
        """
        count = len(self.positions)
        rows = G / np.maximum(np.linalg.norm(G, axis=1, keepdims=True), 1e-300)
        basis, names = rows[:count], list[str]()
        for name, row in zip(self.speeds, rows[count:], strict=True):
            grown = np.vstack([basis, row])
            if _rank(grown) > _rank(basis):
                basis, names = grown, [*names, name]
        if _rank(basis) > _rank(rows[count:]):
            raise ModelError(
                "from_sympy: velocity_constraints= of a KanesMethod must have the derivatives of "
                "its configuration_constraints=, which SymPy does not add; here they allow motions "
                f"that {', '.join(self.positions)} forbid"
            )
        return names


def _rank(rows: Array) -> int:
    return int(np.linalg.matrix_rank(rows, tol=DEPENDENT)) if len(rows) else 0


def plain(names: Names, source: Source) -> dict[sympy.Expr, sympy.Expr]:
    """Functions of time -> plain symbols, derivatives of coordinates -> their expressions."""
    t = next(x for x, name in names.names.items() if name == "t")
    base = {x: sympy.Symbol(name) for x, name in names.names.items()}
    base |= {d: 0 for x in source.zero for d in (x, x.diff(t))}
    rates = zip(source.q, source.rates, strict=True)
    return {x.diff(t): rate.xreplace(base) for x, rate in rates} | base


def bound_of(names: Names, source: Source, replaced: Mapping[sympy.Expr, sympy.Expr]) -> Bound:
    """Kinematics and constraints of a source in plain symbols."""
    positions, speeds = (
        {name: sympy.sympify(e, strict=True).xreplace(replaced) for name, e in part.items()}
        for part in (source.positions, source.speeds)
    )
    expressions = [*positions.values(), *speeds.values()]
    symbols = {x.name for e in expressions for x in e.free_symbols}
    input_rates = dict[Any, Any]()
    for name in (name for name in names.inputs.values() if name in symbols):
        chain = [f"{name}{suffix}" for suffix in DERIVED]
        input_rates |= {sympy.Symbol(a): sympy.Symbol(b) for a, b in pairwise(chain)}
    return Bound(
        tuple(sympy.Symbol(name) for name in names.q),
        tuple(sympy.Symbol(name) for name in names.u),
        tuple(sympy.sympify(e, strict=True).xreplace(replaced) for e in source.rates),
        positions,
        speeds,
        input_rates,
    )
