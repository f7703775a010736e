"""Functions as plain data: dictionaries, lists, strings and numbers, ready for JSON.

Saved Functions are there to be evaluated and differentiated. What only the reader of C needs, the
origins and labels of nodes, is not saved.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from itertools import pairwise
from typing import Any

from .function import Block, Function, Output
from .grammar import check
from .graph import Graph, Node
from .ops import LEAVES
from .recursion import OUT, STORE, Recursion, Sweep, Turns, Visit, ahead
from .table import Table
from .trees import saved_table
from .trees.assembly import Assembly, Form

SCHEMA = 1
MOST_NODES = 4_000_000
MOST_ENTRIES = 4_000_000
# entries of a block up to which their names are saved where others have them too
LISTED = 1000


def to_dict(function: Form, unnamed: Collection[str] = ()) -> dict[str, Any]:
    """The function with the nodes that its results need, renumbered; a recursion by its steps.

    Args:
        function: The function.
        unnamed: Blocks whose entries somebody else names: of those with more than ``LISTED`` the
            number of entries is saved alone.
    """
    if isinstance(function, Assembly):
        return _assembly_to_dict(function)
    if isinstance(function, Recursion):
        return _recursion_to_dict(function, unnamed)
    order = function.live()
    place = {i: k for k, i in enumerate(order)}
    return {
        "schema": SCHEMA,
        "name": function.name,
        "about": function.about,
        "owners": list(function.owners),
        "inputs": _saved_blocks(function, unnamed),
        "outputs": [
            {
                "name": o.name,
                "shape": list(o.shape),
                "nodes": [place[i] for i in o.nodes],
                "entries": list(o.entries),
                "units": list(o.units),
            }
            for o in function.outputs
        ],
        "tables": [
            {"breaks": list(t.breaks), "coefficients": [list(c) for c in t.coefficients]}
            for t in function.graph.tables
        ],
        "nodes": [_saved(function.graph.nodes[i], place) for i in order],
    }


def _saved_blocks(function: Form, unnamed: Collection[str] = ()) -> list[dict[str, Any]]:
    return [
        {"name": b.name, "size": len(b)}
        if b.name in unnamed and len(b) > LISTED
        else {"name": b.name, "entries": list(b.entries), "units": list(b.units)}
        for b in function.inputs
    ]


def _block(saved: object) -> Block:
    """A block with the names of its entries, or with their number alone."""
    name = _text(saved, "name")
    size = saved.get("size") if isinstance(saved, Mapping) else None
    if size is None:
        return Block(name, _texts(saved, "entries"), _texts(saved, "units"))
    if type(size) is not int or not 0 <= size <= MOST_ENTRIES:
        raise ValueError(f"'size' of a saved block must be a whole number, not {size!r}")
    return Block(name, ("",) * size, ("",) * size)


def _assembly_to_dict(assembly: Assembly) -> dict[str, object]:
    return {
        "schema": SCHEMA,
        "name": assembly.name,
        "about": assembly.about,
        "inputs": _saved_blocks(assembly),
        "outputs": _saved_results(assembly.outputs),
        "parts": to_dict(assembly.parts),
        "kernel": assembly.kernel,
        "tree": saved_table.to_dict(assembly.tree),
    }


def _saved_results(outputs: Sequence[Output]) -> list[dict[str, object]]:
    """Results without their expressions."""
    return [
        {"name": o.name, "shape": list(o.shape), "entries": list(o.entries), "units": list(o.units)}
        for o in outputs
    ]


def _recursion_to_dict(recursion: Recursion, unnamed: Collection[str]) -> dict[str, Any]:
    return {
        "schema": SCHEMA,
        "name": recursion.name,
        "about": recursion.about,
        "inputs": _saved_blocks(recursion, unnamed),
        "outputs": _saved_results(recursion.outputs),
        "size": recursion.size,
        "steps": [to_dict(step) for step in recursion.steps],
        "sweeps": [
            {"name": sweep.name, "visits": [_saved_part(part) for part in sweep.parts]}
            for sweep in recursion.sweeps
        ],
    }


def _saved_part(part: Visit | Turns) -> list[Any]:
    if isinstance(part, Visit):
        return _saved_visit(part)
    visits, strides = ([_saved_visit(v) for v in row] for row in (part.visits, part.strides))
    return [part.times, visits, strides]


def _saved_visit(visit: Visit) -> list[Any]:
    reads = {block: list(places) for block, places in visit.reads.items()}
    return [visit.step, reads, list(visit.stores), list(visit.outs)]


def _saved(node: Node, place: Mapping[int, int]) -> list[Any]:
    op = node[0]
    if op in LEAVES:
        return list(node)
    if op == "item":
        return [op, place[node[1]], node[2]]
    if op == "solve":
        return [*node[:4], *[place[k] for k in node[4:]]]
    return [op, *[place[k] for k in node[1:]]]


def from_dict(data: Mapping[str, object]) -> Function:
    """The function that :func:`to_dict` saved; recursions and assemblies come back straight-line.

    Raises:
        ValueError: as :func:`form_from_dict`.
    """
    form = form_from_dict(data)
    return form if isinstance(form, Function) else check(form.straight())


def form_from_dict(data: Mapping[str, object]) -> Form:
    """What :func:`to_dict` saved, as it was.

    Raises:
        ValueError: the data is not a saved function of this schema, is too large, or breaks a rule
            of :mod:`cardan.ir.grammar`.
    """
    if not isinstance(data, Mapping) or data.get("schema") != SCHEMA:
        raise ValueError(f"a saved function has 'schema': {SCHEMA}; this is none of them")
    inputs = tuple(map(_block, _list(data, "inputs", 64)))
    name, about = _text(data, "name"), _text(data, "about")
    if "kernel" in data:
        return _assembly(data, name, inputs, about)
    if "sweeps" in data:
        return _recursion(data, name, inputs, about)
    nodes = _list(data, "nodes", MOST_NODES)
    graph, place = Graph(), list[int]()
    graph.tables = [_table(t) for t in _list(data, "tables", MOST_NODES)]
    for number, saved in enumerate(nodes):
        place.append(graph.intern(_read(saved, number, place)))
    outputs = tuple(_output(o, place) for o in _list(data, "outputs", MOST_ENTRIES))
    return check(Function(name, graph, inputs, outputs, _texts(data, "owners"), about))


def _read(saved: object, number: int, place: Sequence[int]) -> Node:
    """A node on the operands read before it."""
    where = f"node {number} of a saved function"
    if not isinstance(saved, list) or not saved or not isinstance(saved[0], str):
        raise ValueError(f"{where}: expected a list that begins with an operator, not {saved!r}")
    op, arguments = saved[0], saved[1:]
    if op == "const":
        if (
            len(arguments) != 1
            or isinstance(arguments[0], bool)
            or not isinstance(arguments[0], int | float)
        ):
            raise ValueError(f"{where}: a constant holds one number")
        return (op, float(arguments[0]) + 0.0)
    if op in LEAVES:
        return (op, *arguments) if all(isinstance(x, str | int) for x in arguments) else (op,)
    data = arguments[:3] if op == "solve" else arguments[1:] if op == "item" else []
    indices = arguments[3:] if op == "solve" else arguments[:1] if op == "item" else arguments
    for k in indices:
        if type(k) is not int or not 0 <= k < number:
            raise ValueError(f"{where}: operand {k!r} does not stand before it")
    if not all(type(x) in (int, str) for x in data):
        raise ValueError(f"{where}: {data!r} are neither names nor whole numbers")
    copies = [place[k] for k in indices]
    return (op, *copies, *data) if op == "item" else (op, *data, *copies)


def _recursion(
    data: Mapping[str, object], name: str, inputs: tuple[Block, ...], about: str
) -> Recursion:
    """A recursion whose visits name only what is there."""
    steps = tuple(from_dict(step) for step in _list(data, "steps", MOST_ENTRIES))
    size, outputs = data.get("size"), _list(data, "outputs", MOST_ENTRIES)
    if type(size) is not int or not 0 <= size <= MOST_ENTRIES:
        raise ValueError(f"'size' of a saved recursion must be a whole number, not {size!r}")
    results = tuple(map(_result, outputs))
    lengths = {b.name: len(b) for b in inputs} | {STORE: size}
    room = sum(o.size for o in results)
    sweeps = tuple(
        Sweep(
            _text(sweep, "name"),
            tuple(_part(v, steps, lengths, room) for v in _list(sweep, "visits", MOST_ENTRIES)),
        )
        for sweep in _list(data, "sweeps", MOST_ENTRIES)
    )
    return Recursion(name, inputs, results, steps, sweeps, size, about)


def _assembly(
    data: Mapping[str, object], name: str, inputs: tuple[Block, ...], about: str
) -> Assembly:
    """An assembly whose table names only what is there."""
    saved, results = data.get("parts"), _list(data, "outputs", MOST_ENTRIES)
    parts = from_dict(saved if isinstance(saved, Mapping) else {})
    outputs, kernel = tuple(map(_result, results)), _text(data, "kernel")
    if len(parts.outputs) != 1:
        raise ValueError("the parts of a saved assembly give the numbers of its bodies alone")
    speeds = sum(len(block) for block in inputs if block.name == "u")
    size = sum(output.size for output in outputs)
    numbers = parts.outputs[0].size
    tree = saved_table.from_dict(data.get("tree"), kernel, numbers, speeds, size)
    return Assembly(name, inputs, outputs, parts, kernel, tree, about)


def _result(saved: object) -> Output:
    """A result without expressions."""
    names = (_texts(saved, "entries"), _texts(saved, "units"))
    return Output(_text(saved, "name"), _shape(saved), (), *names)


def _part(
    saved: object, steps: Sequence[Function], lengths: Mapping[str, int], room: int
) -> Visit | Turns:
    """A visit, or turns whose first and last visits are inside their blocks."""
    if not isinstance(saved, list) or len(saved) != 3:
        return _visit(saved, steps, lengths, room)
    times, rows, strides = saved
    if type(times) is not int or not 1 <= times <= MOST_ENTRIES:
        raise ValueError(f"saved turns must be a number of times, not {times!r}")
    if not isinstance(rows, list) or not isinstance(strides, list) or len(rows) != len(strides):
        raise ValueError("saved turns are [times, visits, strides], a stride for every visit")
    visits = tuple(_visit(row, steps, lengths, room) for row in rows)
    moves = tuple(_stride(row, visit) for row, visit in zip(strides, visits, strict=True))
    for visit, move in zip(visits, moves, strict=True):
        last = _saved_visit(ahead(visit, move, times - 1))
        _visit(last, steps, lengths, room)
    return Turns(visits, moves, times)


def _stride(saved: Any, visit: Visit) -> Visit:
    """Differences of entries, as many as the visit has entries."""
    try:
        _, reads, stores, outs = saved
        move = Visit(
            visit.step,
            {block: tuple(reads[block]) for block in visit.reads},
            tuple(stores),
            tuple(outs),
        )
        ahead(visit, move, 1)
        entries = [*move.stores, *move.outs, *(k for row in move.reads.values() for k in row)]
    except (TypeError, ValueError, KeyError) as problem:
        raise ValueError(f"a saved stride does not fit its visit: {problem}") from problem
    if not all(type(k) is int for k in entries):
        raise ValueError("a saved stride consists of whole numbers")
    return move


def _visit(
    saved: object, steps: Sequence[Function], lengths: Mapping[str, int], room: int
) -> Visit:
    """A visit with as many places as its step has values, all of them inside their blocks."""
    if not isinstance(saved, list) or len(saved) != 4 or not isinstance(saved[1], dict):
        raise ValueError("a saved visit is [step, places read, places stored, results]")
    step, reads, stores, outs = saved
    if type(step) is not int or not 0 <= step < len(steps):
        raise ValueError(f"a saved visit names step {step!r}; there are {len(steps)}")
    function = steps[step]
    expected = [
        (b.name, reads.get(b.name), len(b), lengths.get(b.name, 0)) for b in function.inputs
    ]
    stored, out = function.outputs if len(function.outputs) == 2 else (None, None)
    if stored is None or out is None:
        raise ValueError("a saved step has two outputs: what it stores, what it gives out")
    expected += [(STORE, stores, stored.size, lengths[STORE]), (OUT, outs, out.size, room)]
    for block, places, count, length in expected:
        if not isinstance(places, list) or len(places) != count:
            raise ValueError(f"a saved visit needs {count} places of '{block}'")
        if not all(type(k) is int and 0 <= k < length for k in places):
            raise ValueError(f"a saved visit leaves the {length} places of '{block}'")
    read = {block: tuple(places) for block, places in reads.items()}
    return Visit(step, read, tuple(stores), tuple(outs))


def _shape(saved: object) -> tuple[int, ...]:
    shape = tuple(_list(saved, "shape", 8))
    if not all(type(n) is int and n >= 0 for n in shape) or math.prod(shape) > MOST_ENTRIES:
        raise ValueError(f"a saved result has a shape of whole numbers, not {shape}")
    return shape


def _output(saved: object, place: Sequence[int]) -> Output:
    shape = _shape(saved)
    nodes = _list(saved, "nodes", MOST_ENTRIES)
    if math.prod(shape) != len(nodes):
        raise ValueError(f"{len(nodes)} nodes of a saved result do not fill {shape}")
    if not all(type(k) is int and 0 <= k < len(place) for k in nodes):
        raise ValueError(f"a saved result names nodes that are not among the {len(place)} saved")
    copies = tuple(place[k] for k in nodes)
    return Output(
        _text(saved, "name"), shape, copies, _texts(saved, "entries"), _texts(saved, "units")
    )


def _table(saved: object) -> Table:
    breaks = tuple(map(_number, _list(saved, "breaks", MOST_ENTRIES)))
    rows = _list(saved, "coefficients", MOST_ENTRIES)
    coefficients = tuple(tuple(map(_number, row)) for row in rows if isinstance(row, list))
    orders = {len(segment) for segment in coefficients}
    rising = all(a < b for a, b in pairwise(breaks))
    if len(coefficients) != len(breaks) - 1 or len(orders) != 1 or 0 in orders or not rising:
        raise ValueError("a saved table needs rising breaks and one row of coefficients per piece")
    return Table(breaks, coefficients)


def _number(x: object) -> float:
    if isinstance(x, bool) or not isinstance(x, int | float) or not math.isfinite(x):
        raise ValueError(f"a saved table holds finite numbers, not {x!r}")
    return float(x)


def _list(data: object, key: str, most: int) -> list[Any]:
    value = data.get(key) if isinstance(data, Mapping) else None
    if not isinstance(value, list):
        raise ValueError(f"a saved function needs the list '{key}'")
    if len(value) > most:
        raise ValueError(f"'{key}' of a saved function has {len(value)} entries; at most {most}")
    return value


def _text(data: object, key: str) -> str:
    value = data.get(key) if isinstance(data, Mapping) else None
    if not isinstance(value, str):
        raise ValueError(f"a saved function needs the text '{key}'")
    return value


def _texts(data: object, key: str) -> tuple[str, ...]:
    values = _list(data, key, MOST_ENTRIES)
    if not all(isinstance(x, str) for x in values):
        raise ValueError(f"'{key}' of a saved function must hold texts")
    return tuple(values)
