"""CasADi: the exported C as external functions with exact sparse derivatives, free of cardan.

CasADi finds derivatives of an external function by their names: ``jac_<name>`` has the Jacobian,
``adj1_<name>`` the gradient of a weighted sum of its results, and the Jacobian of that, which has
second derivatives, is ``jac_adj1_<name>``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import prod
from re import sub

from ...schema.c_functions import ResultRow
from ...schema.manifest import Manifest
from ..program.naming import Names, mangle
from ..sources import source
from . import binding
from .binding import BoundFunction, BoundModel, Hessian, Jacobian

SUFFIX = ".c"
# where a value that nobody gave means that nothing acts
NOTHING = ("t", "tau", "wrench", "udot")
# arguments that hold several blocks
PARTS = {"x": ("q", "u", "z")}

HEAD = '''\
"""{title}: functions of a multibody model for CasADi.

{about} Speeds u are what robotics calls v, quaternions are (w, x, y, z), 6-vectors have the angular
part first, units are SI and radians. Needs casadi, and a C compiler at the first import.

    import casadi, {package}
    f = {package}.function({example!r})
"""

import pathlib

import casadi

NAME = {name!r}
COORDINATES = {coordinates}
SPEEDS = {speeds}
INPUTS = {inputs}
PARAMETERS = {parameters}
P = {values}
FUNCTIONS = {functions}

_BY_PARAMETERS = {by_parameters}
# functions with second derivatives, and whether these are by parameters too
HESSIANS = {hessians}
_EXTERNALS = {externals}
_NAMES = {names}
_PACKAGE = {package!r}
_FLAGS = {flags}
'''

# rows and columns, or entries that are not 0: by columns
Places = list[tuple[int, int, int]]


def package(manifest: Manifest) -> str:
    """Name of the module."""
    return f"{mangle(manifest.name).lower()}_casadi"


def files(model: BoundModel) -> dict[str, str | bytes]:
    """The C of the external functions and the module that loads them."""
    manifest = model.manifest
    functions = binding.bound(manifest)
    return {
        "binding.h": source("binding.h"),
        "casadi.c": _c(manifest, functions),
        f"{package(manifest)}.py": module(HEAD, manifest, package(manifest), model.flags)
        + source("library.txt")
        + source("casadi.txt"),
    }


def _externals(functions: Sequence[BoundFunction]) -> dict[str, str]:
    """Names that CasADi takes, by those in C: without two underscores in a row."""
    names = Names()
    return {f.symbol: names.new(sub("_+", "_", f.symbol).rstrip("_")) for f in functions}


def module(head: str, manifest: Manifest, name: str, flags: Sequence[str]) -> str:
    """Head of a module that loads the exported C."""
    functions = binding.bound(manifest)
    listed = {key: binding.literal(value) for key, value in binding.names(manifest).items()}
    return head.format(
        title=binding.plain(manifest.name),
        name=manifest.name,
        about=binding.summary(manifest),
        package=name,
        example=functions[0].symbol if functions else "",
        values=binding.literal(tuple(float(row.default) for row in manifest.parameters)),
        functions=binding.literal(tuple(f.symbol for f in functions)),
        names=binding.literal(
            {(f.symbol.split("__")[0], f.entry.of): f.symbol for f in functions if f.entry.of}
        ),
        by_parameters=binding.literal(tuple(f.symbol for f in functions if "p" in f.jacobians)),
        hessians=binding.literal(
            {f.symbol: "p" in f.hessian.starts for f in functions if f.hessian}
        ),
        externals=binding.literal(_externals(functions)),
        flags=binding.literal(tuple(flags)),
        **listed,
    )


def _c(manifest: Manifest, functions: Sequence[BoundFunction]) -> str:
    """``casadi.c``."""
    lines, externals = [source("casadi.c")], _externals(functions)
    for f in functions:
        names = _arguments(f, manifest)
        # what is weighted stands behind all arguments that CasADi hands over
        weights = {one.symbol: len(names) + 2 for one in f.gradients.values()}
        if f.hessian:
            weights[f.hessian.symbol] = 2 * len(names) + 2
        lines += [f"/* {f.symbol} */", *binding.records(f, manifest, grouped=True, weights=weights)]
        name = f"casadi_{externals[f.symbol]}"
        lines += [*_value(f, manifest, name), *_jacobian(f, manifest, f"jac_{name}")]
        if f.gradients:
            lines += _gradient(f, manifest, f"adj1_{name}")
        if f.hessian:
            lines += _hessian(f, f.hessian, manifest, f"jac_adj1_{name}")
        lines.append("")
    return "\n".join(lines)


def _arguments(f: BoundFunction, manifest: Manifest) -> list[str]:
    """Names of what CasADi hands over."""
    return [*f.arguments, *(("p",) if manifest.block("p") else ())]


def _value(f: BoundFunction, manifest: Manifest, name: str) -> list[str]:
    """The function itself."""
    size, entries = binding.sizes(manifest), _entries(f.result)
    names = _arguments(f, manifest)
    lines, part = _part(f.symbol, f.symbol, [(0, entries)])
    shapes = [(size[name], 1, _dense(size[name], 1)) for name in names]
    results = [(*_shape(f.result), entries)]
    defaults = "".join("0" if name in NOTHING else "?" for name in names)
    record = _external(f.symbol, [part], (names, shapes), ([f.result.name], results))
    return [*lines, *record, f'DEFINE({name}, {f.symbol}_external, "{defaults}")']


def _jacobian(f: BoundFunction, manifest: Manifest, external: str) -> list[str]:
    """Its derivatives along every argument."""
    size, result = binding.sizes(manifest), f.result
    names, rows = _arguments(f, manifest), prod(result.shape)
    results: list[tuple[int, int, Places]] = []
    by_symbol: dict[str, list[tuple[int, Places]]] = {}
    for place, name in enumerate(names):
        at, symbol = _by_argument(f, name, size)
        if not symbol and name != "s":
            # it was not exported: it is as if it were full, and asking for it fails
            at = _dense(rows, size[name])
        results.append((rows, size[name], at))
        if at:
            by_symbol.setdefault(symbol, []).append((place, at))
    lines, parts = [], []
    for n, (symbol, entries) in enumerate(by_symbol.items()):
        more, part = _part(f"{f.symbol}_jacobian_{n}", symbol, entries)
        lines += more
        parts.append(part)
    shapes = [(size[name], 1, _dense(size[name], 1)) for name in names]
    shapes.append((*_shape(result), []))
    inputs, labels = (*names, f"out_{result.name}"), [f"jac_{result.name}_{n}" for n in names]
    record = _external(f"{f.symbol}_jacobian", parts, (inputs, shapes), (labels, results))
    return [*lines, *record, f'DEFINE({external}, {f.symbol}_jacobian_external, "")']


def _by_argument(f: BoundFunction, name: str, size: Mapping[str, int]) -> tuple[Places, str]:
    """Entries of the Jacobian along an argument that may not be 0, and the C that gives them."""
    at, start, symbol = list[tuple[int, int, int]](), 0, ""
    for block in PARTS.get(name, (name,)):
        one = f.jacobians.get(block)
        if one is not None:
            at += _columns(one, f.result, start)
            symbol = one.symbol
        start += size[block]
    return sorted(at, key=_by_columns), symbol


def _gradient(f: BoundFunction, manifest: Manifest, external: str) -> list[str]:
    """Derivatives of the weighted sum of results: CasADi's reverse mode."""
    size, names, result = binding.sizes(manifest), _arguments(f, manifest), f.result
    name = f"{f.symbol}_gradient"
    results: list[tuple[int, int, Places]] = []
    by_symbol: dict[str, list[tuple[int, Places]]] = {}
    for place, argument in enumerate(names):
        blocks = [block for block in PARTS.get(argument, (argument,)) if size[block]]
        gradients = [f.gradients[block] for block in blocks if block in f.gradients]
        symbol, numbers = "", [0] * size[argument]
        if gradients:
            symbol, starts = gradients[0].symbol, zip(gradients, blocks, strict=True)
            numbers = [one.start + k for one, block in starts for k in range(size[block])]
        elif argument == "s":
            # modes are whole numbers, by which there is no derivative
            symbol, numbers = f.products[0], [-1] * size[argument]
        # CasADi wants gradients that are full
        places = [(row, 0, k) for row, k in enumerate(numbers)]
        results.append((size[argument], 1, places))
        by_symbol.setdefault(symbol, []).append((place, places))
    lines = _weights(name, result, len(names) + 1)
    parts = []
    for n, (symbol, entries) in enumerate(by_symbol.items()):
        more, part = _part(f"{name}_{n}", symbol, entries, f"{name}_weights" if symbol else "")
        lines += more
        parts.append(part)
    inputs = _with_seeds(names, size, result)
    labels = [f"adj_{argument}" for argument in names]
    record = _external(name, parts, inputs, (labels, results))
    return [*lines, *record, f'DEFINE({external}, {name}_external, "")']


