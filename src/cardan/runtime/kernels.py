"""The kernels library: every C file in ``kernels/``, compiled once per compiler and flags."""

from __future__ import annotations

import ctypes
from functools import lru_cache
from pathlib import Path

from . import cache

DIRECTORY = Path(__file__).resolve().parent.parent / "kernels"


@lru_cache(maxsize=4)
def library(reproducible: bool = False) -> ctypes.CDLL:
    """The loaded library; calls through it release the GIL.

    Raises:
        BuildError: no compiler, or it failed.
    """
    built = cache.build(sorted(DIRECTORY.glob("*.c")), [DIRECTORY], reproducible)
    return ctypes.CDLL(str(built.path))
