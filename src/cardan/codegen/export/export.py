"""Export: a model as plain C that compiles alone, with what calls it on top."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from ...equations.functions.recipes import missing
from ...equations.record import EquationRecord
from ...errors import CodegenError, DerivationError, brief, near
from ...records import dataclass
from ...schema.c_functions import FunctionRow
from ...schema.cost import Cost
from ...schema.functions import FUNCTIONS
from ...schema.manifest import Manifest
from .. import flat_scene, header, layout, manifest
from ..header import Exported
from ..languages import BINDINGS
from ..languages.binding import BoundModel
from ..program.program import Program
from ..sources import source
from ..writing import generate
from . import companions, gradient, lanes, model_file
from . import precision as precisions
from . import prefix as prefixes
from .jacobians import with_jacobians
from .model_file import Content
from .readme import readme

STANDARD = ("rhs", "forward_dynamics", "inverse_dynamics", "mass_matrix", "bias", "energy")
# what building an export leaves in its directory
PRODUCTS = ("build", "example", "*.o", "*.so", "*.egg-info", "__pycache__")
FLAGS = ("-std=c99", "-O2", "-fno-math-errno")


@dataclass(frozen=True)
class ExportRequest:
    """Options of an export, for both kinds of coordinates.

    Attributes:
        target: The directory.
        language: ``"c"``, or what calls the C, such as ``"cython"``.
        integrators: By their kernels.
        reproducible: Whether flags forbid contraction.
        prefix: Before all names.
        precision: Of all numbers, ``"double"`` or ``"single"``.
        cost: Whose gradient runs have, None without.
    """

    target: Path
    language: str
    integrators: tuple[str, ...]
    reproducible: bool
    prefix: str
    precision: str
    cost: Cost | None = None

    @property
    def flags(self) -> tuple[str, ...]:
        """For the compiler."""
        return (*FLAGS, f"-ffp-contract={'off' if self.reproducible else 'on'}")

    @classmethod
    def checked(
        cls,
        directory: str | Path,
        language: str,
        integrators: Sequence[str],
        reproducible: bool,
        prefix: str,
        precision: str,
        cost: Cost | None = None,
    ) -> ExportRequest:
        """The options, checked.

        Raises:
            CodegenError: an unknown word, a directory that holds other things.
        """
        target, methods = Path(directory).resolve(), tuple(name.lower() for name in integrators)
        if language not in BINDINGS:
            raise CodegenError(f"language '{language}' does not exist.{near(language, BINDINGS)}")
        binding = BINDINGS[language]
        for name in methods:
            if name not in companions.INTEGRATORS:
                hint = near(name, companions.INTEGRATORS)
                raise CodegenError(f"integrators: '{name}' does not exist.{hint}")
        if methods and binding and binding.without_runs:
            raise CodegenError(f"integrators: language '{language}' {binding.without_runs}")
        prefixes.check(prefix, language)
        precisions.check(precision, language, methods)
        gradient.check(cost, language, methods, precision)
        check(target)
        return cls(target, language, methods, reproducible, prefix, precision, cost)


def written(request: ExportRequest, fill: Callable[[Path], Content]) -> Path:
    """Write an export; it appears whole or not at all.

    Args:
        request: What was asked for.
        fill: Writes model and functions into a folder, and says what else there is.

    Raises:
        CodegenError: there is no room, or nothing may be written there.
    """

    def complete(folder: Path) -> None:
        content = fill(folder)
        layout.add_files(folder, contents(layout.manifest_of(folder), request, content))
        if request.prefix:
            prefixes.add(folder, request.prefix)
        if request.precision == "single":
            precisions.apply(folder)
        (folder / layout.LOCK).unlink()

    try:
        replaced(request.target, complete)
    except OSError as error:
        why = error.strerror or error
        raise CodegenError(
            f"{request.target} cannot be written: {why}. Make room, or name another directory"
        ) from error
    return request.target


def contents(data: Manifest, request: ExportRequest, content: Content) -> dict[str, str | bytes]:
    """Everything beside the functions, by file name."""
    swept = request.integrators if content.cost else ()
    bound = BoundModel(data, content.programs, content.start, request.flags, swept)
    binding = BINDINGS[request.language]
    return {**texts(data, request, content), **(binding.files(bound) if binding else {})}


def texts(data: Manifest, request: ExportRequest, content: Content) -> dict[str, str]:
    """What every export has beside the functions, by file name."""
    methods, functions, elements = request.integrators, content.functions, data.absolute
    line = f"cc {' '.join(request.flags)} -DCARDAN_EXAMPLE -o example *.c -lm && ./example"
    binding = BINDINGS[request.language]
    side_by_side = lanes.methods(data, methods) if request.precision == "double" else []
    top = "simulate_lanes.h" if side_by_side else "simulate.h" if methods else "export.h"
    headers = [top, *(["mesh_export.h"] if elements else [])]
    headers += ["motion_gradient.h"] if content.cost else []
    sweeps = gradient.files(methods) if content.cost else []
    runs = (bool(methods), bool(side_by_side), bool(content.cost))
    return {
        **companions.kernels(methods, elements, sweeps),
        **(lanes.files(side_by_side) if side_by_side else {}),
        "functions.h": header.prototypes(data.name, functions, headers, content.declared),
        "model.c": model_file.text(data, content, methods),
        "example.c": f"/* Try it:  {line} */\n{source('example.c')}",
        "README.md": readme(data, functions, line, runs, binding),
        **content.files,
    }


def export(
    equations: EquationRecord,
    directory: str | Path,
    start: Callable[[Path], Mapping[str, Sequence[float]]],
    functions: Sequence[object] | None = None,
    language: str = "cython",
    integrators: Sequence[str] = (),
    reproducible: bool = False,
    loops: bool | None = None,
    prefix: str = "",
    precision: str = "double",
    cost: Cost | None = None,
) -> Path:
    """Write C that needs nothing but a C compiler, and what makes it easy to use.

    Args:
        equations: What to write.
        directory: A new or empty one, or an earlier export of cardan, which is replaced.
        start: Folder of a model -> values to start from, by block; of other blocks the scene's.
        functions, language, integrators, reproducible, loops, prefix, precision: As
            ``equations.export`` takes them.
        cost: Its ``gradient``.

    Returns:
        The directory. It appears whole or not at all.

    Raises:
        CodegenError: the directory holds other things; an unknown language or integrator.
        DerivationError: an unknown function.
    """
    if not isinstance(functions, list | tuple | None):
        raise CodegenError(f"functions={brief(functions)}: give a list such as ['rhs']")
    for one in functions or ():
        if not isinstance(one, str) and not (isinstance(one, tuple | list) and len(one) == 2):
            raise CodegenError(f"functions: {brief(one)}: give names, or ('pose', 'hand')")
    options = (language, integrators, reproducible, prefix, precision, cost)
    request = ExportRequest.checked(directory, *options)
    fill = filler(equations, start, functions, request.integrators, loops, language, cost)
    return written(request, fill)


def filler(
    equations: EquationRecord,
    start: Callable[[Path], Mapping[str, Sequence[float]]],
    functions: Sequence[object] | None,
    integrators: tuple[str, ...],
    loops: bool | None = None,
    language: str = "c",
    cost: Cost | None = None,
) -> Callable[[Path], Content]:
    """A function that writes model and functions into a folder, and says what else there is.

    Args:
        equations, start, functions, integrators, loops, language, cost: As :func:`export` takes
            them.

    Raises:
        DerivationError: an unknown function.
    """
    requested = _requested(equations, functions, integrators)
    binding = BINDINGS[language]
    if binding and binding.jacobians:
        named = _requested(equations, functions or [*_usual(equations)], ())
        requested = with_jacobians(equations, language, binding.products, named, requested)
    pairs = gradient.functions(equations, cost) if cost else {}
    requested += [pair for pair in dict.fromkeys(pairs.values()) if pair not in requested]

    def fill(folder: Path) -> Content:
        programs = _write(folder, equations, requested, loops)
        if integrators:
            companions.add_time_jumps(folder, equations.system)
        entries = layout.manifest_of(folder).functions
        values = _start(folder, equations, requested, start)
        swept = {equations.c_name(*pair) for pair in pairs.values()}
        ordered = _ordered(entries, swept)
        row = gradient.record(equations, pairs, [*ordered]) if cost else None
        return Content(ordered, values, programs=programs, cost=row)

    return fill


def _write(
    folder: Path,
    equations: EquationRecord,
    requested: Sequence[tuple[str, str | None]],
    loops: bool | None = None,
) -> list[Program]:
    """Write a model with its functions into a folder."""
    layout.write_model(folder, manifest.base(equations, tuple(n for n, _ in requested)))
    texts = []
    for name, of in requested:
        function = equations.form(name, of, loops)
        notes = equations.notes(name, of, function)
        texts.append((generate(function, equations.system.name, notes, of=of), function))
    layout.add_functions(folder, texts)
    return [text.program for text, _ in texts]


def _start(
    folder: Path,
    equations: EquationRecord,
    requested: Sequence[tuple[str, str | None]],
    start: Callable[[Path], Mapping[str, Sequence[float]]],
) -> Mapping[str, Sequence[float]]:
    """Values to start from instead of those of the scene, by block."""
    available = equations.names()
    closing = [(name, None) for name in companions.CLOSING if name in available]
    if not equations.system.closed:
        return start(folder)
    if {*closing} <= {*requested}:
        return start(folder)
    # what closes it is not part of this export
    with tempfile.TemporaryDirectory(prefix=".cardan-") as scratch:
        _write(Path(scratch), equations, closing)
        return start(Path(scratch))


def _requested(
    equations: EquationRecord, functions: Sequence[Any] | None, integrators: tuple[str, ...]
) -> list[tuple[str, str | None]]:
    """Names of the functions to write, and to what they belong.

    Raises:
        DerivationError: one does not exist.
    """
    available = equations.names()
    usual = _usual(equations)
    requested = [(f, None) if isinstance(f, str) else tuple(f) for f in functions or usual]
    if integrators or not functions:
        # what keeps a closed system closed belongs to its dynamics
        # trees start anywhere
        closing = companions.CLOSING if equations.system.closed else ()
        called = [n for n in (*closing, *companions.EVENT_FUNCTIONS) if n in available]
        more = (
            *(("rhs",) if integrators else ()),
            *called,
            *companions.needed(integrators, equations.system.nz > 0),
        )
        requested += [(name, None) for name in more if (name, None) not in requested]
    for name, _ in requested:
        if name not in available:
            why = missing(equations.system, name) if name in FUNCTIONS else ""
            raise DerivationError(
                why or f"function '{name}' does not exist.{near(name, available)}"
            )
    return requested


def _usual(equations: EquationRecord) -> list[str]:
    """Functions where none are named, without what equations do not tell, such as an energy."""
    available = equations.names()
    return [name for name in STANDARD if name in available]


def _ordered(entries: Mapping[str, FunctionRow], swept: set[str]) -> dict[str, Exported]:
    """Functions of the manifest; first one that no run calls beside rhs, if there is one."""
    called = swept | {*companions.CLOSING, *companions.EVENT_FUNCTIONS, flat_scene.TIME_JUMPS}
    called |= {*companions.needed(companions.INTEGRATORS, states=True)}
    ordered = sorted(entries, key=called.__contains__)
    return {name: Exported.of(entries[name]) for name in ordered}


def replaced(target: Path, fill: Callable[[Path], None]) -> None:
    """Fill a directory beside the target, then move it there in one step."""
    target.parent.mkdir(parents=True, exist_ok=True)
    scratch = Path(tempfile.mkdtemp(prefix=".cardan-", dir=target.parent))
    try:
        scratch.chmod(0o755)
        fill(scratch)
        if not target.exists():
            scratch.rename(target)
            return
        # an earlier export goes only when the new one has its place
        before = scratch.with_name(f"{scratch.name}-before")
        target.rename(before)
        try:
            scratch.rename(target)
        except BaseException:
            before.rename(target)
            raise
        shutil.rmtree(before, ignore_errors=True)
    except BaseException:
        shutil.rmtree(scratch, ignore_errors=True)
        raise


def check(target: Path) -> None:
    """Refuse to replace what is not ours.

    Raises:
        CodegenError: the target is a file, where we are, or a directory with other things in it.
    """
    if target == Path.cwd():
        raise CodegenError(
            f"{target} is where you are, and an export replaces its directory: name another one"
        )
    if target.exists() and not target.is_dir():
        raise CodegenError(f"{target} is a file: name a directory to export to")
    if target.is_dir():
        names = {p.name for p in target.iterdir() if not any(map(p.match, PRODUCTS))}
        foreign = sorted(names - layout.written(target)) if names else []
        if foreign:
            raise CodegenError(
                f"directory {target} holds other things ({', '.join(foreign[:3])}): "
                "name a new or empty one"
            )
