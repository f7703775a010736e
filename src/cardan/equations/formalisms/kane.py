"""Kane's method: partial velocities, inertia forces projected on them.

Velocities are differentiated, not accumulated: partial velocities with respect to the generalized
speeds, accelerations with respect to time. Any set of generalized speeds will do.

Source: Kane and Levinson, Dynamics: Theory and Applications (1985), chapters 2 to 4 and 6.
"""

from __future__ import annotations

from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ..kinematics.inertia import of_body
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads
from ..kinematics.partial_velocities import generalized_forces, partials
from ..kinematics.rotation_rates import derivative
from .formalism import Formalism, within_bodies


def mass_matrix(k: Kinematics, loads: Loads) -> Matrix:
    """M (nu, nu): ``M = sum over bodies of partial velocity r . partial momentum s``."""
    k.graph.describe(mass_matrix)
    g, nu = k.graph, k.system.nu
    lower = [[ZERO] * nu for _ in range(nu)]
    for i, partial in enumerate(partials(k)):
        inertia = of_body(k, i)
        with g.made_by(k.owner(i), "M"):
            for s, w in partial.angular.items():
                momentum = inertia.momentum(Matrix.vstack(w, partial.linear[s]))
                for r in partial.angular:
                    if r >= s:
                        twist = Matrix.vstack(partial.angular[r], partial.linear[r])
                        lower[r][s] = g.add(lower[r][s], twist.dot(momentum).node)
    for i, rotor in loads.rotors.items():
        with g.made_by(k.system.joints[i].name, "M"):
            rates = k.partials_of(k.speeds[i])
            for s, right in rates.items():
                for r, left in rates.items():
                    if r >= s:
                        value = left.dot(rotor @ right).node
                        lower[r][s] = g.add(lower[r][s], value)
    return Matrix(g, nu, nu, [lower[max(r, s)][min(r, s)] for r in range(nu) for s in range(nu)])


def bias(k: Kinematics, loads: Loads, gravity: Matrix, moving: bool = True) -> Matrix:
    """h (nu, 1): inertia forces at udot = 0 and gravity, projected on the partial velocities.

    ``h = sum over bodies of partial velocity r . rate of momentum at udot = 0``.
    With ``moving`` False the speeds and prescribed motions rest and only gravity is left.
    """
    g, nu = k.graph, k.system.nu
    g.describe(bias)
    total = [ZERO] * nu
    for i, partial in enumerate(partials(k)):
        inertia = of_body(k, i)
        with g.made_by(k.owner(i), "h"):
            a = -(k.ground_rotation[i].T @ gravity)
            moment, force = inertia.moment.cross(a), a * inertia.mass
            if moving:
                inertial_moment, inertial_force = _inertia_force(k, i)
                moment, force = moment + inertial_moment, force + inertial_force
            for r, w in partial.angular.items():
                value = (w.dot(moment) + partial.linear[r].dot(force)).node
                total[r] = g.add(total[r], value)
    if moving:
        _add_rotor_bias(k, loads, total)
    return Matrix(g, nu, 1, total)


def _inertia_force(k: Kinematics, i: int) -> tuple[Matrix, Matrix]:
    """Rate of momentum at udot = 0 about the origin of a body, from differentiated velocities."""
    inertia, omega = of_body(k, i), k.omega[i]
    alpha = derivative(k, omega)
    a = derivative(k, k.v[i]) + omega.cross(k.v[i])
    moment = inertia.tensor @ alpha + omega.cross(inertia.tensor @ omega)
    force = a * inertia.mass + alpha.cross(inertia.moment)
    return (moment + inertia.moment.cross(a), force + omega.cross(omega.cross(inertia.moment)))


def _add_rotor_bias(k: Kinematics, loads: Loads, total: list[int]) -> None:
    for i, rotor in loads.rotors.items():
        accelerated = rotor @ derivative(k, k.speeds[i])
        for r, left in k.partials_of(k.speeds[i]).items():
            total[r] = k.graph.add(total[r], left.dot(accelerated).node)


KANE = Formalism(
    "kane",
    "partial velocities; inertia forces projected on them",
    "Kane and Levinson, Dynamics: Theory and Applications (1985), chapters 2 to 4 and 6.",
    mass_matrix,
    bias,
    generalized_forces,
    # velocities are taken apart in axes that turn with the bodies
    rewrites=within_bodies,
    refused=("parallel",),
)
