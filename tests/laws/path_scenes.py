"""Scenes whose equilibria are followed, each in other units, orders and directions too."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

import cardan as cd
from mechanisms.superelements import beams

RISE = 0.5


@dataclass(frozen=True)
class Variant:
    """How a scene is written.

    Attributes:
        length, force: Units of length and force in one meter and one newton.
        turned: Whether bodies, forces and beams are declared in the opposite order.
        exchanged: Whether beams run from their ends to their starts.
        coordinates: For compile.
    """

    length: float = 1.0
    force: float = 1.0
    turned: bool = False
    exchanged: bool = False
    coordinates: str = "relative"

    @property
    def moment(self) -> float:
        """The unit of moments, and of inertia."""
        return self.force * self.length

    @property
    def stiffness(self) -> float:
        """The unit of force by length, and of masses."""
        return self.force / self.length

    def ordered(self, *items: Any) -> tuple[Any, ...]:
        """Items as they are declared."""
        return items[::-1] if self.turned else items

    def bodies(self, scene: cd.Scene, *names: str) -> dict[str, Any]:
        """Bodies of mass and moments of inertia 1, by name."""
        inertia = (self.moment,) * 3
        return {
            name: scene.body(name, mass=self.stiffness, inertia=inertia)
            for name in self.ordered(*names)
        }


@dataclass(frozen=True)
class PathScene:
    """A scene with its path.

    Attributes:
        name: In test output.
        build: Makes the scene.
        swept: Parameter -> end in N (times its unit), or coordinate -> end in m.
        along: Coordinate or output that paths are compared by, and the value of its event.
        passes: Kinds of special points, in order.
        bounds: As ``continuation`` takes them, of meters.
        unit: Name of the unit of what is swept: ``"force"``, ``"length"``, ``"moment"``.
        size: Name of the unit of what paths are compared by; "" of angles.
        locked: Whether a coordinate is swept.
        options: For compile.
        flexible: Whether there are beams.
        coordinates: Other coordinates that the scene can be compiled in.
    """

    name: str
    build: Callable[[Variant], cd.Scene]
    swept: tuple[str, float, float]
    along: tuple[str, float]
    passes: tuple[str, ...]
    bounds: Mapping[str, float] = field(default_factory=dict)
    unit: str = "force"
    size: str = ""
    locked: bool = False
    options: Mapping[str, Any] = field(default_factory=dict)
    flexible: bool = False
    coordinates: tuple[str, ...] = ("absolute",)

    def model(self, variant: Variant) -> cd.CompiledModel:
        """The compiled model."""
        kind = {} if self.flexible else {"coordinates": variant.coordinates}
        return cd.compile(self.build(variant), **kind, **self.options)

    def measure(self, variant: Variant) -> float:
        """What the quantity that paths are compared by is divided by."""
        return float(getattr(variant, self.size)) if self.size else 1.0

    def load(self, variant: Variant) -> float:
        """What the load is divided by."""
        return float(getattr(variant, self.unit))

    def follow(self, variant: Variant, model: Any = None, **options: Any) -> Any:
        """The path."""
        model, (name, start, end) = model or self.model(variant), self.swept
        load, size = self.load(variant), self.measure(variant)
        span = (start * load, end * load)
        swept = {"locked": {name: span}} if self.locked else {"swept": {name: span}}
        key, value = self.along
        bounds = {name: (-most * size, most * size) for name, most in self.bounds.items()}
        events = {key: value * size}
        return model.continuation(**{**swept, "bounds": bounds, "events": events, **options})


def bars(scene: cd.Scene, apex: Any, variant: Variant, span: float = 1.0) -> None:
    """Two bars of EA = 1 from the ground to an apex."""
    length = float(np.hypot(span, RISE))
    for name, x in variant.ordered(("left", -span), ("right", span)):
        bar = cd.SpringDamper(
            scene.ground.at(x * variant.length, 0, 0), apex,
            stiffness=variant.stiffness / length, rest_length=length * variant.length,
        )  # fmt: skip
        scene.force(name, bar)


def truss(variant: Variant, stop: bool = False, lag: bool = False, tuned: bool = False) -> cd.Scene:
    """Two bars that snap through; with a stop below, or a strut that gives way in time.

    Args:
        variant, stop, lag: How it is written, and with what.
        tuned: Whether stiffness and damping of the strut are parameters.
    """
    scene = cd.Scene("truss", gravity=(0, 0, 0))
    load, (apex,) = scene.parameter("P", 0.0), variant.bodies(scene, "apex").values()
    foot = scene.ground.at(0, 0, RISE * variant.length)
    scene.joint("up", cd.Prismatic("z"), foot, apex)
    bars(scene, apex, variant)
    scene.force("load", cd.Force(apex, (0, 0, -1 * load)))
    if stop:
        scene.force("floor", cd.Stop("up", lower=-0.4 * variant.length, restitution=0.0))
    if lag:
        of: list[Any] = [variant.stiffness] * 2
        if tuned:
            of = [scene.parameter(name, variant.stiffness) for name in ("strut_k", "strut_c")]
        strut = cd.Maxwell(
            scene.ground.at(0, 0, 2 * variant.length), apex, *of, rest_length=1.5 * variant.length
        )
        scene.force("strut", strut)
    return scene


def swaying(variant: Variant) -> cd.Scene:
    """Two steep bars whose apex sways before it snaps through."""
    scene = cd.Scene("swaying", gravity=(0, 0, 0))
    load, body = scene.parameter("P", 0.0), variant.bodies(scene, "slide", "apex")
    foot = scene.ground.at(0, 0, RISE * variant.length)
    scene.joint("aside", cd.Prismatic("x"), foot, body["slide"])
    scene.joint("up", cd.Prismatic("z"), body["slide"], body["apex"])
    bars(scene, body["apex"], variant, RISE / 3)
    scene.force("load", cd.Force(body["apex"], (0, 0, -1 * load)))
    return scene


def links(variant: Variant) -> cd.Scene:
    """Two links in line, closed by a slide, with a torsion spring between them."""
    scene = cd.Scene("links", gravity=(0, 0, 0))
    load, body = scene.parameter("P", 0.0), variant.bodies(scene, "one", "two", "end")
    tip = variant.length
    scene.joint("theta", cd.Revolute("z"), scene.ground, body["one"])
    scene.joint("middle", cd.Revolute("z"), body["one"].at(tip, 0, 0), body["two"])
    scene.joint("pin", cd.Revolute("z"), body["two"].at(tip, 0, 0), body["end"])
    scene.joint("slide", cd.Prismatic("x"), scene.ground, body["end"], q0=2 * tip)
    scene.force("spring", cd.JointSpring("middle", stiffness=variant.moment))
    scene.force("load", cd.Force(body["end"], (-1 * load, 0, 0)))
    return scene


def pendulum(variant: Variant) -> cd.Scene:
    """Three links upright with springs between them, under their weight."""
    scene = cd.Scene("pendulum", gravity=(0, 0, -1))
    last, size, names = scene.ground, variant.length, ("low", "middle", "high")
    mass, inertia = variant.stiffness, (variant.moment,) * 3
    body = {
        name: scene.body(name, mass=mass, com=(0, 0, size / 2), inertia=inertia)
        for name in variant.ordered(*names)
    }
    for name in names:
        scene.joint(f"{name}_hinge", cd.Revolute("y"), last, body[name])
        last = body[name].at(0, 0, size)
    for k, name in variant.ordered(*enumerate(names)):
        spring = cd.JointSpring(f"{name}_hinge", stiffness=(3 - k) * variant.moment)
        scene.force(f"{name}_spring", spring)
    return scene


def follower(variant: Variant) -> cd.Scene:
    """Ziegler's column: two links with springs and dampers, pushed along the second one."""
    scene = cd.Scene("follower", gravity=(0, 0, 0))
    load, size, body = scene.parameter("P", 0.0), variant.length, dict[str, Any]()
    for name, mass in variant.ordered(("lower", 2.0), ("upper", 1.0)):
        given = mass * variant.stiffness
        body[name] = scene.body(name, mass=given, com=(0, 0, size), inertia=(0, 0, 0))
    scene.joint("one", cd.Revolute("y"), scene.ground, body["lower"])
    scene.joint("two", cd.Revolute("y"), body["lower"].at(0, 0, size), body["upper"])
    for name in variant.ordered("one", "two"):
        scene.force(f"spring_{name}", cd.JointSpring(name, stiffness=variant.moment))
        scene.force(f"damper_{name}", cd.JointDamper(name, damping=0.1 * variant.moment))
    upper = body["upper"]
    scene.force("load", cd.Force(upper.at(0, 0, size), (0, 0, -1 * load), in_=upper))
    return scene


