"""``model.h`` and ``model.c``: sizes, places of entries by name, values to start from, for C."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..ir.rows import Rows
from .naming import Names, comment, mangle

BLOCKS = (
    ("q", "coordinates", "generalized coordinates"),
    ("u", "speeds", "generalized speeds"),
    ("r", "inputs", "inputs"),
    ("p", "parameters", "parameters"),
)


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
    sizes = [f"    cardan_n{b} = {len(manifest[key])}" for b, key, _ in BLOCKS]
    sizes.append(f"    cardan_nbodies = {len(manifest['bodies'])}")
    parts = sum(len(body["parts"]) for body in manifest["bodies"])
    sizes.append(f"    cardan_nparts = {parts}")
    lines += [*(f"{size}," for size in sizes[:-1]), sizes[-1], "};"]
    for block, key, meaning in BLOCKS:
        if manifest[key]:
            lines += ["", f"/* {meaning} */", "enum {"]
            lines += [*_entries(block, manifest[key], names), "};"]
    return "\n".join([*lines, "", "#endif"]) + "\n"


def defaults(
    manifest: dict[str, Any],
    start: Sequence[float] | None = None,
    speeds: Sequence[float] | None = None,
) -> str:
    """``model.c``: values of the parameters, coordinates and inputs that the scene names.

    Args:
        manifest: Of the model.
        start: Coordinates (nq,) to start from instead of those that the scene names.
        speeds: Speeds (nu,) to start with; without them there is no such array.
    """
    lines = [
        "/*",
        f" * model.c: values of model '{comment(manifest['name'])}' to start from.",
        " */",
        '#include "functions.h"',
    ]
    for block, key, meaning in BLOCKS:
        if block == "u" and speeds is None:
            continue
        lines += ["", f"/* {meaning} */", f"const double {array(block)} = {{"]
        # an array has at least one element in C
        rows = manifest[key] or [{"name": "nothing", "unit": "", "default": 0.0}]
        if block == "q" and manifest[key]:
            rows = _start(manifest)
            if start is not None:
                rows = [{**row, "default": x} for row, x in zip(rows, start, strict=True)]
        if block == "u" and speeds:
            rows = [{**row, "default": x} for row, x in zip(rows, speeds, strict=True)]
        for row in rows:
            unit = f" [{row['unit']}]" if row["unit"] else ""
            lines.append(f"    {float(row['default'])!r}, /* {comment(row['name'] + unit)} */")
        lines.append("};")
    return "\n".join(lines) + "\n"


def _start(manifest: dict[str, Any]) -> list[dict[str, Any]]:
    """Coordinates with the initial values that the scene gives its joints."""
    rows = [dict(row) for row in manifest["coordinates"]]
    for joint in manifest["joints"]:
        if joint["q"] and joint["q0"]:
            for k, value in enumerate(joint["q0"], joint["q"][0]):
                rows[k]["default"] = value
    return rows


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
