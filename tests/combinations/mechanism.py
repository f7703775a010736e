"""The mechanism that every feature is added to: two bars that swing, and a chain behind them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import cardan as cd

SPAN = 0.3
SMALL = 2e-3  # moment of inertia of a link [kg m^2]


@dataclass
class Mechanism:
    """A scene while features are added, and the places that they may use.

    Attributes:
        scene: The scene.
        root: The place that all of it hangs on: the ground, or a base that moves.
        arm, forearm: The bars that are always there, along x where all coordinates are 0.
        tip: The end of the chain, to which the next link is joined.
        reach: Coordinate x of the tip where all coordinates are 0.
        inputs: Values of inputs during a run.
        by_conditions: Whether frames of superelements are placed by conditions among interfaces,
            not by coordinates: other equations of the same motion.
    """

    scene: cd.Scene
    root: Any
    arm: Any = None
    forearm: Any = None
    tip: Any = None
    reach: float = 0.9
    inputs: dict[str, object] = field(default_factory=dict)
    by_conditions: bool = False

    def link(self, name: str, joint: Any, length: float = 0.12, **start: Any) -> Any:
        """One more link of the chain, behind a joint."""
        body = self.scene.body(
            name, mass=0.2, com=(length / 2, 0, 0.01), inertia=(SMALL, 2 * SMALL, 1.5 * SMALL)
        )
        self.scene.joint(f"{name}_joint", joint, self.tip, body, **start)
        self.tip = body.at(length, 0, 0)
        self.reach += length
        return body

    def bar(self, name: str, length: float, mass: float = 0.2) -> Any:
        """A bar along x for a loop."""
        size = mass * length * length / 12
        return self.scene.body(
            name, mass=mass, com=(length / 2, 0, 0), inertia=(size / 10, size, size)
        )


def trunk(made: Mechanism) -> None:
    """Two bars in a plane, behind each other."""
    scene, root = made.scene, made.root
    inertia = cd.inertia.rod(1.0, 0.5, axis="x")
    made.arm = scene.body("arm", mass=1.0, com=(0.25, 0, 0), inertia=inertia)
    inertia = cd.inertia.rod(0.6, 0.4, axis="x")
    made.forearm = scene.body("forearm", mass=0.6, com=(0.2, 0, 0), inertia=inertia)
    scene.joint("shoulder", cd.Revolute("y"), root, made.arm, q0=0.3)
    elbow = cd.Revolute("y")
    scene.joint("elbow", elbow, made.arm.at(0.5, 0, 0), made.forearm, q0=0.5, u0=1.5)
    made.tip = made.forearm.at(0.4, 0, 0)


def outputs(made: Mechanism) -> None:
    """Where the tip and the forearm are: what two routes must agree on."""
    places: Mapping[str, Any] = {"tip": made.tip, "hand": made.forearm.at(0.4, 0, 0)}
    for name, place in places.items():
        for axis, value in zip("xyz", place.position(), strict=True):
            made.scene.output(f"{name}_{axis}", value, unit="m")
