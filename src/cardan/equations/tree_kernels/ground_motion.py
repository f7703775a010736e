"""Motion of a tree in axes of the ground, with the origin of its base as origin.

What bodies hand on in these axes adds up as it stands. Positions count from the base of the tree
and velocities from its own, so that no number depends on where the tree is or how fast it travels.
The base is the first body that rotates: a vehicle or a gantry on slides may be far from where its
slides begin, and numbers about that place would leave few digits of what the arm on it does.
Bodies that only slide against the ground count from themselves. That is enough for them: along a
slide nothing is read of what stands inboard but mass and force, which have no origin.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...ir.matrix import Matrix
from ...spatial.moments import Inertia, moved, second_moment
from ...topology.system import System
from ..kinematics.accelerations import field_of
from ..kinematics.inertia import of_body, second_moment_of_body
from ..kinematics.kinematics import Kinematics
from ..recursion.recursion_boundary import CELLS, XYZ, Cuts
from ..recursion.representatives import only_slides


def begins(system: System, numbering: Sequence[int]) -> tuple[bool, ...]:
    """Bodies from which positions count, True for each: whatever is inboard of it only slides.

    It is asked of the complete system: in a small one bodies have other parents.
    """
    sliding, parents = only_slides(system), [system.bodies[number].parent for number in numbering]
    return tuple([parent < 0 or sliding[parent] for parent in parents])


class GroundMotion:
    """Places and motion of the bodies, outward.

    Args:
        k: Motion of the tree, with nothing cut.
        gravity: In ground axes (3, 1).
        cuts: Where values that bodies hand on become leaves, None for straight-line expressions.
        moving: Whether velocities and accelerations are wanted.
        begins: Of every body, whether positions count from it.

    Attributes:
        orientation: R from body axes to ground axes (3, 3).
        position: Origin of the body, from that of the base (3, 1).
        omega, v: Angular velocity, velocity of the origin less that of the base (3, 1).
        alpha, a: Accelerations at udot = 0, less gravity (3, 1).
        field: U = [alpha] + [omega][omega] (3, 3).
    """

    def __init__(
        self,
        k: Kinematics,
        gravity: Matrix,
        cuts: Cuts | None,
        moving: bool,
        begins: Sequence[bool],
    ) -> None:
        self.k, self.gravity, self.cuts, self.begins = k, gravity, cuts, begins
        self.orientation, self.position = list[Matrix](), list[Matrix]()
        self.omega, self.v = list[Matrix](), list[Matrix]()
        self.alpha, self.a, self.field = list[Matrix](), list[Matrix](), list[Matrix]()
        for i in range(len(k.system.bodies)):
            self._place(i)
            if moving:
                self._move(i)

    def _carry(self, i: int, quantity: str, x: Matrix, parts: Sequence[str] = XYZ) -> Matrix:
        """A value that children read, under a name."""
        x.label(self.k.owner(i), quantity, parts)
        if self.cuts is None:
            return x
        return Matrix(self.k.graph, x.rows, x.columns, self.cuts.cut(i, quantity, x.nodes))

    def _place(self, i: int) -> None:
        k, parent = self.k, self.k.system.bodies[i].parent
        with k.graph.made_by(k.owner(i), "orientation"):
            at = k.pose_of(i)
            turns = at.turns or (at.rotation,)
            r = turns[0] if parent < 0 else self.orientation[parent] @ turns[0]
            for turn in turns[1:]:
                r = r @ turn
            p = Matrix.zeros(k.graph, 3)
            if not self.begins[i]:
                p = self.position[parent] + self.orientation[parent] @ at.position
        self.orientation.append(self._carry(i, "orientation", r, CELLS))
        self.position.append(self._carry(i, "from_base", p))

    def _move(self, i: int) -> None:
        k, joint = self.k, self.k.joints[i]
        twist = self.in_ground_axes(i, joint.velocity)
        relative = self.in_ground_axes(i, joint.drift)
        w, v = twist.block(slice(0, 3)), twist.block(slice(3, 6))
        zero = Matrix.zeros(k.graph, 3)
        with k.graph.made_by(k.owner(i), "motion"):
            omega, alpha, a, at = self.inboard(i)
            relative_w, relative_v = relative.block(slice(0, 3)), relative.block(slice(3, 6))
            relative_w = relative_w + omega.cross(w)
            relative_v = relative_v + omega.cross(v) * 2
            self.omega.append(self._carry(i, "ground_omega", omega + w))
            velocity = zero if self.begins[i] else at + v
            self.v.append(self._carry(i, "ground_v", velocity))
            self.alpha.append(self._carry(i, "ground_alpha", alpha + relative_w))
            self.a.append(self._carry(i, "ground_a", a + relative_v))
            u = field_of(self.omega[i], self.alpha[i])
            self.field.append(self._carry(i, "ground_U", u, CELLS))

    def in_ground_axes(self, i: int, x: Matrix) -> Matrix:
        """A 6-vector in axes of body i, in those of the ground."""
        r = self.orientation[i]
        return Matrix.vstack(r @ x.block(slice(0, 3)), r @ x.block(slice(3, 6)))

    def at_base(self, i: int, x: Matrix) -> Matrix:
        """A field (6, 1) about the origin of body i, about that of the tree."""
        w, v = x.block(slice(0, 3)), x.block(slice(3, 6))
        return Matrix.vstack(w, v + self.position[i].cross(w))

    def inboard(self, i: int) -> tuple[Matrix, Matrix, Matrix, Matrix]:
        """omega, alpha, a and v of the parent at the origin of body i."""
        parent, zero = self.k.system.bodies[i].parent, Matrix.zeros(self.k.graph, 3)
        if parent < 0:
            return zero, zero, -self.gravity, zero
        p = self.position[i] - self.position[parent]
        a = self.a[parent] + self.field[parent] @ p
        v = self.v[parent] + self.omega[parent].cross(p)
        return self.omega[parent], self.alpha[parent], a, v

    def inertia(self, i: int) -> Inertia:
        """Inertia of a body about its origin, in ground axes."""
        k, r = self.k, self.orientation[i]
        with k.graph.made_by(k.owner(i), "inertia"):
            local = of_body(k, i)
            return Inertia(local.mass, r @ local.moment, r.congruence(local.tensor))

    def second_moment(self, i: int, inertia: Inertia) -> Matrix:
        """Second moment of a body about its origin, in ground axes."""
        k = self.k
        with k.graph.made_by(k.owner(i), "inertia"):
            if k.system.bodies[i].second_moment is None:
                return second_moment(inertia.tensor)
            return self.orientation[i].congruence(second_moment_of_body(k, i))

    def inertia_at_base(self, i: int, inertia: Inertia) -> list[int]:
        """Mass, first moment and inertia about the origin of the tree (10)."""
        k = self.k
        with k.graph.made_by(k.owner(i), "inertia"):
            there = moved(inertia, self.position[i])
        tensor = there.tensor.nodes
        upper = [tensor[3 * row + column] for row in range(3) for column in range(row, 3)]
        return [there.mass.node, *there.moment.nodes, *upper]
