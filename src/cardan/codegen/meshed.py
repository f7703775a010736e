"""Export of a model whose elements stand in tables: C that compiles alone and simulates."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from ..equations.absolute.record import Absolute
from ..errors import CodegenError, DerivationError, near
from ..schema.integrators import Integrator
from . import companions, elements, header, layout, linkage, mesh, meshed_example, tables
from . import prefix as prefixes
from .export import FLAGS, check, check_words, replaced
from .writing import generate

# files that every such model needs, with what they lead to
ROOTS = (*companions.RUN, "mesh_move.c", "mesh_calls.c", "mesh_solve.c", "mesh_start.c")
# what a run calls
CALLED = ("rhs", "balance", "move", "qdot", "close_position", "close_velocity")


def _called(method: Integrator) -> set[str]:
    """Functions that a method calls of elements in tables."""
    assembled = method.differenced if "assembled" in method.conditions else ()
    return set(method.needs) - set(assembled)


# methods that need no more than elements give
METHODS = tuple(name for name, m in companions.INTEGRATORS.items() if _called(m) <= set(CALLED))


def export(
    absolute: Absolute,
    directory: str | Path,
    plan: Callable[[Path], tables.Planned],
    functions: Sequence[Any] | None = None,
    language: str = "c",
    integrators: Sequence[str] = (),
    reproducible: bool = False,
    prefix: str = "",
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

    Returns:
        The directory. It appears whole or not at all.

    Raises:
        CodegenError: the directory holds other things; an unknown language or integrator, or one
            that elements in tables do not go with.
        DerivationError: an unknown function.
    """
    target, wanted = Path(directory).resolve(), tuple(name.lower() for name in integrators)
    check_words(language, wanted)
    _check(absolute, language, wanted)
    prefixes.check(prefix, language)
    check(target)
    names = _asked(functions, wanted)

    def fill(folder: Path) -> None:
        mesh.write(folder, absolute, tuple(elements.WHOLE))
        _add_data(folder, absolute)
        data, planned = layout.read(folder) or {}, plan(folder)
        flags = (*FLAGS, f"-ffp-contract={'off' if reproducible else 'on'}")
        texts = _texts(absolute, data, planned, names)
        line = companions.compile_line(flags)
        texts["example.c"] = meshed_example.example(wanted, line)
        texts["README.md"] = meshed_example.readme(data, names, line)
        for name in linkage.closure((*ROOTS, *(f"{one}.c" for one in wanted))):
            texts[name] = layout.kernel(name)
        layout.add_files(folder, texts)
        if prefix:
            prefixes.add(folder, prefix)
        (folder / layout.LOCK).unlink()

    replaced(target, fill)
    return target


def _check(absolute: Absolute, language: str, integrators: Sequence[str]) -> None:
    """Refuse what elements in tables do not go with.

    Raises:
        CodegenError: a package, a method that needs other functions, or internal states.
    """
    name = absolute.system.name
    if language != "c":
        raise CodegenError(
            f"language '{language}': model '{name}' is in absolute coordinates, whose elements are "
            "exported as C: language='c'. In Python use cardan.compile()"
        )
    for method in integrators:
        if method not in METHODS:
            raise CodegenError(
                f"integrators: '{method}' needs functions that absolute coordinates do not have. "
                f"Model '{name}' goes with {', '.join(METHODS)}"
            )
    if integrators and tables.sizes(absolute)["nz"]:
        cure = "leave out what has them"
        if not absolute.system.segments:
            cure = "derive(scene, coordinates='relative')"
        raise CodegenError(
            f"integrators: model '{name}' has internal states, which no run in absolute "
            f"coordinates takes: {cure}"
        )


def _asked(functions: Sequence[Any] | None, integrators: Sequence[str]) -> tuple[str, ...]:
    """Names of the functions to write, in their usual order.

    Raises:
        DerivationError: one does not exist.
    """
    known = elements.WHOLE
    asked = tuple(known) if functions is None else functions
    for one in asked:
        if not isinstance(one, str):
            raise DerivationError(
                f"function '{one[0]}' of '{one[1]}': exports of absolute coordinates have "
                f"functions of the whole model only; poses of nodes are in q: {', '.join(known)}"
            )
        if one not in known:
            raise DerivationError(
                f"function '{one}' does not exist in exports of absolute coordinates."
                f"{near(one, known)}"
            )
    # what the example shows, and what it simulates with
    needed = {*asked, "energy", *(CALLED if integrators else ())}
    return tuple(name for name in known if name in needed)


def _add_data(folder: Path, absolute: Absolute) -> None:
    """Write what gives the data of elements by the parameters as C too."""
    made = [
        (generate(function, model=absolute.system.name), function)
        for function in mesh.commons(absolute)
    ]
    if made:
        layout.add_functions(folder, made)


def _texts(
    absolute: Absolute, data: dict[str, Any], planned: tables.Planned, names: Sequence[str]
) -> dict[str, str]:
    """What is written of the whole model, by file name."""
    nq, nu = absolute.places.nq, absolute.places.nu
    start = planned.start.tolist()
    return {
        "functions.h": elements.prototypes(absolute, data, planned, names),
        "elements.c": elements.elements(absolute, names),
        "tables.h": tables.tables(absolute, data["functions"], planned),
        "model.c": header.defaults(data, start[:nq], start[nq : nq + nu]) + _others(data, planned),
    }


def _others(data: dict[str, Any], planned: tables.Planned) -> str:
    """Modes, quaternions and units for ``model.c``."""
    modes = ", ".join(repr(float(row["default"])) for row in data["s"])
    quaternions = ", ".join(map(str, data["quaternions"]))
    columns = "\n".join(tables.wrapped(map(repr, planned.columns.tolist() or [1.0])))
    held = "\n".join(tables.wrapped("01"[one] for one in planned.held.tolist() or [False]))
    return (
        f"\n/* modes */\nconst double {header.array('s')} = {{{modes or 0.0}}};\n"
        "\n/* first entry of every unit quaternion in q */\n"
        f"const ptrdiff_t {elements.QUATERNIONS} = {{{quaternions or 0}}};\n"
        "\n/* 1: entries of x that stay as they are where parameters move the rest */\n"
        f"const double {elements.HELD} = {{\n{held}\n}};\n"
        "\n/* what lengths count against [m]; what speeds count in: that, or 1 */\n"
        f"const double cardan_size = {planned.size!r};\n"
        f"const double {elements.COLUMNS} = {{\n{columns}\n}};\n"
    )
