"""Changes of rotations by angular velocities, whatever coordinates tell them.

The rates of angles or parameters may be singular where angular velocities are not, such as at the
gimbal lock of Euler angles. Entries of rotations are differentiated instead: dR = R [omega].

Source: Roberson and Schwertassek, Dynamics of Multibody Systems, chapter 3 (Poisson's equations).
"""

from __future__ import annotations

from ...ir.derivative import forward
from ...ir.matrix import Matrix
from ...ir.ops import LEAVES
from .kinematics import Kinematics


def derivative(k: Kinematics, x: Matrix) -> Matrix:
    """Entry by entry time derivative at udot = 0; rotations turn as angular velocities say."""
    seeds = dict(k.time_seeds)
    for i, speeds in rotating_joints(k):
        seeds |= rotation_seeds(k, i, speeds)
    return Matrix(k.graph, x.rows, x.columns, forward(k.graph, x.nodes, seeds))


def rotating_joints(k: Kinematics) -> list[tuple[int, Matrix]]:
    """Joints whose group does not commute, and their speeds."""
    pairs = []
    for i, joint in enumerate(k.system.joints):
        if joint.u >= 0:
            u = k.block("u", joint.u, len(joint.element.speeds))
            v = k.block("udot", joint.u, len(joint.element.speeds))
            if not joint.element.bracket(u, v).is_zero:
                pairs.append((i, k.speeds[i]))
    return pairs


def rotation_seeds(k: Kinematics, i: int, u: Matrix) -> dict[int, int]:
    """Entries of the rotation of a joint -> their changes along u: R [S u], whatever its angles."""
    g, element, q, data = k.graph, k.system.joints[i].element, k.coordinates[i], k.data[i]
    R = element.pose(q, **data)[0]
    change = R @ (element.motion(q, **data) @ u).block(slice(0, 3)).skew
    seeds = {}
    for node, dot in zip(R.nodes, change.nodes, strict=True):
        if g.nodes[node][0] == "neg":
            node, dot = g.nodes[node][1], g.neg(dot)
        if g.nodes[node][0] not in LEAVES:
            seeds[node] = dot
    return seeds
