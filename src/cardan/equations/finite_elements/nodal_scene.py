"""A system looked at as nodes and joints with coordinates of their own."""

from __future__ import annotations

from collections.abc import Collection
from functools import cached_property
from typing import TypeAlias

from ...elements.joints.free import Free
from ...elements.joints.joint import Joint as JointElement
from ...elements.joints.joint import Reversed
from ...ir.function import live
from ...ir.graph import ZERO
from ...records import dataclass
from ...topology.conversion import IDENTITY, ORIGIN, parameters_only
from ...topology.system import GROUND, Cut, Force, Nodes, System
from ..constraints.reaction_friction import friction_forces

NODE, JOINT = "node", "joint"
# what a place belongs to: (NODE, body) or (JOINT, joint)
Key: TypeAlias = tuple[str, int]
# speeds of joints that carry an element of a beam, beyond which a node and rows cost less
MAX_PATH_SPEEDS = 12


@dataclass(frozen=True)
class Mass:
    """Mass data of a body: m, m c (3), inertia about the origin (9)."""

    mass: int = ZERO
    first_moment: Nodes = ORIGIN
    inertia: Nodes = (ZERO,) * 9


NOTHING = Mass()


class Scene:
    """Parts of a system as nodes and joints.

    Args:
        system: The system graph.
        nodes: Bodies that have a node of their own where rigid trees have the coordinates of their
            joints; None gives one to every body.
    """

    def __init__(self, system: System, nodes: Collection[int] | None = None) -> None:
        self.system = system
        self._nodes = nodes

    @cached_property
    def joints_of_cuts(self) -> dict[int, Cut]:
        """Bodies that only stand for the far side of a joint that closes a loop, with it."""
        return {cut.carrier: cut for cut in self.system.cuts if cut.carrier is not None}

    @cached_property
    def nodal(self) -> frozenset[int]:
        """Free joints that hold nothing: their coordinates are those of the node they move."""
        acted = {j for force in self.system.forces for j in force.joints.values()}
        return frozenset(
            i
            for i, joint in enumerate(self.system.joints)
            if joint.element == Free()
            and self.system.bodies[i].parent == GROUND
            and (joint.rotation, joint.position) == (IDENTITY, ORIGIN)
            and i not in acted
            and i not in self.joints_of_cuts
        )

    @cached_property
    def in_trees(self) -> frozenset[int]:
        """Bodies that joints alone place: they have no node."""
        if self._nodes is None:
            return frozenset()
        bodies, joints = self.system.bodies, self.system.joints
        return frozenset(
            i
            for i, joint in enumerate(joints)
            if i not in self._nodes
            and i not in self._in_relations
            and i not in self.joints_of_cuts
            and not joint.element.slips
            and i not in self.frictions
            and not (joint.element == Free() and bodies[i].parent == GROUND)
        )

    @cached_property
    def frictions(self) -> dict[int, list[Force]]:
        """Joint -> friction that follows from its reactions: multipliers tell these."""
        frictions: dict[int, list[Force]] = {}
        for force in friction_forces(self.system):
            for i in dict.fromkeys(force.joints.values()):
                frictions.setdefault(i, []).append(force)
        return frictions

    @cached_property
    def _in_relations(self) -> frozenset[int]:
        """Bodies whose motion relations read: their forces pass through nodes."""
        system = self.system
        order = live(system.graph, [entry.node for entry in system.constraints])
        names = {system.graph.nodes[i][1] for i in order if system.graph.nodes[i][0] == "atom"}
        atoms = [system.atoms[name] for name in names if name in system.atoms]
        frames = {
            frame
            for atom in atoms
            if atom.quantity not in ("q", "u")
            for frame in (atom.frame, atom.wrt, atom.in_)
        }
        return frozenset(system.frames[frame].body for frame in frames)

    @cached_property
    def trees(self) -> tuple[tuple[int, ...], ...]:
        """Bodies of every rigid tree, each behind the one that carries it."""
        trees: dict[int, list[int]] = {}
        first: dict[int, int] = {}
        for i in sorted(self.in_trees):
            # branches on one base are trees of their own: they couple through the base alone
            first[i] = first.get(self.system.bodies[i].parent, i)
            trees.setdefault(first[i], []).append(i)
        return tuple(map(tuple, trees.values()))

    @cached_property
    def places(self) -> tuple[Key, ...]:
        """All places, in the order of the tree: a joint with coordinates before its node."""
        keys: list[Key] = []
        for i, joint in enumerate(self.system.joints):
            if joint.q >= 0 and i not in self.nodal:
                keys.append((JOINT, i))
            if i not in self.joints_of_cuts and i not in self.in_trees:
                keys.append((NODE, i))
        return tuple(keys)

    @cached_property
    def parameters_only(self) -> bytearray:
        """1 for every node of the graph that depends on parameters and numbers alone."""
        graph = self.system.graph
        flags = bytearray(len(graph))
        for i in parameters_only(graph, range(len(graph))):
            flags[i] = 1
        return flags

    def name(self, place: Key) -> str:
        """Name of a place: of the joint, or of the body of a node unless a joint is called so."""
        kind, i = place
        if kind == JOINT or i in self.nodal:
            return self.system.joints[i].name
        name = self.system.bodies[i].name
        return f"{name}.node" if name in self._joint_names else name

    @cached_property
    def _joint_names(self) -> frozenset[str]:
        return frozenset(joint.name for joint in self.system.joints)

    def frame(self, number: int) -> int:
        """A frame on a body that is not a node, told by the one it coincides with."""
        cut = self.joints_of_cuts.get(self.system.frames[number].body)
        return number if cut is None else cut.child_frame

    def slot(self, block: str, entry: int) -> tuple[int, int]:
        """Joint and entry within it of an entry of q or u."""
        i = self._owners[block][entry]
        joint = self.system.joints[i]
        return i, entry - (joint.q if block == "q" else joint.u)

    @cached_property
    def _owners(self) -> dict[str, list[int]]:
        owners: dict[str, list[int]] = {"q": [], "u": []}
        for i, joint in enumerate(self.system.joints):
            if joint.q >= 0:
                owners["q"] += [i] * len(joint.element.coordinates)
                owners["u"] += [i] * len(joint.element.speeds)
        return owners

    def line(self, i: int) -> int:
        """Number of coordinates of a joint if they just add up, else 0."""
        element = self.system.joints[i].element
        return len(element.coordinates) if adds_up(element) else 0


