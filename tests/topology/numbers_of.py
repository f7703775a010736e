"""A small NumPy forward kinematics over a System, through the interpreter."""

from __future__ import annotations

import numpy as np

from cardan.ir.function import Function, Output
from cardan.ir.interpreter import evaluate
from cardan.ir.matrix import Matrix


def values(system, nodes, **blocks):
    """Numbers of expressions at the default parameters."""
    nodes = tuple(nodes)
    blocks.setdefault("p", [p.value for p in system.parameters] or [0.0])
    blocks.setdefault("r", [r.default for r in system.inputs] or [0.0])
    blocks.setdefault("t", [0.0])
    function = Function("f", system.graph, (), (Output("x", (len(nodes),), nodes),))
    return np.array(evaluate(function, blocks)["x"], float)


def default_q(system):
    """The coordinates where joint frames coincide."""
    q = []
    for joint in system.joints:
        if joint.q >= 0:
            q += [c.default for c in joint.element.coordinates]
    return q


def homogeneous(rotation, position):
    pose = np.eye(4)
    pose[:3, :3] = np.reshape(rotation, (3, 3))
    pose[:3, 3] = position
    return pose


def body_poses(system, q=None):
    """Pose (4, 4) of every body of the system at q, and that of the ground under -1."""
    g = system.graph
    q = default_q(system) if q is None else list(q)
    poses = {-1: np.eye(4)}
    for k, (body, joint) in enumerate(zip(system.bodies, system.joints, strict=True)):
        count = len(joint.element.coordinates)
        if joint.motion is not None:
            local = [joint.motion.value]
        elif joint.coupling is not None:
            leader = system.joints[joint.coupling.leader]
            moved = g.mul(joint.coupling.ratio, g.var("q", leader.q))
            local = [g.add(moved, joint.coupling.offset)]
        else:
            local = [g.var("q", joint.q + i) for i in range(count)]
        data = {name: Matrix(g, *entry) for name, entry in joint.data.items()}
        rotation, position = joint.element.pose(Matrix(g, count, 1, local), **data)
        nodes = (*joint.rotation, *joint.position, *rotation.nodes, *position.nodes)
        x = values(system, nodes, q=q or [0.0])
        poses[k] = poses[body.parent] @ homogeneous(x[:9], x[9:12]) @ homogeneous(x[12:21], x[21:])
    return poses


def frame_pose(system, name, q=None):
    """Pose (4, 4) of a frame of the system."""
    frame = next(f for f in system.frames if f.name == name)
    x = values(system, (*frame.rotation, *frame.position))
    return body_poses(system, q)[frame.body] @ homogeneous(x[:9], x[9:])


def body_mass(system, k):
    """Mass, first moment (3) and inertia about the origin (3, 3) of a body."""
    body = system.bodies[k]
    x = values(system, (body.mass, *body.first_moment, *body.inertia))
    return x[0], x[1:4], x[4:].reshape(3, 3)
