"""States of the relative formulation as states of nodes and joints.

A visit of every body carries pose and velocity on from its parent. One step serves all bodies with
a joint of one kind; it is derived from a small system of such a body on one that moves freely.
"""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from functools import partial
from typing import NamedTuple

from ...ir.arithmetic import atan2
from ...ir.function import Block, Function, Output, live
from ...ir.graph import Graph
from ...ir.matrix import Matrix
from ...ir.recursion import OUT, STORE, Recursion, Sweep, Visit
from ...ir.rewrite import rebuild
from ...ir.strided_visits import as_turns
from ...spatial.exponential import quaternion_of
from ...spatial.plane import Plane
from ...topology.system import GROUND
from ..constraints.constraints import Constraints
from ..functions.blocks import blocks
from ..kinematics.kinematics import Kinematics
from ..recursion.recursion_boundary import Cuts
from .element_systems import Cutting
from .member_keys import MemberKeys
from .nodal_scene import JOINT, NODE, Scene

ASSEMBLY_SIGNS = "assembly_signs "  # before the name of the joint
READ = ("t", "q", "u", "r", "p")
# what a body hands on, and where it begins among that: as Kinematics names it
FIELDS = {"orientation": 0, "position": 9, "omega": 12, "v": 15}
HANDED = 18
# of the small system of a step: the body that moves freely
PARENT = 0
# an input by its name and entry; of the store the field of the parent
Leaf = tuple[str, int]


def states(
    scene: Scene, planes: Mapping[int, Plane] | None = None, tree_ends: Sequence[int] = ()
) -> Recursion:
    """[t, q, u, r, p] of the relative formulation -> [q, u] of all places.

    Args:
        scene: The scene.
        planes: By body those nodes that are told by x, y and angle in a plane.
        tree_ends: Bodies of rigid trees that beams end at: ``ends_q`` and ``ends_u`` are their
            poses (n, 7) and speeds (n, 6) as of nodes.

    Nodes stand where the joints of the tree carry them; coordinates of joints stay what they are.
    ``assembly_signs <joint>`` of a joint that closes a loop are positive where none of its axes is
    reversed.
    """
    return _States(scene, planes or {}, tree_ends).recursion()


class _Results(NamedTuple):
    """Results of the visit of a body beside what it hands on.

    Attributes:
        coordinates: Whether those of its joint are states.
        nodes: Its node, if it has one: the plane of one that is told in a plane, else None.
        ends: Number of the beams of rigid trees that end at it.
    """

    coordinates: bool
    nodes: tuple[Plane | None, ...]
    ends: int


class _Step(NamedTuple):
    """A step and what its first visit reads.

    Attributes:
        number: Of the step.
        reads: Block -> for every local entry its number among the inputs of a motion, or the
            field of the parent.
    """

    number: int
    reads: dict[str, tuple[int, ...]]


