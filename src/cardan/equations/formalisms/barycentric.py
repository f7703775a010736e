"""Augmented bodies: every body with what it carries put as mass points where it carries it.

Body i with the masses m_n of the trees that its outboard joints carry, at the origins p_n of these,
is its augmented body: B_i is its first moment, along its barycentric vector, and K_i its inertia,
about the origin of the body. Both are constant but for joints that slide, whose displacement is in
p_n. With U = [alpha] + [omega][omega], e_n the acceleration that sliding in joint n adds, and a_i
that of the origin, which the path from the ground sums up from U p and e,

    F_n = sum over the tree of n of U_k B_k + m_k e_k,
    N_i = K_i alpha + omega x K_i omega + B_i x a_i + sum over outboard joints of N_n + p_n x F_n,

and the equation of joint i is S_i . [N_i; F_i + m_i (a_i - e_i)]: no body's own translation is left
in them. Of two bodies on one path M has K_ij = (d_ij . B_j) 1 - B_j d_ijᵀ, d_ij being the vector in
i towards j; summed over the tree of a joint from the tips inward they are its inertia.

Source: Roberson and Schwertassek, Dynamics of Multibody Systems (1988), chapters 10 and 11;
Wittenburg, Dynamics of Multibody Systems (2008), chapter 5; Hooker and Margulies, J. Astronaut.
Sci. 12 (1965).
"""

from __future__ import annotations

from ...ir.arithmetic import Scalar
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.moments import Inertia, turn_symmetric
from ..kinematics.composite_bodies import projected
from ..kinematics.inertia import of_body
from ..kinematics.joint_forces import along_joint
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads, along_speeds
from .formalism import Formalism, within_bodies


@dataclass(frozen=True)
class Augmented:
    """An augmented body, about its origin in its axes.

    Attributes:
        total_mass: Mass of the body and of all outboard of it.
        moment: B (3, 1).
        tensor: K (3, 3).
    """

    total_mass: Scalar
    moment: Matrix
    tensor: Matrix


def augmented(k: Kinematics) -> list[Augmented]:
    """The augmented bodies of a tree, ``augmented = body + carried masses m_n at p_n``."""
    k.graph.describe(augmented)
    bodies = [of_body(k, i) for i in range(len(k.system.bodies))]
    mass = [inertia.mass for inertia in bodies]
    moment, tensor = [x.moment for x in bodies], [x.tensor for x in bodies]
    for n in range(len(bodies) - 1, -1, -1):
        name, parent = k.owner(n), k.system.bodies[n].parent
        if parent < 0:
            continue
        with k.graph.made_by(k.owner(parent), "augmented"):
            p = k.joints[n].position
            mass[parent] = mass[parent] + mass[n]
            moment[parent] = moment[parent] + p * mass[n]
            tensor[parent] = tensor[parent] - p.skew @ p.skew * mass[n]
        k.graph.label(mass[n].node, name, "carried_mass")
    return [Augmented(*parts) for parts in zip(mass, moment, tensor, strict=True)]


def mass_matrix(k: Kinematics, loads: Loads) -> Matrix:
    """M (nu, nu): the sums of all K_ij of the tree of every joint, projected."""
    bodies = augmented(k)
    tensor, moment = [b.tensor for b in bodies], [b.moment for b in bodies]
    for n in range(len(bodies) - 1, -1, -1):
        parent, joint = k.system.bodies[n].parent, k.joints[n]
        if parent < 0:
            continue
        with k.graph.made_by(k.owner(parent), "barycentric"):
            rotated, outboard = tensor[n], joint.rotation @ moment[n]
            for turn in reversed(joint.turns):
                rotated = turn_symmetric(turn, rotated)
            pair = _pair(joint.position, outboard)
            tensor[parent] = tensor[parent] + rotated + (pair + pair.T)
            moment[parent] = moment[parent] + outboard
    inertias = [
        Inertia(body.total_mass, h, t) for body, h, t in zip(bodies, moment, tensor, strict=True)
    ]
    return projected(k, inertias, loads)


def _pair(d: Matrix, b: Matrix) -> Matrix:
    """(d . b) 1 - b dᵀ."""
    return Matrix.identity(d.graph, 3) * d.dot(b) - b @ d.T


@dataclass(frozen=True)
class Course:
    """Accelerations of the bodies of a tree, gravity as an acceleration of the ground.

    Attributes:
        alpha: Angular acceleration of every body.
        acceleration_gradient: U of every body.
        a: Acceleration of its origin.
        sliding: e: what sliding in its joint adds to that.
    """

    alpha: list[Matrix]
    acceleration_gradient: list[Matrix]
    a: list[Matrix]
    sliding: list[Matrix]


