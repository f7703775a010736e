"""The energy of motions that keep it, by which their cycles are told apart.

A system that keeps its energy has a family of cycles for every mode, all with the same parameters.
Laps then leave one equation less: what a lap misses along the gradient of the energy follows from
the rest. The energy of the start takes its place.

Source: F. J. Munoz-Almaraz, E. Freire, J. Galan, E. Doedel, A. Vanderbauwhede, Physica D 181
(2003), 1-38 (continuation of periodic orbits in conservative systems).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace

import numpy as np

from ...arrays import Array
from ...records import dataclass
from ..systems.dynamic_system import DynamicSystem, Moment
from .flow import Flow

ENERGY = "energy"  # as it is swept
WORKS = 64  # of positions that are kept
NODES = 20  # of the integral of forces, from 0 to 1
PLACES, WEIGHTS = (0.5 * part for part in np.polynomial.legendre.leggauss(NODES))
PLACES += 0.5
# differences of fourth order, by sizes of the system
STEP, SHARES, FACTORS = 1e-3, (-2.0, -1.0, 1.0, 2.0), np.array([1.0, -8.0, 8.0, -1.0]) / 12


def _slopes(places: Array) -> Array:
    """Derivatives (n - 2, n) at the inner ones of some places, of the polynomial through all.

    Source: J.-P. Berrut, L. N. Trefethen, SIAM Review 46 (2004), 501-517, section 9.3.
    """
    gaps = places[:, None] - places + np.eye(len(places))
    weights = 1 / gaps.prod(axis=1)
    slopes = weights / weights[:, None] / gaps
    np.fill_diagonal(slopes, 0.0)
    np.fill_diagonal(slopes, -slopes.sum(axis=1))
    return np.asarray(slopes[1:-1])


SLOPES = _slopes(np.concatenate([[0.0], PLACES, [1.0]]))


def _powers(system: DynamicSystem, at: Moment, positions: Array) -> Array:
    """Power (n - 2,) of forces in a motion over the time 1 through positions (n, nq), inside."""
    still, powers = np.zeros(len(at.u)), list[float]()
    for q, rate in zip(positions[1:-1], SLOPES @ positions, strict=True):
        there = replace(at, q=q, u=still, udot=still)
        # constraints do no work along what they allow
        forces = -system.balance(there)[: len(still)]
        speeds = np.linalg.lstsq(system.kinematic_matrix(there), rate)[0]
        powers.append(float(forces @ speeds))
    return np.array(powers)


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
    _works: dict[tuple[object, ...], float] = field(default_factory=dict, repr=False)

    def target(self, values: Mapping[str, float]) -> float:
        """The energy [J] that a cycle has to have."""
        return values.get(ENERGY, self.value)

    def energy(self, system: DynamicSystem, flow: Flow, at: Moment) -> float:
        """Energy [J] of a state: that of its speeds and the work of forces up to the rest.

        The work is taken along a straight motion at no speed, moved onto the constraints; it is
        the same along all others.
        """
        t, x = at.t, np.concatenate([at.q, at.u])
        q, u, _ = flow.parts_of(flow.closed(x, self.modes, t))
        kinetic = 0.5 * float(u @ flow.mass_matrix(q, t) @ u)
        # starts that differ in their speeds lie at the same place
        key = (q.tobytes(), *sorted((at.parameters or {}).items()), at.r.tobytes())
        if key not in self._works:
            if len(self._works) >= WORKS:
                self._works.clear()
            self._works[key] = self._work_to(system, flow, replace(at, q=q, s=self.modes))
        return kinetic - self._works[key]

    def _work_to(self, system: DynamicSystem, flow: Flow, at: Moment) -> float:
        """Work of forces [J] from the state of rest to a position."""
        q, start, t = at.q, flow.parts_of(self.equilibrium)[0], at.t
        way = system.difference(start, q)
        if not np.any(way):
            return 0.0
        there = np.array([system.integrate(start, place * way) for place in PLACES])
        still = np.concatenate([there, np.zeros((NODES, len(at.u)))], axis=1)
        if len(system.rows):
            closed = [flow.closed(one, self.modes, t)[: len(q)] for one in still]
            return float(WEIGHTS @ _powers(system, at, np.vstack([start, *closed, q])))
        # forces are what gives a state at rest its acceleration
        accelerations = flow.rates(still, self.modes, t)[:, len(q) :]
        powers = np.einsum("kij,kj,i->k", flow.mass_matrix(there, t), accelerations, way)
        return float(WEIGHTS @ powers)

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
