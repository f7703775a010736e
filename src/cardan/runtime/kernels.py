"""C that serves every model: the files in ``kernels/``, compiled once per compiler and flags."""

from __future__ import annotations

import ctypes
import threading
from functools import lru_cache
from pathlib import Path

from .. import processes
from . import cache

DIRECTORY = Path(__file__).resolve().parent.parent / "kernels"

# threads that want the same library at once wait for the one that compiles it
_LOCK = threading.Lock()


def _unlocked() -> None:
    """A new lock: the thread that held the old one is not part of a forked process."""
    global _LOCK
    _LOCK = threading.Lock()


processes.after_fork(_unlocked)


def library(reproducible: bool = False, only: str = "*") -> ctypes.CDLL:
    """The loaded library; calls through it release the GIL.

    Args:
        only: Pattern of file names, for callers that need few of them soon.

    Raises:
        CompilerMissing: no compiler. BuildError: it failed.
    """
    with _LOCK:
        return _library(reproducible, only)


@lru_cache(maxsize=8)
def _library(reproducible: bool, only: str) -> ctypes.CDLL:
    return cache.build(sorted(DIRECTORY.glob(f"{only}.c")), [DIRECTORY], reproducible).load()
