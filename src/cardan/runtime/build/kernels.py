"""C that serves every model: the files in ``kernels/``, compiled when cardan is installed."""

from __future__ import annotations

import ctypes
import os
import tempfile
import threading
import time
import zlib
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

from ... import processes
from ...records import dataclass
from ...schema import kernel_files
from . import cache, prebuilt
from .cpu_levels import LEVELS, Level, family
from .object_file import Object
from .toolchain import Compiler, compile_shared

# threads that want the same library at once wait for the one that compiles it
_LOCK = threading.Lock()


def _unlocked() -> None:
    """A new lock: the thread that held the old one is not part of a forked process."""
    global _LOCK
    _LOCK = threading.Lock()


processes.after_fork(_unlocked)


def library(
    reproducible: bool = False, lanes: int = 1, lane_parameters: bool = False
) -> ctypes.CDLL:
    """A loaded library of the kernels; calls through it release the GIL.

    It is the one that was compiled for the level in use when cardan was installed. Where there is
    none (no compiler then, another machine, changed sources, a rare variant) it is compiled into
    the cache.

    Args:
        reproducible: Without contraction.
        lanes, lane_parameters: States side by side, and whether each has parameters of its own.

    Raises:
        CompilerMissing: it is not there, and no compiler either. BuildError: compiling failed.
    """
    with _LOCK:
        return _library(cache.level(), prebuilt.Variant(reproducible, lanes, lane_parameters))


@lru_cache(maxsize=32)
def _library(level: Level, variant: prebuilt.Variant) -> ctypes.CDLL:
    installed = prebuilt.library(level, variant)
    if installed is not None:
        return Object(installed, False).library()
    built = cache.build(
        variant.sources(), kernel_files.includes(), variant.reproducible, extra=variant.macros
    )
    return built.load()


def install(place: Path, levels: Sequence[Level], by: Compiler, say: Callable[[str], None]) -> None:
    """Compile the kernels into a folder; what is there of the same sources and compiler stays.

    Args:
        place: The folder; what else is in it goes.
        levels: For which processors, in all variants; none: for this one, in the usual variants.
        by: The compiler, whatever its level.
        say: Takes one line for every library, and one for all.

    Raises:
        BuildError: compiling failed. OSError: there is no room.
    """
    started = time.perf_counter()
    place.mkdir(parents=True, exist_ok=True)
    plain = replace(by, level=(levels or family())[0].plainest())
    with (
        tempfile.TemporaryDirectory(dir=place) as scratch,
        ThreadPoolExecutor(os.cpu_count()) as pool,
    ):
        choice = _Library("level", [kernel_files.file(prebuilt.LEVEL)], plain)
        chooser = choice.compiled(place, Path(scratch), say)
        widths: Sequence[int] = prebuilt.WIDTHS
        if not levels:
            levels = (LEVELS[Object(place / chooser, False).library().cardan_level()],)
            widths = [levels[0].lanes] if levels[0].lanes > 1 else []
        work = [
            _Library(
                one.name, one.sources(), replace(by, level=level), one.reproducible, one.macros
            )
            for level in levels
            for one in prebuilt.variants(widths)
        ]
        names = list(pool.map(lambda one: one.compiled(place, Path(scratch), say), work))
    objects: dict[str, dict[str, str]] = {level.name: {} for level in levels}
    for variant, name in zip(work, names, strict=True):
        objects[variant.by.level.name][variant.name] = name
    cache.publish(place / prebuilt.INDEX, prebuilt.Index.of(by.identity, chooser, objects).text())
    prebuilt.reread()
    _library.cache_clear()
    for path in place.iterdir():
        if path.name not in (chooser, *names, prebuilt.INDEX):
            path.unlink()
    packed = sum(_packed(place / name) for name in (chooser, *names))
    say(
        f"kernels: {len(names) + 1} libraries, {packed / 1e6:.2f} MB compressed, "
        f"{time.perf_counter() - started:.1f} s"
    )


def _packed(path: Path) -> int:
    """Bytes of a file in a wheel."""
    return len(zlib.compress(path.read_bytes(), 9))


@dataclass(frozen=True)
class _Library:
    """One library to compile, as :func:`install` does it."""

    name: str
    sources: list[Path]
    by: Compiler
    reproducible: bool = False
    macros: tuple[str, ...] = ()

    def compiled(self, place: Path, scratch: Path, say: Callable[[str], None]) -> str:
        """Name of its file in a folder, where it is now."""
        started, include = time.perf_counter(), kernel_files.includes()
        headers = cache.headers(self.sources, include)
        name = f"{cache.key(self.sources, headers, self.by, self.reproducible, self.macros)}.so"
        path = place / name
        if not path.exists():
            options = self.reproducible, scratch / "zig", self.macros
            compile_shared(self.by, self.sources, include, scratch / name, *options)
            os.replace(scratch / name, path)
            say(
                f"kernels: {self.by.level.name:<10} {self.name:<16}"
                f"{path.stat().st_size:>8} bytes,{_packed(path):>7} compressed,"
                f"{time.perf_counter() - started:5.1f} s"
            )
        return name
