"""Numbers of an equilibrium by name, quick enough for every point of a path."""

from __future__ import annotations

from collections.abc import Callable

from ...arrays import Array
from ...errors import ModelError, near
from ...runtime.models.loaded_model import LoadedModel
from .equilibria import EquilibriumFamily, Loaded
from .solutions import Quantity

SUFFIX = ".holding_force"


def quantity(model: LoadedModel, family: EquilibriumFamily, name: str) -> Quantity:
    """A coordinate, internal state, multiplier, output, swept value or holding force.

    Raises:
        ModelError: there is no such number.
    """
    system, way = family.problem.system, family.way
    if name in way.swept:
        return lambda at: way.values(at.s)[name]
    columns = (("q", system.coordinates), ("z", system.internals), ("lam", system.multipliers))
    for attribute, names in columns:
        if name in names:
            k = names.index(name)
            return lambda at: float(getattr(at.point.at, attribute)[k])
    locked = [*way.base.locked, *way.base.prescribed]
    if name.endswith(SUFFIX) and (of := name.removesuffix(SUFFIX)) in locked:
        place = system.place(of)[1]
        return lambda at: float(family.problem.locked_forces(at.point, at.load)[1][place])
    if name in system.outputs:
        k = system.outputs.index(name)
        return lambda at: output(model, at, k)
    names_there = [*system.coordinates, *way.swept, *system.outputs, *(n + SUFFIX for n in locked)]
    raise ModelError(f"continuation: there is no '{name}' to watch.{near(name, names_there)}")


def output(model: LoadedModel, at: Loaded, k: int) -> float:
    """A declared output."""
    m = at.point.at
    changed = model.with_parameters(dict(m.parameters)) if m.parameters else model
    some = {name: values for name, values in (("r", m.r), ("z", m.z), ("s", m.s)) if len(values)}
    outputs: Callable[..., Array] = changed.outputs
    return float(outputs(m.q, m.u, t=m.t, **some)[k])
