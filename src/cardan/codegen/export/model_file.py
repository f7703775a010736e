"""``model.c``: values of a scene to start from, and all that a run must know as one constant."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import Any

from ...records import dataclass
from ...schema.blocks import BLOCKS
from ...schema.integrators import KERNELS
from ...schema.manifest import Manifest
from ...schema.rows import column
from ..header import VALUES, Exported, array
from ..program.naming import comment
from ..program.program import Program
from . import gradient
from .constants import Constants, Declarations, Name, Value

# where none are asked for: tolerances of a run, and the step of methods that choose none [s]
TOLERANCES = {"rtol": 1e-9, "atol": 1e-12}
STEP = 1e-3


@dataclass(frozen=True)
class Content:
    """Contents of an export of one kind of coordinates.

    Attributes:
        functions: By name; the first is the one that the example shows.
        start: Values to start from instead of those that the scene names, by block.
        fields: Fields of ``cardan_export``.
        columns: What speeds count in (nu,); nothing: all in 1.
        tolerances: Tolerances other than the usual ones, by method.
        declared: More lines of ``functions.h``.
        files: More files, by name.
        programs: Its functions, for bindings that are written from them.
        cost: ``cardan_exported_cost``, None without gradients.
    """

    functions: Mapping[str, Exported]
    start: Mapping[str, Sequence[float]]
    fields: Mapping[str, Value] = field(default_factory=dict)
    columns: Any = ()
    tolerances: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    declared: Sequence[str] = ()
    files: Mapping[str, str] = field(default_factory=dict)
    programs: Sequence[Program] = ()
    cost: Value = None


def text(manifest: Manifest, content: Content, integrators: Sequence[str]) -> str:
    """The file.

    Args:
        manifest: Of the model.
        content: Of the export.
        integrators: Methods of the export, by their kernels.
    """
    element_fields, name = content.fields, comment(manifest.name)
    c = Constants(
        "/*",
        f" * model.c: values of model '{name}' to start from; the model as one",
        " * constant.",
        " */",
        f'#include "{"tables.h" if element_fields.get("elements") else "functions.h"}"',
    )
    declare(c, manifest, content, integrators)
    return c.text


def declare(
    c: Declarations, manifest: Manifest, content: Content, integrators: Sequence[str]
) -> None:
    """Declare values to start from and ``cardan_scene``; arguments as of :func:`text`.

    Args:
        c: Where they are declared.
        manifest, content, integrators: As above.
    """
    functions = content.functions
    for block in VALUES:
        values = content.start.get(block) or starts(manifest, block)
        rows = manifest.block(block)
        names = [row.name + (f" [{row.unit}]" if row.unit else "") for row in rows]
        c.say(BLOCKS[block].meaning)
        c.named(f"const double {array(block)}", values, map(comment, names))
    for one in integrators:
        c.external(f"const cardan_method cardan_{one}_method")
    methods = [
        _method(one, {**TOLERANCES, **content.tolerances.get(one, {})}) for one in integrators
    ]
    for one, row in zip(integrators if content.cost else (), methods, strict=False):
        row |= _tables(c, one)
    quaternions, costs = manifest.quaternions, [content.cost] if content.cost else []
    c.say("all that a run must know of the model")
    fields: dict[str, Value] = {
        "name": manifest.name,
        **{f"n{block}": len(manifest.block(block)) for block in VALUES if block != "p"},
        "zeros": _zeros(manifest),
        **{block: Name(f"cardan_default_{block}") for block in VALUES},
        "functions": c.records("cardan_exported_function", "scene_functions", _rows(functions)),
        "function_count": len(functions),
        "methods": c.records("cardan_exported_method", "scene_methods", methods),
        "method_count": len(methods),
        "quaternions": c.numbers("quaternions", list(quaternions)),
        "quaternion_count": len(quaternions),
        **_constraints(manifest),
        "size": 1.0,
        "columns": c.numbers("columns", content.columns),
        **(
            _events(c, manifest) if integrators and {"events", "transition"} <= {*functions} else {}
        ),
        "cost": c.records("cardan_exported_cost", "scene_cost", costs),
        **content.fields,
    }
    c.record("const cardan_export cardan_scene", fields)


def starts(manifest: Manifest, block: str) -> list[float]:
    """Values of a block where the scene starts."""
    values = [float(x) for x in column(manifest.block(block), "default")]
    for joint in manifest.joints if block in "qu" else ():
        first, initial = (joint.q, joint.q0) if block == "q" else (joint.u, joint.u0)
        if first and initial:
            values[first[0] : first[0] + len(initial)] = map(float, initial)
    return values


def _rows(functions: Mapping[str, Exported]) -> list[Value]:
    rows: list[Value] = []
    for name, entry in functions.items():
        sizes = {k: Name(f"{name}_{k}_size") for k in entry.sizes}
        row: dict[str, Value] = {"name": name, "function": Name(name), **sizes}
        rows.append(row | ({"prepare": Name(f"prepare_{name}")} if "w" in sizes else {}))
    return rows


def _tables(c: Declarations, name: str) -> dict[str, Value]:
    """Coefficients of a method, for sweeps over its steps."""
    table = f"cardan_{name}_tableau"
    c.external(f"ptrdiff_t {table}(real *nodes, real *weights, real *matrix)")
    if not gradient.METHODS[name]:
        return {"tableau": Name(table)}
    c.external("const struct cardan_coupled cardan_coupled_stages")
    return {"tableau": Name(table), "coupled": Name("&cardan_coupled_stages")}


def _method(name: str, tolerances: Mapping[str, float]) -> dict[str, Value]:
    record = KERNELS[name]
    fixed = {} if record.adaptive else {"step": STEP}
    return {
        "name": name,
        "method": Name(f"&cardan_{name}_method"),
        **tolerances,
        **fixed,
        "charted": record.charted,
    }


def _zeros(manifest: Manifest) -> int:
    """Length of what stands for everything that is zero."""
    parts = sum(len(body.parts) for body in manifest.bodies)
    blocks = (*map(manifest.block, "uqzs"), manifest.events, manifest.multipliers)
    vectors = (len(row.vector) for row in manifest.functions.values())
    return max(6 * parts, 1, *map(len, blocks), *vectors)


def _constraints(manifest: Manifest) -> dict[str, Value]:
    """Rows that runs keep closed, those of positions among them."""
    rows = manifest.multipliers if manifest.projected else ()
    positions = sum(row.level == "position" for row in rows)
    return {"positions": positions, "rates": len(rows)}


def _events(c: Declarations, manifest: Manifest) -> dict[str, Value]:
    """Event tables: kinds, signs and sample times."""
    modes, rows, kinds = [row.name for row in manifest.s], list[Value](), list[Value]()
    for row in manifest.events:
        mode, value = next(iter(row.decides.items()), ("", 0.0))
        place = modes.index(mode) if mode else -1
        rows.append({"name": row.name, "mode": place, "first": float(value)})
        kinds.append(Name(f"CARDAN_{row.kind.upper()}"))
    ticks: list[Value] = [
        {"event": tick.event, "period": float(tick.period), "phase": float(tick.phase)}
        for tick in manifest.ticks
    ]
    return {
        "events": c.records("cardan_exported_event", "scene_events", rows),
        "kinds": c.records("ptrdiff_t", "scene_kinds", kinds),
        "event_count": len(rows),
        "ticks": c.records("cardan_exported_tick", "scene_ticks", ticks),
        "tick_count": len(ticks),
    }
