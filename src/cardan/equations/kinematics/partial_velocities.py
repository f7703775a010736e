"""Partial velocities: what one generalized speed moves, found by differentiating velocities.

Source: Kane and Levinson, Dynamics: Theory and Applications (1985), chapters 2 and 4.
"""

from __future__ import annotations

from ...ir.derivative import forward
from ...ir.graph import ONE, ZERO
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...records import dataclass
from .kinematics import Kinematics
from .loads import Loads, actions, applied, without_potential


@dataclass(frozen=True)
class Partials:
    """Partial velocities of a body by generalized speed: angular and of the origin, body axes."""

    angular: dict[int, Matrix]
    linear: dict[int, Matrix]


def partials(k: Kinematics) -> list[Partials]:
    """Partial velocities of every body; speeds that do not move a body are left out."""
    g, nu = k.graph, k.system.nu
    result = [Partials({}, {}) for _ in k.system.bodies]
    nodes = [n for i in range(len(result)) for n in (*k.omega[i].nodes, *k.v[i].nodes)]
    for r in range(nu):
        dots = forward(g, nodes, {g.var("u", r): ONE})
        for i, partial in enumerate(result):
            angular = Matrix(g, 3, 1, dots[6 * i : 6 * i + 3])
            linear = Matrix(g, 3, 1, dots[6 * i + 3 : 6 * i + 6])
            if not (angular.is_zero and linear.is_zero):
                partial.angular[r], partial.linear[r] = angular, linear
    return result


def generalized_forces(k: Kinematics, loads: Loads) -> Matrix:
    """f (nu, 1): applied wrenches and joint forces projected on the partial velocities."""
    g, nu = k.graph, k.system.nu
    total = [ZERO] * nu
    for i, partial in enumerate(partials(k)):
        if i in loads.wrenches:
            moment, force = loads.wrenches[i]
            for r, w in partial.angular.items():
                value = (w.dot(moment) + partial.linear[r].dot(force)).node
                total[r] = g.add(total[r], value)
    for i, force in loads.joints.items():
        for r, left in k.partials_of(k.speeds[i]).items():
            total[r] = g.add(total[r], left.dot(force).node)
    return Matrix(g, nu, 1, total)


def strain_of(k: Kinematics) -> str:
    """Kind of the forces of an element as to strains, as elements in tables say it."""
    forces = [force for force in k.system.forces if force.element.strained]
    acting = [action for force in forces for action in actions(k, force)]
    if all(action.potential is None for action in acting):
        return ""
    # forces at rest besides those of the strain, or of one whose energy time changes
    zero_speeds = {k.graph.var("u", n): ZERO for n in range(k.system.nu)}
    remaining = generalized_forces(k, without_potential(k, applied(k)))
    forces_at_zero_speed = rebuild(k.graph, remaining.nodes, zero_speeds, into=k.graph)[1]
    return "alone" if all(node == ZERO for node in forces_at_zero_speed) else "mixed"
