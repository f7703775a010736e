"""Checked arguments of a trim."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import ModelError, SolveError, listed, named, near
from ..mechanisms.consistent_rates import read
from ..systems.joint_system import JointSystem
from .trim_problem import FORCE, Trimming

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel


def trimming(
    system: JointSystem,
    targets: object,
    free: Iterable[str],
    u: object,
    inputs: object,
    parameters: object,
    t: float,
) -> Trimming:
    """The trim that a user described, checked.

    Raises:
        ModelError: unknown names, a name in both. SolveError: values that are not finite.
    """
    aims = {n: float(v) for n, v in named("targets", targets, "'steer': 0.1").items()}
    names = (*system.coordinates, *system.speeds, *system.outputs)
    for name, value in aims.items():
        if name not in names:
            raise ModelError(
                f"trim: targets '{name}' is not a coordinate, speed or output.{near(name, names)}"
            )
        if not np.isfinite(value):
            raise SolveError(f"trim: '{name}' has the target {value!r}; it must be finite")
    kinds = {name: _kind(system, name) for name in listed("free", free, "torque")}
    both = next((name for name in kinds if name in aims), None)
    if both is not None:
        raise ModelError(f"trim: '{both}' is a target and free: leave one out")
    start = by_entry(system.model, named("u", u, "'spin': 30"))
    base = dict(named("parameters", parameters, "'mass': 2"))
    system.changed(base)
    if not np.isfinite(t):
        raise SolveError(f"t={t!r}: it must be finite")
    return Trimming(system, aims, kinds, start, base, system.input_vector(inputs), float(t))


def by_entry(model: LoadedModel, speeds: Mapping[str, Any]) -> dict[str, float]:
    """Speeds by their own names, of joints and speeds with values.

    Raises:
        ModelError, ArgumentError, SolveError: unknown names, values of a wrong shape, not finite.
    """
    places, values = read("u", model, speeds)
    return {model.speeds[k]: float(x) for k, x in zip(places, values, strict=True)}


def _kind(system: JointSystem, name: str) -> str:
    """Kind of a free quantity.

    Raises:
        ModelError: there is nothing of the kind.
    """
    forces = [f"{n}{FORCE}" for n in (*system.speeds, *system.coordinates)]
    if name in system.inputs:
        return "input"
    if name in system.speeds:
        return "speed"
    base_name = name.removesuffix(FORCE)
    if name.endswith(FORCE) and (base_name in system.speeds or f"{base_name}.u" in system.speeds):
        return "force"
    if name in system.model.parameters:
        return "parameter"
    names = (*system.inputs, *system.speeds, *forces, *system.model.parameters)
    raise ModelError(f"trim: there is nothing '{name}' that could be free.{near(name, names)}")
