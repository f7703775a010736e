"""Momenta and energy of a system with their rates, as expressions and at states drawn by chance."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...ir.arithmetic import Scalar
from ...ir.derivative import forward
from ...ir.function import Function
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...records import dataclass
from ..functions import event_functions, outputs
from ..functions.context import Context
from ..functions.random_states import States, drawn, function_of
from . import energies

if TYPE_CHECKING:
    from ..record import EquationRecord

# rounding of rates, relative to their terms
ZERO_RATE = 1e-8
# momenta of single speeds are looked at up to so many
LARGEST = 24
MOMENTUM, ANGULAR = "kg*m/s", "kg*m^2/s"
AXES = "xyz"


@dataclass(frozen=True)
class Candidate:
    """A quantity that may be constant."""

    name: str
    unit: str
    value: Scalar


def candidates(equations: EquationRecord, c: Context) -> tuple[list[Candidate], Candidate]:
    """Momenta, in the order in which they are preferred, and the energy."""
    k, g = c.k, c.k.graph
    kinetic, potential = outputs.energy(c.d)
    total = outputs.momentum(k)
    angular, linear = total.block(slice(0, 3)), total.block(slice(3, 6))
    listed = [
        Candidate(f"linear momentum along {x}", MOMENTUM, linear[i]) for i, x in enumerate(AXES)
    ]
    listed += [
        Candidate(f"angular momentum about {x}", ANGULAR, angular[i]) for i, x in enumerate(AXES)
    ]
    names, units = c.names["u"], c.units["u"]
    if 0 < len(names) <= LARGEST:
        for j, node in enumerate(energies.momenta(k, c.d.loads.rotors).nodes):
            unit = {"rad/s": ANGULAR, "m/s": MOMENTUM}.get(units[j], "")
            listed.append(
                Candidate(f"momentum of {names[j].replace('.u', '', 1)}", unit, Scalar(g, node))
            )
    if any(body.mass != ZERO for body in k.system.bodies):
        about = angular - outputs.center_of_mass(k).cross(linear)
        listed += [
            Candidate(f"angular momentum about {x} through the center of mass", ANGULAR, about[i])
            for i, x in enumerate(AXES)
        ]
    return listed, Candidate("energy", "J", kinetic + potential)


def watched(equations: EquationRecord, c: Context, every: list[Candidate]) -> Function:
    """Values and rates of all candidates, udot given."""
    g, k = c.k.graph, c.k
    nodes = [one.value.node for one in every]
    seeds = dict(k.time_seeds)
    seeds |= {g.var("u", j): g.var("udot", j) for j in range(k.system.nu)}
    if k.system.nz:
        seeds |= {g.var("z", j): node for j, node in enumerate(event_functions.rates(c.d).nodes)}
    rates = forward(g, nodes, seeds)
    n = len(nodes)
    named = {"value": Matrix(g, n, 1, nodes), "rate": Matrix(g, n, 1, rates)}
    return function_of(equations, c, named)


@dataclass(frozen=True)
class Observation:
    """Values and rates (n, candidates) relative to what a candidate usually amounts to (scale)."""

    values: Array
    rates: Array
    scale: Array

    @property
    def constant(self) -> list[int]:
        """Candidates whose rate vanishes."""
        largest = np.abs(self.rates).max(axis=0, initial=0.0)
        return [int(k) for k in np.flatnonzero(largest < ZERO_RATE)]


def drawn_at(
    equations: EquationRecord, count: int, rng: np.random.Generator, base: dict[str, Array]
) -> States:
    """States at times of their own."""
    return drawn(equations, count, rng, base | {"t": rng.normal(size=(count, 1))})


def observed(watched: Function, states: States) -> Observation:
    """The candidates at the states at which all are finite."""
    if not states.count:
        size = watched.outputs[0].size
        return Observation(np.zeros((0, size)), np.zeros((0, size)), np.ones(size))
    results = states.of(watched)
    value, rate = results["value"][..., 0], results["rate"][..., 0]
    udot, u = states.values["udot"], states.values["u"]
    sizes = 1.0 + np.abs(udot).max(axis=1, initial=0.0) + np.square(u).sum(axis=1)
    fine = np.isfinite(value).all(axis=1) & np.isfinite(rate).all(axis=1) & (sizes < 1e6)
    value, rate = value[fine], rate[fine] / sizes[fine, np.newaxis]
    usual = np.sqrt(np.square(value).mean(axis=0)) if len(value) else np.ones(value.shape[1])
    # one that is zero throughout has no rate either
    scale = np.where(usual > 0.0, usual, 1.0)
    return Observation(value / scale, rate / scale, scale)
