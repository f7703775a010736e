"""Angles of a rotation matrix at and near the singular set: no unique ones, but always right."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from cardan.ir.function import Function, Output
from cardan.ir.graph import Graph
from cardan.ir.interpreter import evaluate
from cardan.ir.matrix import Matrix
from cardan.spatial.rotations import ROTATIONS, SEQUENCES
from table import each


@each("name", SEQUENCES)
@each("distance", [0.0, 1e-14, 1e-12, 1e-8, 1e-4])
def test_angles_reproduce_the_matrix_near_gimbal_lock(name: str, distance: float) -> None:
    graph = Graph()
    cells = Matrix(graph, 3, 3, [graph.var("q", k) for k in range(9)])
    angles = ROTATIONS[name].from_matrix(cells)
    again = ROTATIONS[name].matrix(angles)
    function = Function("angles", graph, (), (Output("R", (9,), again.nodes),))
    for first, last in ((0.3, -0.8), (2.0, 1.1), (-1.0, 3.0)):
        locks = (0.0, np.pi) if name[0] == name[2] else (-np.pi / 2, np.pi / 2)
        for lock in locks:
            middle = lock + distance if lock < 1 else lock - distance
            given = Rotation.from_euler(name, [first, middle, last]).as_matrix()
            values = evaluate(function, {"q": given.ravel()})["R"]
            # a few roundings of products of cosines
            np.testing.assert_allclose(values, given.ravel(), rtol=0, atol=2e-15)
