"""``functions.h`` of an export of elements in tables: what these give together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from ...equations.finite_elements.record import FiniteElementRecord
from ...schema.c_functions import FunctionRow
from ...schema.planned import Planned
from ..header import Exported
from . import tables_header


class AssembledFunction(NamedTuple):
    """A function of the whole model: what it gives, the blocks it reads, how many numbers in C."""

    about: str
    reads: tuple[str, ...]
    size: str


STATE = ("t", "q", "u", "z", "s", "r")
BALANCED = (*STATE[:3], "udot", "lam", *STATE[3:])
ASSEMBLED = {
    "rhs": AssembledFunction(
        "derivative of the state: qdot, udot, zdot", STATE, "cardan_nq + cardan_nu + cardan_nz"
    ),
    "forward_dynamics": AssembledFunction(
        "accelerations udot, then the multipliers lam", (*STATE, "tau"), "cardan_nu + cardan_nlam"
    ),
    "balance": AssembledFunction(
        "M udot + h - f - G^T lam, gaps of positions, of speeds",
        BALANCED,
        "cardan_nu + cardan_npositions + cardan_nlam",
    ),
    "mass_matrix": AssembledFunction(
        "values of [M G^T; G 0], sparse: see model_pattern", STATE, "cardan_nvalues"
    ),
    "energy": AssembledFunction("kinetic, potential and their sum", STATE, "3"),
    "momentum": AssembledFunction(
        "angular momentum about the origin of the ground, then linear", STATE, "6"
    ),
    "power": AssembledFunction("power of every source", STATE, "cardan_npowers"),
    "outputs": AssembledFunction("outputs of the scene", BALANCED, "cardan_noutputs"),
    "qdot": AssembledFunction("rates of the coordinates", ("q", "u"), "cardan_nq"),
    "move": AssembledFunction(
        "coordinates moved by du along the speeds, then a rotation (3, 3) for every place",
        ("q", "du"),
        "cardan_nq + 9 * cardan_nplaces",
    ),
    "close_position": AssembledFunction(
        "coordinates a step nearer to closing all loops, then how open they were",
        (*STATE, "tau"),
        "cardan_nq + cardan_npositions",
    ),
    "close_velocity": AssembledFunction(
        "speeds that the constraints allow, then what the given ones missed",
        (*STATE, "tau"),
        "cardan_nu + cardan_nlam",
    ),
    "events": AssembledFunction(
        "values of the events, which happen where they fall through zero", STATE, "cardan_nevents"
    ),
    "transition": AssembledFunction(
        "speeds, internal states and modes behind the events e",
        (*STATE, "e"),
        "cardan_nu + cardan_nz + cardan_ns",
    ),
}
EVENT_FUNCTIONS = ("events", "transition")


def available(absolute: FiniteElementRecord) -> tuple[str, ...]:
    """Names of the functions that a model has as a whole."""
    without = () if absolute.system.events else EVENT_FUNCTIONS
    return tuple(name for name in ASSEMBLED if name not in without)


def exported(names: Sequence[str], example: str) -> dict[str, Exported]:
    """Functions of the whole model, the one that the example shows first."""
    functions = {name: ASSEMBLED[name] for name in dict.fromkeys((example, *names))}
    return {name: Exported(w.about, w.reads, {"out": w.size}) for name, w in functions.items()}


def declared(
    absolute: FiniteElementRecord,
    entries: Mapping[str, FunctionRow],
    planned: Planned,
    names: Sequence[str],
) -> list[str]:
    """Lines of ``functions.h``: sizes, the model as a record, the list of its functions.

    Args:
        absolute: The equations.
        entries: Functions of the manifest.
        planned: What is known of its matrices.
        names: Functions of the whole model.
    """
    numbers = sum(tables_header.rooms(absolute, entries))
    sizes = {
        "nlam": (len(absolute.multipliers), "multipliers: those of positions, then the others"),
        "npositions": (absolute.mp, "constraints of positions"),
        "nplaces": (len(absolute.places), "places: nodes and joints"),
        "noutputs": (len(absolute.results), "outputs"),
        "npowers": (len(absolute.powers), "sources of power"),
        "nevents": (len(absolute.system.events), "events"),
        "nunknowns": (planned.plan["n"], "speeds and multipliers"),
        "nvalues": (planned.plan["values"], "numbers of the sparse matrix"),
        "ngroups": (len(absolute.groups), "groups of elements"),
        "nnumbers": (numbers, "numbers of elements"),
    }
    listed = [f"    cardan_{name} = {n}, /* {about} */" for name, (n, about) in sizes.items()]
    # no comma behind the last
    listed[-1] = listed[-1].replace(", /*", " /*", 1)
    calls = [f"F({name}, cardan_mesh_call_{name})" for name in names]
    return [
        *("", "enum {", *listed, "};", '#include "elements.h"', ""),
        "/* functions of the whole model, and what of the kernels each of them is */",
        f"#define CARDAN_ELEMENT_CALLS(F) {' '.join(calls)}",
    ]
