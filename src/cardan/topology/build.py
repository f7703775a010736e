"""Model -> System: the spanning tree, coordinate slots, and everything written as expressions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from ..errors import ModelError, near
from ..ir.graph import ZERO, Graph
from ..model.body import Body as UserBody
from ..model.connections import Joint as UserJoint
from ..model.frame import Frame as UserFrame
from ..model.frame import Place
from ..model.model import Model
from . import announcements, motion, system
from .convert import IDENTITY, ORIGIN, Converter, symmetric
from .placement import HERE, Placement, moved_mass
from .reference import Reference
from .system import GROUND, System
from .tree import Branch, open_tree


def build(model: Model) -> System:
    """The system graph of a model.

    Raises:
        TopologyError: circuits, loose bodies, reversed joints.
        ModelError: quantities that cannot be what they say.
    """
    return _Builder(model).system()


@dataclass
class _Rigid:
    """A rigid body being assembled: the parts and where their frames are."""

    name: str
    parent: int
    parts: list[system.Part] = field(default_factory=list)
    index: dict[str, int] = field(default_factory=dict)


class _Builder:
    """One build: fills the lists of the system in the order of the spanning tree."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.graph = Graph()
        self.convert = Converter(model, self.graph)
        self.inputs = motion.declare_inputs(model, self.convert)
        self.bodies: list[_Rigid] = []
        self.ground = _Rigid("ground", GROUND)
        self.frames: list[system.Frame] = []
        self.joints: list[system.Joint] = []
        self.fixed: list[str] = []
        self.home: dict[UserBody, tuple[int, Placement]] = {}
        self.numbers: dict[Any, int] = {}
        self.joint_number: dict[str, int] = {}
        self.local: dict[UserFrame, Placement] = {}
        self.nq = self.nu = 0

    def system(self) -> System:
        """The whole build, one named step per line."""
        model = self.model
        branches = open_tree(model)
        with self.graph.made_by("ground", "gravity"):
            gravity = self.convert.vector(model.gravity, "gravity", "m/s^2")
        self._place_ground()
        self.reference = Reference(self.convert, model)
        for branch in branches:
            self._add(branch)
        self._couple()
        for frame in model.frames.values():
            if frame.named:
                self._frame(frame, frame.name)
        atoms = self._atoms()
        forces = tuple([self._force(name) for name in model.forces])
        joints = tuple(self._prescribed())
        outputs = tuple([self._output(name) for name in model.outputs])
        bodies = tuple([self._body(rigid) for rigid in self.bodies])
        made = System(
            name=model.name,
            graph=self.graph,
            gravity=gravity,
            bodies=bodies,
            joints=joints,
            frames=tuple(self.frames),
            forces=forces,
            parameters=tuple(self.convert.parameters),
            inputs=self.inputs,
            outputs=outputs,
            atoms=atoms,
            nq=self.nq,
            nu=self.nu,
            ground_parts=tuple(self.ground.parts),
            fixed=tuple(self.fixed),
            shapes=tuple(self._shapes()),
            snaps=tuple(model.snaps),
            structural=self.convert.structural,
        )
        return announcements.announce(made, model, self.convert.used)

    # bodies and their frames

    def _place_ground(self) -> None:
        self.home[self.model.ground] = (GROUND, HERE)
        self.frames.append(system.Frame("ground", GROUND, 0, IDENTITY, ORIGIN))
        self.numbers[self.model.ground] = 0
        part = system.Part("ground", -1, "", ZERO, ORIGIN, (ZERO,) * 9, 0, 0)
        self.ground.parts.append(part)
        self.ground.index["ground"] = 0

    def _rigid(self, number: int) -> _Rigid:
        return self.ground if number == GROUND else self.bodies[number]

    def _add(self, branch: Branch) -> None:
        """Add the outer body of a branch: a part of the inner one, or a body with a joint."""
        parent_side, child_side = self._sides(branch.joint)
        if branch.joint.kind.kind == "fixed":
            self._merge(branch, parent_side, child_side)
        else:
            self._join(branch, parent_side, child_side)

    def _sides(self, joint: UserJoint) -> tuple[Placement, Placement]:
        """The joint frame on the parent body and on the child body, in their user frames."""
        with self.graph.made_by(joint.name, "placement"):
            return self.reference.sides(
                joint,
                self._local(joint.parent, joint.name),
                self._local(joint.child, f"{joint.name}.child"),
            )

    def _local(self, place: Place, name: str) -> Placement:
        """A frame in its user body; the parameters take the name of the first who uses it."""
        if isinstance(place, UserBody):
            return HERE
        found = self.local.get(place)
        if found is None:
            own = place.name if place.named else name
            position = self.convert.vector(place.coordinates, f"{own}.position", "m")
            rotation = self.convert.rotation(place.orientation, f"{own}.rotation")
            found = Placement(rotation, position)
            self.local[place] = found
        return found

    def _merge(self, branch: Branch, parent_side: Placement, child_side: Placement) -> None:
        """Fix the outer body to the rigid body of the inner one."""
        g, joint = self.graph, branch.joint
        number, inner = self.home[branch.inner]
        near_side, far_side = parent_side, child_side
        if branch.reversed:
            near_side, far_side = child_side, parent_side
        with g.made_by(joint.name, "placement"):
            side = inner.then(g, near_side)
            self.home[branch.outer] = (number, side.then(g, far_side.inverse(g)))
        self.fixed.append(joint.name)
        self._part(branch, joint.name)

    def _join(self, branch: Branch, parent_side: Placement, child_side: Placement) -> None:
        """A new rigid body: its axes are the child side of its inboard joint."""
        g, joint = self.graph, branch.joint
        parent, inner = self.home[branch.inner]
        number = len(self.bodies)
        self.bodies.append(_Rigid(branch.outer.name, parent))
        with g.made_by(joint.name, "placement"):
            self.home[branch.outer] = (number, child_side.inverse(g))
            outer_side = inner.then(g, parent_side)
        self._part(branch, "")
        element = joint.kind
        with g.made_by(joint.name, "data"):
            data = {
                name: self.convert.quantity(entry, f"{joint.name}.{name}")
                for name, entry in element.quantities().items()
            }
        slots = joint.motion is None and joint.couple is None
        frame = self._joint_frame(joint.parent, f"{joint.name}.parent", parent, outer_side)
        child = self._joint_frame(joint.child, f"{joint.name}.child", number, HERE)
        self.joint_number[joint.name] = number
        self.joints.append(
            system.Joint(
                name=joint.name,
                element=element,
                data=data,
                parent_frame=frame,
                child_frame=child,
                rotation=outer_side.rotation,
                position=outer_side.position,
                q=self.nq if slots else -1,
                u=self.nu if slots else -1,
                q0=joint.q0,
                u0=joint.u0,
                limits=joint.limits,
            )
        )
        coordinates, speeds = element.coordinates, element.speeds
        motion.define_coordinates(
            self.convert, joint.name, coordinates, speeds, (self.nq, self.nu) if slots else None
        )
        if slots:
            self.nq += len(coordinates)
            self.nu += len(speeds)

    def _part(self, branch: Branch, joint: str) -> None:
        """The outer body as a part of its rigid body, with its mass in the axes of that."""
        g, body = self.graph, branch.outer
        number, placement = self.home[body]
        rigid = self._rigid(number)
        frame = self._number(body, body.name, number, len(rigid.parts), placement)
        with g.made_by(body.name, "mass"):
            mass = self.convert.scalar(body.mass, f"{body.name}.mass", "kg")
            com = self.convert.vector(body.com, f"{body.name}.com", "m")
            entries = self.convert.vector(
                body.inertia, f"{body.name}.inertia", "kg m^2", labels=_ENTRIES
            )
            first, tensor = moved_mass(g, placement, mass, com, symmetric(entries))
        inboard = rigid.index[branch.inner.name] if joint else -1
        side = frame
        if joint:
            user = branch.joint.child if not branch.reversed else branch.joint.parent
            with g.made_by(branch.joint.name, "placement"):
                where = placement.then(g, self._local(user, f"{joint}.child"))
            side = self._joint_frame(user, f"{joint}.child", number, where)
        rigid.index[body.name] = len(rigid.parts)
        rigid.parts.append(system.Part(body.name, inboard, joint, mass, first, tensor, frame, side))

    def _body(self, rigid: _Rigid) -> system.Body:
        """Sums over the parts."""
        g, parts = self.graph, rigid.parts
        first = parts[0]
        mass, moment, inertia = first.mass, first.first_moment, first.inertia
        with g.made_by(rigid.name, "mass"):
            for part in parts[1:]:
                mass = g.add(mass, part.mass)
                moment = tuple(map(g.add, moment, part.first_moment))
                inertia = tuple(map(g.add, inertia, part.inertia))
        return system.Body(rigid.name, rigid.parent, mass, moment, inertia, tuple(parts))

    def _number(self, key: Any, name: str, body: int, part: int, placement: Placement) -> int:
        """A new frame of the system."""
        self.numbers[key] = len(self.frames)
        self.frames.append(system.Frame(name, body, part, placement.rotation, placement.position))
        return self.numbers[key]

    def _joint_frame(self, place: Place, name: str, body: int, placement: Placement) -> int:
        """Number of the frame of one side of a joint."""
        known = self.numbers.get(place)
        if known is not None:
            frame = self.frames[known]
            if (frame.rotation, frame.position) == (placement.rotation, placement.position):
                return known
            place = name  # type: ignore[assignment]
        rigid = self._rigid(body)
        owner = place.body.name if isinstance(place, (UserFrame, UserBody)) else ""
        part = rigid.index.get(owner, max(len(rigid.parts) - 1, 0))
        named = place.name if isinstance(place, UserFrame) and place.named else name
        return self._number(place, named, body, part, placement)

    def _frame(self, place: Place, name: str) -> int:
        """Number of a frame of the user, made where it is not known yet."""
        known = self.numbers.get(place)
        if known is None:
            number, home = self.home[place.body]
            placement = home.then(self.graph, self._local(place, name))
            part = self._rigid(number).index[place.body.name]
            known = self._number(place, name, number, part, placement)
        return known

    # coordinates that follow, placeholders, forces

    def _couple(self) -> None:
        """Couplings, now that every joint has its number."""
        for user in self.model.joints.values():
            if user.couple is None or user.name not in self.joint_number:
                continue
            k = self.joint_number[user.name]
            coupling = motion.coupling(self.convert, user, self.joint_number, self.joints)
            self.joints[k] = motion.replaced(self.joints[k], coupling=coupling)
        motion.check_couplings(self.joints)

    def _prescribed(self) -> list[system.Joint]:
        """Joints with ``motion=`` get value, rate and acceleration."""
        joints = list(self.joints)
        for user in self.model.joints.values():
            if user.motion is not None and user.name in self.joint_number:
                k = self.joint_number[user.name]
                prescribed = motion.prescribe(self.convert, user, self.inputs)
                joints[k] = motion.replaced(joints[k], motion=prescribed)
        return joints

    def _atoms(self) -> dict[str, system.Atom]:
        """The placeholders of expressions, by frame number."""
        atoms: dict[str, system.Atom] = {}
        for name, entry in self.model.atoms.items():
            if entry.quantity in "qu":
                number = self.joint_number.get(entry.place)
                if number is None:
                    raise ModelError(
                        f"'{name}': joint '{entry.place}' is fixed; it has no coordinates"
                    )
                if self.joints[number].q < 0:
                    atoms[name] = system.Atom(entry.quantity, number)
                    self.convert.define(name, self.graph.atom(name), entry.unit)
                continue
            place, wrt, in_ = (
                self._frame(p, p.name) if p is not None else 0
                for p in (entry.place, entry.wrt, entry.in_)
            )
            atoms[name] = system.Atom(entry.quantity, place, wrt, in_, entry.component)
            self.convert.define(name, self.graph.atom(name), entry.unit)
        return atoms

    def _force(self, name: str) -> system.Force:
        element = self.model.forces[name].element
        with self.graph.made_by(name, "data"):
            data = {
                key: self.convert.quantity(entry, f"{name}.{key}")
                for key, entry in element.quantities().items()
            }
            frames = {
                role: self._frame(
                    self.model.place(f"force '{name}'", place, role), f"{name}.{role}"
                )
                for role, place in element.frames().items()
            }
        joints = {role: self._joint_of(name, j) for role, j in element.joints().items()}
        return system.Force(name, element, data, frames, joints)

    def _joint_of(self, force: str, joint: Any) -> int:
        name = joint if isinstance(joint, str) else joint.name
        if name not in self.joint_number:
            what = "is fixed" if name in self.model.joints else "does not exist"
            hint = near(name, self.joint_number).replace(" Known:", " Joints:")
            raise ModelError(f"force '{force}': joint '{name}' {what}.{hint}")
        return self.joint_number[name]

    def _output(self, name: str) -> system.Named:
        entry = self.model.outputs[name]
        with self.graph.made_by(name, "output"):
            node = self.convert.scalar(entry.expression, f"output {name}", entry.unit)
        return system.Named(name, node, entry.unit)

    def _shapes(self) -> list[tuple[int, Mapping[str, object]]]:
        return [
            (self.numbers[body], shape.record())
            for body in (self.model.ground, *self.model.bodies.values())
            for shape in body.shapes
        ]


_ENTRIES = ("xx", "xy", "xz", "yy", "yz", "zz")
