"""Scenes with superelements: their interfaces become bodies that elastic joints place.

The frame of a superelement is fixed to one of its interfaces, or is a body of its own that the
others leave no freedom: see :func:`...scene.superelement.frame_condition`. From there elastic
joints lead to the interfaces, and a joint that moves nothing has the modal coordinates. None of
these bodies has a mass: the inertia is that of one element, which reads all of these coordinates.
"""

from __future__ import annotations

import copy
from collections.abc import Sequence

import numpy as np

from ...elements.joints.fixed import Fixed
from ...elements.quantity import Value
from ...elements.superelement_joints import Elastic, Modal
from ...elements.superelement_load import SuperelementLoad
from ...errors import ModelError
from ...scene.body import Body
from ...scene.checks import is_number
from ...scene.connections import Force, Joint
from ...scene.frame import Frame
from ...scene.parameters import Constraint, Declared, Output
from ...scene.scene import SceneRecord
from ...scene.superelement import CHORD, MEAN, PlacedSuperelement, frame_condition
from ..assembly import Assembly
from .part_of_system import PartOfSystem

# rows of the condition of a frame whose coefficients are smaller than this part of the largest
# one say nothing
ROUNDING = 1e-14
# of the sum of magnitudes, below which the resultant of a load is what rounding leaves of 0
BALANCED = 1e-9
ROWS = ("px", "py", "pz", "rx", "ry", "rz")


def with_superelements(model: SceneRecord) -> SceneRecord:
    """The scene with the bodies, joints and relations of its superelements.

    Returns:
        The scene itself where there are none, else a copy.

    Raises:
        ModelError: a name is taken.
    """
    if not model.superelements:
        return model
    extended = copy.copy(model)
    extended.bodies, extended.joints = dict(model.bodies), dict(model.joints)
    extended.frames, extended.constraints = dict(model.frames), dict(model.constraints)
    extended.forces, extended.outputs = dict(model.forces), dict(model.outputs)
    extended.parameters = dict(model.parameters)
    for superelement in model.superelements.values():
        _add(extended, superelement)
    return extended


def _add(model: SceneRecord, superelement: PlacedSuperelement) -> None:
    record, name = superelement.record, superelement.name
    carrier = model.nodes[superelement.carrier].body
    names = [superelement.place_name(one.name) for one in record.interfaces]
    for each in superelement.places:
        _enter(model.bodies, each, model.nodes[each].body, superelement)
    here = (0.0, 0.0, 0.0)
    if superelement.carrier in names:
        here = record.interfaces[names.index(superelement.carrier)].position
    axes = _frame(model, carrier, tuple(-x for x in here), f"{name}.axes")
    for one in record.interfaces:
        if one.name == superelement.frame:
            continue
        label = superelement.place_name(one.name)
        side = _frame(model, carrier, one.position, f"{label}.undeformed", axes)
        joint = Joint(label, Elastic(one.components), side, model.nodes[label])
        _enter(model.joints, label, joint, superelement)
    if modes := record.n - record.n_boundary:
        body = Body(model, superelement.modes_body, 0, (0, 0, 0), (0,) * 6)
        _enter(model.bodies, body.name, body, superelement)
        _enter(model.joints, name, Joint(name, Modal(modes), axes, body), superelement)
    for interface, place in superelement.joined.items():
        label = superelement.place_name(interface)
        parent = model.place(f"superelement '{name}'", place)
        joint = Joint(f"{label}.fixed", Fixed(), parent, model.nodes[label])
        _enter(model.joints, joint.name, joint, superelement)
    if superelement.frame in (MEAN, CHORD):
        _add_condition(model, superelement)
    for load, factor in superelement.loads.items():
        label = superelement.place_name(load)
        factor = _shared(model, superelement, f"{label}.factor", factor)
        element = _load(superelement, load, factor, axes)
        _enter(model.forces, label, Force(label, element), superelement)
        # what stresses and readers of motions take
        _enter(model.outputs, label, Output(label, factor, ""), superelement)


