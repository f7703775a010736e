"""Warnings about a system before its equations are derived."""

from __future__ import annotations

import dataclasses
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from ...arrays import Array
from ...errors import ImpossibleWarning
from ...scene.checks import is_number, lone_moment, mass, unphysical
from ...scene.scene import SceneRecord
from ...scene.summary import notes_of
from ..assembly import Assembly
from ..conversion import Converter
from ..loops.circuits import SAMPLES, Numbers
from ..scene_warnings import warn_about
from ..system import GROUND, Nodes, System

Moments = Sequence[Any]
ALONG = 1e-9  # of an axis across another one: it is along it


def announce(
    system: System, model: SceneRecord, convert: Converter, placing: Collection[str] = ()
) -> System:
    """The system with notes: what does not act, what is unused, massless tips.

    Args:
        placing: Parameters that say where beams are.
    """
    notes = notes_of(model)
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
    notes += massless_notes(system)
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


def check_masses(written: Iterable[tuple[str, Nodes]], convert: Converter) -> dict[str, Moments]:
    """Masses and inertias given as expressions are possible ones at the default parameters.

    Args:
        written: Name of a body, its mass and the entries xx xy xz yy yz zz of its inertia.
        convert: Knows the defaults.

    Returns:
        Name of a body -> its inertia at the defaults.

    Raises:
        ModelError: a negative mass.
    """
    inertias = dict[str, Moments]()
    for name, nodes in written:
        values = convert.defaults(nodes)
        mass(name, values[0], values[1:])
        inertias[name] = values[1:]
    return inertias


def check_lone_moments(
    model: SceneRecord, assembly: Assembly, expression_inertias: Mapping[str, Moments]
) -> None:
    """Warn of bodies with one moment of inertia alone that turn about other axes as well.

    Args:
        model: The scene as the user wrote it.
        assembly: Its bodies and joints.
        expression_inertias: Name of a body -> its inertia, of those written as expressions.
    """
    home = {body.name: place for body, place in assembly.home.items()}
    lone = dict[str, int]()
    for body in model.bodies.values():
        moments = expression_inertias.get(body.name, body.inertia)
        axis = lone_moment(moments) if all(is_number(entry) for entry in moments) else None
        if axis is not None and body.name in home:
            lone[body.name] = axis
    if not lone:
        return
    numbers = Numbers(assembly.convert)
    rotation_axes = turnings(assembly, numbers, [home[name][0] for name in lone])
    for name, axis in lone.items():
        number, placement = home[name]
        outer, axes = rotation_axes[number]
        body_rotation = outer @ numbers.pose(placement.rotation, placement.position).rotation
        across = np.delete(axes @ body_rotation, axis, axis=1)
        if np.abs(across).max(initial=0.0) > ALONG:
            text = (
                f"body '{name}': "
                f"{unphysical(expression_inertias.get(name, model.bodies[name].inertia))}. It "
                f"turns about other axes than its own {'xyz'[axis]} too: give the other moments"
            )
            warn_about(text, model, ImpossibleWarning)


def turnings(
    assembly: Assembly, numbers: Numbers, body_numbers: Iterable[int]
) -> dict[int, tuple[Array, Array]]:
    """Rotation to the ground of rigid bodies with joints at their defaults, and their axes of
    rotation.

    Axes (n, 3) are those of the joints from the ground to the body, in ground axes.
    """
    needed = set[int]()
    for number in body_numbers:
        while number != GROUND and number not in needed:
            needed.add(number)
            number = assembly.bodies[number].parent
    axes_of_bodies = {GROUND: (np.eye(3), np.zeros((0, 3)))}
    # every body comes after that which carries it
    for number in sorted(needed):
        joint = assembly.joints[number]
        outer, axes = axes_of_bodies[assembly.bodies[number].parent]
        seat = outer @ numbers.pose(joint.rotation, joint.position).rotation
        moved = []
        for sample in range(SAMPLES):
            pose, modes = numbers.motion(joint.element, joint.data, sample)
            moved.append(seat @ pose.rotation)
            axes = np.concatenate([axes, (moved[-1] @ modes[:3]).T])
        axes_of_bodies[number] = moved[0], axes
    return axes_of_bodies


def massless_notes(system: System) -> list[str]:
    """Notes on joints that nothing resists, with the bodies that they move."""
    outboard: dict[int, list[int]] = {}
    for k, body in enumerate(system.bodies):
        outboard.setdefault(body.parent, []).append(k)
    numbers = {body.name: k for k, body in enumerate(system.bodies)}
    notes = []
    for name, joint in massless_tips(system):
        outer, waiting = list[str](), [*outboard.get(numbers[name], ())]
        while waiting:
            k = waiting.pop(0)
            outer.append(f"'{system.bodies[k].name}'")
            waiting += outboard.get(k, ())
        if outer:
            more = f" and {len(outer) - 4} more" if len(outer) > 4 else ""
            state = f"and all that it carries ({', '.join(outer[:4])}{more}) are massless"
            cure = "Give one of them"
        else:
            state, cure = "is a massless tip", "Give it"
        notes.append(
            f"body '{name}' {state}: nothing resists the joint '{joint}' that moves it. {cure} a "
            "mass or an inertia, or fix or prescribe the joint"
        )
    return notes


def massless_tips(system: System) -> list[tuple[str, str]]:
    """Bodies without any mass from there outward, with their joints; M is singular there.

    What a joint that closes a loop holds is not a tip, nor what a beam holds.
    """
    count = len(system.bodies)
    constrained = {
        system.frames[f].body for c in system.closing for f in (c.parent_frame, c.child_frame)
    }
    constrained |= {system.frames[f].body for s in system.segments for f in (s.frame_a, s.frame_b)}
    constrained |= {
        i for one in system.superelements for i in (system.frames[one.frame].body, *one.joints)
    }
    heavy = [
        bool(b.mass or any(b.inertia)) or i in constrained for i, b in enumerate(system.bodies)
    ]
    for k in range(count - 1, -1, -1):
        parent = system.bodies[k].parent
        if heavy[k] and parent >= 0:
            heavy[parent] = True
    return [
        (body.name, joint.name)
        for body, joint, some in zip(system.bodies, system.joints, heavy, strict=True)
        if not (some or joint.element.bodiless) and joint.motion is None and joint.coupling is None
    ]
