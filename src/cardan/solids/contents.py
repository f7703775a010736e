"""Contents of a file of a mesh, before it is checked: merging nodes, leaving out unused ones."""

from __future__ import annotations

from dataclasses import field

import numpy as np

from ..arrays import Array, Integers
from ..errors import ModelError, ModelWarning, counted, warn
from ..records import dataclass


@dataclass
class Contents:
    """Contents of a file, in its numbering of nodes.

    Attributes:
        points: Positions (nodes, 3), in the unit of the file.
        cells: Nodes of solid cells by kind.
        node_sets: Node numbers by name.
        surfaces: Nodes of faces by kind, by name.
        regions: Numbers of solid cells by kind, by name.
    """

    points: Array
    cells: dict[str, Integers] = field(default_factory=dict)
    node_sets: dict[str, Integers] = field(default_factory=dict)
    surfaces: dict[str, dict[str, Integers]] = field(default_factory=dict)
    regions: dict[str, dict[str, Integers]] = field(default_factory=dict)


def merge_nodes(source: str, contents: Contents, distance: float) -> None:
    """Nodes nearer than a distance, in the unit of the file, become one."""
    from scipy.spatial import cKDTree

    if not distance >= 0:
        raise ModelError(f"{source}: merge={distance:g}: give a distance [m], 0 or more")
    _, first, inverse = np.unique(contents.points, axis=0, return_index=True, return_inverse=True)
    target = first[inverse.ravel()].astype(np.intp)
    while True:
        remaining = np.unique(target)
        if len(remaining) < 2:
            break
        near, neighbor = cKDTree(contents.points[remaining]).query(contents.points[remaining], k=2)
        pairs = np.flatnonzero(near[:, 1] <= distance)
        if not len(pairs):
            break
        # each of a pair to the lower one; chains shorten in the next round
        lower = np.arange(len(remaining))
        np.minimum.at(lower, pairs, neighbor[pairs, 1])
        np.minimum.at(lower, neighbor[pairs, 1], pairs)
        replaced = np.arange(len(contents.points))
        replaced[remaining] = remaining[lower]
        target = replaced[target]
    contents.cells = {kind: target[cells] for kind, cells in contents.cells.items()}
    contents.node_sets = {name: np.unique(target[x]) for name, x in contents.node_sets.items()}
    contents.surfaces = {
        name: {kind: target[rows] for kind, rows in kinds.items()}
        for name, kinds in contents.surfaces.items()
    }


def drop_unused(source: str, contents: Contents) -> None:
    """Leave out nodes that no solid cell has, and what is named of them."""
    used = np.zeros(len(contents.points), bool)
    for cells in contents.cells.values():
        used[cells] = True
    number = np.cumsum(used) - 1
    contents.points = contents.points[used]
    contents.cells = {kind: number[cells] for kind, cells in contents.cells.items()}
    sets = {name: number[x[used[x]]] for name, x in contents.node_sets.items()}
    contents.node_sets = {name: numbers for name, numbers in sets.items() if len(numbers)}
    lost: list[str] = [name for name, numbers in sets.items() if not len(numbers)]
    surfaces: dict[str, dict[str, Integers]] = {}
    for name, kinds in contents.surfaces.items():
        complete = {kind: number[rows[used[rows].all(axis=1)]] for kind, rows in kinds.items()}
        if sum(map(len, complete.values())) < sum(map(len, kinds.values())):
            lost.append(name)
        complete = {kind: rows for kind, rows in complete.items() if len(rows)}
        if complete:
            surfaces[name] = complete
    contents.surfaces = surfaces
    if lost:
        warn(
            f"{source}: {counted(len(lost), 'set')} with nodes or faces of no solid cell, which "
            f"are left out: {', '.join(lost[:8])}",
            ModelWarning,
        )
