"""``model.h``: the sizes of a model and the places of its entries, by name, for C programmers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

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
    lines += [*(f"{size}," for size in sizes[:-1]), sizes[-1], "};"]
    for block, key, meaning in BLOCKS:
        if manifest[key]:
            lines += ["", f"/* {meaning} */", "enum {"]
            lines += [*_entries(block, manifest[key], names), "};"]
    return "\n".join([*lines, "", "#endif"]) + "\n"


def _entries(block: str, rows: Sequence[dict[str, Any]], names: Names) -> list[str]:
    """Lines of an enumeration."""
    lines = []
    for k, row in enumerate(rows):
        unit = f" [{row['unit']}]" if row["unit"] else ""
        comma = "," if k + 1 < len(rows) else ""
        name = names.new(f"{block}_{mangle(row['name'])}")
        lines.append(f"    {name} = {k}{comma} /* {comment(row['name'] + unit)} */")
    return lines
