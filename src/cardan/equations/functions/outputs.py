"""Outputs of a moving system: poses, velocities, energy, momentum, reactions, outputs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from ...errors import DerivationError
from ...ir.arithmetic import Scalar
from ...ir.derivative import forward
from ...ir.graph import ONE, ZERO
from ...ir.matrix import Matrix
from ...spatial.moments import Inertia, second_moment
from ...topology.prescribed_motion import driver
from ...topology.system import Part
from ..constraints.loop_loads import Closing, closing_wrenches, with_closing
from ..kinematics.accelerations import Accelerations, accelerations, second_moment_force
from ..kinematics.energies import ground_moment, kinetic, total, weight, weights
from ..kinematics.inertia import of_body
from ..kinematics.joint_forces import JointForces, along_joint, driving_force, joint_forces
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import applied, merged
from ..recursion.recursion_boundary import summed
from .dynamics import Dynamics


def pose(k: Kinematics, frame: int) -> Matrix:
    """Homogeneous transform (4, 4) from frame axes to ground axes."""
    last = Matrix(k.graph, 1, 4, (ZERO, ZERO, ZERO, ONE))
    return Matrix.vstack(Matrix.hstack(k.rotation(frame), k.position(frame)), last)


def velocity(k: Kinematics, frame: int) -> Matrix:
    """Angular velocity and velocity of the origin of a frame (6, 1), ground axes."""
    return Matrix.vstack(k.angular_velocity(frame), k.velocity(frame))


def frame_jacobian(k: Kinematics, frame: int) -> Matrix:
    """Derivative of the velocity of a frame with respect to u (6, nu), ground axes."""
    g, nu = k.graph, k.system.nu
    if k.chosen:
        nodes = velocity(k, frame).nodes
        changes = [forward(g, nodes, {g.var("u", j): ONE}) for j in range(nu)]
        return Matrix(g, 6, nu, [column[i] for i in range(6) for column in changes])
    columns = [Matrix.zeros(g, 6) for _ in range(nu)]
    body, at = k.system.frames[frame].body, k.position(frame)
    while body >= 0:
        # what moves with a joint turns about the origin of its body
        arm = at - k.ground_position[body]
        for slot, s in k.joints[body].columns:
            angular = k.ground_rotation[body] @ s.block(slice(0, 3))
            moving = k.ground_rotation[body] @ s.block(slice(3, 6)) + angular.cross(arm)
            columns[slot] = columns[slot] + Matrix.vstack(angular, moving)
        body = k.system.bodies[body].parent
    return Matrix.hstack(*columns) if nu else Matrix(g, 6, 0, ())


def system_accelerations(d: Dynamics, udot: Matrix) -> Accelerations:
    """Accelerations of all bodies for given udot; gravity is in them as -gravity."""
    along = [along_joint(d.k, i, udot) for i in range(len(d.k.joints))]
    return accelerations(d.k, along, d.gravity)


def acceleration(d: Dynamics, acc: Accelerations, frame: int) -> Matrix:
    """Angular acceleration and acceleration of the origin of a frame (6, 1), ground axes."""
    k, f = d.k, d.k.system.frames[frame]
    if f.body < 0:
        return Matrix.zeros(k.graph, 6)
    linear = acc.a[f.body] + acc.gradient[f.body] @ k.place(frame)
    r = k.ground_rotation[f.body]
    return Matrix.vstack(r @ acc.alpha[f.body], r @ linear + d.gravity)


def energy(d: Dynamics) -> tuple[Scalar, Scalar]:
    """Kinetic and potential energy; gravity's is zero at the ground origin."""
    if d.k.cuts is None:
        return kinetic(d.k, d.loads.rotors), d.loads.potential + weight(d.k, d.gravity)
    # as a recursion every body adds its weight and what is stored at its joint
    parts = weights(d.k, d.gravity)
    return kinetic(d.k, d.loads.rotors), total(d.k, "potential_energy", parts, d.loads.energies)


def center_of_mass(k: Kinematics) -> Matrix:
    """Center of mass of everything that moves (3, 1), ground axes: ``com = sum m c / sum m``.

    Raises:
        DerivationError: nothing that moves has a mass.
    """
    k.graph.describe(center_of_mass)
    masses, moments = [], []
    for i in range(len(k.system.bodies)):
        with k.graph.made_by(k.owner(i), "com"):
            inertia = of_body(k, i)
            masses.append(Matrix(k.graph, 1, 1, [inertia.mass.node]))
            moments.append(ground_moment(k, i, inertia))
    if all(mass[0].node == ZERO for mass in masses):
        raise DerivationError(
            "com: nothing that moves has a mass, and so no center of it; give a body a mass"
        )
    return summed(k, "moment", moments) / summed(k, "mass", masses)[0]


