"""Six classical systems with their equations as books have them.

Written down from the books and by hand before any of it was compared with what is derived. The
``terms`` of an entry are the summands it has in the book when brackets are multiplied out.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import sympy as sp

import cardan as cd

sin, cos = sp.sin, sp.cos


@dataclass(frozen=True)
class Classical:
    """A scene and M, h of M udot + h = tau from a book.

    Attributes:
        book: Author, title, place; the coordinates it uses.
        scene: Makes the model.
        mass_matrix, bias: The book's, in the symbols of the model.
        terms: Summands of the entries of M (row by row) and of h.
    """

    book: str
    scene: Callable[[], cd.Scene]
    mass_matrix: list[list[Any]]
    bias: list[Any]
    terms: tuple[tuple[int, ...], tuple[int, ...]]


def S(names: str) -> tuple[Any, ...]:
    return sp.symbols(names)


def parameters(scene: cd.Scene, unit: str, names: str) -> list[Any]:
    """Parameters with values that no formula can confuse."""
    number = len(scene.parameters)
    return [
        scene.parameter(name, 1.0 + (number + k) / 8, unit=unit)
        for k, name in enumerate(names.split())
    ]


def model(name: str, gravity: str) -> cd.Scene:
    """A model whose gravity is the parameter g along -y or -z; "" for none."""
    g = sp.Symbol("g")
    pulls = {"": (0, 0, 0), "y": (0, -g, 0), "z": (0, 0, -g)}
    scene = cd.Scene(name, gravity=pulls[gravity])
    if gravity:
        scene.parameter("g", 9.81, unit="m/s^2")
    return scene


def cart() -> cd.Scene:
    scene = model("cart", "z")
    M, m = parameters(scene, "kg", "M m")
    (l,) = parameters(scene, "m", "l")
    cart, bob = scene.body("cart", mass=M), scene.body("bob", mass=m, com=(0, 0, -l))
    scene.joint("x", cd.Prismatic("x"), scene.ground, cart)
    scene.joint("theta", cd.Revolute((0, -1, 0)), cart, bob)
    return scene


def double() -> cd.Scene:
    scene = model("double", "z")
    m1, m2 = parameters(scene, "kg", "m1 m2")
    l1, l2 = parameters(scene, "m", "l1 l2")
    upper = scene.body("upper", mass=m1, com=(0, 0, -l1))
    lower = scene.body("lower", mass=m2, com=(0, 0, -l2))
    scene.joint("theta1", cd.Revolute("y"), scene.ground, upper)
    scene.joint("theta2", cd.Revolute("y"), upper.at(0, 0, -l1), lower)
    return scene


def spherical() -> cd.Scene:
    scene = model("spherical", "z")
    (m,) = parameters(scene, "kg", "m")
    (l,) = parameters(scene, "m", "l")
    plane, bob = scene.body("plane"), scene.body("bob", mass=m, com=(0, 0, -l))
    scene.joint("phi", cd.Revolute("z"), scene.ground, plane)
    scene.joint("theta", cd.Revolute("y"), plane, bob)
    return scene


def gyroscope() -> cd.Scene:
    scene = model("gyroscope", "")
    moments = "A1 A2 A3 B1 B2 B3 C D"
    A1, A2, A3, B1, B2, B3, C, D = parameters(scene, "kg*m^2", moments)
    outer = scene.body("outer", mass=1.0, inertia=(A1, A2, A3))
    inner = scene.body("inner", mass=1.0, inertia=(B1, B2, B3))
    rotor = scene.body("rotor", mass=1.0, inertia=(C, C, D))
    scene.joint("alpha", cd.Revolute("z"), scene.ground, outer)
    scene.joint("beta", cd.Revolute("x"), outer, inner)
    scene.joint("gamma", cd.Revolute("z"), inner, rotor)
    return scene


def top() -> cd.Scene:
    scene = model("top", "z")
    (m,) = parameters(scene, "kg", "m")
    (l,) = parameters(scene, "m", "l")
    # moments about the tip: what is left about the center of mass must be positive
    I1 = scene.parameter("I1", 4.0, unit="kg*m^2")
    I3 = scene.parameter("I3", 0.5, unit="kg*m^2")
    across = I1 - m * l**2
    turning, leaning = scene.body("turning"), scene.body("leaning")
    spinning = scene.body("spinning", mass=m, com=(0, 0, l), inertia=(across, across, I3))
    scene.joint("phi", cd.Revolute("z"), scene.ground, turning)
    scene.joint("theta", cd.Revolute("x"), turning, leaning)
    scene.joint("psi", cd.Revolute("z"), leaning, spinning)
    return scene


def arm() -> cd.Scene:
    scene = model("arm", "y")
    m1, m2, mp = parameters(scene, "kg", "m1 m2 mp")
    l1, l2, lc1, lc2 = parameters(scene, "m", "l1 l2 lc1 lc2")
    I1, I2 = parameters(scene, "kg*m^2", "I1 I2")
    first = scene.body("first", mass=m1, com=(lc1, 0, 0), inertia=(I1, I1, I1))
    second = scene.body("second", mass=m2, com=(lc2, 0, 0), inertia=(I2, I2, I2))
    payload = scene.body("payload", mass=mp)
    scene.joint("q1", cd.Revolute("z"), scene.ground, first)
    scene.joint("q2", cd.Revolute("z"), first.at(l1, 0, 0), second)
    scene.joint("grip", cd.Fixed(), second.at(l2, 0, 0), payload)
    return scene


def _cart() -> Classical:
    g, M, m, l, th, w = S("g M m l theta theta.u")
    return Classical(
        "Tedrake, Underactuated Robotics, chapter on acrobots and cart-poles: x of the cart, theta "
        "of the pole from hanging down",
        cart,
        [[M + m, m * l * cos(th)], [m * l * cos(th), m * l**2]],
        [-m * l * w**2 * sin(th), m * g * l * sin(th)],
        ((2, 1, 1, 1), (1, 1)),
    )


def _double() -> Classical:
    g, m1, m2, l1, l2 = S("g m1 m2 l1 l2")
    a, b, u, v = S("theta1 theta2 theta1.u theta2.u")
    off = m2 * l2**2 + m2 * l1 * l2 * cos(b)
    return Classical(
        "Tedrake, Underactuated Robotics, appendix on multi-body dynamics, the double pendulum: "
        "theta1 from hanging down, theta2 relative",
        double,
        [[(m1 + m2) * l1**2 + m2 * l2**2 + 2 * m2 * l1 * l2 * cos(b), off], [off, m2 * l2**2]],
        [
            -m2 * l1 * l2 * (2 * u + v) * v * sin(b)
            + (m1 + m2) * l1 * g * sin(a)
            + m2 * g * l2 * sin(a + b),
            m2 * l1 * l2 * u**2 * sin(b) + m2 * g * l2 * sin(a + b),
        ],
        ((4, 2, 2, 1), (5, 2)),
    )


def _spherical() -> Classical:
    g, m, l, th, f, w = S("g m l theta phi.u theta.u")
    return Classical(
        "Landau and Lifshitz, Mechanics, section 14, problem 1: spherical angles about the "
        "downward vertical",
        spherical,
        [[m * l**2 * sin(th) ** 2, 0], [0, m * l**2]],
        [
            2 * m * l**2 * f * w * sin(th) * cos(th),
            -m * l**2 * f**2 * sin(th) * cos(th) + m * g * l * sin(th),
        ],
        ((1, 0, 0, 1), (1, 2)),
    )


def _gyroscope() -> Classical:
    A3, B1, B2, B3, C, D = S("A3 B1 B2 B3 C D")
    b, a1, b1, c1 = S("beta alpha.u beta.u gamma.u")
    change = 2 * (B2 + C - B3 - D) * sin(b) * cos(b)
    return Classical(
        "Magnus, Kreisel, chapter on the gyroscope in gimbals: the angles of outer ring, inner "
        "ring and rotor; by hand from 2T = A3 a'^2 + B1 b'^2 + (B2 + C) (a' sin b)^2 + C b'^2 + "
        "B3 (a' cos b)^2 + D (c' + a' cos b)^2",
        gyroscope,
        [
            [A3 + (B2 + C) * sin(b) ** 2 + (B3 + D) * cos(b) ** 2, 0, D * cos(b)],
            [0, B1 + C, 0],
            [D * cos(b), 0, D],
        ],
        [
            change * a1 * b1 - D * b1 * c1 * sin(b),
            -change / 2 * a1**2 + D * a1 * c1 * sin(b),
            -D * a1 * b1 * sin(b),
        ],
        ((5, 0, 1, 0, 2, 0, 1, 0, 1), (5, 5, 1)),
    )


def _top() -> Classical:
    g, m, l, I1, I3 = S("g m l I1 I3")
    th, f, w, p = S("theta phi.u theta.u psi.u")
    return Classical(
        "Goldstein, Classical Mechanics, chapter 5, the heavy symmetrical top with one point "
        "fixed: Euler angles, moments about that point",
        top,
        [
            [I1 * sin(th) ** 2 + I3 * cos(th) ** 2, 0, I3 * cos(th)],
            [0, I1, 0],
            [I3 * cos(th), 0, I3],
        ],
        [
            2 * (I1 - I3) * f * w * sin(th) * cos(th) - I3 * w * p * sin(th),
            -(I1 - I3) * f**2 * sin(th) * cos(th) + I3 * f * p * sin(th) - m * g * l * sin(th),
            -I3 * f * w * sin(th),
        ],
        ((2, 0, 1, 0, 1, 0, 1, 0, 1), (3, 4, 1)),
    )


def _arm() -> Classical:
    g, m1, m2, mp, l1, l2, c1, c2, I1, I2 = S("g m1 m2 mp l1 l2 lc1 lc2 I1 I2")
    a, b, u, v = S("q1 q2 q1.u q2.u")
    h = -(m2 * l1 * c2 + mp * l1 * l2) * sin(b)
    off = m2 * (c2**2 + l1 * c2 * cos(b)) + mp * (l2**2 + l1 * l2 * cos(b)) + I2
    second = (m2 * c2 + mp * l2) * g * cos(a + b)
    return Classical(
        "Spong, Hutchinson and Vidyasagar, Robot Modeling and Control, chapter on dynamics, the "
        "planar elbow manipulator: q1 from the horizontal, q2 relative; the payload is a point "
        "mass at the end of the second link",
        arm,
        [
            [
                m1 * c1**2
                + m2 * (l1**2 + c2**2 + 2 * l1 * c2 * cos(b))
                + mp * (l1**2 + l2**2 + 2 * l1 * l2 * cos(b))
                + I1
                + I2,
                off,
            ],
            [off, m2 * c2**2 + mp * l2**2 + I2],
        ],
        [
            h * (2 * u * v + v**2) + (m1 * c1 + m2 * l1 + mp * l1) * g * cos(a) + second,
            -h * u**2 + second,
        ],
        ((9, 5, 5, 3), (9, 4)),
    )


CLASSICAL = {
    "cart": _cart(),
    "double": _double(),
    "spherical": _spherical(),
    "gyroscope": _gyroscope(),
    "top": _top(),
    "arm": _arm(),
}