class _States:
    """Collects steps and visits.

    Args:
        scene, planes, tree_ends: As of :func:`states`.
    """

    def __init__(self, scene: Scene, planes: Mapping[int, Plane], tree_ends: Sequence[int]) -> None:
        self.scene, self.system = scene, scene.system
        self.planes, self.tree_ends = planes, tree_ends
        self.keys = MemberKeys(scene)
        self.steps: list[Function] = []
        self._by_key: dict[Hashable, _Step] = {}
        self._numbers: dict[Hashable, int] = {}
        self._firsts = self._places()

    def _is_free(self, i: int) -> bool:
        """True for a node that has the coordinates of its joint."""
        return i in self.scene.nodal and i not in self.planes

    def _places(self) -> dict[tuple[str, int], tuple[int, int]]:
        """First coordinate and speed of every place; sizes of the blocks as q_size, u_size."""
        firsts, q, u = dict[tuple[str, int], tuple[int, int]](), 0, 0
        for key in self.scene.places:
            firsts[key] = q, u
            kind, i = key
            if kind == JOINT or self._is_free(i):
                element = self.system.joints[i].element
                nq, nu = len(element.coordinates), len(element.speeds)
            else:
                nq, nu = (3, 3) if i in self.planes else (7, 6)
            q, u = q + nq, u + nu
        self.q_size, self.u_size = q, u
        return firsts

    def recursion(self) -> Recursion:
        """The states as visits of all bodies, then those of signs of loops."""
        system, listed = self.system, blocks(self.system)
        outputs = [Output("q", (self.q_size,), ()), Output("u", (self.u_size,), ())]
        count = len(self.tree_ends)
        if count:
            outputs += [Output("ends_q", (count, 7), ()), Output("ends_u", (count, 6), ())]
        visits = [self._visit(i) for i in range(len(system.bodies))]
        sweeps = [Sweep("outward", as_turns(visits))]
        if system.cuts:
            at = sum(o.size for o in outputs)
            signs, visit = self._signs(at)
            outputs += signs
            sweeps.append(Sweep("after the sweeps", (visit,)))
        return Recursion(
            "states",
            tuple(listed[letter] for letter in READ),
            tuple(outputs),
            tuple(self.steps),
            tuple(sweeps),
            HANDED * len(system.bodies),
            "states of the nodes and joints by joint coordinates",
        )

    # visits

    def _results(self, i: int) -> _Results:
        free = self._is_free(i)
        nodes = (self.planes.get(i),) * ((NODE, i) in self._firsts and not free)
        return _Results(free or (JOINT, i) in self._firsts, nodes, self.tree_ends.count(i))

    def _outs(self, i: int, results: _Results) -> tuple[int, ...]:
        """Entries of all results that the visit of a body gives."""
        entries = list[int]()
        element = self.system.joints[i].element

        def add(first: int, count: int) -> None:
            entries.extend(range(first, first + count))

        if results.coordinates:
            q, u = self._firsts[(NODE if self._is_free(i) else JOINT), i]
            add(q, len(element.coordinates))
            add(self.q_size + u, len(element.speeds))
        for plane in results.nodes:
            q, u = self._firsts[NODE, i]
            nq, nu = (7, 6) if plane is None else (3, 3)
            add(q, nq)
            add(self.q_size + u, nu)
        at, ends = self.q_size + self.u_size, len(self.tree_ends)
        for k in (k for k, end in enumerate(self.tree_ends) if results.ends and end == i):
            add(at + 7 * k, 7)
            add(at + 7 * ends + 6 * k, 6)
        return tuple(entries)

    def _visit(self, i: int) -> Visit:
        """The visit of a body, with a step of its own where no other one does the same."""
        results, motion = self._results(i), self.keys.motion(i)
        stores = tuple(range(HANDED * i, HANDED * (i + 1)))
        outs, parent = self._outs(i, results), self.system.bodies[i].parent
        if motion is None:
            number, reads = self._derived(i, results)
            return Visit(number, reads, stores, outs)
        key, inputs = (motion.key, results), motion.inputs
        step = self._by_key.get(key)
        if step is None:
            number, reads = self._derived(i, results)
            numbers = {
                block: tuple(
                    k - HANDED * parent if block == STORE else inputs.index((block, k)) for k in of
                )
                for block, of in reads.items()
            }
            step = self._by_key[key] = _Step(number, numbers)
        entries = {
            block: tuple([HANDED * parent + k for k in of])
            if block == STORE
            else tuple([inputs[k][1] for k in of])
            for block, of in step.reads.items()
        }
        return Visit(step.number, entries, stores, outs)

    # steps

    def _derived(self, i: int, results: _Results) -> tuple[int, dict[str, tuple[int, ...]]]:
        """Number of the step of a body, and the entries that it reads there."""
        parent = self.system.bodies[i].parent
        cutting = Cutting(self.scene)
        base = GROUND if parent == GROUND else cutting.floating("parent")
        body = cutting.moving_body(i, base)
        cut = partial(Cuts, every=True, bodies=() if base == GROUND else (PARENT,))
        k = Kinematics(cutting.system_of(), cut=cut)
        handed = (k.ground_rotation, k.ground_position, k.omega, k.v)
        stored = [node for part in handed for node in part[body].nodes]
        outs = list[int]()
        if results.coordinates:
            outs += [*k.coordinates[body].nodes, *k.speeds[body].nodes]
        for plane in results.nodes:
            pairs = _in_space(k, body) if plane is None else _in_plane(plane, k, body)
            outs += [node for part in pairs for node in part]
        for _ in range(results.ends):
            outs += [node for part in _in_space(k, body) for node in part]
        graph, roots = self._in_scene(cutting, k, (*stored, *outs))
        reads = _entries(graph, roots)
        if STORE in reads:
            reads[STORE] = tuple(HANDED * parent + n for n in reads[STORE])
        joint = self.system.joints[i]
        about = f"{self.system.bodies[i].name}, {joint.element.kind} joint {joint.name}"
        return self._numbered(graph, roots, len(stored), about), reads

    def _in_scene(
        self, cutting: Cutting, k: Kinematics, nodes: Sequence[int]
    ) -> tuple[Graph, list[int]]:
        """Expressions of a small system in inputs of the scene and in fields of the parent."""
        graph = Graph()
        graph.tables = k.graph.tables.copy()
        assert k.cuts is not None
        slots = cutting.slots()
        replacements = dict[int, int]()
        for i in _leaves(k.graph, nodes):
            block, entry = k.graph.nodes[i][1:]
            if block == STORE:
                field, component = k.cuts.definitions[i].field
                replacements[i] = graph.var(STORE, FIELDS[field] + component)
            elif block == "p":
                datum = [cutting.data[entry]]
                replacements[i] = rebuild(self.system.graph, datum, into=graph)[1][0]
            elif block in ("q", "u"):
                replacements[i] = graph.var(block, slots[block, entry])
        return graph, rebuild(k.graph, nodes, replacements, into=graph)[1]

    def _signs(self, first: int) -> tuple[list[Output], Visit]:
        """Signs of the axes of joints that close loops, by coordinates and parameters."""
        k = Kinematics(self.system)
        owners, signs = Constraints(k).assembly_signs
        numbers = {owner: owners.count(owner) for owner in dict.fromkeys(owners)}
        names = sorted(range(len(owners)), key=lambda n: list(numbers).index(owners[n]))
        graph, roots = rebuild(k.graph, [signs.nodes[n] for n in names])
        reads = _entries(graph, roots)
        number = self._numbered(graph, roots, 0, "axes of joints that close loops")
        outputs = [
            Output(f"{ASSEMBLY_SIGNS}{owner}", (count,), ()) for owner, count in numbers.items()
        ]
        return outputs, Visit(number, reads, (), tuple(range(first, first + len(roots))))

    def _numbered(self, graph: Graph, roots: Sequence[int], stored: int, about: str) -> int:
        """Number of a step, made unless there is one that does the same."""
        entries = _entries(graph, roots)
        local = Graph()
        local.tables = graph.tables.copy()
        names = {(block, e): n for block, of in entries.items() for n, e in enumerate(of)}
        copies = {
            i: local.var(graph.nodes[i][1], names[graph.nodes[i][1:]])
            for i in _leaves(graph, roots)
        }
        _, nodes = rebuild(graph, roots, copies, into=local)
        sizes = tuple((block, len(of)) for block, of in entries.items())
        key = (sizes, tuple(local.nodes), tuple(nodes), stored)
        if key not in self._numbers:
            self._numbers[key] = number = len(self.steps)
            inputs = tuple(
                Block(block, tuple(f"{block}.{n}" for n in range(size)), ("",) * size)
                for block, size in sizes
            )
            outputs = (
                Output(STORE, (stored,), tuple(nodes[:stored])),
                Output(OUT, (len(nodes) - stored,), tuple(nodes[stored:])),
            )
            name = f"states_{number + 1}"
            self.steps.append(Function(name, local, inputs, outputs, (), about))
        return self._numbers[key]