def _shared(
    model: SceneRecord, superelement: PlacedSuperelement, name: str, factor: Value
) -> Value:
    """A factor, of which a number is one parameter for the load and for its output."""
    if not is_number(factor):
        return factor
    from sympy import Symbol

    _enter(model.parameters, name, Declared(name, float(factor), "", False), superelement)
    return Symbol(name)


def _load(
    superelement: PlacedSuperelement, load: str, factor: Value, axes: Frame
) -> SuperelementLoad:
    """A load of the record as forces along the coordinates and on the frame."""
    record, members, forces, at = superelement.record, list[str](), list[tuple[float, ...]](), 0
    values = record.loads[load]
    for one in record.interfaces:
        if one.name != superelement.frame:
            members.append(superelement.place_name(one.name))
            forces.append(tuple(values[at : at + len(one.components)].tolist()))
        at += len(one.components)
    if record.n > at:
        members.append(superelement.name)
        forces.append(tuple(values[at:].tolist()))
    motions = record.rigid_motions()
    resultant = motions.T @ values
    # what loads in balance leave by rounding
    resultant[abs(resultant) <= BALANCED * (abs(motions).T @ abs(values))] = 0.0
    force, torque = np.split(resultant, 2)
    return SuperelementLoad(
        axes, factor, tuple(torque.tolist()), tuple(force.tolist()), tuple(members), tuple(forces)
    )


def _frame(
    model: SceneRecord, body: Body, position: Sequence[float], name: str, base: Frame | None = None
) -> Frame:
    x, y, z = (float(value) + 0.0 for value in position)
    frame = Frame(body, (x, y, z), None, name, True, base)
    model.frames[name] = frame
    return frame


def _enter(table: dict, name: str, value: object, superelement: PlacedSuperelement) -> None:  # type: ignore[type-arg]
    if name in table:
        raise ModelError(
            f"superelement '{superelement.name}': the name '{name}' of one of its parts is taken"
        )
    table[name] = value


def _add_condition(model: SceneRecord, superelement: PlacedSuperelement) -> None:
    """The relations that hold a frame among the interfaces."""
    from sympy import Float, Symbol

    rows = frame_condition(superelement)
    motions = [
        Symbol(f"{superelement.place_name(one.name)}.{motion}")
        for one in superelement.record.interfaces
        for motion in one.components
    ]
    most = abs(rows).max()
    for row, label in zip(rows, ROWS, strict=True):
        terms = [
            Float(float(c)) * motion
            for c, motion in zip(row, motions, strict=True)
            if abs(c) > ROUNDING * most
        ]
        # a planar component has no motion that leaves its plane
        if not terms:
            continue
        name = f"{superelement.carrier}.{label}"
        unit = "m" if label.startswith("p") else "m^2"
        _enter(model.constraints, name, Constraint(name, sum(terms), unit), superelement)


def parts_of_system(model: SceneRecord, assembly: Assembly) -> tuple[PartOfSystem, ...]:
    """The superelements, their joints and axes by number.

    Args:
        model: The scene with their parts.
        assembly: Its bodies, frames and joints.
    """
    parts = []
    for name, superelement in model.superelements.items():
        record, joints, rows, at = superelement.record, list[int](), list[int](), 0
        for one in record.interfaces:
            if one.name != superelement.frame:
                joints.append(assembly.joint_number[superelement.place_name(one.name)])
                rows += range(at, at + len(one.components))
            at += len(one.components)
        if record.n > at:
            joints.append(assembly.joint_number[name])
            rows += range(at, record.n)
        axes = model.frames[f"{name}.axes"]
        frame = assembly.frame(axes, axes.name)
        modal = (f"{name}.modes",) if record.n > at else ()
        sides = (f"{superelement.place_name(one.name)}.undeformed" for one in record.interfaces)
        parts.append(
            PartOfSystem(
                name=name,
                record=record,
                frame_choice=superelement.frame,
                frame=frame,
                joints=tuple(joints),
                rows=tuple(rows),
                stiffening=superelement.stiffening,
                inertia=superelement.constants,
                loads=tuple(superelement.loads),
                bodies=(*superelement.places, *modal),
                undeformed=(axes.name, *(side for side in sides if side in model.frames)),
            )
        )
    return tuple(parts)
