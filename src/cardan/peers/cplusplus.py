"""C++ compilers of this machine, for peers that come as headers."""

from __future__ import annotations

import shutil
from pathlib import Path

from ..errors import BuildError
from ..runtime import toolchain
from ..runtime.toolchain import Compiler

NAMES = ("clang++", "g++")


def compilers(options: tuple[str, ...]) -> list[Compiler]:
    """Compilers that answer, clang before gcc: it makes the faster code of templates.

    Args:
        options: Language, level, processor, headers.
    """
    commands = [(*found.command[:-1], "c++") for found in toolchain.ziglang()]
    binaries = [found.binary for found in toolchain.ziglang()]
    for name in NAMES:
        path = shutil.which(name)
        if path:
            commands.append((path,))
            binaries.append(Path(path).resolve())
    made = []
    for command, binary in zip(commands, binaries, strict=True):
        try:
            made.append(Compiler(command, binary, toolchain.ask_version(command), options))
        except BuildError:
            # one that does not answer is as good as none
            continue
    return made


def version(compiler: Compiler) -> str:
    """Family and version, such as ``gcc 12.2.0``."""
    first = compiler.identity.splitlines()[0]
    numbers = [word for word in first.split() if word[:1].isdigit()]
    return f"{compiler.family} {numbers[-1] if numbers else first}"
