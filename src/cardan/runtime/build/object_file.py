"""Shared objects as files: what the linker wrote, then the SHA-256 of it.

Loaders ignore what follows the last section, so the check travels with the file and one rename
publishes both. Objects that are compiled together are made in a folder of their own, whose lock
says that their process lives: one, as a process may open few files.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
import shutil
import tempfile
from collections.abc import Sequence
from dataclasses import replace
from io import FileIO
from pathlib import Path

from ... import processes, regular_file
from ...errors import BuildError
from ...records import dataclass
from . import cache_folder
from .file_trust import exposed, is_mine

DIGEST = 32
NEW = ".new-"
LOCK = "lock"  # file in a folder that a living process compiles in
# no link: what it leads to lies somewhere else
FLAGS = regular_file.FLAGS | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
LARGEST, CHUNK = 1 << 30, 1 << 20  # bytes of an object, and of what is read of it at once


@dataclass(frozen=True)
class Workplace:
    """A folder in which objects wait until they are published.

    Attributes:
        lock: Open file.
        waiting: Those that are neither published nor forgotten.
    """

    lock: FileIO
    waiting: set[Path]

    def leave(self, path: Path) -> None:
        """An object waits no more; the last one takes the folder along."""
        self.waiting.discard(path)
        if not self.waiting:
            # first the lock: an open file cannot be removed on every system
            self.lock.close()
            shutil.rmtree(path.parent, ignore_errors=True)


@dataclass(frozen=True)
class Object:
    """A compiled shared object.

    Attributes:
        path: The file.
        fresh: True when it was compiled now, False when it was there.
        place: Where it belongs in the cache; None when it is there.
        workplace: What keeps others from sweeping it away before it is there.
    """

    path: Path
    fresh: bool
    place: Path | None = None
    workplace: Workplace | None = None

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
            raise unwritable(self.place.parent, error) from error
        finally:
            self.discard()
        return replace(self, path=self.place, place=None, workplace=None)

    def discard(self) -> None:
        """Forget it unless it is published: nobody finds it any more. Twice is as good as once."""
        if self.workplace is not None:
            self.workplace.leave(self.path)


def unwritable(place: Path, error: OSError) -> BuildError:
    """Error for a place that cannot be written to."""
    return BuildError(
        f"{place} cannot be written to ({error.strerror or error}). {cache_folder.cure(error)}"
    )


def begun(places: Sequence[Path]) -> list[Object]:
    """Objects that are to come, in a folder of their own under a lock."""
    directory = Path(tempfile.mkdtemp(dir=places[0].parent, prefix=NEW))
    paths = [directory / f"object{k or ''}.so" for k in range(len(places))]
    lock = FileIO(os.open(directory / LOCK, os.O_RDWR | os.O_CREAT), "r+")
    workplace = Workplace(lock, set(paths))
    objects = [
        Object(path, True, place, workplace) for path, place in zip(paths, places, strict=True)
    ]
    try:
        processes.lock(lock.fileno())
    except BaseException:
        for one in objects:
            one.discard()
        raise
    return objects


def linked(file: Path, place: Path) -> None:
    """The same file in another place; a copy where a file system has it once only."""
    try:
        os.link(file, place)
    except OSError:
        shutil.copyfile(file, place)


def seal(path: Path) -> None:
    """Put the check behind an object that was linked just now."""
    with open(path, "r+b") as file:
        content = file.read()
        file.write(hashlib.sha256(content).digest())


def intact(path: Path) -> bool:
    """True when the file is there, this user's alone, and is what the linker wrote."""
    try:
        handle = os.open(path, FLAGS)
        with open(handle, "rb") as file:
            status, total = os.fstat(handle), hashlib.sha256()
            left = status.st_size - DIGEST
            if not is_mine(status) or not 0 <= left <= LARGEST:
                return False
            # in chunks: a damaged file may be larger than memory
            while left > 0 and (chunk := file.read(min(left, CHUNK))):
                total.update(chunk)
                left -= len(chunk)
            return file.read(DIGEST + 1) == total.digest()
    except OSError:
        return False
