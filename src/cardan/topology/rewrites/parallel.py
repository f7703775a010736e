"""Parallel: bodies that turn about parallel axes share axes that do not turn.

Of consecutive joints about parallel lines all bodies but the outermost are told in the axes they
enter with: vectors pass between them unchanged, while their inertias and what is fixed to them
turn by the sum of the angles. The outermost body has axes of its own, turned by the whole sum.

Source: Khalil and Dombre, Modeling, Identification and Control of Robots (2002), on the sums of
angles of parallel joints.
"""

from __future__ import annotations

from dataclasses import replace

from ...ir.graph import Graph
from ...ir.matrix import Matrix
from ...spatial.axis import principal
from ..frame_change import FrameChange, change_frames, new_joint_pose
from ..system import Joint, System, Turn


def parallel(system: System) -> System:
    """The system with bodies of parallel joints in common axes."""
    graph = system.graph.fork()
    followers = {i for i in range(len(system.joints)) if _follows(system, graph, i)}
    if all(system.joints[i].follows for i in followers):
        return system
    aligned = _lined_up(system, graph, followers)
    leading = {system.bodies[i].parent for i in followers}
    turns: list[Turn | None] = []
    for i, body in enumerate(aligned.bodies):
        line = _line(graph, aligned.joints[i]) if i in leading else None
        if line is None:
            turns.append(None)
            continue
        before = turns[body.parent] if i in followers else None
        inner = before.joints if before is not None else ()
        turns.append(Turn(line[0], (*inner, (i, line[1]))))
    bodies = tuple(replace(b, turn=turn) for b, turn in zip(aligned.bodies, turns, strict=True))
    return replace(aligned, bodies=bodies)


def _line(graph: Graph, joint: Joint) -> tuple[int, int] | None:
    """Index and sign of the axis a joint turns about, in axes of its body."""
    if joint.element.angle is None:
        return None
    return principal(Matrix(graph, *joint.data[joint.element.line]))


def _follows(system: System, graph: Graph, i: int) -> bool:
    """True when a joint turns about the direction about which its parent does."""
    parent = system.bodies[i].parent
    line = _line(graph, system.joints[i])
    inner = _line(graph, system.joints[parent]) if parent >= 0 else None
    if line is None or inner is None:
        return False
    rotation = Matrix(graph, 3, 3, system.joints[i].rotation)
    if any(graph.value(node) is None for node in rotation.nodes):
        return False
    outer = principal(rotation.column(line[0]))
    return outer is not None and outer[0] == inner[0]


def _lined_up(system: System, graph: Graph, followers: set[int]) -> System:
    """The system with the axes of followers along those of their parents, at zero angles."""
    zero = Matrix.zeros(graph, 3)
    new_frames: list[FrameChange] = []
    joints: dict[int, Joint] = {}
    for i, joint in enumerate(system.joints):
        new_frames.append(FrameChange(Matrix.identity(graph, 3), zero))
        if i in followers:
            rotation, position = new_joint_pose(system, graph, new_frames, i)
            new_frames[i] = FrameChange(rotation.T, zero)
            line = joint.element.line
            axis = rotation @ Matrix(graph, *joint.data[line])
            data = {**joint.data, line: (3, 1, axis.nodes)}
            same = Matrix.identity(graph, 3)
            joints[i] = replace(
                joint, rotation=same.nodes, position=position.nodes, data=data, follows=True
            )
    return change_frames(system, graph, new_frames, joints)
