"""The equations of motion as LaTeX."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...errors import DerivationError
from ...ir.function import length
from .notation import Notation, symbols

if TYPE_CHECKING:
    import sympy

    from ..record import EquationRecord
    from .readable import Readable

GENERAL = r"M(q)\,\dot u + h(q, u) = f + \tau"
BOUND = GENERAL + r" + G(q)^T \lambda, \quad G(q)\,\dot u = \gamma(q, u)"

PARTS = (
    ("M", "mass_matrix"),
    ("h", "bias"),
    ("g", "constraints"),
    ("G", "constraint_jacobian"),
    (r"\gamma", "constraint_bias"),
)
# what notebooks show at once: operations of a matrix that is written, and operations, written out
# in full, of one that is simplified, which takes seconds where there are more
LONGEST, SIMPLIFIED = 600, 2_200


def latex(equations: Readable) -> str:
    """M udot + h = f + tau and, where u is not the rate of q, qdot = N u, without dollar signs.

    Systems with constraints show the general form, then what is short of it.
    """
    if equations.system.closed:
        return _aligned([("", BOUND), *_parts(equations)])
    try:
        lines = _lines(equations)
    except DerivationError:
        # too long to be read: symbolic() and the counts say more
        return GENERAL
    return _aligned(lines)


def _aligned(lines: list[tuple[str, str]]) -> str:
    if len(lines) == 1:
        return " = ".join(filter(None, lines[0]))
    rows = r"\\".join(" &= ".join(line) if line[0] else f"&{line[1]}" for line in lines)
    return rf"\begin{{aligned}}{rows}\end{{aligned}}"


def _parts(equations: Readable) -> list[tuple[str, str]]:
    """M, h, g, G and gamma, one line each; what is long or zero is left out."""
    parts = []
    for sign, name in PARTS:
        if length(equations.without_rewrites.function(name)) > SIMPLIFIED:
            continue
        try:
            matrix = equations.written(name)
        except DerivationError:
            continue
        if sum(entry.count_ops() for entry in matrix) <= LONGEST and not matrix.is_zero_matrix:
            parts.append((sign, of_matrix(equations, matrix)))
    return parts


def _lines(equations: Readable) -> list[tuple[str, str]]:
    import sympy

    rate = equations.blocks["udot"].entries
    udot = sympy.Matrix([sympy.Symbol(name) for name in rate])
    f = equations.forces
    right = (of_matrix(equations, f) + " + " if any(f) else "") + r"\tau"
    parts = [of_matrix(equations, x) for x in (equations.mass_matrix, udot, equations.bias)]
    lines = [(f"{parts[0]}{parts[1]} + {parts[2]}", right)]
    kinematics = equations.kinematics
    if not rates_are_speeds(equations, kinematics):
        lines.append((r"\dot q", of_matrix(equations, kinematics)))
    return lines


def rates_are_speeds(equations: Readable, kinematics: sympy.Matrix) -> bool:
    """True when qdot = u says nothing that needs to be written."""
    return [str(entry) for entry in kinematics] == list(equations.speeds)


def of_matrix(equations: EquationRecord, matrix: sympy.Matrix) -> str:
    """A matrix of these equations in LaTeX."""
    import sympy

    names = {sympy.Symbol(key): value.latex() for key, value in symbols(equations).items()}
    foreign = matrix.free_symbols - set(names)
    names |= {s: Notation(s.name).latex() for s in foreign}
    return str(sympy.latex(matrix, symbol_names=names, mat_str="matrix", mul_symbol=r" \, "))
