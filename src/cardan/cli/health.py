"""Checks that ``cardan doctor`` runs."""

from __future__ import annotations

import ctypes
import os
import platform
import shlex
import shutil
import sys
import tempfile
import time
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from ..errors import BuildError, CompilerMissing
from ..peers import processor
from ..records import dataclass
from ..runtime.build import cache, cache_folder, limited_subprocess, prebuilt, prune, toolchain
from ..runtime.build.object_file import Object
from ..runtime.calls import abi, batch, lanes, webassembly
from ..version import VERSION

NEEDED = ("numpy", "scipy", "sympy", "rich", "defusedxml", "ruamel.yaml")
# what may be missing: package -> what it is for, and the extra that brings it
OPTIONAL = {
    "matplotlib": ("pictures: motion.plot()", "plot"),
    "xarray": ("data sets: motion.to_xarray()", "data"),
    "meshio": ("solids from meshes of Gmsh and other programs", "fem"),
    "mpmath": ("errors in model.report(), against 40 digits", "test"),
    "example-robot-data": ("robots for cardan demo", "demo"),
    "ziglang": ("a C compiler from the package index", "compiler"),
    "wasmtime": ("fast functions without a C compiler", "wasm"),
}
PROBE = "double cardan_probe(double x);\ndouble cardan_probe(double x) { return 2 * x; }\n"
PIP = "pip install"
LITTLE = 100e6  # bytes


@dataclass(frozen=True)
class Finding:
    """One line of the report.

    Attributes:
        name: What was looked at.
        ok: Whether nothing needs doing.
        says: What was found.
        cure: What to do about it, or what could be had; "" if nothing.
    """

    name: str
    ok: bool
    says: str
    cure: str = ""


def findings() -> list[Finding]:
    """Everything there is to say about this machine."""
    return [
        Finding("cardan", True, f"{VERSION}, Python {platform.python_version()}"),
        *map(_needed, NEEDED),
        _extension(),
        _compiler(),
        _kernels(),
        _batches(),
        _limits(),
        _cache(),
        _processor(),
        *(_optional(name, what, extra) for name, (what, extra) in OPTIONAL.items()),
    ]


def _needed(name: str) -> Finding:
    try:
        return Finding(name, True, version(name))
    except PackageNotFoundError:
        return Finding(name, False, "not installed", f"{PIP} {name}")


def _optional(name: str, what: str, extra: str) -> Finding:
    try:
        return Finding(name, True, f"{version(name)}; {what}")
    except PackageNotFoundError:
        cure = f"to have it: {PIP} 'cardan[{extra}]'"
        return Finding(name, True, f"not installed; {what}", cure)


def _extension() -> Finding:
    if abi.NAME == "cython":
        return Finding("calls", True, "through the compiled extension")
    cure = f"for quicker single calls: {PIP} --force-reinstall --no-binary cardan cardan"
    return Finding("calls", True, "through ctypes; batches and simulations are as fast", cure)


def _compiler() -> Finding:
    """The compiler in use, tried on a few lines."""
    try:
        chosen = cache.compiler().for_models()
        compilers = [candidate.name for candidate in toolchain.candidates()]
        with tempfile.TemporaryDirectory() as place:
            source, library = Path(place) / "probe.c", Path(place) / "probe.so"
            source.write_text(PROBE)
            start = time.perf_counter()
            toolchain.compile_shared(
                chosen, [source], [], library, scratch=cache_folder.directory() / "zig"
            )
            spent = time.perf_counter() - start
            probe = Object(library, True).load().cardan_probe
            probe.argtypes, probe.restype = [ctypes.c_double], ctypes.c_double
            if probe(21.0) != 42.0:
                raise BuildError(f"{chosen.command[0]} compiles wrong code: 2 x 21 is not 42")
    except BuildError as error:
        if isinstance(error, CompilerMissing) and webassembly.available():
            says = f"{error}; functions run as WebAssembly in {webassembly.version()}"
            return Finding("compiler", True, says, f"{PIP} 'cardan[compiler]' is a little faster")
        cure = f"{PIP} 'cardan[compiler]' or 'cardan[wasm]'; until then functions run in NumPy"
        return Finding("compiler", False, str(error), cure)
    except OSError as error:
        cure = "make room, or set TMPDIR to another folder"
        return Finding("compiler", False, f"it could not be tried: {error}", cure)
    first = chosen.identity.splitlines()[0] if chosen.identity else "says nothing of itself"
    alternatives = f" (found: {', '.join(compilers)})" if len(compilers) > 1 else ""
    flags = " ".join(chosen.flags())
    text = (
        f"{shlex.join(chosen.command)}: {first}{alternatives}; works, {spent:.2f} s; flags {flags}"
    )
    return Finding("compiler", True, text)


def _batches() -> Finding:
    """Lanes and threads that batches of states use."""
    try:
        cache.compiler()
        text = f"{lanes.width()} states side by side (CARDAN_LANES), "
        text += f"{batch.threads()} threads (CARDAN_THREADS)"
    except CompilerMissing:
        way = "one by one" if webassembly.available() else "in NumPy"
        return Finding("batches", True, f"{way}, without a compiler")
    except BuildError as error:
        return Finding("batches", False, str(error), "correct or unset it")
    return Finding("batches", True, text)


def _limits() -> Finding:
    try:
        limits = limited_subprocess.Limits.of_environment()
    except BuildError as error:
        return Finding("limits", False, str(error), "correct or unset it")
    text = f"a compiler may take {limits.seconds} s (CARDAN_COMPILE_SECONDS) and "
    return Finding("limits", True, f"{text}{limits.memory} MiB (CARDAN_COMPILE_MEMORY)")


def _cache() -> Finding:
    place = cache_folder.configured()
    reason = cache_folder.refusal(place)
    if reason:
        return Finding("cache", False, f"{place} cannot be used", reason)
    usage, free = prune.content(place), shutil.disk_usage(place).free
    text = (
        f"{place}: yours alone, {usage.objects} objects and {usage.models} models, "
        f"{usage.size / 1e6:.1f} MB, {free / 1e9:.1f} GB free"
    )
    try:
        with tempfile.TemporaryFile(dir=place) as file:
            file.write(bytes(4096))
    except OSError as error:
        cure = "cardan doctor --prune, or set CARDAN_CACHE to another folder"
        return Finding("cache", False, f"{text}; cannot be written to ({error.strerror})", cure)
    if free < LITTLE:
        return Finding("cache", False, text, "little room is left: cardan doctor --prune")
    left = usage.leftovers and f"{usage.leftovers} leftovers: cardan doctor --prune"
    return Finding("cache", True, text, left or "")


def _processor() -> Finding:
    """Cores, and the instructions that compiled code uses."""
    text = f"{os.cpu_count()} x {processor.name()} ({sys.platform})"
    try:
        level = cache.level()
    except CompilerMissing:
        return Finding("processor", True, text)
    except BuildError as error:
        return Finding("processor", False, str(error), "correct or unset it")
    text += f"; level {level.name} (CARDAN_LEVEL), vectors of {level.lanes} numbers"
    return Finding("processor", True, text)


def _kernels() -> Finding:
    """Integrators and solvers: from the installation or the cache."""
    index = prebuilt.current()
    if index is None:
        text = "compiled into the cache at first use"
        cure = f"for a quicker first run: {PIP} --force-reinstall --no-binary cardan cardan"
        return Finding("kernels", True, text, cure)
    levels = ", ".join(f"{name} ({len(objects)})" for name, objects in index.objects.items())
    first = index.compiler.partition("\n")[0]
    return Finding("kernels", True, f"compiled at installation for {levels} by {first}")
