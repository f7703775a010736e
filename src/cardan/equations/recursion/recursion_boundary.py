"""Values that bodies hand to each other: where a recursion can be cut into steps.

A formalism says which values it hands on; straight-line derivation goes on with the expressions
themselves. Where steps are wanted, a leaf of the block ``store`` takes the place of each handed
value, so that the expressions of one body end at those of its neighbors.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from typing import TYPE_CHECKING, TypeAlias

from ...ir.function import live, operands
from ...ir.graph import ZERO, Graph
from ...ir.matrix import Matrix
from ...ir.ops import LEAVES
from ...ir.recursion import STORE
from ...records import dataclass
from .common_forms import Form, Forms

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
        summed: Whether it is a sum, to which nobody may add here.
        common: Whether bodies of all kinds hand it on.
    """

    body: int
    field: tuple[str, int]
    size: int
    node: int
    added: tuple[tuple[int, int], ...] = ()
    summed: bool = False
    common: bool = False


class Cuts:
    """The handed values of one derivation.

    Args:
        graph: Where they live.
        every: Whether every entry becomes a leaf and is stored, numbers and what nobody reads too:
            so bodies next to the ground and at the tips do what all others do.
        forms: Forms in which bodies of all kinds hand on what others read, where few bodies stand
            for many.
        bodies: Those whose values become leaves, all by default.

    Attributes:
        definitions: Leaf of the store -> what it stands for.
    """

    def __init__(
        self,
        graph: Graph,
        every: bool = False,
        forms: Forms | None = None,
        bodies: Collection[int] | None = None,
    ) -> None:
        self.graph, self.every, self.forms, self.bodies = graph, every, forms, bodies
        self.definitions: dict[int, Definition] = {}
        self._leaves: dict[tuple[int, int], int] = {}
        self._times: dict[tuple[int, str], int] = {}
        self._fixed: dict[int, bool] = {}

    def cut(self, body: int, quantity: str, nodes: Sequence[int]) -> list[int]:
        """Leaves for the entries of a value; numbers, inputs and parameters stay what they are."""
        if self.bodies is not None and body not in self.bodies:
            return list(nodes)
        size, quantity = len(nodes), self._name(body, quantity)
        if self.every:
            return [
                self._leaf(Definition(body, (quantity, k), size, node))
                for k, node in enumerate(nodes)
            ]
        if self.forms is not None and self.forms.common(body, quantity):
            form = self.forms.form(self.graph, quantity, nodes)
            if form is not None:
                return self._in_form(body, quantity, form, nodes)
        return [self._cut(body, (quantity, k), size, node) for k, node in enumerate(nodes)]

    def _name(self, body: int, quantity: str) -> str:
        """Name of a quantity of a body: two of one name have places each."""
        number = self._times[body, quantity] = self._times.get((body, quantity), 0) + 1
        return quantity if number == 1 else f"{quantity}_{number}"

    def _in_form(
        self,
        body: int,
        quantity: str,
        form: Form,
        nodes: Sequence[int],
        added: Sequence[tuple[int, Sequence[int]]] | None = None,
    ) -> list[int]:
        """Leaves for the entries that are leaves of bodies of all kinds."""
        result: list[int] = []
        for k, entry in enumerate(form):
            if entry.value is not None:
                result.append(nodes[k])
                continue
            leaf = result[entry.source] if entry.source < k else -1
            if leaf < 0:
                parts = [(by, part[k]) for by, part in added or () if part[k] != ZERO]
                node, *terms = self._signed(entry.sign, [nodes[k], *(term for _, term in parts)])
                terms_added = tuple((by, term) for (by, _), term in zip(parts, terms, strict=True))
                field, summed = (quantity, k), added is not None
                definition = Definition(body, field, len(nodes), node, terms_added, summed, True)
                leaf = self._leaf(definition)
            result += self._signed(entry.sign, [leaf])
        return result

    def _signed(self, sign: int, nodes: Sequence[int]) -> list[int]:
        return [self.graph.neg(node) if sign < 0 else node for node in nodes]

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
        quantity = self._name(body, quantity)
        if self.forms is not None and self.forms.formed[body]:
            terms = (body_nodes, *(nodes for _, nodes in added))
            form = self.forms.form_of_sum(self.graph, quantity, terms)
            if form is not None:
                return self._in_form(body, quantity, form, body_nodes, added)
        leaves: dict[tuple[int, ...], int] = {}
        result = []
        for k, node in enumerate(body_nodes):
            parts = tuple((by, nodes[k]) for by, nodes in added if nodes[k] != ZERO)
            key = (node, *(part for _, part in parts))
            # both triangles of a symmetric matrix are one value
            if key not in leaves:
                field = (quantity, k)
                leaves[key] = (
                    self._leaf(Definition(body, field, len(body_nodes), node, parts, summed=True))
                    if parts
                    else self._cut(body, field, len(body_nodes), node)
                )
            result.append(leaves[key])
        return result

    def _leaf(self, definition: Definition) -> int:
        leaf = self.graph.var(STORE, len(self.definitions))
        self.definitions[leaf] = definition
        return leaf

    def read_elsewhere(self, results: Iterable[tuple[int, int]]) -> frozenset[str]:
        """Names of the quantities of a body that others read, for results of (body, node) too."""
        definitions, names = self.definitions, set[str]()
        handed = ((d.body, d.node) for d in definitions.values())
        added = (part for d in definitions.values() for part in d.added)
        for body, node in (*results, *handed, *added):
            for i in live(self.graph, [node]):
                owner = definitions.get(i)
                if owner is not None and owner.body != body:
                    names.add(owner.field[0])
        return frozenset(names)

    def fixed(self, node: int) -> bool:
        """True when a node depends on parameters and numbers alone."""
        nodes, fixed, waiting = self.graph.nodes, self._fixed, [node]
        while waiting:
            i = waiting[-1]
            entry = nodes[i]
            if entry[0] in LEAVES:
                fixed[i] = entry[0] == "const" or (entry[0] == "var" and entry[1] == "p")
            elif i not in fixed:
                read = operands(entry)
                unknown = [k for k in read if k not in fixed]
                if unknown:
                    waiting += unknown
                    continue
                fixed[i] = all(fixed[k] for k in read)
            waiting.pop()
        return fixed[node]


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
