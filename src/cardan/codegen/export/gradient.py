"""Gradients in exports: the functions that a sweep back over a run calls, and where they are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...equations.record import EquationRecord
from ...errors import CodegenError, DerivationError
from ...ir.function import live
from ...schema.blocks import COORDINATES
from ...schema.cost import Cost
from ...schema.request import Request
from ...topology.system import System
from .. import flat_scene
from .constants import Name, Value

Pair = tuple[str, str | None]
# methods whose steps are a table of coefficients, and whether their stages are solved together
METHODS = {"rk4": False, "rk45": False, "dop853": False, "radau": True}
BLOCKS = (COORDINATES, "u", "z", "s", "r", "p")
LANGUAGES = ("c", "cython", "jax")
FILES = "motion_gradient.c"


def check(
    cost: Cost | None, language: str, integrators: Sequence[str], precision: str, name: str = ""
) -> None:
    """Refuse gradients that an export cannot have.

    Args:
        cost: Whose gradient; None: none was asked for.
        language, integrators, precision: As an export takes them.
        name: Of a model of elements in absolute coordinates.

    Raises:
        CodegenError: with the cure.
    """
    if cost is None:
        return
    if name:
        raise CodegenError(
            f"gradient=: model '{name}' is in absolute coordinates, as all models with beams are, "
            "and C that computes gradients of their motions is not exported. Use model.gradient in "
            "Python; a scene without beams can be derived in joint coordinates instead"
        )
    if language not in LANGUAGES:
        raise CodegenError(
            f"gradient=: it goes with language={', '.join(map(repr, LANGUAGES))}, not '{language}'"
        )
    if precision != "double":
        raise CodegenError(f"gradient=: it goes with precision='double', not '{precision}'")
    if not integrators:
        raise CodegenError(
            "gradient=: a gradient is one of a run: name its method, integrators=['dop853']"
        )
    wrong = [one for one in integrators if one not in METHODS]
    if wrong:
        raise CodegenError(
            f"gradient=: steps of '{wrong[0]}' have no table of coefficients; those that have one: "
            f"{', '.join(METHODS)}"
        )


def functions(equations: EquationRecord, cost: Cost) -> dict[str, Pair]:
    """Functions of a gradient by the fields of ``cardan_exported_cost``.

    Raises:
        DerivationError: a formula cannot be read, or the scene jumps when a parameter says so.
    """
    _check_jumps(equations.system)
    blocks = [block for block in BLOCKS if len(equations.blocks[_letter(block)])]

    def product(name: str, of: str | None = None) -> Pair:
        return ("vjp", str(Request(name, of, tuple(blocks))))

    result: dict[str, Pair] = {"rates": product("rhs")}
    for name in ("close_position", "close_velocity") if equations.system.closed else ():
        if name in equations.names():
            result[name] = product(name)
    for field, formula in (("final", cost.final), ("integrand", cost.running)):
        if formula is not None:
            result[field] = ("expression", formula)
            result[f"{field}_product"] = product("expression", formula)
    return result


def record(equations: EquationRecord, pairs: Mapping[str, Pair], names: Sequence[str]) -> Value:
    """The constant ``cardan_exported_cost``.

    Args:
        equations: Of the model.
        pairs: Functions by field.
        names: Those of the export, in its order.
    """
    fields = (
        *("final", "final_product", "integrand", "integrand_product"),
        *("rates", "close_position", "close_velocity"),
    )
    places = {field: names.index(equations.c_name(*pair)) for field, pair in pairs.items()}
    return {"np": Name("cardan_np"), **{field: places.get(field, -1) for field in fields}}


def files(integrators: Sequence[str]) -> list[str]:
    """Files of ``kernels/`` that sweeps need."""
    tables = [f"{one}_tableau.c" for one in integrators]
    return [FILES, *tables, *(["stages.c"] if any(METHODS[one] for one in integrators) else [])]


def _letter(block: str) -> str:
    return "q" if block == COORDINATES else block


def _check_jumps(system: System) -> None:
    """Refuse a scene that jumps when a parameter says so: its time would not move along.

    Raises:
        DerivationError: with the cure.
    """
    jumps = flat_scene.time_jumps(system)
    if jumps is None:
        return
    roots = [node for output in jumps.outputs for node in output.nodes]
    nodes = (jumps.graph.nodes[i] for i in live(jumps.graph, roots))
    if any(node[:2] == ("var", "p") for node in nodes):
        raise DerivationError(
            "gradient=: a parameter decides when the scene jumps, by a comparison of t, and such "
            "times are held. Write the time as a number, or the jump as an event"
        )
