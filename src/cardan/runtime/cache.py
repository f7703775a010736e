"""The compile cache: shared objects under the hash of everything they were made of.

A file is ``<key>.so``: the object as the linker wrote it, then the SHA-256 of it. Loaders ignore
what follows the last section, so the check travels with the file and one rename publishes both.
Processes never wait for each other: each compiles in a folder of its own, ``.new-...``, and
renames. A lock in that folder says that its process lives; the system drops it with the process.
"""

from __future__ import annotations

import ctypes
import hashlib
import json
import os
import re
import shutil
import tempfile
import time
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

from .. import processes
from ..errors import BuildError
from . import folder, prebuilt
from .levels import LEVELS, Level, family
from .together import together
from .toolchain import Compiler, compile_shared, find_compiler
from .trust import exposed, own

DIGEST = 32
VERSION = "4"
NEW = ".new-"
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]+"([^"\n]+)"', re.MULTILINE)
LOCK = "lock"  # file in a folder that a living process compiles in
LARGEST, CHUNK = 1 << 30, 1 << 20  # bytes of an object, and of what is read of it at once
GRACE = 60.0  # seconds between the making of a folder and its lock, at the very most


@dataclass(frozen=True)
class Object:
    """A compiled shared object.

    Attributes:
        path: The file.
        fresh: True when it was compiled now, False when it was there.
        place: Where it belongs in the cache; None when it is there.
        lock: Descriptor that keeps others from sweeping it away before it is there.
    """

    path: Path
    fresh: bool
    place: Path | None = None
    lock: int = -1

    def load(self) -> ctypes.CDLL:
        """The object in this process.

        Raises:
            BuildError: the loader refuses it.
        """
        way = exposed(self.path.parent)
        if way:
            raise BuildError(
                f"compiled code is not loaded from {self.path.parent}: {way} now. Set "
                "CARDAN_CACHE to a folder of your own"
            )
        return self.library()

    def library(self) -> ctypes.CDLL:
        """The object in this process, from wherever it is: what was installed is trusted.

        Raises:
            BuildError: the loader refuses it.
        """
        try:
            return ctypes.CDLL(str(self.path))
        except OSError as error:
            raise BuildError(
                f"compiled code cannot be loaded: {error}. Is memory full, does "
                f"{self.path.parent} lie on a file system without permission to execute, or was "
                "it removed? Free memory, or set CARDAN_CACHE to "
                "another folder"
            ) from error

    def published(self) -> Object:
        """The same in its place in the cache, for other processes to find.

        Raises:
            BuildError: the cache was removed meanwhile.
        """
        if self.place is None:
            return self
        try:
            os.replace(self.path, self.place)
        except OSError as error:
            raise _unwritable(self.place.parent, error) from error
        finally:
            self.discard()
        return replace(self, path=self.place, place=None, lock=-1)

    def discard(self) -> None:
        """Forget it unless it is published: nobody finds it any more."""
        if self.place is not None:
            # first the lock: an open file cannot be removed on every system
            with suppress(OSError):
                os.close(self.lock)
            shutil.rmtree(self.path.parent, ignore_errors=True)


@lru_cache(maxsize=8)
def _compiler(cache: Path, chosen: str, path: str) -> Compiler:
    return find_compiler(lambda mark, ask: _remembered(cache, mark, ask))


def _without_level() -> Compiler:
    """The compiler in use, which does not know the processor."""
    return _compiler(folder.directory(), os.environ.get("CC", ""), os.environ.get("PATH", ""))


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
    wanted = os.environ.get("CARDAN_LEVEL", "").strip()
    return _level(wanted, None if prebuilt.level_object() else _without_level())


@lru_cache(maxsize=8)
def _level(wanted: str, by: Compiler | None) -> Level:
    """The level of a name, else the highest."""
    highest = _highest(by)
    levels = {one.name: one for one in family() if one.number <= highest.number}
    if not wanted or wanted in levels:
        return levels.get(wanted, highest)
    raise BuildError(
        f"CARDAN_LEVEL={wanted!r} is no set of instructions that this processor has: "
        f"{', '.join(levels)}"
    )


@lru_cache(maxsize=8)
def _highest(by: Compiler | None) -> Level:
    """The level of this processor, asked by code from the installation or of a compiler."""
    path = prebuilt.level_object()
    if by is None and path is not None:
        chooser = Object(path, False).library()
    else:
        chooser = build([prebuilt.DIRECTORY / prebuilt.LEVEL], by=by).load()
    return LEVELS[chooser.cardan_level()]


