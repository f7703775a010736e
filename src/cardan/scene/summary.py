"""A model on one screen: what is in it and what of it does not act."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..elements.forces.friction import Friction
from ..elements.forces.stop import Stop
from .connections import Joint
from .joint_properties import moves_alone

if TYPE_CHECKING:
    from .scene import SceneRecord

MOST_ROWS = 30
WIDEST = 28
LONGEST_NOTE = 400  # what to do stands at its end


def notes_of(model: SceneRecord) -> list[str]:
    """Notes for a user: notes of files, and joint properties without effect."""
    stopped, rubbing = (
        {f.element.joint for f in model.forces.values() if isinstance(f.element, kind)}
        for kind in (Stop, Friction)
    )
    joints = model.joints.values()
    ends = [j.name for j in joints if j.limits[:2] != (None, None) and j.name not in stopped]
    rates = [j.name for j in joints if j.limits[2:] != (None, None) and j.name not in ends]
    dry = [j.name for j in joints if j.friction and j.name not in rubbing]
    # what cd.load can make act, and what belongs to the joint that another one follows
    alone = {joint.name for joint in joints if moves_alone(joint)}
    without_effect = (
        (
            "friction is ignored; add a Friction, or load the file with friction=True",
            [name for name in dry if name in alone],
        ),
        (
            "friction is ignored on joints that follow others or have several coordinates",
            [name for name in dry if name not in alone],
        ),
        (
            "limits are ignored; add a Stop, or load the file with limits='stop'",
            [name for name in ends if name in alone],
        ),
        (
            "limits are ignored on joints that follow others, are prescribed or have several "
            "coordinates",
            [name for name in ends if name not in alone],
        ),
        ("limits of speed and effort are ignored", rates),
    )
    sentences = (f"joints {', '.join(names)}: {what}" for what, names in without_effect if names)
    return [*model.notes, *sentences]


def summary(model: SceneRecord) -> str:
    """Bodies with their joints, forces, declared names and notes."""
    counts = ", ".join(
        f"{len(items)} {what}{'s' if len(items) != 1 else ''}"
        for what, items in (
            ("joint", model.joints),
            ("beam", model.beams),
            ("cable", model.cables),
            ("superelement", model.superelements),
            ("force", model.forces),
            ("parameter", model.parameters),
            ("input", model.inputs),
            ("output", model.outputs),
            ("constraint", model.constraints),
        )
        if items
    )
    bodies = f"{len(model.bodies)} bod{'y' if len(model.bodies) == 1 else 'ies'}"
    gravity = ", ".join(_short(g) for g in model.gravity)
    lines = [
        f"model '{model.name}': {bodies}{', ' if counts else ''}{counts}",
        f"gravity ({gravity}) m/s^2",
    ]
    lines += ["", *_table(body_rows(model))] if model.bodies else []
    lines += ["", *_table(beam_rows(model))] if model.beams else []
    lines += ["", *_table(cable_rows(model))] if model.cables else []
    lines += ["", *_table(superelement_rows(model))] if model.superelements else []
    lines += ["", "forces", *(f"  {line}" for line in force_rows(model))] if model.forces else []
    lines += [f"note: {_fit(note, LONGEST_NOTE)}" for note in notes_of(model)]
    return "\n".join(lines)


def body_rows(model: SceneRecord) -> list[list[str]]:
    """Bodies with their joints, below their titles."""
    # the first joint of a body; further ones close loops
    inboard = {joint.child.body: joint for joint in reversed(model.joints.values())}
    rows = [["body", "mass [kg]", "joint", "kind", "parent", ""]]
    for body in model.bodies.values():
        joint = inboard.get(body)
        row = [body.name, _short(body.mass)]
        if joint is None:
            row += ["-", "", "", ""]
        else:
            row += [joint.name, joint.kind.kind, joint.parent.body.name, _remark(joint)]
        rows.append(row)
    return rows


def beam_rows(model: SceneRecord) -> list[list[str]]:
    """Beams, below their titles."""
    rows = [["beam", "section", "line", "from", "to", "elements"]]
    for beam in model.beams.values():
        ends = (beam.start.name, beam.end.name)
        rows.append([beam.name, beam.section.kind, beam.line.kind, *ends, str(beam.elements)])
    return rows


def cable_rows(model: SceneRecord) -> list[list[str]]:
    """Cables, below their titles."""
    rows = [["cable", "EA [N]", "mass [kg/m]", "length [m]", "from", "to", "elements"]]
    for cable in model.cables.values():
        length = "" if cable.length is None else _short(cable.length)
        numbers = (_short(cable.EA), _short(cable.rhoA), length)
        ends = (cable.start.name, cable.end.name)
        name = f"{cable.name} (bar)" if cable.compression else cable.name
        rows.append([name, *numbers, *ends, str(cable.elements)])
    return rows


def superelement_rows(model: SceneRecord) -> list[list[str]]:
    """Superelements, below their titles."""
    loaded = any(one.loads for one in model.superelements.values())
    heads = ["superelement", "mass [kg]", "method", "modes", "frame", "interfaces"]
    rows = [[*heads, "loads"] if loaded else heads]
    for name, one in model.superelements.items():
        record = one.record
        ends = [
            f"{end.name} = {one.joined[end.name]}" if end.name in one.joined else end.name
            for end in record.interfaces
        ]
        modes = str(record.n - record.n_boundary)
        mass = _short(record.properties.mass)
        row = [name, mass, record.method, modes, one.frame, ", ".join(ends)]
        loads = (f"{load} {_short(factor)}" for load, factor in one.loads.items())
        rows.append([*row, *([", ".join(loads)] if loaded else [])])
    return rows


def _remark(joint: Joint) -> str:
    if joint.prescribed is not None:
        return f"prescribed: {joint.prescribed}"
    if joint.couple is not None:
        return f"follows {joint.couple.leader}"
    return ""


def force_rows(model: SceneRecord) -> list[str]:
    """Forces by their kinds."""
    kinds: dict[str, list[str]] = {}
    for force in model.forces.values():
        kinds.setdefault(force.element.kind, []).append(force.name)
    return [f"{kind}: {_fit(', '.join(names), 100)}" for kind, names in kinds.items()]


def _table(rows: Sequence[Sequence[str]]) -> list[str]:
    hidden = len(rows) - 1 - MOST_ROWS
    cells = [[_fit(cell, WIDEST) for cell in row] for row in rows[: MOST_ROWS + 1]]
    widths = [max(len(row[k]) for row in cells) for k in range(len(cells[0]))]
    lines = [
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in cells
    ]
    return [*lines, f"... and {hidden} more"] if hidden > 0 else lines


def _short(value: object) -> str:
    return f"{value:.6g}" if isinstance(value, (int, float)) else str(value)


def _fit(text: str, width: int) -> str:
    return text if len(text) <= width else text[: width - 3] + "..."
