"""Rotors that are bodies: their elements add a body and a joint to the scene."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from dataclasses import field
from typing import Any

from ..elements.forces.force import RotorBody
from ..elements.joints.revolute import Revolute
from ..elements.validation import is_expression
from ..errors import ModelError
from ..records import dataclass
from ..scene.body import Body
from ..scene.connections import Couple, Force, Joint
from ..scene.frame import Place
from ..scene.parameters import Declared
from ..scene.scene import SceneRecord


@dataclass(frozen=True)
class Rotors:
    """Data of added rotors for the build.

    Attributes:
        place: Joint of a rotor -> the driven joint, whose place it shares.
        same: Dotted name -> the name under which the same number is kept.
    """

    place: dict[str, str] = field(default_factory=dict)
    same: dict[str, str] = field(default_factory=dict)


def with_rotors(model: SceneRecord) -> tuple[SceneRecord, Rotors]:
    """The model with the rotors of its elements as bodies ``<element>.rotor``.

    Returns:
        The model itself where no element needs one, else a copy; and what was added.
    """
    rotor_forces = [
        (force, rotor)
        for force in model.forces.values()
        if (rotor := force.element.rotor()) is not None
    ]
    if not rotor_forces:
        return model, Rotors()
    extended = copy.copy(model)
    extended.bodies, extended.joints = dict(model.bodies), dict(model.joints)
    extended.parameters = dict(model.parameters)
    rotors = Rotors()
    for force, rotor in rotor_forces:
        parent = None if rotor.joint else model.place(f"force '{force.name}'", rotor.frame)
        _add(extended, force, rotor, parent, rotors)
    return extended, rotors


def with_rotors_on(model: SceneRecord, bodies: Sequence[Body]) -> tuple[Body, ...]:
    """Bodies and the rotors that they carry.

    Args:
        model: The scene with its rotors.
        bodies: Bodies of the user.
    """
    added = (f"{force.name}.rotor" for force in model.forces.values() if force.element.rotor())
    rotor_bodies = (model.bodies[n] for n in added if model.joints[n].parent.body in bodies)
    return (*bodies, *rotor_bodies)


def _add(
    model: SceneRecord, force: Force, rotor: RotorBody, parent: Place | None, rotors: Rotors
) -> None:
    """The rotor, and the joint that carries it; ``parent`` where it is on no joint."""
    who, rotor_name = f"force '{force.name}' ({force.element.kind})", f"{force.name}.rotor"
    if rotor_name in model.bodies or rotor_name in model.joints:
        raise ModelError(f"{who}: the name '{rotor_name}' of its rotor is taken")
    if rotor.joint and rotor.joint not in model.joints:
        # the build names it
        return
    axis = _axis_of(model, who, rotor.joint) if rotor.joint else rotor.axis
    body = Body(model, rotor_name, 0, (0, 0, 0), _about(axis, rotor.inertia))
    model.bodies[rotor_name] = body
    couple = motion = None
    if parent is None:
        parent = model.joints[rotor.joint].parent
        rotors.place[rotor_name] = rotor.joint
    if rotor.ratio is not None:
        couple = Couple(rotor.joint, rotor.ratio, 0)
        rotors.same[f"{rotor_name}.ratio"] = f"{force.name}.ratio"
    if rotor.speed is not None:
        motion = _angle_of(model, f"{force.name}.speed", rotor.speed)
    model.joints[rotor_name] = Joint(
        rotor_name, Revolute(axis), parent, body, prescribed=motion, couple=couple
    )
    for k, key in ((0, "xx"), (3, "yy"), (5, "zz")):
        if body.inertia[k] is rotor.inertia:
            rotors.same[f"{rotor_name}.inertia.{key}"] = f"{force.name}.inertia"


def _axis_of(model: SceneRecord, who: str, name: str) -> Any:
    """Axis of the joint whose parent carries a rotor."""
    joint = model.joints[name]
    axis = getattr(joint.kind, "axis", None)
    if axis is None or len(joint.kind.coordinates) != 1:
        raise ModelError(
            f"{who}: joint '{name}' ({joint.kind.kind}) has no axis for a rotor; drive a revolute, "
            "prismatic or screw joint"
        )
    return axis


def _angle_of(model: SceneRecord, name: str, speed: Any) -> Any:
    """Angle of a rotor at constant speed; a number is a parameter of that name."""
    from sympy import Symbol

    if not is_expression(speed):
        if name in model.parameters or name in model.inputs:
            raise ModelError(f"the name '{name}' stands for two numbers; rename one of its owners")
        model.parameters[name] = Declared(name, float(speed), "rad/s", False)
        speed = Symbol(name)
    elif not {symbol.name for symbol in speed.free_symbols} <= set(model.parameters):
        raise ModelError(
            f"'{name}' is constant: an expression of parameters. Join a body by a Revolute joint "
            "with prescribed= for a wheel whose speed is prescribed otherwise"
        )
    return speed * Symbol("t")


def _about(axis: Any, inertia: Any) -> tuple[Any, ...]:
    """Entries xx xy xz yy yz zz of inertia a a^T / |a|^2, exact along x, y and z."""
    along = [k for k in range(3) if not (isinstance(axis[k], float) and axis[k] == 0.0)]
    if len(along) == 1:
        return tuple(inertia if i == j == along[0] else 0 for i in range(3) for j in range(i, 3))
    square = sum(a * a for a in axis)
    return tuple(inertia * axis[i] * axis[j] / square for i in range(3) for j in range(i, 3))
