"""Forces that joints transmit at given accelerations, and inverse dynamics by them.

Source: Luh, Walker and Paul, J. Dyn. Sys. Meas. Control 102 (1980).
"""

from __future__ import annotations

from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...records import dataclass
from ..recursion.recursion_boundary import Sums
from .accelerations import Accelerations, accelerations, inertial_wrench
from .kinematics import Kinematics
from .loads import Loads, along_speeds


@dataclass(frozen=True)
class JointForces:
    """Moment and force on every body from its inboard joint, at the body's origin, body axes."""

    moment: list[Matrix]
    force: list[Matrix]


def joint_forces(k: Kinematics, acc: Accelerations, loads: Loads) -> JointForces:
    """Moments and forces that the joints transmit, inward.

    ``f = inertia_force_f - applied_f + sum R f_child`` and
    ``n = inertia_force_n - applied_n + sum (R n_child + p x R f_child)``.
    """
    k.graph.describe(joint_forces)
    n = len(k.system.bodies)
    sums = Sums(k, ("n", "f"), [inertial_wrench(k, i, acc, loads) for i in range(n)])
    result: dict[int, tuple[Matrix, Matrix]] = {}
    for i in range(n - 1, -1, -1):
        moment, force = result[i] = sums[i][0], sums[i][1]
        force.label(k.owner(i), "f")
        moment.label(k.owner(i), "n")
        parent, joint = k.system.bodies[i].parent, k.joints[i]
        if parent >= 0:
            with k.graph.made_by(k.owner(i), "f"):
                parent_force = joint.rotation @ force
                parent_moment = joint.rotation @ moment + joint.position.cross(parent_force)
                sums.add(parent, i, (parent_moment, parent_force))
    return JointForces([result[i][0] for i in range(n)], [result[i][1] for i in range(n)])


def inverse_dynamics(
    k: Kinematics, udot: Matrix, loads: Loads, gravity: Matrix, moving: bool = True
) -> Matrix:
    """tau with M udot + h = f_model + tau (nu, 1): ``tau = S . [n; f] - force on the joint``."""
    k.graph.describe(inverse_dynamics)
    along = [along_joint(k, i, udot) for i in range(len(k.joints))]
    acc = accelerations(k, along, gravity, moving)
    forces = joint_forces(k, acc, loads)
    tau = [ZERO] * k.system.nu
    for i in range(len(k.joints) - 1, -1, -1):
        with k.graph.made_by(k.system.joints[i].name, "tau"):
            force_along = driving_force(k, i, forces, loads, along[i], moving)
            for slot, node in along_speeds(k, i, force_along).items():
                tau[slot] = k.graph.add(tau[slot], node)
    result = Matrix(k.graph, k.system.nu, 1, tau)
    for joint in k.system.joints:
        if joint.u >= 0:
            names = [c.name for c in joint.element.speeds]
            result.block(slice(joint.u, joint.u + len(names))).label(joint.name, "tau", names)
    return result


def driving_force(
    k: Kinematics, i: int, forces: JointForces, loads: Loads, udot: Matrix, moving: bool = True
) -> Matrix:
    """Force along the speeds of a joint that the elements on it do not supply."""
    s = k.joints[i].S
    value = s.T @ Matrix.vstack(forces.moment[i], forces.force[i])
    if i in loads.rotors:
        rotor, prescribed = udot, k.prescribed_acceleration(i) if moving else None
        if prescribed is not None:
            rotor = rotor + prescribed
        value = value + loads.rotors[i] @ rotor
    if i in loads.joints:
        value = value - loads.joints[i]
    return value


def along_joint(k: Kinematics, i: int, udot: Matrix) -> Matrix:
    """The part of udot (nu, 1) along the speeds of one joint, 0 for a prescribed one.

    A joint without slots of its own, and every joint where speeds are chosen, has its share of it.
    """
    joint, count = k.system.joints[i], len(k.system.joints[i].element.speeds)
    shares = k.shares(i)
    if shares is None:
        return udot.block(slice(joint.u, joint.u + count))
    total = Matrix.zeros(k.graph, count)
    for slot, share in shares.items():
        total = total + share * udot[slot]
    return total


def bias(k: Kinematics, loads: Loads, gravity: Matrix, moving: bool = True) -> Matrix:
    """h (nu, 1): what moves the system without udot and forces."""
    zero_udot = Matrix.zeros(k.graph, k.system.nu)
    still = Loads({}, {}, loads.potential, (), loads.rotors)
    return inverse_dynamics(k, zero_udot, still, gravity, moving)


def forces(k: Kinematics, loads: Loads) -> Matrix:
    """f (nu, 1): what holds the applied forces at rest without gravity, negated."""
    zero_udot = Matrix.zeros(k.graph, k.system.nu)
    return -inverse_dynamics(k, zero_udot, loads, Matrix.zeros(k.graph, 3), moving=False)
