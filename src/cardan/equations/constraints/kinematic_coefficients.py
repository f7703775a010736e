"""Quantities that closed loops determine, under names: equations of mechanisms as books write them.

A joint that follows has a coordinate phi, rates k of it by the independent speeds, and second rates
L: kinematic coefficients. Equations in these are as short as those of a tree; without them
every phi is an expression with roots in it.

Source: S. Doughty, Mechanics of Machines, chapters on kinematic coefficients and Eksergian's
equation.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import TYPE_CHECKING

from ...elements.joints.joint import entries
from ...ir.function import Block, live
from ...ir.graph import ONE, ZERO, Graph
from ...ir.matrix import Matrix
from ...ir.ops import LEAVES
from ...ir.rewrite import rebuild
from ...records import dataclass
from ...schema.blocks import of_rate
from .dyads import without_guard

if TYPE_CHECKING:
    from ...topology.system import System
    from .closures import Position

# components of a joint that say where a point is
PLACES = frozenset(["px", "py", "pz"])
Shares = dict[int, Matrix]


@dataclass
class KinematicCoefficients:
    """Names for what closed loops determine.

    Attributes:
        coordinates: Joint -> names of its coordinates.
        speeds: Names of the speeds of the system.
        taken: Names that mean something else.
        definitions: Symbol -> node of what it stands for, in terms of those before it.
    """

    coordinates: Mapping[int, Sequence[str]]
    speeds: Sequence[str]
    taken: set[str]
    definitions: dict[str, int] = field(default_factory=dict)

    @classmethod
    def of(cls, system: System, blocks: Mapping[str, Block]) -> KinematicCoefficients:
        """For the joints of a system that follow."""
        coordinates = {
            i: entries(joint.name, joint.element.coordinates)
            for i, joint in enumerate(system.joints)
            if joint.closure >= 0
        }
        taken = {entry for block in blocks.values() for entry in block.entries}
        return cls(coordinates, blocks["u"].entries, taken | set(system.atoms))

    def position(self, g: Graph, solution: Position) -> Position:
        """The coordinates of a loop as symbols; lengths come first, angles may use them."""
        q = {i: list(column.nodes) for i, column in solution.q.items()}
        places = [(i, n) for i, nodes in q.items() for n in range(len(nodes))]
        angle_nodes = dict(zip(places, solution.angles, strict=True))
        short: dict[int, int] = {}
        for i, n in sorted(places, key=lambda place: angle_nodes[place][1] != ZERO):
            node, cosine, sine = angle_nodes[i, n]
            (value,) = rebuild(g, [node], short, into=g)[1]
            value = _shortest_arms(g, without_guard(g, value))
            symbol = q[i][n] = self._named(g, self.coordinates[i][n], value)
            waves = {cosine: g.apply("cos", symbol), sine: g.apply("sin", symbol)}
            replacements = {node: symbol} if cosine == ZERO else {node: symbol, **waves}
            short |= {a: b for a, b in replacements.items() if g.nodes[a][0] not in LEAVES}
        columns = {i: Matrix(g, len(nodes), 1, nodes) for i, nodes in q.items()}
        angles = tuple((q[i][n], ZERO, ZERO) for i, n in places)
        return type(solution)(columns, {}, angles)

    def rates(
        self, g: Graph, keys: Sequence[tuple[int, int]], shares: Shares, rates: Matrix
    ) -> tuple[Shares, Matrix]:
        """Shares of the speeds, and rates of the joints in them: phi.theta is dphi/dtheta."""
        names = [self.coordinates[i][n] for i, n in keys]
        named = {
            slot: self._column(g, [f"{name}.{self._speed(slot)}" for name in names], column)
            for slot, column in shares.items()
        }
        explicit = _at(g, rates, dict.fromkeys(_speeds(g, rates), ZERO))
        total = self._column(g, [f"{name}.t" for name in names], explicit)
        for slot, column in named.items():
            total = total + column * Matrix(g, 1, 1, [g.var("u", slot)])[0]
        return named, total

    def accelerations(
        self, g: Graph, keys: Sequence[tuple[int, int]], shares: Shares, bias: Matrix
    ) -> Matrix:
        """Accelerations at udot = 0: phi.theta.theta theta.u² where one speed moves all."""
        names = [self.coordinates[i][n] for i, n in keys]
        if len(shares) == 1 and not any(f"{name}.t" in self.definitions for name in names):
            (slot,) = shares
            u, suffix = g.var("u", slot), self._speed(slot)
            square = Matrix(g, 1, 1, [g.square(u)])[0]
            column = _at(g, bias, {u: ONE})
            return self._column(g, [f"{name}.{suffix}.{suffix}" for name in names], column) * square
        return self._column(g, [f"{name}.bias" for name in names], bias)

    def used(self, g: Graph, roots: Sequence[int]) -> list[str]:
        """Symbols in expressions and in the definitions of these, in their order."""
        names, ahead = set[str](), list(roots)
        while ahead:
            atoms = {g.nodes[i][1] for i in live(g, ahead) if g.nodes[i][0] == "atom"}
            new = (atoms & set(self.definitions)) - names
            names |= new
            ahead = [self.definitions[name] for name in new]
        return [name for name in self.definitions if name in names]

    def _speed(self, slot: int) -> str:
        return of_rate(self.speeds[slot])

    def _column(self, g: Graph, names: Sequence[str], x: Matrix) -> Matrix:
        nodes = [self._named(g, name, node) for name, node in zip(names, x.nodes, strict=True)]
        return Matrix(g, x.rows, 1, nodes)

    def _named(self, g: Graph, name: str, node: int) -> int:
        """A symbol for a node, or the node itself where that is as short."""
        kind, *read = g.nodes[node]
        if kind in LEAVES or (kind == "neg" and g.nodes[read[0]][0] in LEAVES):
            return node
        while name in self.taken:
            name += "'"
        self.taken.add(name)
        self.definitions[name] = node
        return g.atom(name)


def in_fixed_axes(rows: Matrix, components: Sequence[str], axes: Matrix) -> Matrix:
    """Conditions that two points meet, in axes that no joint of the loop turns.

    Args:
        rows: Their gradients, in the axes of the joint that closes the loop.
        components: Which of its components they hold, some of :data:`PLACES`.
        axes: R from its axes to the fixed ones (3, 3).
    """
    used = [[axes[i, "xyz".index(name[1])] for name in components] for i in range(3)]
    across = [row for row in used if any(entry.node != ZERO for entry in row)]
    # in a plane that no two of the axes span nothing is gained
    return Matrix.of(rows.graph, across) @ rows if len(across) == len(components) else rows


def _shortest_arms(g: Graph, angle: int) -> int:
    """atan2(a / s, b / s) as atan2(a, b); :func:`.dyads.turn` divides by squares only."""
    op, *read = g.nodes[angle]
    if op != "atan2" or any(g.nodes[i][0] != "div" for i in read):
        return angle
    (_, a, s), (_, b, t) = (g.nodes[i] for i in read)
    return g.apply("atan2", a, b) if s == t else angle


def _speeds(g: Graph, x: Matrix) -> list[int]:
    return [i for i in live(g, x.nodes) if g.nodes[i][:2] == ("var", "u")]


def _at(g: Graph, x: Matrix, values: Mapping[int, int]) -> Matrix:
    """Expressions at given values of leaves."""
    return Matrix(g, x.rows, x.columns, rebuild(g, x.nodes, values, into=g)[1])