def frame(variant: Variant) -> cd.Scene:
    """A column and a beam with a stiff corner, hinged at their feet, pressed beside the corner."""
    scene, size = cd.Scene("frame", gravity=(0, 0, 0)), variant.length
    EA, EI = 1e4 * variant.force, variant.moment * variant.length
    section = cd.section.general(
        EA=EA, GA=EA, GJ=EI, EI=EI, rhoA=variant.stiffness / size, rhoI=1e-3 * variant.moment / size
    )
    places = {"foot": (0, 0, 0), "corner": (0, 0, size), "arm": (0.2 * size, 0, size)}
    places["end"] = (size, 0, size)
    small = {"mass": 0.01 * variant.stiffness, "inertia": (1e-3 * variant.moment,) * 3}
    corner = scene.body("corner", pose=places["corner"], **small)
    arm = scene.body("arm", pose=places["arm"], **small)
    foot = scene.body("foot", pose=places["foot"], **small)
    end = scene.body("end", pose=places["end"], **small)
    scene.joint("hinge", cd.Revolute("y"), scene.ground, foot)
    scene.joint("support", cd.Revolute("y"), scene.ground.at(*places["end"]), end)
    for name, body in (("one", corner), ("two", arm)):
        scene.joint(name, cd.Planar("y"), scene.ground, body)
    for name, one, two, count in variant.ordered(
        ("column", foot, corner, 4), ("short", corner, arm, 2), ("long", arm, end, 4)
    ):
        one, two = (two, one) if variant.exchanged else (one, two)
        scene.beam(name, one, two, section, elements=count, up="y")
    scene.force("load", cd.Force(arm, (0, 0, -1 * scene.parameter("P", 0.0))))
    scene.output("v", size - arm.position()[2], unit="m")
    return scene