def ends_of_beams(system: System) -> frozenset[int]:
    """Bodies that beams begin or end at, or are pulled to."""
    frames = (
        frame
        for s in system.segments
        for frame in (s.frame_a, s.frame_b, *(one.center for one in s.fields))
    )
    return frozenset(system.frames[frame].body for frame in frames) - {GROUND}


def ends_with_nodes(system: System) -> frozenset[int]:
    """Bodies at ends of beams that have a node of their own, held by rows of constraints.

    The others are carried by joints, and the first element of the beam has the coordinates of
    these joints. That takes no prescribed ones, and pays up to some number of speeds. What carries
    the frame of a superelement always has a node.
    """
    carriers = {system.frames[one.frame].body for one in system.superelements} - {GROUND}
    return frozenset(carriers).union(i for i in ends_of_beams(system) if not _short_path(system, i))


def _short_path(system: System, body: int) -> bool:
    """True when few joints carry a body, none of which is prescribed."""
    speeds = 0
    while body != GROUND:
        joint = system.joints[body]
        if joint.motion is not None:
            return False
        if joint.element != Free():
            speeds += len(joint.element.speeds)
        body = system.bodies[body].parent
    return speeds <= MAX_PATH_SPEEDS


def adds_up(element: JointElement) -> bool:
    """True when the speeds of a joint are the rates of its coordinates."""
    if isinstance(element, Reversed):
        return adds_up(element.element)
    methods = (type(element).rates, type(element).integrate)
    return methods == (JointElement.rates, JointElement.integrate)
