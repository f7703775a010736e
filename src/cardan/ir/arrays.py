"""NumPy arrays as numbers of the interpreter: every node is evaluated for a whole batch."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from ..errors import SolveError
from ..records import dataclass
from . import numbers
from .numbers import Numbers, Operators
from .table import Table


@dataclass(frozen=True)
class Arrays(Numbers):
    """Arrays of one kind of number; tables and solutions entry by entry of the batch.

    Attributes:
        entry: The arithmetic of one entry.
    """

    entry: Numbers

    def table(self, table: Table, derivative: int, x: Any) -> Any:
        """Derivative of a table at x."""
        breaks, coefficients = np.array(table.breaks), np.array(table.coefficients)
        interval = np.searchsorted(breaks, np.real(x), side="right") - 1
        interval = np.clip(interval, 0, len(coefficients) - 1)
        h, total = x - breaks[interval], np.zeros_like(x)
        for j, factor in enumerate(table.factors(derivative)):
            total = total * h + coefficients[interval, j] * factor
        return total

    def solve(self, kind: str, n: int, m: int, entries: list[Any]) -> list[Any]:
        """X (n m, row by row) of A X = B, from the entries of A and B row by row."""
        both = np.stack(np.broadcast_arrays(*entries), axis=-1)
        batch = both.shape[:-1]
        if kind in ("rank_revealing", "semidefinite", "basic"):
            # the choice of pivots differs within the batch
            flat = both.reshape(-1, n * (n + m))
            solved = [self.entry.solve(kind, n, m, row.tolist()) for row in flat]
            x = np.array(solved).reshape((*batch, n * m))
        else:
            a = both[..., : n * n].reshape((*batch, n, n))
            b = both[..., n * n :].reshape((*batch, n, m))
            x = _regular(a, b).reshape((*batch, n * m))
        return [x[..., k] for k in range(n * m)]


def _regular(a: Any, b: Any) -> Any:
    try:
        return np.linalg.solve(a, b)
    except np.linalg.LinAlgError as problem:
        raise SolveError(
            f"a system of {a.shape[-1]} equations is singular for a state of the batch"
        ) from problem


def _as_float(condition: object) -> Any:
    return np.asarray(condition, dtype=float)


def stumpff(k: int, x: object) -> Any:
    """c_k(x) of an array, as :func:`cardan.ir.ops.stumpff`."""
    x = np.asarray(x, dtype=float)
    near = 2.0 * np.abs(x) < (k + 1) * (k + 2)
    # the series where nothing cancels; 24 terms are enough for every k
    small = np.where(near, x, 0.0)
    term = np.full_like(x, 1.0 / math.factorial(k))
    series = term.copy()
    for i in range(k, k + 48, 2):
        term = term * (-small / ((i + 1) * (i + 2)))
        series = series + term
    if near.all():
        return series
    far = np.where(near, 1.0, x)
    return np.where(near, series, _closed(k, far))


def _closed(k: int, x: Any) -> Any:
    if k < 2:
        root = np.sqrt(np.abs(x))
        if k == 0:
            return np.where(x > 0, np.cos(root), np.cosh(root))
        return np.where(x > 0, np.sin(root), np.sinh(root)) / root
    if k == 2:
        return 0.5 * stumpff(1, 0.25 * x) ** 2
    return (1.0 / math.factorial(k - 2) - stumpff(k - 2, x)) / x


# spelled the same in NumPy
_SAME_NAME = (
    *("sqrt", "sin", "cos", "tan", "exp", "log", "sinh", "cosh", "tanh"),
    *("abs", "sign", "floor"),
)


@cache
def arrays() -> Arrays:
    """The arithmetic of arrays."""
    operators: Operators = {
        "add": np.add,
        "sub": np.subtract,
        "mul": np.multiply,
        "div": np.divide,
        "neg": np.negative,
        "asin": np.arcsin,
        "acos": np.arccos,
        "atan": np.arctan,
        "asinh": np.arcsinh,
        "acosh": np.arccosh,
        "atanh": np.arctanh,
        "atan2": np.arctan2,
        "pow": np.power,
        "min": np.minimum,
        "max": np.maximum,
        "lt": lambda a, b: _as_float(a < b),
        "le": lambda a, b: _as_float(a <= b),
        "eq": lambda a, b: _as_float(a == b),
        "and": lambda a, b: _as_float((a != 0) & (b != 0)),
        "or": lambda a, b: _as_float((a != 0) | (b != 0)),
        "not": lambda a: _as_float(a == 0),
        "select": lambda c, a, b: np.where(c != 0, a, b),
        "stumpff": stumpff,
    }
    for name in _SAME_NAME:
        operators[name] = getattr(np, name)
    eps = np.finfo(float).eps
    return Arrays("numpy", np.float64, operators, lambda x: x, eps, numbers.FLOATS)


@cache
def complex_arrays() -> Arrays:
    """The arithmetic of arrays of complex numbers; comparisons and choices by the real part."""
    real = np.real
    single = numbers.COMPLEXES
    operators = dict(arrays().operators)
    for name in ("atan2", "stumpff"):
        operators[name] = _entry_by_entry(single.operators[name])
    operators |= {
        "floor": lambda a: np.floor(real(a)) + 0j,
        "lt": lambda a, b: _as_float(real(a) < real(b)),
        "le": lambda a, b: _as_float(real(a) <= real(b)),
        "eq": lambda a, b: _as_float(real(a) == real(b)),
        "min": lambda a, b: np.where(real(b) < real(a), b, a),
        "max": lambda a, b: np.where(real(b) > real(a), b, a),
        "abs": lambda a: np.where(real(a) < 0, -a, a),
        "sign": lambda a: np.sign(real(a)),
    }
    return Arrays("numpy", np.complex128, operators, real, single.eps, single)


def _entry_by_entry(f: Callable[..., complex]) -> Callable[..., Any]:
    """f of one entry after the other, for operators that NumPy does not have."""
    alone = np.frompyfunc(f, 2, 1)
    return lambda a, b: np.asarray(alone(a, b), dtype=complex)
