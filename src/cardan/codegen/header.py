"""``model.h`` and ``functions.h``: sizes, places of entries by name, prototypes, for C."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

from ..ir.rows import Rows
from .naming import Names, comment, mangle

BLOCKS = (
    ("q", "coordinates", "generalized coordinates"),
    ("u", "speeds", "generalized speeds"),
    ("r", "inputs", "inputs"),
    ("p", "parameters", "parameters"),
)


# sizes of a function in C and in manifests
SIZES = {"out": "output_size", "work": "work_size", "w": "prepared_size"}
# where the manifest has the values of a block at the start
VALUES = {
    **{block: key for block, key, _ in BLOCKS},
    "z": "z",
    "s": "s",
}


Entry: TypeAlias = Mapping[str, Any]


def slots(manifest: dict[str, Any]) -> str:
    """The header: sizes, and per block an enumeration ``<block>_<name>`` with units."""
    names = Names()
    lines = [
        "/*",
        f" * model.h: places of the entries of model '{comment(manifest['name'])}'.",
        " *",
        " * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.",
        " */",
        "#ifndef CARDAN_MODEL_H",
        "#define CARDAN_MODEL_H",
        "",
        '#include "cardan.h"',
        "",
        "/* sizes */",
        "enum {",
    ]
    sizes = [f"    cardan_n{b} = {len(manifest[key])}" for b, key in VALUES.items()]
    sizes.append(f"    cardan_nbodies = {len(manifest['bodies'])}")
    parts = sum(len(body["parts"]) for body in manifest["bodies"])
    sizes.append(f"    cardan_nparts = {parts}")
    lines += [*(f"{size}," for size in sizes[:-1]), sizes[-1], "};"]
    for block, key, meaning in BLOCKS:
        if manifest[key]:
            lines += ["", f"/* {meaning} */", "enum {"]
            lines += [*_entries(block, manifest[key], names), "};"]
    return "\n".join([*lines, "", "#endif"]) + "\n"


def array(block: str) -> str:
    """How the values of a block are declared, in ``model.c`` and in ``functions.h``."""
    return f"cardan_default_{block}[cardan_n{block} + (cardan_n{block} == 0)]"


def _entries(block: str, rows: Sequence[dict[str, Any]], names: Names) -> list[str]:
    """Lines of an enumeration; of runs of rows only the first of each kind."""
    told = list(enumerate(rows.listed if isinstance(rows, Rows) else rows))
    repeated: dict[int, str] = {}
    start = len(told)
    for run in rows.runs if isinstance(rows, Rows) else ():
        told += [(start + k, run.row(k)) for k in range(len(run.pattern))]
        repeated |= dict.fromkeys(
            range(start, start + len(run.pattern)),
            f"; {run.count} of them, {len(run.pattern)} apart",
        )
        start += len(run)
    lines = []
    for k, row in told:
        about = row["name"] + (f" [{row['unit']}]" if row["unit"] else "") + repeated.get(k, "")
        comma = "," if k != told[-1][0] else ""
        name = names.new(f"{block}_{mangle(row['name'])}")
        lines.append(f"    {name} = {k}{comma} /* {comment(about)} */")
    return lines


def prototypes(
    name: str, functions: Mapping[str, Entry], headers: Sequence[str], more: Sequence[str] = ()
) -> str:
    """``functions.h``: the functions of an export, with the sizes a caller must provide.

    Args:
        name: Of the model.
        functions: What manifests say of its functions; those without ``prepared_size`` read
            elements, which are prepared together.
        headers: What it stands on.
        more: Other lines.
    """
    lines = [
        "/*",
        f" * functions.h: what model '{comment(name)}' computes.",
        " *",
        " * out, work and w are arrays of the caller of at least the sizes given here.",
        " */",
        "#ifndef CARDAN_FUNCTIONS_H",
        "#define CARDAN_FUNCTIONS_H",
        "",
        *(f'#include "{header}"' for header in ("model.h", *headers)),
        "",
        "/* model.c: values to start from; all that a run must know of the model */",
        *(f"extern const double {array(block)};" for block in VALUES),
        "extern const cardan_export cardan_scene;",
        *more,
    ]
    for own, entry in functions.items():
        sizes = [f"    {own}_{k}_size = {entry[key]}" for k, key in SIZES.items() if key in entry]
        reads = ", ".join(entry["inputs"]) or "nothing"
        lines += ["", f"/* {comment(entry['about'] or own)}; reads {reads} */"]
        lines += ["enum {", ",\n".join(sizes), "};"]
        lines.append(f"CARDAN_API int {own}(const cardan_in *in, real *out, real *work);")
        if "prepared_size" in entry:
            lines.append(f"CARDAN_API void prepare_{own}(const wreal *p, wreal *w);")
    return "\n".join([*lines, "", "#endif"]) + "\n"
