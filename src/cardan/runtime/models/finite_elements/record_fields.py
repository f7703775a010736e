"""Fields of the records of a mesh: what loaded elements and exports of them fill in alike.

Numbers stand as they are, arrays for the pointers to them; what is prepared of parameters is not
among them.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ....schema.c_functions import FunctionRow
from ....schema.finite_elements import ElementKind
from ....schema.planned import Fields
from ....schema.records import PARTS
from ...sparse.matrices import Matrices
from .elements import INNER
from .tables import Tables

SIZES = ("nq", "nu", "nz", "ns", "mp", "m")


def group_fields(tables: Tables) -> list[Fields]:
    """Fields of every ``cardan_group``, without its forms."""
    listed, inner_start = list[Fields](), 0
    for group, rows, spots in zip(
        tables.groups, tables.rows, tables.once(Matrices.of).spots, strict=True
    ):
        kind = group.kind
        inner = INNER if "mixed" in kind.functions else 0
        fields = {
            "count": len(group),
            "places": group.place.shape[1],
            **{name: getattr(kind, name) for name in SIZES},
            "switched": kind.released,
            "z_states": kind.states[0],
            "s_states": kind.states[1],
            **{name: getattr(kind, name) for name in ("ne", "jumps", "responses", "frictions")},
            "inner": inner,
            "inner_start": inner_start if inner else 0,
            "place": group.place.astype(np.intp),
            "rows": rows,
            "spots": spots,
            **{name: getattr(group, name) for name in ("z", "s", "events", "powers", "outputs")},
            "parts": np.array([kind.parts.get(name, -1) for name in PARTS], dtype=np.intp),
        }
        listed.append(fields)
        inner_start += inner * len(group)
    return listed


def mover_fields(tables: Tables) -> list[tuple[Fields, dict[str, str]]]:
    """Fields of every ``cardan_movers``, and the C names of its functions."""
    listed = list[tuple[Fields, dict[str, str]]]()
    for k, kind in enumerate(tables.kinds):
        if kind.name == "node":
            continue
        places = np.flatnonzero(tables.kind == k).astype(np.intp)
        fields: Fields = {"count": len(places), "nq": kind.nq, "nu": kind.nu, "place": places}
        named = (("move", "move"), ("rates", "qdot"))
        functions = {f: kind.functions[name] for f, name in named if name in kind.functions}
        listed.append((fields, functions))
    return listed


def mesh_fields(tables: Tables, entries: Mapping[str, FunctionRow]) -> Fields:
    """Fields of ``cardan_mesh``, without its groups, its movers and its plan.

    Args:
        tables: The elements.
        entries: C name -> what the manifest says about a function.
    """
    matrices = tables.once(Matrices.of)
    nodes, flats = (tables.nodes(flat).astype(np.intp) for flat in (False, True))
    return {
        **{name: getattr(tables, name) for name in (*SIZES, "nr", "q", "u")},
        "places": len(tables.kind),
        "nodes": len(nodes),
        "node": nodes,
        "flats": len(flats),
        "flat": flats,
        "unknown": matrices.unknown,
        "diagonal": matrices.diagonal,
        "work": max((entry.work_size for entry in entries.values()), default=0),
        "local": max((_local(group.kind, entries) for group in tables.groups), default=0),
        "powers": len(tables.powers),
        "driven": int(
            tables.driven or any(_reads(g.kind, "power", entries) for g in tables.groups)
        ),
        "outputs": tables.outputs,
        "solved": int(any(_reads(g.kind, "outputs", entries) for g in tables.groups)),
        "ne": tables.ne,
        "jumps": sum(len(group) * group.kind.jumps for group in tables.groups),
        "responses": sum(len(group) * group.kind.responses for group in tables.groups),
        "frictions": sum(len(group) * group.kind.frictions for group in tables.groups),
    }


def _reads(kind: ElementKind, form: str, entries: Mapping[str, FunctionRow]) -> bool:
    """True when a function of a kind depends on accelerations or multipliers."""
    symbol = kind.functions.get(form)
    return symbol is not None and not {"udot", "lam"}.isdisjoint(entries[symbol].inputs)


def _local(kind: ElementKind, entries: Mapping[str, FunctionRow]) -> int:
    """Numbers that an element reads, and gives at most."""
    reads = kind.nq + 3 * kind.nu + kind.m + kind.nz + kind.ns + INNER
    reads += kind.ne + kind.frictions + kind.responses
    return reads + max((entries[x].output_size for x in kind.functions.values()), default=0)
