"""The records of ``kernels/lanes/ensemble.h`` and ``kernels/lanes/simd_steps.h`` for Python."""

from __future__ import annotations

import ctypes
from functools import lru_cache
from typing import Any

import numpy as np

from ...arrays import Array
from ...build import kernels
from ...schema.records import Driver, Lane, LaneMethod, RunPointer, SimdSteps, check


@lru_cache(maxsize=4)
def driver(library: ctypes.CDLL) -> Any:
    """``cardan_ensemble_drive`` of the kernels.

    Raises:
        BuildError: its record differs from the one here.
    """
    for name, structure in (("run_pointer", RunPointer), ("lane", Lane), ("ensemble", Driver)):
        check(library, f"cardan_{name}", structure)
    library.cardan_ensemble_drive.argtypes = [ctypes.POINTER(Driver)]
    library.cardan_ensemble_drive.restype = None
    return library.cardan_ensemble_drive


@lru_cache(maxsize=8)
def trials(reproducible: bool, width: int) -> ctypes.CDLL:
    """The lane builds of the methods.

    Raises:
        BuildError: the compiler failed.
    """
    library = kernels.library(reproducible, width)
    check(library, "cardan_simd", SimdSteps)
    check(library, "cardan_lane_method", LaneMethod)
    return library


def method(library: ctypes.CDLL, kernel: str) -> LaneMethod:
    """The functions of a method in a lane build."""
    return LaneMethod.in_dll(library, f"cardan_{kernel}_lane_method")


def aligned(size: int, width: int) -> Array:
    """Zeros (size,) that begin where vectors may."""
    block = np.zeros(size + width)
    skip = -block.ctypes.data // 8 % width
    return block[skip : skip + size]
