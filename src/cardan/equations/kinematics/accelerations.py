"""Accelerations of the bodies of a tree, and the forces that they take.

With U = [alpha] + [omega][omega] the force and moment of a body about its origin are F = m a + U h
and N = 2 vee(skew(U J)) + h x a, where J is the second moment of mass; U also carries the origin of
the next body.

Source: Luh, Walker and Paul, J. Dyn. Sys. Meas. Control 102 (1980); Balafoutis and Patel, Dynamic
Analysis of Robot Manipulators (1991), for the second moment form.
"""

from __future__ import annotations

from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.moments import Inertia
from ..recursion.recursion_boundary import CELLS
from .inertia import of_body, second_moment_of_body
from .kinematics import Kinematics
from .loads import Loads


@dataclass(frozen=True)
class Accelerations:
    """Angular acceleration and acceleration of the origin of every body minus gravity, body axes.

    ``gradient`` is U = [alpha] + [omega][omega] of every body.
    """

    alpha: list[Matrix]
    a: list[Matrix]
    gradient: list[Matrix]


def accelerations(
    k: Kinematics, udot: list[Matrix], gravity: Matrix, moving: bool = True, word: str = ""
) -> Accelerations:
    """Accelerations of all bodies, outward, with c of :meth:`.Kinematics.convective`.

    ``alpha = Rᵀ alpha_parent + S_w udot + c_w``,
    ``a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v``, where the ground has a = -gravity, and
    ``U = [alpha] + [omega][omega]``.

    Args:
        k: Motion of the tree.
        udot: Acceleration along the speeds of every joint (nu of the joint, 1).
        gravity: In ground axes (3, 1); it enters as an acceleration of the ground by -gravity.
        moving: False at rest, where all velocity products vanish.
        word: Begins the names of the quantities, where there are several sets of them.
    """
    result = Accelerations([], [], [])
    k.graph.describe(accelerations)
    for i, (body, joint) in enumerate(zip(k.system.bodies, k.joints, strict=True)):
        name, to_child = k.owner(i), joint.rotation.T
        with k.graph.made_by(name, f"{word}alpha"):
            relative = joint.S @ udot[i]
            if moving:
                relative = relative + k.convective(i)
            alpha, a = relative.block(slice(0, 3)), relative.block(slice(3, 6))
            if body.parent >= 0:
                alpha = to_child @ result.alpha[body.parent] + alpha
            result.alpha.append(k.carry(i, f"{word}alpha", alpha))
        with k.graph.made_by(name, f"{word}a"):
            if body.parent >= 0:
                at_joint = result.a[body.parent] + result.gradient[body.parent] @ joint.position
            else:
                at_joint = -gravity
            result.a.append(k.carry(i, f"{word}a", to_child @ at_joint + a))
        with k.graph.made_by(name, f"{word}U"):
            omega = k.omega[i] if moving else Matrix.zeros(k.graph, 3)
            result.gradient.append(k.carry(i, f"{word}U", _gradient(omega, result.alpha[i]), CELLS))
    return result


def _gradient(omega: Matrix, alpha: Matrix) -> Matrix:
    """[alpha] + [omega][omega]."""
    x, y, z = omega
    xx, yy, zz = x * x, y * y, z * z
    xy, xz, yz = x * y, x * z, y * z
    return Matrix.of(
        omega.graph,
        [
            [-(yy + zz), xy - alpha[2], xz + alpha[1]],
            [xy + alpha[2], -(xx + zz), yz - alpha[0]],
            [xz - alpha[1], yz + alpha[0], -(xx + yy)],
        ],
    )


def inertia_force(k: Kinematics, i: int, acc: Accelerations) -> tuple[Matrix, Matrix]:
    """Rate of change of momentum of a body about its origin: moment and force.

    ``inertia_force = [2 vee(skew(U J)) + h x a; m a + U h]``, h the first and J the second moment.
    """
    k.graph.describe(inertia_force)
    inertia, second = of_body(k, i), second_moment_of_body(k, i)
    with k.graph.made_by(k.owner(i), "inertia_force"):
        return second_moment_force(inertia, second, acc.a[i], acc.gradient[i])


def second_moment_force(
    inertia: Inertia, second: Matrix, a: Matrix, gradient: Matrix
) -> tuple[Matrix, Matrix]:
    """Moment and force that accelerate an inertia: origin by a, field by U = ``gradient``."""
    moment = _second_moment(gradient, second) + inertia.moment.cross(a)
    return moment, a * inertia.mass + gradient @ inertia.moment


def _second_moment(u: Matrix, j: Matrix) -> Matrix:
    """2 vee(skew(U J)) of a symmetric J; entries off the diagonal of J meet differences of U."""
    rows = []
    for x, y, z in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        if (-u[y, z]).node == u[z, y].node:
            along = u[z, y] * (j[y, y] + j[z, z])
        else:
            along = u[z, y] * j[y, y] - u[y, z] * j[z, z]
        across = j[y, z] * (u[z, z] - u[y, y]) + u[z, x] * j[x, y] - u[y, x] * j[x, z]
        rows.append(along + across)
    return Matrix.vector(u.graph, rows)


def inertial_wrench(
    k: Kinematics, i: int, acc: Accelerations, loads: Loads
) -> tuple[Matrix, Matrix]:
    """Rate of change of momentum less applied forces: the load on the joints of a body."""
    moment, force = inertia_force(k, i, acc)
    if i in loads.wrenches:
        with k.graph.made_by(k.owner(i), "f"):
            moment = moment - loads.wrenches[i][0]
            force = force - loads.wrenches[i][1]
    return moment, force
