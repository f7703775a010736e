"""Drives whose rotor is a body: they add a body and a joint to the scene."""

from __future__ import annotations

import copy
from dataclasses import dataclass, field
from typing import Any

from ..elements.forces.drive import Drive
from ..elements.joints.revolute import Revolute
from ..errors import ModelError
from ..model.body import Body
from ..model.connections import Couple, Joint
from ..model.model import Model


@dataclass(frozen=True)
class Rotors:
    """What the build must know about added rotors.

    Attributes:
        place: Joint of a rotor -> the driven joint, whose place it shares.
        same: Dotted name -> the name under which the same number is kept.
    """

    place: dict[str, str] = field(default_factory=dict)
    same: dict[str, str] = field(default_factory=dict)


def with_rotors(model: Model) -> tuple[Model, Rotors]:
    """The model with the rotors of its drives as bodies ``<drive>.rotor``.

    Returns:
        The model itself where no drive needs one, else a copy; and what was added.
    """
    drives = {
        name: force.element
        for name, force in model.forces.items()
        if isinstance(force.element, Drive) and force.element.rotor() is not None
    }
    if not drives:
        return model, Rotors()
    extended = copy.copy(model)
    extended.bodies, extended.joints = dict(model.bodies), dict(model.joints)
    rotors = Rotors()
    for name, drive in drives.items():
        _add(extended, name, drive, rotors)
    return extended, rotors


def _add(model: Model, name: str, drive: Drive, rotors: Rotors) -> None:
    """The rotor turns about the axis of the driven joint, carried by the parent of that."""
    rotor, joint = drive.rotor(), model.joints.get(drive.joint)
    if joint is None or rotor is None:
        return
    axis = getattr(joint.kind, "axis", None)
    if axis is None or len(joint.kind.coordinates) != 1:
        raise ModelError(
            f"force '{name}' (drive): joint '{drive.joint}' ({joint.kind.kind}) has no axis for "
            "a rotor; drive a revolute, prismatic or screw joint"
        )
    own = f"{name}.rotor"
    if own in model.bodies or own in model.joints:
        raise ModelError(f"force '{name}' (drive): the name '{own}' of its rotor is taken")
    body = Body(model, own, 0, (0, 0, 0), _about(axis, rotor.inertia))
    model.bodies[own] = body
    couple = None if rotor.elastic else Couple(drive.joint, rotor.ratio, 0)
    model.joints[own] = Joint(own, Revolute(axis), joint.parent, body, couple=couple)
    rotors.place[own] = drive.joint
    rotors.same[f"{own}.ratio"] = f"{name}.ratio"
    for k, key in ((0, "xx"), (3, "yy"), (5, "zz")):
        if body.inertia[k] is rotor.inertia:
            rotors.same[f"{own}.inertia.{key}"] = f"{name}.inertia"


def _about(axis: Any, inertia: Any) -> tuple[Any, ...]:
    """Entries xx xy xz yy yz zz of inertia a a^T / |a|^2, exact along x, y and z."""
    along = [k for k in range(3) if not (isinstance(axis[k], float) and axis[k] == 0.0)]
    if len(along) == 1:
        return tuple(inertia if i == j == along[0] else 0 for i in range(3) for j in range(i, 3))
    square = sum(a * a for a in axis)
    return tuple(inertia * axis[i] * axis[j] / square for i in range(3) for j in range(i, 3))
