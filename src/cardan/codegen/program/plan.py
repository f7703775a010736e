"""Decide which nodes of an expression graph get a name, and which are written where they are read.

A node becomes a statement of its own where several others read it, where someone labeled it, or
where its line would become too long. Everything else stays inside the expression that reads it.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from ...errors import CodegenError
from ...ir.graph import Graph, Node
from ...ir.ops import LEAVES, OPERATORS
from ...ir.owners import Owner
from ...records import dataclass
from .naming import ValueNames
from .values import Values

# the widest expression, with its name: a line of 100 columns and most of a second one
WIDEST = 320
# the least width that can be too much; "_12" behind a name that is not unique
NARROW, NUMBER = 260, 3

INFIX = frozenset({"add", "sub", "mul", "div"})
SEPARATE = frozenset({"sin", "cos", "solve", "item"})
# what stands around the operands of an operator
GLUE = {
    name: 3 if name in INFIX else len(operator.c) - 3 * operator.arity
    for name, operator in OPERATORS.items()
}


@dataclass(frozen=True)
class Plan:
    """The statements of a routine.

    Attributes:
        graph: Where the nodes live.
        order: Nodes that are computed or read, operands first.
        reads: Node that is a statement -> the statements and outside values it reads.
        owners: Node that is a statement -> whose it is.
        direct: Statements whose only reader is a result: they need no name.
        outside: What is read but not computed here: input entries and given nodes.
    """

    graph: Graph
    order: list[int]
    reads: dict[int, tuple[int, ...]]
    owners: dict[int, Owner]
    direct: frozenset[int]
    outside: frozenset[int]


def make_plan(
    graph: Graph,
    order: Sequence[int],
    roots: Sequence[int],
    external: Collection[int],
    values: Values,
) -> Plan:
    """Decide which nodes become statements.

    Args:
        graph: Where the nodes live.
        order: All nodes, operands first.
        roots: Results, once per place where they are wanted.
        external: Nodes that are read from outside instead of being computed.
        values: Names and owners of the nodes.

    Raises:
        CodegenError: a placeholder was left in the graph.
    """
    ordered, uses = _needed(graph, order, roots, external)
    outside = frozenset([i for i in ordered if graph.nodes[i][0] == "var" or i in external])
    planner = _Planner(graph, uses, frozenset(roots), values.namer)
    planner.plan(ordered, outside, values.names)
    reads = {i: planner.reads[i] for i in ordered if i in planner.reads}
    direct = frozenset(
        i for i in roots if i in reads and uses[i] == 1 and graph.nodes[i][0] != "item"
    )
    return Plan(graph, ordered, reads, {i: values.owners.of(i) for i in reads}, direct, outside)


def _needed(
    graph: Graph, order: Sequence[int], roots: Sequence[int], external: Collection[int]
) -> tuple[list[int], list[int]]:
    """Nodes to compute or read for the roots, and how often each node of the graph is read."""
    nodes, leaves = graph.nodes, LEAVES
    uses = [0] * len(nodes)
    for i in roots:
        uses[i] += 1
    ordered = []
    for i in reversed(order):
        if not uses[i]:
            continue
        ordered.append(i)
        node = nodes[i]
        op = node[0]
        if op in leaves or i in external:
            continue
        for k in node[4:] if op == "solve" else node[1:2] if op == "item" else node[1:]:
            uses[k] += 1
    ordered.reverse()
    return ordered, uses


class _Planner:
    """One pass over the nodes; ``sees`` is what an expression that contains a node reads."""

    def __init__(
        self, graph: Graph, uses: list[int], roots: frozenset[int], namer: ValueNames
    ) -> None:
        self.namer = namer
        self.graph = graph
        self.uses = uses
        self.roots = roots
        self.width = [0] * len(graph)
        self.sees: list[tuple[int, ...]] = [()] * len(graph)
        self.reads: dict[int, tuple[int, ...]] = {}

    def plan(self, order: list[int], outside: frozenset[int], names: Mapping[int, str]) -> None:
        nodes, uses, width, sees = self.graph.nodes, self.uses, self.width, self.sees
        # what is labeled or wanted is a statement in any case, and entries of linear systems
        systems = [k for i in order if nodes[i][0] == "solve" for k in nodes[i][4:]]
        roots_mask = bytearray(len(nodes))
        for i in (*self.graph.labels, *self.roots, *systems):
            roots_mask[i] = 1
        for i in order:
            node = nodes[i]
            op = node[0]
            if i in outside:
                width[i], sees[i] = len(names[i]), (i,)
                continue
            if op in INFIX:
                a, b = node[1], node[2]
                total, visible = width[a] + width[b] + 3, sees[a] + sees[b]
            elif op == "const":
                width[i] = len(repr(node[1]))
                continue
            elif op == "atom":
                raise CodegenError(f"placeholder '{node[1]}' was not resolved")
            else:
                read = node[4:] if op == "solve" else node[1:2] if op == "item" else node[1:]
                total = GLUE.get(op, 0) + sum([width[k] for k in read])
                visible = tuple([k for j in read for k in sees[j]])
            if total > NARROW and op not in SEPARATE:
                total, visible = self._shorten(i, node, total, visible)
            # a changed sign of something with a name needs no name
            often = uses[i] > 1 and not (op == "neg" and sees[node[1]] == node[1:])
            if often or roots_mask[i] or op in SEPARATE:
                self._state(i, visible)
            else:
                width[i], sees[i] = total, visible

    def _state(self, i: int, visible: tuple[int, ...]) -> None:
        """Node i becomes a statement."""
        self.reads[i] = visible
        self.sees[i] = (i,)
        self.width[i] = self._name_width(i)

    def _name_width(self, i: int) -> int:
        return len(self.namer.of(i)) + NUMBER

    def _shorten(
        self, i: int, node: Node, total: int, visible: tuple[int, ...]
    ) -> tuple[int, tuple[int, ...]]:
        """Operands become statements, the widest first, while the expression is too wide."""
        width, sees = self.width, self.sees
        limit = WIDEST - self._name_width(i)
        if total <= limit:
            return total, visible
        read: tuple[int, ...] = node[1:]
        while total > limit:
            inner = [k for k in read if sees[k] and sees[k] != (k,)]
            if not inner:
                break
            widest = max(inner, key=lambda k: width[k])
            total -= width[widest]
            self._state(widest, sees[widest])
            total += width[widest]
        return total, tuple([k for j in read for k in sees[j]])
