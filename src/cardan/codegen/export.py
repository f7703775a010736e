"""Export: a model as plain C that compiles alone, with a package for NumPy on top."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from ..equations.record import Equations
from ..errors import CodegenError, DerivationError, near, shown
from . import companions, header, layout, linkage, manifest, simulating
from . import prefix as prefixes
from .languages import LANGUAGES, cython
from .writing import generate

STANDARD = ("rhs", "forward_dynamics", "inverse_dynamics", "mass_matrix", "bias", "energy")
# what building an export leaves in its directory
PRODUCTS = ("build", "example", "*.o", "*.so", "*.egg-info", "__pycache__")
DIGITS = 12
FLAGS = ("-std=c99", "-O2", "-fno-math-errno")


def export(
    equations: Equations,
    directory: str | Path,
    functions: Sequence[Any] | None = None,
    language: str = "cython",
    integrators: Sequence[str] = (),
    reproducible: bool = False,
    loops: bool | None = None,
    prefix: str = "",
) -> Path:
    """Write C that needs nothing but a C compiler, and what makes it easy to use.

    Args:
        equations: What to write.
        directory: A new or empty one, or an earlier export of cardan, which is replaced.
        functions: Names such as ``"mass_matrix"``, or pairs such as ``("pose", "hand")``; by
            default the dynamics and the energy, of a closed system also what closes it, of one
            with events what happens.
        language: ``"cython"`` adds a package for NumPy, ``"c"`` leaves it at C.
        integrators: By their files, such as ``"dop853"``, ``"rk4"`` or ``"radau"``: their C comes
            along, and ``example.c`` simulates.
        reproducible: The flags written down forbid contraction: equal bits from every compiler.
        loops: As :func:`cardan.compile` takes it.
        prefix: Put before the names of all functions and data, such as ``"arm_"``: exports with
            different prefixes can be linked into one program. With ``language="c"``.

    Returns:
        The directory. It appears whole or not at all.

    Raises:
        CodegenError: the directory holds other things; an unknown language or integrator.
        DerivationError: an unknown function.
    """
    if not isinstance(functions, list | tuple | None):
        raise CodegenError(f"functions={shown(functions)}: give a list such as ['rhs']")
    for one in functions or ():
        if not isinstance(one, str) and not (isinstance(one, tuple | list) and len(one) == 2):
            raise CodegenError(f"functions: {shown(one)}: give names, or ('pose', 'hand')")
    target, wanted = Path(directory).resolve(), tuple(name.lower() for name in integrators)
    check_words(language, wanted)
    prefixes.check(prefix, language)
    check(target)
    known = equations.names()
    # equations that tell of no energy go without
    usual = [name for name in STANDARD if name != "energy" or name in known]
    asked = [(f, None) if isinstance(f, str) else tuple(f) for f in functions or usual]
    # what keeps a closed system closed belongs to its dynamics
    called = [name for name in (*simulating.CLOSING, *simulating.HAPPENING) if name in known]
    if wanted or not functions:
        needed = dict.fromkeys(name for one in wanted for name in companions.INTEGRATORS[one].needs)
        more = (*(("rhs",) if wanted else ()), *called, *needed)
        asked += [(name, None) for name in more if (name, None) not in asked]
    for name, _ in asked:
        if name not in known:
            raise DerivationError(f"function '{name}' does not exist.{near(name, known)}")

    def fill(folder: Path) -> None:
        layout.write_model(folder, manifest.base(equations, tuple(n for n, _ in asked)))
        made = []
        for name, of in asked:
            function = equations.form(name, of, loops)
            notes = equations.notes(name, of, function)
            made.append((generate(function, equations.system.name, notes, of=of), function))
        layout.add_functions(folder, made)
        flags = (*FLAGS, f"-ffp-contract={'off' if reproducible else 'on'}")
        data = layout.read(folder) or {}
        texts = _companions(data, language, wanted, flags)
        texts["model.c"] = header.defaults(data, _closed(equations))
        layout.add_files(folder, texts)
        if prefix:
            prefixes.add(folder, prefix)
        (folder / layout.LOCK).unlink()

    replaced(target, fill)
    return target


def _closed(equations: Equations) -> list[float] | None:
    """Coordinates at which all circuits close, next to the initial ones; None where none do."""
    if not equations.system.closed:
        return None
    found = equations.feasibility()
    # as many digits as are the same on every machine; a run closes the rest
    return [round(float(x), DIGITS) + 0.0 for x in found.q] if found.closes else None


def check_words(language: str, integrators: Sequence[str]) -> None:
    if language not in LANGUAGES:
        raise CodegenError(f"language '{language}' does not exist.{near(language, LANGUAGES)}")
    for name in integrators:
        if name not in companions.INTEGRATORS:
            known = near(name, companions.INTEGRATORS)
            raise CodegenError(f"integrators: '{name}' does not exist.{known}")


def _companions(
    data: dict[str, Any], language: str, integrators: Sequence[str], flags: Sequence[str]
) -> dict[str, str]:
    """Everything beside the functions, by file name."""
    roots = (*companions.RUN, *(f"{one}.c" for one in integrators)) if integrators else ()
    package = cython.package(data) if language == "cython" else ""
    line = companions.compile_line(flags)
    files = {name: layout.kernel(name) for name in linkage.closure(roots)}
    files |= {
        "functions.h": companions.prototypes(data),
        "example.c": companions.example(data, integrators, line),
        "README.md": companions.readme(data, package, line),
    }
    return files | (cython.files(data, flags) if package else {})


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
