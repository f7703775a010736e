"""Energies of the classical systems and the motion of a rigid body as books have them.

Written down by hand before any of it was compared with what is derived. The ``terms`` are the
summands with brackets multiplied out.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

import cardan as cd

from .classical import S, cos, model, parameters, sin

HALF = sp.Rational(1, 2)


@dataclass(frozen=True)
class Energy:
    """Kinetic and potential energy in the symbols of the model, and their terms."""

    kinetic: Any
    potential: Any
    terms: tuple[int, int]


def _cart() -> Energy:
    g, M, m, l, th, v, w = S("g M m l theta x.u theta.u")
    kinetic = HALF * (M + m) * v**2 + m * l * v * w * cos(th) + HALF * m * l**2 * w**2
    return Energy(kinetic, -m * g * l * cos(th), (4, 1))


def _double() -> Energy:
    g, m1, m2, l1, l2 = S("g m1 m2 l1 l2")
    a, b, u, v = S("theta1 theta2 theta1.u theta2.u")
    kinetic = (
        HALF * (m1 + m2) * l1**2 * u**2
        + HALF * m2 * l2**2 * (u + v) ** 2
        + m2 * l1 * l2 * u * (u + v) * cos(b)
    )
    return Energy(kinetic, -(m1 + m2) * g * l1 * cos(a) - m2 * g * l2 * cos(a + b), (7, 3))


def _spherical() -> Energy:
    g, m, l, th, f, w = S("g m l theta phi.u theta.u")
    return Energy(HALF * m * l**2 * (w**2 + f**2 * sin(th) ** 2), -m * g * l * cos(th), (2, 1))


def _gyroscope() -> Energy:
    A3, B1, B2, B3, C, D = S("A3 B1 B2 B3 C D")
    b, a1, b1, c1 = S("beta alpha.u beta.u gamma.u")
    twice = (
        A3 * a1**2
        + B1 * b1**2
        + (B2 + C) * (a1 * sin(b)) ** 2
        + C * b1**2
        + B3 * (a1 * cos(b)) ** 2
        + D * (c1 + a1 * cos(b)) ** 2
    )
    return Energy(HALF * twice, sp.Integer(0), (9, 0))


def _top() -> Energy:
    g, m, l, I1, I3 = S("g m l I1 I3")
    th, f, w, p = S("theta phi.u theta.u psi.u")
    kinetic = HALF * I1 * (w**2 + f**2 * sin(th) ** 2) + HALF * I3 * (p + f * cos(th)) ** 2
    return Energy(kinetic, m * g * l * cos(th), (5, 1))


def _arm() -> Energy:
    g, m1, m2, mp, l1, l2, c1, c2, I1, I2 = S("g m1 m2 mp l1 l2 lc1 lc2 I1 I2")
    a, b, u, v = S("q1 q2 q1.u q2.u")

    def end(length: Any) -> Any:
        """Square of the velocity of a point of the second link."""
        return l1**2 * u**2 + length**2 * (u + v) ** 2 + 2 * l1 * length * u * (u + v) * cos(b)

    kinetic = HALF * (
        m1 * c1**2 * u**2 + I1 * u**2 + m2 * end(c2) + mp * end(l2) + I2 * (u + v) ** 2
    )
    height = l1 * sin(a) + c2 * sin(a + b), l1 * sin(a) + l2 * sin(a + b)
    return Energy(kinetic, g * (m1 * c1 * sin(a) + m2 * height[0] + mp * height[1]), (17, 5))


ENERGIES = {
    "cart": _cart(),
    "double": _double(),
    "spherical": _spherical(),
    "gyroscope": _gyroscope(),
    "top": _top(),
    "arm": _arm(),
}


def rigid(rotation: str) -> cd.Scene:
    """A body with principal moments A, B, C that turns about its center of mass."""
    scene = model("rigid", "")
    A, B, C = parameters(scene, "kg*m^2", "A B C")
    body = scene.body("body", mass=1.0, inertia=(A, B, C))
    scene.joint("r", cd.Spherical(rotation=rotation), scene.ground, body)
    return scene


def euler_equations() -> tuple[list[Any], tuple[int, ...]]:
    """h of Euler's equations, and terms. Goldstein, Classical Mechanics, section 5.5."""
    A, B, C, x, y, z = S("A B C r.u.x r.u.y r.u.z")
    return [(C - B) * y * z, (A - C) * z * x, (B - A) * x * y], (2, 2, 2)


def euler_rates() -> tuple[list[Any], tuple[int, ...]]:
    """Rates of Euler's angles (z, x, z) by the angular velocity in body axes, and terms.

    Hughes, Spacecraft Attitude Dynamics, section 2.3, solved for the sequence of Goldstein.
    """
    th, psi, x, y, z = S("theta psi x y z")
    f = (x * sin(psi) + y * cos(psi)) / sin(th)
    return [f, x * cos(psi) - y * sin(psi), z - f * cos(th)], (2, 2, 3)


def quaternion_rates() -> tuple[list[Any], tuple[int, ...]]:
    """Rates of a unit quaternion by the angular velocity in body axes, and terms.

    Hughes, Spacecraft Attitude Dynamics, section 2.3: 2 q' = q * (0, omega).
    """
    w, a, b, c, x, y, z = S("w a b c x y z")
    twice = [
        -a * x - b * y - c * z,
        w * x + b * z - c * y,
        w * y + c * x - a * z,
        w * z + a * y - b * x,
    ]
    return [HALF * entry for entry in twice], (3, 3, 3, 3)
