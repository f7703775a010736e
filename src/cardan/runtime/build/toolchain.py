"""Find a C compiler on this machine and drive it: one command per shared object."""

from __future__ import annotations

import errno
import importlib.util
import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import NamedTuple, NoReturn

from ...errors import BuildError, CompilerMissing
from ...records import dataclass
from . import limited_subprocess
from .cpu_levels import OTHER, X86, Level

NAMES = ("cc", "gcc", "clang")
COMMON_FLAGS = ("-std=c99", "-O2", "-fno-tree-vectorize", "-fno-math-errno")
OPTIMIZATIONS = ("0", "1", "2", "3")
# Tunings such as znver3 avoid chains of fused multiply-adds in scalars and narrow vectors only: a
# scalar build would get other bits than a build for wide lanes. gcc 8 was the first to do so.
ALL_CHAINS = "--param=avoid-fma-max-bits=0"
FIRST_TO_AVOID = 8
SHARED_FLAGS = ("-shared", "-fPIC", "-pipe")
MAX_PRINTED = 8


@dataclass(frozen=True)
class Compiler:
    """A C compiler of this machine.

    Attributes:
        command: How it is called, without flags.
        binary: The program whose change means another compiler.
        identity: What it says about its version.
        options: Language and optimization.
        level: The instructions that it may use.
    """

    command: tuple[str, ...]
    binary: Path
    identity: str
    options: tuple[str, ...] = COMMON_FLAGS
    level: Level = OTHER

    @property
    def family(self) -> str:
        """``"clang"`` or ``"gcc"``: they spell contraction differently."""
        return "clang" if "clang" in self.identity.lower() else "gcc"

    @property
    def is_zig(self) -> bool:
        """True if it is the clang of ziglang, which compiles several files at once by itself."""
        return any("zig" in Path(word).name for word in self.command)

    @property
    def tuning(self) -> tuple[str, ...]:
        """Flags that arrange the instructions for this very processor, without other bits.

        Measured on functions of one state at a time: up to a sixth less time; lanes lose 3 %.
        """
        return ("-mtune=native",) if self.level in X86 and not self.is_zig else ()

    def flags(self, reproducible: bool = False) -> tuple[str, ...]:
        """Flags of a scalar unit; contraction is always given.

        Args:
            reproducible: No contraction: every compiler of IEEE arithmetic gives equal bits.
        """
        # what zig writes for debuggers by itself is four times the code
        level = (*self.level.zig, "-g0", "-s") if self.is_zig else self.level.flags
        return (*self.options, *level, *self.contraction(reproducible), *SHARED_FLAGS)

    def for_models(self) -> Compiler:
        """The same with the optimization that ``$CARDAN_OPTIMIZATION`` names; not for kernels.

        Raises:
            BuildError: it is not one of 0, 1, 2, 3.
        """
        optimization = os.environ.get("CARDAN_OPTIMIZATION", "").strip()
        if not optimization:
            return self
        if optimization in OPTIMIZATIONS:
            # the last one counts
            return replace(self, options=(*self.options, f"-O{optimization}"))
        raise BuildError(
            f"CARDAN_OPTIMIZATION={optimization!r} must be one of {', '.join(OPTIMIZATIONS)}"
        )

    def contraction(self, reproducible: bool = False) -> tuple[str, ...]:
        """Flags that say which sums of products become one fused operation.

        Args:
            reproducible: None of them: every compiler of IEEE arithmetic gives equal bits.
        """
        if reproducible:
            return ("-ffp-contract=off",)
        if self.family == "clang":
            return ("-ffp-contract=on",)
        release = re.search(r"\b(\d+)\.\d+", self.identity.partition("\n")[0])
        if release and int(release[1]) < FIRST_TO_AVOID:
            return ("-ffp-contract=fast",)
        return ("-ffp-contract=fast", ALL_CHAINS)


class Candidate(NamedTuple):
    """A compiler that may be there.

    Attributes:
        command: How it is called.
        binary: The program whose change means another compiler.
        name: As users know it: ``$CC``, ``gcc``, ``ziglang``.
    """

    command: tuple[str, ...]
    binary: Path
    name: str

    def mark(self) -> str:
        """Text that changes when the compiler does."""
        status = self.binary.stat()
        command = " ".join(self.command)
        return f"{command}|{self.binary}|{status.st_mtime_ns}|{status.st_size}"


def candidates() -> Iterator[Candidate]:
    """Compilers to try, in this order: cc, gcc, clang, ``ziglang``; or what ``$CC`` names alone.

    Raises:
        BuildError: ``$CC`` names nothing that can be run.
    """
    if os.environ.get("CC", "").strip():
        yield _named(os.environ["CC"])
        return
    for path, name in ((shutil.which(name), name) for name in NAMES):
        if path:
            yield Candidate((path,), Path(path).resolve(), name)
    yield from ziglang()


def _named(text: str) -> Candidate:
    """The compiler that CC speaks of."""
    try:
        arguments = shlex.split(text)
    except ValueError as error:
        raise BuildError(f"CC={text!r} is not a command: {error}") from None
    path = shutil.which(arguments[0])
    if path is None:
        raise BuildError(
            f"CC={text!r}: there is no program {arguments[0]!r} on the PATH. Correct CC, or unset "
            "it to have cc, gcc, clang and ziglang tried"
        )
    return Candidate((path, *arguments[1:]), Path(path).resolve(), "$CC")


