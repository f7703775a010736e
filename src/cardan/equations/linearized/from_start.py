"""The linear model from the start: small motions of a tree relative to its gross motion.

A small displacement (theta, s) at a joint moves everything outboard of it as one rigid body.
Besides being moved, angular velocities outboard change by eta and accelerations at every point by a
field (zeta_w, zeta_v) and 2 eta x v. With omega, v, alpha, a of the inner body there, v_o of the
outer one, and the twist (d_w, d_v) and acceleration (b_w, b_v) that the joint adds by itself,

    eta    = omega x theta + d_w,
    zeta_w = alpha x theta + omega x (omega x theta) + (2 omega + w_r) x d_w + b_w,
    zeta_v = alpha x s + omega x (omega x s) + a x theta + 2 v x (omega x theta)
             + 2 omega x d_v + 2 v_o x d_w + b_v.

The forces F of all that is outboard change by I zeta + T eta, composite inertia and flow of
momentum, and are turned along. Changes of speeds are the same with theta = s = 0. Forces and
constraints are expanded where they act. Terms of second order are never formed.

Source: R. E. Roberson, R. Schwertassek, Dynamics of Multibody Systems (1988), chapter 13;
J. Carpentier, N. Mansard, Robotics: Science and Systems (2018), for composites.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...ir.derivative import forward
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...records import dataclass
from ..functions.directions import Direction, directions
from . import differentiated
from .all_coordinates import FullMatrices
from .gross import Gross, halves, wrench_change
from .local import Local
from .outward import outward
from .reference import Reference


@dataclass(frozen=True)
class Cause:
    """Effect of a direction at one joint, on its outer body (6, 1) each.

    Attributes:
        column: Number of the direction.
        J: Displacement (theta, s). zeta: See above.
        change: Of the twist, apart from being moved; eta is its angular part.
        modes: Speed -> change of the column of the joint, apart from being moved.
    """

    column: int
    J: Matrix
    change: Matrix
    zeta: Matrix
    modes: dict[int, Matrix]

    @property
    def eta(self) -> Matrix:
        """Change of the angular velocity (3, 1)."""
        return self.change.block(slice(0, 3))


def full_matrices(at: Reference) -> FullMatrices:
    """All matrices at the reference."""
    return FullMatrices(**SmallMotions(at).matrices(), **outward(at, differentiated.columns))


class SmallMotions:
    """One derivation.

    Args:
        at: The reference.
    """

    def __init__(self, at: Reference) -> None:
        self.at, self.graph, nu = at, at.graph, at.system.nu
        self.gross = Gross(at)
        self.local = Local(self.gross)
        self.bodies = self.gross.bodies
        self.forces = self._with_loads()
        self.blocks = {b: directions(at.k, b, at.names) for b in ("q", "u", "z", "r")}
        self.directions = [d for block in self.blocks.values() for d in block]
        self.causes = [self._causes(i) for i in range(len(self.bodies))]
        self.balance = [[ZERO] * nu for _ in self.directions]
        self.M = [[ZERO] * nu for _ in range(nu)]
        self._outboard()
        self._inboard()
        self._elements()

    def matrices(self) -> dict[str, Matrix]:
        """Matrices of :data:`.all_coordinates.DYNAMIC`, and by_z and by_r."""
        nu, seeds = self.at.system.nu, self.seeds
        matrices = {"M": Matrix(self.graph, nu, nu, [x for row in self.M for x in row])}
        start = 0
        for name, block in zip(("K", "C", "by_z", "by_r"), self.blocks.values(), strict=True):
            columns = self.balance[start : start + len(block)]
            matrices[name] = self._matrix(columns, nu)
            start += len(block)
        matrices["by_r"] = -matrices["by_r"]
        n = len(self.blocks["q"])
        for law, along in ((self.local.rates, ("R", "G")), (self.local.accelerated, ("Qe", "Qv"))):
            columns = [list(self.local.change(law, s).nodes) for s in seeds[: 2 * n]]
            matrices[along[0]] = self._matrix(columns[:n], law.rows)
            matrices[along[1]] = self._matrix(columns[n:], law.rows)
        return matrices

    def _matrix(self, columns: Sequence[Sequence[int]], rows: int) -> Matrix:
        nodes = [column[i] for i in range(rows) for column in columns]
        return Matrix(self.graph, rows, len(columns), nodes)

    def _add(self, column: int, slot: int, node: int) -> None:
        row = self.balance[column]
        row[slot] = self.graph.add(row[slot], node)

    def _with_loads(self) -> list[Matrix]:
        """Forces that joints transmit, of everything outboard (6, 1)."""
        result = list(self.gross.forces)
        for body, wrench in self.local.wrenches.items():
            load, i = Matrix.vstack(*(self.local.put(x) for x in wrench)), body
            while i >= 0:
                result[i] = result[i] - load
                load, i = self.gross.inward(i, load), self.bodies[i].parent
        return result

    # causes

    def _causes(self, i: int) -> list[Cause]:
        """Effects of the directions at a joint."""
        causes, motion = list[Cause](), self.gross.motion[i]
        for n, d in enumerate(self.directions):
            J = self._displacement(i, d)
            more, added = self._change(motion.twist, d), self._change(motion.acceleration, d)
            if not (J.is_zero and more.is_zero and added.is_zero):
                modes = {s: self._change(x, d) for s, x in motion.columns.items()}
                modes = {s: x for s, x in modes.items() if not x.is_zero}
                causes.append(self._cause(i, n, J, more, added, modes))
        return causes

    def _cause(
        self, i: int, n: int, J: Matrix, more: Matrix, added: Matrix, modes: dict[int, Matrix]
    ) -> Cause:
        """The formulas above."""
        inner, outer = self.gross.inner[i], self.gross.outer[i]
        (theta, s), (d_w, d_v), (b_w, b_v) = halves(J), halves(more), halves(added)
        omega, swept_omega = inner.omega, inner.omega.cross(theta)
        zeta_w = inner.alpha.cross(theta) + omega.cross(swept_omega) + b_w
        zeta_w = zeta_w + (omega + outer.omega).cross(d_w)
        swept = omega.cross(s)
        zeta_v = inner.alpha.cross(s) + omega.cross(swept) + inner.a.cross(theta) + b_v
        zeta_v = zeta_v + (inner.v.cross(swept_omega) + omega.cross(d_v) + outer.v.cross(d_w)) * 2
        change = Matrix.vstack(swept_omega, swept + inner.v.cross(theta)) + more
        return Cause(n, J, change, Matrix.vstack(zeta_w, zeta_v), modes)

    def _change(self, x: Matrix, d: Direction) -> Matrix:
        """Change of what a joint does by itself."""
        nodes = forward(self.graph, x.nodes, d.seeds)
        return self.at.put(Matrix(self.graph, x.rows, 1, nodes))

    def _displacement(self, i: int, d: Direction) -> Matrix:
        zero = Matrix.zeros(self.graph, 6)
        if d.block == "q":
            return self.gross.columns[i].get(d.index, zero)
        if d.block != "r":
            return zero
        # prescribed joints have one coordinate, whose rate is their speed
        q, modes = self.at.k.coordinates[i], self.at.k.joints[i].S
        moved = Matrix(self.graph, q.rows, 1, forward(self.graph, q.nodes, d.seeds))
        return zero if moved.is_zero else self.at.put(modes @ moved)

    # inertia

    def _outboard(self) -> None:
        """Response at joints to causes inboard of them: of I zeta and T eta, transmitted inward."""
        gross = self.gross
        for j in range(len(self.bodies)):
            for slot, s in gross.columns[j].items():
                inertial, flowing = gross.inertias[j].momentum(s), gross.flows[j]
                w, v = halves(s)
                along = flowing.moment_map.T @ w + flowing.momentum.cross(v)
                i = j
                while i >= 0:
                    self._feel(i, slot, inertial, along, i == j)
                    inertial, along = gross.inward(i, inertial), gross.rotation[i] @ along
                    i = self.bodies[i].parent

    def _feel(self, i: int, slot: int, inertial: Matrix, along: Matrix, here: bool) -> None:
        """Forces along a speed by what happens at joint i."""
        for c in self.causes[i]:
            felt = inertial.dot(c.zeta) + along.dot(c.eta)
            self._add(c.column, slot, felt.node)
        for other, s in self.gross.columns[i].items():
            # within one joint each pair is met from both sides
            if not here or other <= slot:
                self._add_mass(slot, other, inertial.dot(s).node, not here or other < slot)

    def _add_mass(self, row: int, column: int, node: int, both: bool) -> None:
        """Add to M, and to its mirror entry."""
        g, M = self.graph, self.M
        M[row][column] = g.add(M[row][column], node)
        if both:
            M[column][row] = g.add(M[column][row], node)

    def _inboard(self) -> None:
        """Response at joints to causes outboard of them, and to loads:

        forces transmitted inward.
        """
        waiting = self._loads()
        for i in range(len(self.bodies) - 1, -1, -1):
            force, parent = waiting[i], self.bodies[i].parent
            for n, x in force.items():
                for slot, s in self.gross.columns[i].items():
                    self._add(n, slot, s.dot(x).node)
            for c in self.causes[i]:
                for slot, change in c.modes.items():
                    self._add(c.column, slot, change.dot(self.forces[i]).node)
                term = self._response(i, c)
                force[c.column] = force[c.column] + term if c.column in force else term
            if parent >= 0:
                there = waiting[parent]
                for n, x in force.items():
                    term = self.gross.inward(i, x)
                    there[n] = there[n] + term if n in there else term

    def _response(self, i: int, c: Cause) -> Matrix:
        """Change of the forces of all that a joint moves (6, 1)."""
        gross = self.gross
        response = gross.inertias[i].momentum(c.zeta) + gross.flows[i].force(c.eta)
        return response + wrench_change(c.J, self.forces[i])

    # forces

    def _moved(self) -> list[dict[int, int]]:
        """Changes of the leaves along every direction, where laws read them."""
        read, seeds = self.local.read(), [dict(d.seeds) for d in self.directions]
        zero = Matrix.zeros(self.graph, 6)
        parts: list[dict[int, tuple[Matrix, ...]]] = []
        for i, body in enumerate(self.bodies):
            changes = dict[int, tuple[Matrix, ...]]()
            if body.parent >= 0:
                for n, x in parts[body.parent].items():
                    changes[n] = tuple(self.gross.outward(i, part) for part in x)
            for c in self.causes[i]:
                before, more = (
                    changes.get(c.column, (zero,) * 3),
                    self.local.true(i, c.J, c.change, c.zeta),
                )
                changes[c.column] = tuple(a + b for a, b in zip(before, more, strict=True))
            parts.append(changes)
            if i in read:
                for n, (J, change, zeta) in changes.items():
                    seeds[n] |= self.local.seeds(i, J, change, zeta)
        return seeds

    def _loads(self) -> list[dict[int, Matrix]]:
        """Applied and constraint forces, apart from being moved: less of what joints supply."""
        self.seeds = self._moved()
        loads = [dict[int, Matrix]() for _ in self.bodies]
        for body, wrench in self.local.wrenches.items():
            for n, seeds in enumerate(self.seeds):
                change = Matrix.vstack(*(self.local.change(x, seeds) for x in wrench))
                if not change.is_zero:
                    loads[body][n] = -change
        return loads

    def _elements(self) -> None:
        """Forces along the speeds themselves, and rotors."""
        g, along = self.graph, self.local.along
        for n, seeds in enumerate(self.seeds):
            for slot, node in enumerate(self.local.change(along, seeds).nodes):
                self._add(n, slot, g.neg(node))
        for n, d in enumerate(directions(self.at.k, "udot", self.at.names)):
            for slot, node in enumerate(self.local.change(along, d.seeds).nodes):
                self.M[slot][n] = g.sub(self.M[slot][n], node)
