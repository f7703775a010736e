"""``tables.h``: the places, elements and planned matrices of a model as constants of C.

What every table means stands in ``mesh.h``, ``sparse.h`` and ``mesh_export.h``. One line per table
entry would be read by nobody: numbers follow each other, which compilers take by the million.
"""

from __future__ import annotations

from collections.abc import Mapping

from ...equations.finite_elements.record import FiniteElementRecord, Group
from ...schema.c_functions import FunctionRow
from ...schema.planned import Fields, Planned
from ...schema.records import FORMS
from ..export.constants import Constants, Name, Value
from ..program.naming import comment
from .model_folder import common_name

# tables of the plan whose entries are records
RECORDS = {"load": "cardan_sparse_load", "run": "cardan_sparse_run"}


def functions(
    absolute: FiniteElementRecord, entries: Mapping[str, FunctionRow]
) -> list[dict[str, Value]]:
    """The functions of the elements of all groups, as ``cardan_element_function``.

    Args:
        absolute: The equations.
        entries: Functions of the manifest.
    """
    listed: list[dict[str, Value]] = []
    for k, group in enumerate(absolute.groups):
        for name in FORMS:
            if name in group.kind.functions:
                entry = entries[group.kind.functions[name].name]
                form = Name(f"CARDAN_{name.upper().removeprefix('BALANCE_')}")
                sizes = {"nw": entry.prepared_size, "size": entry.output_size}
                listed.append({"group": k, "form": form, **_called(entry), **sizes})
    return listed


def _called(entry: FunctionRow) -> dict[str, Value]:
    symbol = entry.symbol
    return {"function": Name(symbol), "prepare": Name(f"prepare_{symbol}")}


def rooms(absolute: FiniteElementRecord, entries: Mapping[str, FunctionRow]) -> tuple[int, int]:
    """Numbers that the data of a group take with what finds them, and those that are prepared."""
    data, prepared = 0, 0
    for k, group in enumerate(absolute.groups):
        attributes = 0 if group.attributes is None else group.attributes.shape[1]
        scratch, each = 0, 0
        if group.common is not None:
            entry, each = entries[common_name(k, group)], group.common.outputs[0].shape[-1]
            scratch = entry.output_size + entry.prepared_size + entry.work_size
        data = max(data, (attributes + each) * len(group) + scratch)
        used = (f.name for name, f in group.kind.functions.items() if name in FORMS)
        prepared += len(group) * sum(entries[name].prepared_size for name in used)
    return data, prepared


def tables(
    absolute: FiniteElementRecord, entries: Mapping[str, FunctionRow], planned: Planned
) -> str:
    """The file.

    Args:
        absolute: The equations.
        entries: Functions of the manifest.
        planned: What is known of the matrices.
    """
    c = Constants(
        "/*",
        f" * tables.h: elements of model '{comment(absolute.system.name)}', which places they",
        " * couple, and the plan of its matrices.",
        " */",
        "#ifndef CARDAN_TABLES_H",
        "#define CARDAN_TABLES_H",
        "",
        '#include "functions.h"',
        "",
    )
    called = functions(absolute, entries)
    commons = [
        entries[common_name(k, g)] if g.common else None for k, g in enumerate(absolute.groups)
    ]
    symbols = [str(row["function"]) for row in called]
    symbols += [entry.symbol for entry in commons if entry is not None]
    symbols += [symbol for _, named in planned.movers for symbol in named.values()]
    for symbol in dict.fromkeys(symbols):
        c.lines.append(f"CARDAN_API int {symbol}(const cardan_in *in, real *out, real *work);")
        c.lines.append(f"CARDAN_API void prepare_{symbol}(const wreal *p, wreal *w);")
    data = list[Value]()
    for k, (group, entry) in enumerate(zip(absolute.groups, commons, strict=True)):
        c.say(f"what {len(group)} of kind {comment(group.kind.name)} are given")
        data.append(_data(c, k, group, entry))
    _mesh(c, planned)
    room, nw = rooms(absolute, entries)
    fields: dict[str, Value] = {
        "mesh": Name("&mesh"),
        "functions": c.records("cardan_element_function", "element_functions", called),
        "function_count": len(called),
        "data": c.records("cardan_element_data", "element_data", data),
        "data_room": room,
        "nw": nw,
        "locked": c.numbers("locked", planned.locked.astype(float)),
    }
    c.record("static const cardan_elements elements", fields)
    c.lines += ["", "#endif"]
    return c.text


def _data(c: Constants, k: int, group: Group, entry: FunctionRow | None) -> dict[str, Value]:
    """Data of the elements of a group, as ``cardan_element_data``."""
    fields: dict[str, Value] = {"size": 0}
    if entry is not None and group.common is not None:
        shape = group.common.outputs[0].shape
        fields = _called(entry) | {"size": entry.output_size, "nw": entry.prepared_size}
        fields |= {"each": shape[-1], "alike": len(shape) == 1}
    if group.attributes is not None and group.attributes.size:
        fields |= {
            "attributes": c.numbers(f"attributes_{k}", group.attributes),
            "more": group.attributes.shape[1],
        }
    return fields


def _mesh(c: Constants, planned: Planned) -> None:
    """The mesh, without what is prepared of its groups."""
    c.say("the groups, then places that are not poses, the plan, the whole")
    groups = [_fields(c, each, f"_{k}") for k, each in enumerate(planned.groups)]
    movers = [
        _fields(c, each, f"_of_mover_{k}") | {name: Name(symbol) for name, symbol in named.items()}
        for k, (each, named) in enumerate(planned.movers)
    ]
    c.record("static const cardan_sparse plan", _fields(c, planned.plan, "_of_plan"))
    fields = _fields(c, planned.mesh, "_of_mesh") | {
        "groups": c.records("cardan_group", "groups", groups),
        "group_count": len(groups),
        "movers": c.records("cardan_movers", "movers", movers),
        "mover_count": len(movers),
        "plan": Name("&plan"),
        "lanes": 1,
    }
    c.record("static const cardan_mesh mesh", fields)


def _fields(c: Constants, fields: Fields, ending: str) -> dict[str, Value]:
    """Fields of a record; their tables stand before it under the names of the fields."""
    written: dict[str, Value] = {}
    for name, value in fields.items():
        if value is None or isinstance(value, int):
            written[name] = value
        else:
            written[name] = c.numbers(name + ending, value, RECORDS.get(name, ""))
    return written
