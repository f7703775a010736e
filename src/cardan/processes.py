"""Locks between processes, what a forked child does first, Ctrl-C, and the collector of cycles.

A lock belongs to an open file and is dropped with it, also where its process is killed: it says
that a process lives. Where ``flock`` is missing (Windows) the last byte that the C library can name
is locked, because others cannot read a locked byte there.
"""

from __future__ import annotations

import ctypes
import errno
import gc
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import IO

LAST_BYTE = (1 << 31) - 2
# of flock, on every system that has it
LOCK_EX, LOCK_NB = 2, 4
# of a folder whose files belong together
FOLDER_LOCK = ".lock"
_FOLDER_LOCKS: set[IO[str]] = set()


def _module(name: str) -> ModuleType | None:
    try:
        return import_module(name)
    except ImportError:
        return None


_FCNTL, _MSVCRT = _module("fcntl"), _module("msvcrt")


def lock(handle: int, wait: bool = True) -> None:
    """Lock an open file against other processes until it is closed.

    Args:
        handle: Its descriptor, open for writing.
        wait: For the one that has the lock.

    Raises:
        BlockingIOError: another process has it, and ``wait`` is false.
    """
    if _FCNTL is not None:
        _FCNTL.flock(handle, _FCNTL.LOCK_EX | (0 if wait else _FCNTL.LOCK_NB))
    elif _MSVCRT is not None:
        _lock_byte(_MSVCRT, handle, wait)
    else:
        _lock_by_library(handle, wait)


def _lock_byte(msvcrt: ModuleType, handle: int, wait: bool) -> None:
    here = os.lseek(handle, 0, os.SEEK_CUR)
    try:
        while True:
            os.lseek(handle, LAST_BYTE, os.SEEK_SET)
            try:
                msvcrt.locking(handle, msvcrt.LK_LOCK if wait else msvcrt.LK_NBLCK, 1)
                return
            except OSError as error:
                # it gives up after ten seconds, with the same error as where it does not wait
                if not wait:
                    raise BlockingIOError(*error.args) from error
    finally:
        os.lseek(handle, here, os.SEEK_SET)


def _lock_by_library(handle: int, wait: bool) -> None:
    """``flock`` of the C library, for a Python that was built without it."""
    library = ctypes.CDLL(None, use_errno=True)
    while library.flock(handle, LOCK_EX | (0 if wait else LOCK_NB)):
        number = ctypes.get_errno()
        # after a signal, whose handler has run by now
        if number != errno.EINTR:
            raise OSError(number, os.strerror(number))


def after_fork(action: Callable[[], object]) -> None:
    """Call something first in every forked child; nothing where processes are not forked."""
    if hasattr(os, "register_at_fork"):
        os.register_at_fork(after_in_child=action)


@contextmanager
def folder_lock(directory: Path, *, read_only: bool = False) -> Iterator[None]:
    """Alone with the files of a folder, across threads and processes.

    Args:
        directory: It gets a file named ``.lock``.
        read_only: Nothing is written. A folder without a lock is read at once: an exported one may
            lie on a disk that cannot be written to.
    """
    try:
        file = open(directory / FOLDER_LOCK, "r+" if read_only else "w")  # noqa: SIM115
    except OSError:
        if not read_only:
            raise
        yield
        return
    _FOLDER_LOCKS.add(file)
    try:
        lock(file.fileno())
        yield
    finally:
        _FOLDER_LOCKS.discard(file)
        file.close()


def _close_folder_locks() -> None:
    """A forked child would keep the locks of its parent as long as it lives."""
    for file in _FOLDER_LOCKS:
        file.close()
    _FOLDER_LOCKS.clear()


after_fork(_close_folder_locks)


# below those of signal, which look for names of signals: that takes longer than some runs
_signal = sys.modules.get("_signal", signal)
_handler, _set_handler = _signal.getsignal, _signal.signal
_INTERRUPT = int(signal.SIGINT)


class on_interrupt:
    """Let Ctrl-C do something instead of raising KeyboardInterrupt.

    Entered, it tells whether it does: not in other threads than the first, nor where a handler of
    the caller's is in place.
    """

    def __init__(self, action: Callable[[], object]) -> None:
        self._action, self._set = action, False

    def __enter__(self) -> bool:
        usual = _handler(_INTERRUPT) is signal.default_int_handler
        if usual and threading.current_thread() is threading.main_thread():
            self._set = True
            _set_handler(_INTERRUPT, lambda *_: self._action())
        return self._set

    def __exit__(self, *_: object) -> None:
        if self._set:
            _set_handler(_INTERRUPT, signal.default_int_handler)


@contextmanager
def collector_paused() -> Iterator[None]:
    """No cyclic garbage collection in this block.

    Expressions, rows and elements are made by the ten thousand and have no cycles: the collector
    would scan them again and again. Pausing it saves a tenth of the derivation of a small system,
    and two fifths of the time in which 10,000 bodies are prepared.
    """
    was_enabled = gc.isenabled()
    # where another thread has paused it, that thread lets it go on: it may have done so already
    if was_enabled:
        gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()
