"""The energy of motions that keep it, by which their cycles are told apart.

A system that keeps its energy has a family of cycles for every mode, all with the same parameters.
Laps then leave one equation less: what a lap misses along the gradient of the energy follows from
the rest. The energy of the start takes its place.

Source: F. J. Munoz-Almaraz, E. Freire, J. Galan, E. Doedel, A. Vanderbauwhede, Physica D 181
(2003), 1-38 (continuation of periodic orbits in conservative systems).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ...arrays import Array
from ..systems.dynamic_system import DynamicSystem
from .flow import Flow

ENERGY = "energy"  # as it is swept
NODES = 20  # of the integral of forces, from 0 to 1
PLACES, WEIGHTS = (0.5 * part for part in np.polynomial.legendre.leggauss(NODES))
PLACES += 0.5
# differences of fourth order, by sizes of the system
STEP, SHARES, FACTORS = 1e-3, (-2.0, -1.0, 1.0, 2.0), np.array([1.0, -8.0, 8.0, -1.0]) / 12


@dataclass(frozen=True, eq=False)
class EnergyLevel:
    """Energies over that of a state of rest.

    Attributes:
        equilibrium, modes: State (nx,) and modes (ns,) whose energy is 0.
        size: An energy [J] that is large.
        value: The energy [J] where it is not swept.
    """

    equilibrium: Array
    modes: Array
    size: float
    value: float

    def target(self, values: Mapping[str, float]) -> float:
        """The energy [J] that a cycle has to have."""
        return values.get(ENERGY, self.value)

    def energy(self, system: DynamicSystem, flow: Flow, x: Array, t: float) -> float:
        """Energy [J] of a state: that of its speeds and the work of forces up to the rest.

        The work is taken along a straight motion at no speed; it is the same along all others.
        """
        q, u, _ = flow.parts_of(x)
        start = flow.parts_of(self.equilibrium)[0]
        way = system.difference(start, q)
        kinetic = 0.5 * float(u @ flow.mass_matrix(q, t) @ u)
        if not np.any(way):
            return kinetic
        there = np.array([system.integrate(start, place * way) for place in PLACES])
        still = np.concatenate([there, np.zeros((NODES, len(u)))], axis=1)
        # forces are what gives a state at rest its acceleration
        accelerations = flow.rates(still, self.modes, t)[:, len(q) :]
        work = np.einsum("kij,kj,i->k", flow.mass_matrix(there, t), accelerations, way)
        return kinetic - float(WEIGHTS @ work)

    def gradient(self, system: DynamicSystem, flow: Flow, x: Array, t: float) -> Array:
        """The direction (n,) along which the energy grows, of increments."""
        q, u, _ = flow.parts_of(x)
        M = flow.mass_matrix(q, t)
        still = np.concatenate([q, 0 * u])
        along = -M @ flow.rates(still, self.modes, t)[len(q) :]
        if np.any(u):
            along = along + self._by_inertia(system, flow, q, u, t)
        return np.concatenate([along, M @ u])

    def _by_inertia(self, system: DynamicSystem, flow: Flow, q: Array, u: Array, t: float) -> Array:
        """Slopes (nu,) of the kinetic energy by increments of the position, by differences."""
        sizes = STEP * system.columns
        there = np.array(
            [system.integrate(q, share * step) for share in SHARES for step in np.diag(sizes)]
        )
        kinetic = 0.5 * np.einsum("kij,i,j->k", flow.mass_matrix(there, t), u, u)
        slopes: Array = FACTORS @ kinetic.reshape(len(SHARES), len(u)) / sizes
        return slopes
