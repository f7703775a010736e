"""Motion of a body against its parent, by the joint between them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...ir.arithmetic import Scalar, cos, sin
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.axis import elementary, principal
from ...topology.system import Turn
from ..recursion.recursion_boundary import CELLS, XYZ

if TYPE_CHECKING:
    from .kinematics import Kinematics


@dataclass(frozen=True)
class JointPose:
    """Pose of a body relative to its parent, and its motion from there.

    Attributes:
        q: Coordinates of the joint as expressions of the system's.
        turns: Rotations (3, 3) whose product is ``rotation``.
        rotation: R from child axes to parent axes (3, 3).
        position: Origin of the child in parent axes (3, 1).
        S: Modes of motion (6, nu of the joint), child axes.
        modes: The same, not cut where values are handed on.
    """

    q: Matrix
    turns: tuple[Matrix, ...]
    rotation: Matrix
    position: Matrix
    S: Matrix
    modes: Matrix


@dataclass(frozen=True)
class JointMotion:
    """Motion of a body against its parent.

    Attributes:
        q, u: Coordinates and speeds of the joint as expressions of the system's.
        turns: Rotations (3, 3) whose product is ``rotation``.
        rotation: R from child axes to parent axes (3, 3).
        position: Origin of the child in parent axes (3, 1).
        S: Modes of motion (6, nu of the joint), child axes.
        columns: (k, column of S (6, 1)) for every system speed k that moves the joint.
        velocity: S u (6, 1).
        drift: Acceleration against the parent, as seen from it, that needs no udot (6, 1): Sdot u,
            [0; omega x v], and S times a prescribed acceleration.
    """

    q: Matrix
    u: Matrix
    turns: tuple[Matrix, ...]
    rotation: Matrix
    position: Matrix
    S: Matrix
    columns: tuple[tuple[int, Matrix], ...]
    velocity: Matrix
    drift: Matrix


def joint_pose(k: Kinematics, i: int) -> JointPose:
    """Place of body i against its parent, told in the axes of the two.

    ``R = R_fixed R_joint(q)`` turns child axes to parent axes, ``p = p_fixed + R_fixed p_joint(q)``
    is the origin of the child there; ``S = d(twist of the child) / du`` in child axes.
    """
    k.graph.describe(joint_pose)
    joint, q, data = k.system.joints[i], k.coordinates[i], k.data[i]
    g, name, parent = k.graph, joint.name, k.system.bodies[i].parent
    fixed, at = k.matrix(3, 3, joint.rotation), k.vector(joint.position)
    with g.made_by(name, "R"):
        inner, shift = (k.settled(i, x) for x in joint.element.pose(_with_offset(k, i), **data))
        turns = _turns(k, i, fixed, k.carry(i, "inner", inner, (), name))
        product = Matrix.identity(g, 3)
        for r in turns:
            product = product @ r
        rotation = k.carry(i, "R", product, CELLS, name)
    with g.made_by(name, "p"):
        position = k.carry(i, "p", k.fixed_to(parent, at + fixed @ shift), XYZ, name)
    with g.made_by(name, "S"):
        modes = k.settled(i, joint.element.motion(q, **data))
        s = k.carry(i, "S", modes, (), name)
    return JointPose(q, turns, rotation, position, s, modes)


def joint_motion(k: Kinematics, i: int) -> JointMotion:
    """Motion of body i against its parent, told in the axes of the two.

    ``velocity = S u`` and ``drift = S' u + [0; omega x v]``, its acceleration without udot.
    """
    k.graph.describe(joint_motion)
    joint, g, at = k.system.joints[i], k.graph, k.pose_of(i)
    u = k.joint_speeds(i)
    with g.made_by(joint.name, "velocity"):
        velocity = k.carry(i, "relative", (at.S @ u).note("relative"), (), joint.name)
    with g.made_by(joint.name, "drift"):
        drift = _drift(k, i, at.modes, u, velocity)
        prescribed = k.prescribed_acceleration(i)
        if prescribed is not None:
            drift = drift + at.S @ prescribed
        drift.note("relative")
    columns = _columns(k, i, at.S)
    return JointMotion(at.q, u, at.turns, at.rotation, at.position, at.S, columns, velocity, drift)


def turn(k: Kinematics, axis_turn: Turn | None) -> Matrix | None:
    """R from the axes of a body to those that do not turn with it.

    Joints with parallel axes turn by ``turn = sum of their angles``.
    """
    k.graph.describe(turn)
    if axis_turn is None:
        return None
    with k.graph.made_by(k.system.joints[axis_turn.joints[-1][0]].name, "turn"):
        return _about(k, axis_turn.axis, axis_turn.joints)


def _about(k: Kinematics, axis: int, joints: tuple[tuple[int, int], ...]) -> Matrix:
    """Rotation about a coordinate axis by the sum of the angles of joints."""
    total = Scalar(k.graph, ZERO)
    for j, sign in joints:
        angle = k.system.joints[j].element.angle
        assert angle is not None
        total = total + _with_offset(k, j)[angle] * sign
    k.graph.hint(total.node, k.system.joints[joints[-1][0]].name, "turn")
    return elementary(axis, cos(total), sin(total))


def _turns(k: Kinematics, i: int, fixed: Matrix, inner: Matrix) -> tuple[Matrix, ...]:
    """Rotations whose product leads from the axes of body i to those of its parent."""
    body, parent = k.system.bodies[i], k.system.bodies[i].parent
    before = k.system.bodies[parent].turn if parent >= 0 else None
    if before is None:
        return (fixed,) if body.turn is not None else (fixed, inner)
    around = k.turns[parent]
    assert around is not None
    joint = k.system.joints[i]
    if joint.follows:
        if body.turn is not None:
            return ()
        along = principal(k.matrix(*joint.data[joint.element.line]))
        assert along is not None
        return (_about(k, before.axis, (*before.joints, (i, along[1]))),)
    return (around, fixed) if body.turn is not None else (around, fixed, inner)


def _with_offset(k: Kinematics, i: int) -> Matrix:
    """Coordinates of a joint, its angle counted from where the axes were put."""
    joint, q = k.system.joints[i], k.coordinates[i]
    if joint.offset == ZERO:
        return q
    nodes = list(q.nodes)
    assert joint.element.angle is not None
    at = joint.element.angle
    nodes[at] = k.graph.add(nodes[at], joint.offset)
    k.graph.hint(joint.offset, joint.name, "offset")
    k.graph.hint(nodes[at], joint.name, "angle")
    return Matrix(k.graph, len(nodes), 1, nodes)


def _drift(k: Kinematics, i: int, s: Matrix, u: Matrix, velocity: Matrix) -> Matrix:
    """Sdot u + [0; omega x v] of a joint, in the joint's own words where it has them."""
    convective = k.system.joints[i].element.convective(k.coordinates[i], u, **k.data[i])
    if convective is not None:
        return k.settled(i, convective)
    w, v = velocity.block(slice(0, 3)), velocity.block(slice(3, 6))
    transport = Matrix.vstack(Matrix.zeros(k.graph, 3), w.cross(v))
    if all(k.graph.value(x) is not None for x in s.nodes):
        return transport
    return k.derivative(s) @ u + transport


def _columns(k: Kinematics, i: int, s: Matrix) -> tuple[tuple[int, Matrix], ...]:
    shares = k.shares(i)
    if shares is None:
        first = k.system.joints[i].u
        return tuple((first + n, s.column(n)) for n in range(s.columns))
    return tuple((slot, s @ share) for slot, share in shares.items())
