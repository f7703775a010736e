"""Accelerations of a chain of hinged unit rods to 40 digits, from Newton's and Euler's equations.

Shares nothing with the package. The inverse dynamics is written for any kind of number; the
forward dynamics solves it by refinement: the residual is taken in 40 digits, the correction in
doubles, until the accelerations stand still.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import mpmath
import numpy as np

Vector = list[Any]
DIGITS = 40
INERTIA = (0, 1, 1)  # of a thin rod of unit length and mass along x, in twelfths
ARM = (1, 0, 0)


def cross(a: Sequence, b: Sequence) -> Vector:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(*vectors: Sequence) -> Vector:
    return [sum(entries) for entries in zip(*vectors, strict=True)]


def axis(i: int) -> tuple[int, int, int]:
    """Hinge axes are y and z in turn."""
    return (0, 1, 0) if i % 2 == 0 else (0, 0, 1)


def turned(i: int, s: Any, c: Any, v: Sequence) -> Vector:
    """The vector v of rod i, whose hinge angle has sine s and cosine c, in axes of rod i - 1."""
    x, y, z = v
    return [c * x + s * z, y, c * z - s * x] if i % 2 == 0 else [c * x - s * y, s * x + c * y, z]


def swung(alpha: Sequence, omega: Sequence, arm: Sequence) -> Vector:
    """Acceleration of the end of an arm against its start."""
    return plus(cross(alpha, arm), cross(omega, cross(omega, arm)))


def torques(angles: Sequence, u: Sequence, udot: Sequence, gravity: Sequence) -> Vector:
    """Hinge torques (n) that make a motion, every vector in axes of its own rod.

    Args:
        angles: (sine, cosine) per hinge.
        u: Rates.
        udot: Accelerations.
        gravity: Acceleration of gravity in ground axes.
    """
    n = len(angles)
    half = [x * (u[0] * 0 + 1) / 2 for x in ARM]
    omega: Vector = [0, 0, 0]
    alpha: Vector = [0, 0, 0]
    acceleration: Vector = [-x for x in gravity]
    forces, moments = [], []
    # outwards: the motion of every rod, and what its center of mass needs
    for i, (s, c) in enumerate(angles):
        if i:
            acceleration = plus(acceleration, swung(alpha, omega, ARM))
        omega, alpha, acceleration = (turned(i, -s, c, v) for v in (omega, alpha, acceleration))
        rate = [u[i] * x for x in axis(i)]
        alpha = plus(alpha, [udot[i] * x for x in axis(i)], cross(omega, rate))
        omega = plus(omega, rate)
        spin = [k * w / 12 for k, w in zip(INERTIA, omega, strict=True)]
        change = [k * a / 12 for k, a in zip(INERTIA, alpha, strict=True)]
        forces.append(plus(acceleration, swung(alpha, omega, half)))
        moments.append(plus(change, cross(omega, spin)))
    # inwards: what hinge i has to carry
    result: Vector = [0] * n
    force: Vector = [0, 0, 0]
    moment: Vector = [0, 0, 0]
    for i in range(n - 1, -1, -1):
        moment = plus(moment, cross(ARM, force), moments[i], cross(half, forces[i]))
        force = plus(force, forces[i])
        result[i] = sum(a * m for a, m in zip(axis(i), moment, strict=True))
        force, moment = (turned(i, *angles[i], v) for v in (force, moment))
    return result


def accelerations(q: np.ndarray, u: np.ndarray, gravity: Sequence[float]) -> np.ndarray:
    """udot (n) of the chain without torques, rounded from 40 digits.

    Raises:
        ArithmeticError: the refinement did not converge.
    """
    n = len(q)
    # mass matrix in doubles, all columns at once: torques of unit accelerations at rest
    rough = [(np.sin(x), np.cos(x)) for x in q]
    matrix = np.array(torques(rough, [0.0] * n, list(np.eye(n)), [0.0] * 3), dtype=float)
    with mpmath.workdps(DIGITS + 10):
        angles = [(mpmath.sin(mpmath.mpf(x)), mpmath.cos(mpmath.mpf(x))) for x in q]
        rates = [mpmath.mpf(x) for x in u]
        pull = [mpmath.mpf(x) for x in gravity]
        udot = [mpmath.mpf(0)] * n
        for _ in range(12):
            residual = torques(angles, rates, udot, pull)
            size = max(abs(x) for x in residual)
            scale = float(size) or 1.0
            correction = np.linalg.solve(matrix, [float(x / scale) for x in residual])
            step = [mpmath.mpf(x) * scale for x in correction]
            udot = [a - b for a, b in zip(udot, step, strict=True)]
            largest = max(abs(x) for x in udot)
            if max(abs(x) for x in step) <= largest * mpmath.mpf(10) ** -DIGITS:
                return np.array([float(x) for x in udot])
    raise ArithmeticError("the refinement did not converge to 40 digits")
