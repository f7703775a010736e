"""Equations of motion of SymPy's mechanics package in one form. Loads SymPy."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from typing import Any

import numpy as np
import sympy
from sympy.physics.mechanics import KanesMethod, LagrangesMethod, dynamicsymbols

from ...errors import ModelError
from ...records import dataclass
from .leaves import leaves
from .numbers import numbers

# beyond this condition a matrix is singular
REGULAR = 1e8
FORMS = (
    "a KanesMethod, a LagrangesMethod, a System of sympy.physics.mechanics whose equations are "
    "formed, (q, u, M, f), (q, u, kinematics, M, f), (q, u, kinematics, M, f, constraints), or "
    "what equations.to_sympy() returns"
)


@dataclass(frozen=True)
class Source:
    """Equations M u' = f, q' = rates, and what binds them.

    Attributes:
        q, u: Functions of time; a speed may be the derivative of a coordinate.
        rates: q' in q, u and t.
        M: (nu, nu). f: (nu,).
        positions: Name -> expression of q and t that is kept at 0.
        speeds: Name -> expression linear in u that is kept at 0.
        implied: Whether ``speeds`` has the derivatives of ``positions`` too.
        lagrangian: L where it is known.
        applied: The part of f (nu,) that is not in L.
        balance: SymPy's own rows (A, b) of A u' = b with constraints, where it has some.
        zero: Functions of time that are 0.
        values: Symbol -> default value that the source knows.
        inputs: Functions of time that move the system, as far as the source says.
    """

    q: tuple[sympy.Expr, ...]
    u: tuple[sympy.Expr, ...]
    rates: tuple[sympy.Expr, ...]
    M: tuple[sympy.Expr, ...]
    f: tuple[sympy.Expr, ...]
    positions: Mapping[str, sympy.Expr] = field(default_factory=dict)
    speeds: Mapping[str, sympy.Expr] = field(default_factory=dict)
    implied: bool = False
    lagrangian: sympy.Expr | None = None
    applied: tuple[sympy.Expr, ...] = ()
    balance: tuple[sympy.Expr, sympy.Expr] | None = None
    zero: tuple[sympy.Expr, ...] = ()
    values: Mapping[sympy.Expr, float] = field(default_factory=dict)
    inputs: tuple[sympy.Expr, ...] = ()


def source_of(equations: object) -> Source:
    """Equations in any of the forms that are taken.

    Raises:
        ModelError: another object, or one whose equations are not formed yet.
    """
    if isinstance(equations, KanesMethod):
        return _kane(equations)
    if isinstance(equations, LagrangesMethod):
        return _lagrange(equations)
    if hasattr(equations, "eom_method"):
        if equations.eom_method is None:
            raise ModelError("from_sympy: call system.form_eoms() first")
        return source_of(equations.eom_method)
    if hasattr(equations, "kindiffdict") and hasattr(equations, "parameters"):
        return _of_mechanics(equations)
    if isinstance(equations, Sequence) and 4 <= len(equations) <= 6:
        return _written(*equations)
    raise ModelError(f"from_sympy takes {FORMS}; not {type(equations).__name__}")


def _kane(kane: Any) -> Source:
    """Kane's equations before dependent speeds are eliminated.

    SymPy solves for q' and eliminates dependent speeds by symbolic factorizations, whose pivots may
    vanish where the system is at home, such as an upright bicycle. The rows of all speeds are
    formed anew from the bodies and loads that the object holds, and q' by Cramer's rule where its
    own solution divides by zero; constraints stay constraints.
    """
    if kane._fr is None or kane._frstar is None:
        raise ModelError("from_sympy: call kane.kanes_equations(bodies, loads) first")
    q, u, rates, reduced = tuple(kane.q), tuple(kane.u), kane.kindiffdict(), kane
    derivatives = [x.diff(dynamicsymbols._t) for x in q]
    bound, divides = len(kane._f_nh), _divides(kane, [rates[x] for x in derivatives])
    if bound or divides:
        kinematics = [x - rates[x] for x in derivatives]
        if divides:
            kinematics = list(
                kane._k_kqdot_implicit * sympy.Matrix(derivatives)
                + kane._k_ku_implicit * sympy.Matrix(u)
                + kane._f_k_implicit
            )
        reduced = KanesMethod(
            kane._inertial,
            list(q),
            list(u),
            kinematics,
            u_auxiliary=list(kane._uaux) or None,
            kd_eqs_solver="CRAMER" if divides else "LU",
        )
        reduced.kanes_equations(kane.bodylist, kane.forcelist)
        rates = reduced.kindiffdict()
    velocity_constraints = kane._k_nh * sympy.Matrix(u) + kane._f_nh if bound else ()
    return Source(
        q,
        u,
        tuple(rates[x] for x in derivatives),
        tuple(reduced.mass_matrix),
        tuple(reduced.forcing),
        positions={f"configuration{i + 1}": x for i, x in enumerate(kane._f_h)},
        speeds={f"velocity{i + 1}": x for i, x in enumerate(velocity_constraints)},
        implied=True,
        balance=(kane.mass_matrix, kane.forcing),
        zero=tuple(kane._uaux),
    )


def _divides(kane: Any, rates: Sequence[sympy.Expr]) -> bool:
    """True when q' as SymPy solved for it divides by zero where the kinematics are regular.

    That is looked for where all coordinates vanish, and each of them alone.
    """
    K = kane._k_kqdot_implicit
    q, parameter_leaves = list(kane.q), set(leaves([*rates, *K])) - set(kane.q)
    parameters = {x: 0.7 + 0.1 * k for k, x in enumerate(sorted(parameter_leaves, key=str))}
    samples = [0.3 + 0.2 * k for k in range(len(q))]
    for zero in [range(len(q)), *([k] for k in range(len(q)))]:
        at = {x: 0.0 if k in zero else samples[k] for k, x in enumerate(q)}
        matrix = np.array(numbers([*K], parameters | at)).reshape(len(q), len(q))
        if np.isfinite(matrix).all() and np.linalg.cond(matrix) < REGULAR:
            rates_there = numbers(rates, parameters | at)
            if not (
                np.isfinite(rates_there).all() and np.abs(rates_there).max(initial=0.0) < REGULAR
            ):
                return True
    return False


def _lagrange(lagrange: Any) -> Source:
    """Lagrange's equations of the first or second kind."""
    if lagrange.eom is None:
        raise ModelError("from_sympy: call lagrange.form_lagranges_equations() first")
    q = tuple(lagrange.q)
    u = tuple(x.diff(dynamicsymbols._t) for x in q)
    positions = tuple(lagrange._hol_coneqs)
    return Source(
        q,
        u,
        u,
        tuple(lagrange._m_d),
        tuple(lagrange.forcing),
        positions={f"holonomic{i + 1}": x for i, x in enumerate(positions)},
        speeds={f"nonholonomic{i + 1}": x for i, x in enumerate(lagrange.coneqs[len(positions) :])},
        lagrangian=lagrange._L[0],
        applied=tuple(lagrange._term4),
    )