def momentum(k: Kinematics) -> Matrix:
    """Angular momentum about the ground origin and linear momentum (6, 1), ground axes.

    Of the bodies: a rotor that only adds its inertia to a joint has no momentum of its own here.
    """
    parts = []
    for i in range(len(k.system.bodies)):
        with k.graph.made_by(k.owner(i), "momentum"):
            body_momentum = of_body(k, i).momentum(Matrix.vstack(k.omega[i], k.v[i]))
            linear = k.ground_rotation[i] @ body_momentum.block(slice(3, 6))
            angular = k.ground_rotation[i] @ body_momentum.block(slice(0, 3))
            angular = angular + k.ground_position[i].cross(linear)
            parts.append(Matrix.vstack(angular, linear))
    return summed(k, "momentum", parts) if parts else Matrix.zeros(k.graph, 6)


# forces of joints


def external(d: Dynamics, part_names: set[str] | None = None) -> dict[int, tuple[Matrix, Matrix]]:
    """Moment and force of the block ``wrench`` on every body, at its origin in its axes.

    Args:
        part_names: Names of the parts whose wrenches count; all by default.
    """
    k, row = d.k, 0
    result: dict[int, tuple[Matrix, Matrix]] = {}
    for i, body in enumerate(k.system.bodies):
        for part in body.parts:
            nodes = [k.graph.var("wrench", 6 * row + j) for j in range(6)]
            row += 1
            if part_names is not None and part.name not in part_names:
                continue
            to_body = k.ground_rotation[i].T
            force = to_body @ Matrix(k.graph, 3, 1, nodes[3:])
            at = k.place(part.frame)
            moment = to_body @ Matrix(k.graph, 3, 1, nodes[:3]) + at.cross(force)
            if i in result:
                moment, force = result[i][0] + moment, result[i][1] + force
            result[i] = (moment, force)
    return result


def accelerated(d: Dynamics) -> tuple[Matrix, Accelerations]:
    """udot under tau, the model's forces and the block ``wrench``; and all accelerations."""
    d.loads = d.loads.with_outside(external(d))
    udot = d.forward(d.tau)
    return udot, system_accelerations(d, udot)


def reaction(d: Dynamics, name: str) -> Matrix:
    """Wrench of parent on child of a joint (6, 1), at the child joint frame in its axes.

    Moment first. Joints with motion and fixed joints alike.
    """
    udot, acc = accelerated(d)
    closing = closing_wrenches(d, d.tau, udot, acc)
    for one in closing:
        if one.cut.name == name:
            return one.wrench
    forces = joint_forces(d.k, acc, with_closing(d.k, d.loads, closing))
    for i, joint in enumerate(d.k.system.joints):
        if joint.name == name:
            wrench = Matrix.vstack(forces.moment[i], forces.force[i])
            return on_declared_child(d.k, i, wrench) if joint.reversed else wrench
    return _fixed_reaction(d, name, acc, forces, closing)


def on_declared_child(k: Kinematics, i: int, wrench: Matrix) -> Matrix:
    """Wrench on the inner body of joint i, whose child it is, at its frame in its axes."""
    pose = k.system.joints[i].element.pose(k.coordinates[i], **k.data[i])
    rotation, position = (k.settled(i, x) for x in pose)
    moment, force = (rotation @ wrench.block(slice(a, a + 3)) for a in (0, 3))
    return -Matrix.vstack(moment + position.cross(force), force)


