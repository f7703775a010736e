"""Find a C compiler on this machine and drive it: one command per shared object."""

from __future__ import annotations

import importlib.util
import os
import platform
import shlex
import shutil
import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from ..errors import BuildError

NAMES = ("cc", "gcc", "clang")
COMMON_FLAGS = (
    "-std=c99",
    "-O2",
    "-march=native",
    "-fno-tree-vectorize",
    "-fno-math-errno",
)
SHARED_FLAGS = ("-shared", "-fPIC", "-pipe")


@dataclass(frozen=True)
class Compiler:
    """A C compiler of this machine.

    Attributes:
        command: How it is called, without flags.
        binary: The program whose change means another compiler.
        identity: What it says about its version.
    """

    command: tuple[str, ...]
    binary: Path
    identity: str

    @property
    def family(self) -> str:
        """``"clang"`` or ``"gcc"``: they spell contraction differently."""
        return "clang" if "clang" in self.identity.lower() else "gcc"

    def flags(self, reproducible: bool = False) -> tuple[str, ...]:
        """Flags of a scalar unit; contraction is always given.

        Args:
            reproducible: No contraction: every compiler of IEEE arithmetic gives equal bits.
        """
        contract = "off" if reproducible else {"gcc": "fast", "clang": "on"}[self.family]
        return (*COMMON_FLAGS, f"-ffp-contract={contract}", *SHARED_FLAGS)


def candidates() -> list[tuple[tuple[str, ...], Path]]:
    """Compilers to try, in this order: ``$CC``, cc, gcc, clang, ``ziglang``."""
    named = [shlex.split(os.environ["CC"])] if os.environ.get("CC") else []
    found = []
    for words in [*named, *([name] for name in NAMES)]:
        path = shutil.which(words[0]) if words else None
        if path:
            found.append(((path, *words[1:]), Path(path).resolve()))
    return found or ziglang()


def ziglang() -> list[tuple[tuple[str, ...], Path]]:
    """The clang of the Python package ziglang; [] where it is not installed."""
    spec = importlib.util.find_spec("ziglang")
    for folder in (spec.submodule_search_locations or []) if spec else []:
        binary = Path(folder) / "zig"
        if binary.exists():
            return [((sys.executable, "-m", "ziglang", "cc"), binary)]
    return []


def ask_version(command: Sequence[str]) -> str:
    """What the compiler says about itself: the first line and the target."""
    try:
        answer = subprocess.run(
            [*command, "--version"], capture_output=True, text=True, timeout=60, check=True
        )
    except (OSError, subprocess.SubprocessError) as error:
        raise BuildError(f"the compiler {' '.join(command)} does not answer: {error}") from error
    return answer.stdout.strip()


def find_compiler(remembered: Callable[[Path, Callable[[], str]], str]) -> Compiler:
    """The compiler to use here.

    Args:
        remembered: ``remembered(binary, ask)`` gives the version text, from memory if it can.

    Raises:
        BuildError: there is no compiler.
    """
    found = candidates()
    if found:
        command, binary = found[0]
        return Compiler(command, binary, remembered(binary, lambda: ask_version(command)))
    raise BuildError(
        "no C compiler here: looked for $CC, cc, gcc and clang on the PATH and for the Python "
        "package ziglang. Install one of them, such as: pip install 'cardan[compiler]'"
    )


def compile_shared(
    compiler: Compiler,
    sources: Sequence[Path],
    include: Sequence[Path],
    output: Path,
    reproducible: bool = False,
    scratch: Path | None = None,
) -> None:
    """Compile and link C files into one shared object, in one command.

    Args:
        include: Directories of headers.
        output: File to write.
        scratch: Where a compiler that keeps a cache of its own may put it.

    Raises:
        BuildError: with the compiler's message.
    """
    command = [
        *compiler.command,
        *compiler.flags(reproducible),
        *(f"-I{folder}" for folder in include),
        "-o",
        str(output),
        *(str(source) for source in sources),
        "-lm",
    ]
    environment = dict(os.environ)
    if scratch is not None:
        environment.setdefault("ZIG_GLOBAL_CACHE_DIR", str(scratch))
        environment.setdefault("ZIG_LOCAL_CACHE_DIR", str(scratch))
    try:
        answer = subprocess.run(command, capture_output=True, text=True, env=environment)
    except OSError as error:
        raise BuildError(f"{compiler.command[0]} could not be started: {error}") from error
    if answer.returncode:
        raise BuildError(
            f"{Path(compiler.command[0]).name} could not compile "
            f"{', '.join(str(source) for source in sources)} (status {answer.returncode}). "
            f"It was called as: {shlex.join(command)}\n{answer.stderr[-4000:].strip()}"
        )


@lru_cache(maxsize=1)
def processor() -> str:
    """What ``-march=native`` depends on: machine, model and instruction sets of the processor."""
    wanted = ("vendor_id", "model name", "flags", "Features", "CPU implementer", "CPU part")
    lines = [platform.machine()]
    try:
        with open("/proc/cpuinfo", encoding="utf-8", errors="replace") as file:
            # the first processor speaks for all: its block ends with an empty line
            for line in iter(file.readline, ""):
                if not line.strip():
                    break
                if line.startswith(wanted):
                    lines.append(line.strip())
    except OSError:
        lines.append(platform.processor())
    return "\n".join(lines)
