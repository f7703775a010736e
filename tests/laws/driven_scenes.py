"""Loops through a prescribed joint and one that a relation ties to it, with their closed forms."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

import cardan as cd

GRAVITY = 9.81
# mass, length and moment of inertia about the center of mass
CARRIAGE, CRANK, LEG = 2.0, (0.7, 0.4, 0.02), (1.0, 1.0, 0.1)
APART = 0.3
# how the scene ties the other side to the prescribed one, and whether that takes no drive
MIRRORED = ("coordinates", "speeds", "frames", "couple")
DRIVEN = ("time", "input", "prescribed")


@dataclass(frozen=True)
class Driven:
    """A symmetric loop: two feet, of which one is prescribed, and two legs that meet in the middle.

    Attributes:
        name: Of the scene.
        drive: Coordinate of the prescribed foot and its rate, by (complex) time.
        kind: Of the feet.
        feet: Of a scene its feet, where they are on the ground, and the ends of the legs on them.
        energy: Kinetic and potential energy together, by time.
    """

    name: str
    drive: tuple[float, float]
    kind: Any
    feet: Callable[[cd.Scene], tuple[Any, Any, Any, Any, Any, Any]]
    energy: Callable[[Any], Any]

    def force(self, t: Any) -> Any:
        """What drives the foot where nothing else does work: rate of the energy over its rate."""
        return self.energy(np.asarray(t) + 1e-30j).imag / 1e-30 / self.drive[1]

    def build(self, tied: str) -> cd.Scene:
        """The scene; the driven foot is 'right', the other 'left'."""
        scene = cd.Scene(f"{self.name} {tied}", gravity=(0, 0, -GRAVITY))
        right, left, at_right, at_left, on_right, on_left = self.feet(scene)
        start, rate = self.drive
        value = start + rate * cd.t
        scene.joint("right", self.kind, at_right, right, prescribed=value)
        other = {"couple": ("right", -1)} if tied == "couple" else {"q0": -start}
        if tied == "prescribed":
            other = {"prescribed": -value}
        scene.joint("left", self.kind, at_left, left, **other)
        m, length, inertia = LEG
        legs = [
            scene.body(n, mass=m, com=(0, 0, length / 2), inertia=(inertia,) * 3)
            for n in ("leg_right", "leg_left")
        ]
        lean = self.leans(start)
        scene.joint("knee_right", cd.Revolute("y"), on_right, legs[0], q0=-lean)
        scene.joint("knee_left", cd.Revolute("y"), on_left, legs[1], q0=lean)
        ends = [leg.at(0, 0, length) for leg in legs]
        scene.joint("top", cd.Revolute("y"), *ends)
        unit = "m" if self.kind == cd.Prismatic("x") else "rad"
        if tied == "coordinates":
            scene.constraint("tie", scene.q("right") + scene.q("left"), unit=unit)
        elif tied == "speeds":
            scene.constraint("tie", scene.u("right") + scene.u("left"), unit=f"{unit}/s")
        elif tied == "frames":
            places = [frame.position()[0] for frame in (on_right, on_left)]
            scene.constraint("tie", sum(places), unit="m")
        elif tied == "time":
            scene.constraint("tie", scene.q("left") + value, unit=unit)
        elif tied == "input":
            given = scene.input("given", unit=unit)
            scene.constraint("tie", scene.q("left") + given, unit=unit)
        return scene

    def leans(self, q: Any) -> Any:
        """Angle of the right leg against its foot."""
        if self.kind == cd.Prismatic("x"):
            return np.arcsin(q / LEG[1])
        return np.arcsin((APART + CRANK[1] * np.sin(q)) / LEG[1]) + q


def _carriages(scene: cd.Scene) -> tuple[Any, Any, Any, Any, Any, Any]:
    right, left = (scene.body(n, mass=CARRIAGE, inertia=(0.1,) * 3) for n in ("r", "l"))
    return right, left, scene.ground, scene.ground, right.at(0, 0, 0), left.at(0, 0, 0)


def _cranks(scene: cd.Scene) -> tuple[Any, Any, Any, Any, Any, Any]:
    m, length, inertia = CRANK
    right, left = (
        scene.body(n, mass=m, com=(0, 0, length / 2), inertia=(inertia,) * 3) for n in ("r", "l")
    )
    ground = scene.ground
    tips = [crank.at(0, 0, length) for crank in (right, left)]
    return right, left, ground.at(APART, 0, 0), ground.at(-APART, 0, 0), tips[0], tips[1]


def _leg(x: Any, z: Any, vx: Any, vz: Any) -> Any:
    """Energy of a leg whose foot is at x, z with its rates."""
    m, length, inertia = LEG
    sine = x / length
    cosine = np.sqrt(1 - sine**2)
    omega = vx / (length * cosine)
    velocity = vx / 2, vz - omega * length * sine / 2
    kinetic = m * (velocity[0] ** 2 + velocity[1] ** 2) / 2 + inertia * omega**2 / 2
    return kinetic + m * GRAVITY * (z + length * cosine / 2)


def _of_carriages(t: Any) -> Any:
    start, rate = CARRIAGES
    return 2 * (CARRIAGE * rate**2 / 2 + _leg(start + rate * t, 0.0, rate, 0.0))


def _of_cranks(t: Any) -> Any:
    (start, rate), (m, length, inertia) = CRANKS, CRANK
    angle = start + rate * t
    sine, cosine = np.sin(angle), np.cos(angle)
    x, z, vx, vz = APART + length * sine, length * cosine, length * cosine * rate, -length * sine
    moment = inertia + m * length**2 / 4
    crank = moment * rate**2 / 2 + m * GRAVITY * length * cosine / 2
    return 2 * (crank + _leg(x, z, vx, vz * rate))


CARRIAGES, CRANKS = (0.5, 0.05), (0.2, 0.3)
SCENES = {
    one.name: one
    for one in (
        Driven("carriages", CARRIAGES, cd.Prismatic("x"), _carriages, _of_carriages),
        Driven("cranks", CRANKS, cd.Revolute("y"), _cranks, _of_cranks),
    )
}