def _fixed_reaction(
    d: Dynamics, name: str, acc: Accelerations, joints: JointForces, closing: tuple[Closing, ...]
) -> Matrix:
    """Reaction inside a rigid body: balance of the parts outboard of a fixed joint."""
    k = d.k
    body, parts = _holder(k, name)
    outboard = _outboard(parts, name)
    moment, force = Matrix.zeros(k.graph, 3), Matrix.zeros(k.graph, 3)
    for j in outboard:
        part_force = _part_force(d, body, parts[j], acc)
        moment, force = moment + part_force[0], force + part_force[1]
    applied_here = _applied(d, body, parts, outboard, closing)
    moment, force = moment - applied_here[0], force - applied_here[1]
    # joints that leave from the outboard parts pull on them
    for i, joint in enumerate(k.system.joints):
        frame = k.system.frames[joint.parent_frame]
        if frame.body == body and frame.part in outboard:
            child_force = k.joints[i].rotation @ joints.force[i]
            child_moment = k.joints[i].rotation @ joints.moment[i]
            moment = moment + child_moment + k.joints[i].position.cross(child_force)
            force = force + child_force
    fixed_part = next(p for p in parts if p.joint == name)
    at = k.system.frames[fixed_part.joint_frame]
    axes = k.matrix(3, 3, at.rotation).T
    wrench = Matrix.vstack(axes @ (moment - k.vector(at.position).cross(force)), axes @ force)
    # declared the other way round, the part is the parent of its joint
    return -wrench if fixed_part.reversed else wrench


def _holder(k: Kinematics, name: str) -> tuple[int, tuple[Part, ...]]:
    """The rigid body (-1: ground) within which a fixed joint lies, and its parts."""
    for i, body in enumerate(k.system.bodies):
        if any(part.joint == name for part in body.parts):
            return i, body.parts
    return -1, k.system.ground_parts


def _outboard(parts: tuple[Part, ...], name: str) -> set[int]:
    """Indices of the parts that a fixed joint carries; parts follow those they are fixed to."""
    outboard: set[int] = set()
    for j, part in enumerate(parts):
        if part.joint == name or part.inboard in outboard:
            outboard.add(j)
    return outboard


def _part_force(d: Dynamics, body: int, part: Part, acc: Accelerations) -> tuple[Matrix, Matrix]:
    k = d.k
    inertia = Inertia(
        Scalar(k.graph, k.resolve([part.mass])[0]),
        k.vector(part.first_moment),
        k.matrix(3, 3, part.inertia),
    )
    if body < 0:
        still = -d.gravity
        return inertia.moment.cross(still), still * inertia.mass
    second = second_moment(inertia.tensor)
    return second_moment_force(inertia, second, acc.a[body], acc.gradient[body])


def _applied(
    d: Dynamics, body: int, parts: tuple[Part, ...], chosen: set[int], closing: tuple[Closing, ...]
) -> tuple[Matrix, Matrix]:
    """Wrench that elements, the block ``wrench`` and loops apply to some parts of a body."""
    frames = d.k.system.frames
    mine = {i for i, f in enumerate(frames) if f.body == body and f.part in chosen}
    zero = Matrix.zeros(d.k.graph, 3)
    moment, force = applied(d.k, mine).wrenches.get(body, (zero, zero))
    outside = external(d, {parts[j].name for j in chosen}) if body >= 0 else {}
    loads = replace(d.loads, wrenches=merged({body: (moment, force)}, outside))
    return with_closing(d.k, loads, closing, mine).wrenches[body]


def motion_forces(d: Dynamics, udot: Matrix, acc: Accelerations) -> dict[int, Scalar]:
    """Force that moves every prescribed joint as prescribed, along its coordinate.

    Args:
        udot: Accelerations of the system without tau (nu, 1).
        acc: Those of the bodies.
    """
    moved = [i for i, joint in enumerate(d.k.system.joints) if joint.motion is not None]
    if not moved:
        return {}
    tau = Matrix.zeros(d.k.graph, d.k.system.nu)
    closing = closing_wrenches(d, tau, udot, acc)
    forces = joint_forces(d.k, acc, with_closing(d.k, d.loads, closing))
    still = Matrix.zeros(d.k.graph, 1)
    needed = {i: driving_force(d.k, i, forces, d.loads, still)[0] for i in moved}
    if d.driven_rows.shares:
        lam = d.bound(tau)[1]
        needed = {i: force - d.driven_rows.along(i, lam) for i, force in needed.items()}
    return driven(d.k, needed)


def driven(k: Kinematics, needed: Mapping[int, Scalar]) -> dict[int, Scalar]:
    """Forces of the joints that are driven: what their followers need acts on them as well."""
    totals: dict[int, Scalar] = {}
    for i, force in needed.items():
        motion, leader = k.system.joints[i].motion, driver(k.system.joints, i)
        assert motion is not None
        (ratio,) = k.resolve([motion.ratio])
        totals[leader] = totals.get(leader, Scalar(k.graph, ZERO)) + force * Scalar(k.graph, ratio)
    return {i: totals[i] for i in needed if i in totals}
