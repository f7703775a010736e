"""Functions of equations as expressions of CasADi, which its own machine evaluates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca

from cardan.ir.interpreter import nodes_of
from cardan.ir.numbers import Numbers

NAMES = ("sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh")


@dataclass(frozen=True)
class Symbols(Numbers):
    """Expressions of CasADi as numbers."""

    def solve(self, kind: str, n: int, m: int, entries: list[Any]) -> list[Any]:
        """X (n m, row by row) of A X = B, A symmetric and positive definite: A = L D L^T."""
        if kind != "spd":
            raise ValueError(f"a system of kind '{kind}' needs pivots")
        a = [entries[i * n : (i + 1) * n] for i in range(n)]
        b = [entries[n * n + i * m : n * n + (i + 1) * m] for i in range(n)]
        for k in range(n):
            for i in range(k + 1, n):
                factor = a[i][k] / a[k][k]
                a[i] = [x - factor * y for x, y in zip(a[i], a[k], strict=True)]
                b[i] = [x - factor * y for x, y in zip(b[i], b[k], strict=True)]
        for i in reversed(range(n)):
            for j in range(i + 1, n):
                b[i] = [x - a[i][j] * y for x, y in zip(b[i], b[j], strict=True)]
            b[i] = [x / a[i][i] for x in b[i]]
        return [x for row in b for x in row]


def symbols() -> Symbols:
    """What operators of expressions are in CasADi."""
    operators = {name: getattr(ca, name) for name in NAMES}
    operators |= {
        "add": lambda a, b: a + b, "sub": lambda a, b: a - b, "mul": lambda a, b: a * b,
        "div": lambda a, b: a / b, "neg": lambda a: -a, "pow": lambda a, b: a**b,
        "max": ca.fmax, "min": ca.fmin, "abs": ca.fabs, "sign": ca.sign,
        "lt": lambda a, b: a < b, "le": lambda a, b: a <= b, "select": ca.if_else,
    }  # fmt: skip
    return Symbols("casadi", ca.SX, operators, lambda x: x, 0.0)


def rates(equations: Any, nq: int, nu: int, parameters: Sequence[str]) -> Any:
    """Rates of a tree without inputs as a function of CasADi, of x and p."""
    function = equations.function("rhs")
    x, p = ca.SX.sym("x", nq + nu), ca.SX.sym("p", len(parameters))
    places = ca.vertsplit(x)
    inputs = {"q": places[:nq], "u": places[nq:], "p": ca.vertsplit(p), "t": [ca.SX(0)]}
    values = nodes_of(function.graph, function.live(), inputs, symbols())
    results = ca.vertcat(*(values[i] for output in function.outputs for i in output.nodes))
    return ca.Function("rhs", [x, p], [results], ["x", "p"], ["xdot"])
