"""Derivatives of inverse dynamics with respect to q and u, by a recursion over the tree.

A change of q or u at a joint moves everything outboard of it as one rigid body, besides which it
changes the angular velocity of all of it by the same eta and the acceleration at every point x by
zeta(x) + 2 eta x v(x), where zeta is the acceleration field of a rigid body. Of what is outboard
this needs the composite inertia, the momentum P and the flow K, the integral of v xᵀ dm. How the
forces of a joint answer to (eta, zeta) is handed inward to all joints that can cause them, and the
forces that a joint causes are handed inward to all joints that carry them.

Velocities count from that of the origin of the tree's first body: no force depends on it.

Source: Carpentier and Mansard, Robotics: Science and Systems (2018); Singh, Russo and Wensing,
IEEE Robotics and Automation Letters 7 (2022), for composites; second moments as in newton_euler.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from functools import cached_property

from ...ir.derivative import directional, forward
from ...ir.graph import Graph
from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.moments import Inertia, turn_general
from ..kinematics.accelerations import Accelerations, accelerations
from ..kinematics.composite_bodies import composites, inward
from ..kinematics.inertia import of_body, second_moment_of_body
from ..kinematics.joint_forces import JointForces, along_joint, driving_force, joint_forces
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads, along_speeds
from .directions import Direction


@dataclass(frozen=True)
class Flow:
    """Twice the momentum P and twice K, the integral of v xᵀ dm, about the origin of a body."""

    momentum: Matrix
    gradient: Matrix

    @cached_property
    def moment_map(self) -> Matrix:
        """tr(K) - K: the moment that eta causes is this times eta."""
        k = self.gradient
        x, y, z = k[0, 0], k[1, 1], k[2, 2]
        rows = [
            [y + z, -k[0, 1], -k[0, 2]],
            [-k[1, 0], x + z, -k[1, 2]],
            [-k[2, 0], -k[2, 1], x + y],
        ]
        return Matrix.of(k.graph, rows)

    def force(self, eta: Matrix) -> Matrix:
        """Moment and force (6, 1) that a change of angular velocity asks for."""
        return Matrix.vstack(self.moment_map @ eta, eta.cross(self.momentum))

    def along(self, s: Matrix) -> Matrix:
        """g (3, 1): the part of that along the motion s (6, 1) is g · eta."""
        return self.moment_map.T @ s.block(slice(0, 3)) + self.momentum.cross(s.block(slice(3, 6)))


@dataclass(frozen=True)
class Cause:
    """Effect of one direction at one joint, in the axes of its body.

    Attributes:
        column: Number of the direction.
        shift: Displacement of the body (6, 1), None along u.
        eta: Change of angular velocity (3, 1), apart from turning with the body.
        zeta: Change of acceleration (6, 1) as a field about the body's origin.
        modes: slot of u -> change of the column of S (6, 1) in the axes of the body.
    """

    column: int
    shift: Matrix | None
    eta: Matrix
    zeta: Matrix
    modes: dict[int, Matrix]


class Derivatives:
    """One derivation of columns of d tau.

    Args:
        k: Motion of the tree.
        udot: Accelerations along the speeds (nu, 1); they do not change.
        loads: Applied forces.
        gravity: In ground axes (3, 1).
        directions: Columns along q and u.
    """

    def __init__(
        self,
        k: Kinematics,
        udot: Matrix,
        loads: Loads,
        gravity: Matrix,
        directions: Sequence[Direction],
    ) -> None:
        self.k, self.loads, self.gravity, self.directions = k, loads, gravity, directions
        self.along = [along_joint(k, i, udot) for i in range(len(k.joints))]
        self.acc: Accelerations = accelerations(k, self.along, gravity)
        self.forces: JointForces = joint_forces(k, self.acc, loads)
        self.inertias: list[Inertia] = composites(k)
        self.flows = flows(k)
        self.slots = {(d.block, d.index): n for n, d in enumerate(directions)}
        self.entries: dict[tuple[int, int], int] = {}

    def columns(self) -> list[list[int]]:
        """d tau along every direction, nu nodes each."""
        causes = [self._causes(i) for i in range(len(self.k.joints))]
        self._answers(causes)
        self._effects(causes)
        self._elements()
        slots = range(self.k.system.nu)
        return [[self.entries.get((s, n), 0) for s in slots] for n in range(len(self.directions))]

    def _add(self, slot: int, column: int, node: int) -> None:
        before = self.entries.get((slot, column), 0)
        self.entries[slot, column] = self.k.graph.add(before, node)

    # causes

    def _causes(self, i: int) -> list[Cause]:
        """Effects of the directions along the speeds of a joint."""
        causes = []
        for slot, s in self.k.joints[i].columns:
            for block, shift in (("q", s), ("u", None)):
                if (block, slot) in self.slots:
                    with self.k.graph.made_by(self.k.system.joints[i].name, f"d{block}"):
                        causes.append(self._cause(i, self.slots[block, slot], shift))
        return causes

    def _cause(self, i: int, column: int, shift: Matrix | None) -> Cause:
        k, joint = self.k, self.k.joints[i]
        change, modes = self._joint_change(i, self.directions[column].seeds, shift)
        dw, dv, drift = (
            change.block(slice(0, 3)),
            change.block(slice(3, 6)),
            change.block(slice(6, 12)),
        )
        turn, velocity = joint.velocity.block(slice(0, 3)), self.k.v_from_root[i]
        omega, alpha, a, v = self._inboard(i)
        twice = omega * 2
        zeta_w = (twice + turn).cross(dw) + drift.block(slice(0, 3))
        zeta_v = twice.cross(dv) + drift.block(slice(3, 6)) - dw.cross(velocity * 2)
        eta = dw
        if shift is not None:
            xi_w, xi_v = shift.block(slice(0, 3)), shift.block(slice(3, 6))
            swept = omega.cross(xi_w)
            eta = swept + dw
            zeta_w = zeta_w + alpha.cross(xi_w) + omega.cross(swept)
            zeta_v = zeta_v + a.cross(xi_w) - swept.cross(v * 2)
            zeta_v = zeta_v + alpha.cross(xi_v) + omega.cross(omega.cross(xi_v))
        name = k.system.joints[i].name
        eta.label(name, "eta")
        return Cause(column, shift, eta, Matrix.vstack(zeta_w, zeta_v), modes)

    def _joint_change(
        self, i: int, seeds: dict[int, int], shift: Matrix | None
    ) -> tuple[Matrix, dict[int, Matrix]]:
        """Changes of S u (6) and of drift + S udot (6), and of the columns of S, child axes."""
        k, g, joint = self.k, self.k.graph, self.k.joints[i]
        seeds_of_nodes = dict(seeds)
        if shift is not None:
            # the rotation changes by R [xi]: nothing is differentiated through its parameters
            inner = joint.turns[-1]
            rotation_change = inner @ shift.block(slice(0, 3)).skew
            pairs = zip(inner.nodes, rotation_change.nodes, strict=True)
            seeds_of_nodes |= {n: d for n, d in pairs if g.value(n) is None}
        moved = joint.drift + joint.S @ self.along[i]
        columns = dict(joint.columns)
        nodes = [
            *joint.velocity.nodes,
            *moved.nodes,
            *(n for s in columns.values() for n in s.nodes),
        ]
        slopes = forward(g, nodes, seeds_of_nodes)
        modes = {
            slot: Matrix(g, 6, 1, slopes[12 + 6 * n : 18 + 6 * n]) for n, slot in enumerate(columns)
        }
        return Matrix(k.graph, 12, 1, slopes[:12]), modes

    def _inboard(self, i: int) -> tuple[Matrix, Matrix, Matrix, Matrix]:
        """omega, alpha, a and v of the parent at the origin and in the axes of body i."""
        k, parent, joint = self.k, self.k.system.bodies[i].parent, self.k.joints[i]
        to_child, p = joint.rotation.T, joint.position
        if parent < 0:
            zero = Matrix.zeros(k.graph, 3)
            return zero, zero, to_child @ -self.gravity, zero
        omega, acc = k.omega[parent], self.acc
        return (
            to_child @ omega,
            to_child @ acc.alpha[parent],
            to_child @ (acc.a[parent] + acc.gradient[parent] @ p),
            to_child @ (k.v_from_root[parent] + omega.cross(p)),
        )

    # what the forces of a joint answer to causes inboard of it

    def _answers(self, causes: list[list[Cause]]) -> None:
        for i in range(len(self.k.joints) - 1, -1, -1):
            for slot, s in self.k.joints[i].columns:
                with self.k.graph.made_by(self.k.system.joints[i].name, "answer"):
                    self._answer(
                        i, slot, self.flows[i].along(s), self.inertias[i].momentum(s), causes
                    )

    def _answer(
        self, i: int, slot: int, g: Matrix, momentum: Matrix, causes: list[list[Cause]]
    ) -> None:
        """Hand one row inward: g · eta + momentum · zeta of every cause on the way."""
        bodies = self.k.system.bodies
        while bodies[i].parent >= 0:
            g, momentum = self.k.joints[i].rotation @ g, inward(self.k, i, momentum)
            i = bodies[i].parent
            for cause in causes[i]:
                value = g.dot(cause.eta) + momentum.dot(cause.zeta)
                self._add(slot, cause.column, value.node)

    # what the forces that a cause asks for do to the joints that carry them

    def _effects(self, causes: list[list[Cause]]) -> None:
        k = self.k
        force: dict[int, dict[int, Matrix]] = defaultdict(dict)
        for i, (moment, push) in self._loads().items():
            for n in range(len(self.directions)):
                load = Matrix.vstack(moment[n], push[n])
                if not load.is_zero:
                    force[i][n] = -load
        for i in range(len(k.joints) - 1, -1, -1):
            with k.graph.made_by(k.system.joints[i].name, "effect"):
                self._effect(i, causes[i], force)

    def _effect(self, i: int, causes: list[Cause], force: dict[int, dict[int, Matrix]]) -> None:
        """The columns that reach joint i: along its speeds, then on to the parent."""
        k = self.k
        here, total = force.pop(i, {}), Matrix.vstack(self.forces.moment[i], self.forces.force[i])
        for c in causes:
            inertial = self.flows[i].force(c.eta) + self.inertias[i].momentum(c.zeta)
            here[c.column] = here[c.column] + inertial if c.column in here else inertial
        for n, vector in here.items():
            for slot, s in k.joints[i].columns:
                self._add(slot, n, s.dot(vector).node)
        for c in causes:
            for slot, change in c.modes.items():
                self._add(slot, c.column, change.dot(total).node)
            if c.shift is not None:
                here[c.column] = here[c.column] + _wrench_change(c.shift, total)
        parent = k.system.bodies[i].parent
        if parent >= 0:
            there = force[parent]
            for n, vector in here.items():
                transported = inward(k, i, vector)
                there[n] = there[n] + transported if n in there else transported

    def _loads(self) -> dict[int, tuple[list[Matrix], list[Matrix]]]:
        """Changes of the applied moments and forces of every body along every direction."""
        g = self.k.graph
        seeds = [d.seeds for d in self.directions]
        changes = {}
        for i, wrench in self.loads.wrenches.items():
            moment, force = (directional(g, x.nodes, seeds) for x in wrench)
            changes[i] = (_vectors(g, moment), _vectors(g, force))
        return changes

    def _elements(self) -> None:
        """Forces of elements along the joints themselves, and the inertia of rotors."""
        k, zero = self.k, Matrix.zeros(self.k.graph, 3)
        none = JointForces([zero] * len(k.joints), [zero] * len(k.joints))
        for i in {*self.loads.joints, *self.loads.rotors}:
            driving = driving_force(k, i, none, self.loads, self.along[i])
            rows = along_speeds(k, i, driving)
            changes = directional(k.graph, list(rows.values()), [d.seeds for d in self.directions])
            for n, column in enumerate(changes):
                for slot, node in zip(rows, column, strict=True):
                    self._add(slot, n, node)


def flows(k: Kinematics) -> list[Flow]:
    """Flow of every body with all bodies outboard of it, about its origin in its axes."""
    result = [_flow(k, i) for i in range(len(k.system.bodies))]
    for i in range(len(result) - 1, -1, -1):
        parent, joint = k.system.bodies[i].parent, k.joints[i]
        if parent >= 0:
            with k.graph.made_by(k.owner(parent), "flow"):
                momentum = joint.rotation @ result[i].momentum
                rotated = result[i].gradient
                for turn in reversed(joint.turns):
                    rotated = turn_general(turn, rotated)
                before = result[parent]
                result[parent] = Flow(
                    before.momentum + momentum,
                    before.gradient + rotated + momentum.outer(joint.position),
                )
    return result


def _flow(k: Kinematics, i: int) -> Flow:
    """Flow of one body."""
    with k.graph.made_by(k.owner(i), "flow"):
        inertia, omega, v = of_body(k, i), k.omega[i] * 2, k.v_from_root[i] * 2
        momentum = v * inertia.mass + omega.cross(inertia.moment)
        gradient = v.outer(inertia.moment) + omega.skew @ second_moment_of_body(k, i)
        return Flow(momentum, gradient)


def _wrench_change(shift: Matrix, wrench: Matrix) -> Matrix:
    """Change of moment and force (6, 1) that move with a displaced body."""
    w, v = shift.block(slice(0, 3)), shift.block(slice(3, 6))
    moment, force = wrench.block(slice(0, 3)), wrench.block(slice(3, 6))
    return Matrix.vstack(w.cross(moment) + v.cross(force), w.cross(force))


def _vectors(graph: Graph, columns: Sequence[Sequence[int]]) -> list[Matrix]:
    return [Matrix(graph, 3, 1, column) for column in columns]