def _of_mechanics(mechanics: Any) -> Source:
    """Equations from the result of ``equations.to_sympy()``."""
    return Source(
        tuple(mechanics.q),
        tuple(mechanics.u),
        tuple(mechanics.kinematics),
        tuple(mechanics.mass_matrix),
        tuple(mechanics.forcing),
        positions=mechanics.constraints,
        speeds=mechanics.velocity_constraints,
        values=mechanics.parameters,
        inputs=tuple(mechanics.inputs),
    )


def _written(q: Iterable[sympy.Expr], u: Iterable[sympy.Expr], *rest: Any) -> Source:
    """(M, f), (kinematics, M, f) or (kinematics, M, f, constraints) behind q and u."""
    q, u = tuple(q), tuple(u)
    kinematics, M, f = (u, *rest) if len(rest) == 2 else rest[:3]
    if len(kinematics) != len(q):
        raise ModelError(
            f"from_sympy: {len(q)} coordinates and {len(kinematics)} "
            f"{'speeds; give' if len(rest) == 2 else 'of'} the kinematics q', one expression for "
            "every coordinate"
        )
    M, f = sympy.Matrix(M), sympy.Matrix(f)
    if M.shape != (len(u), len(u)) or len(f) != len(u):
        raise ModelError(
            f"from_sympy: with {len(u)} speeds M is {len(u)}x{len(u)} and f has {len(u)} entries; "
            f"here M is {M.rows}x{M.cols} and f has {len(f)}"
        )
    bound = rest[3] if len(rest) == 4 else {}
    if not isinstance(bound, Mapping):
        bound = {f"constraint{i + 1}": x for i, x in enumerate(bound)}
    moving = {*u, *(x.diff(dynamicsymbols._t) for x in q)}
    constraints = {name: sympy.sympify(x, strict=True) for name, x in bound.items()}
    speeds = {name: x for name, x in constraints.items() if any(x.has(v) for v in moving)}
    return Source(
        q,
        u,
        tuple(sympy.sympify(x, strict=True) for x in kinematics),
        tuple(M),
        tuple(f),
        positions={name: x for name, x in constraints.items() if name not in speeds},
        speeds=speeds,
    )
