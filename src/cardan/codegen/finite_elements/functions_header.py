"""``functions.h`` of an export of elements in tables: what these give together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from ...equations.finite_elements.record import FiniteElementRecord
from ...schema.c_functions import FunctionRow
from ...schema.planned import Planned
from ..header import Exported
from . import tables_header


class Whole(NamedTuple):
    """A function of the whole model: what it gives, the blocks it reads, how many numbers in C."""

    about: str
    reads: tuple[str, ...]
    size: str


SOLVED = ("t", "q", "u", "s", "r")
WHOLE = {
    "rhs": Whole("derivative of the state: qdot, udot", SOLVED, "cardan_nq + cardan_nu"),
    "forward_dynamics": Whole(
        "accelerations udot, then the multipliers lam",
        (*SOLVED, "tau"),
        "cardan_nu + cardan_nlam",
    ),
    "balance": Whole(
        "M udot + h - f - G^T lam, gaps of positions, of speeds",
        ("t", "q", "u", "udot", "lam", "s", "r"),
        "cardan_nu + cardan_npositions + cardan_nlam",
    ),
    "mass_matrix": Whole(
        "values of [M G^T; G 0], sparse: see model_pattern", SOLVED, "cardan_nvalues"
    ),
    "energy": Whole("kinetic, potential and their sum", ("t", "q", "u", "s", "r"), "3"),
    "momentum": Whole(
        "angular momentum about the origin of the ground, then linear",
        ("t", "q", "u", "s", "r"),
        "6",
    ),
    "power": Whole("power of every source", SOLVED, "cardan_npowers"),
    "outputs": Whole(
        "outputs of the scene", ("t", "q", "u", "udot", "lam", "s", "r"), "cardan_noutputs"
    ),
    "qdot": Whole("rates of the coordinates", ("q", "u"), "cardan_nq"),
    "move": Whole(
        "coordinates moved by du along the speeds, then a rotation (3, 3) for every place",
        ("q", "du"),
        "cardan_nq + 9 * cardan_nplaces",
    ),
    "close_position": Whole(
        "coordinates a step nearer to closing all circuits, then how open they were",
        ("t", "q", "u", "r", "tau"),
        "cardan_nq + cardan_npositions",
    ),
    "close_velocity": Whole(
        "speeds that the constraints allow, then what the given ones missed",
        ("t", "q", "u", "r", "tau"),
        "cardan_nu + cardan_nlam",
    ),
}


def exported(names: Sequence[str], shown: str) -> dict[str, Exported]:
    """Functions of the whole model, the one that the example shows first."""
    found = {name: WHOLE[name] for name in dict.fromkeys((shown, *names))}
    return {name: Exported(w.about, w.reads, {"out": w.size}) for name, w in found.items()}


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
        "nunknowns": (planned.plan["n"], "speeds and multipliers"),
        "nvalues": (planned.plan["values"], "numbers of the sparse matrix"),
        "ngroups": (len(absolute.groups), "groups of elements"),
        "nnumbers": (numbers, "numbers of elements"),
    }
    listed = [f"    cardan_{name} = {n}, /* {about} */" for name, (n, about) in sizes.items()]
    # no comma behind the last
    listed[-1] = listed[-1].replace(", /*", " /*", 1)
    whole = [f"F({name}, cardan_mesh_call_{name})" for name in names]
    return [
        *("", "enum {", *listed, "};", '#include "elements.h"', ""),
        "/* functions of the whole model, and what of the kernels each of them is */",
        f"#define CARDAN_WHOLE(F) {' '.join(whole)}",
    ]
