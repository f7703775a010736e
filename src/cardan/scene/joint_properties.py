"""Limits and dry friction that a file declares for its joints, made to act."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

from ..elements.forces.friction import Friction
from ..elements.forces.stop import Stop
from .connections import Joint

if TYPE_CHECKING:
    from .scene import SceneRecord


def add_stops(scene: SceneRecord) -> None:
    """A :class:`Stop` at the limits of position of every joint that has some and moves freely.

    A joint whose reference position lies outside starts in the middle, which a note says.
    """
    for joint in list(scene.joints.values()):
        lower, upper = joint.limits[:2]
        if not moves_alone(joint) or _acted_on(scene, joint, Stop):
            continue
        if (lower, upper) == (None, None) or (lower is not None and lower == upper):
            continue
        scene.force(f"{joint.name}.stop", Stop(joint.name, lower, upper))
        start = _inside(lower, upper)
        if joint.q0 is None and start != 0.0:
            scene.joints[joint.name] = dataclasses.replace(joint, q0=(start,))
            scene.notes.append(f"joint {joint.name} starts at {start:.4g}: 0 is outside its limits")


def add_friction(scene: SceneRecord) -> None:
    """A :class:`Friction` for every joint with declared dry friction that moves freely."""
    for joint in list(scene.joints.values()):
        if joint.friction and moves_alone(joint) and not _acted_on(scene, joint, Friction):
            scene.force(f"{joint.name}.friction", Friction(joint.name, coulomb=joint.friction))


def moves_alone(joint: Joint) -> bool:
    """True for a joint of one coordinate that is neither prescribed nor coupled."""
    free = joint.prescribed is None and joint.couple is None
    return free and len(joint.kind.coordinates) == len(joint.kind.speeds) == 1


def _acted_on(scene: SceneRecord, joint: Joint, kind: type[Stop | Friction]) -> bool:
    elements = (force.element for force in scene.forces.values())
    return any(isinstance(one, kind) and one.joint == joint.name for one in elements)


def _inside(lower: float | None, upper: float | None) -> float:
    """A position within limits: 0, or the middle of a range without it."""
    if (lower is None or lower < 0) and (upper is None or upper > 0):
        return 0.0
    if lower is None or upper is None:
        # one limit: 1 rad or 1 m inside
        return (lower or 0.0) + 1.0 if upper is None else upper - 1.0
    return (lower + upper) / 2
