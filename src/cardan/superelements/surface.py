"""What one sees of a component: points that its nodes carry, triangles and lines between them."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Array, Integers
from ..errors import ModelError, brief, counted
from ..records import dataclass
from .node_dofs import NodeDofs
from .values import numbers

# of a picture, far more than a screen shows; meshes with more are coarsened
MOST_TRIANGLES = 200_000
MOST_POINTS = 200_000


@dataclass(frozen=True, eq=False)
class Surface:
    """Points that nodes carry, and what is drawn between them.

    Attributes:
        nodes: Place of the node of each point (points,).
        arms: From the node to the point (points, 3) [m]; they turn with nodes that have rotations.
        triangles: Points of triangles (triangles, 3), counterclockwise from outside.
        lines: Points of lines (lines, 2).
    """

    nodes: Integers
    arms: Array
    triangles: Integers
    lines: Integers

    def __post_init__(self) -> None:
        for array in (self.nodes, self.arms, self.triangles, self.lines):
            array.setflags(write=False)

    def points(self, dofs: NodeDofs) -> Array:
        """Positions of the points of the undeformed component (points, 3) [m]."""
        positions: Array = dofs.positions[self.nodes] + self.arms
        return positions

    def basis(self, shapes: Array, dofs: NodeDofs) -> Array:
        """Displacements of the points by the coordinates of a component.

        Args:
            shapes: Displacements of the rows of the nodes by the coordinates (rows, n).
            dofs: Of the rows.

        Returns:
            (points, 3, n) [m]; 0 along axes along which a node has no row.
        """
        row = np.full((len(dofs.positions), 6), -1)
        row[dofs.node, dofs.component] = np.arange(len(dofs))
        of_point = row[self.nodes]
        motions = np.where((of_point >= 0)[:, :, None], shapes[of_point], 0.0)
        moved: Array = motions[:, :3]
        if self.arms.any():
            turns = np.cross(motions[:, 3:].transpose(0, 2, 1), self.arms[:, None])
            moved = moved + turns.transpose(0, 2, 1)
        return moved


def joined(nodes: Integers, triangles: Integers, lines: Integers) -> Surface:
    """A surface between nodes of a component.

    Args:
        nodes: Places of nodes that are shown anyway.
        triangles, lines: Between places of nodes (triangles, 3), (lines, 2).
    """
    every = np.unique(np.concatenate([nodes, triangles.ravel(), lines.ravel()]))
    ends = (np.searchsorted(every, one).astype(np.intp) for one in (triangles, lines))
    return Surface(every, np.zeros((len(every), 3)), *ends)


def surface_of(
    dofs: NodeDofs, triangles: ArrayLike | None = None, lines: ArrayLike | None = None
) -> Surface:
    """A surface by numbers of nodes; all nodes where no triangles are given.

    Args:
        dofs: Nodes of the component.
        triangles, lines: Numbers of nodes (triangles, 3), (lines, 2).

    Raises:
        ModelError: nodes that do not exist, another shape, or too many.
    """
    faces, edges = _ends("triangles", triangles, 3, dofs), _ends("lines", lines, 2, dofs)
    every = sampled(0 if len(faces) else len(dofs.positions))
    return joined(every, faces, edges)


def sampled(count: int) -> Integers:
    """Places of nodes that are shown: all, or every k-th where they are too many."""
    return np.arange(0, count, max(1, -(-count // MOST_POINTS)))


def _ends(who: str, values: ArrayLike | None, width: int, dofs: NodeDofs) -> Integers:
    """Places of nodes by their numbers."""
    if values is None:
        return np.zeros((0, width), np.intp)
    rows = numbers(who, values)
    if not rows.size:
        return np.zeros((0, width), np.intp)
    if rows.ndim != 2 or rows.shape[1] != width or (rows != np.floor(rows)).any():
        raise ModelError(
            f"{who}={brief(values)}: shape {rows.shape}; give node numbers ({who}, {width})"
        )
    if len(rows) > MOST_TRIANGLES:
        raise ModelError(
            f"{who}: {counted(len(rows), 'row')}, at most {MOST_TRIANGLES} are drawn; give fewer"
        )
    return dofs.places(rows.astype(np.intp).ravel(), who).reshape(-1, width)
