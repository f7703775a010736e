"""``tables.h``: the places, elements and planned matrices of a model as constants of C.

One line per table entry would be read by nobody: numbers follow each other, twelve to a line, which
compilers take by the million.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from ..equations.absolute.record import Absolute, BlockKind, Kind
from ..equations.blocks import defaults
from .mesh import PARTS, common_name, parts
from .naming import comment

# what the functions of an element give, in the order of kernels/mesh.h
FORMS = {
    "balance": "CARDAN_BALANCE",
    "balance_tangent": "CARDAN_TANGENT",
    "gamma": "CARDAN_GAMMA",
    "energy": "CARDAN_ENERGY",
    "momentum": "CARDAN_MOMENTUM",
    "power": "CARDAN_POWER",
    "reaction": "CARDAN_REACTION",
    "outputs": "CARDAN_OUTPUTS",
    "stress": "CARDAN_STRESS",
    "mixed": "CARDAN_MIXED",
    "mixed_step": "CARDAN_MIXED_STEP",
}
OF_GROUP = ("place", "rows", "z", "s", "parts", "spots", "powers")
WAYS, NODE = ("move", "qdot"), "node"
PER_LINE = 12
# no group
END = "{-1, 0, NULL, NULL, 0, 0, 0}"
# tables of the plan whose entries are records
RECORDS = {"load": "cardan_sparse_load", "run": "cardan_sparse_run"}


class Planned(Protocol):
    """What is known of the matrices of a model and of its start; see ``runtime/absolute``."""

    @property
    def numbers(self) -> Mapping[str, int]:
        """Sizes of ``cardan_sparse``."""

    @property
    def tables(self) -> Mapping[str, Any]:
        """Its tables."""

    @property
    def spots(self) -> Sequence[Any]:
        """Of every group where its elements stand in the matrix."""

    @property
    def unknown(self) -> Any:
        """(m,) the unknown that every multiplier is."""

    @property
    def diagonal(self) -> Any:
        """(nu,) where the diagonal of the matrix stands."""

    @property
    def start(self) -> Any:
        """(nx,) state in which a run starts."""

    @property
    def held(self) -> Any:
        """(nx,) which entries of it stay as they are when parameters change."""

    @property
    def size(self) -> float:
        """Of the model [m], against which lengths count."""

    @property
    def columns(self) -> Any:
        """(nu,) what speeds count in: that, or 1."""


@dataclass(frozen=True)
class Form:
    """A function of the elements of a group.

    Attributes:
        group: Index of the group.
        name: Such as ``"balance"``.
        entry: What the manifest says about it.
    """

    group: int
    name: str
    entry: Mapping[str, Any]

    @property
    def nw(self) -> int:
        """Numbers that are prepared for an element."""
        return int(self.entry["prepared_size"])

    @property
    def row(self) -> str:
        """The entry of the table of functions."""
        symbol, size, work = (self.entry[key] for key in ("symbol", "output_size", "work_size"))
        return (
            f"{{{self.group}, {FORMS[self.name]}, {symbol}, prepare_{symbol}, "
            f"{self.nw}, {size}, {work}}}"
        )


@dataclass(frozen=True)
class Data:
    """What the elements of a group are given.

    Attributes:
        common: What the manifest says about the function that gives what follows from parameters,
            None without.
        alike: Whether that is the same for all of them.
        each: How many numbers of it belong to an element.
        own: How many others do.
        count: Elements.
    """

    common: Mapping[str, Any] | None
    alike: bool
    each: int
    own: int
    count: int

    @property
    def scratch(self) -> int:
        """Numbers of memory that the function and its results take."""
        sizes = ("output_size", "prepared_size", "work_size")
        return 0 if self.common is None else sum(int(self.common[key]) for key in sizes)

    def row(self, k: int) -> str:
        """The entry of the table of data."""
        own = f"own_{k}" if self.own and self.count else "NULL"
        if self.common is None:
            return f"{{NULL, NULL, 0, 0, 0, 0, {own}, {self.own}}}"
        symbol, size, nw = (self.common[key] for key in ("symbol", "output_size", "prepared_size"))
        return (
            f"{{{symbol}, prepare_{symbol}, {size}, {nw}, {self.each}, {int(self.alike)}, "
            f"{own}, {self.own}}}"
        )


def forms(absolute: Absolute, functions: Mapping[str, Any]) -> list[Form]:
    """The functions of all groups.

    Args:
        absolute: The equations.
        functions: Those of the manifest.
    """
    return [
        Form(k, name, functions[group.kind.functions[name].name])
        for k, group in enumerate(absolute.groups)
        for name in FORMS
        if name in group.kind.functions
    ]


def data(absolute: Absolute, functions: Mapping[str, Any]) -> list[Data]:
    """The data of all groups; arguments as of :func:`forms`."""
    found = []
    for k, group in enumerate(absolute.groups):
        own = 0 if group.own is None else group.own.shape[1]
        entry = functions[common_name(k, group)] if group.common is not None else None
        shape = group.common.outputs[0].shape if group.common is not None else (0,)
        found.append(Data(entry, len(shape) == 1, shape[-1], own, len(group)))
    return found


def tables(absolute: Absolute, functions: Mapping[str, Any], planned: Planned) -> str:
    """The file.

    Args:
        absolute: The equations.
        functions: Those of the manifest.
        planned: What is known of the matrices.
    """
    name = comment(absolute.system.name)
    lines = [
        "/*",
        f" * tables.h: elements of model '{name}', which places they couple, and the plan of its",
        " * matrices; what every table means stands in mesh.h and sparse.h.",
        " */",
        "#ifndef CARDAN_TABLES_H",
        "#define CARDAN_TABLES_H",
        "",
        '#include "functions.h"',
        "",
        "/* a function of the elements of a group */",
        "typedef struct form {",
        "    ptrdiff_t group, form;",
        "    cardan_function function;",
        "    void (*prepare)(const wreal *p, wreal *w);",
        "    ptrdiff_t nw, size, work; /* numbers prepared per element, of results, of work */",
        "} form;",
        "",
        "/* the data of an element: some follow from the parameters, some are its own */",
        "typedef struct data {",
        "    cardan_function function;",
        "    void (*prepare)(const wreal *p, wreal *w);",
        "    ptrdiff_t size, nw; /* numbers of results and prepared ones */",
        "    ptrdiff_t each, alike; /* how many of the results an element has; 1: all the same */",
        "    const real *own; /* (count, more) */",
        "    ptrdiff_t more;",
        "} data;",
        "",
        *_declared(absolute, functions),
        *_places(absolute),
        *_groups(absolute, planned),
        *_matrices(planned),
        *_mesh(absolute, functions),
        "/* group, form, function, what prepares it, sizes */",
        *_rows("form", "forms", [*(form.row for form in forms(absolute, functions)), END]),
        "/* function, what prepares it, sizes, own numbers; by group */",
        *_rows("data", "data_of", [d.row(k) for k, d in enumerate(data(absolute, functions))]),
        "#endif",
    ]
    return "\n".join(lines) + "\n"


def _declared(absolute: Absolute, functions: Mapping[str, Any]) -> Iterator[str]:
    """Prototypes of the functions of elements."""
    used = [row.entry["symbol"] for row in forms(absolute, functions)]
    used += [row.common["symbol"] for row in data(absolute, functions) if row.common is not None]
    for kind in absolute.places.kinds:
        used += [kind.functions[way].name for way in WAYS if way in kind.functions]
    for symbol in dict.fromkeys(used):
        yield f"CARDAN_API int {symbol}(const cardan_in *in, real *out, real *work);"
        yield f"CARDAN_API void prepare_{symbol}(const wreal *p, wreal *w);"
    yield ""


def _places(absolute: Absolute) -> Iterator[str]:
    """Where the numbers of places begin, and which places are what."""
    places = absolute.places
    yield f"/* {len(places)} places: where their numbers begin, which of them are poses */"
    yield from array("starts_q", places.q)
    yield from array("starts_u", places.u)
    yield from array("node", nodes(absolute, flat=False))
    yield from array("flat", nodes(absolute, flat=True))
    rows = []
    for k, kind in moving(absolute):
        own = np.flatnonzero(places.kind == k)
        yield from array(f"moving_{k}", own)
        ways = [kind.functions[way].name if way in kind.functions else "NULL" for way in WAYS]
        counts = f"{len(own)}, {kind.nq}, {kind.nu}"
        rows.append(f"{{{counts}, {_pointer(f'moving_{k}', own)}, {', '.join(ways)}, NULL, NULL}}")
    yield "/* places that are no poses: how many, their numbers, which, what moves them */"
    yield from _rows("cardan_movers", "moving", rows)


def nodes(absolute: Absolute, flat: bool) -> Any:
    """Places that are nodes, those of a plane or all others."""
    kinds = absolute.places.kinds
    having = [k for k, x in enumerate(kinds) if (x.plane is not None if flat else x.name == NODE)]
    return np.flatnonzero(np.isin(absolute.places.kind, having))


def moving(absolute: Absolute) -> list[tuple[int, BlockKind]]:
    """Kinds of places that are no poses, with their numbers."""
    return [(k, kind) for k, kind in enumerate(absolute.places.kinds) if kind.name != NODE]


def _groups(absolute: Absolute, planned: Planned) -> Iterator[str]:
    """The elements, group by group."""
    rows, begin = list[str](), 0
    for k, (group, spots) in enumerate(zip(absolute.groups, planned.spots, strict=True)):
        kind = group.kind
        own: dict[str, Any] = {"place": group.places, "rows": group.rows}
        own |= {"z": group.z, "s": group.s, "spots": spots, "powers": group.powers}
        own |= {"outputs": group.outputs, "own": group.own}
        own["parts"] = np.array([parts(kind.functions).get(name, -1) for name in PARTS])
        yield f"/* {len(group)} of kind {comment(kind.name)} */"
        for name, table in own.items():
            yield from array(f"{name}_{k}", table)
        more = inner(kind)
        counts = [len(group), group.places.shape[1], kind.nq, kind.nu, _width(group.z)]
        counts += [_width(group.s), kind.mp, kind.m, more, begin if more else 0]
        begin += more * len(group)
        told = [_pointer(f"{name}_{k}", own[name]) for name in OF_GROUP]
        rows.append(f"{{{', '.join(map(str, counts))},\n     {', '.join(told)}, {{{{0}}}}}}")
        yield ""
    yield "/* the groups, without what is prepared of their data */"
    yield from _rows("cardan_group", "grouped", rows)
    summed = [_pointer(f"outputs_{k}", group.outputs) for k, group in enumerate(absolute.groups)]
    yield "/* which outputs of the scene the results of the elements of a group are */"
    yield from _rows("ptrdiff_t *const", "output_of", summed or ["NULL"])


def _width(table: Any) -> int:
    return 0 if table is None else int(table.shape[1])


def _matrices(planned: Planned) -> Iterator[str]:
    """The plan of the matrices."""
    for name, table in planned.tables.items():
        yield from array(f"plan_{name}", table, RECORDS.get(name, "int32_t"))
    yield "static const cardan_sparse plan = {"
    yield from (f"    .{name} = {number}," for name, number in planned.numbers.items())
    for name, table in planned.tables.items():
        yield f"    .{name} = {_pointer(f'plan_{name}', table)},"
    yield from ("};", "")
    yield from array("unknown", planned.unknown)
    yield from array("diagonal", planned.diagonal)
    yield ""


def _mesh(absolute: Absolute, functions: Mapping[str, Any]) -> Iterator[str]:
    """The whole, without what is prepared for some parameters."""
    blocks, places = sizes(absolute), absolute.places
    flat = {flat: nodes(absolute, flat) for flat in (False, True)}
    works = (int(entry["work_size"]) for entry in functions.values())
    fields: dict[str, Any] = dict(blocks)
    fields |= {"places": len(places), "nodes": len(flat[False]), "flats": len(flat[True])}
    fields |= {"q": "starts_q", "u": "starts_u"}
    fields |= {"node": _pointer("node", flat[False]), "flat": _pointer("flat", flat[True])}
    fields |= {"group_count": len(absolute.groups), "mover_count": len(moving(absolute))}
    fields |= {"movers": "moving", "plan": "&plan"}
    fields["unknown"] = "unknown" if blocks["m"] else "NULL"
    fields["diagonal"] = "diagonal" if blocks["nu"] else "NULL"
    fields |= {"lanes": 1, "work": max(works, default=0), "local": _local(absolute, functions)}
    fields["powers"] = len(absolute.powers)
    fields["driven"] = int(any(name.endswith(".motion") for name in absolute.powers))
    yield "static const cardan_mesh whole = {"
    yield from (f"    .{name} = {value}," for name, value in fields.items())
    yield from ("};", "")


def sizes(absolute: Absolute) -> dict[str, int]:
    """Lengths of the blocks."""
    known = defaults(absolute.system)
    blocks = {f"n{letter}": len(known[letter]) for letter in "zsr"}
    blocks |= {"nq": absolute.places.nq, "nu": absolute.places.nu}
    return blocks | {"mp": absolute.mp, "m": len(absolute.multipliers)}


def _local(absolute: Absolute, functions: Mapping[str, Any]) -> int:
    """Numbers that an element reads, and gives at most."""
    found = 0
    for group in absolute.groups:
        kind = group.kind
        results = (int(functions[f.name]["output_size"]) for f in kind.functions.values())
        reads = kind.nq + 3 * kind.nu + kind.m + _width(group.z) + _width(group.s) + inner(kind)
        found = max(found, reads + max(results, default=0))
    return found


def inner(kind: Kind) -> int:
    """Unknowns of its own that an element has in a search."""
    step = kind.functions.get("mixed_step")
    return 0 if step is None else sum(output.size for output in step.outputs)


def _rows(kind: str, name: str, rows: Sequence[str]) -> Iterator[str]:
    """A table of records; one of zeros where there are none, as C wants one."""
    yield f"static const {kind} {name}[] = {{"
    yield from (f"    {row}," for row in rows or ["{0}"])
    yield from ("};", "")


def array(name: str, table: Any, kind: str = "") -> Iterator[str]:
    """Lines of a table; none where it is empty."""
    if table is None or not table.size:
        return
    real = table.dtype.kind == "f"
    yield f"static const {kind or ('real' if real else 'ptrdiff_t')} {name}[] = {{"
    if kind in RECORDS.values():
        numbers: Iterable[str] = (f"{{{', '.join(map(str, row))}}}" for row in table.tolist())
    else:
        numbers = map(repr, table.ravel().tolist())
    yield from wrapped(numbers)
    yield "};"


def wrapped(numbers: Iterable[str]) -> Iterator[str]:
    """Numbers of a table, some to a line."""
    listed = list(numbers)
    for k in range(0, len(listed), PER_LINE):
        yield "    " + ", ".join(listed[k : k + PER_LINE]) + ","


def _pointer(name: str, table: Any) -> str:
    return name if table is not None and table.size else "NULL"
