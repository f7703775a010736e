"""Lagrange's equations in quasi-velocities: energies differentiated as expressions.

With the momenta p = dT/du, displacements along speed r and what they do to the speeds,

    d/dt p_r - dT along r - p . c_r + dV along r = Q_r,

in which c_r vanishes where speeds are rates of coordinates: these are the equations of Boltzmann
and Hamel. dT and dV take one sweep from the energy inwards, d/dt p another.

Source: Lagrange, Mécanique analytique (1788); Hamel, Z. Math. Phys. 50 (1904); Lurie, Analytical
Mechanics (2002), chapters 6 and 7.
"""

from __future__ import annotations

from ...ir.matrix import Matrix
from ..kinematics.energies import inertia, kinetic, momenta, weight
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads
from ..kinematics.quasi_velocities import drawn, slopes, transport_terms
from ..kinematics.rotation_rates import derivative
from .formalism import Formalism, within_bodies


def mass_matrix(k: Kinematics, loads: Loads) -> Matrix:
    """M (nu, nu): kinetic energy differentiated twice by the speeds."""
    return inertia(k, loads.rotors)


def bias(k: Kinematics, loads: Loads, gravity: Matrix, moving: bool = True) -> Matrix:
    """h (nu, 1): d/dt p at udot = 0 - dT along the speeds - p . c + dV along the speeds."""
    static = slopes(k, weight(k, gravity))
    if not moving:
        return static
    p = momenta(k, loads.rotors)
    return derivative(k, p) - slopes(k, kinetic(k, loads.rotors)) - transport_terms(k, p) + static


LAGRANGE = Formalism(
    "lagrange",
    "energies differentiated along the speeds, with Hamel's symbols",
    "Lagrange, Mécanique analytique (1788); Hamel, Z. Math. Phys. 50 (1904); Lurie, Analytical "
    "Mechanics (2002), chapters 6 and 7.",
    mass_matrix,
    bias,
    drawn,
    rewrites=within_bodies,
)
