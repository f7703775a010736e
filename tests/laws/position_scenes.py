"""Linkages whose positions are followed, each in other units, orders and coordinates too."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

import cardan as cd

TILT = (0.4, -0.7, 1.1)  # of the ground, about x, y and z of itself
Point = tuple[float, float, float]


@dataclass(frozen=True)
class Variant:
    """How a linkage is written.

    Attributes:
        length: Unit of length in one meter.
        turned: Whether bodies and joints are declared in the opposite order.
        exchanged: Whether joints go from their children to their parents: angles change signs.
        cut: Whether loops are cut at another joint.
        tilted: Whether everything stands askew in the ground.
    """

    length: float = 1.0
    turned: bool = False
    exchanged: bool = False
    cut: bool = False
    tilted: bool = False

    @property
    def rotation(self) -> np.ndarray:
        """Axes of the linkage in the ground."""
        return Rotation.from_euler("XYZ", TILT).as_matrix() if self.tilted else np.eye(3)

    def ordered(self, items: Any) -> list[Any]:
        """Items as they are declared."""
        return [*items][::-1] if self.turned else [*items]

    def point(self, owner: Any, place: Point) -> Any:
        """A frame on a body, or on the ground as the linkage sees it."""
        x, y, z = self.length * np.array(place)
        if not isinstance(owner, cd.Scene):
            return owner.at(float(x), float(y), float(z))
        rotation = ("XYZ", *TILT) if self.tilted else None
        x, y, z = self.rotation @ [x, y, z]
        return owner.ground.at(float(x), float(y), float(z), rotation=rotation)


@dataclass(frozen=True)
class Pin:
    """A joint of a linkage.

    Attributes:
        name: Its name.
        kind: The joint element.
        parent, at: Body and point; "" is the ground.
        child, on: The same of the child.
        axis: Common to both bodies; None without.
        start: Coordinate at the start of the path, about.
        exchanged: The joint element from the child to the parent, where it is another one.
    """

    name: str
    kind: Any
    parent: str
    at: Point
    child: str
    on: Point = (0.0, 0.0, 0.0)
    axis: Point | None = (0.0, 0.0, 1.0)
    start: float | None = 0.0
    exchanged: Any = None


@dataclass(frozen=True)
class Linkage:
    """A linkage with its path.

    Attributes:
        name: In test output.
        pins: Its joints.
        swept: Name -> (start, end), radians, lengths or seconds.
        passes: Kinds of special points, in order.
        closed: Whether the path leads back to its start.
        followed: A coordinate that goes on where the driver turns back.
        cut: Name of the joint that is cut, otherwise.
        locked: Coordinate -> value.
        long: Whether lengths are swept.
        marks: Points of bodies that positions are compared by.
        prescribed: Joint -> what it follows, by the scene.
        parameter: Body -> parameter that is the x of its second joint.
    """

    name: str
    pins: tuple[Pin, ...]
    swept: tuple[str, float, float]
    passes: tuple[str, ...]
    closed: bool = True
    followed: str = ""
    cut: str = ""
    locked: Mapping[str, float] = field(default_factory=dict)
    long: bool = False
    prescribed: Mapping[str, Callable[[cd.Scene], Any]] = field(default_factory=dict)
    parameter: tuple[str, str] = ("", "")

    @property
    def bodies(self) -> list[str]:
        """Names, in the order of their joints."""
        return [*dict.fromkeys(pin.child for pin in self.pins if pin.child)]

    def scene(self, variant: Variant) -> cd.Scene:
        """The scene."""
        scene, size = cd.Scene(self.name, gravity=(0, 0, 0)), variant.length
        body = {
            name: scene.body(name, mass=1.0, inertia=(size**2,) * 3)
            for name in variant.ordered(self.bodies)
        }
        joint, parameter = self.parameter
        for pin in variant.ordered(self.pins):
            one, two = (body.get(name, scene) for name in (pin.parent, pin.child))
            parent, child = variant.point(one, pin.at), variant.point(two, pin.on)
            if pin.name == joint:
                length = scene.parameter(parameter, pin.on[0] * size)
                child = two.at(length, 0, 0)
            kind = pin.kind
            if variant.exchanged:
                parent, child, kind = child, parent, pin.exchanged or kind
            more: dict[str, Any] = {"cut": True} if variant.cut and pin.name == self.cut else {}
            if pin.name in self.prescribed:
                more["prescribed"] = self.sign(variant) * self.prescribed[pin.name](scene)
            scene.joint(pin.name, kind, parent, child, **more)
        return scene

    def sign(self, variant: Variant) -> int:
        """Of coordinates beside those of the plain scene."""
        return -1 if variant.exchanged else 1

    def unit(self, variant: Variant) -> float:
        """The unit of what is swept, with its sign."""
        size = variant.length if self.long else 1.0
        driven = self.swept[0] in {pin.name for pin in self.pins}
        return size * (self.sign(variant) if driven else 1)

    def begin(self, variant: Variant, model: cd.CompiledModel) -> dict[str, float]:
        """Coordinates to start from."""
        first, values = self.swept[1] * self.unit(variant), dict[str, float]()
        for pin in self.pins:
            if pin.name in model.coordinates and pin.start is not None:
                size = variant.length if isinstance(pin.kind, cd.Prismatic) else 1.0
                values[pin.name] = self.sign(variant) * pin.start * size
        return {**values, **({self.swept[0]: first} if self.swept[0] in values else {})}

    def follow(self, variant: Variant, model: cd.CompiledModel, **options: Any) -> Any:
        """The path."""
        name, start, end = self.swept
        unit, sign = self.unit(variant), self.sign(variant)
        way = {name: (start * unit, end * unit)}
        locked = {name: sign * value for name, value in self.locked.items()}
        begin = self.begin(variant, model)
        return model.continuation(
            **{"swept": way, "of": "positions", "locked": locked, "q": begin, **options}
        )

    def gaps(
        self, variant: Variant, model: cd.CompiledModel, q: np.ndarray, t: float, r: np.ndarray
    ) -> np.ndarray:
        """Distances of what joints keep together, and angles of their axes, by poses of bodies."""
        pose = {name: model.pose(name, q, t=t, r=r) for name in self.bodies}
        still = np.eye(4)
        still[:3, :3] = variant.rotation
        gaps = []
        for pin in self.pins:
            one, two = (pose.get(name, still) for name in (pin.parent, pin.child))
            on = pin.on
            if pin.name == self.parameter[0]:
                on = (model.parameters[self.parameter[1]] / variant.length, 0.0, 0.0)
            away = np.array([p[:3, :3] @ x for p, x in ((one, pin.at), (two, on))])
            away = away * variant.length + [one[:3, 3], two[:3, 3]]
            apart = (away[1] - away[0]) / variant.length
            if isinstance(pin.kind, cd.Prismatic):
                apart = np.cross(apart, one[:3, :3] @ pin.axis)
            gaps.append(float(np.abs(apart).max()))
            if pin.axis is not None:
                turn = np.cross(one[:3, :3] @ pin.axis, two[:3, :3] @ pin.axis)
                gaps.append(float(np.abs(turn).max()))
        return np.array(gaps)

    def marks(
        self, variant: Variant, model: cd.CompiledModel, q: np.ndarray, t: float, r: np.ndarray
    ) -> np.ndarray:
        """Places of bodies (n,) as the linkage sees them: origins and directions."""
        rows = []
        for name in sorted(self.bodies):
            pose = model.pose(name, q, t=t, r=r)
            rows += [pose[:3, 3] / variant.length @ variant.rotation]
            rows += [variant.rotation.T @ pose[:3, :3] @ (1, 0, 0)]
            rows += [variant.rotation.T @ pose[:3, :3] @ (0, 1, 0)]
        return np.concatenate(rows)


Z, TURN = cd.Revolute("z"), 2 * math.pi


def four_bar(
    sizes: tuple[float, float, float, float], start: Mapping[str, float]
) -> tuple[Pin, ...]:
    """Crank A, coupler, rocker D and the pin C between them."""
    crank, coupler, rocker, ground = sizes
    return (
        Pin("A", Z, "", (0, 0, 0), "crank", start=start["A"]),
        Pin("B", Z, "crank", (crank, 0, 0), "coupler", start=start["B"]),
        Pin("D", Z, "", (ground, 0, 0), "rocker", start=start["D"]),
        Pin("C", Z, "coupler", (coupler, 0, 0), "rocker", (rocker, 0, 0), start=start["C"]),
    )


ROCKER = four_bar((1, 2.5, 2, 3), {"A": 1.76, "B": -1.42, "D": 2.0, "C": 1.66})
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, -1, 0], [1, -1, 1], [0, -1, 1], [0, 0, 1]], float)
AXES = "yzxyzx"


def unit_vector(axis: str) -> Point:
    """Along a coordinate axis."""
    x, y, z = (float(axis == one) for one in "xyz")
    return x, y, z


def bricard() -> tuple[Pin, ...]:
    """R. Bricard (1927): six perpendicular hinges and five rods."""
    first, pins = 0.3, list[Pin]()
    second = -math.asin(math.sin(first) / (1 + math.sin(first)))
    for k in range(6):
        at = CORNERS[k] - CORNERS[k - 1] if k else np.zeros(3)
        x, y, z = (CORNERS[5] if k == 5 else np.zeros(3)).tolist()
        pins.append(
            Pin(
                f"J{k}", cd.Revolute(AXES[k]), f"rod{k - 1}" if k else "", tuple(at.tolist()),
                f"rod{k}" if k < 5 else "", (x, y, z), unit_vector(AXES[k]),
                second if k % 2 else first,
            )
        )  # fmt: skip
    return tuple(pins)


FOLDS, BRANCHES = ("fold", "fold"), ("branch point", "branch point", "event")
LINKAGES: dict[str, Linkage] = {
    one.name: one
    for one in (
        Linkage("rocker", ROCKER, ("D", 2.0, 4.0), FOLDS, followed="A", cut="B"),
        Linkage(
            "slider",
            (
                Pin("A", Z, "", (0, 0, 0), "crank", start=0.5),
                Pin("B", Z, "crank", (1, 0, 0), "rod", start=-0.5),
                Pin("C", Z, "rod", (3, 0, 0), "slider", start=0.0),
                Pin("s", cd.Prismatic("x"), "", (0, 0.4, 0), "slider", axis=(1, 0, 0), start=3.8),
            ),
            ("s", 3.8, 9.0), FOLDS, followed="A", cut="B", long=True,
        ),
        Linkage(
            "arms",
            (
                Pin("theta", Z, "", (0, 0, 0), "one", start=1.3),
                Pin("elbow", Z, "one", (1, 0, 0), "two", start=-2.6),
                Pin("pin", Z, "two", (1, 0, 0), "tip", start=1.3),
                Pin("s", cd.Prismatic("x"), "", (0, 0, 0), "tip", axis=(1, 0, 0), start=0.5),
            ),
            ("s", 0.5, -4.0), ("branch point", "fold", "branch point", "fold"),
            followed="theta", cut="elbow", long=True,
        ),
        Linkage(
            "parallelogram",
            four_bar((1, 2, 1, 2), {"A": 0.4, "B": -0.4, "D": 0.4, "C": 0.4}),
            ("A", 0.4, 0.4 + TURN), BRANCHES, closed=False, followed="D", cut="B",
        ),
        Linkage(
            "five",
            (
                Pin("left", Z, "", (0, 0, 0), "a", start=1.5),
                Pin("J2", Z, "a", (1, 0, 0), "b", start=-1.0),
                Pin("right", Z, "", (1, 0, 0), "c", start=1.2),
                Pin("J4", Z, "c", (1, 0, 0), "d", start=1.0),
                Pin("J5", Z, "b", (1.2, 0, 0), "d", (1.2, 0, 0), start=1.5),
            ),
            ("left", 1.5, 5.0), FOLDS, followed="J2", cut="J4", locked={"right": 1.2},
        ),
        Linkage("length", ROCKER, ("L", 2.0, 9.0), FOLDS, cut="B", followed="D",
                locked={"A": 0.5}, long=True, parameter=("C", "L")),
        Linkage("timed", ROCKER, ("t", 1.0, 3.0), FOLDS, cut="B", followed="A",
                prescribed={"D": lambda scene: 2 * cd.t}),
        Linkage("input", ROCKER, ("drive", 2.0, 5.0), FOLDS, cut="B", followed="A",
                prescribed={"D": lambda scene: scene.input("drive", 2.0)}),
        Linkage("bricard", bricard(), ("J0", 0.3, 7.0), FOLDS, followed="J1", cut="J2"),
        Linkage(
            "skew",
            (
                Pin("A", Z, "", (0, 0, 0), "crank", start=0.4),
                Pin("ball", cd.Spherical(), "crank", (1, 0, 0), "coupler", axis=None, start=None),
                Pin("D", cd.Revolute("y"), "", (2, 0.5, 0), "rocker", axis=(0, 1, 0), start=0.2),
                Pin("hooke", cd.Universal("x", "y"), "rocker", (0, 0, 1.6), "coupler",
                    (0, 0, 2.2), axis=None, start=None, exchanged=cd.Universal("y", "x")),
            ),
            ("D", 0.2, 4.0), FOLDS, followed="A", cut="hooke",
        ),
    )
}  # fmt: skip