def _with_seeds(
    names: Sequence[str], size: Mapping[str, int], result: ResultRow
) -> tuple[list[str], list[tuple[int, int, Places]]]:
    """What CasADi hands to a gradient: arguments, the result, which is not needed, and weights."""
    shapes = [(size[name], 1, _dense(size[name], 1)) for name in names]
    shapes += [(*_shape(result), []), (*_shape(result), _entries(result))]
    return [*names, f"out_{result.name}", f"adj_{result.name}"], shapes


def _hessian(f: BoundFunction, second: Hessian, manifest: Manifest, external: str) -> list[str]:
    """Derivatives of the gradient by arguments and by weights."""
    size, names, result = binding.sizes(manifest), _arguments(f, manifest), f.result
    name, rows = f"{f.symbol}_hessian", prod(result.shape)
    results, labels = list[tuple[int, int, Places]](), list[str]()
    by_symbol: dict[str, list[tuple[int, Places]]] = {}

    def add(label: str, shape: tuple[int, int], symbol: str, at: Places) -> None:
        if at:
            by_symbol.setdefault(symbol, []).append((len(results), at))
        results.append((*shape, at))
        labels.append(f"jac_adj_{label}")

    for row in names:
        for column in names:
            at, exported = _second(f, second, (row, column), size)
            add(f"{row}_{column}", (size[row], size[column]), second.symbol if exported else "", at)
        add(f"{row}_out_{result.name}", (size[row], rows), "", [])
        at, symbol = _by_argument(f, row, size)
        at = sorted(((j, i, k) for i, j, k in at), key=_by_columns)
        if not symbol and row != "s":
            at = _dense(size[row], rows)
        add(f"{row}_adj_{result.name}", (size[row], rows), symbol, at)
    lines = _weights(name, result, len(names) + 1)
    parts = []
    for n, (symbol, entries) in enumerate(by_symbol.items()):
        weights = f"{name}_weights" if symbol == second.symbol else ""
        more, part = _part(f"{name}_{n}", symbol, entries, weights)
        lines += more
        parts.append(part)
    inputs, shapes = _with_seeds(names, size, result)
    inputs += [f"out_adj_{argument}" for argument in names]
    shapes += [(size[argument], 1, []) for argument in names]
    record = _external(name, parts, (inputs, shapes), (labels, results))
    return [*lines, *record, f'DEFINE({external}, {name}_external, "")']


