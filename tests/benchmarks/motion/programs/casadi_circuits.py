"""Planar loops in CasADi: two points held together per cut joint.

Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, section 8.5.
"""

from __future__ import annotations

from typing import Any

import casadi as ca
import numpy as np

from benchmarks.motion.problem import Anchor, Task
from cardan.peers.casadi_algorithms import Tree, composite, exact, newton_euler
from cardan.peers.circuits import circuits

PLANE = slice(0, 2)


def accelerations(task: Task, tree: Tree, q: Any, u: Any, tau: Any) -> Any:
    """udot with the loops of a planar mechanism closed."""
    poses = _poses(tree)
    names = [body["name"] for body in task.model.manifest["bodies"]]

    def place(body: int, local: Any) -> Any:
        if body < 0:
            return ca.SX(exact(local))
        return poses[body][1] + ca.mtimes(poses[body][0], exact(local))

    def anchored(end: Anchor) -> Any:
        return place(names.index(end[0]) if end[0] != "ground" else -1, end[1])

    for spring in task.problem.loads.springs:
        length = ca.norm_2(anchored(spring.ends[1]) - anchored(spring.ends[0]))
        energy = spring.stiffness / 2 * (length - spring.length) ** 2
        tau = tau - ca.gradient(energy, q)
    found = circuits(task.model)
    if isinstance(found, str):
        raise ValueError(found)
    gaps = [place(h.bodies[0], h.positions[0]) - place(h.bodies[1], h.positions[1])
            for h in found.connections]  # fmt: skip
    gap = ca.vertcat(*(each[PLANE] for each in gaps))
    jacobian = ca.jacobian(gap, q)
    drift = ca.jtimes(ca.mtimes(jacobian, u), q, u)
    bias = newton_euler(tree, u, ca.SX(np.zeros(len(tree.parents))))
    rows = gap.shape[0]
    matrix = ca.blockcat([[composite(tree), jacobian.T], [jacobian, ca.SX(rows, rows)]])
    return ca.solve(matrix, ca.vertcat(tau - bias, -drift))[: u.shape[0]]


def _poses(tree: Tree) -> list[tuple[Any, Any]]:
    """Rotation to ground axes and place of the origin of every body."""
    found: list[tuple[Any, Any]] = []
    for parent, x in zip(tree.parents, tree.x, strict=True):
        back = x[:3, :3]
        # the lower left block is -R skew(place)
        cross = -ca.mtimes(back.T, x[3:, :3])
        place = ca.vertcat(cross[2, 1], cross[0, 2], cross[1, 0])
        if parent < 0:
            found.append((back.T, place))
        else:
            outer, origin = found[parent]
            found.append((ca.mtimes(outer, back.T), origin + ca.mtimes(outer, place)))
    return found
