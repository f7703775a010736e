"""Compile a shared object that other programs load, for any processor of a platform."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Protocol

from ...errors import CompilerMissing
from . import cache, cache_folder, toolchain
from .cpu_levels import OTHER
from .toolchain import Compiler

# other names than those of the interface stay inside, and what debuggers read is left out
EXTRA = ("-fvisibility=hidden", "-s")


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
        output = Path(scratch) / "unit"
        toolchain.compile_shared(
            by, sources, [folder], output, reproducible, cache_folder.directory() / "zig", EXTRA
        )
        return output.read_bytes()


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
