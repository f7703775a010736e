"""Scenes with cables: their nodes become point masses, and their pieces force elements."""

from __future__ import annotations

import copy
from collections.abc import Callable, Sequence

import numpy as np

from ...arrays import Array
from ...elements.forces.cable import Cable as CableElement
from ...elements.joints.fixed import Fixed
from ...elements.joints.translation import Translation
from ...elements.quantity import Value
from ...elements.validation import is_expression
from ...errors import ModelError
from ...scene.beam import UNITS, Cable, End
from ...scene.body import Body
from ...scene.connections import Force, Joint
from ...scene.parameters import Declared
from ...scene.scene import SceneRecord
from ..assembly import Assembly
from ..conversion import Converter
from .hanging_shape import hanging


def with_cables(model: SceneRecord, assembled: Callable[[SceneRecord], Assembly]) -> SceneRecord:
    """The model with the parts of its cables: bodies, joints, force elements and parameters.

    Args:
        model: The scene.
        assembled: The bodies of a scene in its reference configuration.

    Returns:
        The model itself where there are no cables, else a copy.
    """
    if not model.cables:
        return model
    extended = copy.copy(model)
    extended.cables = {}
    extended.bodies, extended.joints = dict(model.bodies), dict(model.joints)
    extended.forces, extended.parameters = dict(model.forces), dict(model.parameters)
    for cable in model.cables.values():
        for key in UNITS:
            _declare(extended, cable, key)
        for name in cable.inner_nodes():
            _add_body(extended, cable, name, model.nodes[name].body)
            extended.joints[name] = Joint(name, Translation(), model.ground, extended.bodies[name])
    geometry = _Geometry(assembled(extended))
    positions: dict[str, Array] = {}
    for cable in model.cables.values():
        _add(extended, cable, geometry, positions)
    return extended


def with_joined_nodes(model: SceneRecord) -> SceneRecord:
    """The model with those nodes of its cables that joints and other cables reach, and free ends.

    Returns:
        The model itself where there are none, else a copy.
    """
    sides = (side for joint in model.joints.values() for side in (joint.parent, joint.child))
    ends = (side for cable in model.cables.values() for side in (cable.start, cable.end))
    joined = {side.body.name for side in (*sides, *ends)}
    nodes = [n for one in model.cables.values() for n in one.inner_nodes() if n in joined]
    if not nodes:
        return model
    extended = copy.copy(model)
    extended.bodies, extended.joints = dict(model.bodies), dict(model.joints)
    for name in nodes:
        extended.bodies[name] = body = model.nodes[name].body
        extended.joints[name] = Joint(name, Translation(), model.ground, body)
    return extended


class _Geometry:
    """Numbers of a scene in its reference configuration.

    Args:
        assembly: Of the scene, with the nodes of cables anywhere.
    """

    def __init__(self, assembly: Assembly) -> None:
        self.assembly = assembly

    @property
    def convert(self) -> Converter:
        return self.assembly.convert

    def value(self, value: Value, name: str, unit: str = "") -> float:
        """A number as written, or an expression at the values of the parameters."""
        value = self.assembly.model.values.get(name, value)
        if not is_expression(value):
            return float(value)
        return self.convert.defaults([self.convert.expression(value, name, unit)])[0]

    def vector(self, values: Sequence[Value], name: str, unit: str) -> Array:
        entries = zip("xyz", values, strict=True)
        return np.array([self.value(x, f"{name}.{axis}", unit) for axis, x in entries])

    def point(self, end: End, base: Body | None, name: str) -> Array:
        """Position of an end in ground axes (3)."""
        place = base if end.place is None else end.place
        rotation, position = np.eye(3), np.zeros(3)
        if place is not None:
            pose = self.assembly.reference_pose(place, name)
            numbers = np.array(self.convert.defaults((*pose.rotation, *pose.position)))
            rotation, position = numbers[:9].reshape(3, 3), numbers[9:]
        if end.point is None:
            return position
        return np.asarray(position + rotation @ self.vector(end.point, name, "m"))


