"""Kinds of elements whose nodes stay in a plane, made of those in space.

Poses of nodes are told by x, y, angle; speeds follow by a constant matrix, so that balance and
tangents are those in space, told along the speeds that are left. Rows of constraints that nothing
in the plane moves are left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from ...ir.arithmetic import Scalar, cos, sin
from ...ir.function import Block, Function, Output
from ...ir.graph import ONE, ZERO, Graph
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...spatial.exponential import multiply
from ...spatial.plane import Plane
from ...spatial.rotations.quaternion import Quaternion
from .record import ALWAYS, BlockKind, Kind

FLAT = "plane_node"
NAMES, UNITS = ("x", "y", "angle"), ("m", "m", "rad")
SPEEDS = ("m/s", "m/s", "rad/s")
RATES = ("u", "udot", "du")
# results along speeds, and along rows of constraints
MATRICES, ROWS = ("K", "C", "M", "R", "G", "L"), ("g", "rates", "gamma")


def plane_node(plane: Plane, number: int) -> BlockKind:
    """Block kind of a planar node."""
    return BlockKind(
        name=FLAT if not number else f"{FLAT}_{number + 1}",
        coordinates=NAMES,
        speeds=NAMES,
        q_units=UNITS,
        u_units=SPEEDS,
        defaults=(0.0, 0.0, 0.0),
        plane=plane,
    )


def flattened(name: str, kind: Kind, blocks: Sequence[BlockKind]) -> Kind:
    """A kind of element with nodes in a plane.

    Args:
        name: Of the new kind.
        kind: In space.
        blocks: What its places hold; those that are nodes there may be nodes of a plane here.
    """
    flat = Flat(kind, blocks)
    functions = {key: flat.function(f"{name}__{key}", f) for key, f in kind.functions.items()}
    return replace(
        kind,
        name=name,
        blocks=tuple(blocks),
        rows=tuple(kind.rows[i] for i in flat.rows),
        mp=sum(i < kind.mp for i in flat.rows),
        switched=sum(i >= kind.m - kind.switched for i in flat.rows),
        functions={
            key: function
            for key, function in functions.items()
            if key in ALWAYS or any(node != ZERO for node in function.roots)
        },
    )


class Flat:
    """Tells the functions of one kind anew.

    Attributes:
        rows: Rows of constraints in space that motion in the plane changes.
    """

    def __init__(self, kind: Kind, blocks: Sequence[BlockKind]) -> None:
        self.kind, self.blocks = kind, blocks
        self.rows: tuple[int, ...] = tuple(range(kind.m))
        if kind.m:
            self.rows = self._moved(kind.functions["balance_tangent"])

    def _moved(self, tangent: Function) -> tuple[int, ...]:
        """Rows of G that are not zero."""
        jacobian = self.function("G", tangent, always=True)
        nodes = next(o.nodes for o in jacobian.outputs if o.name == "G")
        nu = sum(block.nu for block in self.blocks)
        count = range(self.kind.m)
        return tuple(i for i in count if any(nodes[i * nu : (i + 1) * nu]))

    def function(self, name: str, f: Function, always: bool = False) -> Function:
        """One of them; ``always`` with matrices that are zero."""
        target = Graph()
        target.tables = f.graph.tables.copy()
        roots = rebuild(f.graph, f.roots, self._replacements(f.graph, target), into=target)[1]
        outputs, at = list[Output](), 0
        for output in f.outputs:
            planar_output = self._output(target, output, roots[at : at + len(output.nodes)])
            at += len(output.nodes)
            if (
                always
                or output.name not in MATRICES
                or any(node != ZERO for node in planar_output.nodes)
            ):
                outputs.append(planar_output)
        inputs = tuple(self._block(block) for block in f.inputs)
        return Function(name, target, inputs, tuple(outputs), f.owners, f.about)

    def _replacements(self, graph: Graph, target: Graph) -> dict[int, int]:
        """Coordinates, speeds and multipliers in space, and rotations, as they are here."""
        replacements = dict[int, int]()
        q = u = first = planar_u = 0
        for space, planar in zip(self.kind.blocks, self.blocks, strict=True):
            if planar.plane is None:
                for k in range(space.nq):
                    replacements[graph.var("q", q + k)] = target.var("q", first + k)
                for letter, k in ((x, k) for x in RATES for k in range(space.nu)):
                    replacements[graph.var(letter, u + k)] = target.var(letter, planar_u + k)
            else:
                replacements |= _pose(planar.plane, graph, q, target, first)
                E = Matrix.of(target, planar.plane.to_space.tolist())
                for letter in RATES:
                    rates = Matrix(
                        target, 3, 1, [target.var(letter, planar_u + k) for k in range(3)]
                    )
                    moved = zip(range(6), (E @ rates).nodes, strict=True)
                    replacements |= {graph.var(letter, u + k): node for k, node in moved}
            q, u = q + space.nq, u + space.nu
            first, planar_u = first + planar.nq, planar_u + planar.nu
        rows = {row: k for k, row in enumerate(self.rows)}
        for row in range(self.kind.m):
            replacements[graph.var("lam", row)] = (
                target.var("lam", rows[row]) if row in rows else ZERO
            )
        return replacements

    def _block(self, block: Block) -> Block:
        """An input block with what is left."""
        if block.name == "lam":
            entries = tuple(block.entries[row] for row in self.rows)
            return Block("lam", entries, tuple(block.units[row] for row in self.rows))
        if block.name not in ("q", *RATES) or not block.entries:
            return block
        entries_of, units_of, at = list[str](), list[str](), 0
        for space, planar in zip(self.kind.blocks, self.blocks, strict=True):
            count = space.nq if block.name == "q" else space.nu
            entries, units = block.entries[at : at + count], block.units[at : at + count]
            if planar.plane is not None:
                owner = entries[0].rpartition(".")[0]
                entries = tuple(f"{owner}.{entry}" for entry in NAMES)
                units = (units[-1], units[-1], units[-1].replace("m", "rad", 1))
            entries_of += entries
            units_of += units
            at += count
        return Block(block.name, tuple(entries_of), tuple(units_of))

    def _output(self, graph: Graph, output: Output, nodes: Sequence[int]) -> Output:
        """A result along what is left."""
        if output.name == "balance":
            column = self._to_space(graph).T @ Matrix(graph, len(nodes), 1, nodes)
            return Output("balance", (column.rows,), column.nodes)
        if output.name in ROWS:
            picked = tuple(nodes[row] for row in self.rows if row < len(nodes))
            return Output(output.name, (len(picked),), picked)
        if output.name == "H":
            at = [row * output.shape[1] + column for row in self.rows for column in self.rows]
            return Output("H", (len(self.rows),) * 2, tuple(nodes[i] for i in at))
        if output.name in ("J", "along"):
            reduced = Matrix(graph, output.shape[0], output.shape[1], nodes)
            reduced = reduced @ self._to_space(graph)
            return Output(output.name, (reduced.rows, reduced.columns), reduced.nodes)
        if output.name == "normal":
            count, _, m = output.shape
            picked = tuple(nodes[i * m + row] for i in range(3 * count) for row in self.rows)
            return Output("normal", (count, 3, len(self.rows)), picked)
        if output.name in MATRICES:
            rows, columns = output.shape
            reduced = Matrix(graph, rows, columns, nodes) @ self._to_space(graph)
            if output.name in "KCM":
                reduced = self._to_space(graph).T @ reduced
            else:
                at = [row * reduced.columns for row in self.rows]
                left = [node for i in at for node in reduced.nodes[i : i + reduced.columns]]
                reduced = Matrix(graph, len(self.rows), reduced.columns, left)
            return Output(output.name, (reduced.rows, reduced.columns), reduced.nodes)
        return Output(output.name, output.shape, tuple(nodes), output.entries, output.units)

    def _to_space(self, graph: Graph) -> Matrix:
        """Speeds in space from those that are left, (nu, nu here)."""
        return Matrix.of(graph, self.to_space.tolist())

    @cached_property
    def to_space(self) -> Any:
        """The same as numbers."""
        from scipy.linalg import block_diag

        parts = zip(self.kind.blocks, self.blocks, strict=True)
        return block_diag(
            *(
                np.eye(space.nu) if planar.plane is None else planar.plane.to_space
                for space, planar in parts
            )
        )


def _pose(plane: Plane, graph: Graph, q: int, target: Graph, first: int) -> dict[int, int]:
    """Pose of a node in space, with its rotation as it stands, by x, y and angle."""
    x, y, angle = (Scalar(target, target.var("q", first + k)) for k in range(3))
    position = Matrix.zeros(target, 3) + Matrix.of(
        target, plane.to_space[3:, :2].tolist()
    ) @ Matrix.vector(target, [x, y])
    s, c = sin(angle), cos(angle)
    a, b = plane.along
    turn = [[ONE if i == j else ZERO for j in range(3)] for i in range(3)]
    turn[a][a] = turn[b][b] = c.node
    turn[a][b], turn[b][a] = (-s).node, s.node
    rotated = Matrix(target, 3, 3, [node for row in turn for node in row])
    rotation = rotated @ Matrix.of(target, plane.rotation.tolist())
    # the quaternion at angle 0, turned
    home = Matrix.vector(target, plane.home.tolist())
    axis = [sin(angle * 0.5) if k == plane.normal else 0.0 for k in range(3)]
    quaternion = multiply(Matrix.vector(target, [cos(angle * 0.5), *axis]), home)
    quaternion_nodes = Matrix(graph, 4, 1, [graph.var("q", q + k) for k in range(4)])
    replacements = dict(
        zip(Quaternion().matrix(quaternion_nodes).nodes, rotation.nodes, strict=True)
    )
    replacements |= dict(zip(quaternion_nodes.nodes, quaternion.nodes, strict=True))
    places = [graph.var("q", q + 4 + k) for k in range(3)]
    return replacements | dict(zip(places, position.nodes, strict=True))