def _leaves(graph: Graph, roots: Sequence[int]) -> list[int]:
    """Inputs that expressions read."""
    return [i for i in live(graph, roots) if graph.nodes[i][0] == "var"]


def _entries(graph: Graph, roots: Sequence[int]) -> dict[str, tuple[int, ...]]:
    """Entries of every block that expressions read, in the order of the blocks."""
    entries: dict[str, list[int]] = {}
    for i in _leaves(graph, roots):
        block, entry = graph.nodes[i][1:]
        entries.setdefault(block, []).append(entry)
    order = [block for block in (*READ, STORE) if block in entries]
    return {block: tuple(sorted(entries[block])) for block in order}


def _in_space(k: Kinematics, i: int) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Unit quaternion and position of a body, angular velocity in its axes and velocity."""
    R = k.ground_rotation[i]
    pose = Matrix.vstack(quaternion_of(R), k.ground_position[i])
    return pose.nodes, Matrix.vstack(k.omega[i], R @ k.v[i]).nodes


def _in_plane(plane: Plane, k: Kinematics, i: int) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """x, y, angle of a body and their rates."""
    R, p = k.ground_rotation[i], k.ground_position[i]
    to_space = Matrix.of(k.graph, plane.to_space.tolist())
    rotation = R @ Matrix.of(k.graph, plane.rotation.T.tolist())
    a, b = plane.along
    angle = atan2(rotation[b, a], rotation[a, a])
    rates = to_space.T @ Matrix.vstack(k.omega[i], R @ k.v[i])
    return (p[a].node, p[b].node, angle.node), rates.nodes