def _add(
    model: SceneRecord, cable: Cable, geometry: _Geometry, positions: dict[str, Array]
) -> None:
    """The parts of one cable.

    Args:
        model: The scene that gets them.
        cable: The cable.
        geometry: Where its ends are.
        positions: Of the nodes of cables by name, extended by those of this one.
    """
    name, n = cable.name, cable.elements
    points = [
        positions[place.name]
        if place is not None and place.name in positions
        else geometry.point(end, cable.base, f"{name}.{role}")
        for role, end in zip(("start", "end"), cable.ends, strict=True)
        for place in (end.place,)
    ]
    stiffness = geometry.value(cable.EA, f"{name}.EA", "N")
    distance = float(np.linalg.norm(points[1] - points[0]))
    length = _unloaded(cable, stiffness, distance) if cable.length is None else cable.length
    if not is_expression(length) and length == 0:
        raise ModelError(
            f"cable '{name}': its ends are at one point in the reference configuration, which "
            "gives it no length; give length="
        )
    if cable.length is None:
        model.parameters[f"{name}.length"] = Declared(f"{name}.length", float(length), "m", True)
    mass_per_length = geometry.value(cable.rhoA, f"{name}.rhoA", "kg/m")
    size = geometry.value(length, f"{name}.length", "m")
    gravity = geometry.vector(geometry.assembly.model.gravity, "gravity", "m/s^2")
    shape = points[0] + np.linspace(0, 1, n + 1)[:, None] * (points[1] - points[0])
    if not cable.compression:
        shape = hanging(points[0], points[1], size, stiffness, mass_per_length * size * gravity, n)
    for k in range(n + 1):
        node = cable.node_name(k)
        if model.nodes[node].name == node:
            positions[node] = shape[k]
            q0 = tuple(float(x) for x in shape[k])
            body = model.nodes[node].body
            model.joints[node] = Joint(node, Translation(), model.ground, body, q0=q0)
        elif not is_expression(cable.rhoA) and cable.rhoA == 0:
            continue
        else:
            _add_end(model, cable, node)
    for k in range(n):
        label = name if n == 1 else f"{name}.element{k + 1}"
        if label in model.forces:
            raise ModelError(f"cable '{name}': the name '{label}' of its force is taken")
        ends = (model.nodes[cable.node_name(k)], model.nodes[cable.node_name(k + 1)])
        element = CableElement(
            *ends,
            cable.symbol("EA"),
            cable.symbol("length") / n,
            cable.symbol("damping"),
            cable.compression,
        )
        model.forces[label] = Force(label, element)


def _unloaded(cable: Cable, stiffness: float, distance: float) -> float:
    """The length without load at which a cable between its ends has its tension.

    Raises:
        ModelError: an expression of EA has a value that gives none.
    """
    if not stiffness > 0 or stiffness + cable.tension <= 0:
        raise ModelError(
            f"cable '{cable.name}': EA is {stiffness:g} at the values of the parameters, and no "
            f"length gives a tension of {cable.tension:g} then: EA is above 0 and above -tension"
        )
    return distance / (1 + cable.tension / stiffness)


def _declare(model: SceneRecord, cable: Cable, key: str) -> None:
    """The parameter of a number; a length that follows from places is still 1 m."""
    value = getattr(cable, key)
    value = 1.0 if value is None else value
    if is_expression(value) or value == 0:
        return
    name = f"{cable.name}.{key}"
    if name in model.parameters or name in model.inputs:
        raise ModelError(f"cable '{cable.name}': the name '{name}' of its number is taken")
    model.parameters[name] = Declared(name, float(value), UNITS[key], True)


def _add_end(model: SceneRecord, cable: Cable, node: str) -> None:
    """Half the mass of an element, fixed to what the cable ends in."""
    body = Body(model, node, cable.node_mass(0), (0, 0, 0), (0,) * 6)
    _add_body(model, cable, node, body)
    model.joints[node] = Joint(node, Fixed(), model.nodes[node], body)


def _add_body(model: SceneRecord, cable: Cable, name: str, body: Body) -> None:
    if name in model.bodies or name in model.joints:
        raise ModelError(f"cable '{cable.name}': the name '{name}' of its node is taken")
    model.bodies[name] = body
