"""Values that bodies hand to each other: where a recursion can be cut into steps.

A formalism says which values it hands on; straight-line derivation goes on with the expressions
themselves. Where steps are wanted, a leaf of the block ``store`` takes the place of each handed
value, so that the expressions of one body end at those of its neighbors.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, TypeAlias

from ...ir.graph import ZERO, Graph
from ...ir.matrix import Matrix
from ...ir.ops import LEAVES
from ...ir.recursion import STORE
from ...records import dataclass

if TYPE_CHECKING:
    from ..kinematics.kinematics import Kinematics


Parts: TypeAlias = tuple[Matrix, ...]

XYZ = ("x", "y", "z")
# components of a matrix, row by row
CELLS = tuple(i + j for i in XYZ for j in XYZ)


@dataclass(frozen=True)
class Definition:
    """Meaning of a leaf of the store.

    Attributes:
        body: Whose value it is.
        field: (quantity, component).
        size: Number of components of the quantity.
        node: Its expression; of a sum, the body's own part.
        added: Of a sum: (body, node) that others add.
    """

    body: int
    field: tuple[str, int]
    size: int
    node: int
    added: tuple[tuple[int, int], ...] = ()


class Cuts:
    """The handed values of one derivation.

    Args:
        graph: Where they live.
        every: Whether every entry becomes a leaf and is stored, numbers and what nobody reads too:
            so bodies next to the ground and at the tips do what all others do.

    Attributes:
        definitions: Leaf of the store -> what it stands for.
    """

    def __init__(self, graph: Graph, every: bool = False) -> None:
        self.graph, self.every = graph, every
        self.definitions: dict[int, Definition] = {}
        self._leaves: dict[tuple[int, int], int] = {}
        self._fields: set[tuple[int, tuple[str, int]]] = set()
        self._fixed = bytearray()

    def cut(self, body: int, quantity: str, nodes: Sequence[int]) -> list[int]:
        """Leaves for the entries of a value; numbers, inputs and parameters stay what they are."""
        size = len(nodes)
        if self.every:
            return [
                self._leaf(Definition(body, (quantity, k), size, node))
                for k, node in enumerate(nodes)
            ]
        return [self._cut(body, (quantity, k), size, node) for k, node in enumerate(nodes)]

    def _cut(self, body: int, field: tuple[str, int], size: int, node: int) -> int:
        entry = self.graph.nodes[node]
        if entry[0] == "neg":
            return self.graph.neg(self._cut(body, field, size, entry[1]))
        if entry[0] in LEAVES or self.fixed(node):
            return node
        key = (body, node)
        if key not in self._leaves:
            self._leaves[key] = self._leaf(Definition(body, field, size, node))
        return self._leaves[key]

    def total(
        self,
        body: int,
        quantity: str,
        body_nodes: Sequence[int],
        added: Sequence[tuple[int, Sequence[int]]],
    ) -> list[int]:
        """Leaves for sums of what a body has itself and what others add, entry by entry."""
        leaves: dict[tuple[int, ...], int] = {}
        result = []
        for k, node in enumerate(body_nodes):
            parts = tuple((by, nodes[k]) for by, nodes in added if nodes[k] != ZERO)
            key = (node, *(part for _, part in parts))
            # both triangles of a symmetric matrix are one value
            if key not in leaves:
                field = (quantity, k)
                leaves[key] = (
                    self._leaf(Definition(body, field, len(body_nodes), node, parts))
                    if parts
                    else self._cut(body, field, len(body_nodes), node)
                )
            result.append(leaves[key])
        return result

    def _leaf(self, definition: Definition) -> int:
        # two values of one name have a place each
        (quantity, k), number = definition.field, 2
        while (definition.body, definition.field) in self._fields:
            definition = replace(definition, field=(f"{quantity}_{number}", k))
            number += 1
        self._fields.add((definition.body, definition.field))
        leaf = self.graph.var(STORE, len(self.definitions))
        self.definitions[leaf] = definition
        return leaf

    def fixed(self, node: int) -> bool:
        """True when a node depends on parameters and numbers alone."""
        nodes, fixed = self.graph.nodes, self._fixed
        for i in range(len(fixed), node + 1):
            entry = nodes[i]
            op = entry[0]
            if op in LEAVES:
                fixed.append(op == "const" or (op == "var" and entry[1] == "p"))
            elif op == "item" or len(entry) == 2:
                fixed.append(fixed[entry[1]])
            elif len(entry) == 3:
                # most nodes by far
                fixed.append(fixed[entry[1]] and fixed[entry[2]])
            else:
                read = entry[4:] if op == "solve" else entry[1:]
                fixed.append(all(fixed[k] for k in read))
        return bool(fixed[node])


def summed(k: Kinematics, quantity: str, parts: Sequence[Matrix]) -> Matrix:
    """The sum of a part of every body; as a recursion each adds its own to a value of the first.

    Args:
        k: Motion of the tree.
        quantity: Name of the sum.
        parts: Of every body, all of one shape.
    """
    first, *more = parts
    if k.cuts is None:
        return sum(more, start=first)
    added = [(by, part.nodes) for by, part in enumerate(more, 1)]
    nodes = k.cuts.total(0, quantity, first.nodes, added)
    return Matrix(k.graph, first.rows, first.columns, nodes)


class Sums:
    """Sums over every body and the bodies that transmit something to it.

    All is added before it is read.

    Args:
        k: Motion of the tree.
        quantities: Names of the matrices that are added up.
        own: The body's own parts.
    """

    def __init__(
        self, k: Kinematics, quantities: Sequence[str], body_parts: Sequence[Parts]
    ) -> None:
        self._k = k
        self._quantities = quantities
        self._body_parts = body_parts
        self._added: list[list[tuple[int, Parts]]] = [[] for _ in body_parts]

    def add(self, body: int, by: int, parts: Parts) -> None:
        """Body ``by`` hands its part to another one."""
        self._added[body].append((by, parts))

    def __getitem__(self, body: int) -> Parts:
        rows = zip(self._quantities, self._body_parts[body], strict=True)
        return tuple(self._sum(body, n, *row) for n, row in enumerate(rows))

    def _sum(self, body: int, n: int, quantity: str, body_part: Matrix) -> Matrix:
        k, added = self._k, [(by, parts[n]) for by, parts in self._added[body]]
        if k.cuts is None:
            with k.graph.made_by(k.owner(body), quantity):
                return sum((x for _, x in added), start=body_part)
        nodes = k.cuts.total(body, quantity, body_part.nodes, [(by, x.nodes) for by, x in added])
        return Matrix(k.graph, body_part.rows, body_part.columns, nodes)
