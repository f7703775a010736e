"""Equations as users of SymPy's mechanics package expect them: functions of time. Loads SymPy."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import field
from typing import TYPE_CHECKING

import sympy
from sympy.physics.mechanics import dynamicsymbols

from ...records import dataclass
from ..constraints.constraints import POSITION

if TYPE_CHECKING:
    from .readable import Readable


@dataclass(frozen=True)
class Mechanics:
    """M u' = forcing with coordinates and speeds as functions of time, like ``KanesMethod``.

    Attributes:
        t: The time.
        q: Coordinates q(t), (nq, 1).
        u: Speeds u(t), (nu, 1).
        mass_matrix: M (nu, nu).
        forcing: f - h (nu, 1): everything that is not M u'.
        kinematics: Right-hand side of q' = N u + n, (nq, 1).
        parameters: Symbol -> default value.
        inputs: Inputs r(t), (nr,).
        constraints: Name -> expression of q and t that is kept at 0.
        velocity_constraints: Name -> expression linear in u that is kept at 0 and is not a
            derivative of these. M u' = forcing + Gᵀ lam where there are any.
    """

    t: sympy.Expr
    q: sympy.Matrix
    u: sympy.Matrix
    mass_matrix: sympy.Matrix
    forcing: sympy.Matrix
    kinematics: sympy.Matrix
    parameters: dict[sympy.Expr, float]
    inputs: tuple[sympy.Expr, ...]
    constraints: dict[str, sympy.Expr] = field(default_factory=dict)
    velocity_constraints: dict[str, sympy.Expr] = field(default_factory=dict)

    def kindiffdict(self) -> dict[sympy.Expr, sympy.Expr]:
        """q' -> its expression in q and u."""
        return dict(zip(self.q.diff(self.t), self.kinematics, strict=True))

    @property
    def mass_matrix_full(self) -> sympy.Matrix:
        """Matrix of [q', u'] (nq + nu, nq + nu)."""
        return sympy.diag(sympy.eye(len(self.q)), self.mass_matrix)

    @property
    def forcing_full(self) -> sympy.Matrix:
        """Right-hand side to it (nq + nu, 1)."""
        return self.kinematics.col_join(self.forcing)

    def rhs(self) -> sympy.Matrix:
        """[q', u'] solved for (nq + nu, 1); long for more than a few coordinates."""
        return self.kinematics.col_join(self.mass_matrix.LUsolve(self.forcing))


def mechanics(equations: Readable) -> Mechanics:
    """The equations with functions of time for q, u and r.

    Raises:
        DerivationError: they are too long to be written out.
    """
    moving = _functions(equations)
    names = equations.symbols
    as_functions = {names[key]: function for key, function in moving.items()}
    time = dynamicsymbols._t
    as_functions[names["t", 0]] = time

    def written(matrix: sympy.Matrix) -> sympy.Matrix:
        return matrix.xreplace(as_functions)

    def column(letter: str) -> list[sympy.Expr]:
        return [moving[letter, k] for k in range(len(equations.blocks[letter]))]

    q, u = column("q"), column("u")
    position_constraints, slipping = _constraints(equations, written)
    return Mechanics(
        t=time,
        q=sympy.Matrix(len(q), 1, q),
        u=sympy.Matrix(len(u), 1, u),
        mass_matrix=written(equations.mass_matrix),
        forcing=written(equations.forces - equations.bias),
        kinematics=written(equations.kinematics),
        parameters={
            names["p", k]: parameter.value
            for k, parameter in enumerate(equations.system.parameters)
        },
        inputs=tuple(column("r")),
        constraints=position_constraints,
        velocity_constraints=slipping,
    )


def _constraints(
    equations: Readable, written: Callable[[sympy.Matrix], sympy.Matrix]
) -> tuple[dict[str, sympy.Expr], dict[str, sympy.Expr]]:
    """Constraints of the system by name: at position level, and at velocity level alone."""
    rows = equations.constraint_rows
    if not rows:
        return {}, {}
    position_names = [row.name for row in rows if row.level == POSITION]
    velocity_names = [row.name for row in rows[len(position_names) :]]
    positions = dict(zip(position_names, written(equations.constraints), strict=True))
    rates = written(equations.written("constraint_rates")) if velocity_names else []
    return positions, dict(zip(velocity_names, rates[len(position_names) :], strict=True))


def _functions(equations: Readable) -> dict[tuple[str, int], sympy.Expr]:
    """Entry of q, u and r -> a function of time; its name has no dots and is taken once."""
    taken = set(equations.parameters)
    functions: dict[tuple[str, int], sympy.Expr] = {}
    for letter in ("q", "u", "r"):
        for k, entry in enumerate(equations.blocks[letter].entries):
            name = base = re.sub(r"\W", "_", entry)
            number = 1
            while name in taken:
                number += 1
                name = f"{base}_{number}"
            taken.add(name)
            functions[letter, k] = sympy.Function(name)(dynamicsymbols._t)
    return functions
