"""Recursions: a few step functions and the order in which they visit bodies or elements.

A step is a Function in local words. A visit says which step runs and where its local entries lie
in the blocks of the whole, in the store that all visits share, and among the results. What one
visit stores later ones read; that order is the only one. Visits at regular distances are told as
turns. :meth:`Recursion.straight` splices the visits into one straight-line Function; the code
generator prints them as loops over tables.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field
from typing import NamedTuple

from ..records import dataclass
from .function import Block, Function, Output
from .graph import ZERO, Graph
from .rewrite import rebuild

# name of the block of stored values, and of the results of a step
STORE, OUT = "store", "out"


class Visit(NamedTuple):
    """One run of a step.

    Attributes:
        step: Number of the step.
        reads: Block -> for every local entry the entry of the whole block (or place in the store).
        stores: Places in the store that it writes.
        outs: Entries of the results, counted over all outputs, that it writes.
    """

    step: int
    reads: Mapping[str, tuple[int, ...]]
    stores: tuple[int, ...]
    outs: tuple[int, ...]


class Turns(NamedTuple):
    """Visits repeated, every time the same number of entries further on.

    Attributes:
        visits: Those of the first turn.
        strides: What is added to their entries from turn to turn; their steps are the same.
        times: Number of turns.
    """

    visits: tuple[Visit, ...]
    strides: tuple[Visit, ...]
    times: int

    def turn(self, number: int) -> tuple[Visit, ...]:
        """The visits of one turn."""
        pairs = zip(self.visits, self.strides, strict=True)
        return tuple(ahead(visit, stride, number) for visit, stride in pairs)


def ahead(visit: Visit, stride: Visit, turns: int) -> Visit:
    """A visit some turns further on."""

    def moved(places: tuple[int, ...], by: tuple[int, ...]) -> tuple[int, ...]:
        return tuple([a + turns * d for a, d in zip(places, by, strict=True)])

    reads = {block: moved(places, stride.reads[block]) for block, places in visit.reads.items()}
    stores, outs = moved(visit.stores, stride.stores), moved(visit.outs, stride.outs)
    return Visit(visit.step, reads, stores, outs)


@dataclass(frozen=True)
class Sweep:
    """Visits that belong together, such as those from the ground outward.

    Attributes:
        name: For the reader.
        parts: In order; equal ones at regular distances as turns.
    """

    name: str
    parts: tuple[Visit | Turns, ...] = field(repr=False)

    def __len__(self) -> int:
        """Number of visits."""
        return sum(len(p.visits) * p.times if isinstance(p, Turns) else 1 for p in self.parts)

    def visits(self) -> Iterator[Visit]:
        """All visits, one by one."""
        for part in self.parts:
            if isinstance(part, Turns):
                for number in range(part.times):
                    yield from part.turn(number)
            else:
                yield part


@dataclass(frozen=True)
class Recursion:
    """A function that is computed by visits.

    Attributes:
        name: C name.
        inputs: The blocks it may read, in ABI order.
        outputs: Its results; they hold no nodes.
        steps: What visits do. A step reads local blocks, ``store`` among them; its outputs are
            ``store`` (what it stores) and ``out`` (results of the whole).
        sweeps: The visits, in order.
        size: Length of the store.
        about: One line for the reader of the C.
    """

    name: str
    inputs: tuple[Block, ...] = field(repr=False)
    outputs: tuple[Output, ...] = field(repr=False)
    steps: tuple[Function, ...]
    sweeps: tuple[Sweep, ...]
    size: int
    about: str = ""

    def operations(self) -> dict[str, int]:
        """Number of operations per operator, over all visits."""
        counts = [step.operations() for step in self.steps]
        total: dict[str, int] = {}
        for sweep in self.sweeps:
            for part in sweep.parts:
                turns = part if isinstance(part, Turns) else Turns((part,), (part,), 1)
                for visit in turns.visits:
                    for op, n in counts[visit.step].items():
                        total[op] = total.get(op, 0) + n * turns.times
        return total

    def entries_read(self, block: str) -> frozenset[int]:
        """Numbers of the entries of a block that visits read."""
        visits = (visit for sweep in self.sweeps for visit in sweep.visits())
        return frozenset(k for visit in visits for k in visit.reads.get(block, ()))

    def straight(self) -> Function:
        """The same function as straight-line expressions."""
        graph = Graph()
        if self.steps:
            graph.tables = self.steps[0].graph.tables.copy()
        store = [ZERO] * self.size
        out = [ZERO] * sum(o.size for o in self.outputs)
        for sweep in self.sweeps:
            for visit in sweep.visits():
                step = self.steps[visit.step]
                places = _places(step, visit, store, graph)
                _, roots = rebuild(step.graph, step.roots, places, into=graph)
                stored = len(visit.stores)
                for place, node in zip(visit.stores, roots[:stored], strict=True):
                    store[place] = node
                for place, node in zip(visit.outs, roots[stored:], strict=True):
                    out[place] = node
        outputs, at = [], 0
        for o in self.outputs:
            nodes = tuple(out[at : at + o.size])
            outputs.append(Output(o.name, o.shape, nodes, o.entries, o.units))
            at += o.size
        return Function(self.name, graph, self.inputs, tuple(outputs), (), self.about)


def _places(step: Function, visit: Visit, store: list[int], graph: Graph) -> dict[int, int]:
    """Local input entry -> what stands for it in the whole."""
    places_by_node: dict[int, int] = {}
    for i in step.live():
        node = step.graph.nodes[i]
        if node[0] == "var":
            block, k = node[1], node[2]
            place = visit.reads[block][k]
            places_by_node[i] = store[place] if block == STORE else graph.var(block, place)
    return places_by_node
