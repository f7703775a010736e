"""The one way to write a file that users name: beside, and renamed once it is whole."""

from __future__ import annotations

import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from .errors import ModelError

ROOM = "Make room or name another place"


@contextmanager
def replaced(path: Path) -> Iterator[str]:
    """A new file that takes the place of another one, or of none, once it is whole and on the disk.

    Where a link leads to a file, that file is replaced.

    Args:
        path: Of the file; the new one is written beside it, under the name that is given.

    Raises:
        ModelError: the directory does not exist, there is no room, or what has the name is not a
            regular file. What was there is as it was.
    """
    try:
        target = Path(os.path.realpath(path))
        if not target.parent.is_dir():
            raise ModelError(f"{path}: the directory {path.parent} does not exist")
        if target.exists() and not target.is_file():
            raise ModelError(f"{path} is not a regular file: name another one")
        # with the permissions of any other new file, unlike those of tempfile
        new = str(target.with_name(f".cardan-{secrets.token_hex(8)}{target.suffix}"))
        handle = os.open(new, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666)
    except (OSError, ValueError) as error:
        if isinstance(error, ModelError):
            raise
        raise ModelError(f"{path} cannot be written: {_why(error)}. {ROOM}") from error
    try:
        yield new
        os.fsync(handle)
        os.replace(new, target)
    except OSError as error:
        Path(new).unlink(missing_ok=True)
        raise ModelError(f"{path} cannot be written: {_why(error)}. {ROOM}") from error
    except BaseException:
        Path(new).unlink(missing_ok=True)
        raise
    finally:
        os.close(handle)


def written(path: Path, text: str) -> Path:
    """Write a text in UTF-8; the file appears complete or not at all. Returns its path.

    Raises:
        ModelError: as :func:`replaced`.
    """
    with replaced(path) as new:
        Path(new).write_text(text, encoding="utf-8", newline="\n")
    return path


def folder(path: Path) -> None:
    """Make the directory of a file, if there is none.

    Raises:
        ModelError: it cannot be made.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except (OSError, ValueError) as error:
        raise ModelError(f"{path}: its directory cannot be made: {_why(error)}. {ROOM}") from error


def _why(error: Exception) -> str:
    """Message of the operating system, without the name of the file."""
    return str(getattr(error, "strerror", None) or error)
