"""Frames of a model that need an entry of their own in its file."""

from __future__ import annotations

from collections import Counter
from dataclasses import fields
from typing import Any

from ...frame import Frame
from ...scene import SceneRecord


def separate_frames(model: SceneRecord) -> dict[Frame, None]:
    """Frames for the section ``frames``; every other one is written where it is used.

    These are the named ones, those used more than once, those from which others are placed, those
    whose motion an expression has, those that superelements are fixed to, and those whose made
    name, such as ``upper.at1``, would be another one after reading.
    """
    uses = _uses(model)
    counts = Counter(uses)
    spoken = {
        place
        for entry in model.atoms.values()
        for place in (entry.place, entry.wrt, entry.in_)
        if isinstance(place, Frame)
    }
    spoken |= {frame.base for frame in model.frames.values() if frame.base is not None}
    spoken |= {
        model.frames[name]
        for superelement in model.superelements.values()
        for name in superelement.joined.values()
        if name in model.frames
    }
    separate = {f for f in model.frames.values() if f.named or counts[f] != 1 or f in spoken}
    while wrong := _renamed([frame for frame in uses if frame not in separate], separate):
        separate |= wrong
    return {frame: None for frame in model.frames.values() if frame in separate}


def _uses(model: SceneRecord) -> list[Frame]:
    """Frames in the order in which a reader meets them."""
    places: list[Any] = [end.place for beam in model.beams.values() for end in beam.ends]
    places += [end.place for cable in model.cables.values() for end in cable.ends]
    places += [side for joint in model.joints.values() for side in (joint.parent, joint.child)]
    for force in model.forces.values():
        element = force.element
        places += [getattr(element, entry.name) for entry in fields(element)]  # type: ignore[arg-type]
    return [place for place in places if isinstance(place, Frame)]


def _renamed(inline: list[Frame], separate: set[Frame]) -> set[Frame]:
    """Frames that would get another name than they have: names go to the first who needs one."""
    taken = {frame.name for frame in separate}
    wrong, next_free = set(), Counter[str]()
    for frame in inline:
        body = frame.body.name
        count = next_free[body] + 1
        while f"{body}.at{count}" in taken:
            count += 1
        next_free[body] = count
        if frame.name != f"{body}.at{count}":
            wrong.add(frame)
    return wrong
