"""Export of a model whose elements stand in tables: C that compiles alone and simulates."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ...equations.finite_elements.record import FiniteElementRecord
from ...errors import CodegenError, DerivationError, near
from ...schema.planned import Planned
from .. import layout
from ..finite_elements import functions_header, model_folder, tables_header
from ..header import Exported
from ..sources import source
from ..writing import generate
from . import companions
from .constants import Name
from .export import ExportRequest, written
from .model_file import Content

# what a run calls beside what happens at events; what the example shows
CALLED, EXAMPLE_FUNCTION = (
    ("rhs", "balance", "move", "qdot", "close_position", "close_velocity"),
    "energy",
)
# tolerances of ``simulate``: the method is none for many digits
TOLERANCES = {"alpha": {"rtol": 1e-6, "atol": 1e-9}}


# methods that need no more than elements give
METHODS = tuple(
    name
    for name, method in companions.INTEGRATORS.items()
    if {*method.called(elements=True, states=True)} <= {*CALLED}
)


def export(
    absolute: FiniteElementRecord,
    directory: str | Path,
    plan: Callable[[Path], Planned],
    functions: Sequence[object] | None = None,
    language: str = "c",
    integrators: Sequence[str] = (),
    reproducible: bool = False,
    prefix: str = "",
    precision: str = "double",
) -> Path:
    """Write C that needs nothing but a C compiler.

    Args:
        absolute: What to write.
        directory: A new or empty one, or an earlier export of cardan, which is replaced.
        plan: Folder of a model -> what is known of its matrices and its start.
        functions: Names of functions of the whole model; all by default.
        language: ``"c"``.
        integrators: By their files, such as ``"alpha"`` or ``"dop853"``: their C comes along, and
            ``example.c`` simulates.
        reproducible: The flags written down forbid contraction: equal bits from every compiler.
        prefix: Put before the names of all functions and data, such as ``"arm_"``: exports with
            different prefixes can be linked into one program.
        precision: ``"double"``.

    Returns:
        The directory. It appears whole or not at all.

    Raises:
        CodegenError: the directory holds other things; an unknown language or integrator, or one
            that elements in tables do not go with.
        DerivationError: an unknown function.
    """
    options = (language, integrators, reproducible, prefix, precision)
    request = ExportRequest.checked(directory, *options)
    check(absolute, request)
    return written(request, filler(absolute, plan, functions, request.integrators))


def filler(
    absolute: FiniteElementRecord,
    plan: Callable[[Path], Planned],
    functions: Sequence[object] | None,
    integrators: tuple[str, ...],
) -> Callable[[Path], Content]:
    """A function that writes a model into a folder, and says what else there is.

    Args:
        absolute, plan, functions, integrators: As :func:`export` takes them.

    Raises:
        DerivationError: an unknown function.
    """
    names = _requested(absolute, functions, integrators)

    def fill(folder: Path) -> Content:
        model_folder.write(folder, absolute, functions_header.available(absolute))
        # what gives the data of elements by the parameters is C here too
        commons = model_folder.commons(absolute)
        if commons:
            model = absolute.system.name
            layout.add_functions(folder, [(generate(f, model=model), f) for f in commons])
        jumps = companions.add_time_jumps(folder, absolute.system) if integrators else ()
        entries, planned = layout.manifest_of(folder).functions, plan(folder)
        q, u, z = np.split(planned.start, np.cumsum([absolute.places.nq, absolute.places.nu]))
        calls = Name("&cardan_calls_of_elements")
        return Content(
            functions_header.exported(names, EXAMPLE_FUNCTION)
            | {name: Exported.of(entries[name]) for name in jumps},
            {"q": q.tolist(), "u": u.tolist(), "z": z.tolist()},
            {
                "mesh": Name("&mesh"),
                "elements": Name("&elements"),
                "calls": calls,
                "size": planned.size,
            },
            planned.columns,
            TOLERANCES,
            functions_header.declared(absolute, entries, planned, names),
            {
                **{name: source(name) for name in ("elements.h", "elements.c")},
                "tables.h": tables_header.tables(absolute, entries, planned),
            },
        )

    return fill


def check(absolute: FiniteElementRecord, request: ExportRequest) -> None:
    """Refuse what elements in tables do not go with.

    Raises:
        CodegenError: a package, or a method that needs other functions.
    """
    name = absolute.system.name
    if request.language != "c":
        raise CodegenError(
            f"language '{request.language}': model '{name}' is in absolute coordinates, whose "
            "elements are exported as C: language='c'. In Python use cardan.compile(). Scenes "
            "without flexible parts go with it in joint coordinates: "
            "derive(scene, coordinates='relative')"
        )
    if request.precision != "double":
        raise CodegenError(
            f"precision='{request.precision}': model '{name}' is in absolute coordinates, whose "
            "equations need double precision. Joint coordinates have it: "
            "derive(scene, coordinates='relative')"
        )
    for method in request.integrators:
        if method not in METHODS:
            raise CodegenError(
                f"integrators: '{method}' needs functions that absolute coordinates do not have. "
                f"Model '{name}' goes with {', '.join(METHODS)}"
            )


def _requested(
    absolute: FiniteElementRecord, functions: Sequence[Any] | None, integrators: Sequence[str]
) -> tuple[str, ...]:
    """Names of the functions to write, in their usual order.

    Raises:
        DerivationError: one does not exist.
    """
    available = functions_header.available(absolute)
    requested = available if functions is None else functions
    for one in requested:
        if not isinstance(one, str):
            raise DerivationError(
                f"function '{one[0]}' of '{one[1]}': exports of absolute coordinates have "
                "functions of the whole model only; poses of nodes are in q: "
                f"{', '.join(available)}"
            )
        if one not in available:
            raise DerivationError(
                f"function '{one}' does not exist in exports of absolute coordinates."
                f"{near(one, available)}"
            )
    called = (*CALLED, *functions_header.EVENT_FUNCTIONS) if integrators else ()
    needed = {*requested, EXAMPLE_FUNCTION, *called}
    return tuple(name for name in available if name in needed)
