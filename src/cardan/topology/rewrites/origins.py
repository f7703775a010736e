"""Origins: moved along the lines of the joints, so that positions between them have fewer parts.

The origin of a body may lie anywhere on the line of its joint. Where the joint sits off the origin
of its parent along that very line, the offset is passed on to the joints outboard, where it meets
another one or, at the tip of a branch, nothing at all.

Source: Khalil and Kleinfinger, A New Geometric Notation for Open and Closed-Loop Robots, IEEE ICRA
1986, for trees.
"""

from __future__ import annotations

from ...ir.graph import ZERO, Graph
from ...ir.matrix import Matrix
from ...spatial.axis import principal
from ..frame_change import FrameChange, change_frames, new_joint_pose
from ..system import Body, System

# operations: of a component of a position, of one that is a joint further out, and of a product of
# inertia that was zero
GAIN, LEVER, FILLED = 10, 4, 7


def origins(system: System) -> System:
    """The system with origins of a better choice."""
    graph = system.graph.fork()
    children: list[list[int]] = [[] for _ in system.bodies]
    for i, body in enumerate(system.bodies):
        if body.parent >= 0:
            children[body.parent].append(i)
    identity, zero = Matrix.identity(graph, 3), Matrix.zeros(graph, 3)
    new_frames = [FrameChange(identity, zero) for _ in system.bodies]
    moved = False
    for i, body in enumerate(system.bodies):
        with graph.made_by(body.name, "origin"):
            shift = _shift(system, graph, new_frames, i, children[i])
        if shift is not None:
            new_frames[i], moved = FrameChange(identity, shift), True
    return change_frames(system, graph, new_frames, {}) if moved else system


def _shift(
    system: System, graph: Graph, new_frames: list[FrameChange], i: int, children: list[int]
) -> Matrix | None:
    """Shift of the origin of body i along its line; None where it stays."""
    joint = system.joints[i]
    # where the ground has its origin is the user's choice: a vehicle may be far from there, and its
    # inertia about a point that far would leave few digits
    if not joint.element.line or system.bodies[i].parent < 0:
        return None
    line = principal(Matrix(graph, *joint.data[joint.element.line]))
    rotation, position = new_joint_pose(system, graph, new_frames, i)
    if line is None:
        return None
    k, _ = line
    outer = principal(rotation.column(k))
    if outer is None or position.nodes[outer[0]] == ZERO:
        return None
    # what is passed on takes zeros from joints outboard, and at a tip from products of inertia
    outer_joints = [system.joints[child].position for child in children]
    new = [at for at in outer_joints if at[k] == ZERO]
    left = any(node for j, node in enumerate(position.nodes) if j != outer[0])
    if left and new and not all(any(at) for at in outer_joints):
        return None
    filled = 0 if children else _filled(system.bodies[i], k)
    if GAIN * (1 - len(new)) + LEVER - FILLED * filled <= 0:
        return None
    distance = position[outer[0]] * -outer[1]
    return Matrix.vector(graph, [distance if j == k else 0.0 for j in range(3)])


def _filled(body: Body, k: int) -> int:
    """Products of inertia that are zero before a shift along axis k and not after it."""
    across = [j for j in range(3) if j != k]
    return sum(body.inertia[3 * j + k] == ZERO != body.first_moment[j] for j in across)
