"""Hamilton's equations: momenta, and the Hamilton function differentiated with these held.

Kinetic energy T = 1/2 uᵀ M u + b . u + T0, with b and T0 where motions are prescribed, has the
momenta p = M u + b and H = 1/2 (p - b)ᵀ M^-1 (p - b) - T0 + V. Since dM^-1 = -M^-1 dM M^-1, at
fixed p

    dH = -1/2 uᵀ dM u - u . db - dT0 + dV,

and pdot_r = -dH along speed r + p . c_r + Q_r, with what displacements do to speeds that are no
rates of coordinates. The state stays [q, u]: udot follows from M udot = pdot - Mdot u - bdot.

Source: Hamilton, Phil. Trans. R. Soc. 125 (1835); Goldstein, Poole and Safko, Classical Mechanics
(2002), chapter 8; Lurie, Analytical Mechanics (2002), chapter 10.
"""

from __future__ import annotations

from ...ir.arithmetic import Scalar
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ..kinematics.energies import inertia, kinetic, momenta, weight
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads
from ..kinematics.quasi_velocities import drawn, slopes, transport_terms
from ..kinematics.rotation_rates import derivative
from .formalism import Formalism, within_bodies


def mass_matrix(k: Kinematics, loads: Loads) -> Matrix:
    """M (nu, nu): derivatives of the momenta by the speeds."""
    return inertia(k, loads.rotors)


def bias(k: Kinematics, loads: Loads, gravity: Matrix, moving: bool = True) -> Matrix:
    """h (nu, 1): Mdot u + bdot + dH along the speeds - p . c."""
    static = slopes(k, weight(k, gravity))
    if not moving:
        return static
    p, u = momenta(k, loads.rotors), k.block("u", 0, k.system.nu)
    M, b, T0 = _parts(k, loads)
    # minus what of H depends on q but for V, with M^-1 (p - b) = u
    at_momenta = u.dot(M @ u) * 0.5 + u.dot(b) + T0
    return derivative(k, p) - slopes(k, at_momenta) - transport_terms(k, p) + static


def _parts(k: Kinematics, loads: Loads) -> tuple[Matrix, Matrix, Scalar]:
    """M (nu, nu), b (nu, 1) and T0 of the kinetic energy."""
    g, nu = k.graph, k.system.nu
    zero_speeds = {g.var("u", slot): ZERO for slot in range(nu)}
    expressions = (*momenta(k, loads.rotors).nodes, kinetic(k, loads.rotors).node)
    *b, T0 = rebuild(g, expressions, zero_speeds, into=g)[1]
    return inertia(k, loads.rotors), Matrix(g, nu, 1, b), Scalar(g, T0)


HAMILTON = Formalism(
    "hamilton",
    "momenta, and the Hamilton function differentiated with these held",
    "Hamilton, Phil. Trans. R. Soc. 125 (1835); Goldstein, Poole and Safko, Classical Mechanics "
    "(2002), chapter 8; Lurie, Analytical Mechanics (2002), chapter 10.",
    mass_matrix,
    bias,
    drawn,
    rewrites=within_bodies,
)
