"""The run record of ``kernels/run.h`` for Python: the same fields in the same order."""

from __future__ import annotations

import ctypes
from functools import lru_cache
from typing import Any

from ..errors import BuildError

# answers of the kernels, as in run.h
DONE, MORE, FULL, STOPPED, EVENT = 0, 1, 2, 3, 4
NOT_FINITE, TOO_SMALL, MODEL, INPUT, SIZE, OPEN, TURNED = -1, -2, -3, -4, -5, -6, -7
UNSOLVED, STORM, CHATTER, WHIRLED = -8, -9, -10, -11
# kinds of events, as in run.h
MODE, IMPACT, TICK, END, MARK, HALT = range(6)

POINTER, COUNT, REAL = ctypes.c_void_p, ctypes.c_ssize_t, ctypes.c_double
INPUTS = ctypes.CFUNCTYPE(
    ctypes.c_int, REAL, ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_double)
)

FIELDS: tuple[tuple[Any, str], ...] = (
    (POINTER, "init step dense length"),
    (POINTER, "rhs rhs_w power power_w"),
    (POINTER, "energy energy_w rhs_jacobian rhs_jacobian_w"),
    (POINTER, "balance balance_w balance_tangent balance_tangent_w move move_w qdot qdot_w"),
    (POINTER, "mesh options"),
    (POINTER, "inputs signals quaternions"),
    (COUNT, "nq nu nz nx n nr ns signal_count quaternion_count"),
    (POINTER, "bounded"),
    (COUNT, "bounded_count sampled charted"),
    (POINTER, "close_position close_position_w close_velocity close_velocity_w"),
    (POINTER, "constraint_jacobian constraint_jacobian_w columns"),
    (COUNT, "positions rates"),
    (REAL, "size"),
    (POINTER, "events events_w transition transition_w watch kinds ticks"),
    (COUNT, "ne watched tick_count"),
    (POINTER, "y y_old trial k f r s spread at_rest work closing chart holding passing own"),
    (POINTER, "e board ledger"),
    (COUNT, "stages dense_rows"),
    (POINTER, "stops"),
    (COUNT, "stop_count next_stop"),
    (REAL, "t t_old t_start segment until early late"),
    (COUNT, "jumps in_segment"),
    (REAL, "rtol atol max_step h moment correction"),
    (COUNT, "fresh is_dense rejected on_grid"),
    (REAL, "hold best_hold pass_start pass_length"),
    (COUNT, "held ranks pass_points pass_part pass_parts"),
    (POINTER, "rows"),
    (COUNT, "nlam"),
    (POINTER, "spreads times"),
    (COUNT, "time_count next_time capacity count row_open"),
    (POINTER, "log"),
    (COUNT, "log_capacity log_count happened at_once occurred"),
    (COUNT, "steps rejections evaluations budget culprit model_status"),
    (COUNT, "open_row projections passed"),
    (COUNT, "looked limited jacobians factorizations"),
    (COUNT, "stop"),
)


class Run(ctypes.Structure):
    """``cardan_run``; see ``kernels/run.h`` for the meaning of every field."""

    _fields_ = [(name, kind) for kind, names in FIELDS for name in names.split()]


class Signal(ctypes.Structure):
    """``cardan_signal``: an input given by pieces."""

    _fields_ = [
        ("input", COUNT),
        ("pieces", COUNT),
        ("where", COUNT),
        ("breaks", POINTER),
        ("coefficients", POINTER),
    ]


class Tick(ctypes.Structure):
    """``cardan_tick``: an event at known times."""

    _fields_ = [
        ("event", COUNT),
        ("period", REAL),
        ("phase", REAL),
        ("count", COUNT),
        ("next", REAL),
    ]


@lru_cache(maxsize=4)
def kernels(library: ctypes.CDLL) -> ctypes.CDLL:
    """The kernels library with the types of its run functions declared.

    Raises:
        BuildError: its record differs from the one here.
    """
    library.cardan_run_size.restype = ctypes.c_size_t
    if library.cardan_run_size() != ctypes.sizeof(Run):
        raise BuildError(
            f"the integrators were built for a run record of {library.cardan_run_size()} bytes, "
            f"this cardan has {ctypes.sizeof(Run)}: install cardan again, it is from two versions"
        )
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
