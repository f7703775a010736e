"""Constant placements of frames on bodies: R and p as expressions of the parameters."""

from __future__ import annotations

from ..ir.graph import ZERO, Graph
from ..ir.matrix import Matrix
from ..records import dataclass
from .conversion import IDENTITY, ORIGIN, compose
from .system import Nodes


@dataclass(frozen=True)
class Placement:
    """Frame F in frame A: R_AF (9) and p_AF (3) in A axes."""

    rotation: Nodes = IDENTITY
    position: Nodes = ORIGIN

    def then(self, graph: Graph, inner: Placement) -> Placement:
        """F's own frame G, seen from A."""
        if inner is HERE:
            return self
        moved = rotated(graph, self.rotation, inner.position)
        position = tuple([graph.add(a, b) for a, b in zip(self.position, moved, strict=True)])
        return Placement(compose(graph, self.rotation, inner.rotation), position)

    def inverse(self, graph: Graph) -> Placement:
        """A in frame F."""
        if self.rotation == IDENTITY and self.position == ORIGIN:
            return HERE
        r = self.rotation
        back = (r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8])
        moved = rotated(graph, back, self.position)
        return Placement(back, tuple([graph.neg(x) for x in moved]))


HERE = Placement()


def rotated(graph: Graph, rotation: Nodes, vector: Nodes) -> Nodes:
    """R v (3)."""
    if rotation == IDENTITY or vector == ORIGIN:
        return vector
    return (Matrix(graph, 3, 3, rotation) @ Matrix(graph, 3, 1, vector)).nodes


def moved_mass(
    graph: Graph, placement: Placement, mass: int, com: Nodes, inertia: Nodes
) -> tuple[Nodes, Nodes]:
    """First moment (3) and inertia about the outer origin (9) of a body placed in outer axes.

    Args:
        graph: Where the nodes live.
        placement: The body's frame in the outer frame.
        mass: Its mass.
        com: Its center of mass in its own frame (3).
        inertia: Its inertia about the center of mass in its own axes (9).

    Source: parallel-axis theorem, Roberson and Schwertassek, chapter 4.
    """
    g = graph
    center = placement.then(g, Placement(IDENTITY, com)).position
    first = tuple([g.mul(mass, x) for x in center])
    tensor = inertia
    if placement.rotation != IDENTITY and any(inertia):
        rotation = Matrix(g, 3, 3, placement.rotation)
        tensor = rotation.congruence(Matrix(g, 3, 3, inertia)).nodes
    if center == ORIGIN or mass == ZERO:
        return first, tensor
    # I + m (c.c 1 - c c^T)
    x, y, z = center
    fx, fy, fz = first
    add, mul, sub = g.add, g.mul, g.sub
    xx, yy, zz = mul(fx, x), mul(fy, y), mul(fz, z)
    xy, xz, yz = mul(fx, y), mul(fx, z), mul(fy, z)
    i = tensor
    a, b, c = sub(i[1], xy), sub(i[2], xz), sub(i[5], yz)
    return first, (
        add(i[0], add(yy, zz)), a, b,
        a, add(i[4], add(xx, zz)), c,
        b, c, add(i[8], add(xx, yy)),
    )  # fmt: skip