def _remembered(cache: Path, mark: str, ask: Callable[[], str]) -> str:
    file = cache / "compilers.json"
    try:
        known = {str(k): str(v) for k, v in json.loads(file.read_text(encoding="utf-8")).items()}
    except (OSError, ValueError, AttributeError):
        known = {}
    if mark not in known:
        known[mark] = ask()
        # a cache that cannot be written to only means that it is asked again
        with suppress(OSError):
            publish(file, json.dumps(known, indent=1).encode())
    return known[mark]


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
    words: Sequence[str] = (),
) -> str:
    """Hash of texts, headers, compiler and flags, the level of instructions among them."""
    parts = [VERSION, by.identity, *by.command, str(by.binary), *by.flags(reproducible), *words]
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
    words: Sequence[str] = (),
) -> Object:
    """The shared object of C files: from the cache, or compiled now and put there.

    Args and Raises: as :func:`compiled`.
    """
    return compiled(sources, include, reproducible, by, words).published()


def compiled(
    sources: Sequence[Path],
    include: Sequence[Path] = (),
    reproducible: bool = False,
    by: Compiler | None = None,
    words: Sequence[str] = (),
) -> Object:
    """The shared object of C files: from the cache, or compiled now and not yet published.

    Args:
        sources: C files, linked together.
        include: Directories of headers; those that are included are part of the key.
        reproducible: Equal bits from every compiler.
        by: The compiler; by default the one in use.
        words: What else the compiler is told, such as ``-DCARDAN_LANES=8``.

    Raises:
        CompilerMissing: no compiler. BuildError: it failed, or there is no room to write.
    """
    by = by or compiler()
    name = _name(sources, include, by, reproducible, words)
    there = _there(name)
    if there is not None:
        return there
    return _made_somewhere([name], sources, include, by, reproducible, words)[0]


def compiled_apart(
    texts: Sequence[Path],
    include: Path,
    reproducible: bool,
    by: Compiler,
    words: Sequence[str] = (),
) -> list[Object]:
    """An object of every C file: from the cache, or compiled now and not yet published.

    One run of the compiler takes many files, as each run spends 50 ms on itself: there are as many
    runs as processors. What it makes holds them all, and is each of their objects.

    Args:
        texts: C files of one directory, whose names are distinct from each other's.
        include: That directory.
        reproducible, by, words: As :func:`compiled` takes them.

    Raises:
        BuildError: the compiler failed, or there is no room to write.
    """
    names = [_name([text], [include], by, reproducible, words) for text in texts]
    found = {name: _there(name) for name in names}
    missing = {n: text for n, text in zip(names, texts, strict=True) if found[n] is None}
    tasks = [
        partial(_Several.made, share, [missing[n] for n in share], include, by, reproducible, words)
        for share in _shares({name: text.stat().st_size for name, text in missing.items()})
    ]
    for several in together(tasks):
        found |= several.objects
    return [one for name in names if (one := found[name]) is not None]


@dataclass(frozen=True)
class _Several:
    """What one run of a compiler made.

    Attributes:
        objects: By their names in the cache.
    """

    objects: dict[str, Object]

    @staticmethod
    def made(names: Sequence[str], *what: Any) -> _Several:
        """Compiled under these names."""
        return _Several(dict(zip(names, _made_somewhere(names, *what), strict=True)))

    def discard(self) -> None:
        """As :meth:`Object.discard`."""
        for one in self.objects.values():
            one.discard()


def _shares(sizes: dict[str, int]) -> list[list[str]]:
    """Names in as many shares of like size as there are processors."""
    shares: list[list[str]] = [[] for _ in range(min(len(sizes), os.cpu_count() or 1))]
    weights = [0] * len(shares)
    for name in sorted(sizes, key=lambda name: (-sizes[name], name)):
        least = weights.index(min(weights))
        shares[least].append(name)
        weights[least] += sizes[name]
    return shares