def boom(variant: Variant) -> cd.Scene:
    """A superelement on a hinge with a spring, pressed along its axis."""
    scene = cd.Scene("boom", gravity=(0, 0, 0))
    element = scene.superelement("boom", beams(), frame="start")
    scene.joint("hinge", cd.Revolute("y"), scene.ground, element.at("start"))
    scene.force("spring", cd.JointSpring("hinge", stiffness=5.0))
    scene.force("load", cd.Force(element.at("end"), (-1 * scene.parameter("P", 0.0), 0, 0)))
    return scene


FOLDS = ("fold", "event", "fold")
SCENES: dict[str, PathScene] = {
    scene.name: scene
    for scene in (
        PathScene("truss", truss, ("P", 0.0, 0.2), ("up", -0.3), FOLDS, size="length"),
        PathScene(
            "swaying", swaying, ("P", 0.0, 2.0), ("up", -0.5),
            ("branch point", "fold", "branch point", "event", "branch point", "fold",
             "branch point"), size="length",
        ),
        PathScene("links", links, ("P", 0.0, 4.0), ("theta", 0.5), ("branch point",)),
        PathScene("stop", lambda v: truss(v, stop=True), ("P", 0.0, 1.0), ("up", -0.3),
                  ("fold", "event", "event"), size="length"),
        PathScene("lag", lambda v: truss(v, lag=True), ("P", 0.0, 0.2), ("up", -0.3), FOLDS,
                  size="length"),
        PathScene("pendulum", pendulum, ("gravity.z", 0.0, -5.0), ("low_hinge", 0.5),
                  ("branch point",) * 3, unit="length"),
        PathScene("follower", follower, ("P", 0.0, 3.0), ("one", 0.5), ("Hopf point",)),
        PathScene("prescribed", truss, ("up", 0.0, -1.0), ("up", -0.3), ("event",),
                  unit="length", size="length", locked=True),
        PathScene("frame", frame, ("P", 0.0, 30.0), ("v", 0.3),
                  ("event", "fold", "fold"), size="length",
                  options={"plane": "y"}, flexible=True, coordinates=()),
        PathScene("boom", boom, ("P", 0.0, 30.0), ("hinge", 0.3), ("branch point",),
                  flexible=True, coordinates=()),
    )
}  # fmt: skip
