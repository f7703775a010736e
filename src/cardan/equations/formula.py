"""The equations of motion as LaTeX and as MathML."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..errors import DerivationError
from .notation import Notation, symbols

if TYPE_CHECKING:
    import sympy

    from .record import Equations

GENERAL = r"M(q)\,\dot u + h(q, u) = f + \tau"
BOUND = GENERAL + r" + G(q)^T \lambda, \quad G(q)\,\dot u = \gamma(q, u)"


def latex(equations: Equations) -> str:
    """M udot + h = f + tau and, where u is not the rate of q, qdot = N u, without dollar signs.

    Systems with constraints show the general form.
    """
    if equations.system.closed:
        return BOUND
    try:
        lines = _lines(equations)
    except DerivationError:
        # too long to be read: symbolic() and the counts say more
        return GENERAL
    if len(lines) == 1:
        return " = ".join(lines[0])
    rows = r"\\".join(" &= ".join(line) for line in lines)
    return rf"\begin{{aligned}}{rows}\end{{aligned}}"


def _lines(equations: Equations) -> list[tuple[str, str]]:
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


def rates_are_speeds(equations: Equations, kinematics: sympy.Matrix) -> bool:
    """Whether qdot = u says nothing that needs to be written."""
    return [str(entry) for entry in kinematics] == list(equations.speeds)


def of_matrix(equations: Equations, matrix: sympy.Matrix) -> str:
    """A matrix of these equations in LaTeX."""
    import sympy

    names = {sympy.Symbol(key): value.latex() for key, value in symbols(equations).items()}
    others = matrix.free_symbols - set(names)
    names |= {s: Notation(s.name).latex() for s in others}
    return str(sympy.latex(matrix, symbol_names=names, mat_str="matrix", mul_symbol=r" \, "))


def mathml(equations: Equations, expression: Any, lines: bool = False) -> str:
    """An expression or matrix of these equations as MathML, which browsers set by themselves.

    Args:
        lines: Break a long sum into several lines.
    """
    from .mathml import Printer

    printer = Printer(symbols(equations))
    return printer.lines(expression) if lines else printer.written(expression)
