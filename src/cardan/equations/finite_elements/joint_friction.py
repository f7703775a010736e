"""Friction of a joint between nodes that its own reaction presses together.

The multipliers of the joint tell the force F across its line, and friction D = c |F|. A balance at
given multipliers contains D; where they are solved for, their share of D is among the columns of
the multipliers.

Source: F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapter 5.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from ...elements.forces.force import Places
from ...ir.arithmetic import Scalar, norm
from ...ir.derivative import directional, forward
from ...ir.function import Output
from ...ir.graph import ONE
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...spatial.axis import unit
from ...topology.system import Force
from ..constraints.constraints import rows
from ..constraints.reaction_friction import friction_forces, with_values
from ..functions.dynamics import Dynamics
from ..kinematics.loads import places
from .joint_constraints import JointConstraint, Seeds, increments


class JointFriction:
    """Friction of cut joint 0 of a small system that follows from its reaction.

    Args:
        d: Dynamics of the small system; the carrier of the joint has no mass.
        constraint: Rows of the joint.
    """

    def __init__(self, d: Dynamics, constraint: JointConstraint) -> None:
        self.d, self.k, self.constraint = d, d.k, constraint
        self.forces = friction_forces(d.k.system)
        all_rows = rows(d.k.system)
        self.lam = d.block("lam", len(all_rows))
        self._switched = [i for i, row in enumerate(all_rows) if row.switched]

    @cached_property
    def normal(self) -> Matrix:
        """Force across the line of the joint (3, 1), in axes of its child."""
        (k, carrier) = self.k, self.constraint.carrier
        assert carrier is not None
        force = self.constraint.wrench(self.lam).block(slice(3, 6))
        joint = k.system.joints[carrier]
        if not joint.element.line:
            return force
        axis = unit(k.matrix(*joint.data[joint.element.line]))
        return force - axis * axis.dot(force)

    def coefficient(self, force: Force) -> Scalar:
        """c of an element."""
        return force.element.reaction_force(places(self.k, force))

    @cached_property
    def _values(self) -> dict[int, int]:
        """Friction of every element by its placeholder."""
        size, values = norm(*self.normal), dict[int, int]()
        for force in self.forces:
            at = places(self.k, force)
            assert at.reaction_force is not None
            values[at.reaction_force.node] = (self.coefficient(force) * size).node
        return values

    def at(self, force: Force) -> Places:
        """Places of an element with its friction by the multipliers."""
        at = places(self.k, force)
        assert at.reaction_force is not None
        value = Scalar(self.k.graph, self._values[at.reaction_force.node])
        return Places(at.motion, at.data, at.frames, at.joints, at.z, at.s, self._settled(value))

    def settled(self, x: Matrix) -> Matrix:
        """Expressions with friction by the multipliers, and poses of nodes."""
        return self.constraint.settled(with_values(x, self._values))

    def _settled(self, x: Scalar) -> Scalar:
        return self.constraint.settled(Matrix.vector(self.k.graph, [x]))[0]

    # the share of the elements in the balance and in the rows

    @cached_property
    def balance(self) -> Matrix:
        """-f of the elements with what they hold (nu, 1), by leaves of the joint."""
        locked = self.locked
        force = -with_values(self.d.forces(), self._values)
        if not locked.rows:
            return force
        multipliers = [self.lam.nodes[i] for i in self._switched]
        return force - locked.T @ Matrix(self.k.graph, locked.rows, 1, multipliers)

    def _picked(self, x: Matrix) -> Matrix:
        """Rows that modes hold."""
        nodes = [n for i in self._switched for n in x.block(slice(i, i + 1)).nodes]
        return Matrix(x.graph, len(self._switched), x.columns, nodes)

    @cached_property
    def locked(self) -> Matrix:
        """G of the velocities that modes hold (k, nu)."""
        return self._picked(self.d.constraints.jacobian)

    @cached_property
    def rates(self) -> Matrix:
        """G u + g_t of the same (k, 1)."""
        return self._picked(self.d.constraints.rates)

    @cached_property
    def gamma(self) -> Matrix:
        """gamma of the same (k, 1)."""
        return self._picked(self.d.constraints.gamma)

    # derivatives

    @cached_property
    def _seeds(self) -> list[Seeds]:
        """Changes of the leaves of the joint and of the places along every speed."""
        pairs = zip(increments(self.k), self.constraint.seeds, strict=True)
        return [places_moved | leaves for places_moved, leaves in pairs]

    def along(self, x: Matrix) -> Matrix:
        """Changes of expressions (n, 1) along every speed (n, nu)."""
        return self._columns(x, self._seeds)

    def by_speeds(self, x: Matrix) -> Matrix:
        """Derivatives of expressions (n, 1) by every speed (n, nu)."""
        g = self.k.graph
        return self._columns(x, [{g.var("u", n): ONE} for n in range(self.k.system.nu)])

    def _columns(self, x: Matrix, seeds: list[Seeds]) -> Matrix:
        columns = directional(self.k.graph, x.nodes, seeds)
        nodes = [column[i] for i in range(x.rows) for column in columns]
        return Matrix(self.k.graph, x.rows, len(seeds), nodes)

    @cached_property
    def by_multipliers(self) -> Matrix:
        """Change of the friction in the balance by every multiplier (m, nu), without Gᵀ lam."""
        g, force = self.k.graph, -with_values(self.d.forces(), self._values)
        nodes = [n for lam in self.lam.nodes for n in forward(g, force.nodes, {lam: ONE})]
        return Matrix(g, self.lam.rows, force.rows, nodes)

    # what is solved for together

    def outputs(self) -> tuple[Output, ...]:
        """c (k) of every element; generalized force by a unit of its friction (k, nu); force across
        the line by every multiplier (k, 3, m)."""
        g, m = self.k.graph, self.lam.rows
        still = self._values.keys()
        nothing = dict.fromkeys(still, g.const(0.0))
        along, normals = list[int](), list[int]()
        slopes = [forward(g, self.normal.nodes, {lam: ONE}) for lam in self.lam.nodes]
        for atom in still:
            unit_force = forward(g, self.d.forces().nodes, {atom: ONE})
            along += rebuild(g, unit_force, nothing, into=g)[1]
            normals += [slope[i] for i in range(3) for slope in slopes]
        count = len(self.forces)
        coefficients = Matrix.vector(g, [self.coefficient(force) for force in self.forces])
        tables: tuple[tuple[str, tuple[int, ...], Sequence[int]], ...] = (
            ("coefficient", (count,), coefficients.nodes),
            ("along", (count, self.k.system.nu), along),
            ("normal", (count, 3, m), normals),
        )
        return tuple(Output(name, shape, tuple(nodes)) for name, shape, nodes in tables)
