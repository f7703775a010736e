"""Fixed joints that loops pass inside the rigid bodies of a system."""

from __future__ import annotations

from collections.abc import Iterator

from ...records import dataclass
from ..system import Cut, Part, System


@dataclass(frozen=True)
class Weld:
    """A fixed joint that a loop passes.

    Attributes:
        joint: Its name.
        frame: Number of its child frame.
        side: 1 where the part that it carries is nearer to the child of the cut, -1 where it is
            nearer to the parent.
    """

    joint: str
    frame: int
    side: int


def passed(system: System, cut: Cut) -> list[Weld]:
    """Fixed joints that a loop passes.

    Args:
        system: Whose bodies are made of parts.
        cut: What closes the loop.
    """
    welds: list[Weld] = []
    frames = system.frames
    ends = [
        (frames[frame].body, frames[frame].part) for frame in (cut.parent_frame, cut.child_frame)
    ]
    sides = []
    for (body, part), sign in zip(ends, (-1, 1), strict=True):
        while body != cut.base:
            joint = system.joints[body]
            inboard = frames[joint.child_frame].part
            for weld, way in _joints_on_path(_parts(system, body), part, inboard):
                welds.append(Weld(weld.joint, weld.joint_frame, sign * way))
            frame = frames[joint.parent_frame]
            body, part = frame.body, frame.part
        sides.append(part)
    for weld, way in _joints_on_path(_parts(system, cut.base), sides[1], sides[0]):
        welds.append(Weld(weld.joint, weld.joint_frame, way))
    return welds


def _parts(system: System, body: int) -> tuple[Part, ...]:
    return system.ground_parts if body < 0 else system.bodies[body].parts


def _joints_on_path(parts: tuple[Part, ...], one: int, other: int) -> Iterator[tuple[Part, int]]:
    """Parts that fixed joints between two parts hold: 1 on the side of the first, else -1."""
    # parts come after those that they are fixed to
    while one != other:
        if one > other:
            yield parts[one], 1
            one = parts[one].inboard
        else:
            yield parts[other], -1
            other = parts[other].inboard
