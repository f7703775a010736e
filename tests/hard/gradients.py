"""Gradients of motions that are hard to differentiate, against closed forms."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

import cardan as cd

from .case import compiled

G = 9.81
TIGHT = {"rtol": 1e-13, "atol": 1e-15}
TINY = 1e-30  # of complex steps
Differentiated = tuple[float, Any]


@dataclass(frozen=True)
class GradientCase:
    """A motion that is hard to differentiate for some reason, with an oracle.

    Attributes:
        name: In test output and in the page.
        hard: What is hard.
        oracle: What the error is measured by, and its unit.
        bound: Of the error.
        differentiate: The error, and the record of the gradient.
    """

    name: str
    hard: str
    oracle: str
    bound: float
    differentiate: Callable[[], Differentiated]

    def __repr__(self) -> str:
        return self.name


@dataclass(frozen=True)
class GradientOutcome:
    """What was measured: error, steps, events and time [ms]."""

    error: float
    steps: int
    events: int
    milliseconds: float


def measure(case: GradientCase) -> GradientOutcome:
    """Differentiate the motion of a case; the time is that of all, models compiled before."""
    case.differentiate()
    begin = time.perf_counter()
    error, found = case.differentiate()
    spent = time.perf_counter() - begin
    motion = found.motion
    return GradientOutcome(error, len(motion.t) - 1, len(motion.events), 1e3 * spent)


def thrown() -> cd.Scene:
    """A mass over a floor or under a ceiling."""
    scene = cd.Scene("thrown", gravity=(0, 0, -G))
    e, top = scene.parameter("e", 0.95), scene.parameter("top", 100.0)
    scene.joint("z", cd.Prismatic("z"), scene.ground, scene.body("ball", mass=1.0))
    scene.force("walls", cd.Stop("z", lower=0.0, upper=top, restitution=e))
    return scene


def worst(found: Any, exact: Any) -> float:
    """Largest error, each of its own value."""
    return max(abs(found.slope[name] / value - 1) for name, value in exact.items())


def impacts(t: float) -> Differentiated:
    """Height of a ball that bounces, from 1 m."""
    e = 0.95

    def height(h: complex, e: complex) -> complex:
        start = np.sqrt(2 * h / G)
        speed, at = G * start, start
        while (at + 2 * e * speed / G).real < t:
            speed, at = e * speed, at + 2 * e * speed / G
        return e * speed * (t - at) - G * (t - at) ** 2 / 2

    found = compiled(thrown, ()).gradient(
        t, cd.cost(final="z"), wrt=("q0.z", "e"), q={"z": 1.0}, **TIGHT
    )
    exact = {
        "q0.z": height(1 + TINY * 1j, e).imag / TINY,
        "e": height(1.0, e + TINY * 1j).imag / TINY,
    }
    return worst(found, exact), found


def near_touch(speed: float) -> Differentiated:
    """A ball that reaches a ceiling with hardly any speed: all depends on when."""
    up, t = 5.0, 0.8
    top = (up**2 - speed**2) / (2 * G)

    def height(h: complex, v: complex) -> complex:
        at = np.sqrt(v**2 - 2 * G * (top - h))
        hit = (v - at) / G
        return top - 0.95 * at * (t - hit) - G * (t - hit) ** 2 / 2

    found = compiled(thrown, ()).gradient(
        t, cd.cost(final="z"), wrt=("q0.z", "u0.z"), q={"z": 0.0}, u={"z": up},
        parameters={"top": top}, **TIGHT,
    )  # fmt: skip
    exact = {
        "q0.z": height(TINY * 1j, up).imag / TINY,
        "u0.z": height(0.0, up + TINY * 1j).imag / TINY,
    }
    return worst(found, exact), found


def orbiting() -> cd.Scene:
    """A point mass about a fixed one, with G M = 1."""
    scene = cd.Scene("orbit", gravity=(0, 0, 0))
    point, carriage = scene.body("point", mass=1.0), scene.body("carriage", mass=0.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, carriage)
    scene.joint("y", cd.Prismatic("y"), carriage, point)
    x, y = scene.q("x"), scene.q("y")
    pull = -((x**2 + y**2) ** (-1.5))
    scene.force("pull", cd.Force(point, (pull * x, pull * y, 0)))
    return scene


def orbits(turns: int) -> Differentiated:
    """Where a body is after many turns in an orbit, by its first place and speed.

    Kepler's equation, its solution by complex Newton steps.
    """
    t, eccentric = 2 * np.pi * turns, 0.5
    start = 1 - eccentric, np.sqrt((1 + eccentric) / (1 - eccentric))

    def place(x: complex, v: complex) -> complex:
        a = 1 / (2 / x - v**2)
        e, rate = 1 - x / a, a**-1.5
        E: complex = 2 * np.pi * turns
        for _ in range(40):
            E -= (E - e * np.sin(E) - rate * t) / (1 - e * np.cos(E))
        return complex(a * np.sqrt(1 - e**2) * np.sin(E))

    found = compiled(orbiting, ()).gradient(
        t, cd.cost(final="y"), wrt=("q0.x", "u0.y"), q={"x": start[0]}, u={"y": start[1]}, **TIGHT
    )
    exact = {
        "q0.x": place(start[0] + TINY * 1j, start[1]).imag / TINY,
        "u0.y": place(start[0], start[1] + TINY * 1j).imag / TINY,
    }
    return worst(found, exact), found


def rubbing() -> cd.Scene:
    """A spring and dry friction."""
    scene = cd.Scene("rubbing", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=2.0))
    k = scene.parameter("k", 50.0)
    scene.force("spring", cd.JointSpring("x", stiffness=k))
    scene.force("rail", cd.Friction("x", coulomb=scene.parameter("friction", 0.3)))
    return scene


def sticking() -> Differentiated:
    """A block that swings thirty half cycles, each shorter by 2 F / k, and sticks."""
    k, friction, start = 50.0, 0.3, 0.37
    halves = int(np.ceil((start - friction / k) / (2 * friction / k)))
    found = compiled(rubbing, ()).gradient(
        25.0, cd.cost(final="x"), wrt=("q0.x", "k", "friction"), q={"x": start}, **TIGHT
    )
    sign = (-1) ** halves
    exact = {
        "q0.x": sign, "friction": -sign * 2 * halves / k,
        "k": sign * 2 * halves * friction / k**2,
    }  # fmt: skip
    return worst(found, exact), found


CASES: dict[str, GradientCase] = {
    case.name: case
    for case in (
        GradientCase("22 impacts", "the time of each moves those of all behind it",
                     "closed form, complex steps; of the derivative", 1e-10,
                     partial(impacts, 12.0)),
        GradientCase("all but a touch", "a ball meets a ceiling with 1 mm/s, which it left the "
                     "floor for with 5 m/s: its impact moves 5,000 times as much as its start",
                     "closed form, complex steps; of the derivative", 1e-7,
                     partial(near_touch, 1e-3)),
        GradientCase("100 revolutions", "derivatives grow with every turn of an orbit of "
                     "eccentricity 0.5", "Kepler's equation, complex steps; of the derivative",
                     1e-6, partial(orbits, 100)),
        GradientCase("sticks after 31 half cycles", "friction turns around at every end, and holds "
                     "at last", "closed form; of the derivative", 1e-9, sticking),
    )
}  # fmt: skip
