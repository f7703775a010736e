"""Bodies, frames and joints of the system, in the order of the spanning tree."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ..elements.joints.fixed import Fixed
from ..elements.joints.joint import Joint as JointElement
from ..errors import TopologyError
from ..ir.graph import ZERO
from ..ir.matrix import Matrix
from ..scene.body import Body as UserBody
from ..scene.checks import is_number
from ..scene.connections import Joint as UserJoint
from ..scene.frame import Frame as UserFrame
from ..scene.frame import Place
from ..scene.scene import SceneRecord
from . import prescribed_motion
from .beams.beams import Beams
from .beams.nodal_scene import BeamNodes
from .conversion import IDENTITY, ORIGIN, Converter, symmetric
from .loops.circuits import circuit
from .loops.coincidence import check_coincidence
from .placement import HERE, Placement, moved_mass
from .reference_configuration import Reference
from .rigid_body import ENTRIES, Rigid
from .system import GROUND, Closure, Cut, Frame, Joint, Nodes, Part
from .tree import Branch, Closing


class Assembly:
    """Grows the lists of the system branch by branch.

    Args:
        model: The scene, rotors of drives included.
        convert: Makes expressions of what is written.
        rotors: Joint of a rotor -> the joint whose place it shares.
        nodes: Nodes of beams, which are bodies of the scene.
    """

    def __init__(
        self, model: SceneRecord, convert: Converter, rotors: Mapping[str, str], nodes: BeamNodes
    ) -> None:
        self.model = model
        self.graph = convert.graph
        self.convert = convert
        self.rotors = rotors
        self.bodies: list[Rigid] = []
        self.frames: list[Frame] = []
        self.joints: list[Joint] = []
        self.fixed: list[str] = []
        self.cuts: list[Cut] = []
        self.numbers: dict[Any, int] = {}
        named = (frame.name for frame in model.frames.values() if frame.named)
        self.written = {"ground", *model.bodies, *named}
        self.joint_number: dict[str, int] = {}
        self.nq = self.nu = 0
        self.unchecked: list[tuple[str, Nodes]] = []
        self.home: dict[UserBody, tuple[int, Placement]] = {}
        # mass, com and inertia as written, in axes of the user's body
        self.weights: dict[UserBody, dict[str, tuple[int, int, Nodes]]] = {}
        self.local: dict[UserFrame, Placement] = {}
        self.parent_side: dict[str, Placement] = {}
        self.data: dict[str, dict[str, tuple[int, int, Nodes]]] = {}
        self.beams = Beams(convert, nodes, self.reference_pose)
        self.reference = Reference(convert, model, self.beams)
        self._place_ground()

    def _place_ground(self) -> None:
        self.ground = Rigid("ground", GROUND)
        self.home[self.model.ground] = (GROUND, HERE)
        self.frames.append(Frame("ground", GROUND, 0, IDENTITY, ORIGIN))
        self.numbers[self.model.ground] = 0
        part = Part("ground", -1, "", ZERO, ORIGIN, (ZERO,) * 9, 0, 0)
        self.ground.parts.append(part)
        self.ground.index["ground"] = 0

    def rigid(self, number: int) -> Rigid:
        return self.ground if number == GROUND else self.bodies[number]

    def add(self, branch: Branch) -> None:
        """Add the outer body of a branch: a part of the inner one, or a body with a joint."""
        sides = self._sides(branch.joint)
        near_side, far_side = reversed(sides) if branch.reversed else sides
        if branch.joint.kind.kind == "fixed":
            self._merge(branch, near_side, far_side)
        else:
            self._join(branch, near_side, far_side)

    def _sides(self, joint: UserJoint) -> tuple[Placement, Placement]:
        """The joint frame on the parent body and on the child body, in their user frames."""
        if joint.name in self.rotors:
            return self.parent_side[self.rotors[joint.name]], HERE
        if joint.name in self.beams.nodes.implicit:
            return self.reference.floating(joint)
        with self.graph.made_by(joint.name, "placement"):
            sides = self.reference.sides(
                joint,
                self.placement_of(joint.parent, joint.name),
                self.placement_of(joint.child, f"{joint.name}.child"),
                lambda: self._joint_default(joint),
            )
        self.parent_side[joint.name] = sides[0]
        return sides

    def _data(self, joint: UserJoint) -> dict[str, tuple[int, int, Nodes]]:
        """The user's values for a joint, converted once."""
        if joint.name not in self.data:
            with self.graph.made_by(joint.name, "data"):
                self.data[joint.name] = {
                    name: self.convert.quantity(entry, f"{joint.name}.{name}")
                    for name, entry in joint.kind.quantities().items()
                }
        return self.data[joint.name]

    def _joint_default(self, joint: UserJoint) -> Placement:
        """Pose of the child frame in the parent frame at the default coordinates."""
        if joint.kind.coincident:
            return HERE
        q = Matrix.vector(self.graph, [c.default for c in joint.kind.coordinates])
        data = {name: Matrix(self.graph, *entry) for name, entry in self._data(joint).items()}
        rotation, position = joint.kind.pose(q, **data)
        return Placement(rotation.nodes, position.nodes)

    def placement_of(self, place: Place, name: str) -> Placement:
        """A frame in its user body; the parameters take the name of the first who uses it."""
        if isinstance(place, UserBody):
            return HERE
        chain = [place]
        while (base := chain[-1].base) is not None and base not in self.local:
            chain.append(base)
        # from the body outward, without recursion: chains may be long
        for frame in reversed(chain if place not in self.local else ()):
            label = name if frame is place and not frame.named else frame.name
            at = self.convert.vector(frame.coordinates, f"{label}.position", "m")
            inner = Placement(self.convert.rotation(frame.orientation, f"{label}.rotation"), at)
            outer = HERE if frame.base is None else self.local[frame.base]
            self.local[frame] = outer.then(self.graph, inner)
        return self.local[place]

    def reference_pose(self, place: Place, name: str) -> Placement:
        """Pose of a frame in the reference configuration."""
        return self.reference.poses[place.body].then(self.graph, self.placement_of(place, name))

    def _merge(self, branch: Branch, near_side: Placement, far_side: Placement) -> None:
        """Fix the outer body to the rigid body of the inner one."""
        g, joint = self.graph, branch.joint
        number, inner = self.home[branch.inner]
        with g.made_by(joint.name, "placement"):
            side = inner.then(g, near_side)
            self.home[branch.outer] = (number, side.then(g, far_side.inverse(g)))
            where = self.home[branch.outer][1].then(g, far_side)
        self.fixed.append(joint.name)
        self._part(branch, joint.name, where)

    def _join(self, branch: Branch, near_side: Placement, far_side: Placement) -> None:
        """A new rigid body: its axes are the far side of its inboard joint."""
        g, joint = self.graph, branch.joint
        parent, inner = self.home[branch.inner]
        number = len(self.bodies)
        self.bodies.append(Rigid(branch.outer.name, parent))
        with g.made_by(joint.name, "placement"):
            self.home[branch.outer] = (number, far_side.inverse(g))
            outer_side = inner.then(g, near_side)
        if joint.kind.bodiless:
            # nobody's frame, that the joint may have an end
            self.new_frame(branch.outer, self.unwritten(branch.outer.name), number, 0, HERE)
        else:
            self._part(branch, "", HERE)
        frames = {
            role: self._joint_frame(
                place,
                f"{joint.name}.{role}",
                *((parent, outer_side) if place.body is branch.inner else (number, HERE)),
            )
            for role, place in (("parent", joint.parent), ("child", joint.child))
        }
        near, far = ("child", "parent") if branch.reversed else ("parent", "child")
        new_joint = self._moving(joint, frames[near], frames[far], outer_side)
        self._enter(self._reversed(new_joint) if branch.reversed else new_joint)

    def _moving(self, joint: UserJoint, near: int, far: int, place: Placement) -> Joint:
        """A joint of the tree as declared, without slots.

        Args:
            joint: As the user wrote it.
            near, far: Frames on the inner and the outer body.
            place: The frame on the inner body.
        """
        element, data = joint.kind, self._data(joint)
        check_coincidence(self.convert, joint.name, element, data)
        self._label_place(joint.name, place)
        return Joint(
            name=joint.name,
            element=element,
            data=data,
            parent_frame=near,
            child_frame=far,
            rotation=place.rotation,
            position=place.position,
            q=-1,
            u=-1,
            q0=joint.q0,
            u0=joint.u0,
            limits=joint.limits,
        )

    def _enter(self, joint: Joint) -> None:
        """The inboard joint of the last body."""
        self.joint_number[joint.name] = len(self.joints)
        self.joints.append(joint)

    def number(self, closures: Sequence[Closure]) -> None:
        """Slots of the joints that move freely, now that it is known which ones do not."""
        circuit = {i: n for n, closure in enumerate(closures) for i in closure.unknown}
        for i, joint in enumerate(self.joints):
            if i in circuit:
                self.joints[i] = prescribed_motion.replaced(joint, closure=circuit[i])
                continue
            user = self.model.joints[joint.name]
            if user.prescribed is not None or user.couple is not None:
                continue
            coordinates, speeds = joint.element.coordinates, joint.element.speeds
            self.joints[i] = prescribed_motion.replaced(joint, q=self.nq, u=self.nu)
            prescribed_motion.define_coordinates(
                self.convert, joint.name, coordinates, speeds, (self.nq, self.nu)
            )
            self.nq += len(coordinates)
            self.nu += len(speeds)

    def _reversed(self, joint: Joint) -> Joint:
        """A joint whose child carries its parent."""
        line, element = joint.element.line, joint.element.reversed()
        data = joint.data
        if line:
            # parameters are those of the direction as declared
            rows, columns, nodes = data[line]
            data = data | {line: (rows, columns, tuple(map(self.graph.neg, nodes)))}
        return prescribed_motion.replaced(joint, element=element, data=data, reversed=True)

    def close(self, closing: Closing) -> None:
        """A joint of a loop between bodies that are in the tree already."""
        g, joint = self.graph, closing.joint
        with g.made_by(joint.name, "placement"):
            sides = self.reference.closing(
                joint,
                self.placement_of(joint.parent, joint.name),
                self.placement_of(joint.child, f"{joint.name}.child"),
                lambda: self._joint_default(joint),
            )
            (parent, inner), (child, outer) = (
                self.home[place.body] for place in (joint.parent, joint.child)
            )
            places = [inner.then(g, sides[0]), outer.then(g, sides[1])]
        self.parent_side[joint.name] = sides[0]
        if parent == child:
            raise TopologyError(
                f"joint '{joint.name}' ({joint.kind.kind}) closes a loop in which nothing "
                f"moves: '{joint.parent.body.name}' and '{joint.child.body.name}' are fixed to "
                "each other. Leave it out, or let another joint of the loop move"
            )
        near = self._joint_frame(joint.parent, f"{joint.name}.parent", parent, places[0])
        far = self._joint_frame(joint.child, f"{joint.name}.child", child, places[1])
        if closing.keeps_coordinates:
            carrier = self._carry(joint, parent, near, places[0])
            self._cut(closing, Fixed(), {}, (self.joints[carrier].child_frame, far), carrier)
        else:
            self._cut(closing, joint.kind, self._data(joint), (near, far))

    def _carry(self, joint: UserJoint, parent: int, near: int, place: Placement) -> int:
        """Number of a new body without mass, which a joint moves in place of its child."""
        number, name = len(self.bodies), self.unwritten(f"{joint.name}.carried")
        self.bodies.append(Rigid(name, parent))
        far = self.new_frame(name, name, number, 0, HERE)
        self._enter(self._moving(joint, near, far, place))
        return number

    def _cut(
        self,
        closing: Closing,
        element: JointElement,
        data: dict[str, tuple[int, int, Nodes]],
        frames: tuple[int, int],
        carrier: int | None = None,
    ) -> None:
        """Cut joint that closes a loop between two frames."""
        ends = (self.frames[frame].body for frame in frames)
        base, path = circuit([body.parent for body in self.bodies], *ends)
        cut = Cut(
            name=closing.joint.name,
            element=element,
            data=data,
            parent_frame=frames[0],
            child_frame=frames[1],
            base=base,
            path=path,
            rows=tuple(range(len(element.locked))),
            reason=closing.reason,
            carrier=carrier,
        )
        self.cuts.append(cut)

    def _label_place(self, joint: str, place: Placement) -> None:
        """Names for readers of the C: where a joint sits on the parent body."""
        for k, node in enumerate(place.rotation):
            self.graph.label(node, joint, f"place_{'xyz'[k // 3]}{'xyz'[k % 3]}")
        for axis, node in zip("xyz", place.position, strict=True):
            self.graph.label(node, joint, f"place_{axis}")

    def _part(self, branch: Branch, joint: str, where: Placement) -> None:
        """The outer body as a part of its rigid body, with its mass in the axes of that.

        Args:
            branch: How it hangs on the tree.
            joint: Name of the fixed joint that holds it, "" for the first part.
            where: Frame of that joint in the rigid body.
        """
        body = branch.outer
        number, placement = self.home[body]
        rigid = self.rigid(number)
        frame = self.new_frame(body, body.name, number, len(rigid.parts), placement)
        mass, first, tensor = self._mass(body, placement)
        inboard = rigid.index[branch.inner.name] if joint else -1
        rigid.index[body.name] = len(rigid.parts)
        side = frame
        if joint:
            user = branch.joint.parent if branch.reversed else branch.joint.child
            side = self._joint_frame(user, f"{joint}.child", number, where)
        reversed_joint = bool(joint) and branch.reversed
        rigid.parts.append(
            Part(body.name, inboard, joint, mass, first, tensor, frame, side, reversed_joint)
        )

    def _mass(self, body: UserBody, placement: Placement) -> tuple[int, Nodes, Nodes]:
        """Mass, first moment and inertia in axes of the rigid body; nodes of beams have none."""
        if body in self.beams.nodes.beams:
            return ZERO, ORIGIN, (ZERO,) * 9
        convert, name = self.convert, body.name
        with self.graph.made_by(name, "mass"):
            mass = convert.scalar(body.mass, f"{name}.mass", "kg")
            com = convert.vector(body.com, f"{name}.com", "m")
            entries = convert.vector(body.inertia, f"{name}.inertia", "kg m^2", labels=ENTRIES)
            center_tensor = symmetric(entries)
            first, tensor = moved_mass(self.graph, placement, mass, com, center_tensor)
        self.weights[body] = {
            "mass": (1, 1, (mass,)),
            "com": (3, 1, com),
            "inertia": (3, 3, center_tensor),
        }
        if not all(is_number(entry) for entry in (body.mass, *body.inertia)):
            self.unchecked.append((name, (mass, *entries)))
        return mass, first, tensor

    def new_frame(self, key: object, name: str, body: int, part: int, placement: Placement) -> int:
        """A new frame of the system."""
        self.numbers[key] = len(self.frames)
        self.frames.append(Frame(name, body, part, placement.rotation, placement.position))
        return self.numbers[key]

    def _joint_frame(self, place: Place, name: str, body: int, placement: Placement) -> int:
        """Number of the frame of one side of a joint."""
        if (existing := self.numbers.get(place)) is not None:
            frame = self.frames[existing]
            if (frame.rotation, frame.position) == (placement.rotation, placement.position):
                return existing
        part = self.rigid(body).index[place.body.name]
        named_frame = isinstance(place, UserFrame) and place.named and not existing
        named = place.name if named_frame else self.unwritten(name)
        # a joint placed by at= has a frame of its own on a body that stands for another
        return self.new_frame(name if existing is not None else place, named, body, part, placement)

    def unwritten(self, name: str) -> str:
        """A made name, or one like it where the user gave that to something else."""
        while name in self.written:
            name += "_"
        return name

    def frame(self, place: Place, name: str) -> int:
        """Number of a frame of the user, made where it is not known yet."""
        if place not in self.numbers:
            number, home = self.home[place.body]
            placement = home.then(self.graph, self.placement_of(place, name))
            part = self.rigid(number).index[place.body.name]
            has_name = isinstance(place, UserBody) or place.named
            named = place.name if has_name else self.unwritten(name)
            self.new_frame(place, named, number, part, placement)
        return self.numbers[place]

    def couple(self) -> None:
        """Couplings, now that every joint has its number."""
        for user in self.model.joints.values():
            if user.couple is None or user.name not in self.joint_number:
                continue
            k = self.joint_number[user.name]
            coupling = prescribed_motion.coupling(
                self.convert, user, self.joint_number, self.joints
            )
            self.joints[k] = prescribed_motion.replaced(self.joints[k], coupling=coupling)
        prescribed_motion.check_couplings(self.joints)
