"""Scenes with beams: their nodes become bodies, and joints come in an order in which places follow.

Where a node is follows from its beam, and where that is from what its ends are joined to. Joints
are taken one after the other from the ground; where none leads on, the nodes of a beam whose ends
have their places do, and then bodies with a pose.
"""

from __future__ import annotations

import copy
from collections import deque
from dataclasses import field
from heapq import heappop, heappush

from ...elements.joints.free import Free
from ...elements.joints.joint import Joint as JointElement
from ...errors import TopologyError
from ...records import dataclass
from ...scene.beam import Beam
from ...scene.body import Body
from ...scene.connections import Joint
from ...scene.scene import SceneRecord


@dataclass(frozen=True)
class BeamNodes:
    """Data of added nodes for the build.

    Attributes:
        beams: Node -> its beam.
        implicit: Names of the joints that let a node, or a body that only beams hold, move freely.
        releases: Names of the joints of released ends.
        unplaced: Beams whose places do not follow from anything, with the bodies they wait for.
    """

    beams: dict[Body, Beam] = field(default_factory=dict)
    implicit: set[str] = field(default_factory=set)
    releases: set[str] = field(default_factory=set)
    unplaced: dict[Beam, set[Body]] = field(default_factory=dict)

    def check(self) -> None:
        """Every beam has a place.

        Raises:
            TopologyError: one hangs on a body without a place.
        """
        for beam, homes in self.unplaced.items():
            name = next(iter(homes)).name
            raise TopologyError(
                f"beam '{beam.name}': nothing says where body '{name}' is, to which it is joined. "
                "Give it pose=, its place in the reference configuration, or join it to something "
                "else"
            )


def with_beams(model: SceneRecord) -> tuple[SceneRecord, BeamNodes]:
    """The model with the nodes of its beams as bodies.

    Returns:
        The model itself where there are no beams, else a copy; and what was added.
    """
    nodes = BeamNodes()
    if not model.beams:
        return model, nodes
    extended = copy.copy(model)
    extended.bodies = dict(model.bodies)
    for beam in model.beams.values():
        for body in node_bodies(beam):
            extended.bodies[body.name] = body
            nodes.beams[body] = beam
    growth = _Growth(model, nodes)
    growth.run()
    extended.joints = growth.ordered | {
        name: joint for name, joint in model.joints.items() if name not in growth.ordered
    }
    return extended, nodes


def node_bodies(beam: Beam) -> list[Body]:
    """The nodes of a beam that are not frames of the user."""
    names = (f"{beam.name}.start", f"{beam.name}.end", *beam.stops)
    places = ((name, beam.model.nodes[name]) for name in names)
    return [place.body for name, place in places if place.name == name]


def _homes(beam: Beam) -> set[Body]:
    """Bodies that a beam hangs on."""
    homes = {end.place.body for end in beam.ends if end.place is not None}
    return homes if beam.base is None else homes | {beam.base}


class _Growth:
    """Takes joints in an order in which every place follows from those before."""

    def __init__(self, model: SceneRecord, nodes: BeamNodes) -> None:
        self.model = model
        self.nodes = nodes
        self.joints = [joint for joint in model.joints.values() if not joint.cut]
        self.at: dict[Body, list[int]] = {}
        for k, joint in enumerate(self.joints):
            self._attach(k, joint)
        self.ordered: dict[str, Joint] = {}
        # beams, with the bodies that they wait for, and the other way round
        self.waiting = {beam: _homes(beam) for beam in model.beams.values()}
        self.awaited: dict[Body, list[Beam]] = {}
        for beam, homes in self.waiting.items():
            for body in homes:
                self.awaited.setdefault(body, []).append(beam)
        self.ready = [beam for beam, homes in self.waiting.items() if not homes]
        # nodes whose beams have their places; nodes to be reached, in the order of their beams
        self.in_tree: set[Body] = set()
        self.pending: deque[Body] = deque()
        self.connected: set[Body] = set()
        self.open: list[int] = []

    def _attach(self, k: int, joint: Joint) -> None:
        for place in (joint.parent, joint.child):
            self.at.setdefault(place.body, []).append(k)

    def run(self) -> None:
        """Reach what can be reached; bodies without beams that hang nowhere are left."""
        self._reach(self.model.ground)
        while self._grown() or self._place_beam_nodes() or self._floated():
            pass
        self.nodes.unplaced.update(self.waiting)

    def _reach(self, body: Body) -> None:
        self.connected.add(body)
        for beam in self.awaited.get(body, ()):
            self.waiting[beam].discard(body)
            if not self.waiting[beam]:
                self.ready.append(beam)
        for k in self.at.get(body, ()):
            heappush(self.open, k)

    def _grown(self) -> bool:
        """Joints that lead on from what is reached."""
        before = len(self.ordered)
        while self.open:
            joint = self.joints[heappop(self.open)]
            ends = (joint.parent.body, joint.child.body)
            if joint.name in self.ordered or any(
                body in self.nodes.beams and body not in self.in_tree for body in ends
            ):
                continue
            self.ordered[joint.name] = joint
            for body in ends:
                if body not in self.connected:
                    self._reach(body)
        return len(self.ordered) > before

    def _place_beam_nodes(self) -> bool:
        """Beams whose ends have their places: so do their nodes."""
        ready, self.ready = self.ready, []
        for beam in ready:
            del self.waiting[beam]
            node_bodies_here = node_bodies(beam)
            self.in_tree.update(node_bodies_here)
            self.pending += node_bodies_here
            for name, kind in beam.releases().items():
                end = beam.ends[name == f"{beam.name}.end"]
                assert end.place is not None
                self._released(name, kind, end.place.body)
            for body in node_bodies_here:
                for k in self.at.get(body, ()):
                    if self._touched(k):
                        heappush(self.open, k)
        return bool(ready)

    def _touched(self, k: int) -> bool:
        joint = self.joints[k]
        return joint.parent.body in self.connected or joint.child.body in self.connected

    def _released(self, name: str, kind: JointElement, body: Body) -> None:
        """The joint of an end that is not clamped."""
        joint = Joint(self._unwritten(name), kind, body, self.model.nodes[name])
        self.joints.append(joint)
        self.nodes.releases.add(joint.name)
        self._attach(len(self.joints) - 1, joint)

    def _unwritten(self, name: str) -> str:
        """A name, or one like it where the user gave that to a joint."""
        while name in self.model.joints or name in self.ordered:
            name += "_"
        return name

    def _floated(self) -> bool:
        """The next node that no joint reaches, or body with a pose that a beam waits for."""
        while self.pending and self.pending[0] in self.connected:
            self.pending.popleft()
        if self.pending:
            body = self.pending.popleft()
        else:
            posed = (b for homes in self.waiting.values() for b in homes if b.pose is not None)
            floating = next(posed, None)
            if floating is None:
                return False
            body = floating
        name = self._unwritten(body.name)
        self.ordered[name] = Joint(name, Free(), self.model.ground, body)
        self.nodes.implicit.add(name)
        self._reach(body)
        return True
