"""The model: what the user says about a scene, kept as written."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ..arguments import checked
from ..elements.forces.force import ForceElement, refuse_several
from ..elements.joints.joint import Joint as JointElement
from ..elements.quantity import Direction, Rows, Value
from ..errors import ModelError, brief, counted
from ..notebooks import html
from . import checks
from .beam import Beam, Cable
from .beam_arguments import ELEMENT, INERTIA, add_beam, add_cable
from .body import Body, read_pose, shapes_of, tensor
from .checks import triple
from .connections import (
    Force,
    Joint,
    by_names,
    check_cut,
    check_start,
    couple_of,
    element_of,
    limits_of,
)
from .frame import Frame, Located, Place, new_frame_of
from .include import Included, include
from .parameters import Constraint, Declared, Output, Placeholder
from .prescribed_joints import chain, several
from .shape import Shape
from .terms import Vocabulary

if TYPE_CHECKING:
    from ..elements.centerlines import Centerline
    from ..elements.material import Material
    from ..elements.sections import Section
    from .superelement import PlacedSuperelement


class SceneRecord(Vocabulary):
    """A scene: bodies, joints, beams, forces, parameters, inputs and outputs.

    Args:
        name: Its name.
        gravity: Acceleration of free fall in ground axes (3) [m/s^2].

    Attributes:
        ground: The body that does not move.
        bodies, joints, beams, cables, superelements, forces: By name, in the order of declaration.
        frames: By name; those made by ``at`` of bodies and frames.
        nodes: By name; start, end and :meth:`Beam.at` of the beams, all nodes of cables, interfaces
            of superelements. Where an end is joined to a frame, that frame.
        parameters, inputs, outputs, constraints: By name.
        original: The scene that this one was copied from for a build, else itself.
        of_robot: Read from a file that describes a robot: impossible numbers are warned of there.
        notes: What a file says that this model does not act on.
        snaps: Numbers of a file that were replaced by exact ones.
        values: Numbers by dotted name that replace those written, such as ``upper.mass``.
        settings: How its file wants it simulated: arguments for ``simulate(**scene.settings)``.
        origins: Place in a file by kind and name of an item, see :mod:`.origins`.
    """

    def __init__(self, name: str, gravity: Sequence[Value] = (0, 0, -9.81)) -> None:
        self.name = checks.name("model", name)
        self.original = self
        self.gravity = triple(gravity, "gravity")
        self.ground = Body(self, "ground", 0, (0, 0, 0), (0,) * 6, ((0, 0, 0), None))
        self.bodies: dict[str, Body] = {}
        self.joints: dict[str, Joint] = {}
        self.beams: dict[str, Beam] = {}
        self.cables: dict[str, Cable] = {}
        self.superelements: dict[str, PlacedSuperelement] = {}
        self.nodes: dict[str, Place] = {}
        self.forces: dict[str, Force] = {}
        self.frames: dict[str, Frame] = {}
        self.parameters: dict[str, Declared] = {}
        self.inputs: dict[str, Declared] = {}
        self.outputs: dict[str, Output] = {}
        self.constraints: dict[str, Constraint] = {}
        self.atoms: dict[str, Placeholder] = {}
        self.of_robot = False
        self.notes: list[str] = []
        self.snaps: list[str] = []
        self.values: dict[str, float] = {}
        self.settings: dict[str, Any] = {}
        self.origins: dict[tuple[str, str], str] = {}

    _repr_html_ = html

    def __repr__(self) -> str:
        bodies = counted(len(self.bodies), "body", "bodies")
        return f"Scene({self.name!r}, {bodies}, {counted(len(self.joints), 'joint')})"

    # bodies and frames

    def body(
        self,
        name: str,
        mass: Value | None = None,
        com: Sequence[Value] = (0, 0, 0),
        inertia: Rows | None = None,
        pose: Rows | None = None,
        shape: Shape | Iterable[Shape] | None = None,
    ) -> Body:
        """Add a rigid body.

        Args:
            name: Its name.
            mass: [kg]; left out: massless.
            com: Center of mass in body axes (3) [m].
            inertia: About the center of mass in body axes [kg m^2]: 3x3 with I_xy = -∫xy dm, three
                principal values, or a dict of xx, yy, zz, xy, yz, xz; left out: a point mass.
            pose: Place in the reference configuration in ground axes: (x, y, z), (position,
                rotation) or a 4x4 matrix.
            shape: What to draw; by default something is made of com and inertia.

        Returns:
            The body; it stands for its own origin frame.

        Raises:
            ModelError: the name is taken, or a number cannot be what it says.
        """
        self.new_place("body", name)
        center = triple(com, f"body '{name}': com")
        entries = tensor(inertia, name)
        checks.mass(name, mass, entries, self.of_robot)
        shapes = shapes_of(name, shape)
        if mass is not None:
            checks.quantity(f"body '{name}': mass", mass)
        for entry in entries:
            checks.quantity(f"body '{name}': inertia", entry)
        body = Body(self, name, 0 if mass is None else mass, center, entries, None, shapes)
        body = dataclasses.replace(body, pose=read_pose(pose, name))
        self.bodies[name] = body
        return body

    def add_frame(
        self, base: Located, position: Sequence[Value], rotation: Rows | None, name: str | None
    ) -> Frame:
        """The work of ``at`` of bodies and frames."""
        return new_frame_of(self, base, position, rotation, name)

    def new_place(self, what: str, name: str) -> None:
        """A usable name of a body or frame that is not taken.

        Raises:
            ModelError: it is taken or not usable.
        """
        checks.new(what, name, self.bodies)
        if name in self.frames or name in self.nodes or name == "ground":
            taken = "node of a beam" if name in self.nodes else "frame"
            raise ModelError(f"{what} '{name}': the name is taken by a {taken}")

    def place(self, who: str, place: Place | str, role: str = "frame") -> Place:
        """A frame or body of this model.

        Raises:
            ModelError: it belongs to another model or does not exist.
        """
        if isinstance(place, Located):
            if place.body.model is not self.original:
                raise ModelError(
                    f"{who}: {role} '{place.name}' belongs to model '{place.body.model.name}', "
                    f"not to '{self.name}'; include that model"
                )
            return place
        if isinstance(place, str) and place == "ground":
            return self.ground
        located = None
        for named in (self.bodies, self.frames, self.nodes) if isinstance(place, str) else ():
            located = located or named.get(str(place))
        if located is None:
            names = ["ground", *self.bodies, *self.nodes, *(self.beams if "beam" in role else ())]
            raise checks.no_place(who, role, place, names)
        return located

    # joints and forces

    def joint(
        self,
        name: str,
        kind: JointElement | type[JointElement],
        parent: Place | str,
        child: Place | str,
        prescribed: Rows | None = None,
        cut: bool = False,
        q0: float | Sequence[float] | None = None,
        u0: float | Sequence[float] | None = None,
        limits: Mapping[str, float] | Sequence[float] | None = None,
        at: Sequence[Value] | None = None,
        axis: Direction | None = None,
        couple: tuple[Value, ...] | None = None,
    ) -> Joint:
        """Join two bodies.

        Args:
            name: Its name.
            kind: A joint element such as ``Revolute("y")``; its axis is given in the parent frame.
            parent, child: Frames, bodies (their origin frames) or their names; they coincide at
                q = 0 unless the kind says otherwise (:class:`Distance`, :class:`Wheel`,
                :class:`RollingDisk`, :class:`PointOnCurve`). Where the child has ``pose=`` and the
                parent is a body, the frame on the parent follows from the poses. The child may be
                the one nearer to the ground.
            prescribed: Its coordinate as an expression in ``cardan.t`` or an input. One for each
                coordinate of a joint with several: that becomes a chain of joints
                ``<name>.<coordinate>``; None in it moves freely.
            cut: Ask for this joint to close a loop; without it loops are cut where that
                leaves the fewest speeds.
            q0, u0: Initial values.
            limits: (lower, upper), or a mapping with lower, upper, speed, effort.
            at: Place of the joint in ground axes at the reference configuration; its frames are
                then parallel to the ground axes. A child without ``pose=`` has its origin there.
            axis: Direction of the kind's axis; in ground axes where ``at`` is given.
            couple: ``(leader, ratio[, offset])``: the coordinate follows that of another joint.

        Raises:
            ModelError: unknown or foreign bodies, wrong lengths or a name that is taken.
        """
        checks.new("joint", name, self.joints)
        element = element_of(name, kind, axis)
        if several(prescribed):
            further = {"q0": q0, "u0": u0, "limits": limits, "at": at, "couple": couple}
            return chain(
                self, name, element, (parent, child), prescribed, further | {"cut": cut or None}
            )
        who = f"joint '{name}' ({element.kind})"
        if prescribed is not None:
            checks.quantity(f"{who}: prescribed", prescribed)
        inboard, outboard = self.place(who, parent, "parent"), self.place(who, child, "child body")
        if inboard.body is outboard.body:
            raise ModelError(f"{who}: parent and child are the same body '{inboard.body.name}'")
        follows = couple_of(who, element, couple)
        if prescribed is not None and follows is not None:
            raise ModelError(
                f"{who}: it cannot follow prescribed= and another joint; leave out one"
            )
        check_cut(who, cut, prescribed is not None or couple is not None)
        if at is not None and (isinstance(inboard, Frame) or isinstance(outboard, Frame)):
            raise ModelError(f"{who}: at= needs bodies, not frames: it makes the frames itself")
        joint = Joint(
            name,
            element,
            inboard,
            outboard,
            prescribed,
            checks.initial(who, "q0", q0, len(element.coordinates), element.quaternion),
            checks.initial(who, "u0", u0, len(element.speeds)),
            limits_of(who, limits),
            None if at is None else triple(at, f"{who}: at"),
            follows,
            cut=cut,
        )
        check_start(joint)
        self.joints[name] = joint
        return joint

    def force(self, name: str, element: ForceElement) -> Force:
        """Add a force element such as ``Force``, ``SpringDamper`` or ``JointForce``.

        Raises:
            ModelError: the name is taken.
        """
        checks.new("force", name, self.forces)
        if not isinstance(element, ForceElement):
            raise ModelError(f"force '{name}': {brief(element)} is not a force element")
        beam = getattr(element, "beam", None)
        if isinstance(beam, Beam) and beam.model is not self:
            raise ModelError(
                f"force '{name}': beam '{beam.name}' belongs to model '{beam.model.name}', not to "
                f"'{self.name}'"
            )
        force = Force(name, by_names(element))
        joint = self.joints.get(getattr(force.element, "joint", ""))
        if joint is not None:
            refuse_several(name, force.element, joint.kind.coordinates)
        self.forces[name] = force
        return force

    def beam(
        self,
        name: str,
        start: Place | str | Sequence[Value],
        end: Place | str | Sequence[Value],
        section: Section | None = None,
        material: Material | None = None,
        elements: int = 8,
        up: Direction | None = None,
        line: Centerline | None = None,
        element: str = ELEMENT,
        inertia: str = INERTIA,
        release_start: str | Sequence[str] = (),
        release_end: str | Sequence[str] = (),
        temperature: Value = 0,
        prestrain: Mapping[str, Value] | None = None,
        base: Body | str | None = None,
    ) -> Beam:
        """Add a beam: slender, elastic, of one section, in displacements of any size.

        Section axes: e1 along the beam, e3 as near to ``up`` as can be, e2 = e3 x e1. Beams
        live in nodes, rigid bodies in joint coordinates. See ``docs/flexible.md``.

        Args:
            name: Its name.
            start, end: A frame, body or name that the end is clamped to, or a free end: three
                numbers in axes of ``base`` at the reference configuration.
            section: One of :mod:`cardan.section`, such as ``cd.section.tube(0.05, 0.04)``.
            material: ``cd.material(E=, nu=, rho=, damping=, expansion=)``; not needed by
                ``cd.section.general``.
            elements: Number of finite elements.
            up: Direction of e3 in axes of ``base``, or its part across the beam. Without it e3
                starts upward (of an upright beam e2 along y) and goes on without twist.
            line: ``cd.arc(...)`` or ``cd.spline(points)`` from start to end; straight without. The
                beam is without stress there.
            element: Kind of finite element: ``"hellinger_reissner"``, the same ``..._loaded``,
                ``"helicoidal"``, ``"classical"`` or ``"classical_plain"``.
            inertia: ``"linked"``, that of the motion between nodes, or ``"lumped"`` at them.
            release_start, release_end: What the clamp does not hold there: ``"x" "y" "z"``
                displacements along and ``"rx" "ry" "rz"`` rotations about the section axes, such as
                ``"ry"`` for a hinge. The coordinates are those of a joint ``<name>.start`` or
                ``<name>.end``.
            temperature: Rise against the reference configuration [K].
            prestrain: What the beam has without stress beyond the reference configuration: any of
                twist, curvature2, curvature3 [1/m], stretch, shear2, shear3.
            base: Body in whose axes points and directions of the beam are told; None: the ground.

        Returns:
            The beam; :meth:`Beam.at`, ``start`` and ``end`` are frames for joints and forces.

        Raises:
            ModelError: unknown or foreign frames, numbers no beam has, or a name that is taken.

        Source: J. C. Simo and L. Vu-Quoc, A three-dimensional finite-strain rod model, 1986.
        """
        ends, stuff = ((start, release_start), (end, release_end)), (section, material)
        kinds = (element, inertia)
        return add_beam(
            self, name, ends, stuff, elements, up, line, kinds, temperature, prestrain, base
        )

    @checked
    def cable(
        self,
        name: str,
        start: Place | str | Sequence[Value],
        end: Place | str | Sequence[Value],
        EA: Value,
        rhoA: Value = 0,
        length: Value | None = None,
        tension: float | None = None,
        damping: Value = 0,
        elements: int = 1,
        base: Body | str | None = None,
        compression: bool = False,
    ) -> Cable:
        """Add a cable: straight elastic pieces that pull and do not push, with mass in its nodes.

        Args:
            name: Its name.
            start, end: A frame, body or name, whose origin holds the end without moments, or a free
                end: three numbers in axes of ``base`` at the reference configuration.
            EA, rhoA: Stiffness [N] and mass per length [kg/m] of the section.
            length: Without load [m]; longer than the distance of the ends it sags.
            tension: In the reference configuration [N], where ``length`` is not given.
            damping: Tension of a rate of the strain is EA times this time [s].
            elements: Number of pieces of equal length.
            base: Body in whose axes free ends are told; None: the ground.
            compression: True for a bar, which pushes too; elements have hinges between them.

        Raises:
            ModelError: unknown or foreign frames, numbers no cable has, or a name that is taken.

        Source: Irvine, Cable Structures (1981), chapter 1.
        """
        numbers, unloaded = {"EA": EA, "rhoA": rhoA, "damping": damping}, (length, tension)
        return add_cable(self, name, (start, end), numbers, unloaded, elements, base, compression)

    @checked
    def include(self, other: SceneRecord, prefix: str, at: Place | str | None = None) -> Included:
        """Add a copy of another model as a subsystem; its ground becomes a body of this one.

        Args:
            other: The model; later changes of it do not show here. Its gravity is ignored.
            prefix: Put before all its names: ``left`` makes ``left.upper``; a prefix that ends
                in a sign, such as ``left_``, is used as it is.
            at: Frame (or body) that its ground coincides with; the ground by default.

        Returns:
            The copies of its bodies, frames, joints and symbols by their old names.

        Raises:
            ModelError: a name is taken.
        """
        place = self.ground if at is None else self.place(f"include '{prefix}'", at)
        return include(self, other, checks.name("prefix", prefix), place)
