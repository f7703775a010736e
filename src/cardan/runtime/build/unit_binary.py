"""Compile a shared object that other programs load, for any processor of a platform."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Protocol

from ...errors import CompilerMissing
from ...records import dataclass
from . import cache, cache_folder, toolchain
from .cpu_levels import OTHER
from .parallel_build import in_parallel
from .toolchain import Compiler

# names other than those of the interface stay inside
HIDDEN = ("-fvisibility=hidden",)
# what debuggers read is left out
LINKED = (*HIDDEN, "-s")


class Target(Protocol):
    """A platform: its name, and as ``zig cc`` knows it."""

    @property
    def name(self) -> str:
        """As users say it."""

    @property
    def target(self) -> str:
        """As ``zig cc -target`` has it."""


def unit_binary(
    sources: Sequence[Path], platform: Target, local: bool, reproducible: bool
) -> bytes:
    """A shared object.

    Args:
        sources: C files of one folder, with their headers.
        platform: What it is for.
        local: Whether that is this machine's.
        reproducible: No contraction.

    Raises:
        CompilerMissing: nothing here compiles for that platform. BuildError: it does not compile.
    """
    if local:
        native = cache.compiler().for_models()
        by = replace(native, level=native.level.plainest())
    else:
        by = _cross(platform)
    folder = sources[0].parent
    with tempfile.TemporaryDirectory(prefix="cardan-unit-") as scratch:
        to = partial(_compiled, by, [folder], reproducible)
        files = list(sources)
        if not by.is_zig:
            parts = [Part(Path(scratch) / f"{source.stem}.o") for source in sources]
            named = zip(sources, parts, strict=True)
            in_parallel([partial(to, [source], part, (*HIDDEN, "-c")) for source, part in named])
            files = [part.path for part in parts]
        return to(files, Part(Path(scratch) / "unit"), LINKED).path.read_bytes()


@dataclass(frozen=True)
class Part:
    """An object in a folder that goes away as a whole."""

    path: Path

    def discard(self) -> None:
        """Nothing to do."""


def _compiled(
    by: Compiler,
    include: Sequence[Path],
    reproducible: bool,
    files: Sequence[Path],
    part: Part,
    extra: Sequence[str],
) -> Part:
    """Compile or link files into one."""
    scratch = cache_folder.directory() / "zig"
    toolchain.compile_shared(by, files, include, part.path, reproducible, scratch, extra)
    return part


def _cross(platform: Target) -> Compiler:
    """The clang of ziglang for another platform.

    Raises:
        CompilerMissing: it is not installed.
    """
    for candidate in toolchain.ziglang():
        command = (*candidate.command, "-target", platform.target)
        return Compiler(command, candidate.binary, toolchain.ask_version(command), level=OTHER)
    raise CompilerMissing(
        f"platforms: '{platform.name}' is not this machine's; the clang of ziglang compiles for "
        "it: pip install 'cardan[compiler]', or leave it out"
    )
