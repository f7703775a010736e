"""Small systems cut out of a scene: what one element couples, with data of its own.

Every body of the scene stands here without mass on a free joint from the ground; coordinates of a
joint that an element only reads move a body without mass from the ground. What depends on
parameters alone becomes a parameter of the small system; zeros and ones stay what they are, so that
members of one kind give the same expressions.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ...elements.joints.free import Free
from ...elements.joints.joint import Joint as JointElement
from ...elements.joints.prismatic import Prismatic
from ...elements.joints.revolute import Revolute
from ...errors import DerivationError
from ...ir.function import live, operands
from ...ir.graph import MINUS_ONE, NO_ORIGIN, ONE, ZERO, Graph
from ...ir.matrix import Matrix
from ...ir.ops import LEAVES
from ...ir.rewrite import rebuild
from ...topology.conversion import IDENTITY, ORIGIN, parameters_only
from ...topology.system import (
    GROUND,
    Atom,
    Body,
    Coupling,
    Frame,
    Joint,
    Nodes,
    Parameter,
    Prescribed,
    System,
)
from ..functions.outputs import on_declared_child
from ..kinematics.joint_forces import JointForces
from ..kinematics.kinematics import Kinematics
from .nodal_scene import NODE, NOTHING, Key, Mass, Scene

Data = dict[str, tuple[int, int, Nodes]]
STRUCTURAL = (ZERO, ONE, MINUS_ONE)
LINE: Nodes = (ONE, ZERO, ZERO)
# the joint that an element is made of
MOVING_JOINT = "joint"


class Cutting:
    """Grows a small system.

    Args:
        scene: Where from.

    Attributes:
        places: Keys of the places whose coordinates it has, in the order of its q and u.
        data: Expression in the parameters of the scene of each of its own parameters.
        moved: Bodies of rigid trees of the scene -> their numbers here.
        z, s: Entries of the internal states and modes of the scene that it reads.
        events: Number of the events of its elements.
    """

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.system = scene.system
        self.graph = Graph()
        self.graph.tables = self.system.graph.tables.copy()
        self.bodies: list[Body] = []
        self.joints: list[Joint] = []
        self.frames: list[Frame] = [Frame("ground", GROUND, 0, IDENTITY, ORIGIN)]
        self.atoms: dict[str, Atom] = {}
        self.places: list[Key] = []
        self.data: list[int] = []
        self.events = 0
        self.moved: dict[int, int] = {}
        self.z: list[int] = []
        self.s: list[int] = []
        self._names: list[str] = []
        self._frames_of_bodies: dict[int, int] = {}
        self._body: dict[int, int] = {GROUND: GROUND}
        self._joint: dict[int, int] = {}
        self._frame: dict[int, int] = {0: 0}
        self._slots = [0, 0]

    def system_of(self, **more: object) -> System:
        """The small system."""
        fields: dict[str, object] = {
            "gravity": ORIGIN,
            "forces": (),
            "outputs": (),
            "cuts": (),
            "constraints": (),
            **more,
        }
        return System(
            name=self.system.name,
            graph=self.graph,
            bodies=tuple(self.bodies),
            joints=tuple(self.joints),
            frames=tuple(self.frames),
            parameters=tuple(Parameter(name, 0.0, "") for name in self._names),
            inputs=self.system.inputs,
            atoms=self.atoms,
            nq=self._slots[0],
            nu=self._slots[1],
            **fields,  # type: ignore[arg-type]
        )

    def like(self, places: Sequence[Key], data: Sequence[int]) -> Cutting:
        """The same small system cut out at other places, with other data."""
        other = Cutting.__new__(Cutting)
        other.__dict__.update(self.__dict__)
        other.places, other.data = list(places), list(data)
        return other

    @property
    def driven(self) -> dict[int, int]:
        """Prescribed joints of the scene whose coordinates it has -> their numbers here."""
        joints = self.system.joints
        return {i: n for i, n in self._joint.items() if joints[i].motion is not None}

    def slots(self) -> dict[tuple[str, int], int]:
        """Entries of q and u here that are those of joints of the scene -> entries there."""
        entries: dict[tuple[str, int], int] = {}
        for i, number in self._joint.items():
            there, here = self.system.joints[i], self.joints[number]
            if here.q >= 0:
                counts = len(here.element.coordinates), len(here.element.speeds)
                entries |= {("q", here.q + n): there.q + n for n in range(counts[0])}
                entries |= {("u", here.u + n): there.u + n for n in range(counts[1])}
        return entries

    # places

    def node(self, body: int, mass: Mass = NOTHING) -> int:
        """Number here of a body of the scene."""
        if body in self.scene.in_trees:
            return self.tree_body(body)
        if body not in self._body:
            self._body[body] = self.floating(self._numbered("body"), mass)
            self.places.append((NODE, body))
        return self._body[body]

    def tree_body(self, body: int, mass: Mass = NOTHING) -> int:
        """Number here of a body of a rigid tree: joints carry it from its base on."""
        way = [body]
        while way[-1] not in self._body and self.system.bodies[way[-1]].parent in (
            self.scene.in_trees
        ):
            way.append(self.system.bodies[way[-1]].parent)
        for i in reversed(way):
            if i not in self._body:
                parent = self.system.bodies[i].parent
                local = self._body[parent] if parent in self._body else self.node(parent)
                self._body[i] = self._tree_body(i, local, mass if i == body else NOTHING)
        return self._body[body]

    def _tree_body(self, i: int, parent: int, mass: Mass) -> int:
        """A body that joint i of the scene moves from a body here."""
        joint = self.system.joints[i]
        place = (
            self.expressions(joint.rotation, "place_rotation"),
            self.expressions(joint.position, "place_position"),
        )
        data = self.quantities(joint.data)
        number = self._moving("", i, parent, joint.element, data, place, mass)
        self.moved[i] = number
        self._joint.setdefault(i, number)
        return number

    def floating(self, name: str, mass: Mass = NOTHING) -> int:
        """Number here of a new body that moves freely."""
        return self._enter(name, GROUND, Free(), {}, mass)

    def joint(self, i: int) -> int:
        """Number here of a joint of the scene whose coordinates are read."""
        if i in self.scene.nodal:
            return self.node(i)
        if i in self.scene.in_trees and not self.scene.line(i):
            return self.tree_body(i)
        return self._joint[i] if i in self._joint else self.alone(i)

    def alone(self, i: int) -> int:
        """Number here of a body on the ground that has the coordinates of a joint of the scene."""
        element, data = self._stand_in(i)
        self._joint[i] = self._moving("", i, GROUND, element, data)
        return self._joint[i]

    def moving_body(self, i: int, parent: int) -> int:
        """Number here of a body without mass that a joint of the scene moves from a body here."""
        joint = self.system.joints[i]
        place = (
            self.expressions(joint.rotation, "place_rotation"),
            self.expressions(joint.position, "place_position"),
        )
        data = self.quantities(joint.data)
        number = self._moving(MOVING_JOINT, i, parent, joint.element, data, place)
        self._joint.setdefault(i, number)
        return number

    def _stand_in(self, i: int) -> tuple[JointElement, Data]:
        """A joint with the same coordinates; where there is one, of the simplest kind."""
        joint = self.system.joints[i]
        if self.scene.line(i) != 1:
            return joint.element, self.quantities(joint.data)
        slides = joint.element.coordinates[0].unit == "m"
        return (Prismatic("x") if slides else Revolute("x")), {"axis": (3, 1, LINE)}

    def _moving(
        self,
        name: str,
        i: int,
        parent: int,
        element: JointElement,
        data: Data,
        place: tuple[Nodes, Nodes] = (IDENTITY, ORIGIN),
        mass: Mass = NOTHING,
    ) -> int:
        """A body on a joint with the coordinates of joint i of the scene."""
        joint = self.system.joints[i]
        coupling = motion = None
        if i in self._joint and joint.motion is None:
            # its coordinate is here already
            coupling = Coupling(self._joint[i], ONE, ZERO)
        elif joint.coupling is not None:
            ratio, offset = joint.coupling.ratio, joint.coupling.offset
            ratio_and_offset = self.expressions((ratio, offset), "coupling")
            coupling = Coupling(self.joint(joint.coupling.leader), *ratio_and_offset)
        elif joint.motion is not None:
            prescribed = joint.motion
            expressions = (prescribed.value, prescribed.rate, prescribed.acceleration)
            motion = Prescribed(*self.expressions(expressions, "motion"))
            (ratio,) = self.expressions((prescribed.ratio,), "ratio")
            motion = replace(motion, ratio=ratio)
        else:
            self.places.append(("joint", i))
        name = name or self._numbered("joint")
        return self._enter(name, parent, element, data, mass, place, coupling, motion)

    def _numbered(self, name: str) -> str:
        return f"{name}{sum(joint.name.startswith(name) for joint in self.joints) + 1}"

    def _enter(
        self,
        name: str,
        parent: int,
        element: JointElement,
        data: Data,
        mass: Mass,
        place: tuple[Nodes, Nodes] = (IDENTITY, ORIGIN),
        coupling: Coupling | None = None,
        motion: Prescribed | None = None,
    ) -> int:
        number, (q, u) = len(self.bodies), self._slots
        free = coupling is None and motion is None
        inertia = (mass.mass, mass.first_moment, mass.inertia)
        self.bodies.append(Body(name, parent, *inertia, parts=()))
        self.frames.append(Frame(name, number, 0, IDENTITY, ORIGIN))
        self.joints.append(
            Joint(
                name=name,
                element=element,
                data=data,
                parent_frame=0,
                child_frame=len(self.frames) - 1,
                rotation=place[0],
                position=place[1],
                q=q if free else -1,
                u=u if free else -1,
                coupling=coupling,
                motion=motion,
            )
        )
        if free:
            self._slots = [q + len(element.coordinates), u + len(element.speeds)]
        return number

    def joint_wrenches(self, k: Kinematics, forces: JointForces) -> tuple[int, ...]:
        """Wrenches on the declared children of the joints of trees, in the order of ``moved``."""
        nodes = list[int]()
        for i, number in self.moved.items():
            wrench = Matrix.vstack(forces.moment[number], forces.force[number])
            if self.system.joints[i].reversed:
                wrench = on_declared_child(k, number, wrench)
            nodes += wrench.nodes
        return tuple(nodes)

    def body_frame(self, body: int) -> int:
        """Index of the frame of a body here that is its own."""
        return self.joints[body].child_frame

    def frame(self, number: int) -> int:
        """Index here of a frame of the scene."""
        number = self.scene.frame(number)
        if number not in self._frame:
            frame = self.system.frames[number]
            body = self.node(frame.body)
            name = f"frame{len(self._frame)}"
            rotation = self.expressions(frame.rotation, f"{name}_rotation")
            position = self.expressions(frame.position, f"{name}_position")
            self._frame[number] = len(self.frames)
            self.frames.append(Frame(name, body, 0, rotation, position))
        return self._frame[number]

    # expressions

    def quantities(self, data: Data) -> Data:
        """Quantities of an element of the scene."""
        return {
            name: (rows, columns, self.expressions(nodes, name))
            for name, (rows, columns, nodes) in data.items()
        }

    def expressions(self, nodes: Sequence[int], name: str) -> Nodes:
        """Expressions of the scene told here.

        Args:
            nodes: In the graph of the scene.
            name: What new parameters are called.
        """
        graph = self.system.graph
        order = live(graph, nodes)
        fixed = parameters_only(graph, order)
        replacements: dict[int, int] = {}
        for i in (n for n in nodes if n in fixed):
            replacements[i] = self._datum(i, name, len(nodes) > 1)
        for i in order:
            if i in fixed:
                continue
            node = graph.nodes[i]
            if node[0] in LEAVES:
                replacements[i] = self._leaf(i)
                continue
            for k in operands(node):
                if k in fixed and graph.nodes[k][0] != "const":
                    replacements[k] = self._datum(k, name, True)
        start = len(self.graph)
        rebuilt = rebuild(graph, nodes, replacements, into=self.graph)[1]
        # who wrote them first is no matter: they stand for all members of a kind
        for i in range(start, len(self.graph)):
            self.graph.origins[i] = NO_ORIGIN
            self.graph.labels.pop(i, None)
            self.graph.shared.pop(i, None)
        return tuple(rebuilt)

    def _datum(self, i: int, name: str, several: bool) -> int:
        """An expression in parameters alone as a parameter of its own, or as the number it is."""
        graph = self.system.graph
        if i in STRUCTURAL:
            return i
        if graph.nodes[i][0] == "neg":
            return self.graph.neg(self._datum(graph.nodes[i][1], name, several))
        if i not in self._frames_of_bodies:
            count = sum(other.startswith(f"{name}.") for other in self._names)
            taken = several or name in self._names
            self._frames_of_bodies[i] = self.graph.var("p", len(self.data))
            self._names.append(f"{name}.{count + 1}" if taken else name)
            self.data.append(i)
        return self._frames_of_bodies[i]

    def _leaf(self, i: int) -> int:
        """A leaf that moves: time, input, coordinate, state or placeholder."""
        kind, name, *indices = self.system.graph.nodes[i]
        if kind == "atom":
            return self._atom(name) if name in self.system.atoms else self.graph.atom(name)
        if name in ("t", "r"):
            return self.graph.var(name, indices[0])
        if name in ("z", "s"):
            return self.graph.var(name, self.state(name, indices[0]))
        if name not in ("q", "u"):
            raise DerivationError(f"an expression that reads block '{name}' belongs to no element")
        owner, entry = self.scene.slot(name, indices[0])
        joint = self.joints[self.joint(owner)]
        return self.graph.var(name, (joint.q if name == "q" else joint.u) + entry)

    def state(self, block: str, entry: int) -> int:
        """Entry here of an internal state ("z") or mode ("s") of the scene."""
        entries = self.z if block == "z" else self.s
        if entry not in entries:
            entries.append(entry)
        return entries.index(entry)

    def _atom(self, name: str) -> int:
        """A placeholder for the motion of frames or joints."""
        atom = self.system.atoms[name]
        if atom.quantity in ("q", "u"):
            local = replace(atom, frame=self.joint(atom.frame))
        else:
            frame, wrt, in_ = (self.frame(f) for f in (atom.frame, atom.wrt, atom.in_))
            local = replace(atom, frame=frame, wrt=wrt, in_=in_)
        for key, other in self.atoms.items():
            if other == local:
                return self.graph.atom(key)
        key = f"motion {len(self.atoms)}"
        self.atoms[key] = local
        return self.graph.atom(key)
