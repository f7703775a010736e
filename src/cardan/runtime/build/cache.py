"""The compile cache: shared objects, ``<key>.so``, under the hash of all they were made of.

Processes never wait for each other: each compiles in a folder of its own, ``.new-...``, and
renames. A lock in that folder says that its process lives; the system drops it with the process.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import re
import shutil
import tempfile
import time
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

from ... import processes
from ...errors import BuildError
from ...records import dataclass
from ...schema import kernel_files
from . import cache_folder, prebuilt
from .cpu_levels import LEVELS, Level, family
from .object_file import LOCK, NEW, Object, begun, intact, linked, seal, unwritable
from .parallel_build import in_parallel
from .toolchain import Compiler, compile_shared, find_compiler

VERSION = "4"
INCLUDE = re.compile(r'#[ \t]*include[ \t]+"([^"\n]+)"')
GRACE = 60.0  # seconds between the making of a folder and its lock, at the very most
RUN = 1_000_000  # bytes of texts from which on one run of the compiler takes no more


@lru_cache(maxsize=8)
def _compiler(cache: Path, chosen: str, path: str) -> Compiler:
    return find_compiler(lambda mark, ask: _remembered(cache, mark, ask))


def _without_level() -> Compiler:
    """The compiler in use, which does not know the processor."""
    return _compiler(cache_folder.directory(), os.environ.get("CC", ""), os.environ.get("PATH", ""))


def compiler() -> Compiler:
    """The compiler in use and its level, found once per process and setting of CC and PATH.

    Raises:
        CompilerMissing: there is none. BuildError: the one that CC names does not work.
    """
    return replace(_without_level(), level=level())


def level() -> Level:
    """The level in use: what ``$CARDAN_LEVEL`` names, else the highest that the processor has.

    Raises:
        CompilerMissing: nothing was compiled when cardan was installed, and nothing can be.
        BuildError: CARDAN_LEVEL names none that this processor has.
    """
    requested = os.environ.get("CARDAN_LEVEL", "").strip()
    return _level(requested, prebuilt.level_object() or _without_level())


@lru_cache(maxsize=8)
def _level(requested: str, by: Path | Compiler) -> Level:
    """The level of a name, else the highest."""
    highest = _highest(by)
    levels = {one.name: one for one in family() if one.number <= highest.number}
    if not requested or requested in levels:
        return levels.get(requested, highest)
    raise BuildError(
        f"CARDAN_LEVEL={requested!r} is not a set of instructions that this processor has: "
        f"{', '.join(levels)}"
    )


@lru_cache(maxsize=8)
def _highest(by: Path | Compiler) -> Level:
    """The level of this processor, asked by code from the installation or of a compiler."""
    if isinstance(by, Path):
        chooser = Object(by, False).library()
    else:
        chooser = build([kernel_files.file(prebuilt.LEVEL)], by=by).load()
    return LEVELS[chooser.cardan_level()]


def _remembered(cache: Path, mark: str, ask: Callable[[], str]) -> str:
    file = cache / "compilers.json"
    try:
        identities = {
            str(k): str(v) for k, v in json.loads(file.read_text(encoding="utf-8")).items()
        }
    except (OSError, ValueError, AttributeError):
        identities = {}
    if mark not in identities:
        identities[mark] = ask()
        # a cache that cannot be written to only means that it is asked again
        with suppress(OSError):
            publish(file, json.dumps(identities, indent=1).encode())
    return identities[mark]


def publish(path: Path, content: bytes) -> None:
    """Write a file so that readers see all of it or nothing."""
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=NEW)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        os.replace(name, path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def key(
    sources: Sequence[Path],
    headers: Iterable[Path],
    by: Compiler,
    reproducible: bool,
    extra: Sequence[str] = (),
) -> str:
    """Hash of texts, headers, compiler and flags, the level of instructions among them."""
    parts = [VERSION, by.identity, *by.command, str(by.binary), *by.flags(reproducible), *extra]
    digest = hashlib.sha256("\0".join(parts).encode())
    for path in [*sources, *sorted(headers, key=lambda path: (path.name, path))]:
        content = path.read_bytes()
        digest.update(f"\0{path.name}\0{len(content)}\0".encode())
        digest.update(content)
    return digest.hexdigest()


def build(
    sources: Sequence[Path],
    include: Sequence[Path] = (),
    reproducible: bool = False,
    by: Compiler | None = None,
    extra: Sequence[str] = (),
) -> Object:
    """The shared object of C files: from the cache, or compiled now and put there.

    Args and Raises: as :func:`compiled`.
    """
    return compiled(sources, include, reproducible, by, extra).published()


def compiled(
    sources: Sequence[Path],
    include: Sequence[Path] = (),
    reproducible: bool = False,
    by: Compiler | None = None,
    extra: Sequence[str] = (),
) -> Object:
    """The shared object of C files: from the cache, or compiled now and not yet published.

    Args:
        sources: C files, linked together.
        include: Directories of headers; those that are included are part of the key.
        reproducible: Equal bits from every compiler.
        by: The compiler; by default the one in use.
        extra: What else the compiler is told, such as ``-DCARDAN_LANES=8``.

    Raises:
        CompilerMissing: no compiler. BuildError: it failed, or there is no room to write.
    """
    by = by or compiler()
    name = _name(sources, include, by, reproducible, extra)
    there = _there(name)
    if there is not None:
        return there
    return _compiled_anywhere([name], sources, include, by, reproducible, extra)[0]


def compiled_separately(
    texts: Sequence[Path],
    include: Path,
    reproducible: bool,
    by: Compiler,
    extra: Sequence[Sequence[str]],
) -> list[Object]:
    """An object of every C file: from the cache, or compiled now and not yet published.

    One run of the compiler takes many files, as each run spends 50 ms on itself: there are as many
    runs as processors, more where texts are large, as limits of time and memory are those of a
    run, or where the compiler is told something else. What it makes holds them all, and is each of
    their objects.

    Args:
        texts: C files of one directory, whose names are distinct from each other's.
        include: That directory.
        reproducible, by: As :func:`compiled` takes them.
        extra: What else the compiler is told of every file.

    Raises:
        BuildError: the compiler failed, or there is no room to write.
    """
    pairs = zip(texts, extra, strict=True)
    names = [
        _name([text], [include], by, reproducible, flags_of_text) for text, flags_of_text in pairs
    ]
    flags = {name: tuple(words) for name, words in zip(names, extra, strict=True)}
    objects = {name: _there(name) for name in names}
    missing = {n: text for n, text in zip(names, texts, strict=True) if objects[n] is None}
    sizes = {name: text.stat().st_size for name, text in missing.items()}
    tasks = []
    for words in dict.fromkeys(flags.values()):
        share_sizes = {name: size for name, size in sizes.items() if flags[name] == words}
        for share in _shares(share_sizes, sum(sizes.values())):
            what = include, by, reproducible, words
            tasks.append(partial(_Several.compiled, share, [missing[n] for n in share], *what))
    for several in in_parallel(tasks):
        objects |= several.objects
    return [one for name in names if (one := objects[name]) is not None]


@dataclass(frozen=True)
class _Several:
    """Results of one run of a compiler.

    Attributes:
        objects: By their names in the cache.
    """

    objects: dict[str, Object]

    @staticmethod
    def compiled(names: Sequence[str], *what: object) -> _Several:
        """Compiled under these names."""
        return _Several(dict(zip(names, _compiled_anywhere(names, *what), strict=True)))

    def discard(self) -> None:
        """Same as :meth:`Object.discard`."""
        for one in self.objects.values():
            one.discard()


def _shares(sizes: dict[str, int], total: int) -> list[list[str]]:
    """Names in shares of like size, one for each run of the compiler; all sizes give the total."""
    weight = sum(sizes.values())
    count = max(math.ceil((os.cpu_count() or 1) * weight / max(total, 1)), -(-weight // RUN))
    shares: list[list[str]] = [[] for _ in range(min(len(sizes), count))]
    weights = [0] * len(shares)
    for name in sorted(sizes, key=lambda name: (-sizes[name], name)):
        least = weights.index(min(weights))
        shares[least].append(name)
        weights[least] += sizes[name]
    return shares


def _compiled_anywhere(names: Sequence[str], *what: Any) -> list[Object]:
    """Compiled in the cache, or where else there is room; as :func:`_compiled` takes it.

    Raises:
        BuildError: the compiler failed, or there is no room to write.
    """
    cache = cache_folder.directory()
    try:
        return _compiled([cache / name for name in names], *what)
    except OSError as error:
        elsewhere = cache_folder.instead(
            cache, f"{error.strerror or error}. {cache_folder.cure(error)}"
        )
    try:
        return _compiled([elsewhere / name for name in names], *what)
    except OSError as error:
        raise unwritable(elsewhere, error) from error


def cached(
    sources: Sequence[Path],
    include: Sequence[Path],
    reproducible: bool,
    by: Compiler,
    extra: Sequence[str] = (),
) -> Object | None:
    """The object that :func:`compiled` would give, if it is in the cache."""
    return _there(_name(sources, include, by, reproducible, extra))


def _name(
    sources: Sequence[Path],
    include: Sequence[Path],
    by: Compiler,
    reproducible: bool,
    extra: Sequence[str],
) -> str:
    """File name of an object."""
    try:
        return f"{key(sources, headers(sources, include), by, reproducible, extra)}.so"
    except OSError as error:
        raise BuildError(f"{error.filename} cannot be read: {error.strerror}") from error


def headers(sources: Sequence[Path], include: Sequence[Path]) -> set[Path]:
    """Headers that the sources include, directly or not:

    other scenes share texts that know no more.

    A header counts in every directory where it stands, whichever of them the compiler takes.
    """
    included: set[Path] = set()
    left = list(sources)
    while left:
        path = left.pop()
        names = INCLUDE.findall(path.read_text("utf-8", "replace"))
        places = {path.parent, *include}
        more = {file for name in names for place in places if (file := place / name).is_file()}
        left += more - included
        included |= more
    return included


def _there(name: str) -> Object | None:
    """An object that is in the cache, whole."""
    for place in (
        cache_folder.directory() / name,
        *(other / name for other in cache_folder.temporary()),
    ):
        if intact(place):
            cache_folder.used(place)
            return Object(place, fresh=False)
    return None


def _compiled(
    places: Sequence[Path],
    sources: Sequence[Path],
    include: Path | Sequence[Path],
    by: Compiler,
    reproducible: bool,
    extra: Sequence[str],
) -> list[Object]:
    """Compile and sign, in a folder of this process; an object that has several places is in each.

    Where there are several, every source has a place of its own.
    """
    cache = places[0].parent
    sweep(cache)
    objects = begun(places)
    try:
        output, files = objects[0].path, sources
        if len(places) > 1:
            # the directory of the sources is among those of headers
            text = "".join(f'#include "{source.name}"\n' for source in sources)
            files = [output.with_suffix(".c")]
            files[0].write_text(text, encoding="utf-8")
        folders = [include] if isinstance(include, Path) else include
        options = reproducible, cache / "zig", extra, sources
        compile_shared(by, files, folders, output, *options)
        seal(output)
        for one in objects[1:]:
            linked(output, one.path)
    except BaseException:
        for one in objects:
            one.discard()
        raise
    return objects


def sweep(cache: Path) -> list[Path]:
    """Remove what killed processes left behind; returns what it was."""
    long_ago, gone = time.time() - GRACE, []
    for path in cache.glob(f"{NEW}*"):
        try:
            if path.stat().st_mtime < long_ago and _abandoned(path):
                shutil.rmtree(path) if path.is_dir() else path.unlink()
                gone.append(path)
        except OSError:
            # another process was quicker, or it is not ours to remove
            continue
    return gone


def _abandoned(path: Path) -> bool:
    """True when no living process holds the lock of a path."""
    try:
        handle = os.open(path / LOCK if path.is_dir() else path, os.O_RDWR)
    except FileNotFoundError:
        return True
    try:
        processes.lock(handle, wait=False)
    except BlockingIOError:
        return False
    finally:
        os.close(handle)
    return True
