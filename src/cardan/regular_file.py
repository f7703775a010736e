"""The one way to read a file that somebody else may have made.

What a name leads to may be a pipe that never ends, a device, or a link to one: it is opened
without waiting, must be a regular file, and at most a limit of it is read.
"""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path
from typing import BinaryIO

LARGEST = 1 << 31  # bytes
CHUNK = 1 << 20
# where a system lacks these words, it lacks what they are for
FLAGS = os.O_RDONLY | sum(getattr(os, f"O_{name}", 0) for name in ("NONBLOCK", "CLOEXEC", "NOCTTY"))
KINDS = (
    (stat.S_ISDIR, errno.EISDIR, "it is a directory"),
    (stat.S_ISFIFO, errno.EINVAL, "it is a pipe"),
    (stat.S_ISSOCK, errno.EINVAL, "it is a socket"),
    (stat.S_ISCHR, errno.EINVAL, "it is a device"),
    (stat.S_ISBLK, errno.EINVAL, "it is a device"),
)


def open_regular(path: str | Path, limit: int = LARGEST) -> BinaryIO:
    """A regular file, open for reading at its start.

    Args:
        path: The file, or a link to it.
        limit: Size in bytes that it may have.

    Raises:
        OSError: it is missing, no regular file, too large or may not be read; ``strerror`` says
            which.
    """
    _nameable(path)
    # opening a device can do something: look before, and at what was opened
    _regular(os.stat(path), path, limit)
    handle = os.open(path, FLAGS | getattr(os, "O_BINARY", 0))
    try:
        _regular(os.fstat(handle), path, limit)
        return os.fdopen(handle, "rb")
    except BaseException:
        os.close(handle)
        raise


def content(path: str | Path, limit: int = LARGEST) -> bytes:
    """The bytes of a regular file.

    Raises:
        OSError: as :func:`open_regular`; or it has grown beyond the limit meanwhile.
    """
    with open_regular(path, limit) as file:
        contents = file.read(os.fstat(file.fileno()).st_size + 1)
        # some files of the system have no size, and others grow
        while len(contents) <= limit and (more := file.read(CHUNK)):
            contents += more
    if len(contents) > limit:
        raise _too_large(len(contents), path, limit)
    return contents


def grown(path: str | Path) -> int:
    """Descriptor of a regular file, made if there is none, to read and to write at its end.

    Raises:
        OSError: it is not a regular file, or may not be written to.
    """
    _nameable(path)
    if os.path.exists(path):
        _regular(os.stat(path), path, 1 << 62)
    handle = os.open(path, FLAGS | os.O_RDWR | os.O_CREAT, 0o666)
    try:
        _regular(os.fstat(handle), path, 1 << 62)
    except BaseException:
        os.close(handle)
        raise
    return handle


def text(path: str | Path, limit: int = LARGEST) -> str:
    """The UTF-8 text of a regular file.

    Raises:
        OSError: as :func:`content`. UnicodeDecodeError: it is not UTF-8.
    """
    return content(path, limit).decode("utf-8")


def _nameable(path: str | Path) -> None:
    if "\0" in str(path):
        raise OSError(errno.EINVAL, "a NUL is in no name of a file", str(path))


def _regular(status: os.stat_result, path: str | Path, limit: int) -> None:
    for of_kind, number, description in KINDS:
        if of_kind(status.st_mode):
            raise OSError(number, f"{description}, not a regular file", str(path))
    if not stat.S_ISREG(status.st_mode):
        raise OSError(errno.EINVAL, "it is not a regular file", str(path))
    if status.st_size > limit:
        raise _too_large(status.st_size, path, limit)


def _too_large(size: int, path: str | Path, limit: int) -> OSError:
    reason = f"it has {size / 2**20:.0f} MiB, at most {limit / 2**20:g} MiB are read"
    return OSError(errno.EFBIG, reason, str(path))
