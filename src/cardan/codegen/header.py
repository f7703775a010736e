"""``model.h`` and ``functions.h``: sizes, places of entries by name, prototypes, for C."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from ..schema.c_functions import FunctionRow, ResultRow
from ..schema.entries import Entry
from ..schema.manifest import Manifest
from ..schema.rows import Rows
from .program.naming import Names, comment, comments, mangled

BLOCKS = {
    "q": "generalized coordinates",
    "u": "generalized speeds",
    "r": "inputs",
    "p": "parameters",
}
# those with values at the start
VALUES = (*BLOCKS, "z", "s")


class Exported(NamedTuple):
    """Description of a function in an export.

    Attributes:
        about: What it gives, in words.
        inputs: The blocks that it reads.
        sizes: Length of ``out``, ``work`` and ``w``, as C has them; those without ``w`` read
            elements, which are prepared together.
        outputs: Its results by name and shape, where they are known.
        vector: Length of the block v, which every function has entries of its own in.
    """

    about: str
    inputs: Sequence[str]
    sizes: Mapping[str, int | str]
    outputs: Sequence[ResultRow] = ()
    vector: int = 0

    @staticmethod
    def of(row: FunctionRow) -> Exported:
        """The description from a row of the manifest."""
        sizes = {"out": row.output_size, "work": row.work_size, "w": row.prepared_size}
        return Exported(row.about, row.inputs, sizes, row.outputs, len(row.vector))


def slots(manifest: Manifest) -> str:
    """The header: sizes, and per block an enumeration ``<block>_<name>`` with units."""
    names = Names()
    lines = [
        "/*",
        f" * model.h: places of the entries of model '{comment(manifest.name)}'.",
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
    sizes = [f"    cardan_n{b} = {len(manifest.block(b))}" for b in VALUES]
    sizes.append(f"    cardan_nbodies = {len(manifest.bodies)}")
    parts = sum(len(body.parts) for body in manifest.bodies)
    sizes.append(f"    cardan_nparts = {parts}")
    lines += [*(f"{size}," for size in sizes[:-1]), sizes[-1], "};"]
    for block, meaning in BLOCKS.items():
        if manifest.block(block):
            lines += ["", f"/* {meaning} */", "enum {"]
            lines += [*_entries(block, manifest.block(block), names), "};"]
    return "\n".join([*lines, "", "#endif"]) + "\n"


def array(block: str) -> str:
    """C declaration of the values of a block, in ``model.c`` and in ``functions.h``."""
    return f"cardan_default_{block}[cardan_n{block} + (cardan_n{block} == 0)]"


def _entries(block: str, rows: Sequence[Entry], names: Names) -> list[str]:
    """Lines of an enumeration; of runs of rows only the first of each kind."""
    listed = list(enumerate(rows.listed if isinstance(rows, Rows) else rows))
    repeated: dict[int, str] = {}
    start = len(listed)
    for run in rows.runs if isinstance(rows, Rows) else ():
        listed += [(start + k, run.row(k)) for k in range(len(run.pattern))]
        repeated |= dict.fromkeys(
            range(start, start + len(run.pattern)),
            f"; {run.count} of them, {len(run.pattern)} apart",
        )
        start += len(run)
    abouts = [
        f"{row.name} [{row.unit}]{repeated.get(k, '')}"
        if row.unit
        else row.name + repeated.get(k, "")
        for k, row in listed
    ]
    bases = [f"{block}_{name}" for name in mangled([row.name for _, row in listed])]
    signs = [","] * (len(listed) - 1) + [""]
    return [
        f"    {name} = {k}{comma} /* {about} */"
        for (k, _), name, comma, about in zip(
            listed, names.several(bases), signs, comments(abouts), strict=True
        )
    ]


def prototypes(
    name: str, functions: Mapping[str, Exported], headers: Sequence[str], more: Sequence[str] = ()
) -> str:
    """``functions.h``: the functions of an export, with the sizes a caller must provide.

    Args:
        name: Of the model.
        functions: Its functions by name.
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
    for symbol, entry in functions.items():
        sizes = [f"    {symbol}_{k}_size = {size}" for k, size in entry.sizes.items()]
        sizes += [f"    {symbol}_v_size = {entry.vector}"] if entry.vector else []
        reads = ", ".join(entry.inputs) or "nothing"
        lines += ["", f"/* {comment(entry.about or symbol)}; reads {reads} */"]
        lines += ["enum {", ",\n".join(sizes), "};"]
        lines.append(f"CARDAN_API int {symbol}(const cardan_in *in, real *out, real *work);")
        if "w" in entry.sizes:
            lines.append(f"CARDAN_API void prepare_{symbol}(const wreal *p, wreal *w);")
    return "\n".join([*lines, "", "#endif"]) + "\n"
