"""The compile cache: shared objects under the hash of everything they were made of.

A file is ``<key>.so``: the object as the linker wrote it, then the SHA-256 of it. Loaders ignore
what follows the last section, so the check travels with the file and one rename publishes both.
Processes never wait for each other: each compiles to a name of its own and renames.
"""

from __future__ import annotations

import hashlib
import json
import os
import stat
import tempfile
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from ..errors import BuildError
from .toolchain import Compiler, compile_shared, find_compiler, processor

DIGEST = 32
VERSION = "1"
ABANDONED = 3600.0


@dataclass(frozen=True)
class Object:
    """A shared object in the cache.

    Attributes:
        path: The file.
        fresh: True when it was compiled now, False when it was there.
    """

    path: Path
    fresh: bool

    def discard(self) -> None:
        """Take it out of the cache, so that nobody loads it again."""
        self.path.unlink(missing_ok=True)


def directory() -> Path:
    """The cache of this user, made with mode 0700: ``$CARDAN_CACHE`` or the usual place.

    Raises:
        BuildError: it belongs to somebody else or others may write to it.
    """
    named = os.environ.get("CARDAN_CACHE")
    usual = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return _private(named or os.path.join(usual, "cardan"))


@lru_cache(maxsize=8)
def _private(name: str) -> Path:
    path = Path(name)
    try:
        path.mkdir(mode=0o700, parents=True, exist_ok=True)
        status = path.stat()
    except OSError as error:
        raise BuildError(
            f"the compile cache {path} cannot be made ({error.strerror}). "
            "Set CARDAN_CACHE to a directory that you may write to."
        ) from error
    # an object loaded from here runs as this user: nobody else may put one there
    if status.st_uid != os.getuid() or status.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
        raise BuildError(
            f"the compile cache {path} is not private: it must belong to you and nobody else may "
            f"write to it. Run: chmod 700 {path}, or set CARDAN_CACHE to another directory."
        )
    return path


@lru_cache(maxsize=8)
def _compiler(cache: Path, chosen: str, path: str) -> Compiler:
    return find_compiler(lambda binary, ask: _remembered(cache, binary, ask))


def compiler() -> Compiler:
    """The compiler in use, found once per process and setting of CC and PATH."""
    return _compiler(directory(), os.environ.get("CC", ""), os.environ.get("PATH", ""))


def _remembered(cache: Path, binary: Path, ask: Callable[[], str]) -> str:
    """The version text of a compiler, kept on disk by path, time of change and size."""
    status = binary.stat()
    mark = f"{binary}|{status.st_mtime_ns}|{status.st_size}"
    file = cache / "compilers.json"
    try:
        known: dict[str, str] = dict(json.loads(file.read_text(encoding="utf-8")))
    except (OSError, ValueError, TypeError):
        known = {}
    if mark not in known:
        known[mark] = ask()
        publish(file, json.dumps(known, indent=1).encode())
    return known[mark]


def publish(path: Path, content: bytes) -> None:
    """Write a file so that readers see all of it or nothing."""
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=".new-")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        os.replace(name, path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def key(sources: Sequence[Path], headers: Iterable[Path], by: Compiler, reproducible: bool) -> str:
    """Hash of texts, headers, flags, compiler and processor."""
    parts = [VERSION, by.identity, str(by.binary), *by.flags(reproducible), processor()]
    digest = hashlib.sha256("\0".join(parts).encode())
    for path in [*sources, *sorted(headers)]:
        content = path.read_bytes()
        digest.update(f"\0{path.name}\0{len(content)}\0".encode())
        digest.update(content)
    return digest.hexdigest()


def build(
    sources: Sequence[Path], include: Sequence[Path] = (), reproducible: bool = False
) -> Object:
    """The shared object of C files: from the cache, or compiled now.

    Args:
        sources: C files, linked together.
        include: Directories; every header in them is part of the key.

    Raises:
        BuildError: no compiler, or it failed.
    """
    cache, by = directory(), compiler()
    headers = [header for folder in include for header in folder.glob("*.h")]
    path = cache / f"{key(sources, headers, by, reproducible)}.so"
    if intact(path):
        return Object(path, fresh=False)
    sweep(cache)
    handle, name = tempfile.mkstemp(dir=cache, prefix=".new-", suffix=".so")
    os.close(handle)
    new = Path(name)
    try:
        compile_shared(by, sources, include, new, reproducible, scratch=cache / "zig")
        # sign, then publish in one step: a killed compile leaves only a name nobody asks for
        with open(new, "r+b") as file:
            content = file.read()
            file.write(hashlib.sha256(content).digest())
        os.replace(new, path)
    except BaseException:
        new.unlink(missing_ok=True)
        raise
    return Object(path, fresh=True)


def sweep(cache: Path) -> None:
    """Remove what killed compiles left behind long ago."""
    long_ago = time.time() - ABANDONED
    for path in cache.glob(".new-*"):
        try:
            if path.stat().st_mtime < long_ago:
                path.unlink()
        except FileNotFoundError:
            # another process was quicker
            continue


def intact(path: Path) -> bool:
    """Whether the file is there and is what the linker wrote."""
    try:
        content = path.read_bytes()
    except OSError:
        return False
    return hashlib.sha256(content[:-DIGEST]).digest() == content[-DIGEST:]
