"""What a user should know about a system before its equations are derived."""

from __future__ import annotations

import dataclasses
from collections.abc import Collection, Iterable

from ..model.checks import mass
from ..model.model import Model
from .convert import Converter
from .system import GROUND, Nodes, System


def announce(
    system: System, model: Model, convert: Converter, placing: Collection[str] = ()
) -> System:
    """The system with notes: what does not act, what is unused, massless tips.

    Args:
        placing: Parameters that say where beams are.
    """
    notes = list(model.notes)
    notes += [
        f"parameter '{name}' says where a beam is, so that its value is built into the equations; "
        f"for another one give specialize={{'{name}': ...}}"
        for name in model.parameters
        if name in placing
    ]
    for what, names in (("parameter", model.parameters), ("input", model.inputs)):
        notes += [
            f"{what} '{name}' is declared but used nowhere: use it or remove it"
            for name in names
            if name not in convert.used
        ]
    limited = [j.name for j in model.joints.values() if any(v is not None for v in j.limits)]
    stored = f"joints {', '.join(limited)}: limits are stored, but do not act yet"
    # the reader of a file says so by itself
    if limited and stored not in notes:
        notes.append(stored)
    notes += [
        f"body '{name}' is a massless tip: nothing resists the joint '{joint}' that moves it. "
        "Give it a mass or an inertia, or fix or prescribe the joint"
        for name, joint in massless_tips(system)
    ]
    notes += [
        f"beam '{name}' flies: nothing joins it to the ground, itself or through others. Join one "
        "of its ends if something is to hold it"
        for name in flying(system)
    ]
    return dataclasses.replace(system, notes=tuple(notes))


def flying(system: System) -> list[str]:
    """The first beam of every group of bodies that neither joints nor beams join to the ground."""
    ends = [
        (system.frames[a].body, system.frames[b].body)
        for a, b in (
            *((j.parent_frame, j.child_frame) for j in system.joints if not j.implicit),
            *((c.parent_frame, c.child_frame) for c in system.closing),
            *((s.frame_a, s.frame_b) for s in system.segments),
        )
    ]
    # every body points to another of its group, one of them to itself; the ground is the last
    first = list(range(len(system.bodies) + 1))

    def group(body: int) -> int:
        body %= len(first)
        while first[body] != body:
            first[body] = body = first[first[body]]
        return body

    for a, b in ends:
        first[group(a)] = group(b)
    names: dict[int, str] = {}
    for segment in system.segments:
        names.setdefault(group(system.frames[segment.frame_a].body), segment.name)
    names.pop(group(GROUND), None)
    return list(names.values())


def check_masses(written: Iterable[tuple[str, Nodes]], convert: Converter) -> None:
    """Masses and inertias given as expressions are possible ones at the default parameters.

    Args:
        written: Name of a body, its mass and the entries xx xy xz yy yz zz of its inertia.
        convert: Knows the defaults.

    Raises:
        ModelError: a negative mass.
    """
    for name, nodes in written:
        values = convert.defaults(nodes)
        mass(name, values[0], values[1:])


def massless_tips(system: System) -> list[tuple[str, str]]:
    """Bodies without any mass from there outward, with their joints; M is singular there.

    What a joint that closes a circuit holds is no tip, nor what a beam holds.
    """
    count = len(system.bodies)
    held = {system.frames[f].body for c in system.closing for f in (c.parent_frame, c.child_frame)}
    held |= {system.frames[f].body for s in system.segments for f in (s.frame_a, s.frame_b)}
    heavy = [bool(b.mass or any(b.inertia)) or i in held for i, b in enumerate(system.bodies)]
    for k in range(count - 1, -1, -1):
        parent = system.bodies[k].parent
        if heavy[k] and parent >= 0:
            heavy[parent] = True
    return [
        (body.name, joint.name)
        for body, joint, some in zip(system.bodies, system.joints, heavy, strict=True)
        if not (some or joint.element.bodiless) and joint.motion is None and joint.coupling is None
    ]
