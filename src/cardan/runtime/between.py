"""A motion between the rows that a run kept."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import ModelError
from .calling import Array
from .closing import project

if TYPE_CHECKING:
    from .trajectory import Trajectory


def states_at(motion: Trajectory, times: Array) -> Array:
    """States and energies of the sources (m, nx + sources) at times (m,).

    Raises:
        ModelError: a time outside the run, or the run kept only its output times.
    """
    if motion.dense is None:
        raise ModelError(
            "the run was asked for output times only and kept nothing between them. "
            "Simulate with t as an end or (start, end)"
        )
    low, high = sorted((float(motion.t[0]), float(motion.t[-1])))
    outside = times[~((times >= low) & (times <= high))]
    if len(outside):
        raise ModelError(f"t={outside[0]:g} s: the run covers {low:g} ... {high:g} s")
    values = motion.dense.at(times)
    if motion.ledger is not None and motion.model is not None:
        # a polynomial leaves the constraints between its ends
        nx = motion.x.shape[1]
        r, modes = inputs_at(motion, times), motion.happened.modes(motion.t, times)
        x = project(motion.model, times, values[:, :nx], r, modes, motion.ledger)
        values[:, :nx] = x
    return values


def inputs_at(motion: Trajectory, times: Array) -> Array:
    """Inputs (m, nr) at times (m,)."""
    if motion.inputs_at is not None:
        return motion.inputs_at(times)
    order = np.argsort(motion.t, kind="stable")
    columns = [np.interp(times, motion.t[order], column[order]) for column in motion.r.T]
    return np.stack(columns, axis=1) if columns else np.zeros((len(times), 0))
