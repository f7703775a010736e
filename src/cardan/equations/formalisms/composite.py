"""Composite rigid bodies: the mass matrix from the inertia of what every joint carries.

Source: Walker and Orin, J. Dyn. Sys. Meas. Control 104 (1982); Featherstone, Rigid Body Dynamics
Algorithms (2008), section 6.2.
"""

from __future__ import annotations

from ...ir.matrix import Matrix
from ..kinematics.composite_bodies import composites, projected
from ..kinematics.joint_forces import bias, forces, inverse_dynamics
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads
from .formalism import RECURSIONS, Formalism


def mass_matrix(k: Kinematics, loads: Loads) -> Matrix:
    """M (nu, nu)."""
    return projected(k, composites(k), loads)


COMPOSITE = Formalism(
    "composite",
    "M from composite bodies, h from the recursion of Newton and Euler",
    "Walker and Orin, J. Dyn. Sys. Meas. Control 104 (1982); Featherstone, Rigid Body Dynamics "
    "Algorithms (2008), section 6.2.",
    mass_matrix,
    bias,
    forces,
    inverse_dynamics,
    loops=RECURSIONS,
)
