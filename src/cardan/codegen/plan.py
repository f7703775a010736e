"""What of an expression graph gets a name, and what is written out where it is read.

A node becomes a statement of its own where several others read it, where someone labeled it, or
where its line would become too long. Everything else stays inside the expression that reads it.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from ..errors import CodegenError
from ..ir.graph import Graph
from ..ir.ops import LEAVES, OPERATORS
from .naming import mangle

COLUMNS = 100
# "    const real " + " = " + ";" around a name and its expression
FRAME = 19
# the least width that can make a line too long, and what a number behind a name takes
SHORT, NUMBER = 36, 3
SHARED = "shared"

# what stands around the operands of an operator
GLUE = {
    name: 3 if op.arity == 2 and "(" not in op.c else len(op.c.replace(" ", "")) - 3 * op.arity + 2
    for name, op in OPERATORS.items()
}


class Owner(NamedTuple):
    """Whose a value is: the section it stands in, and the words of its name."""

    section: str
    name: str
    quantity: str


class Owners:
    """Who a node belongs to: its label, else the first of its owners in graph numbering."""

    def __init__(self, graph: Graph, owners: Sequence[str]) -> None:
        self._graph = graph
        self._rank = {name: k for k, name in enumerate(owners)}
        self._names: dict[Owner, str] = {}

    def of(self, i: int) -> Owner:
        """Owner of a node. Nodes of several owners stand in the section "shared"."""
        label = self._graph.labels.get(i)
        if label is not None:
            return Owner(label[0], *label)
        origin = self._graph.origins[i]
        more = self._graph.shared.get(i)
        if more:
            last = len(self._rank)
            origins = sorted({*more, origin}, key=lambda o: (self._rank.get(o[0], last), o))
            origins = [o for o in origins if o[0]]
            if origins and origins[0][0] != origins[-1][0]:
                return Owner(SHARED, *origins[0])
        return Owner(origin[0], *origin)

    def base(self, i: int) -> str:
        """Name of a node before it is made unique: ``<owner>_<quantity>``."""
        owner = self.of(i)
        name = self._names.get(owner)
        if name is None:
            words = [mangle(word) for word in owner[1:] if word]
            name = self._names[owner] = mangle("_".join(words)) if words else ""
        return name or f"{self._graph.nodes[i][0]}_1"


@dataclass(frozen=True)
class Plan:
    """The statements of a routine.

    Attributes:
        graph: Where the nodes live.
        order: Nodes that are computed or read, operands first.
        reads: Node that is a statement -> the statements and outside values it reads, in order.
        direct: Statements whose only reader is a result: they need no name.
        outside: What is read but not computed here: input entries and given nodes.
    """

    graph: Graph
    order: list[int]
    reads: dict[int, tuple[int, ...]]
    direct: frozenset[int]
    outside: frozenset[int]


def make_plan(
    graph: Graph,
    order: Sequence[int],
    roots: Sequence[int],
    given: Collection[int],
    owners: Owners,
) -> Plan:
    """Decide which nodes become statements.

    Args:
        graph: Where the nodes live.
        order: All nodes, operands first.
        roots: Results, once per place where they are wanted.
        given: Nodes that are read from outside instead of being computed.
        owners: Whose the nodes are.

    Raises:
        CodegenError: a placeholder was left in the graph.
    """
    found, uses = _needed(graph, order, roots, given)
    return _Planner(graph, uses, frozenset(roots), owners).plan(found, given)


def _needed(
    graph: Graph, order: Sequence[int], roots: Sequence[int], given: Collection[int]
) -> tuple[list[int], dict[int, int]]:
    """Nodes to compute or read for the roots, and how often each is read."""
    nodes, leaves = graph.nodes, LEAVES
    uses: dict[int, int] = {}
    for i in roots:
        uses[i] = uses.get(i, 0) + 1
    found = []
    for i in reversed(order):
        if i not in uses:
            continue
        found.append(i)
        node = nodes[i]
        op = node[0]
        if op in leaves or i in given:
            continue
        for k in node[4:] if op == "solve" else node[1:2] if op == "item" else node[1:]:
            uses[k] = uses.get(k, 0) + 1
    found.reverse()
    return found, uses


class _Planner:
    """One pass over the nodes; ``sees`` is what an expression that contains a node reads."""

    def __init__(
        self, graph: Graph, uses: dict[int, int], roots: frozenset[int], owners: Owners
    ) -> None:
        self.graph = graph
        self.uses = uses
        self.roots = roots
        self.owners = owners
        self.width: dict[int, int] = {}
        self.sees: dict[int, tuple[int, ...]] = {}
        self.reads: dict[int, tuple[int, ...]] = {}

    def plan(self, order: list[int], given: Collection[int]) -> Plan:
        nodes, labels, uses = self.graph.nodes, self.graph.labels, self.uses
        width, sees, reads = self.width, self.sees, self.reads
        outside = []
        for i in order:
            node = nodes[i]
            op = node[0]
            if op == "const":
                width[i], sees[i] = len(repr(node[1])), ()
            elif i in given or op in LEAVES:
                if op == "atom":
                    raise CodegenError(f"placeholder '{node[1]}' was not resolved")
                outside.append(i)
                width[i], sees[i] = 24, (i,)
            elif op in ("solve", "item"):
                read = node[4:] if op == "solve" else node[1:2]
                self._state(i, tuple(k for j in read for k in sees[j]))
            else:
                total, seen = self._expression(i, node)
                # a changed sign of something with a name needs no name
                sign_only = op == "neg" and sees[node[1]] == node[1:]
                if (uses[i] > 1 and not sign_only) or i in labels or op in ("sin", "cos"):
                    self._state(i, seen)
                elif i in self.roots:
                    self._state(i, seen)
                else:
                    width[i], sees[i] = total, seen
        named = {i: reads[i] for i in order if i in reads}
        direct = frozenset(
            i for i in named if i in self.roots and uses[i] == 1 and nodes[i][0] != "item"
        )
        return Plan(self.graph, order, named, direct, frozenset(outside))

    def _state(self, i: int, seen: tuple[int, ...]) -> None:
        """Node i becomes a statement."""
        self.reads[i] = tuple(dict.fromkeys(seen))
        self.sees[i] = (i,)
        self.width[i] = len(self.owners.base(i)) + NUMBER

    def _expression(self, i: int, node: tuple[object, ...]) -> tuple[int, tuple[int, ...]]:
        """Width and reads of an operator; operands become statements while it is too wide."""
        width, sees = self.width, self.sees
        read: tuple[int, ...] = node[1:]  # type: ignore[assignment]
        total = GLUE[node[0]] + sum([width[k] for k in read])  # type: ignore[index]
        if total > SHORT:
            limit = COLUMNS - FRAME - NUMBER - len(self.owners.base(i))
            while total > limit:
                inner = [k for k in read if sees[k] not in ((k,), ())]
                if not inner:
                    break
                widest = max(inner, key=lambda k: width[k])
                total -= width[widest]
                self._state(widest, sees[widest])
                total += width[widest]
        if len(read) == 2:
            return total, sees[read[0]] + sees[read[1]]
        return total, tuple([k for j in read for k in sees[j]])
