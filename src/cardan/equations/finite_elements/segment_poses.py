"""Poses of the nodes of a segment of a beam in the reference configuration."""

from __future__ import annotations

from functools import cache

import numpy as np

from ...ir.function import Block, Function, Output
from ...ir.graph import Graph
from ...ir.interpreter import evaluate
from ...ir.matrix import Matrix
from ...spatial.exponential import quaternion_of
from ...topology.beams.segment_tables import Segment
from .record import Numbers


def poses_of(segment: Segment) -> Numbers:
    """Unit quaternions and positions of the nodes (n + 1, 7)."""
    line = segment.line
    quaternions = evaluate(_quaternions(), {"q": line.rotations.reshape(-1, 9)}, "numpy")["q"]
    # of q and -q that beside the one before
    flipped = np.sum(quaternions[1:] * quaternions[:-1], axis=1) < 0
    quaternions[1:] *= np.cumprod(np.where(flipped, -1.0, 1.0))[:, None]
    return np.hstack([quaternions, line.positions])


@cache
def _quaternions() -> Function:
    """Rotation matrix q (9) -> unit quaternion (4)."""
    graph = Graph()
    R = Matrix(graph, 3, 3, [graph.var("q", k) for k in range(9)])
    block = Block("q", tuple(f"R{k}" for k in range(9)), ("",) * 9)
    output = Output("q", (4,), quaternion_of(R).nodes)
    return Function("quaternions", graph, (block,), (output,))