def _second(
    f: BoundFunction, second: Hessian, pair: tuple[str, str], size: Mapping[str, int]
) -> tuple[Places, bool]:
    """Second derivatives by two arguments that may not be 0, and whether they were exported."""
    row, column = pair
    moving = [{j for _, j, _ in _by_argument(f, argument, size)[0]} for argument in pair]
    if not all(moving):
        return [], True
    starts = [_starts(second, argument, size) for argument in pair]
    if not all(starts):
        # as with Jacobians
        return _dense(size[row], size[column]), False
    at: Places = []
    for j in sorted(moving[1]):
        for i in sorted(moving[0]):
            k = starts[0][i] * second.size + starts[1][j]
            if k in second.nonzero:
                at.append((i, j, k))
    return at, True


def _starts(second: Hessian, argument: str, size: Mapping[str, int]) -> list[int]:
    """Columns of the Hessian along an argument; none where they were not exported."""
    blocks = [block for block in PARTS.get(argument, (argument,)) if size[block]]
    if any(block not in second.starts for block in blocks):
        return []
    return [second.starts[block] + k for block in blocks for k in range(size[block])]


def _weights(name: str, result: ResultRow, argument: int) -> list[str]:
    """The record of the weights: those that CasADi hands over by columns."""
    table, entries = f"{name}_order", [k for _, _, k in _entries(result)]
    numbers = f"{table}, {len(entries)}, {prod(result.shape)}, {argument}"
    return [*_array("int", table, entries), f"static const weights {name}_weights = {{{numbers}}};"]


