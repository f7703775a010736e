"""Loops that are solved in closed form: coordinates, rates and accelerations of their joints.

The coordinates follow from the geometry of the loop (:mod:`.dyads`), the rates and accelerations
from its closing conditions, which are linear in them: no iteration, no drift, and no multipliers.
Every loop may use the joints that those before it have determined.

Source: Roberson and Schwertassek, Dynamics of Multibody Systems, chapter 8; M. Hiller and A.
Kecskemethy, work on characteristic pairs of joints.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING

from ...elements.closing import closed
from ...ir.derivative import forward
from ...ir.graph import ZERO, Graph
from ...ir.matrix import Matrix
from ...ir.ops import LEAVES
from ...ir.rewrite import rebuild
from ...records import dataclass
from ..kinematics.lazy_list import Memo
from . import dyads, legs
from .cut_joint_frames import Ends, ends
from .dyads import JointSolution
from .kinematic_coefficients import PLACES, in_fixed_axes

if TYPE_CHECKING:
    from ..kinematics.kinematics import Kinematics

SOLUTIONS = {**dyads.SOLUTIONS, "leg": legs.leg, "arm": legs.arm}


@dataclass(frozen=True)
class Position:
    """Coordinates of the joints of a loop.

    Attributes:
        q: Joint -> coordinates (n, 1).
        substitutions: Node of a cosine or sine of a coordinate -> its expression without the angle.
        angles: (node of the coordinate, cosine, sine), the two ZERO for a length.
    """

    q: dict[int, Matrix]
    substitutions: dict[int, int]
    angles: tuple[tuple[int, int, int], ...]

    def settled(self, x: Matrix) -> Matrix:
        """Expressions with the cosines and sines put in."""
        if not self.substitutions:
            return x
        return Matrix(
            x.graph,
            x.rows,
            x.columns,
            rebuild(x.graph, x.nodes, self.substitutions, into=x.graph)[1],
        )


@dataclass(frozen=True)
class Velocity:
    """Rates of the joints of a loop.

    Attributes:
        rates: Joint -> its speeds (n, 1).
        shares: Joint -> slot -> share of the speed in that slot (n, 1).
        bias: Joint -> its accelerations where udot of the system is 0 (n, 1).
        seeds: Node -> its time derivative at udot = 0.
        ends: The frames that close the loop.
        gradient: Of the closing conditions along their twist (r, 6).
        inverse: Of the columns of the rates in them (r, r).
    """

    rates: dict[int, Matrix]
    shares: dict[int, dict[int, Matrix]]
    bias: dict[int, Matrix]
    seeds: dict[int, int]
    ends: Ends
    gradient: Matrix
    inverse: Matrix


class Closures:
    """The loops of a system that are solved, each when it is first asked for."""

    def __init__(self, k: Kinematics) -> None:
        self.k = k

    @cached_property
    def _positions(self) -> Memo[Position]:
        return Memo(len(self.k.system.closures), self._position)

    @cached_property
    def _velocities(self) -> Memo[Velocity]:
        return Memo(len(self.k.system.closures), self._velocity)

    def position(self, n: int) -> Position:
        """Coordinates that loop n determines."""
        return self._positions[n]

    def velocity(self, n: int) -> Velocity:
        """Rates that loop n determines."""
        return self._velocities[n]

    def seeds(self, n: int) -> dict[int, int]:
        """Time derivatives at udot = 0 of what loop n determines."""
        return self._velocities[n].seeds

    def _position(self, n: int) -> Position:
        closure, g = self.k.system.closures[n], self.k.graph
        with g.made_by(closure.cut.name, "closure"):
            solutions = SOLUTIONS[closure.kind](self.k, closure)
            q, substitutions, angles = {}, dict[int, int](), []
            for i in closure.unknown:
                nodes = []
                for entry in solutions[i]:
                    node = entry.coordinate(g)
                    nodes.append(node)
                    if entry.cosine is None or entry.sine is None:
                        angles.append((node, ZERO, ZERO))
                        continue
                    substitutions[g.apply("cos", node)] = entry.cosine.node
                    substitutions[g.apply("sin", node)] = entry.sine.node
                    angles.append((node, entry.cosine.node, entry.sine.node))
                q[i] = Matrix(g, len(nodes), 1, nodes)
        self._label(solutions)
        solution = Position(q, substitutions, tuple(angles))
        return (
            solution if self.k.coefficients is None else self.k.coefficients.position(g, solution)
        )

    def _label(self, solutions: dict[int, tuple[JointSolution, ...]]) -> None:
        for i, entries in solutions.items():
            joint = self.k.system.joints[i]
            for component, entry in zip(joint.element.coordinates, entries, strict=True):
                suffix = f"_{component.name}" if component.name else ""
                for quantity, value in (("cos", entry.cosine), ("sin", entry.sine)):
                    if value is not None:
                        self.k.graph.label(value.node, joint.name, f"{quantity}{suffix}")

    def _velocity(self, n: int) -> Velocity:
        closure, g, k = self.k.system.closures[n], self.k.graph, self.k
        with g.made_by(closure.cut.name, "rates"):
            components = [closure.cut.element.locked[i].name for i in closure.cut.rows]
            fixed_axes = k.coefficients is not None and set(components) <= PLACES
            e = ends(k, closure.cut, closure.unknown, fixed_axes)
            data = {name: k.matrix(*entry) for name, entry in closure.cut.data.items()}
            _, all_rows = closed(closure.cut.element, e.rotation, e.position, data)
            rows = [all_rows.block(slice(i, i + 1)) for i in closure.cut.rows]
            gradient = Matrix.vstack(*rows)
            if fixed_axes:
                gradient = in_fixed_axes(gradient, components, e.axes)
            keys = list(e.open)
            square = gradient @ Matrix.hstack(*e.open.values())
            inverse = _inverse(square)
            shares = {slot: -(inverse @ (gradient @ c)) for slot, c in e.columns.items()}
            rates = -(inverse @ (gradient @ e.twist))
            if k.coefficients is not None:
                shares, rates = k.coefficients.rates(g, keys, shares, rates)
            bias, seeds = self._bias(n, square, gradient @ e.twist, rates, inverse)
            if k.coefficients is not None:
                bias = k.coefficients.accelerations(g, keys, shares, bias)
                seeds |= _seeds(g, zip(rates.nodes, bias.nodes, strict=True))
        ranges, start = {}, 0
        for i in closure.unknown:
            count = sum(key[0] == i for key in keys)
            ranges[i] = slice(start, start + count)
            start += count
        return Velocity(
            {i: rates.block(rows_of_joint) for i, rows_of_joint in ranges.items()},
            {i: {s: x.block(place) for s, x in shares.items()} for i, place in ranges.items()},
            {i: bias.block(place) for i, place in ranges.items()},
            seeds,
            e,
            gradient,
            inverse,
        )

    def _bias(
        self, n: int, square: Matrix, fixed_columns: Matrix, rates: Matrix, inverse: Matrix
    ) -> tuple[Matrix, dict[int, int]]:
        """Accelerations at udot = 0, and the time derivatives of what the loop determines.

        Args:
            n: The loop, whose closing conditions at velocity level are square rates + known.
            square, fixed_columns: Columns of the rates that are looked for, and the rest.
            rates: What they are.
            inverse: Of ``square``.
        """
        g = self.k.graph
        before = dict(self.k.slot_seeds)
        for earlier in range(n):
            before |= self.seeds(earlier)
        seeds = self._moving(n, rates)
        change = forward(g, (*square.nodes, *fixed_columns.nodes), before | seeds)
        count = len(square.nodes)
        square_rate = Matrix(g, square.rows, square.columns, change[:count])
        bias = -(inverse @ (square_rate @ rates + Matrix(g, fixed_columns.rows, 1, change[count:])))
        return bias, seeds | _seeds(g, zip(rates.nodes, bias.nodes, strict=True))

    def _moving(self, n: int, rates: Matrix) -> dict[int, int]:
        """Time derivatives of the coordinates of a loop and of their cosines and sines."""
        g, moving = self.k.graph, list[tuple[int, int]]()
        for (node, cosine, sine), rate in zip(self.position(n).angles, rates.nodes, strict=True):
            moving.append((node, rate))
            if cosine != sine:
                moving.append((cosine, g.neg(g.mul(sine, rate))))
                moving.append((sine, g.mul(cosine, rate)))
        return _seeds(g, moving)


def _seeds(g: Graph, moving: Iterable[tuple[int, int]]) -> dict[int, int]:
    """Nodes with their time derivatives, the negated ones with their operands; leaves have none."""
    seeds = {}
    for node, dot in moving:
        if g.nodes[node][0] == "neg":
            node, dot = g.nodes[node][1], g.neg(dot)
        # a coordinate under a name is a leaf that moves
        if g.nodes[node][0] not in LEAVES or g.nodes[node][0] == "atom":
            seeds[node] = dot
    return seeds


def _inverse(a: Matrix) -> Matrix:
    """Inverse of a matrix of one to three rows by its cofactors."""
    g, n = a.graph, a.rows
    if n == 1:
        return Matrix.identity(g, 1) / a[0, 0]
    if n == 2:
        adjugate = Matrix.of(g, [[a[1, 1], -a[0, 1]], [-a[1, 0], a[0, 0]]])
        return adjugate / (a[0, 0] * a[1, 1] - a[0, 1] * a[1, 0])
    rows = [a.block(slice(i, i + 1)).T for i in range(3)]
    across = [rows[1].cross(rows[2]), rows[2].cross(rows[0]), rows[0].cross(rows[1])]
    return Matrix.hstack(*across) / rows[0].dot(across[0])
