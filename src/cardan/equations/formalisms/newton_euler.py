"""Newton-Euler equations of every body: accelerations outward, forces inward.

Source: Luh, Walker and Paul, J. Dyn. Sys. Meas. Control 102 (1980).
"""

from __future__ import annotations

from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ..kinematics.joint_forces import bias, forces, inverse_dynamics
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads
from .formalism import RECURSIONS, Formalism


def mass_matrix(k: Kinematics, loads: Loads) -> Matrix:
    """M (nu, nu): column by column, the forces of unit accelerations at rest without gravity."""
    g, nu = k.graph, k.system.nu
    still = Loads({}, {}, loads.potential, (), loads.rotors)
    columns = []
    zero_gravity = Matrix.zeros(g, 3)
    for j in range(nu):
        unit = Matrix(g, nu, 1, [1 if i == j else ZERO for i in range(nu)])
        columns.append(inverse_dynamics(k, unit, still, zero_gravity, moving=False))
    # the two triangles agree; the lower one stands for both
    rows = [[columns[min(i, j)][max(i, j)] for j in range(nu)] for i in range(nu)]
    return Matrix.of(g, rows) if nu else Matrix(g, 0, 0, ())


NEWTON_EULER = Formalism(
    "newton_euler",
    "accelerations outward, forces inward; M from unit accelerations",
    "Luh, Walker and Paul, J. Dyn. Sys. Meas. Control 102 (1980).",
    mass_matrix,
    bias,
    forces,
    inverse_dynamics,
    loops=RECURSIONS,
)