def _columns(one: Jacobian, output: ResultRow, start: int) -> Places:
    """Entries of a Jacobian that may not be 0: rows are those of a result column by column."""
    height, width = _shape(output)
    places: Places = []
    for k in one.nonzero:
        row, column = divmod(k, one.columns)
        i, j = divmod(row, width)
        places.append((j * height + i, start + column, one.start + k))
    return places


def _entries(output: ResultRow) -> Places:
    """Entries of a result that may not be 0, by columns."""
    height, width = _shape(output)
    places = [(*divmod(k, width), k) for k in output.sparsity or range(height * width)]
    return sorted(places, key=_by_columns)


def _by_columns(entry: tuple[int, int, int]) -> tuple[int, int]:
    return entry[1], entry[0]


def _shape(output: ResultRow) -> tuple[int, int]:
    """Rows and columns of a result; CasADi has nothing of more axes."""
    height, *inner = output.shape or (1,)
    return height, prod(inner)


def _dense(rows: int, columns: int) -> Places:
    return [(i, j, 0) for j in range(columns) for i in range(rows)]


def _part(
    name: str, symbol: str, results: Sequence[tuple[int, Places]], weights: str = ""
) -> tuple[list[str], str]:
    """One call of the model: tables, and the record that names them."""
    lines, rows = [], []
    for place, entries in results:
        table = f"{name}_entries_{place}"
        lines += _array("int", table, [k for _, _, k in entries])
        rows.append(f"{{{place}, {len(entries)}, {table}}}")
    lines += [f"static const result {name}_results[] = {{", f"    {', '.join(rows)}", "};"]
    call = f"&{symbol}_bound" if symbol else "NULL"
    last = f"&{weights}" if weights else "NULL"
    return lines, f"{{{call}, {name}_results, {len(rows)}, {last}}}"


def _external(
    name: str,
    parts: Sequence[str],
    inputs: tuple[Sequence[str], Sequence[tuple[int, int, Places]]],
    outputs: tuple[Sequence[str], Sequence[tuple[int, int, Places]]],
) -> list[str]:
    """The record of a function of CasADi, with its names and patterns."""
    lines = [f"static const part {name}_parts[] = {{{', '.join(parts)}}};"]
    for way, (names, shapes) in (("in", inputs), ("out", outputs)):
        patterns = []
        for k, (rows, columns, entries) in enumerate(shapes):
            table = f"{name}_{way}_{k}"
            lines += _array("casadi_int", table, _pattern(rows, columns, entries))
            patterns.append(table)
        quoted = ", ".join(f'"{one}"' for one in names)
        lines.append(f"static const char *const {name}_{way}_names[] = {{{quoted}}};")
        listed = ", ".join(patterns)
        lines.append(f"static const casadi_int *const {name}_{way}_sparsity[] = {{{listed}}};")
    fields = [f"{name}_parts, {len(parts)}, {len(inputs[0])}, {len(outputs[0])}"]
    fields += [f"{name}_in_names, {name}_out_names", f"{name}_in_sparsity, {name}_out_sparsity"]
    return [*lines, f"static const external {name}_external = {{", f"    {', '.join(fields)}", "};"]


def _pattern(rows: int, columns: int, entries: Places) -> list[int]:
    """Sparsity as CasADi has it: size, where columns begin, rows."""
    counts = [0] * (columns + 1)
    for _, j, _ in entries:
        counts[j + 1] += 1
    for j in range(columns):
        counts[j + 1] += counts[j]
    return [rows, columns, *counts, *(i for i, _, _ in entries)]


def _array(kind: str, name: str, values: Sequence[int]) -> list[str]:
    """A constant array, wrapped; C wants at least one number."""
    listed = [str(value) for value in values] or ["0"]
    rows = [", ".join(listed[k : k + 20]) for k in range(0, len(listed), 20)]
    return [f"static const {kind} {name}[] = {{", *(f"    {row}," for row in rows), "};"]


BINDING = binding.Binding(
    package,
    files,
    "`casadi.c`, `{package}.py`",
    "external functions of CasADi with exact Jacobians: `import {package}` here compiles them",
    jacobians=True,
    products=("vjp", "hessian"),
)
