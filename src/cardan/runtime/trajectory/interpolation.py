"""A motion between the rows that a run kept."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, ModelError
from ..models.constraint_projection import project

if TYPE_CHECKING:
    from .trajectory import TrajectoryRecord


def states_at(motion: TrajectoryRecord, times: Array) -> Array:
    """States and energies of the sources (m, nx + sources) at times (m,).

    Raises:
        ModelError: a time outside the run, or the run kept only its output times.
        ArgumentError: more times than fit into memory.
    """
    try:
        return _states_at(motion, times)
    except MemoryError:
        raise ArgumentError(
            f"{len(times)} times do not fit into memory. Give fewer at once"
        ) from None


def _states_at(motion: TrajectoryRecord, times: Array) -> Array:
    if motion.dense is None:
        return _interpolated(motion, times)
    low, high = sorted((float(motion.t[0]), float(motion.t[-1])))
    outside = times[~((times >= low) & (times <= high))]
    if len(outside):
        raise ModelError(f"t={outside[0]:g} s: the run covers {low:g} ... {high:g} s")
    values = motion.dense.at(times)
    if motion.ledger is not None and motion.model is not None:
        # a polynomial leaves the constraints between its ends
        nx = motion.x.shape[1]
        r, modes = inputs_at(motion, times), motion.event_log.modes(motion.t, times)
        x = project(motion.model, times, values[:, :nx], r, modes, motion.ledger)
        values[:, :nx] = x
    return values


def _interpolated(motion: TrajectoryRecord, times: Array) -> Array:
    """Rows (m, nx + sources) of a run that kept nothing between its output times.

    Raises:
        ModelError: a time that is none of them.
    """
    order = np.argsort(motion.t, kind="stable")
    # of two rows of one time the later one counts, which is what came of it
    last = np.searchsorted(motion.t[order], times, side="right") - 1
    rows = order[np.maximum(last, 0)]
    missing = times[motion.t[rows] != times]
    if len(missing):
        raise ModelError(
            f"t={missing[0]:g} s is not an output time of the run, which kept nothing between "
            "them. Simulate with t as an end or (start, end)"
        )
    return np.concatenate([motion.x[rows], motion.work_done[rows]], axis=1)


def inputs_at(motion: TrajectoryRecord, times: Array) -> Array:
    """Inputs (m, nr) at times (m,)."""
    if motion.inputs_at is not None:
        return motion.inputs_at(times)
    order = np.argsort(motion.t, kind="stable")
    columns = [np.interp(times, motion.t[order], column[order]) for column in motion.r.T]
    return np.stack(columns, axis=1) if columns else np.zeros((len(times), 0))
