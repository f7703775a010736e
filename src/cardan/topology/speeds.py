"""Generalized speeds that the user chooses, as expressions of a finished system."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..errors import ModelError
from ..model.model import Model
from .convert import Converter
from .motion import declare_inputs, define_coordinates
from .system import Named, System


def named_speeds(model: Model, system: System, speeds: Mapping[str, Any]) -> tuple[Named, ...]:
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
