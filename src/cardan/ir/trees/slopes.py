"""Mass matrix and derivatives of a tree as expressions, from the numbers of its bodies.

Source: M. Walker, D. Orin, J. Dyn. Sys. Meas. Control 104 (1982); S. Singh, R. Russell, P. Wensing,
IEEE Robotics and Automation Letters 7 (2022).
"""

from __future__ import annotations

from collections.abc import Sequence

from ..arithmetic import Scalar
from ..graph import ZERO, Graph
from ..matrix import Matrix
from ..solve import solve
from .table import BODY, ETA_Q, LOAD, SPEED, WRENCH, ZETA_Q, BodyRow, S, Tree, chunks


def outboard_sums(tree: Tree, g: Graph, numbers: Sequence[int], count: int) -> list[list[int]]:
    """Numbers of every body with all bodies outboard of it."""
    sums = [list(numbers[b.numbers : b.numbers + count]) for b in tree.bodies]
    for i in range(len(sums) - 1, -1, -1):
        parent = tree.bodies[i].parent
        if parent >= 0:
            sums[parent] = [g.add(a, b) for a, b in zip(sums[parent], sums[i], strict=True)]
    return sums


def momentum_of(g: Graph, body: Sequence[int], s: Matrix) -> Matrix:
    """Moment and force (6, 1) that accelerate a body by s (6, 1)."""
    xx, xy, xz, yy, yz, zz = body[4:10]
    mass, moment = body[0], Matrix(g, 3, 1, body[1:4])
    tensor = Matrix(g, 3, 3, (xx, xy, xz, xy, yy, yz, xz, yz, zz))
    w, v = s.block(slice(0, 3)), s.block(slice(3, 6))
    force = v.map(lambda x: g.mul(mass, x)) + w.cross(moment)
    return Matrix.vstack(tensor @ w + moment.cross(v), force)


def column_at(g: Graph, numbers: Sequence[int], at: int, count: int = 6) -> Matrix:
    return Matrix(g, count, 1, numbers[at : at + count])


def speed_places(tree: Tree, body: int, speed: int) -> list[int]:
    """Places of the numbers of the speeds, of this size behind those of their body."""
    return [b.numbers + body + n * speed for b in tree.bodies for n in range(b.speeds)]


def mass_by_slots(
    g: Graph,
    tree: Tree,
    numbers: Sequence[int],
    sums: Sequence[Sequence[int]],
    columns: list[Matrix],
) -> Matrix:
    """M by slots."""
    n = len(tree.speeds)
    M = [ZERO] * (n * n)
    for body, total in zip(tree.bodies, sums, strict=True):
        for k in range(body.first, body.first + body.speeds):
            momentum = momentum_of(g, total, columns[k])
            for j in tree.inboard(k):
                a, b = tree.speeds[k].slot, tree.speeds[j].slot
                M[a * n + b] = M[b * n + a] = columns[j].dot(momentum).node
    for entry in tree.rotors:
        a, b = tree.speeds[entry.row].slot, tree.speeds[entry.column].slot
        M[a * n + b] = M[b * n + a] = g.add(M[a * n + b], numbers[entry.place])
    return Matrix(g, n, n, M)


