"""Sines and cosines of the coordinates of a recursion in a sweep of their own, before all others.

A visit of a body computes the sine and cosine of one angle; vectors compute many in the same time.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from ...ir.function import Block, Function, Output
from ...ir.graph import Graph
from ...ir.recursion import OUT, STORE, Recursion, Sweep, Turns, Visit
from ...ir.rewrite import rebuild_function
from ...ir.strided_visits import as_turns

# angles of a visit: several vectors of the widest kind, which do not wait for each other
CHUNK = 32
OPERATORS = ("sin", "cos")
Angles = dict[int, dict[str, int]]


def angles_first(recursion: Recursion) -> Recursion:
    """The same recursion with sines and cosines of entries of q in its first sweep.

    They lie in the store by the number of their entry of q: where visits read q at regular
    distances, so do they read these.
    """
    angles = [_angles(step) for step in recursion.steps]
    read = sorted({k for sweep in recursion.sweeps for p in sweep.parts for k in _read(p, angles)})
    if not read:
        return recursion
    span = read[-1] + 1 - read[0]
    start = {op: recursion.size + n * span - read[0] for n, op in enumerate(OPERATORS)}
    steps = [
        _without(step, of_step) if of_step else step
        for step, of_step in zip(recursion.steps, angles, strict=True)
    ]

    def with_stored(visit: Visit, shift: dict[str, int]) -> Visit:
        """A visit, or a stride, that reads sines and cosines behind what it reads of the store."""
        of_step = angles[visit.step]
        if not of_step:
            return visit
        places = [shift[op] + visit.reads["q"][k] for k, ops in of_step.items() for op in ops]
        stored = (*visit.reads.get(STORE, ()), *places)
        return visit._replace(reads={**visit.reads, STORE: stored})

    still = dict.fromkeys(OPERATORS, 0)
    sweeps = []
    for sweep in recursion.sweeps:
        parts: list[Visit | Turns] = []
        for part in sweep.parts:
            if isinstance(part, Visit):
                parts.append(with_stored(part, start))
                continue
            visits = tuple([with_stored(visit, start) for visit in part.visits])
            strides = tuple([with_stored(stride, still) for stride in part.strides])
            parts.append(Turns(visits, strides, part.times))
        sweeps.append(Sweep(sweep.name, tuple(parts)))
    chunks = [read[k : k + CHUNK] for k in range(0, len(read), CHUNK)]
    number = {size: len(steps) + n for n, size in enumerate(dict.fromkeys(map(len, chunks)))}
    steps += [_step(recursion, size) for size in number]
    first_visits = [
        Visit(
            number[len(c)], {"q": tuple(c)}, tuple(start[op] + k for op in OPERATORS for k in c), ()
        )
        for c in chunks
    ]
    first = Sweep("angles", as_turns(first_visits))
    size = recursion.size + len(OPERATORS) * span
    return replace(recursion, steps=tuple(steps), sweeps=(first, *sweeps), size=size)


def _read(part: Visit | Turns, angles: Sequence[Angles]) -> Iterator[int]:
    """Entries of q whose sine or cosine some visits take."""
    turns = part if isinstance(part, Turns) else Turns((part,), (part,), 1)
    for visit, stride in zip(turns.visits, turns.strides, strict=True):
        for k in angles[visit.step]:
            first, further = visit.reads["q"][k], stride.reads["q"][k]
            yield from (first + further * n for n in range(turns.times))


def _angles(step: Function) -> Angles:
    """Local entry of q -> its sine, its cosine or both -> node."""
    nodes, angles = step.graph.nodes, Angles()
    for i in step.live():
        if nodes[i][0] in OPERATORS:
            argument = nodes[nodes[i][1]]
            if argument[:2] == ("var", "q"):
                angles.setdefault(argument[2], {})[nodes[i][0]] = i
    return angles


def _without(step: Function, angles: Angles) -> Function:
    """A step that reads its sines and cosines from the store."""
    blocks = {block.name: block for block in step.inputs}
    store, q = blocks.get(STORE, Block(STORE, (), ())), blocks["q"]
    entries, read = list(store.entries), dict[int, int]()
    for k, nodes in angles.items():
        for op, node in nodes.items():
            read[node] = len(entries)
            entries.append(f"{q.entries[k]}.{op}")
    blocks[STORE] = Block(STORE, tuple(entries), ("",) * len(entries))

    def stored(target: Graph, i: int, _: object) -> int | None:
        return target.var(STORE, read[i]) if i in read else None

    return replace(rebuild_function(step, stored), inputs=tuple(blocks.values()))


def _step(recursion: Recursion, count: int) -> Function:
    """Sines and cosines of some angles."""
    graph = Graph()
    entries = tuple(f"angle_{k}" for k in range(count))
    angles = [graph.var("q", k) for k in range(count)]
    nodes = tuple(graph.apply(op, angle) for op in OPERATORS for angle in angles)
    labels = tuple(f"{entry}.{op}" for op in OPERATORS for entry in entries)
    outputs = (Output(STORE, (len(nodes),), nodes, labels), Output(OUT, (0,), (), ()))
    inputs = (Block("q", entries, ("rad",) * count),)
    return Function(f"{recursion.name}_angles_{count}", graph, inputs, outputs, ("angle",))
