"""Polynomials of rotations of less than half a turn, against their functions in many digits."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from cardan.ir.graph import Graph
from cardan.spatial import short_rotations
from cardan.spatial.short_rotations import (
    HALF_COSINE,
    HALF_SINE,
    INVERSE_TANGENT,
    polynomial,
    rotation_vector,
    slopes,
)
from spatial.numbers_of import block, numbers
from table import each

ROUNDING = 4 * 2.0**-53
ANGLES = (1e-9, 1e-3, 0.1, 1.0, 2.0, 3.0, 3.14159)
FUNCTIONS: dict[str, tuple[tuple[float, ...], Any]] = {
    "inverse tangent": (INVERSE_TANGENT, lambda a: (1 - a / 2 * mpmath.cot(a / 2)) / a**2),
    "half sine": (HALF_SINE, lambda a: mpmath.sin(a / 2) / a),
    "half cosine": (HALF_COSINE, lambda a: (1 - mpmath.cos(a / 2)) / a**2),
}


@each("name", FUNCTIONS)
@each("angle", ANGLES)
def test_values_and_slopes(name: str, angle: float) -> None:
    coefficients, function = FUNCTIONS[name]
    x = block(Graph(), "q", 1)[0]
    found = slopes(coefficients, x, "f")
    with mpmath.workdps(60):
        square = mpmath.mpf(angle) ** 2

        def at(y: Any) -> Any:
            return function(mpmath.sqrt(y))

        wanted = [mpmath.diff(at, square, n, h=mpmath.mpf(10) ** -25 * square) for n in range(3)]
        known = [numbers(part, q=[float(square)]) for part in (found.value, found.first)]
        errors = [abs(a / b - 1) for a, b in zip(known, wanted, strict=False)]
    # the end of the series is as far from its neighbors as a digit: slopes lose a few
    assert errors[0] < ROUNDING
    assert errors[1] < 100 * ROUNDING
    assert numbers(found.second, q=[float(square)]) == pytest.approx(float(wanted[2]), rel=1e-10)


@each("angle", [0.0, *ANGLES])
def test_rotation_vector(angle: float) -> None:
    wanted = angle * np.array([2.0, -1.0, 2.0]) / 3
    x, y, z, w = Rotation.from_rotvec(wanted).as_quat()
    q = block(Graph(), "q", 4)
    found = rotation_vector(q[0], q.block(slice(1, 4)))
    assert numbers(found, q=[w, x, y, z]) == pytest.approx(wanted, rel=8 * ROUNDING, abs=1e-300)


def test_no_choices_and_no_library() -> None:
    g = Graph()
    q = block(g, "q", 4)
    rotation_vector(q[0], q.block(slice(1, 4)))
    slopes(INVERSE_TANGENT, q[0], "a")
    assert {node[0] for node in g.nodes} <= {"const", "var", "add", "sub", "mul", "div", "neg"}


def test_polynomial() -> None:
    x = block(Graph(), "q", 1)[0]
    for n in (2, 3, 6):
        coefficients = tuple(range(1, n + 1))
        wanted = np.polyval(coefficients[::-1], 1.7)
        assert numbers(polynomial(coefficients, x), q=[1.7]) == pytest.approx(wanted)
    assert len(HALF_SINE) == short_rotations.TERMS
