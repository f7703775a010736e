"""Into which segments a measured motion is divided: as few as the search can do with.

A segment goes on until errors at its start have grown by e^2, or until its run has left what was
measured. So a chaotic motion has many of them, a mild one near the first values one, and the same
from values that are far off several: single runs would be led astray.

Growth is the norm of the transition matrix, coordinates and speeds in units of their standard
deviations along the motion, in which an oscillation is no growth.

Source: H. G. Bock, in: Numerical Treatment of Inverse Problems in Differential and Integral
Equations (1983), 95-121, for what the division does to the search.
"""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import SolveError
from .shooting import NodeRun, Segment, Shooting, Trial

GROWTH = float(np.exp(2.0))
LEFT = 0.25  # of the standard deviation of a channel: a run that far off has left the measurements
LEAST = 1e-3  # of the largest deviation of a block: coordinates that hardly move


def divided(shooting: Shooting, states: Array, values: Array) -> list[int]:
    """Numbers of the nodes at which segments begin, of those that a fine division has.

    Args:
        shooting: The fine division.
        states: First values at its nodes (segments, nx).
        values: First values of the parameters.

    Raises:
        SolveError: a run from a node breaks down before the next one.
    """
    trial, units = Trial(shooting, values), _units(shooting, states)
    n = len(units)
    begins, x, grown = [0], states[0], np.eye(n)
    for k in range(len(states)):
        run, growth = _onward(trial, k, x, grown, units) if k > begins[-1] else (None, grown)
        # over: the next one begins where the measurements are
        if run is None:
            begins += [k] if k else []
            run, growth = trial.run(k, states[k]), np.eye(n)
            growth = _transition(trial.segments([run])[0], units)
        x, grown = run.end, growth
    return begins


def _onward(
    trial: Trial, number: int, x: Array, grown: Array, units: Array
) -> tuple[NodeRun | None, Array]:
    """The run over one more segment and the growth since the start; None where that is too much."""
    try:
        run = trial.run(number, x)
        (segment,) = trial.segments([run])
    except SolveError:
        return None, grown
    growth = _transition(segment, units) @ grown
    too_far = np.linalg.norm(growth, 2) > GROWTH or _has_left(trial.shooting, run, segment)
    return (None if too_far else run), growth


def _transition(segment: Segment, units: Array) -> Array:
    """Transition matrix (n, n) in these units."""
    n = len(units)
    return np.asarray(segment.transition[:, :n] * units / units[:, None])


def _has_left(shooting: Shooting, run: NodeRun, segment: Segment) -> bool:
    """Whether most samples of a channel are far off the run."""
    samples = shooting.samples
    mask = samples.present[run.first : run.first + len(run.x)]
    off = np.full(mask.shape, np.nan)
    off[mask] = np.abs(segment.residuals)
    off *= samples.noise
    for k in np.flatnonzero(mask.any(axis=0)):
        if np.nanmedian(off[:, k]) > LEFT * np.nanstd(samples.values[:, k]) > 0:
            return True
    return False


def _units(shooting: Shooting, states: Array) -> Array:
    """Standard deviations (n,) of coordinates along the speeds, of speeds and internal states."""
    moves = shooting.increments(np.repeat(states[:1], len(states), axis=0), states)
    units, nu = moves.std(axis=0), shooting.model.nu
    for block in (slice(0, nu), slice(nu, 2 * nu), slice(2 * nu, None)):
        most = float(units[block].max(initial=0.0))
        units[block] = np.maximum(units[block], LEAST * most) if most > 0 else 1.0
    return np.asarray(units)
