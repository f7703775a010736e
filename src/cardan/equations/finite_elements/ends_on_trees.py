"""Elements of beams in small systems: joints of a rigid tree carry some of their ends, or their
data change with what moves.

What an element does to its ends, w = (moment in axes of the end, force in ground axes), is told
along the speeds of the joints: with J of the end b = Jᵀ w. Of its tangent K, J follows both sides
and one term is left, the change of Jᵀ w along q at constant w.

Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), chapter 7.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from typing import ClassVar

from ...elements.flexible.element import FlexibleElement
from ...elements.flexible.element_ends import (
    ENDS,
    LOADS,
    NAMES,
    PLACES,
    STRESS_UNITS,
    STRESSES,
    Ends,
    Loads,
)
from ...elements.flexible.node_set import FRAME, Motion, Node, Offset, Place, Pose
from ...elements.joints.free import Free
from ...ir.arithmetic import Scalar
from ...ir.derivative import directional
from ...ir.function import Block, Function, Output
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...records import dataclass
from ...spatial.exponential import quaternion_of
from ...topology.system import GROUND
from ..functions.blocks import blocks
from ..kinematics.accelerations import Accelerations, accelerations
from ..kinematics.joint_forces import JointForces, along_joint, joint_forces
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import merged, none
from .element_systems import Cutting
from .joint_constraints import increments
from .nodal_scene import NODE, Scene
from .parts import Part, structure

TREE, TREE_OFFSET = "tree", "tree_offset"
# loads told end by end
BY_END = ("mx", "my", "mz", "fx", "fy", "fz")
# in place of a body: a node that no body of the scene has
INSIDE = -2
# leaves that stand for the load on an end while its place moves
LEAVES = tuple(f"load on the end of an element [{k}]" for k in range(6))


class TreeMotion:
    """Motion of the bodies of a small system, for all ends of one element.

    Args:
        k: Its kinematics.
    """

    def __init__(self, k: Kinematics) -> None:
        self.k = k

    @cached_property
    def accelerations(self) -> Accelerations:
        """Of all bodies; the ground is at rest."""
        k, nu = self.k, self.k.system.nu
        udot = k.block("udot", 0, nu)
        along = [along_joint(k, i, udot) for i in range(len(k.joints))]
        return accelerations(k, along, Matrix.zeros(k.graph, 3))

    @cached_property
    def directions(self) -> list[dict[int, int]]:
        """Changes of q, and of poses of nodes, at unit increments of each speed."""
        seeds = increments(self.k)
        for i, joint in enumerate(self.k.system.joints):
            if is_node(self.k, i):
                seeds[joint.u : joint.u + 6] = Node(self.k.graph, (), joint.q, joint.u).directions()
        return seeds


def is_node(k: Kinematics, i: int) -> bool:
    """True when a joint of a small system stands for a node."""
    return k.system.joints[i].element == Free() and k.system.bodies[i].parent == GROUND


@dataclass(frozen=True)
class TreeEnd(Place):
    """At the origin of a body of a tree, in its axes; all speeds of the small system are its own.

    Attributes:
        motion_of_tree: Of all bodies.
        body: Number in the small system.
    """

    kind: ClassVar[str] = TREE
    motion_of_tree: TreeMotion = field(repr=False)
    body: int

    @property
    def k(self) -> Kinematics:
        """Kinematics of the small system."""
        return self.motion_of_tree.k

    def entries(self, letter: str) -> Matrix:
        system = self.k.system
        return self.k.block(letter, 0, system.nq if letter == "q" else system.nu)

    def pose(self) -> Pose:
        R = self.k.ground_rotation[self.body]
        return Pose(R, self.k.ground_position[self.body], quaternion_of(R))

    def motion(self) -> Motion:
        k, b, acc = self.k, self.body, self.motion_of_tree.accelerations
        R = k.ground_rotation[b]
        return Motion(k.omega[b], R @ k.v[b], acc.alpha[b], R @ acc.a[b])

    def to_space(self) -> Matrix:
        k, g = self.k, self.graph
        columns = [Matrix.zeros(g, 6) for _ in range(k.system.nu)]
        R, at, body = k.ground_rotation[self.body], k.ground_position[self.body], self.body
        while body >= 0:
            # what moves with a joint turns about the origin of its body
            arm, axes = at - k.ground_position[body], k.ground_rotation[body]
            for slot, s in k.joints[body].columns:
                turn = axes @ s.block(slice(0, 3))
                moving = axes @ s.block(slice(3, 6)) + turn.cross(arm)
                columns[slot] = columns[slot] + Matrix.vstack(R.T @ turn, moving)
            body = k.system.bodies[body].parent
        return Matrix.hstack(*columns)

    def at_origin(self, moment: Matrix, force: Matrix) -> tuple[Matrix, Matrix]:
        """A load on the end as one at the origin of its body: moment in its axes, force."""
        return moment, force

    def bent(self, moment: Matrix, force: Matrix) -> Matrix:
        g, nu = self.graph, self.k.system.nu
        leaves = [g.atom(name) for name in LEAVES]
        loads = self.to_space().T @ Matrix(g, 6, 1, leaves)
        columns = directional(g, loads.nodes, self.directions())
        nodes = [column[i] for i in range(nu) for column in columns]
        values = dict(zip(leaves, (*moment.nodes, *force.nodes), strict=True))
        return Matrix(g, nu, nu, rebuild(g, nodes, values, into=g)[1])

    def directions(self) -> list[dict[int, int]]:
        return self.motion_of_tree.directions


@dataclass(frozen=True)
class TreeOffset(TreeEnd):
    """Fixed to a body of a tree beside its origin, or in other axes."""

    kind: ClassVar[str] = TREE_OFFSET
    data: ClassVar[tuple[str, ...]] = FRAME

    @property
    def _at(self) -> TreeEnd:
        """The origin of the body."""
        return TreeEnd(self.graph, (), 0, 0, self.motion_of_tree, self.body)

    @property
    def _frame(self) -> Offset:
        """The same frame on a node, whose motion is replaced."""
        return _OnEnd(self.graph, self.attributes, 0, 0, self._at)

    def pose(self) -> Pose:
        pose = self._frame.pose()
        return replace(pose, quaternion=quaternion_of(pose.rotation))

    def motion(self) -> Motion:
        return self._frame.motion()

    def to_space(self) -> Matrix:
        return self._frame.to_space() @ self._at.to_space()

    def at_origin(self, moment: Matrix, force: Matrix) -> tuple[Matrix, Matrix]:
        load = self._frame.to_space().T @ Matrix.vstack(moment, force)
        return load.block(slice(3)), load.block(slice(3, 6))

    def bent(self, moment: Matrix, force: Matrix) -> Matrix:
        J = self._at.to_space()
        inner = self._at.bent(*self.at_origin(moment, force))
        return inner + J.T @ self._frame.bent(moment, force) @ J


@dataclass(frozen=True)
class _OnEnd(Offset):
    """A frame fixed to another end instead of a node."""

    at: TreeEnd

    @property
    def node(self) -> TreeEnd:  # type: ignore[override]
        return self.at


END_CLASSES: dict[str, type[Place]] = {**PLACES, TREE: TreeEnd, TREE_OFFSET: TreeOffset}


@dataclass(frozen=True)
class EndsOnTrees(Ends):
    """Ends of an element in a small system of tree bodies and nodes.

    Attributes:
        motion_of_tree: Of its bodies.
        bodies: Number of the body of every end, :data:`GROUND` on the ground.
        states: Internal states and modes of the small system.
        variable: Expressions of the data that more than parameters change, by name.
        by_end: Whether what acts on the ends is told end by end, not along the speeds.
    """

    motion_of_tree: TreeMotion = field(repr=False)
    bodies: tuple[int, ...]
    states: Mapping[str, Block] = field(default_factory=dict)
    variable: Mapping[str, int] = field(default_factory=dict)
    by_end: bool = False

    def number(self, name: str) -> Scalar:
        if name in self.variable:
            return Scalar(self.graph, *self.k.resolve([self.variable[name]]))
        return super().number(name)

    @property
    def k(self) -> Kinematics:
        """Kinematics of the small system."""
        return self.motion_of_tree.k

    @cached_property
    def _ends(self) -> tuple[Place, ...]:
        return tuple(self._end(k) for k in range(len(self.kinds)))

    @property
    def places(self) -> tuple[Place, ...]:
        return self._ends

    def _end(self, k: int) -> Place:
        body, cls = self.bodies[k], END_CLASSES[self.kinds[k]]
        attributes = tuple(self.number(f"{ENDS[k]}_{entry}") for entry in cls.data)
        if issubclass(cls, TreeEnd):
            return cls(self.graph, attributes, 0, 0, self.motion_of_tree, body)
        joint = self.k.system.joints[body] if body != GROUND else None
        first = (joint.q, joint.u) if joint is not None else (0, 0)
        return cls(self.graph, attributes, *first)

    @property
    def speeds(self) -> tuple[str, ...]:
        return self._by_end if self.by_end else blocks(self.k.system)["u"].entries

    @property
    def _by_end(self) -> tuple[str, ...]:
        return tuple(f"{name}.{entry}" for name in ENDS[: len(self.kinds)] for entry in BY_END)

    @property
    def load_units(self) -> tuple[str, ...]:
        if self.by_end:
            return ("",) * len(self._by_end)
        units = blocks(self.k.system)["du"].units
        return tuple(LOADS.get(unit, "") for unit in units)

    def directions(self, letter: str) -> list[dict[int, int]]:
        if self.by_end:
            return [{} for _ in self._by_end]
        return self.motion_of_tree.directions if letter == "q" else super().directions(letter)

    def _entries(self, letter: str) -> Block:
        if letter == "p":
            return Block("p", self.data, ("",) * len(self.data))
        if letter in self.states:
            return self.states[letter]
        if letter == "z":
            return Block("z", STRESSES, STRESS_UNITS)
        return blocks(self.k.system)[letter]

    def assembled(self, loads: Loads) -> Matrix:
        return Matrix.vstack(*loads) if self.by_end else super().assembled(loads)

    def derivative(self, blocks: Sequence[Loads], loads: Loads) -> Matrix:
        if self.by_end:
            return Matrix.zeros(self.graph, len(self._by_end), len(self._by_end))
        return super().derivative(blocks, loads)

    def joint_forces(self, loads: Matrix) -> JointForces:
        """What the joints of the tree transmit on account of the element.

        Args:
            loads: Moments and forces on the ends, end by end (6 each).
        """
        k, wrenches = self.k, dict[int, tuple[Matrix, Matrix]]()
        for n, (place, body) in enumerate(zip(self.places, self.bodies, strict=True)):
            if isinstance(place, TreeEnd):
                moment, force = (loads.block(slice(i, i + 3)) for i in (6 * n, 6 * n + 3))
                moment, force = place.at_origin(moment, force)
                in_body = k.ground_rotation[body].T @ force
                # loads hold the ends: the element acts on them with the opposite
                wrenches = merged(wrenches, {body: (-moment, -in_body)})
        acting = none(k).with_outside(wrenches)
        return joint_forces(k, self.motion_of_tree.accelerations, acting)


class TreeElement:
    """A flexible element with ends on bodies of a rigid tree, or with data that vary.

    Its data are those of the joints that carry the ends and of what varies, then its own.

    Args:
        scene: The scene.
        element: The element.
        kinds: Of its ends.
        bodies: Of its ends, :data:`GROUND` or :data:`INSIDE`.
        variable: Expressions in the scene of the data that more than parameters change, by name.

    Attributes:
        cutting: What of the scene it couples besides nodes inside the beam.
    """

    def __init__(
        self,
        scene: Scene,
        element: FlexibleElement,
        kinds: tuple[str, ...],
        bodies: tuple[int, ...],
        variable: Mapping[str, int],
    ) -> None:
        self.element, self.kinds, self.cutting = element, kinds, Cutting(scene)
        numbers = {body: self.cutting.node(body) for body in sorted({*bodies} - {INSIDE})}
        self.variable = {
            name: self.cutting.expressions((node,), name)[0] for name, node in variable.items()
        }
        # nodes inside of beams come last
        self.bodies = tuple(
            self.cutting.floating(NODE) if body == INSIDE else numbers[body] for body in bodies
        )
        self.system = self.cutting.system_of()

    @property
    def data(self) -> tuple[str, ...]:
        """Names of the entries of p."""
        joints = [f"tree_{n + 1}" for n in range(len(self.cutting.data))]
        ends = [
            f"{name}_{entry}"
            for name, kind in zip(NAMES, self.kinds, strict=False)
            for entry in END_CLASSES[kind].data
        ]
        return (*joints, *self.element.common, *self.element.geometric, *ends)

    def structure(self) -> str:
        """Text that elements on equal places share if and only if the same functions serve both."""
        part = Part("", self.element.name(), self.cutting, self.system)
        return repr((structure(part), self.kinds, self.bodies, self.variable))

    def functions(self, name: str) -> dict[str, Function]:
        """Its functions by what they are, called ``<name>__<function>``."""
        motion, cutting = TreeMotion(Kinematics(self.system)), self.cutting
        states = {x: _numbered(x, entries) for x, entries in (("z", cutting.z), ("s", cutting.s))}
        ends = EndsOnTrees(
            graph=motion.k.graph,
            kinds=self.kinds,
            data=self.data,
            motion_of_tree=motion,
            bodies=self.bodies,
            states=states if self.variable else {},
            variable=self.variable,
        )
        functions = dict(self.element.functions(ends))
        if cutting.moved and {TREE, TREE_OFFSET}.intersection(self.kinds):
            functions["reactions"] = self._reactions(ends)
        return {key: replace(f, name=f"{name}__{key}") for key, f in functions.items()}

    def _reactions(self, ends: EndsOnTrees) -> Function:
        """Shares of the wrenches of the joints that carry its ends."""
        by_end = self.element.functions(replace(ends, by_end=True))["balance"]
        nodes = by_end.outputs[0].nodes
        forces = ends.joint_forces(Matrix(ends.graph, len(nodes), 1, nodes))
        wrenches = self.cutting.joint_wrenches(ends.k, forces)
        output = Output("reactions", (len(self.cutting.moved), 6), wrenches)
        more = ("z", "s", "r") if self.variable else ()
        read = ends.blocks(*("t",) * bool(more), "q", "u", *more, "udot", "p")
        return replace(by_end, outputs=(output,), inputs=read)


def _numbered(letter: str, entries: Sequence[int]) -> Block:
    """Block of internal states or modes that an element reads."""
    names = tuple(f"{letter}{k + 1}" for k in range(len(entries)))
    return Block(letter, names, ("",) * len(names))
