"""Coordinates that do not move freely: prescribed ones, coupled ones, inputs that prescribe."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import Any

from ..elements.joints.joint import Component, entries
from ..errors import ModelError, near
from ..ir.derivative import forward
from ..ir.graph import ONE, Graph
from ..scene.connections import Joint as UserJoint
from ..scene.scene import SceneRecord
from .conversion import Converter
from .system import Coupling, Input, Joint, Named, Prescribed, System

replaced = dataclasses.replace


def declare_inputs(model: SceneRecord, convert: Converter) -> tuple[Input, ...]:
    """Slots of the inputs; one in a motion or constraint takes value, rate and acceleration."""
    prescribing: set[str] = set()
    # constraints are differentiated, like prescribed motions
    expressions = [joint.prescribed for joint in model.joints.values()]
    for value in (
        *expressions,
        *(constraint.expression for constraint in model.constraints.values()),
    ):
        for symbol in getattr(value, "free_symbols", ()):
            prescribing.add(symbol.name)
    inputs: list[Input] = []
    for entry in model.inputs.values():
        unit = entry.unit
        node = convert.graph.var("r", len(inputs))
        convert.define(entry.name, node, unit if entry.stated else None)
        inputs.append(Input(entry.name, unit, entry.value, entry.name in prescribing))
        if entry.name in prescribing:
            for suffix, per in (("rate", "/s"), ("acceleration", "/s^2")):
                rate_name = f"{entry.name}.{suffix}"
                if rate_name in model.inputs:
                    raise ModelError(
                        f"input '{rate_name}': input '{entry.name}' prescribes a motion, so that "
                        "its "
                        f"{suffix} has this name; rename one of them"
                    )
                if rate_name not in convert.symbols:
                    convert.define(rate_name, convert.graph.var("r", len(inputs)))
                inputs.append(Input(rate_name, unit + per if unit else ""))
    return tuple(inputs)


def input_rates(graph: Graph, inputs: Sequence[Input]) -> dict[int, int]:
    """Entries of r -> their time derivatives, for the inputs that prescribe a motion."""
    seeds = {}
    for k, entry in enumerate(inputs):
        if entry.prescribes:
            seeds[graph.var("r", k)] = graph.var("r", k + 1)
            seeds[graph.var("r", k + 1)] = graph.var("r", k + 2)
    return seeds


def define_coordinates(
    convert: Converter,
    joint: str,
    coordinates: Sequence[Component],
    speeds: Sequence[Component],
    slots: tuple[int, int],
) -> None:
    """Symbols of the coordinates and speeds of a joint.

    Raises:
        ModelError: something else has the name of a coordinate.
    """
    for block, start, prefix, components in (
        ("q", slots[0], joint, coordinates),
        ("u", slots[1], f"{joint}.u", speeds),
    ):
        for k, name in enumerate(entries(prefix, components)):
            if name in convert.symbols:
                raise ModelError(
                    f"joint '{joint}': the name of its coordinate '{name}' is taken by a "
                    "parameter, an input, another coordinate or the time; rename one of them"
                )
            convert.define(name, convert.graph.var(block, start + k))


def prescribed(
    model: SceneRecord,
    joints: Sequence[Joint],
    numbers: Mapping[str, int],
    convert: Converter,
    inputs: Sequence[Input],
) -> list[Joint]:
    """The joints, those with ``prescribed=`` with value, rate and acceleration."""
    joints_done = list(joints)
    for user in model.joints.values():
        if user.prescribed is not None and user.name in numbers:
            k = numbers[user.name]
            joints_done[k] = replaced(joints_done[k], motion=prescribe(convert, user, inputs))
    for k, joint in enumerate(joints_done):
        if joint.coupling is not None:
            joints_done[k] = _followed(convert, joints_done, joint)
    return joints_done


def _followed(convert: Converter, joints: Sequence[Joint], joint: Joint) -> Joint:
    """A joint that follows a prescribed one is prescribed itself."""
    g, chain, leader, number = convert.graph, [], joint, -1
    while leader.coupling is not None:
        chain.append(leader.coupling)
        number = leader.coupling.leader
        leader = joints[number]
    if leader.motion is None:
        return joint
    value, rate = leader.motion.value, leader.motion.rate
    acceleration, ratio = leader.motion.acceleration, leader.motion.ratio
    if leader.motion.leader >= 0:
        number = leader.motion.leader
    with g.made_by(joint.name, "motion"):
        for link in reversed(chain):
            value = g.add(g.mul(link.ratio, value), link.offset)
            rate, acceleration = g.mul(link.ratio, rate), g.mul(link.ratio, acceleration)
            ratio = g.mul(link.ratio, ratio)
    motion = Prescribed(value, rate, acceleration, number, ratio)
    return replaced(joint, coupling=None, motion=motion)


def driver(joints: Sequence[Joint], i: int) -> int:
    """The joint that is driven where a prescribed joint moves: itself, or the one it follows."""
    motion = joints[i].motion
    return i if motion is None or motion.leader < 0 else motion.leader


def driving_outputs(system: System) -> dict[int, tuple[str, str]]:
    """Names and units of the forces that move joints as prescribed, by the joints."""
    return {
        i: driving_output(joint)
        for i, joint in enumerate(system.joints)
        if joint.motion and joint.motion.leader < 0
    }


def driving_output(joint: Joint) -> tuple[str, str]:
    """Name and unit of the force that moves a joint as prescribed."""
    unit = "N" if joint.element.speeds[0].unit == "m/s" else "N*m"
    return f"{joint.name}.driving_force", unit


def prescribe(convert: Converter, joint: UserJoint, inputs: Sequence[Input]) -> Prescribed:
    """Value, rate and acceleration of a prescribed coordinate.

    Raises:
        ModelError: the joint has several coordinates, or the motion depends on more than t,
            inputs and parameters.
    """
    g, who = convert.graph, f"joint '{joint.name}' ({joint.kind.kind})"
    if len(joint.kind.coordinates) != 1:
        raise ModelError(
            f"{who}: prescribed= prescribes one coordinate, this kind has "
            f"{len(joint.kind.coordinates)}; give a value for each"
        )
    allowed = {"t"} | {entry.name for entry in inputs}
    allowed |= {p.name for p in convert.parameters if p.declared}
    for symbol in sorted(getattr(joint.prescribed, "free_symbols", ()), key=str):
        if symbol.name not in allowed:
            raise ModelError(
                f"{who}: prescribed= is a function of t, inputs and parameters; it has "
                f"'{symbol.name}'." + near(symbol.name, allowed)
            )
    with g.made_by(joint.name, "motion"):
        unit = joint.kind.coordinates[0].unit
        value = convert.scalar(joint.prescribed, f"{joint.name}.prescribed", unit)
        seeds = {g.var("t", 0): ONE} | input_rates(g, inputs)
        (rate,) = forward(g, [value], seeds)
        (acceleration,) = forward(g, [rate], seeds)
    return Prescribed(value, rate, acceleration)


def coupling(
    convert: Converter, joint: UserJoint, numbers: Mapping[str, int], joints: Sequence[Joint]
) -> Coupling:
    """Coupling of a joint to its leader.

    Raises:
        ModelError: an unknown or fixed leader, or joints with several coordinates.
    """
    couple: Any = joint.couple
    who = f"joint '{joint.name}' ({joint.kind.kind})"
    if couple.leader not in numbers:
        listed = near(couple.leader, numbers).replace(" Known:", " Joints:")
        raise ModelError(f"{who}: it follows '{couple.leader}', which does not move.{listed}")
    leader = joints[numbers[couple.leader]]
    for name, kind in ((joint.name, joint.kind), (leader.name, leader.element)):
        if len(kind.coordinates) != 1:
            raise ModelError(
                f"{who}: only joints with one coordinate can be coupled; '{name}' "
                f"({kind.kind}) has {len(kind.coordinates)}"
            )
    with convert.graph.made_by(joint.name, "coupling"):
        ratio = convert.scalar(couple.ratio, f"{joint.name}.ratio", ratio=True)
        offset = convert.scalar(couple.offset, f"{joint.name}.offset")
    return Coupling(numbers[couple.leader], ratio, offset)


def check_couplings(joints: Sequence[Joint]) -> None:
    """Followers end at a joint that moves by itself.

    Raises:
        ModelError: they follow each other in a ring.
    """
    for joint in joints:
        chain, leader = [joint.name], joint.coupling
        while leader is not None:
            follower = joints[leader.leader]
            if follower.name in chain:
                ring = ", ".join(f"'{name}'" for name in chain)
                raise ModelError(f"joints {ring} follow each other in a ring; let one move freely")
            chain.append(follower.name)
            leader = follower.coupling


def named_speeds(
    model: SceneRecord, system: System, speeds: Mapping[str, object]
) -> tuple[Named, ...]:
    """Chosen speeds as expressions in the graph of the system.

    Args:
        model: The scene.
        system: Its system; nodes are added to its graph.
        speeds: Name -> SymPy expression in ``model.u(...)``, ``model.q(...)``, motions of frames,
            parameters and t.

    Raises:
        ModelError: as many as there are speeds are wanted; an unknown symbol.
    """
    if len(speeds) != system.nu:
        raise ModelError(f"speeds: {len(speeds)} are given, but the system has {system.nu}")
    convert = Converter(model, system.graph)
    convert.moving = True
    declare_inputs(model, convert)
    for joint in system.joints:
        if joint.q >= 0:
            element, slots = joint.element, (joint.q, joint.u)
            define_coordinates(convert, joint.name, element.coordinates, element.speeds, slots)
    for name, atom in system.atoms.items():
        # what forces decide can be no speed
        if atom.quantity not in ("acceleration", "state"):
            convert.define(name, system.graph.atom(name))
    return tuple(
        Named(name, convert.expression(expression, f"speed {name}"), "")
        for name, expression in speeds.items()
    )
