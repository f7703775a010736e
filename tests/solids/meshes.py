"""Meshes of blocks and tubes for the tests."""

from __future__ import annotations

from itertools import product

import numpy as np

from cardan import solids as fem
from cardan.solids.cells import SOLIDS

KINDS = ("tet4", "tet10", "hex8", "hex20")
# a cube in six tetrahedra around its diagonal; those of neighbors fit
SIX = ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6))


def grid(counts, moved=lambda x: x, kind="hex20", size=(1.0, 1.0, 1.0)):
    """Points and cells of a block whose corner grid has been moved; edges stay straight."""
    nx, ny, nz = counts
    axes = [np.linspace(0, s, n + 1) for s, n in zip(size, counts, strict=True)]
    points = np.array(list(product(*axes)))
    points = np.array([moved(x) for x in points])

    def node(i, j, k):
        return (i * (ny + 1) + j) * (nz + 1) + k

    hexes = np.array(
        [
            [node(i + a, j + b, k + c) for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
            for i, j, k in product(range(nx), range(ny), range(nz))
        ]
    )
    corners = hexes if kind.startswith("hex") else hexes[:, SIX].reshape(-1, 4)
    return quadratic(points, corners, kind)


def quadratic(points, corners, kind):
    """Cells with nodes in the middle of straight edges, where the kind has them."""
    edges = np.array(SOLIDS[kind].edges, int).reshape(-1, 2)
    if not len(edges):
        return points, {kind: corners}
    pairs = np.sort(corners[:, edges], axis=2)
    unique, number = np.unique(pairs.reshape(-1, 2), axis=0, return_inverse=True)
    middles = points[unique].mean(axis=1)
    cells = np.hstack([corners, len(points) + number.reshape(len(corners), -1)])
    return np.vstack([points, middles]), {kind: cells}


def block(kind, counts=(2, 2, 2), size=(1.0, 1.0, 1.0), distortion=0.0, seed=1):
    """A checked mesh of a block; corners inside are moved at random by a share of a cell."""
    rng = np.random.default_rng(seed)
    step = np.array(size) / counts

    def moved(x):
        inside = (x > 1e-9) & (x < np.array(size) - 1e-9)
        return x + distortion * step * inside * rng.uniform(-1, 1, 3)

    points, cells = grid(counts, moved, kind, size)
    return fem.from_arrays(points, cells, scale=1.0)


def bent(mesh, move):
    """A mesh of the same cells with all nodes moved: edges become curved."""
    points = np.array([move(x) for x in mesh.points])
    return fem.from_arrays(points, dict(mesh.cells), scale=1.0)
