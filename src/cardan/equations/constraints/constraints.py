"""Constraints on the speeds of a tree: loops, rolling, relations that the user wrote.

Every joint that closes a loop says by its residuals at position level what it holds; their
derivative along the relative twist of its two frames, carried back through the joints of the
loop, is the constraint Jacobian: g = 0, G u + g_t = 0, G udot = gamma.

Source: Roberson and Schwertassek, Dynamics of Multibody Systems, chapters 5 and 8.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

from ...elements.closing import closed
from ...elements.internal_states import ModeConstraint
from ...elements.joints.joint import Component
from ...elements.quantity import written_unit
from ...errors import DerivationError
from ...ir.derivative import forward
from ...ir.function import live
from ...ir.graph import ONE, ZERO, Graph
from ...ir.matrix import Matrix, Name
from ...ir.rewrite import rebuild
from ...records import dataclass
from ...topology.internal_states import slides
from ...topology.system import Cut, System
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import places
from .cut_joint_frames import ends

POSITION, VELOCITY = "position", "velocity"


@dataclass(frozen=True)
class Row:
    """One constraint.

    Attributes:
        name: Of its multiplier: ``J3.px``.
        unit: Of its residual at position level, or at velocity level where it has no other.
        owner: The joint or constraint it belongs to.
        level: ``"position"`` or ``"velocity"``: where it holds first.
        switched: Whether an element holds it in some of its modes only.
    """

    name: str
    unit: str
    owner: str
    level: str
    switched: bool = False

    @property
    def component(self) -> str:
        """Component of its owner: ``px``; "" where that has no other."""
        return self.name[len(self.owner) + 1 :]

    def word(self, quantity: str) -> str:
        """A quantity of this row of its owner: ``gamma_px``."""
        return f"{quantity}_{self.component}" if self.component else quantity

    @property
    def force_unit(self) -> str:
        """Unit of its multiplier."""
        length = {"m": "N", "m/s": "N", "rad": "N*m", "rad/s": "N*m"}
        return length.get(self.unit, f"J/({self.unit})" if self.unit else "J")


def rows(system: System) -> tuple[Row, ...]:
    """The constraints of a system: those of position level first, in the order of the matrices."""
    position_rows, slipping = list[Row](), list[Row]()
    for cut in system.cuts:
        cut_components = [cut.element.locked[i] for i in cut.rows]
        position_rows += _rows(cut.name, cut_components, POSITION)
        slipping += _rows(cut.name, cut.element.slips, VELOCITY)
    for joint in system.joints:
        slipping += _rows(joint.name, joint.element.slips, VELOCITY)
    for force in system.forces:
        components = [
            Component(name, written_unit(unit, slides(system.joints, force.joints.values())))
            for name, unit in force.element.locked_velocities()
        ]
        mode_rows = _rows(force.name, components, VELOCITY)
        slipping += [replace(row, switched=True) for row in mode_rows]
    for entry in system.constraints:
        level = VELOCITY if _has_speeds(system, entry.node) else POSITION
        row = Row(entry.name, entry.unit, entry.name, level)
        (position_rows if level == POSITION else slipping).append(row)
    return (*position_rows, *slipping)


def left_out(cut: Cut) -> list[dict[str, str]]:
    """Names and units of the conditions of a loop that its motion fulfills by itself."""
    redundant = [component for k, component in enumerate(cut.element.locked) if k not in cut.rows]
    return [
        {"name": row.name, "unit": row.force_unit} for row in _rows(cut.name, redundant, POSITION)
    ]


def _rows(owner: str, components: Sequence[Component], level: str) -> list[Row]:
    return [Row(f"{owner}.{c.name}", c.unit, owner, level) for c in components]


def _has_speeds(system: System, node: int) -> bool:
    """True when an expression contains speeds, or velocities of frames."""
    for i in live(system.graph, [node]):
        kind, name = system.graph.nodes[i][0], system.graph.nodes[i][1:2]
        if kind == "var" and name == ("u",):
            return True
        if kind == "atom" and name[0] in system.atoms:
            quantity = system.atoms[str(name[0])].quantity
            if quantity in ("u", "velocity", "angular_velocity"):
                return True
    return False


class Constraints:
    """The constraints of a system as expressions, derived when asked for.

    Args:
        k: Motion of the tree.
    """

    def __init__(self, k: Kinematics) -> None:
        self.k = k
        self.rows = rows(k.system)
        self.positions = sum(row.level == POSITION for row in self.rows)
        self._ends = [ends(k, cut) for cut in k.system.cuts]
        self._closed = [
            closed(cut.element, e.rotation, e.position, data)
            for cut, e, data in zip(k.system.cuts, self._ends, self._data, strict=True)
        ]

    @cached_property
    def _data(self) -> list[dict[str, Matrix]]:
        return [
            {name: self.k.matrix(*entry) for name, entry in cut.data.items()}
            for cut in self.k.system.cuts
        ]

    @cached_property
    def _written(self) -> list[tuple[str, int, str]]:
        """(name, node, level) of the relations that the user wrote."""
        levels = {row.owner: row.level for row in self.rows}
        return [
            (entry.name, self.k.resolve([entry.node])[0], levels[entry.name])
            for entry in self.k.system.constraints
        ]

    def _column(self, nodes: Sequence[int]) -> Matrix:
        return Matrix(self.k.graph, len(nodes), 1, nodes)

    @cached_property
    def position(self) -> Matrix:
        """g (mp, 1)."""
        nodes: list[int] = []
        for cut, (g, _) in zip(self.k.system.cuts, self._closed, strict=True):
            nodes += [g.nodes[i] for i in cut.rows]
        nodes += [node for _, node, level in self._written if level == POSITION]
        return self._column(nodes)

    @cached_property
    def closure(self) -> Matrix:
        """Residuals of all closing conditions of all cut joints, dependent ones too."""
        return self._column([node for g, _ in self._closed for node in g.nodes])

    @cached_property
    def assembly_signs(self) -> tuple[tuple[str, ...], Matrix]:
        """Owners of numbers that are positive where cut joints are not turned round, and these."""
        owners, nodes = list[str](), list[int]()
        for n, cut in enumerate(self.k.system.cuts):
            with self.k.graph.made_by(cut.name, "assembly_signs"):
                ends = self._ends[n]
                signs = cut.element.assembly_signs(ends.rotation, ends.position, **self._data[n])
            owners += [cut.name] * signs.rows
            nodes += signs.nodes
        return tuple(owners), self._column(nodes)

    @cached_property
    def _mode_constraints(self) -> list[tuple[str, ModeConstraint]]:
        """Constraints that elements impose in some modes, with their names."""
        return [
            (force.name, constraint)
            for force in self.k.system.forces
            if force.element.locked_velocities()
            for constraint in force.element.holds(places(self.k, force))
        ]

    @cached_property
    def rates(self) -> Matrix:
        """Derivative of g, then velocities that vanish (m, 1): ``rate = G u + g_t``."""
        self.k.graph.describe(Constraints.rates)
        g, position_rows, slipping = self.k.graph, list[int](), list[int]()
        for n, cut in enumerate(self.k.system.cuts):
            with g.made_by(cut.name, "rate"):
                ends, (_, gradient) = self._ends[n], self._closed[n]
                position_rows += [_times(gradient, i, ends.twist) for i in cut.rows]
                slipping += self._slip(n, ends.twist)
        for i, joint in enumerate(self.k.system.joints):
            with g.made_by(joint.name, "slip"):
                slipping += self._tree_slip(i, self.k.speeds[i])
        for name, constraint in self._mode_constraints:
            with g.made_by(name, "rate"):
                slipping.append((constraint.velocity * constraint.active).node)
        for name, node, level in self._written:
            with g.made_by(name, "rate"):
                if level == POSITION:
                    position_rows += forward(g, [node], self.k.time_seeds)
                else:
                    slipping.append(node)
        return self._named([*position_rows, *slipping], g.hint, "rate")

    @cached_property
    def jacobian(self) -> Matrix:
        """Jacobian of the constraints (m, nu), ``G = d(rate) / du``.

        Raises:
            DerivationError: a relation is not linear in the speeds.
        """
        self.k.graph.describe(Constraints.jacobian)
        g, nu = self.k.graph, self.k.system.nu
        if self.k.chosen:
            # the columns of the joints belong to their own speeds
            nodes = self.rates.nodes
            columns = [forward(g, nodes, {g.var("u", s): ONE}) for s in range(nu)]
            return self._labeled([[c[i] for c in columns] for i in range(len(nodes))])
        position_rows, slipping = list[list[int]](), list[list[int]]()
        for n, cut in enumerate(self.k.system.cuts):
            with g.made_by(cut.name, "G"):
                ends, (_, gradient) = self._ends[n], self._closed[n]
                for i in cut.rows:
                    entries = {s: _times(gradient, i, c) for s, c in ends.columns.items()}
                    position_rows.append([entries.get(s, ZERO) for s in range(nu)])
                slips = dict[int, list[int]]()
                for s, c in ends.columns.items():
                    with g.made_by(cut.name, f"slip_{self.k.speed_names[s]}"):
                        slips[s] = self._slip(n, c)
                for i in range(len(cut.element.slips)):
                    slipping.append([slips[s][i] if s in slips else ZERO for s in range(nu)])
        for i, joint in enumerate(self.k.system.joints):
            with g.made_by(joint.name, "G"):
                unit = Matrix.identity(g, len(joint.element.speeds))
                units = {joint.u + j: self._tree_slip(i, unit.column(j)) for j in range(len(unit))}
                for n in range(len(joint.element.slips)):
                    slipping.append([units[s][n] if s in units else ZERO for s in range(nu)])
        for name, constraint in self._mode_constraints:
            with g.made_by(name, "G"):
                velocity = (constraint.velocity * constraint.active).node
                slipping.append(self.gradient(name, velocity, VELOCITY))
        for name, node, level in self._written:
            with g.made_by(name, "G"):
                row = self.gradient(name, node, level)
                (position_rows if level == POSITION else slipping).append(row)
        return self._labeled([*position_rows, *slipping])

    def _labeled(self, entries: Sequence[Sequence[int]]) -> Matrix:
        """G of its rows, whose entries are called after row and speed."""
        g, speeds = self.k.graph, self.k.speed_names
        for row, nodes in zip(self.rows, entries, strict=True):
            for speed, node in zip(speeds, nodes, strict=True):
                g.label(node, row.owner, f"{row.word('G')}_{speed}")
        return Matrix(g, len(self.rows), len(speeds), [x for nodes in entries for x in nodes])

    @cached_property
    def gamma(self) -> Matrix:
        """The right side of G udot = gamma (m, 1), ``gamma = -d(rate)/dt at udot = 0``."""
        self.k.graph.describe(Constraints.gamma)
        nodes = [_negated(self.k.graph, x) for x in self.k.derivative(self.rates).nodes]
        return self._named(nodes, self.k.graph.label, "gamma")

    def _named(self, nodes: Sequence[int], name: Name, quantity: str) -> Matrix:
        """A column with an entry per constraint, named row by row."""
        for row, node in zip(self.rows, nodes, strict=True):
            name(node, row.owner, row.word(quantity))
        return self._column(nodes)

    def _slip(self, n: int, twist: Matrix) -> list[int]:
        cut, ends = self.k.system.cuts[n], self._ends[n]
        slip = cut.element.slip(ends.rotation, ends.position, twist, **self._data[n])
        return [] if slip is None else list(slip.nodes)

    def _tree_slip(self, i: int, speeds: Matrix) -> list[int]:
        joint, k = self.k.system.joints[i], self.k
        if not joint.element.slips:
            return []
        slip = joint.element.sliding(k.coordinates[i], speeds, **k.data[i])
        return [] if slip is None else list(slip.nodes)

    def gradient(self, name: str, node: int, level: str) -> list[int]:
        """Derivatives of the rate of a relation with respect to the speeds.

        Raises:
            DerivationError: it is not linear in them.
        """
        g, nu = self.k.graph, self.k.system.nu
        rate = node if level == VELOCITY else forward(g, [node], self.k.time_seeds)[0]
        slots = [g.var("u", s) for s in range(nu)]
        row = [forward(g, [rate], {slot: ONE})[0] for slot in slots]
        if set(live(g, row)) & set(slots):
            raise DerivationError(
                f"constraint '{name}' is not linear in the speeds: write it so that every speed "
                "and velocity in it has a factor without speeds"
            )
        return row

    def pose(self, cut: int) -> tuple[Matrix, Matrix]:
        """R_PC (3, 3) and p_PC (3, 1) of the frames of a cut joint, in P axes."""
        return self._ends[cut].rotation, self._ends[cut].position

    @cached_property
    def prescribed(self) -> Matrix:
        """g_t of the relations that the user wrote (their number, 1): their rates at rest."""
        g, at = self.k.graph, {row.owner: i for i, row in enumerate(self.rows)}
        still = {g.var("u", s): ZERO for s in range(self.k.system.nu)}
        nodes = [self.rates.nodes[at[name]] for name, _, _ in self._written]
        return self._column(rebuild(g, nodes, still, into=g)[1])

    def wrench(self, cut: int, multipliers: Matrix) -> Matrix:
        """Moment and force of P on C of a cut joint (6, 1), at the origin of C in C axes."""
        at = {name: n for n, name in reversed(list(enumerate(r.name for r in self.rows)))}
        record = self.k.system.cuts[cut]
        gradient, total = self._closed[cut][1], Matrix.zeros(self.k.graph, 6)
        for i in record.rows:
            row = gradient.block(slice(i, i + 1)).T
            total = total + row * multipliers[at[f"{record.name}.{record.element.locked[i].name}"]]
        for n, component in enumerate(record.element.slips):
            unit = Matrix.identity(self.k.graph, 6)
            slips = [self._slip(cut, unit.column(j))[n] for j in range(6)]
            total = total + self._column(slips) * multipliers[at[f"{record.name}.{component.name}"]]
        return total


def _negated(g: Graph, x: int) -> int:
    """-x by differences with exchanged sides where x has some: what has a name needs no sign."""
    op, *read = g.nodes[x]
    if op == "sub":
        return g.intern(("sub", read[1], read[0]))
    for a, b in (read, read[::-1]) if op == "add" else ():
        other = _negated(g, a)
        if g.nodes[other][0] != "neg":
            return g.intern(("sub", other, b))
    return g.neg(x)


def _times(gradient: Matrix, i: int, twist: Matrix) -> int:
    """Row i of a gradient times a twist."""
    return gradient.block(slice(i, i + 1)).T.dot(twist).node
