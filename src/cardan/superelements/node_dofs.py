"""Which motion of which node stands in which row of the matrices of a component."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Array, Integers
from ..errors import ModelError, brief, counted
from ..records import dataclass
from .values import numbers as numbers_of

# displacements along the axes of the component, then small rotations about them
COMPONENTS = ("x", "y", "z", "rx", "ry", "rz")
ORDERS = ("node", "component")
FARTHEST = 1e30  # so that squares of distances do not overflow [m]


@dataclass(frozen=True)
class NodeDofs:
    """Nodes of a component, and which motion of which of them each row of its matrices is.

    Attributes:
        positions: Of the nodes (n_nodes, 3) [m].
        ids: Numbers by which users name the nodes (n_nodes,).
        node: Place of the node of each row (n,).
        component: Place of its motion in ``COMPONENTS`` (n,).
    """

    positions: Array
    ids: Integers
    node: Integers
    component: Integers

    def __len__(self) -> int:
        return len(self.node)

    def label(self, row: int) -> str:
        """A row in messages, such as ``node 17 rz``."""
        return f"node {self.ids[self.node[row]]} {COMPONENTS[self.component[row]]}"

    def rigid(self, about: Array, rows: Integers | None = None) -> Array:
        """Displacements of the rows by unit motions of a rigid body.

        Args:
            about: Point that rotations leave where it is (3,).
            rows: The rows that are meant; all by default.

        Returns:
            (n, 6), in the order of ``COMPONENTS``.
        """
        node = self.node if rows is None else self.node[rows]
        component = self.component if rows is None else self.component[rows]
        return rigid_rows(self.positions[node] - about, component)

    def places(self, ids: Iterable[object], who: str) -> Integers:
        """Places of nodes that users name.

        Raises:
            ModelError: a node that does not exist.
        """
        place = {int(number): k for k, number in enumerate(self.ids)}
        numbers = [*ids]
        result = []
        for one in numbers:
            number = int(one) if isinstance(one, int | np.integer) else one
            if not isinstance(number, int) or isinstance(one, bool) or number not in place:
                first, last = min(place), max(place)
                raise ModelError(
                    f"{who}: there is no node {brief(number)}. Its {counted(len(place), 'node')} "
                    f"have numbers from {first} to {last}"
                )
            result.append(place[number])
        return np.array(result, dtype=np.intp)

    def rows_of(self, nodes: Integers) -> Integers:
        """Rows of some nodes, in their order in the matrices."""
        return np.flatnonzero(np.isin(self.node, nodes))


def rigid_rows(arms: Array, component: Integers) -> Array:
    """Motions (n, 6) of points of a rigid body by its unit translations and rotations.

    Args:
        arms: From the point that does not move to each point (n, 3) [m].
        component: Which motion of the point is meant, in ``COMPONENTS`` (n,).
    """
    rows = np.zeros((len(arms), 6))
    rows[np.arange(len(arms)), component] = 1.0
    moved = np.flatnonzero(component < 3)
    # w x arm along an axis, w about the other two
    after, before = (component[moved] + 1) % 3, (component[moved] + 2) % 3
    rows[moved, 3 + after] = arms[moved, before]
    rows[moved, 3 + before] = -arms[moved, after]
    return rows


def component_names(text: str | Sequence[str], who: str) -> tuple[int, ...]:
    """Places in ``COMPONENTS`` of names such as ``"x y rz"``.

    Raises:
        ModelError: a name that does not exist, or one twice.
    """
    names = text.replace(",", " ").split() if isinstance(text, str) else [*text]
    wrong = [name for name in names if name not in COMPONENTS]
    if wrong or len(set(names)) != len(names) or not names:
        raise ModelError(
            f"{who}={brief(text)}: give names out of {', '.join(COMPONENTS)}, each at most once, "
            "such as 'x y rz'"
        )
    return tuple(COMPONENTS.index(name) for name in names)


def positions_of(nodes: ArrayLike, ids: Sequence[int] | None) -> tuple[Array, Integers]:
    """Positions and numbers of nodes, checked.

    Raises:
        ModelError: another shape, a position that is not finite, or a number twice.
    """
    positions = numbers_of("nodes", nodes)
    if positions.ndim != 2 or positions.shape[1] != 3 or not len(positions):
        raise ModelError(
            f"nodes: shape {positions.shape}, expected (number of nodes, 3): a position [m] for "
            "each node; give z = 0 to those in a plane"
        )
    numbers = np.arange(len(positions)) if ids is None else np.asarray(ids)
    if numbers.shape != (len(positions),) or numbers.dtype.kind not in "iu":
        raise ModelError(
            f"node_ids: shape {numbers.shape} of {numbers.dtype}, expected a whole number for each "
            f"of the {counted(len(positions), 'node')}"
        )
    unique, count = np.unique(numbers, return_counts=True)
    if (count > 1).any():
        raise ModelError(f"node_ids: node {unique[count > 1][0]} is there twice; number it anew")
    bad = np.flatnonzero(~(abs(positions) < FARTHEST).all(axis=1))
    if len(bad):
        raise ModelError(
            f"nodes: the position of node {numbers[bad[0]]} is {positions[bad[0]]}; give finite "
            f"numbers below {FARTHEST:g} [m]"
        )
    return positions, numbers.astype(np.intp)


def number_rows(
    nodes: ArrayLike,
    size: int,
    *,
    node_ids: Sequence[int] | None = None,
    node_dofs: str | Sequence[str] | None = None,
    order: str = "node",
    dofs: Sequence[tuple[int, str]] | None = None,
) -> NodeDofs:
    """Rows of matrices of a size, numbered.

    Args:
        nodes: Positions (n_nodes, 3) [m].
        size: Rows of the matrices.
        node_ids: Numbers of the nodes; 0, 1, 2, ... by default.
        node_dofs: Motions that every node has; displacements where the size is three times the
            number of nodes, displacements and then rotations where it is six times.
        order: ``"node"``: all motions of the first node come first; ``"component"``: the first
            motion of all nodes.
        dofs: Node and motion of each row, instead.

    Raises:
        ModelError: rows that are not those of the nodes.
    """
    positions, ids = positions_of(nodes, node_ids)
    count = len(positions)
    if dofs is not None:
        return _listed(positions, ids, size, dofs)
    if order not in ORDERS:
        raise ModelError(f"order={brief(order)}: give 'node' or 'component'")
    if node_dofs is None:
        if size not in (3 * count, 6 * count):
            raise ModelError(
                f"M and K have {counted(size, 'row')}, {counted(count, 'node')} have {3 * count} "
                f"with three motions each and {6 * count} with six. Say which motions a node has, "
                "such as node_dofs='x y rz', or name each row by dofs=[(node, 'x'), ...]"
            )
        per_node: tuple[int, ...] = tuple(range(size // count))
    else:
        per_node = component_names(node_dofs, "node_dofs")
        if size != len(per_node) * count:
            names = " ".join(COMPONENTS[k] for k in per_node)
            raise ModelError(
                f"M and K have {counted(size, 'row')}; {counted(count, 'node')} with motions "
                f"{names} have {len(per_node) * count}. Leave out the nodes without rows, or name "
                "each row by dofs=[(node, 'x'), ...]"
            )
    node, component = np.arange(count), np.array(per_node)
    if order == "node":
        return NodeDofs(positions, ids, np.repeat(node, len(per_node)), np.tile(component, count))
    return NodeDofs(positions, ids, np.tile(node, len(per_node)), np.repeat(component, count))


def _listed(
    positions: Array, ids: Integers, size: int, dofs: Sequence[tuple[int, str]]
) -> NodeDofs:
    """Rows that are named one by one."""
    if not isinstance(dofs, Sequence) or isinstance(dofs, str):
        raise ModelError(f"dofs={brief(dofs)}: give a list such as [(17, 'x'), (17, 'rz')]")
    rows = [*dofs]
    if len(rows) != size:
        raise ModelError(f"dofs: {counted(len(rows), 'row')} named, M and K have {size}")
    bad = next((row for row in rows if not isinstance(row, tuple | list) or len(row) != 2), None)
    bad = next((row for row in rows if row[1] not in COMPONENTS), None) if bad is None else bad
    if bad is not None:
        raise ModelError(
            f"dofs: {brief(bad)} is not a row; give a node and one of {', '.join(COMPONENTS)}, "
            "such as (17, 'rz')"
        )
    empty = NodeDofs(positions, ids, np.zeros(0, np.intp), np.zeros(0, np.intp))
    node = empty.places([row[0] for row in rows], "dofs")
    component = np.array([COMPONENTS.index(row[1]) for row in rows], dtype=np.intp)
    numbered = NodeDofs(positions, ids, node, component)
    unique, first, count = np.unique(6 * node + component, return_index=True, return_counts=True)
    if len(unique) != size:
        raise ModelError(f"dofs: {numbered.label(first[count > 1][0])} is there twice; drop one")
    return numbered
