"""Rotations of less than half a turn, without choices and without functions of a library.

What elements compute at every point of a mesh runs in lanes, where choices cost both sides and
library functions are called lane by lane. Polynomials of the squared angle, fitted by Chebyshev
series to rounding, hold for every angle up to pi.

Source: Hairer, Lubich and Wanner, Geometric Numerical Integration (2006), section IV.7 (dexp and
its inverse).
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ..ir.arithmetic import Scalar
from ..ir.matrix import Matrix
from ..records import dataclass

# atan(s)/s in powers of s², for s up to 1
ARCTANGENT = (
    *(1.0, -0.3333333333333286, 0.19999999999929946, -0.14285714281592693, 0.11111110982087126),
    *(-0.09090906605656898, 0.0769227555520563, -0.06666371187721096, 0.058803420024015285),
    *(-0.052527255573225094, 0.047197239923208865, -0.0421257239638493, 0.03651081352719787),
    *(-0.029700717736214088, 0.021740213830732918, -0.013674139288375268, 0.007038646202972334),
    *(-0.002804765553160955, 0.0008033604181592972, -0.00014617088163551987),
    1.263117843040284e-05,
)
# (1 - (φ/2) cot(φ/2)) / φ² in powers of φ², for φ up to pi
INVERSE_TANGENT = (
    *(0.08333333333333333, 0.0013888888888888915, 3.306878306876057e-05, 8.267195767958328e-07),
    *(2.087675685246588e-08, 5.284191588637453e-10, 1.3382434933444688e-11, 3.390170284017489e-13),
    *(8.569275711864078e-15, 2.2164599237362465e-16, 4.758716543236575e-18, 2.3763321286520025e-19),
    *(
        -5.5868211676655105e-21,
        6.689835630876281e-22,
        -2.085606351045793e-23,
        5.282901546587776e-25,
    ),
)
# sin(φ/2) / φ and (1 - cos(φ/2)) / φ², by their own series
TERMS = 12
HALF_SINE = tuple((-1) ** k / 2 / 4**k / math.factorial(2 * k + 1) for k in range(TERMS))
HALF_COSINE = tuple((-1) ** k / 4 / 4**k / math.factorial(2 * k + 2) for k in range(TERMS))


@dataclass(frozen=True)
class Slopes:
    """A function of one variable with its first two derivatives."""

    value: Scalar | float
    first: Scalar | float = 0.0
    second: Scalar | float = 0.0

    def __neg__(self) -> Slopes:
        return Slopes(-self.value, -self.first, -self.second)


def polynomial(coefficients: Sequence[float], x: Scalar) -> Scalar:
    """Value by Horner's rule on even and odd powers side by side."""
    square = x * x
    even, odd = _horner(coefficients[::2], square), _horner(coefficients[1::2], square)
    return x * odd + even


def _horner(coefficients: Sequence[float], x: Scalar) -> Scalar | float:
    total: Scalar | float = coefficients[-1]
    for coefficient in coefficients[-2::-1]:
        total = x * total + coefficient
    return total


def slopes(coefficients: Sequence[float], x: Scalar, word: str) -> Slopes:
    """A polynomial and its derivatives, called ``word``, ``word_slope`` and ``word_bend``."""
    first = [k * c for k, c in enumerate(coefficients)][1:]
    second = [k * c for k, c in enumerate(first)][1:]
    labels = (word, f"{word}_slope", f"{word}_bend")
    rows = zip((coefficients, first, second), labels, strict=True)
    return Slopes(*(polynomial(c, x).note(name) for c, name in rows))


def rotation_vector(w: Scalar, v: Matrix) -> Matrix:
    """Rotation vector (3, 1) [rad] of a unit quaternion (w, v) with w >= 0."""
    # tangent of a quarter of the angle, at most 1
    quarter = (v * (1.0 / (1.0 + w))).note("tan_quarter")
    square = quarter.dot(quarter).note("tan_quarter_squared")
    return (v * (2.0 * (1.0 + square) * polynomial(ARCTANGENT, square))).note("theta")