class Slopes:
    """Derivatives of inverse and forward dynamics, entry by entry.

    Args:
        g: Where they go.
        numbers: Of the bodies.
        tree: The table.
    """

    def __init__(self, g: Graph, numbers: Sequence[int], tree: Tree) -> None:
        self.g, self.numbers, self.tree = g, numbers, tree
        self.at = speed_places(tree, BODY, SPEED)
        self.columns = [column_at(g, numbers, at + S) for at in self.at]
        self.sums = outboard_sums(tree, g, numbers, BODY)
        self.mass = mass_by_slots(g, tree, numbers, self.sums, self.columns)
        self.udot = self._udot()
        self.zeta: list[Matrix] = []
        self.wrenches: list[Matrix] = []
        self._accelerate()

    def _udot(self) -> list[int]:
        """Accelerations by the speeds of the tree."""
        g, speeds = self.g, self.tree.speeds
        if not self.tree.forward:
            return [g.var("udot", speed.slot) for speed in speeds]
        drive = [ZERO] * len(speeds)
        for body, total in zip(self.tree.bodies, self.sums, strict=True):
            wrench = Matrix(g, 6, 1, total[WRENCH:BODY])
            for k in range(body.first, body.first + body.speeds):
                force = g.add(g.var("tau", speeds[k].slot), self.numbers[self.at[k] + LOAD])
                drive[speeds[k].slot] = g.sub(force, self.columns[k].dot(wrench).node)
        udot = solve("spd", self.mass, Matrix(g, len(speeds), 1, drive))
        return [udot.nodes[speed.slot] for speed in speeds]

    def _accelerate(self) -> None:
        """What udot adds to accelerations, to zeta along q, to the forces that bodies take."""
        g, further, forces = self.g, list[Matrix](), list[Matrix]()
        for body in self.tree.bodies:
            before = further[body.parent] if body.parent >= 0 else Matrix.zeros(g, 6)
            here = before
            for k in range(body.first, body.first + body.speeds):
                zeta = column_at(g, self.numbers, self.at[k] + ZETA_Q)
                zeta = zeta + _cross_motion(before, self.columns[k])
                for j in range(body.speeds if body.modes >= 0 else 0):
                    change = self._change(body, j, k - body.first)
                    zeta = zeta + change * Scalar(g, self.udot[body.first + j])
                self.zeta.append(zeta)
                here = here + self.columns[k] * Scalar(g, self.udot[k])
            further.append(here)
            forces.append(momentum_of(g, self.numbers[body.numbers : body.numbers + 10], here))
        for i in range(len(forces) - 1, -1, -1):
            parent = self.tree.bodies[i].parent
            if parent >= 0:
                forces[parent] = forces[parent] + forces[i]
        self.wrenches = [
            Matrix(g, 6, 1, total[WRENCH:BODY]) + force
            for total, force in zip(self.sums, forces, strict=True)
        ]

    def _change(self, body: BodyRow, j: int, k: int) -> Matrix:
        """Change of column j of S of a body along its k-th q."""
        return column_at(self.g, self.numbers, body.modes + 6 * (j * body.speeds + k))

    def sides(self) -> Matrix:
        """Changes of forces less those of the inverse dynamics, by slots: along q, u, others."""
        g, tree = self.g, self.tree
        n = len(tree.speeds)
        half, width = chunks(n), tree.width
        entries = [ZERO] * (n * width)

        slots = [speed.slot for speed in tree.speeds]

        def put(row: int, column: int, node: int) -> None:
            entries[slots[row] * width + column] = g.neg(node)

        for i, body in enumerate(tree.bodies):
            flow = _Flow(g, self.sums[i])
            speeds = range(body.first, body.first + body.speeds)
            inboard = list(tree.inboard(body.first))[1:] if body.speeds else []
            for k in speeds:
                s = self.columns[k]
                eta = column_at(g, self.numbers, self.at[k] + ETA_Q, 3)
                zeta_u = column_at(g, self.numbers, self.at[k])
                along_q = momentum_of(g, self.sums[i], self.zeta[k]) + flow.force(eta)
                along_u = momentum_of(g, self.sums[i], zeta_u) + flow.force(s.block(slice(0, 3)))
                for j in speeds:
                    of_q = self.columns[j].dot(along_q)
                    if body.modes >= 0:
                        change = self._change(body, j - body.first, k - body.first)
                        of_q = of_q + change.dot(self.wrenches[i])
                    put(j, slots[k], of_q.node)
                    put(j, half + slots[k], self.columns[j].dot(along_u).node)
                moved = along_q + _cross_force(s, self.wrenches[i])
                momentum, along = momentum_of(g, self.sums[i], s), flow.along(s)
                for j in inboard:
                    put(j, slots[k], self.columns[j].dot(moved).node)
                    put(j, half + slots[k], self.columns[j].dot(along_u).node)
                    eta = column_at(g, self.numbers, self.at[j] + ETA_Q, 3)
                    put(k, slots[j], (along.dot(eta) + momentum.dot(self.zeta[j])).node)
                    zeta_u = column_at(g, self.numbers, self.at[j])
                    turn = self.columns[j].block(slice(0, 3))
                    put(k, half + slots[j], (momentum.dot(zeta_u) + along.dot(turn)).node)
        for entry in tree.changes:
            at = slots[entry.row] * width + entry.column
            entries[at] = g.add(entries[at], self.numbers[entry.place])
        return Matrix(g, n, width, entries)


class _Flow:
    """Twice the momentum and twice its flow, of a body with all bodies outboard of it."""

    def __init__(self, g: Graph, numbers: Sequence[int]) -> None:
        self.momentum = Matrix(g, 3, 1, numbers[10:13])
        k = Matrix(g, 3, 3, numbers[13:22])
        trace = (k[0, 0] + k[1, 1]) + k[2, 2]
        self.map = Matrix.identity(g, 3) * trace - k

    def force(self, eta: Matrix) -> Matrix:
        """Moment and force (6, 1) that a change of angular velocity asks for."""
        return Matrix.vstack(self.map @ eta, eta.cross(self.momentum))

    def along(self, s: Matrix) -> Matrix:
        """g (3, 1): the part of that along s (6, 1) is g . eta."""
        w, v = s.block(slice(0, 3)), s.block(slice(3, 6))
        return self.map.T @ w + self.momentum.cross(v)


def _cross_motion(a: Matrix, s: Matrix) -> Matrix:
    """A field of accelerations (6, 1), as what is displaced along s (6, 1) sees it change."""
    alpha, linear = a.block(slice(0, 3)), a.block(slice(3, 6))
    w, v = s.block(slice(0, 3)), s.block(slice(3, 6))
    return Matrix.vstack(alpha.cross(w), linear.cross(w) + alpha.cross(v))


def _cross_force(s: Matrix, wrench: Matrix) -> Matrix:
    """Change of moment and force (6, 1) that move along s (6, 1)."""
    w, v = s.block(slice(0, 3)), s.block(slice(3, 6))
    moment, force = wrench.block(slice(0, 3)), wrench.block(slice(3, 6))
    return Matrix.vstack(w.cross(moment) + v.cross(force), w.cross(force))


def derivative_expressions(g: Graph, numbers: Sequence[int], tree: Tree) -> list[int]:
    slopes, n = Slopes(g, numbers, tree), len(tree.speeds)
    sides, of_mass = slopes.sides(), slopes.mass
    if tree.forward:
        both = Matrix.hstack(sides, Matrix.identity(g, n))
        both = solve("spd", slopes.mass, both)
        sides = both.block(slice(None), slice(0, sides.columns))
        of_mass = both.block(slice(None), slice(sides.columns, both.columns))
    else:
        sides = -sides
    nodes: list[int] = []
    for row in tree.outputs:
        source = of_mass if row.of_mass else sides
        first = 0 if row.of_mass else row.first
        nodes += source.block(slice(None), slice(first, first + row.columns)).nodes
    return nodes
