"""Joints of a body: one after the other, with massless bodies between several of them."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import field
from typing import Any

from ....elements.forces.drive import Drive
from ....elements.forces.joint_damper import JointDamper
from ....elements.forces.joint_spring import JointSpring
from ....elements.joints.fixed import Fixed
from ....elements.joints.free import Free
from ....elements.joints.joint import Joint as JointElement
from ....elements.joints.prismatic import Prismatic
from ....elements.joints.revolute import Revolute
from ....elements.joints.spherical import Spherical
from ....errors import ModelError
from ....records import dataclass
from ....spatial.numbers import UPRIGHT, Vector, about, rotated, to_quaternion, unit
from ...body import Body
from ...frame import Place
from ...scene import SceneRecord
from ..document import Element
from ..pose import HERE, Pose, written
from .compiler import Compiler, chosen

KINDS = ("hinge", "slide", "ball", "free")
# stiffness, armature and the like belong to one coordinate here
SINGLE = frozenset({"hinge", "slide"})


@dataclass(frozen=True)
class Hinge:
    """A joint of the file, read.

    Attributes:
        name: Its own name or a made one.
        kind: Of ``KINDS``.
        element: The element of the file with its defaults.
        anchor: Where it stands, in axes of the body (3) [m].
        axis: Its direction in axes of the body (3).
        ref: Its coordinate in the drawn configuration [rad or m].
        unit: Radians or meters per number of the file.
    """

    name: str
    kind: str
    element: Element
    anchor: Vector
    axis: Vector
    ref: float
    unit: float

    def angle(self, name: str) -> float:
        """An attribute that is measured like the coordinate."""
        return self.element.number(name, "0") * self.unit

    @property
    def single(self) -> bool:
        """It has one coordinate."""
        return self.kind in SINGLE

    @property
    def joint_element(self) -> JointElement:
        """The joint element."""
        axis = tuple(int(x) if x in (0.0, 1.0, -1.0) else x for x in self.axis)
        if self.kind == "hinge":
            return Revolute(axis)
        if self.kind == "slide":
            return Prismatic(axis)
        return Spherical() if self.kind == "ball" else Free()

    @property
    def before(self) -> Pose:
        """The frame on the inner side where the coordinate is 0, in axes of the body."""
        if self.kind == "slide":
            x, y, z = (a - self.ref * b for a, b in zip(self.anchor, self.axis, strict=True))
            return Pose(UPRIGHT, (x, y, z))
        return Pose(about(self.axis, -self.ref) if self.ref else UPRIGHT, self.anchor)


def read(element: Element, name: str, compiler: Compiler, around: Pose) -> Hinge:
    """A <joint> or <freejoint>.

    Args:
        around: Pose of the frames around it, in axes of the body.

    Raises:
        ModelError: an unknown type or an axis without direction.
    """
    free = element.raw.tag == "freejoint"
    kind = "free" if free else chosen(element, "type", KINDS, "hinge")
    if kind == "free":
        return Hinge(name, kind, element, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0), 0.0, 1.0)
    anchor = around.point(element.numbers("pos", 3, "0 0 0"))
    axis = element.numbers("axis", 3, "0 0 1")
    if not any(abs(a) > 1e-14 for a in axis):
        raise ModelError(f"{element.where}: its axis has no direction; give such as '0 0 1'")
    factor = 1.0 if kind == "slide" else compiler.degree
    ref = element.number("ref", "0") * factor if kind in SINGLE else 0.0
    return Hinge(name, kind, element, anchor, rotated(around.rotation, unit(axis)), ref, factor)


@dataclass(frozen=True)
class Chain:
    """Makes the joints of bodies in a model.

    Attributes:
        scene: The model.
        compiler: Settings of the file.
        couples: Joint -> what it follows, from <equality>.
        place: A name that is not taken yet, of bodies and frames.
        origin: Remembers where an item stands in the file.
        ignored: Joint -> attribute that does not act on its kind.
    """

    scene: SceneRecord
    compiler: Compiler
    couples: dict[str, tuple[Any, ...]]
    place: Callable[[str], str]
    origin: Callable[[str, str, Element], None]
    ignored: list[str] = field(default_factory=list)

    def join(self, parent: Body, pose: Pose, body: Body, hinges: list[Hinge], fixed: str) -> None:
        """Join a body to its parent.

        Args:
            pose: Of the body in axes of the parent, all joints as drawn.
            hinges: From the inside to the outside; none: it is fixed by a joint named ``fixed``.
        """
        if not hinges:
            self.scene.joint(fixed, Fixed(), self._frame(parent, pose), body)
            return
        inner, start = parent, pose
        for hinge in hinges:
            last = hinge is hinges[-1]
            outer = body if last else self.scene.body(self.place(f"{body.name}.{hinge.name}"))
            self._joint(inner, start, outer, hinge)
            inner, start = outer, HERE

    def _frame(self, body: Body, pose: Pose) -> Place:
        """A frame on a body; the body itself where it is its own."""
        turn = written(pose.rotation)
        if turn is None and not any(pose.position):
            return body
        return body.at(*pose.position, rotation=turn)

    def _joint(self, inner: Body, start: Pose, outer: Body, hinge: Hinge) -> None:
        anchor = Pose(UPRIGHT, hinge.anchor)
        q0: Any = hinge.ref if hinge.ref else None
        if hinge.kind == "free":
            # its coordinates say where the body is on the ground
            q0 = (*to_quaternion(start.rotation), *start.position)
            start = HERE
        couple = self.couples.get(hinge.name)
        joint = self.scene.joint(
            hinge.name,
            hinge.joint_element,
            self._frame(inner, start.then(hinge.before)),
            self._frame(outer, anchor),
            q0=None if couple else q0,
            limits=self._limits(hinge),
            couple=couple,
        )
        self.origin("joint", hinge.name, hinge.element)
        friction = hinge.element.number("frictionloss", "0")
        if friction:
            self.scene.joints[joint.name] = dataclasses.replace(joint, friction=friction)
        self._forces(hinge)

    def _limits(self, hinge: Hinge) -> tuple[float, float] | None:
        element = hinge.element
        if hinge.kind == "free" or element.raw.get("range") is None:
            return None
        word = chosen(element, "limited", ("auto", "true", "false"), "auto")
        if word == "false" or (word == "auto" and not self.compiler.limited):
            return None
        low, high = (bound * hinge.unit for bound in element.numbers("range", 2))
        return (low, high) if hinge.single else None

    def _forces(self, hinge: Hinge) -> None:
        """Spring, damper and rotor of a joint."""
        element, name, scene = hinge.element, hinge.name, self.scene
        damping, stiffness = element.number("damping", "0"), element.number("stiffness", "0")
        armature = element.number("armature", "0")
        if damping:
            scene.force(f"{name}.damping", JointDamper(name, damping))
            self.origin("force", f"{name}.damping", element)
        for key, value in (("stiffness", stiffness), ("armature", armature)):
            if value and not hinge.single:
                self.ignored.append(f"{key} of {hinge.kind} joint {name}")
        if stiffness and hinge.single:
            reference = hinge.angle("springref")
            scene.force(f"{name}.spring", JointSpring(name, stiffness, rest=reference))
            self.origin("force", f"{name}.spring", element)
        if armature and hinge.single:
            scene.force(f"{name}.rotor", Drive(name, armature))
            self.origin("force", f"{name}.rotor", element)
