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
from scipy.linalg import block_diag

from ...ir.arithmetic import Scalar, cos, sin
from ...ir.function import Block, Function, Output
from ...ir.graph import ONE, ZERO, Graph
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...spatial.exponential import multiply
from ...spatial.plane import Plane
from ...spatial.rotations.quaternion import Quaternion
from .record import BlockKind, Kind

FLAT = "plane_node"
NAMES, UNITS = ("x", "y", "angle"), ("m", "m", "rad")
SPEEDS = ("m/s", "m/s", "rad/s")
RATES = ("u", "udot", "du")
# results along speeds, and along rows of constraints
MATRICES, ROWS = ("K", "C", "M", "R", "G"), ("g", "rates", "gamma")


def plane_node(plane: Plane, number: int) -> BlockKind:
    """What a node of a plane holds."""
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
        functions={
            key: function
            for key, function in functions.items()
            if key == "outputs" or any(node != ZERO for node in function.roots)
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
        told = self.function("G", tangent, always=True)
        nodes = next(o.nodes for o in told.outputs if o.name == "G")
        nu = sum(block.nu for block in self.blocks)
        count = range(self.kind.m)
        return tuple(i for i in count if any(nodes[i * nu : (i + 1) * nu]))

    def function(self, name: str, f: Function, always: bool = False) -> Function:
        """One of them; ``always`` with matrices that are zero."""
        target = Graph()
        target.tables = f.graph.tables.copy()
        roots = rebuild(f.graph, f.roots, self._told(f.graph, target), into=target)[1]
        outputs, at = list[Output](), 0
        for output in f.outputs:
            own = self._output(target, output, roots[at : at + len(output.nodes)])
            at += len(output.nodes)
            if always or output.name not in MATRICES or any(node != ZERO for node in own.nodes):
                outputs.append(own)
        inputs = tuple(self._block(block) for block in f.inputs)
        return Function(name, target, inputs, tuple(outputs), f.owners, f.about)

    def _told(self, graph: Graph, target: Graph) -> dict[int, int]:
        """Coordinates, speeds and multipliers in space, and rotations, as they are here."""
        told = dict[int, int]()
        q = u = first = own_u = 0
        for space, own in zip(self.kind.blocks, self.blocks, strict=True):
            if own.plane is None:
                for k in range(space.nq):
                    told[graph.var("q", q + k)] = target.var("q", first + k)
                for letter, k in ((x, k) for x in RATES for k in range(space.nu)):
                    told[graph.var(letter, u + k)] = target.var(letter, own_u + k)
            else:
                told |= _pose(own.plane, graph, q, target, first)
                E = Matrix.of(target, own.plane.spread.tolist())
                for letter in RATES:
                    rates = Matrix(target, 3, 1, [target.var(letter, own_u + k) for k in range(3)])
                    moved = zip(range(6), (E @ rates).nodes, strict=True)
                    told |= {graph.var(letter, u + k): node for k, node in moved}
            q, u = q + space.nq, u + space.nu
            first, own_u = first + own.nq, own_u + own.nu
        rows = {row: k for k, row in enumerate(self.rows)}
        for row in range(self.kind.m):
            told[graph.var("lam", row)] = target.var("lam", rows[row]) if row in rows else ZERO
        return told

    def _block(self, block: Block) -> Block:
        """An input block with what is left."""
        if block.name == "lam":
            entries = tuple(block.entries[row] for row in self.rows)
            return Block("lam", entries, tuple(block.units[row] for row in self.rows))
        if block.name not in ("q", *RATES) or not block.entries:
            return block
        entries_of, units_of, at = list[str](), list[str](), 0
        for space, own in zip(self.kind.blocks, self.blocks, strict=True):
            count = space.nq if block.name == "q" else space.nu
            entries, units = block.entries[at : at + count], block.units[at : at + count]
            if own.plane is not None:
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
            column = self._spread(graph).T @ Matrix(graph, len(nodes), 1, nodes)
            return Output("balance", (column.rows,), column.nodes)
        if output.name in ROWS:
            picked = tuple(nodes[row] for row in self.rows if row < len(nodes))
            return Output(output.name, (len(picked),), picked)
        if output.name in MATRICES:
            rows, columns = output.shape
            found = Matrix(graph, rows, columns, nodes) @ self._spread(graph)
            if output.name in "KCM":
                found = self._spread(graph).T @ found
            else:
                at = [row * found.columns for row in self.rows]
                left = [node for i in at for node in found.nodes[i : i + found.columns]]
                found = Matrix(graph, len(self.rows), found.columns, left)
            return Output(output.name, (found.rows, found.columns), found.nodes)
        return Output(output.name, output.shape, tuple(nodes), output.entries, output.units)

    def _spread(self, graph: Graph) -> Matrix:
        """Speeds in space from those that are left, (nu, nu here)."""
        return Matrix.of(graph, self.spread.tolist())

    @cached_property
    def spread(self) -> Any:
        """The same as numbers."""
        parts = zip(self.kind.blocks, self.blocks, strict=True)
        return block_diag(
            *(np.eye(space.nu) if own.plane is None else own.plane.spread for space, own in parts)
        )


def _pose(plane: Plane, graph: Graph, q: int, target: Graph, first: int) -> dict[int, int]:
    """Pose of a node in space, with its rotation as it stands, by x, y and angle."""
    x, y, angle = (Scalar(target, target.var("q", first + k)) for k in range(3))
    position = Matrix.zeros(target, 3) + Matrix.of(
        target, plane.spread[3:, :2].tolist()
    ) @ Matrix.vector(target, [x, y])
    s, c = sin(angle), cos(angle)
    a, b = plane.along
    turn = [[ONE if i == j else ZERO for j in range(3)] for i in range(3)]
    turn[a][a] = turn[b][b] = c.node
    turn[a][b], turn[b][a] = (-s).node, s.node
    turned = Matrix(target, 3, 3, [node for row in turn for node in row])
    rotation = turned @ Matrix.of(target, plane.rotation.tolist())
    # the quaternion at angle 0, turned
    home = Matrix.vector(target, plane.home.tolist())
    axis = [sin(angle * 0.5) if k == plane.normal else 0.0 for k in range(3)]
    quaternion = multiply(Matrix.vector(target, [cos(angle * 0.5), *axis]), home)
    own = Matrix(graph, 4, 1, [graph.var("q", q + k) for k in range(4)])
    told = dict(zip(Quaternion().matrix(own).nodes, rotation.nodes, strict=True))
    told |= dict(zip(own.nodes, quaternion.nodes, strict=True))
    places = [graph.var("q", q + 4 + k) for k in range(3)]
    return told | dict(zip(places, position.nodes, strict=True))
