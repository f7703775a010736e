"""Scenes whose cycles are followed, each in other units and orders too."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import sympy as sp

import cardan as cd

Build = Callable[["Variant"], cd.CompiledModel]


@dataclass(frozen=True)
class Variant:
    """How a scene is written.

    Attributes:
        length, time: Units of length and time in one meter and one second; masses stay.
        turned: Whether bodies and forces are declared in the opposite order.
        coordinates: For compile.
    """

    length: float = 1.0
    time: float = 1.0
    turned: bool = False
    coordinates: str = "relative"

    @property
    def force(self) -> float:
        """The unit of force."""
        return self.length / self.time**2

    @property
    def energy(self) -> float:
        """The unit of energy, and of moments."""
        return self.force * self.length

    def ordered(self, items: Any) -> list[Any]:
        """Items as they are declared."""
        return [*items][::-1] if self.turned else [*items]


def slides(variant: Variant, names: str, forces: Callable[..., Any], **parameters: float) -> Any:
    """Bodies of mass 1 on slides; forces by positions, speeds and parameters without units."""
    scene = cd.Scene("slides", gravity=(0, 0, 0))
    values = [scene.parameter(name, value) for name, value in parameters.items()]
    for name in variant.ordered(names):
        body = scene.body(f"body_{name}", mass=1.0, inertia=(variant.length**2,) * 3)
        scene.joint(name, cd.Prismatic("x"), scene.ground, body)
    x = [scene.q(name) / variant.length for name in names]
    v = [scene.u(name) * variant.time / variant.length for name in names]
    acting = dict(zip(names, forces(x, v, cd.t / variant.time, *values), strict=True))
    for name in variant.ordered(names):
        force = variant.force * acting[name]
        scene.force(f"force_{name}", cd.JointForce(name, force))
    return cd.compile(scene, coordinates=variant.coordinates)


def limit_cycle(variant: Variant) -> Any:
    """B. van der Pol (1926), and a damped follower beside it."""
    return slides(
        variant, "xy",
        lambda x, v, t, mu: (mu * (1 - x[0] ** 2) * v[0] - x[0], 0.3 * x[0] - x[1] - 0.4 * v[1]),
        mu=0.5,
    )  # fmt: skip


def resonance(variant: Variant) -> Any:
    """G. Duffing (1918): a force whose amplitude is swept, through two folds."""
    return slides(
        variant, "x",
        lambda x, v, t, p: (p * sp.cos(1.4 * t) - 0.1 * v[0] - x[0] - x[0] ** 3,), p=0.05,
    )  # fmt: skip


def pair(variant: Variant) -> Any:
    """Two masses on springs x + x^3 / 2, coupled."""
    return slides(
        variant, "xy",
        lambda x, v, t, k: (
            -x[0] - x[0] ** 3 / 2 - k * (x[0] - x[1]), -x[1] - x[1] ** 3 / 2 - k * (x[1] - x[0]),
        ), k=0.05,
    )  # fmt: skip


def shaft(variant: Variant) -> Any:
    """A pendulum with two hinges on a shaft that turns: gyroscopic, its Jacobi energy is kept."""
    size = variant.length
    scene = cd.Scene("shaft", gravity=(0, 0, -9.81 * variant.force))
    inertia = {"post": (0, 0, 0), "fork": (0.1, 0.06, 0.05), "bob": (0.1, 0.1, 0.05)}
    body = {
        name: scene.body(
            name,
            mass={"post": 0.0, "fork": 0.3, "bob": 1.0}[name],
            com=(0, 0, -size if name == "bob" else 0),
            inertia=tuple(size**2 * one for one in inertia[name]),
        )
        for name in variant.ordered(inertia)
    }
    rate = 1.0 / variant.time
    scene.joint("turn", cd.Revolute("z"), scene.ground, body["post"], prescribed=rate * cd.t)
    scene.joint("x", cd.Revolute("x"), body["post"], body["fork"])
    scene.joint("y", cd.Revolute("y"), body["fork"], body["bob"])
    scene.force("spring", cd.JointSpring("x", stiffness=3.0 * variant.energy))
    return cd.compile(scene, coordinates=variant.coordinates)


def linkage(variant: Variant) -> Any:
    """A four-bar linkage under a torque that is swept."""
    size, scene = variant.length, cd.Scene("linkage", gravity=(0, 0, -9.81 * variant.force))
    P = scene.parameter("p", 1.0)
    body = {
        name: scene.body(name, mass=1.0, inertia=(0.1 * size**2,) * 3)
        for name in variant.ordered("abc")
    }
    turn = cd.Revolute("y")
    scene.joint("crank", turn, scene.ground, body["a"])
    scene.joint("elbow", turn, body["a"].at(size, 0, 0), body["b"])
    scene.joint("rocker", turn, scene.ground.at(2.5 * size, 0, 0), body["c"])
    scene.joint("pin", turn, body["b"].at(2.2 * size, 0, 0), body["c"].at(0, 0, 2 * size))
    forces = {
        "push": cd.JointForce("crank", variant.energy * P * sp.cos(2 * cd.t / variant.time)),
        "spring": cd.JointSpring("crank", stiffness=60.0 * variant.energy),
        "damper": cd.JointDamper("crank", damping=4.0 * variant.energy * variant.time),
    }
    for name in variant.ordered(forces):
        scene.force(name, forces[name])
    return cd.compile(scene, coordinates=variant.coordinates)


@dataclass(frozen=True)
class CycleScene:
    """A scene with a path of cycles.

    Attributes:
        name: In test output.
        build: Compiles it.
        swept: Name, start and end.
        passes: Kinds of special points before the end.
        key: Coordinate whose extremes are compared.
        start: Names and values next to the first cycle, without units.
        period: Of forces, without units; None where it is not forced.
        mode: Number of the mode that a family of an energy begins at.
        settle: Laps before the search.
        long: Whether the key is a length.
        coordinates: Other coordinates that it can be compiled in.
    """

    name: str
    build: Build
    swept: tuple[str, float, float]
    passes: tuple[str, ...] = ()
    key: str = "x"
    start: Mapping[str, float] = field(default_factory=dict)
    period: float | None = None
    mode: int | None = None
    settle: int = 0
    long: bool = True
    coordinates: tuple[str, ...] = ("absolute",)

    def load(self, variant: Variant) -> float:
        """The unit of what is swept."""
        return variant.energy if self.mode is not None else 1.0

    def size(self, variant: Variant) -> float:
        """The unit of the key."""
        return variant.length if self.long else 1.0

    def cycle(self, variant: Variant, model: Any, **options: Any) -> Any:
        """The first cycle, of what is not a family of an energy."""
        start = {name: value * self.size(variant) for name, value in self.start.items()}
        period = None if self.period is None else self.period * variant.time
        begin = {"period": period, "settle": self.settle, "longest": 100 * variant.time}
        return model.cycle(start, check=True, **{**begin, **options})

    def follow(self, variant: Variant, model: Any, **options: Any) -> Any:
        """The path."""
        name, first, last = self.swept
        load = self.load(variant)
        begin: Any = model.modes()[self.mode] if self.mode is not None else None
        begin = self.cycle(variant, model) if begin is None else begin
        way = {name: (first * load, last * load)}
        return model.continuation(**{"swept": way, "of": "cycles", "start": begin, **options})


SCENES: dict[str, CycleScene] = {
    scene.name: scene
    for scene in (
        CycleScene("limit cycle", limit_cycle, ("mu", 0.5, 1.5), start={"x": 2.0}, settle=4),
        CycleScene("resonance", resonance, ("p", 0.05, 0.6), ("fold", "fold"),
                   start={"x": 0.0}, period=2 * np.pi / 1.4, settle=40),
        CycleScene("pair", pair, ("energy", 0.0, 0.8), ("branch point",), mode=1),
        CycleScene("shaft", shaft, ("energy", 0.0, 3.0), key="y", mode=0, long=False,
                   coordinates=()),
        CycleScene("linkage", linkage, ("p", 1.0, 4.0), key="crank", start={"crank": 0.1},
                   period=np.pi, settle=6, long=False),
    )
}  # fmt: skip