def ziglang() -> list[Candidate]:
    """The clang of the Python package ziglang; [] where it is not installed."""
    spec = importlib.util.find_spec("ziglang")
    for folder in (spec.submodule_search_locations or []) if spec else []:
        for name in ("zig", "zig.exe"):
            binary = Path(folder) / name
            if binary.exists():
                return [Candidate((sys.executable, "-m", "ziglang", "cc"), binary, "ziglang")]
    return []


def ask_version(command: Sequence[str]) -> str:
    """Version of the compiler: its first line and the target."""
    try:
        answer = subprocess.run(
            [*command, "--version"],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=60,
            check=True,
        )
    except (OSError, subprocess.SubprocessError) as error:
        raise BuildError(f"the compiler {' '.join(command)} does not answer: {error}") from error
    return answer.stdout.strip()


def find_compiler(remembered: Callable[[str, Callable[[], str]], str]) -> Compiler:
    """The first compiler that answers.

    Args:
        remembered: ``remembered(mark, ask)`` gives the version text, from memory if it can.

    Raises:
        CompilerMissing: there is no compiler. BuildError: what ``$CC`` names does not answer.
    """
    silent = ""
    for candidate in candidates():
        command = candidate.command
        try:
            identity = remembered(candidate.mark(), partial(ask_version, command))
        except BuildError as error:
            if candidate.name == "$CC":
                raise
            silent += f"; {error}"
            continue
        return Compiler(command, candidate.binary, identity)
    raise CompilerMissing(
        "no C compiler here: looked for $CC, cc, gcc and clang on the PATH and for the Python "
        f"package ziglang{silent}. Install one of them, such as: pip install 'cardan[compiler]'"
    )


def compile_shared(
    compiler: Compiler,
    sources: Sequence[Path],
    include: Sequence[Path],
    output: Path,
    reproducible: bool = False,
    scratch: Path | None = None,
    extra: Sequence[str] = (),
    included: Sequence[Path] = (),
) -> None:
    """Compile and link C files into one shared object, in one command, within limits.

    Args:
        include: Directories of headers.
        output: File to write; beside it the compiler may keep what it needs meanwhile.
        scratch: Where a compiler that keeps a cache of its own may put it.
        extra: What else it is told, such as ``-DCARDAN_LANES=8``.
        included: Files that messages name instead, where the sources only include them.

    Raises:
        BuildError: with the compiler's message. OSError: there is no room for the output.
    """
    command = [
        *compiler.command,
        *compiler.flags(reproducible),
        *extra,
        *(f"-I{folder}" for folder in include),
        "-o",
        str(output),
        *(str(source) for source in sources),
        "-lm",
    ]
    environment = {**os.environ, "LC_ALL": "C", "TMPDIR": str(output.parent)}
    if scratch is not None:
        environment.setdefault("ZIG_GLOBAL_CACHE_DIR", str(scratch))
        environment.setdefault("ZIG_LOCAL_CACHE_DIR", str(scratch))
    limits = limited_subprocess.Limits.of_environment()
    try:
        answer = limited_subprocess.run(command, limits, environment)
    except OSError as error:
        raise BuildError(f"{compiler.command[0]} could not be started: {error}") from error
    if answer.status:
        _complain(command, [source.name for source in included or sources], answer, limits)


FULL = ("No space left on device", "NoSpaceLeft", "Disk quota exceeded", "File too large")
GREEDY = ("out of memory", "OutOfMemory", "Cannot allocate memory", "memory exhausted")


def _complain(
    command: Sequence[str],
    sources: Sequence[str],
    answer: limited_subprocess.Answer,
    limits: limited_subprocess.Limits,
) -> NoReturn:
    """Say what stopped a compiler, and what to do."""
    if any(text in answer.errors for text in FULL):
        raise OSError(errno.ENOSPC, "No space left on device")
    program, what = Path(command[0]).name, ", ".join(sources[:MAX_PRINTED])
    if len(sources) > MAX_PRINTED:
        what += f" and {len(sources) - MAX_PRINTED} more"
    if answer.late or "CPU time limit" in answer.errors:
        raise BuildError(
            f"{program} was stopped: {what} took it longer than {limits.seconds} s. Allow more "
            "with CARDAN_COMPILE_SECONDS, or try another compiler (CC) or another method="
        )
    if any(text in answer.errors for text in GREEDY):
        raise BuildError(
            f"{program} was stopped: {what} takes more than {limits.memory} MiB of memory. Allow "
            "more with CARDAN_COMPILE_MEMORY, or try another compiler (CC) or another method="
        )
    raise BuildError(
        f"{program} could not compile {what} (status {answer.status}):\n{_errors(answer.errors)}\n"
        f"It was called as: {shlex.join(command)}\n"
        "Another compiler may take it: set CC, or pip install 'cardan[compiler]' and CC='python "
        "-m ziglang cc'"
    )


def _errors(text: str) -> str:
    """The first lines of a compiler's answer that speak of errors."""
    lines = [line for line in text.splitlines() if line.strip()]
    telling = [line for line in lines if "error" in line.lower()]
    return "\n".join((telling or lines)[:MAX_PRINTED]) or "it said nothing"
