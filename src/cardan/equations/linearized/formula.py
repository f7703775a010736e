"""Linear models in text and LaTeX."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import DerivationError
from ...ir.matrix import Matrix
from ..reading.formula import of_matrix

if TYPE_CHECKING:
    import sympy

    from .record import Linearized, SecondOrder

RESTS = 1e-9  # accelerations below this are none
GENERAL = r"\dot x = A x + B r, \quad y = C x + D r"


def latex(linear: Linearized) -> str:
    """The equations of second order if there are some, else those of first order."""
    try:
        return second_order_latex(linear.second_order())
    except DerivationError:
        pass
    try:
        equations = linear._reference.equations
        A, B, C, D = (of_matrix(equations, getattr(linear, name)) for name in "ABCD")
    except DerivationError:
        return GENERAL
    return rf"\dot x = {A} x + {B} r, \quad y = {C} x + {D} r"


def second_order_latex(system: SecondOrder) -> str:
    """M y'' + (D + G) y' + (K + N) y = B r; letters for what is too long."""
    equations = system.matrices.reference.equations
    signs = (("M", r"\ddot y"), ("damping", r"\dot y"), ("K", "y"))
    left = [
        f"{_matrix(equations, system, name)} {sign}"
        for name, sign in signs
        if not system.matrices.matrices[name].is_zero
    ]
    external = (("forces", "r"), ("inner", "z"))
    right = [
        f"{_matrix(equations, system, name)} {sign}"
        for name, sign in external
        if not system.matrices.matrices[name].is_zero
    ]
    return f"{' + '.join(left)} = {' + '.join(right) or '0'}"


def _matrix(equations: Any, system: SecondOrder, name: str) -> str:
    try:
        return of_matrix(equations, getattr(system, name))
    except DerivationError:
        return {"damping": "(D + G)", "K": "(K + N)", "forces": "B", "inner": "Z"}.get(name, name)


def overview(linear: Linearized) -> str:
    """The model for people: what it is about, its states, its matrices as far as they are short."""
    lines = [f"'{linear.name}' linearized about {_about(linear)}"]
    if linear.needed:
        lines.append("  (udot='free': about the motion that starts there by itself)")
    for word in ("states", "inputs", "outputs"):
        lines.append(f"  {word:8}{', '.join(getattr(linear, word)) or 'none'}")
    try:
        second = linear.second_order()
    except DerivationError as problem:
        lines.append(f"  {str(problem).removeprefix('linearize: ')}")
        lines += [line for name in "ABCD" for line in _rows(linear, name)]
        return "\n".join(lines)
    return "\n".join([*lines, *rows_of(second)])


def rows_of(system: SecondOrder) -> list[str]:
    """The equations of second order, and every matrix that is not zero."""
    inner = "" if system.matrices.matrices["inner"].is_zero else " + Z z"
    about = f",  y = {', '.join(system.coordinates)}"
    lines = [f"  M y'' + (D + G) y' + (K + N) y = B r{inner}{about}"]
    listed_rows = (
        ("M", "M"),
        ("D", "dissipative"),
        ("G", "gyroscopic"),
        ("K", "conservative"),
        ("N", "circulatory"),
        ("B", "forces"),
        ("Z", "inner"),
    )
    return lines + [line for letter, name in listed_rows for line in _rows(system, name, letter)]


def _about(linear: Linearized) -> str:
    at = linear._reference
    moving = any(at.values[leaf] for leaf in at.block("u"))
    kind = "a motion" if moving or at.timed else "rest"
    if not linear.needed and not at.timed:
        leaves = at.block("udot")
        accelerations = Matrix(at.graph, len(at.w), 1, [at.values[leaves[k]] for k in at.w])
        if np.abs(at.number(accelerations)).max(initial=0.0) > RESTS:
            kind = "a motion that accelerates, at this instant"
    if not linear.needed:
        return kind
    forces = ", ".join(f"{_text(value)} along {name}" for name, value in linear.needed.items())
    return f"{kind} that is none by itself; it takes {forces}"


def _rows(linear: object, name: str, letter: str = "") -> list[str]:
    """A matrix row by row; nothing for one of zeros."""
    try:
        matrix = getattr(linear, name)
    except DerivationError:
        return [f"  {letter or name}: too long to write out; symbolic('{name}') or at()"]
    if not any(matrix):
        return []
    head = f"  {letter or name} = "
    rows = [f"[{', '.join(_text(x) for x in matrix.row(i))}]" for i in range(matrix.rows)]
    return [(head if n == 0 else " " * len(head)) + row for n, row in enumerate(rows)]


def _text(expression: sympy.Expr) -> str:
    """An expression with numbers as short as they are."""
    from sympy import sstr

    return str(sstr(expression, full_prec=False))
