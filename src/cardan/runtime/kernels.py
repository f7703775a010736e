"""C that serves every model: the files in ``kernels/``, compiled once per compiler and flags."""

from __future__ import annotations

import ctypes
from functools import lru_cache
from pathlib import Path

from . import cache

DIRECTORY = Path(__file__).resolve().parent.parent / "kernels"


@lru_cache(maxsize=8)
def library(reproducible: bool = False, only: str = "*") -> ctypes.CDLL:
    """The loaded library; calls through it release the GIL.

    Args:
        only: Pattern of file names, for callers that need few of them soon.

    Raises:
        CompilerMissing: no compiler. BuildError: it failed.
    """
    return cache.build(sorted(DIRECTORY.glob(f"{only}.c")), [DIRECTORY], reproducible).load()
