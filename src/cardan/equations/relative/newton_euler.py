"""Recursive Newton-Euler: accelerations outward, forces inward.

With U = [alpha] + [omega][omega] the force and moment of a body about its origin are F = m a + U h
and N = 2 vee(skew(U J)) + h x a, where J is the second moment of mass; U also carries the origin of
the next body.

Source: Luh, Walker and Paul, J. Dyn. Sys. Meas. Control 102 (1980); Balafoutis and Patel, Dynamic
Analysis of Robot Manipulators (1991), for the second moment form.
"""

from __future__ import annotations

from dataclasses import dataclass

from ...ir.arithmetic import Scalar
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...spatial.moments import Inertia
from ..carried import CELLS, Sums
from ..inertia import of_body, second_moment_of_body
from ..kinematics import Kinematics
from ..loads import Loads, spread


@dataclass(frozen=True)
class Accelerations:
    """Angular acceleration and acceleration of the origin of every body minus gravity, body axes.

    ``spread`` is U = [alpha] + [omega][omega] of every body.
    """

    alpha: list[Matrix]
    a: list[Matrix]
    spread: list[Matrix]


@dataclass(frozen=True)
class JointForces:
    """Moment and force on every body from its inboard joint, at the body's origin, body axes."""

    moment: list[Matrix]
    force: list[Matrix]


def accelerations(
    k: Kinematics, udot: list[Matrix], gravity: Matrix, moving: bool = True
) -> Accelerations:
    """Accelerations of all bodies, outward.

    Args:
        k: Motion of the tree.
        udot: Acceleration along the speeds of every joint (nu of the joint, 1).
        gravity: In ground axes (3, 1); it enters as an acceleration of the ground by -gravity.
        moving: False at rest, where all velocity products vanish.
    """
    result = Accelerations([], [], [])
    for i, (body, joint) in enumerate(zip(k.system.bodies, k.joints, strict=True)):
        name, to_child = k.owner(i), joint.rotation.T
        with k.graph.made_by(name, "alpha"):
            relative = joint.S @ udot[i]
            if moving:
                relative = relative + k.convective(i)
            alpha, a = relative.block(slice(0, 3)), relative.block(slice(3, 6))
            if body.parent >= 0:
                alpha = to_child @ result.alpha[body.parent] + alpha
            result.alpha.append(k.carry(i, "alpha", alpha))
        with k.graph.made_by(name, "a"):
            if body.parent >= 0:
                carried = result.a[body.parent] + result.spread[body.parent] @ joint.position
            else:
                carried = -gravity
            result.a.append(k.carry(i, "a", to_child @ carried + a))
        with k.graph.made_by(name, "U"):
            omega = k.omega[i] if moving else Matrix.zeros(k.graph, 3)
            result.spread.append(k.carry(i, "U", _spread(omega, result.alpha[i]), CELLS))
    return result


def _spread(omega: Matrix, alpha: Matrix) -> Matrix:
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
    """Rate of change of momentum of a body about its origin: moment and force."""
    inertia, second = of_body(k, i), second_moment_of_body(k, i)
    with k.graph.made_by(k.owner(i), "inertia_force"):
        return second_moment_force(inertia, second, acc.a[i], acc.spread[i])


def second_moment_force(
    inertia: Inertia, second: Matrix, a: Matrix, spread: Matrix
) -> tuple[Matrix, Matrix]:
    """Moment and force that accelerate an inertia: origin by a, field by U = ``spread``."""
    moment = _turning(spread, second) + inertia.moment.cross(a)
    return moment, a * inertia.mass + spread @ inertia.moment


def _turning(u: Matrix, j: Matrix) -> Matrix:
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


