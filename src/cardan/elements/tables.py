"""Measured data as functions: interpolation tables."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import field
from functools import cache
from hashlib import sha256
from itertools import pairwise
from typing import Any

from ..errors import ModelError, brief, near
from ..ir.numbers import FLOATS
from ..ir.table import Table
from ..records import dataclass


def table(x: Sequence[float], y: Sequence[float], kind: str = "akima") -> Interpolation:
    """A function through measured points.

    Below the first and above the last point the first and the last piece of the curve continue,
    so that no corner arises at the ends; measure a little farther than the motion goes.

    Args:
        x: Abscissae, increasing, (n,) with n >= 2.
        y: Values, (n,).
        kind: ``akima`` (smooth, does not swing beside a jump), ``linear``, ``cubic`` (two
            continuous derivatives, not-a-knot ends), ``pchip`` (keeps monotonicity) or
            ``periodic`` (``cubic`` whose ends meet; take it at ``Mod(x, period)``).

    Returns:
        A callable: numbers and arrays give numbers, SymPy expressions give an expression.

    Raises:
        ModelError: an unknown kind, unequal lengths, fewer than two points, values that are not
            finite numbers, or abscissae that do not increase.

    Source: H. Akima, A New Method of Interpolation and Smooth Curve Fitting, J. ACM 17 (1970);
        F. N. Fritsch, J. Butland, A Method for Constructing Local Monotone Piecewise Cubic
        Interpolants, SIAM J. Sci. Stat. Comput. 5 (1984).
    """
    if not isinstance(kind, str) or kind not in KINDS:
        raise ModelError(f"table: kind {brief(kind)} does not exist.{near(kind, KINDS)}")
    breaks, values = _column("x", x), _column("y", y)
    if len(breaks) != len(values):
        raise ModelError(
            f"table: x has {len(breaks)} entries and y has {len(values)}; give one y for every x"
        )
    if len(breaks) < 2:
        raise ModelError(f"table: {len(breaks)} points make no curve; give at least 2")
    for i, (left, right) in enumerate(pairwise(breaks)):
        if not left < right:
            raise ModelError(
                f"table: x[{i + 1}] = {right} does not exceed x[{i}] = {left}; sort the points by "
                "x and give one y for every x"
            )
    if kind == "periodic" and values[0] != values[-1]:
        raise ModelError(
            f"table: y begins with {values[0]} and ends with {values[-1]}; a periodic "
            "table ends as it begins"
        )
    # two points determine a straight line, whatever the kind
    coefficients = KINDS["linear" if len(breaks) == 2 else kind](breaks, values)
    return Interpolation(Table(breaks, coefficients), kind, values)


@dataclass(frozen=True)
class Interpolation:
    """Result of :func:`table`.

    Attributes:
        data: The piecewise polynomial.
        kind: How it goes through the points.
        y: The values; the abscissae are ``data.breaks``.
    """

    data: Table = field(repr=False)
    kind: str
    y: tuple[float, ...] = field(repr=False)

    @property
    def name(self) -> str:
        """A name that depends on the data, not on the process; equal tables share it."""
        data = (self.data.breaks, self.data.coefficients)
        return f"table_{sha256(repr(data).encode()).hexdigest()[:8]}"

    def __call__(self, x: Any) -> Any:
        """Value at a number or at every entry of an array; expression of an expression."""
        if hasattr(x, "free_symbols"):
            return _symbolic(self, 0)(x)
        if hasattr(x, "__len__"):
            import numpy as np

            values = [FLOATS.table(self.data, 0, float(entry)) for entry in np.ravel(x)]
            return np.reshape(values, np.shape(x))
        return FLOATS.table(self.data, 0, float(x))


def _column(name: str, entries: Any) -> tuple[float, ...]:
    """Finite floats."""
    try:
        column = tuple(float(entry) for entry in entries)
    except (TypeError, ValueError) as problem:
        raise ModelError(f"table: {name} must be a sequence of numbers: {problem}") from problem
    for i, entry in enumerate(column):
        if not math.isfinite(entry):
            raise ModelError(f"table: {name}[{i}] is {entry}; give finite numbers only")
    return column


# how the curve goes through the points


def _linear(x: Sequence[float], y: Sequence[float]) -> tuple[tuple[float, ...], ...]:
    return tuple(((y[i + 1] - y[i]) / (x[i + 1] - x[i]), y[i]) for i in range(len(x) - 1))


def _curve(name: str, **options: str) -> Callable[..., tuple[tuple[float, ...], ...]]:
    """Pieces of a piecewise polynomial of ``scipy.interpolate``."""

    def coefficients_of(x: Sequence[float], y: Sequence[float]) -> tuple[tuple[float, ...], ...]:
        from scipy import interpolate

        coefficients = getattr(interpolate, name)(x, y, **options).c
        return tuple(tuple(float(c) for c in column) for column in coefficients.T)

    return coefficients_of


KINDS: dict[str, Callable[..., tuple[tuple[float, ...], ...]]] = {
    "akima": _curve("Akima1DInterpolator"),
    "linear": _linear,
    "cubic": _curve("CubicSpline"),
    "pchip": _curve("PchipInterpolator"),
    "periodic": _curve("CubicSpline", bc_type="periodic"),
}


# the SymPy side


@cache
def _symbolic(points: Interpolation, derivative: int) -> Any:
    """The SymPy function of a table or of one of its derivatives; equal tables share it."""
    import sympy

    data = points.data

    def at_number(cls: Any, x: Any) -> Any:
        if x.is_number and x.is_extended_real and x.is_finite:
            return sympy.Float(FLOATS.table(data, derivative, float(x)))
        return None

    def slope(self: Any, argindex: int = 1) -> Any:
        higher = derivative + 1
        return sympy.Integer(0) if higher >= data.order else _symbolic(points, higher)(self.args[0])

    # the name orders arguments of sums
    return type(
        points.name + (f"_d{derivative}" if derivative else ""),
        (sympy.Function,),
        {
            "nargs": 1,
            "is_extended_real": True,
            "cardan_table": data,
            "cardan_points": points,
            "cardan_derivative": derivative,
            "eval": classmethod(at_number),
            "fdiff": slope,
            # pickles name the points: there is no such class in another process
            "__reduce_ex__": lambda self, _: (_applied, (points, derivative, *self.args)),
        },
    )


def _applied(points: Interpolation, derivative: int, x: object) -> object:
    """A table or one of its derivatives of an expression."""
    applied: object = _symbolic(points, derivative)(x)
    return applied