def _made_somewhere(names: Sequence[str], *what: Any) -> list[Object]:
    """Compiled in the cache, or where else there is room; as :func:`_made` takes it.

    Raises:
        BuildError: the compiler failed, or there is no room to write.
    """
    cache = folder.directory()
    try:
        return _made([cache / name for name in names], *what)
    except OSError as error:
        elsewhere = folder.instead(cache, f"{error.strerror or error}. {folder.cure(error)}")
    try:
        return _made([elsewhere / name for name in names], *what)
    except OSError as error:
        raise _unwritable(elsewhere, error) from error


def found(
    sources: Sequence[Path],
    include: Sequence[Path],
    reproducible: bool,
    by: Compiler,
    words: Sequence[str] = (),
) -> Object | None:
    """What :func:`compiled` would give, if it is in the cache."""
    return _there(_name(sources, include, by, reproducible, words))


def _name(
    sources: Sequence[Path],
    include: Sequence[Path],
    by: Compiler,
    reproducible: bool,
    words: Sequence[str],
) -> str:
    """File name of an object."""
    try:
        return f"{key(sources, headers(sources, include), by, reproducible, words)}.so"
    except OSError as error:
        raise BuildError(f"{error.filename} cannot be read: {error.strerror}") from error


def headers(sources: Sequence[Path], include: Sequence[Path]) -> set[Path]:
    """What the sources include, and what that includes: other scenes share texts that know no more.

    A header counts in every directory where it stands, whichever of them the compiler takes.
    """
    found: set[Path] = set()
    left = list(sources)
    while left:
        path = left.pop()
        names = INCLUDE.findall(path.read_text("utf-8", "replace"))
        places = (path.parent, *include)
        more = {place / name for name in names for place in places if (place / name).is_file()}
        left += more - found
        found |= more
    return found


def _there(name: str) -> Object | None:
    """An object that is in the cache, whole."""
    for place in (folder.directory() / name, *(other / name for other in folder.temporary())):
        if intact(place):
            folder.used(place)
            return Object(place, fresh=False)
    return None


def _unwritable(place: Path, error: OSError) -> BuildError:
    return BuildError(
        f"{place} cannot be written to ({error.strerror or error}). {folder.cure(error)}"
    )


def _made(
    places: Sequence[Path],
    sources: Sequence[Path],
    include: Path | Sequence[Path],
    by: Compiler,
    reproducible: bool,
    words: Sequence[str],
) -> list[Object]:
    """Compile and sign, in a folder of this process; an object that has several places is in each.

    Where there are several, every source has a place of its own.
    """
    cache = places[0].parent
    sweep(cache)
    made = [_begun(places[0])]
    try:
        output = made[0].path
        if len(places) > 1:
            # the directory of the sources is among those of headers
            text = "".join(f'#include "{source.name}"\n' for source in sources)
            sources = [output.with_suffix(".c")]
            sources[0].write_text(text, encoding="utf-8")
        folders = [include] if isinstance(include, Path) else include
        compile_shared(by, sources, folders, output, reproducible, cache / "zig", words)
        with open(output, "r+b") as file:
            content = file.read()
            file.write(hashlib.sha256(content).digest())
        for place in places[1:]:
            made.append(_begun(place))
            _linked(output, made[-1].path)
    except BaseException:
        for one in made:
            one.discard()
        raise
    return made


def _begun(place: Path) -> Object:
    """An object that is to come, in a folder of its own under a lock."""
    own = Path(tempfile.mkdtemp(dir=place.parent, prefix=NEW))
    made = Object(own / "object.so", True, place, os.open(own / LOCK, os.O_RDWR | os.O_CREAT))
    try:
        processes.lock(made.lock)
    except BaseException:
        made.discard()
        raise
    return made


def _linked(file: Path, place: Path) -> None:
    """The same file in another place; a copy where a file system has it once only."""
    try:
        os.link(file, place)
    except OSError:
        shutil.copyfile(file, place)


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
    """Whether no living process holds the lock of a path."""
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


def intact(path: Path) -> bool:
    """Whether the file is there, this user's alone, and is what the linker wrote."""
    try:
        # no link: what it leads to lies somewhere else
        handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
        with open(handle, "rb") as file:
            status, total = os.fstat(handle), hashlib.sha256()
            left = status.st_size - DIGEST
            if not own(status) or not 0 <= left <= LARGEST:
                return False
            # in chunks: a damaged file may be larger than memory
            while left > 0 and (chunk := file.read(min(left, CHUNK))):
                total.update(chunk)
                left -= len(chunk)
            return file.read(DIGEST + 1) == total.digest()
    except OSError:
        return False
