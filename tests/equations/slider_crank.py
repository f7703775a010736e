"""The slider-crank mechanism as books have it, in two forms.

Written down by hand before any of it was compared with what is derived. A crank of length r turns
by theta, its moment about the shaft is I1 and its center of mass at s1; the rod has the length l.
Gravity acts across the slide.
"""

from __future__ import annotations

from typing import Any, ClassVar

import sympy as sp

import cardan as cd

from .classical import S, cos, model, parameters, sin


def _parts(name: str) -> tuple[cd.Scene, Any, Any, tuple[Any, ...]]:
    scene = model(name, "y")
    m1, m2, m3 = parameters(scene, "kg", "m1 m2 m3")
    lengths = {"r": 0.1, "l": 0.3, "s1": 0.03, "e": 0.14}
    r, l, s1, e = (scene.parameter(name, value, unit="m") for name, value in lengths.items())
    I1 = scene.parameter("I1", 0.02, unit="kg*m^2")
    I2 = scene.parameter("I2", 0.01, unit="kg*m^2")
    about_center = I1 - m1 * s1**2
    crank = scene.body("crank", mass=m1, com=(s1, 0, 0), inertia=(about_center,) * 3)
    slider = scene.body("slider", mass=m3)
    return scene, crank, slider, (m2, r, l, e, I2)


def by_angles() -> cd.Scene:
    """The angle phi of the rod at the slider, opposite to theta; e: center of mass from there."""
    scene, crank, slider, (m2, r, l, e, I2) = _parts("slider_crank")
    rod = scene.body("rod", mass=m2, com=(-e, 0, 0), inertia=(I2, I2, I2))
    scene.joint("theta", cd.Revolute("z"), scene.ground, crank)
    scene.joint("x", cd.Prismatic("x"), scene.ground, slider, q0=0.4)
    scene.joint("phi", cd.Revolute((0, 0, -1)), slider, rod)
    scene.joint("pin", cd.Revolute("z"), crank.at(r, 0, 0), rod.at(-l, 0, 0), cut=True)
    return scene


def by_relative_angle() -> cd.Scene:
    """The angle beta of the rod at the crank, relative to it; e: center of mass from there."""
    scene, crank, slider, (m2, r, l, e, I2) = _parts("slider_crank")
    rod = scene.body("rod", mass=m2, com=(e, 0, 0), inertia=(I2, I2, I2))
    scene.joint("theta", cd.Revolute("z"), scene.ground, crank)
    scene.joint("x", cd.Prismatic("x"), scene.ground, slider, q0=0.4)
    scene.joint("beta", cd.Revolute("z"), crank.at(r, 0, 0), rod)
    scene.joint("pin", cd.Revolute("z"), slider, rod.at(l, 0, 0), cut=True)
    return scene


class Eksergian:
    """One equation in the angle of the crank, with the coefficients of velocity k and of L.

    S. Doughty, Mechanics of Machines, chapters on kinematic coefficients and on Eksergian's
    equation of motion: I(theta) theta'' + C(theta) theta'^2 = Q, with the first derivatives k and
    the second ones L by theta of the angle phi of the rod and of the place x of the slider:
    r sin theta = l sin phi, x = r cos theta + l cos phi.
    """

    g, m1, m2, m3, r, l, s1, e, I1, I2 = S("g m1 m2 m3 r l s1 e I1 I2")
    theta, omega, phi, x = S("theta theta.u phi x")
    # as they are called in print: behind the dot is what is differentiated by
    k_phi, k_x, L_phi, L_x = S("phi.theta x.theta phi.theta.theta x.theta.theta")

    mass = (
        I1 + (m2 + m3) * k_x**2 + 2 * m2 * e * sin(phi) * k_phi * k_x + (m2 * e**2 + I2) * k_phi**2
    )
    mass_terms = 6
    centripetal = (
        (m2 + m3) * k_x * L_x
        + m2 * e * (sin(phi) * (L_x * k_phi + k_x * L_phi) + cos(phi) * k_x * k_phi**2)
        + (m2 * e**2 + I2) * k_phi * L_phi
    )
    bias = centripetal * omega**2 + m1 * g * s1 * cos(theta) + m2 * g * e * cos(phi) * k_phi
    bias_terms = 9
    definitions: ClassVar = {
        phi: sp.asin(r / l * sin(theta)),
        x: r * cos(theta) + l * cos(phi),
        k_phi: r * cos(theta) / (l * cos(phi)),
        k_x: -r * sin(theta) - l * k_phi * sin(phi),
        L_phi: (l * k_phi**2 * sin(phi) - r * sin(theta)) / (l * cos(phi)),
        L_x: -r * cos(theta) - l * k_phi**2 * cos(phi) - l * L_phi * sin(phi),
    }
    definition_terms: ClassVar = {phi: 1, x: 2, k_phi: 1, k_x: 2, L_phi: 2, L_x: 3}


class Multipliers:
    """Crank, rod and slider with two multipliers; the angle beta of the rod is relative.

    J. Wittenburg, Dynamics of Multibody Systems, chapter on systems with closed chains: the tree
    is a double pendulum and a slider, the conditions are r cos theta + l cos(theta + beta) = x and
    r sin theta + l sin(theta + beta) = 0.
    """

    g, m1, m2, m3, r, l, s1, e, I1, I2 = S("g m1 m2 m3 r l s1 e I1 I2")
    theta, x, beta, u, v, w = S("theta x beta theta.u x.u beta.u")
    both, c, s = theta + beta, cos(beta), sin(beta)

    off = I2 + m2 * (e**2 + r * e * c)
    mass_matrix = (
        (I1 + I2 + m2 * (r**2 + e**2 + 2 * r * e * c), 0, off),
        (0, m3, 0),
        (off, 0, I2 + m2 * e**2),
    )
    bias = (
        -m2 * r * e * s * (2 * u * w + w**2)
        + m1 * g * s1 * cos(theta)
        + m2 * g * (r * cos(theta) + e * cos(both)),
        0,
        m2 * r * e * u**2 * s + m2 * g * e * cos(both),
    )
    constraints = (r * cos(theta) + l * cos(both) - x, r * sin(theta) + l * sin(both))
    jacobian = (
        (-r * sin(theta) - l * sin(both), -1, -l * sin(both)),
        (r * cos(theta) + l * cos(both), 0, l * cos(both)),
    )
    gamma = (
        r * u**2 * cos(theta) + l * (u + w) ** 2 * cos(both),
        r * u**2 * sin(theta) + l * (u + w) ** 2 * sin(both),
    )
    mass_terms = (5, 0, 3, 0, 1, 0, 3, 0, 2)
    bias_terms = (5, 0, 2)
    constraint_terms = (3, 2)
    jacobian_terms = (2, 1, 1, 2, 0, 1)
    gamma_terms = (4, 4)