def joint_forces(k: Kinematics, acc: Accelerations, loads: Loads) -> JointForces:
    """Forces that the joints transmit, inward."""
    n = len(k.system.bodies)
    sums = Sums(k, ("n", "f"), [_own_force(k, i, acc, loads) for i in range(n)])
    result: dict[int, tuple[Matrix, Matrix]] = {}
    for i in range(n - 1, -1, -1):
        moment, force = result[i] = sums[i][0], sums[i][1]
        force.label(k.owner(i), "f")
        moment.label(k.owner(i), "n")
        parent, joint = k.system.bodies[i].parent, k.joints[i]
        if parent >= 0:
            with k.graph.made_by(k.owner(i), "f"):
                carried = joint.rotation @ force
                turned = joint.rotation @ moment + joint.position.cross(carried)
                sums.add(parent, i, (turned, carried))
    return JointForces([result[i][0] for i in range(n)], [result[i][1] for i in range(n)])


def _own_force(k: Kinematics, i: int, acc: Accelerations, loads: Loads) -> tuple[Matrix, Matrix]:
    """What a body needs from its joints: rate of change of momentum less applied forces."""
    moment, force = inertia_force(k, i, acc)
    if i in loads.wrenches:
        with k.graph.made_by(k.owner(i), "f"):
            moment = moment - loads.wrenches[i][0]
            force = force - loads.wrenches[i][1]
    return moment, force


def inverse_dynamics(
    k: Kinematics, udot: Matrix, loads: Loads, gravity: Matrix, moving: bool = True
) -> Matrix:
    """tau with M udot + h = f_model + tau (nu, 1)."""
    along = [along_joint(k, i, udot) for i in range(len(k.joints))]
    acc = accelerations(k, along, gravity, moving)
    forces = joint_forces(k, acc, loads)
    tau = [ZERO] * k.system.nu
    for i in range(len(k.joints) - 1, -1, -1):
        with k.graph.made_by(k.system.joints[i].name, "tau"):
            own = driving_force(k, i, forces, loads, along[i])
            for slot, node in spread(k, i, own).items():
                tau[slot] = k.graph.add(tau[slot], node)
    result = Matrix(k.graph, k.system.nu, 1, tau)
    for joint in k.system.joints:
        if joint.u >= 0:
            names = [c.name for c in joint.element.speeds]
            result.block(slice(joint.u, joint.u + len(names))).label(joint.name, "tau", names)
    return result


def driving_force(k: Kinematics, i: int, forces: JointForces, loads: Loads, udot: Matrix) -> Matrix:
    """Force along the speeds of a joint that the elements on it do not supply."""
    s = k.joints[i].S
    value = s.T @ Matrix.vstack(forces.moment[i], forces.force[i])
    if i in loads.rotors:
        rotor = udot
        motion = k.system.joints[i].motion
        if motion is not None:
            rotor = rotor + Matrix.vector(
                k.graph, [Scalar(k.graph, k.resolve([motion.acceleration])[0])]
            )
        value = value + loads.rotors[i] @ rotor
    if i in loads.joints:
        value = value - loads.joints[i]
    return value


def along_joint(k: Kinematics, i: int, udot: Matrix) -> Matrix:
    """The part of udot (nu, 1) along the speeds of one joint, 0 for a prescribed one."""
    joint, count = k.system.joints[i], len(k.system.joints[i].element.speeds)
    if joint.motion is not None:
        return Matrix(k.graph, count, 1, [ZERO] * count)
    if joint.coupling is not None:
        leader, ratio, _ = k.leader(i)
        return Matrix.vector(k.graph, [udot[k.system.joints[leader].u] * ratio])
    return udot.block(slice(joint.u, joint.u + count))


def mass_matrix(k: Kinematics, loads: Loads) -> Matrix:
    """M (nu, nu): column by column, the forces of unit accelerations at rest without gravity."""
    g, nu = k.graph, k.system.nu
    still = Loads({}, {}, loads.potential, (), loads.rotors)
    columns = []
    rest = Matrix.zeros(g, 3)
    for j in range(nu):
        unit = Matrix(g, nu, 1, [1 if i == j else ZERO for i in range(nu)])
        columns.append(inverse_dynamics(k, unit, still, rest, moving=False))
    # the two triangles agree; the lower one stands for both
    rows = [[columns[min(i, j)][max(i, j)] for j in range(nu)] for i in range(nu)]
    return Matrix.of(g, rows) if nu else Matrix(g, 0, 0, ())