def _course(k: Kinematics, along: list[Matrix], gravity: Matrix, moving: bool) -> Course:
    """The accelerations at given ones along the speeds of the joints.

    ``course = alpha, U, a: Rᵀ alpha_parent + S_w udot + c_w, ...`` of every body.
    """
    k.graph.describe(_course)
    course = Course([], [], [], [])
    for i, (body, joint) in enumerate(zip(k.system.bodies, k.joints, strict=True)):
        with k.graph.made_by(k.owner(i), "course"):
            relative = joint.S @ along[i]
            if moving:
                relative = relative + k.convective(i)
            alpha, sliding = relative.block(slice(0, 3)), relative.block(slice(3, 6))
            back, at_joint = joint.rotation.T, -gravity
            if body.parent >= 0:
                alpha = back @ course.alpha[body.parent] + alpha
                at_joint = (
                    course.a[body.parent]
                    + course.acceleration_gradient[body.parent] @ joint.position
                )
            gradient = alpha.skew
            if moving:
                gradient = gradient + k.omega[i].skew @ k.omega[i].skew
            course.alpha.append(alpha)
            course.acceleration_gradient.append(gradient)
            course.a.append(back @ at_joint + sliding)
            course.sliding.append(sliding)
    return course


def _balance(
    k: Kinematics, along: list[Matrix], loads: Loads, gravity: Matrix, moving: bool
) -> Matrix:
    """M udot + h - f (nu, 1) for given accelerations, ``balance = S . [N; F]``."""
    k.graph.describe(_balance)
    g, bodies = k.graph, augmented(k)
    course = _course(k, along, gravity, moving)
    N, F = list[Matrix](), list[Matrix]()
    for i, body in enumerate(bodies):
        with g.made_by(k.owner(i), "balance"):
            inertial_moment = body.tensor @ course.alpha[i]
            if moving:
                inertial_moment = inertial_moment + k.omega[i].cross(body.tensor @ k.omega[i])
            moment = inertial_moment + body.moment.cross(course.a[i])
            force = (
                course.acceleration_gradient[i] @ body.moment + course.sliding[i] * body.total_mass
            )
            if i in loads.wrenches:
                moment, force = moment - loads.wrenches[i][0], force - loads.wrenches[i][1]
            N.append(moment)
            F.append(force)
    total = [ZERO] * k.system.nu
    for i in range(len(bodies) - 1, -1, -1):
        joint, parent = k.joints[i], k.system.bodies[i].parent
        with g.made_by(k.system.joints[i].name, "balance"):
            augmented_force = (course.a[i] - course.sliding[i]) * bodies[i].total_mass
            along_joint = joint.S.T @ Matrix.vstack(N[i], F[i] + augmented_force)
            if i in loads.rotors:
                along_joint = along_joint + loads.rotors[i] @ _spin(k, i, along[i], moving)
            if i in loads.joints:
                along_joint = along_joint - loads.joints[i]
            for slot, node in along_speeds(k, i, along_joint).items():
                total[slot] = g.add(total[slot], node)
        if parent >= 0:
            with g.made_by(k.owner(parent), "balance"):
                force = joint.rotation @ F[i]
                F[parent] = F[parent] + force
                N[parent] = N[parent] + joint.rotation @ N[i] + joint.position.cross(force)
    return Matrix(g, k.system.nu, 1, total)


def _spin(k: Kinematics, i: int, along: Matrix, moving: bool) -> Matrix:
    """Acceleration of a joint, with what is given to it."""
    prescribed = k.prescribed_acceleration(i) if moving else None
    return along if prescribed is None else along + prescribed


def _still_axes(k: Kinematics) -> list[Matrix]:
    return [Matrix.zeros(k.graph, len(joint.element.speeds)) for joint in k.system.joints]


def bias(k: Kinematics, loads: Loads, gravity: Matrix, moving: bool = True) -> Matrix:
    """h (nu, 1)."""
    still = Loads({}, {}, loads.potential, (), loads.rotors)
    return _balance(k, _still_axes(k), still, gravity, moving)


def forces(k: Kinematics, loads: Loads) -> Matrix:
    """f (nu, 1)."""
    return -_balance(k, _still_axes(k), loads, Matrix.zeros(k.graph, 3), moving=False)


def inverse(k: Kinematics, udot: Matrix, loads: Loads, gravity: Matrix) -> Matrix:
    """tau (nu, 1) with M udot + h = f + tau."""
    along = [along_joint(k, i, udot) for i in range(len(k.joints))]
    return _balance(k, along, loads, gravity, moving=True)


BARYCENTRIC = Formalism(
    "barycentric",
    "augmented bodies, with all they carry as mass points, and barycentric vectors",
    "Roberson and Schwertassek, Dynamics of Multibody Systems (1988), chapters 10 and 11; "
    "Wittenburg, Dynamics of Multibody Systems (2008), chapter 5; Hooker and Margulies, "
    "J. Astronaut. Sci. 12 (1965).",
    mass_matrix,
    bias,
    forces,
    inverse,
    rewrites=within_bodies,
)
