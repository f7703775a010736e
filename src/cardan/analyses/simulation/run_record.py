"""The run record of ``kernels/run/run.h`` for Python."""

from __future__ import annotations

import ctypes
from functools import lru_cache
from typing import Any

from ...schema.records import (
    POINTER,
    REAL,
    Adjoint,
    InputFunction,
    InputFunctions,
    Method,
    Run,
    Signal,
    Steps,
    Tangent,
    Tick,
    check,
)
from ...schema.short_run_records import Account, ShortRuns

# answers of the kernels, as in run.h
DONE, MORE, FULL, STOPPED, EVENT = 0, 1, 2, 3, 4
NOT_FINITE, TOO_SMALL, MODEL, INPUT, SIZE = -1, -2, -3, -4, -5
CONSTRAINT_OPEN, ROTATION_TOO_LARGE, UNSOLVED = -6, -7, -8
EVENT_LIMIT, CHATTER, ROTATION_UNRESOLVED = -9, -10, -11
# kinds of events, as in run.h
MODE, IMPACT, TICK, END, MARK, HALT = range(6)
# pieces of the memory of a run, in the order of memory.c
MEMORY_BLOCKS = (
    *(
        "y",
        "y_old",
        "trial",
        "f",
        "k",
        "interpolant",
        "r",
        "s",
        "zeros",
        "work",
        "closing",
        "chart",
    ),
    *("rank_memory", "crossing", "method_memory", "e", "board", "ledger"),
)

_SOUND = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(Run))
Numbers = Any  # a pointer to numbers, as ctypes hands it over
_NUMBERS = ctypes.POINTER(ctypes.c_double)
INPUTS = ctypes.CFUNCTYPE(ctypes.c_int, POINTER, REAL, _NUMBERS, _NUMBERS)
WATCH = ctypes.CFUNCTYPE(ctypes.c_int, REAL, _NUMBERS, _NUMBERS)
RECORDS = {
    "run": Run,
    "method": Method,
    "signal": Signal,
    "tick": Tick,
    "short_runs": ShortRuns,
    "account": Account,
    "steps": Steps,
    "adjoint": Adjoint,
    "tangent": Tangent,
    "input_function": InputFunction,
    "input_functions": InputFunctions,
}


@lru_cache(maxsize=4)
def kernels(library: ctypes.CDLL) -> ctypes.CDLL:
    """The kernels library with the types of its run functions declared.

    Raises:
        BuildError: its records differ from those here.
    """
    for name, structure in RECORDS.items():
        check(library, f"cardan_{name}", structure)
    record = ctypes.POINTER(Run)
    for name in ("cardan_run_start", "cardan_run_drive", "cardan_refresh", "cardan_segment"):
        getattr(library, name).argtypes = [record]
    library.cardan_short_runs_go.argtypes = [ctypes.POINTER(ShortRuns)]
    library.cardan_account_of.argtypes = [ctypes.POINTER(Account)]
    library.cardan_account_of.restype = None
    library.cardan_run_at.argtypes = [record, REAL, POINTER]
    library.cardan_dense_later.argtypes = [record, ctypes.c_ssize_t, *[POINTER] * 4]
    library.cardan_adjoint_sweep.argtypes = [ctypes.POINTER(Adjoint)]
    library.cardan_tangent_sweep.argtypes = [ctypes.POINTER(Tangent)]
    library.cardan_stages_length.argtypes = [record, ctypes.c_ssize_t]
    library.cardan_stages_length.restype = ctypes.c_ssize_t
    rooms = [ctypes.c_size_t, ctypes.c_size_t]
    library.cardan_run_length.argtypes = [record, *rooms]
    library.cardan_run_length.restype = ctypes.c_size_t
    library.cardan_run_place.argtypes, library.cardan_run_place.restype = (
        [record, POINTER, *rooms],
        None,
    )
    return library


def method(library: ctypes.CDLL, kernel: str) -> Method:
    """The functions of a method, and how much it keeps."""
    return Method.in_dll(library, f"cardan_{kernel}_method")


def sound(library: ctypes.CDLL, method: Method, run: Run) -> bool:
    """True when the places that the memory of a run holds exist, where a method keeps any."""
    checks = [_SOUND(address(library, "cardan_rank_sound"))]
    if method.sound:
        checks.append(_SOUND(method.sound))
    return all(function(run) for function in checks)


def address(library: ctypes.CDLL, name: str) -> int:
    """Address of a function of a library."""
    return ctypes.cast(getattr(library, name), ctypes.c_void_p).value or 0
