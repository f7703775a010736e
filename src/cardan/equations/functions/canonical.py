"""Momenta, their rates and the Hamilton function of a system.

Source: Goldstein, Poole and Safko, Classical Mechanics (2002), chapter 8; Lurie, Analytical
Mechanics (2002), chapter 10.
"""

from __future__ import annotations

from ...ir.function import Output
from ...ir.matrix import Matrix
from ..constraints.reaction_friction import friction_forces
from ..kinematics import energies
from ..kinematics.quasi_velocities import slopes, transport_terms
from .context import Context, recipe

UNITS = {"N*m": "kg*m^2/s", "N": "kg*m/s"}


@recipe
def momenta(c: Context) -> tuple[Output, ...]:
    """p = dT/du."""
    p = energies.momenta(c.k, c.d.loads.rotors)
    names = tuple(f"{speed}.momentum" for speed in c.names["u"])
    units = tuple(UNITS.get(unit, "") for unit in c.units["tau"])
    return (Output("momenta", (p.rows,), p.nodes, names, units),)


@recipe
def momentum_rates(c: Context) -> tuple[Output, ...]:
    """pdot under tau, the forces of the model and those of constraints.

    No acceleration is needed but where constraints or friction in pressed joints ask for it.
    """
    d, k = c.d, c.k
    if friction_forces(k.system):
        d.forward(d.tau)
    kinetic = energies.kinetic(k, d.loads.rotors)
    p = energies.momenta(k, d.loads.rotors)
    rates = slopes(k, kinetic) + transport_terms(k, p) - slopes(k, energies.weight(k, d.gravity))
    rates = rates + d.forces() + d.tau
    if k.system.closed:
        rates = rates + d.constraints.jacobian.T @ d.bound(d.tau)[1]
    names = tuple(f"{speed}.momentum_rate" for speed in c.names["u"])
    return (Output("momentum_rates", (rates.rows,), rates.nodes, names, c.units["tau"]),)


@recipe
def hamiltonian(c: Context) -> tuple[Output, ...]:
    """H = p . u - T + V, the energy where no motion is prescribed."""
    d, k = c.d, c.k
    u: Matrix = k.block("u", 0, k.system.nu)
    p = energies.momenta(k, d.loads.rotors)
    potential = d.loads.potential + energies.weight(k, d.gravity)
    value = p.dot(u) - energies.kinetic(k, d.loads.rotors) + potential
    return (Output("hamiltonian", (), (value.node,), ("hamiltonian",), ("J",)),)
