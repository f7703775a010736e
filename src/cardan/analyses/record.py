"""The run record of ``kernels/run.h`` for Python."""

from __future__ import annotations

import ctypes
from functools import lru_cache

from ..schema.records import COUNT, POINTER, REAL, Run, Signal, Tick, check

# answers of the kernels, as in run.h
DONE, MORE, FULL, STOPPED, EVENT = 0, 1, 2, 3, 4
NOT_FINITE, TOO_SMALL, MODEL, INPUT, SIZE, OPEN, TURNED = -1, -2, -3, -4, -5, -6, -7
UNSOLVED, STORM, CHATTER, WHIRLED = -8, -9, -10, -11
# kinds of events, as in run.h
MODE, IMPACT, TICK, END, MARK, HALT = range(6)

INPUTS = ctypes.CFUNCTYPE(
    ctypes.c_int, REAL, ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_double)
)


@lru_cache(maxsize=4)
def kernels(library: ctypes.CDLL) -> ctypes.CDLL:
    """The kernels library with the types of its run functions declared.

    Raises:
        BuildError: its records differ from those here.
    """
    for name, structure in (("run", Run), ("signal", Signal), ("tick", Tick)):
        check(library, f"cardan_{name}", structure)
    record = ctypes.POINTER(Run)
    for name in ("cardan_run_start", "cardan_run_drive", "cardan_refresh", "cardan_segment"):
        getattr(library, name).argtypes = [record]
    library.cardan_run_at.argtypes = [record, REAL, POINTER]
    for name in ("closing", "hold", "passing", "chart", "board"):
        function = getattr(library, f"cardan_{name}_length")
        function.argtypes, function.restype = [record], COUNT
    return library


def length(library: ctypes.CDLL, kernel: str, run: Run) -> int:
    """Numbers of memory that a method needs for itself."""
    function = getattr(library, f"cardan_{kernel}_length")
    function.restype, function.argtypes = COUNT, [ctypes.POINTER(Run)]
    return int(function(run))


def sound(library: ctypes.CDLL, kernel: str, run: Run) -> bool:
    """Whether the places that the memory of a run holds exist, where a method keeps any."""
    kept = ["cardan_hold_sound", f"cardan_{kernel}_sound"]
    known = [getattr(library, name) for name in kept if hasattr(library, name)]
    for function in known:
        function.restype, function.argtypes = ctypes.c_int, [ctypes.POINTER(Run)]
    return all(function(run) for function in known)


def address(library: ctypes.CDLL, name: str) -> int:
    """Address of a function of a library."""
    return ctypes.cast(getattr(library, name), ctypes.c_void_p).value or 0
