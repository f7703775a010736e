"""The gross motion: how bodies lie and move in the reference.

Vectors are told in the axes of a body, those of its inner body in the axes of the outer one and at
its origin; 6-vectors have the angular part first.
"""

from __future__ import annotations

from ...ir.derivative import forward
from ...ir.graph import ONE
from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.moments import Inertia
from ..functions.newton_euler_derivatives import Flow, flows
from ..kinematics.accelerations import Accelerations, accelerations, inertia_force
from ..kinematics.composite_bodies import composites
from ..kinematics.joint_forces import along_joint
from .reference import Reference


@dataclass(frozen=True)
class JointChange:
    """Motion of a joint by itself, as expressions of any state, in the axes of its body.

    Attributes:
        columns: Speed -> column of its twist (6, 1).
        twist: All of it (6, 1).
        acceleration: Of the outer body as seen from the inner one (6, 1).
    """

    columns: dict[int, Matrix]
    twist: Matrix
    acceleration: Matrix


@dataclass(frozen=True)
class Field:
    """Motion of a body, or of what moves with its inner body, at the body's origin (3, 1) each.

    Attributes:
        omega, alpha: Angular velocity and acceleration.
        v: Velocity, less that of the origin of the first body of the tree: no force depends on it.
        a: Acceleration less gravity.
    """

    omega: Matrix
    v: Matrix
    alpha: Matrix
    a: Matrix


class Gross:
    """The reference motion of a tree.

    Args:
        at: The reference.

    Attributes:
        motion: What joints do by themselves.
        columns: Theirs at the reference.
        rotation, position: Of every body against its inner one.
        inner, outer: Motion of the inner body and of the body itself, at its origin.
        inertias, flows, forces: Of every body with all that is outboard of it; forces are rates of
            momentum, gravity taken off (6, 1).
    """

    def __init__(self, at: Reference) -> None:
        self.at, self.k, self.bodies = at, at.k, at.system.bodies
        count, put = range(len(self.bodies)), at.put
        self._udot = Matrix(at.graph, at.system.nu, 1, at.block("udot"))
        along = [along_joint(at.k, i, self._udot) for i in count]
        acc = accelerations(at.k, along, at.d.gravity)
        self.motion = [self._joint_motion(i, along[i]) for i in count]
        self.columns = [{s: put(x) for s, x in motion.columns.items()} for motion in self.motion]
        self.rotation = [put(joint.rotation) for joint in at.k.joints]
        self.position = [put(joint.position) for joint in at.k.joints]
        self.inner = [self._inner(i, acc) for i in count]
        self.outer = [
            Field(put(at.k.omega[i]), put(at.k.v_from_root[i]), put(acc.alpha[i]), put(acc.a[i]))
            for i in count
        ]
        self.inertias = [Inertia(x.mass, put(x.moment), put(x.tensor)) for x in composites(at.k)]
        self.flows = [Flow(put(x.momentum), put(x.gradient)) for x in flows(at.k)]
        self.forces = [put(Matrix.vstack(*inertia_force(at.k, i, acc))) for i in count]
        for i in reversed(count):
            if self.bodies[i].parent >= 0:
                inner = self.bodies[i].parent
                self.forces[inner] = self.forces[inner] + self.inward(i, self.forces[i])

    def outward(self, i: int, twist: Matrix) -> Matrix:
        """A twist told on the inner body of a joint, told on the outer one (6, 1)."""
        (angular, moving), back = halves(twist), self.rotation[i].T
        return Matrix.vstack(back @ angular, back @ (moving + angular.cross(self.position[i])))

    def inward(self, i: int, wrench: Matrix) -> Matrix:
        """A wrench told on the outer body of a joint, told on the inner one (6, 1)."""
        (moment, force), R = halves(wrench), self.rotation[i]
        rotated_force = R @ force
        return Matrix.vstack(R @ moment + self.position[i].cross(rotated_force), rotated_force)

    def _joint_motion(self, i: int, along: Matrix) -> JointChange:
        k, joint = self.k, self.k.joints[i]
        columns = dict(joint.columns)
        if k.chosen:
            # the columns of the joint belong to its own speeds
            columns = {}
            for slot in range(k.system.nu):
                seeds = {k.graph.var("u", slot): ONE}
                column = Matrix(k.graph, 6, 1, forward(k.graph, joint.velocity.nodes, seeds))
                if not column.is_zero:
                    columns[slot] = column
        return JointChange(columns, joint.velocity, joint.S @ along + joint.drift)

    def _inner(self, i: int, acc: Accelerations) -> Field:
        k, joint, parent = self.k, self.k.joints[i], self.bodies[i].parent
        zero, back, put = Matrix.zeros(k.graph, 3), joint.rotation.T, self.at.put
        v = put(k.v_from_root[i] - joint.velocity.block(slice(3, 6)))
        if parent < 0:
            return Field(zero, v, zero, put(back @ -self.at.d.gravity))
        a = acc.a[parent] + acc.gradient[parent] @ joint.position
        return Field(put(back @ k.omega[parent]), v, put(back @ acc.alpha[parent]), put(back @ a))


def halves(x: Matrix) -> tuple[Matrix, Matrix]:
    """Angular and linear part."""
    return x.block(slice(0, 3)), x.block(slice(3, 6))


def wrench_change(moved: Matrix, wrench: Matrix) -> Matrix:
    """Change of a wrench that is carried along by a displacement (6, 1)."""
    (w, v), (moment, force) = halves(moved), halves(wrench)
    return Matrix.vstack(w.cross(moment) + v.cross(force), w.cross(force))
