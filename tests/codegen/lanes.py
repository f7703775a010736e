"""Calls generated C for several states side by side, as its head says that it can be done."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping, Sequence

import numpy as np

from cardan.codegen import CFile
from codegen.running import ORDER, Inputs, compilers, pointer, shared

WIDTHS = (2, 4, 8)


def aligned(shape: tuple[int, ...]) -> np.ndarray:
    """An array of NaN that starts where vectors may start."""
    size = int(np.prod(shape))
    held = np.full(size + 8, np.nan)
    start = -held.ctypes.data % 64 // 8
    return held[start : start + size].reshape(shape)


def side_by_side(rows: Sequence[Sequence[float]]) -> np.ndarray:
    """Entry by entry what is given state by state, with one more at the end."""
    held = aligned((len(rows[0]) + 1, len(rows)))
    held[:-1] = np.transpose(rows)
    return held


def call_lanes(
    cfile: CFile,
    states: Sequence[Mapping[str, Sequence[float]]],
    flags: Sequence[str],
    compiler: str = "",
    own: bool = False,
) -> tuple[int, np.ndarray]:
    """Status and results (lanes, output size) of as many states as there are lanes.

    Args:
        own: Every state has parameters of its own; else those of the first serve all.
    """
    lanes = len(states)
    words = (*flags, f"-DCARDAN_LANES={lanes}", *(["-DCARDAN_LANE_PARAMETERS"] if own else []))
    library = shared(cfile.text, compiler or next(iter(compilers())), words)
    entry = cfile.entry
    out, work = (aligned((entry[f"{k}_size"] + 1, lanes)) for k in ("output", "work"))
    every = [state.get("p", [0.0]) for state in states]
    p = side_by_side(every) if own else np.array(every[0], dtype=float)
    w = aligned((entry["prepared_size"] + 1, lanes) if own else (entry["prepared_size"] + 1,))
    out[-1] = work[-1] = w[-1] = 12345.0
    getattr(library, f"prepare_{cfile.name}")(pointer(p), pointer(w))
    given = {
        name: side_by_side([state[name] for state in states])
        for name in entry["inputs"]
        if name != "p"
    }
    blocks = Inputs(**{name: pointer(given[name]) for name in ORDER if name in given}, w=pointer(w))
    status = getattr(library, cfile.name)(ctypes.byref(blocks), pointer(out), pointer(work))
    assert (out[-1] == 12345.0).all(), "something was written behind out"
    assert (work[-1] == 12345.0).all(), "something was written behind work"
    assert (w[-1] == 12345.0).all(), "something was written behind w"
    return status, out[:-1].T.copy()
