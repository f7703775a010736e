"""A Function: named inputs, named outputs, units, over a graph."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import field
from functools import cached_property
from math import prod

from ..records import dataclass
from .graph import Graph, Node
from .ops import LEAVES, OPERATORS


@dataclass(frozen=True)
class Block:
    """An input block: the entries ``("var", name, k)`` of a graph.

    Attributes:
        name: A letter of the contract: t q u z s r p udot zdot lam tau wrench du q0.
        entries: Name of every entry.
        units: Unit of every entry, "" where dimensionless.
    """

    name: str
    entries: tuple[str, ...]
    units: tuple[str, ...]

    def __len__(self) -> int:
        return len(self.entries)


@dataclass(frozen=True)
class Output:
    """A named result of a Function.

    Attributes:
        name: Such as ``udot``.
        shape: Such as (7,) or (7, 7); row-major.
        nodes: One node per entry.
        entries: Name of every entry.
        units: Unit of every entry.
    """

    name: str
    shape: tuple[int, ...]
    nodes: tuple[int, ...]
    entries: tuple[str, ...] = ()
    units: tuple[str, ...] = ()

    @property
    def size(self) -> int:
        """Number of entries."""
        return prod(self.shape)


@dataclass(frozen=True)
class Function:
    """Outputs of a graph as a function of named input blocks.

    Attributes:
        name: C name.
        graph: Where the nodes live.
        inputs: The blocks it may read, in ABI order.
        outputs: Its results, concatenated in this order.
        owners: Owner names in graph numbering (ground first): the order of sections.
        about: One line for the reader of the C.
    """

    name: str
    graph: Graph = field(repr=False)
    inputs: tuple[Block, ...]
    outputs: tuple[Output, ...]
    owners: tuple[str, ...] = ()
    about: str = ""

    @property
    def roots(self) -> tuple[int, ...]:
        return tuple(node for output in self.outputs for node in output.nodes)

    def live(self) -> list[int]:
        """Indices of the nodes the outputs need, in topological order."""
        return list(self._live)

    @cached_property
    def _live(self) -> tuple[int, ...]:
        # a graph only grows: what the results need stays the same
        return tuple(live(self.graph, self.roots))

    def entries_read(self, block: str) -> frozenset[int]:
        """Numbers of the entries of a block that results depend on."""
        nodes = (self.graph.nodes[i] for i in self.live())
        return frozenset(node[2] for node in nodes if node[:2] == ("var", block))

    def operations(self) -> dict[str, int]:
        """Number of live nodes per operator."""
        return count(self.graph, self.live())

    def cost(self) -> float:
        """Sum of the costs of the live nodes."""
        return cost(self.operations())

    def critical_path(self) -> float:
        """Cost of the longest chain of dependent operations."""
        return critical_path(self.graph, self.live())


def pattern(
    graph: Graph, roots: Sequence[int], blocks: Collection[str] = ("p",)
) -> tuple[object, tuple[tuple[str, int], ...]]:
    """Expressions in local numbers, and the inputs they read: (block, entry) in order of use.

    None if they read more than these blocks.
    """
    nodes = graph.nodes
    number: dict[int, int] = {}
    pattern_nodes: list[Node] = []
    places: list[tuple[str, int]] = []
    stack = list(reversed(roots))
    while stack:
        i = stack[-1]
        if i in number:
            stack.pop()
            continue
        node = nodes[i]
        op = node[0]
        if op == "const":
            pattern_nodes.append(node)
        elif op in LEAVES:
            if op != "var" or node[1] not in blocks:
                return None, ()
            pattern_nodes.append((node[1], len(places)))
            places.append(node[1:])
        else:
            read = node[4:] if op == "solve" else node[1:2] if op == "item" else node[1:]
            waiting = [k for k in read if k not in number]
            if waiting:
                stack += reversed(waiting)
                continue
            attributes = node[1:4] if op == "solve" else node[2:] if op == "item" else ()
            pattern_nodes.append((op, *attributes, *[number[k] for k in read]))
        number[i] = len(number)
        stack.pop()
    return (tuple(pattern_nodes), tuple([number[i] for i in roots])), tuple(places)


def length(function: Function) -> int:
    """Operations of all entries written out in full."""
    sizes = dict[int, int]()
    for i in function.live():
        read = operands(function.graph.nodes[i])
        sizes[i] = sum(sizes[k] for k in read) + bool(read)
    return sum(sizes[root] for root in function.roots)


def operands(node: Node) -> tuple[int, ...]:
    """Indices of the nodes that a node reads."""
    op = node[0]
    if op in LEAVES:
        return ()
    if op == "solve":
        return node[4:]
    if op == "item":
        return (node[1],)
    return node[1:]


def live(graph: Graph, roots: Iterable[int], stop: Collection[int] = ()) -> list[int]:
    """Indices of the nodes that the roots need, in topological order.

    Args:
        graph: Where the roots live.
        roots: Nodes that are wanted.
        stop: Nodes whose operands are not wanted for their sake.
    """
    roots = tuple(roots)
    last = max(roots, default=-1)
    few = _reachable(graph, roots, stop, last // 8)
    return _swept(graph, roots, stop, last) if few is None else sorted(few)


def _reachable(
    graph: Graph, roots: Iterable[int], stop: Collection[int], most: int
) -> set[int] | None:
    """The nodes that the roots need; None where they are more than ``most``."""
    nodes, leaves = graph.nodes, LEAVES
    stack, visited = list(roots), set[int]()
    while stack:
        i = stack.pop()
        if i in visited:
            continue
        visited.add(i)
        if len(visited) > most:
            return None
        node = nodes[i]
        op = node[0]
        if op not in leaves and i not in stop:
            stack.extend(node[1:2] if op == "item" else node[4:] if op == "solve" else node[1:])
    return visited


def _swept(graph: Graph, roots: Iterable[int], stop: Collection[int], last: int) -> list[int]:
    """The nodes that the roots need, by one sweep backwards: operands stand before their node."""
    nodes, leaves = graph.nodes, LEAVES
    needed = bytearray(last + 1)
    for i in roots:
        needed[i] = 1
    for i in range(last, -1, -1):
        if not needed[i]:
            continue
        node = nodes[i]
        op = node[0]
        if op in leaves or i in stop:
            continue
        if op == "item":
            needed[node[1]] = 1
        else:
            for k in node[4:] if op == "solve" else node[1:]:
                needed[k] = 1
    return [i for i, flag in enumerate(needed) if flag]


@dataclass(frozen=True)
class Staged:
    """A Function cut in two: what the parameters alone determine, and what runs at every call.

    Attributes:
        function: The whole function.
        prepare: Nodes that depend on p and numbers only and are read by nodes that do not, or are
            results: w in this order. Entries of p that are read as they stand are among them.
        order: Live nodes in the order in which statements should stand.
    """

    function: Function
    prepare: tuple[int, ...]
    order: tuple[int, ...] = ()

    def prepared(self) -> list[int]:
        """Live nodes of the parameter part."""
        return live(self.function.graph, self.prepare)

    def body(self) -> list[int]:
        """Live nodes of the part that runs at every call; w stands for what is prepared."""
        done = set(self.prepare)
        return [i for i in live(self.function.graph, self.function.roots, done) if i not in done]

    def operations(self) -> dict[str, int]:
        """Number of nodes per operator in the part that runs at every call."""
        return count(self.function.graph, self.body())

    def prepare_operations(self) -> dict[str, int]:
        """Number of nodes per operator in the parameter part."""
        return count(self.function.graph, self.prepared())

    def critical_path(self) -> float:
        """Cost of the longest chain of dependent operations of a call."""
        return critical_path(self.function.graph, self.body())


def critical_path(graph: Graph, nodes: Iterable[int]) -> float:
    """Cost of the longest chain of dependent ones among nodes in topological order."""
    depth: dict[int, float] = {}
    for i in nodes:
        node = graph.nodes[i]
        latency = OPERATORS[node[0]].cost if node[0] in OPERATORS else 0.0
        depth[i] = latency + max((depth.get(k, 0.0) for k in operands(node)), default=0.0)
    return max(depth.values(), default=0.0)


def count(graph: Graph, nodes: Iterable[int]) -> dict[str, int]:
    """Number of nodes per operator; leaves and entries of solutions are not operations."""
    counts: dict[str, int] = {}
    for i in nodes:
        op = graph.nodes[i][0]
        if op not in LEAVES and op != "item":
            counts[op] = counts.get(op, 0) + 1
    return counts


def cost(counts: Mapping[str, int]) -> float:
    """Relative run time of counted operations, one addition being 1; solve nodes count 0."""
    return sum(OPERATORS[op].cost * n for op, n in counts.items() if op in OPERATORS)
