"""One frame as seen from another, along the tree: what carries both does not show."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...ir.matrix import Matrix
from ...topology.system import GROUND

if TYPE_CHECKING:
    from .kinematics import Kinematics


def arm(k: Kinematics, start: int, end: int) -> Matrix:
    """From the origin of a frame to that of another (3, 1), in axes of the latter."""
    first, last = (k.system.frames[frame].body for frame in (start, end))
    top = common_ancestor(k, first, last)
    span = _point(k, end, top) - _point(k, start, top)
    return frame_axes(k, end).T @ _down(k, span, last, top)


def in_frame(k: Kinematics, x: Matrix, start: int, end: int) -> Matrix:
    """A vector in axes of a frame (3, 1), in those of another."""
    return frame_axes(k, end).T @ into_body(k, x, start, k.system.frames[end].body)


def into_body(k: Kinematics, x: Matrix, start: int, body: int) -> Matrix:
    """A vector in axes of a frame (3, 1), in those the vectors of a body are told in."""
    return body_to_body(k, frame_axes(k, start) @ x, k.system.frames[start].body, body)


def body_to_body(k: Kinematics, x: Matrix, start: int, end: int) -> Matrix:
    """Vectors in axes of a body (3, n), in those of another."""
    top = common_ancestor(k, start, end)
    return _down(k, _up(k, x, start, top), end, top)


def frame_axes(k: Kinematics, frame: int) -> Matrix:
    """R from axes of a frame to those of its body."""
    f = k.system.frames[frame]
    return k.fixed_to(f.body, k.matrix(3, 3, f.rotation))


def common_ancestor(k: Kinematics, first: int, last: int) -> int:
    """The body nearest to two others that carries both, or is one of them."""
    if k.cuts is not None and first != last:
        # a step of a recursion knows of a body only what is handed on
        return GROUND
    bodies = k.system.bodies
    while first != last:
        if first > last:
            first = bodies[first].parent
        else:
            last = bodies[last].parent
    return first


def _up(k: Kinematics, x: Matrix, body: int, top: int) -> Matrix:
    """A vector in axes of a body, in those of one that carries it."""
    if top == GROUND:
        return k.body_rotation(body) @ x
    while body != top:
        x, body = k.pose_of(body).rotation @ x, k.system.bodies[body].parent
    return x


def _down(k: Kinematics, x: Matrix, body: int, top: int) -> Matrix:
    """A vector in axes of a body, in those of one that it carries."""
    if top == GROUND:
        return k.body_rotation(body).T @ x
    chain = []
    while body != top:
        chain.append(body)
        body = k.system.bodies[body].parent
    for i in reversed(chain):
        x = k.pose_of(i).rotation.T @ x
    return x


def _point(k: Kinematics, frame: int, top: int) -> Matrix:
    """Origin of a frame from that of a body that carries it, in axes of that."""
    if top == GROUND:
        return k.position(frame)
    body, p = k.system.frames[frame].body, k.place(frame)
    while body != top:
        pose = k.pose_of(body)
        p, body = pose.position + pose.rotation @ p, k.system.bodies[body].parent
    return p
