"""The graph of a scene for people: its matrices, its tree, its drawings.

Vertices are bodies (the ground is vertex 0), arcs are joints directed from parent to child.

Source: Roberson and Schwertassek, Dynamics of Multibody Systems, chapter 8; Wittenburg, Dynamics
of Multibody Systems, section 5.3.
"""

from __future__ import annotations

from dataclasses import field
from itertools import pairwise

from ...records import dataclass
from ...scene.beam import Beam
from ...scene.body import Body
from ...scene.connections import Joint
from ...scene.scene import SceneRecord
from ..beams.beam_nodes import shares
from ..beams.nodal_scene import with_beams
from ..cables.cable_parts import with_joined_nodes
from ..superelements.superelement_parts import with_superelements
from ..tree import Branch, loop, spanning_tree
from . import drawing
from .labeled_matrix import Labelled


@dataclass(frozen=True)
class GraphView:
    """Bodies and joints as a graph; ``print`` draws the tree.

    Attributes:
        name: Of the model.
        bodies: Names of the bodies, ground first.
        branches: The joints of the spanning tree in regular order.
        closing: The joints that close loops, and are cut.
        reasons: Why each of them was chosen.
        beams: Every cable, and every piece of a beam between named nodes, which are bodies here.
        flexible: Bodies that are parts of one superelement, whose mass is of all of them.
    """

    name: str
    bodies: tuple[str, ...]
    branches: tuple[Branch, ...] = field(repr=False)
    closing: tuple[Joint, ...] = ()
    reasons: tuple[str, ...] = ()
    beams: tuple[drawing.BeamArc, ...] = ()
    flexible: tuple[tuple[str, ...], ...] = ()

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of all joints: tree joints first, then those that close loops."""
        return tuple(joint.name for joint in self._joints)

    @property
    def _joints(self) -> tuple[Joint, ...]:
        return (*(branch.joint for branch in self.branches), *self.closing)

    @property
    def incidence(self) -> Labelled:
        """Bodies x joints: +1 where the joint leaves the body, -1 where it arrives."""
        rows = tuple(
            tuple((j.parent.body.name == b) - (j.child.body.name == b) for j in self._joints)
            for b in self.bodies
        )
        return Labelled(self.bodies, self.joints, rows, "incidence: +1 leaves, -1 arrives")

    @property
    def path(self) -> Labelled:
        """Tree joints x bodies: -1 (+1) where the path from the ground runs along (against) it.

        It is the inverse of the incidence matrix of the tree without the row of the ground.
        """
        paths = self._paths()
        bodies = tuple(b.outer.name for b in self.branches)
        rows = tuple(
            tuple((1 if k.reversed else -1) if k in paths[b] else 0 for b in bodies)
            for k in self.branches
        )
        names = tuple(k.joint.name for k in self.branches)
        return Labelled(names, bodies, rows, "path: -1 from the ground along the joint")

    @property
    def circuit(self) -> Labelled:
        """Loops x joints: +1 (-1) where the loop runs along (against) the joint."""
        tree = list(self.branches)
        rows = []
        for closing in self.closing:
            signs = dict.fromkeys(self.joints, 0)
            # from the child of the closing joint back to its parent
            at = closing.child.body
            signs[closing.name] = 1
            ring = loop(tree, closing)
            start = ring.index(closing)
            for joint in (*ring[start + 1 :], *ring[:start]):
                along = joint.parent.body is at
                signs[joint.name] = 1 if along else -1
                at = joint.child.body if along else joint.parent.body
            rows.append(tuple(signs.values()))
        names = tuple(joint.name for joint in self.closing)
        return Labelled(names, self.joints, tuple(rows), "loop: +1 along, -1 against")

    @property
    def spanning_tree(self) -> tuple[tuple[str, str, str], ...]:
        """(joint, inner body, outer body) in regular order."""
        return tuple((b.joint.name, b.inner.name, b.outer.name) for b in self.branches)

    @property
    def mass_pattern(self) -> Labelled:
        """Blocks of the mass matrix by joint: 1 where some body is moved by both joints.

        The zeros are those that branches induce; they hold for every value of the parameters.

        Source: Featherstone, Rigid Body Dynamics Algorithms, section 6.4.
        """
        moving: list[str] = []
        leaders: dict[str, str | None] = {}
        for branch in self.branches:
            joint = branch.joint
            if joint.couple is not None:
                leaders[joint.name] = joint.couple.leader
            elif joint.prescribed is None and joint.kind.coordinates:
                leaders[joint.name] = joint.name
                moving.append(joint.name)
        coupled: set[tuple[str, str]] = set()
        paths = self._paths()
        shared = (frozenset[Branch]().union(*(paths[b] for b in one)) for one in self.flexible)
        for path in (*paths.values(), *shared):
            moved = {_leader(leaders, branch.joint.name) for branch in path} - {None}
            coupled |= {(a, b) for a in moved for b in moved if a and b}
        rows = tuple(tuple(int((a, b) in coupled) for b in moving) for a in moving)
        return Labelled(tuple(moving), tuple(moving), rows, "mass matrix: blocks by joint")

    def _paths(self) -> dict[str, frozenset[Branch]]:
        """Body -> the branches on its path from the ground."""
        paths: dict[str, frozenset[Branch]] = {"ground": frozenset()}
        for branch in self.branches:
            paths[branch.outer.name] = paths[branch.inner.name] | {branch}
        return {branch.outer.name: paths[branch.outer.name] for branch in self.branches}

    def __str__(self) -> str:
        return drawing.text(self.branches, self.closing, self.beams)

    def dot(self) -> str:
        """The graph in the language of Graphviz."""
        return drawing.dot(self.name, self.bodies, self.branches, self.closing, self.beams)

    def svg(self) -> str:
        """A picture of the tree with its loops dashed, and beams as thick lines."""
        return drawing.svg(self.bodies, drawing.arcs(self.branches, self.closing, self.beams))

    def _repr_svg_(self) -> str:
        return self.svg()

    def _repr_html_(self) -> str:
        """The picture in the colors of the page: pictures alone are black on dark pages too."""
        return self.svg()


def view(model: SceneRecord) -> GraphView:
    """The graph of a model; bodies that nothing joins to the ground are left out of the tree."""
    scene, _ = with_beams(with_superelements(with_joined_nodes(model)))
    branches, closing = spanning_tree(scene)
    bodies: list[Body] = [scene.ground, *scene.bodies.values()]
    names, cut = tuple(b.name for b in bodies), tuple(c.joint for c in closing)
    reasons = tuple(c.reason for c in closing)
    beams = [arc for beam in model.beams.values() for arc in _beam_arcs(beam)]
    for cable in model.cables.values():
        ends = cable.start.body.name, cable.end.body.name
        beams.append(drawing.BeamArc("cable", cable.name, *ends, cable.elements))
    on_tree = {branch.outer.name for branch in branches}
    flexible = tuple(
        tuple(name for name in (*one.places, one.modes_body) if name in on_tree)
        for one in model.superelements.values()
    )
    return GraphView(model.name, names, tuple(branches), cut, reasons, tuple(beams), flexible)


def _beam_arcs(beam: Beam) -> list[drawing.BeamArc]:
    """The pieces of a beam from each of its named nodes to the next."""
    inner = [beam.model.nodes[name] for _, name in sorted((s, n) for n, s in beam.stops.items())]
    bodies = [place.body.name for place in (beam.start, *inner, beam.end)]
    counts = shares(beam.elements, [0.0, *sorted(beam.stops.values()), 1.0])
    spans = zip(pairwise(bodies), counts, strict=True)
    return [drawing.BeamArc("beam", beam.name, *ends, count) for ends, count in spans]


def _leader(leaders: dict[str, str | None], joint: str) -> str | None:
    """The joint with coordinates that moves a joint, None where nothing does."""
    for _ in leaders:
        leader = leaders.get(joint)
        if leader is None or leader == joint:
            return leader
        joint = leader
    return None
