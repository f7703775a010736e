"""A motion that is computed by many programs, and what they have to know about it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

import cardan as cd
from cardan.runtime.verification.flat_scene import scene_of
from cardan.runtime.verification.newton_euler import Scene

Array = NDArray[np.float64]
Anchor = tuple[str, tuple[float, float, float]]


@dataclass(frozen=True)
class Spring:
    """A spring between two points, each a body (or "ground") and a place in its axes."""

    ends: tuple[Anchor, Anchor]
    stiffness: float
    length: float


@dataclass(frozen=True)
class Loads:
    """Forces besides gravity, for programs that do not read our scenes.

    Attributes:
        constant, stiffness, damping: Joint -> force along it, and what it loses per coordinate
            and per speed.
        springs: Between points.
    """

    constant: Mapping[str, float] = field(default_factory=dict)
    stiffness: Mapping[str, float] = field(default_factory=dict)
    damping: Mapping[str, float] = field(default_factory=dict)
    springs: tuple[Spring, ...] = ()


@dataclass(frozen=True)
class Problem:
    """One motion.

    Attributes:
        name: Short; that of its file.
        title: As tables call it.
        text: What moves, from where and for how long.
        build: Makes the scene.
        start: Coordinates at the start, where everything is at rest.
        end: Its end [s].
        places: ``places(model, q)``: what errors are taken of, at the end (k,).
        unit: Of the places.
        methods: Integrators of ours with the tolerances they are run at.
        tolerances: Those of other programs that choose their steps.
        steps: How many the others take.
        loads: See :class:`Loads`.
        stiff: Whether explicit methods take a hundred times as many steps as implicit ones.
        exact: ``exact(model, x0)``: places at the end by a way of its own, where there is one.
        source: Of these, in words.
    """

    name: str
    title: str
    text: str
    build: Callable[[], cd.Scene]
    start: Mapping[str, float]
    end: float
    places: Callable[[cd.CompiledModel, Array], Array]
    unit: str
    methods: Mapping[str, tuple[float, ...]]
    tolerances: tuple[float, ...]
    steps: tuple[int, ...]
    loads: Loads = Loads()
    stiff: bool = False
    exact: Callable[[cd.CompiledModel, Array], Array] | None = None
    source: str = ""


@dataclass(frozen=True)
class Task:
    """A problem ready to be computed.

    Attributes:
        problem: Which one.
        model: Compiled by us.
        x0: The state at the start (nx,).
        exact: Places at the end (k,).
        doubt: How far two ways to them are apart.
    """

    problem: Problem
    model: cd.CompiledModel
    x0: Array
    exact: Array
    doubt: float

    def error(self, q: Array) -> float:
        """Largest error of the places at the end."""
        if not np.all(np.isfinite(q)):
            return float("inf")
        return float(np.abs(self.problem.places(self.model, q) - self.exact).max())

    @property
    def scene(self) -> Scene:
        """Tree, masses and frames as numbers."""
        return scene_of(self.model)

    @property
    def closed(self) -> bool:
        """Whether joints are cut."""
        return bool(self.model.manifest["cuts"])

    def along(self, values: Mapping[str, float]) -> Array:
        """Numbers by joint as a vector (nu,)."""
        names = self.model.coordinates
        return np.array([values.get(name, 0.0) for name in names])


def tip(count: int, length: float) -> Callable[[Any, Array], Array]:
    """Place (x, z) of the end of a pendulum of so many equal links in the plane."""

    def place(model: Any, q: Array) -> Array:
        angles = np.cumsum(q[:count])
        return -length / count * np.array([np.sin(angles).sum(), np.cos(angles).sum()])

    return place


def points(name: str, count: int, length: float) -> cd.Scene:
    """Point masses of 1 kg at the ends of equal rods without mass, hanging along -z.

    Args:
        name: Of the model.
        count: Masses.
        length: Of all rods together [m].
    """
    scene = cd.Scene(name, gravity=(0, 0, -9.81))
    rod, parent = length / count, scene.ground
    for k in range(count):
        body = scene.body(f"link{k}", mass=1.0, com=(0, 0, -rod))
        scene.joint(f"hinge{k}", cd.Revolute("y"), parent, body)
        parent = body.at(0, 0, -rod)
    return scene
