"""The records of ``kernels/ensemble.h`` and ``kernels/abreast.h`` for Python."""

from __future__ import annotations

import ctypes
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import BuildError
from ...runtime import kernels
from .. import record

Array = NDArray[np.float64]
POINTER, COUNT, REAL = record.POINTER, record.COUNT, record.REAL
RUNS = "t size until span idle rejected steps rejections evaluations"
TRIALS = "h t_new at error culprit taken failed ended"
PER_LANE = f"{RUNS} {TRIALS}"
ABREAST: tuple[tuple[Any, str], ...] = (
    (POINTER, "rhs w owner inputs alone quaternions"),
    (COUNT, "quaternion_count n nq nu nr"),
    (POINTER, "trial_step dense worst"),
    (REAL, "rtol atol max_step"),
    (COUNT, "order known"),
    (POINTER, PER_LANE),
    (POINTER, "y trial next k spread r s at_rest work"),
)
ENSEMBLE: tuple[tuple[Any, str], ...] = (
    (POINTER, "lanes abreast attempt move"),
    (COUNT, "lane_count memory_length"),
    (POINTER, "x0 r own w"),
    (COUNT, "count own_count w_size timed"),
    (POINTER, "rows x numbers ends answers"),
    (COUNT, "next finished vacant stop"),
)


class Abreast(ctypes.Structure):
    """``cardan_abreast``: trial steps side by side."""

    _fields_ = [(name, kind) for kind, names in ABREAST for name in names.split()]


class Own(ctypes.Structure):
    """``cardan_own``: numbers of a run that a pointer of its record shall point to."""

    _fields_ = [("offset", COUNT), ("base", POINTER), ("stride", COUNT)]


class Lane(ctypes.Structure):
    """``cardan_lane``: the record at work, and how each run begins."""

    _fields_ = [
        *((name, POINTER) for name in ("run", "memory", "fresh", "fresh_memory")),
        ("number", COUNT),
        ("parked", COUNT),
    ]


class Driver(ctypes.Structure):
    """``cardan_ensemble``: many runs by one thread."""

    _fields_ = [(name, kind) for kind, names in ENSEMBLE for name in names.split()]


@lru_cache(maxsize=4)
def driver(library: ctypes.CDLL) -> Any:
    """``cardan_ensemble_drive`` of the kernels.

    Raises:
        BuildError: its record differs from the one here.
    """
    library.cardan_ensemble_size.restype = ctypes.c_size_t
    _agree(library.cardan_ensemble_size(), Driver)
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
    library.cardan_abreast_size.restype = ctypes.c_size_t
    _agree(library.cardan_abreast_size(), Abreast)
    return library


def _agree(size: int, here: type[ctypes.Structure]) -> None:
    if size != ctypes.sizeof(here):
        raise BuildError(
            f"the kernels were built for a record of {size} bytes, this cardan has "
            f"{ctypes.sizeof(here)}: install cardan again, it is from two versions"
        )


def aligned(size: int, width: int) -> Array:
    """Zeros (size,) that begin where vectors may."""
    block = np.zeros(size + width)
    skip = -block.ctypes.data // 8 % width
    return block[skip : skip + size]
