"""Into which segments a measured motion is divided: as few as the search can do with.

A segment goes on until errors at its start have grown by e^2, or until its run has left what was
measured. So a chaotic motion has many of them, a mild one near the first values one, and the same
from values that are far off several: single runs would be led astray.

Growth is the norm of the transition matrix, coordinates and speeds in units of their standard
deviations along the motion, in which an oscillation does not grow. Errors are those that
constraints allow, in the directions in which the motion itself goes. What coordinates make of
speeds is left out: that is large where something is stiff, and real growth shows in coordinates
too.

Source: H. G. Bock, in: Numerical Treatment of Inverse Problems in Differential and Integral
Equations (1983), 95-121, for what the division does to the search.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.linalg import null_space

from ...arrays import Array
from ...errors import SolveError
from ...runtime.models.constraint_projection import Closing
from .shooting import NodeRun, Shooting, Trial

GROWTH = float(np.exp(2.0))
LEFT = 0.25  # of the standard deviation of a channel: a run that far off has left the measurements
LEAST = 1e-3  # of the largest deviation: coordinates and directions that hardly move
MOST = 16  # directions of coordinates, and of speeds, whose growth is looked at
RANK = 1e-9  # of the largest singular value: rows that say nothing new


def divided(shooting: Shooting, states: Array, values: Array) -> list[int]:
    """Numbers of the nodes at which segments begin, of those that a fine division has.

    Args:
        shooting: The fine division.
        states: First values at its nodes (segments, nx).
        values: First values of the parameters.

    Raises:
        SolveError: a run from a node breaks down before the next one.
    """
    units, moves = _units(shooting, states)
    division = _Division(shooting, values, units, moves)
    begins, x, grown = [0], states[0], division.errors(0, states[0])
    for k in range(len(states)):
        run = division.onward(k, x, grown) if k > begins[-1] else None
        # over: the next one begins where the measurements are
        if run is None:
            begins += [k] if k else []
            run = division.run(k, states[k], division.errors(k, states[k]))
        x, grown = run.end, division.trial.increments_of(run.end, run.moved)
    return begins


class _Division:
    """Runs along which errors grow.

    Args:
        shooting, values: As :func:`divided` takes them.
        units: Of increments (n,).
        moves: Increments from the first state to all in these units (segments, n).
    """

    def __init__(self, shooting: Shooting, values: Array, units: Array, moves: Array) -> None:
        self.model, self.units, self.moves = shooting.model, units, moves
        nu, n = self.model.nu, shooting.size
        self.blocks = slice(0, nu), slice(nu, 2 * nu), slice(2 * nu, n)
        self.sizes = [min(one.stop - one.start, MOST) for one in self.blocks]
        none = np.zeros((max(1, sum(self.sizes)), len(shooting.parameters)))
        # errors of the first node too are along everything
        self.trial = Trial(replace(shooting, joint_start=None), values, none)

    def errors(self, number: int, x: Array) -> Array:
        """Increments (n, k) of a node along what constraints of positions and of speeds allow."""
        model, closing = self.model, Closing.of(self.model)
        allowed = [np.eye(one.stop - one.start) for one in self.blocks]
        if closing.rows and closing.watched:
            t, r = self.trial.time_and_inputs(number)
            s = model._layout.start("s")
            G = model.constraint_jacobian(model.parts_of(x)[0], t=t, r=r, s=s)
            for k, rows in enumerate((G[: closing.positions], G)):
                allowed[k] = null_space(rows * self.units[self.blocks[k]], rcond=RANK)
        result, first = np.zeros((len(self.units), len(self.trial.by_parameters))), 0
        for block, basis, size in zip(self.blocks, allowed, self.sizes, strict=True):
            # along these the motion goes, most first
            _, extents, leading = np.linalg.svd(self.moves[:, block] @ basis, full_matrices=False)
            leading = leading[extents > LEAST * extents.max(initial=0.0)][:size]
            columns = slice(first, first + len(leading))
            result[block, columns] = self.units[block, None] * (basis @ leading.T)
            first += size
        return result

    def run(self, number: int, x: Array, errors: Array) -> NodeRun:
        """The run over a segment, along which errors (n, k) grow."""
        return self.trial.run(number, self.trial.begin(number, x), errors)

    def onward(self, number: int, x: Array, errors: Array) -> NodeRun | None:
        """The run over one more segment; None where errors have grown too much then."""
        try:
            run = self.run(number, x, errors)
            residuals = self.trial.misfit([run])[0][0]
        except SolveError:
            return None
        grown = self.trial.increments_of(run.end, run.moved) / self.units[:, None]
        # how fast coordinates make speeds is stiffness
        grown[self.blocks[1], : self.sizes[0]] = 0.0
        too_far = np.linalg.norm(grown, 2) > GROWTH
        return None if too_far or _has_left(self.trial.shooting, run, residuals) else run


def _has_left(shooting: Shooting, run: NodeRun, residuals: Array) -> bool:
    """True if most samples of a channel are far off the run."""
    samples = shooting.samples
    mask = samples.present[run.first : run.first + len(run.x)]
    off = np.full(mask.shape, np.nan)
    off[mask] = np.abs(residuals)
    off *= samples.noise
    for k in np.flatnonzero(mask.any(axis=0)):
        if np.nanmedian(off[:, k]) > LEFT * np.nanstd(samples.values[:, k]) > 0:
            return True
    return False


def _units(shooting: Shooting, states: Array) -> tuple[Array, Array]:
    """Standard deviations (n,) of coordinates along the speeds, of speeds and internal states.

    And increments from the first state to all in these units (segments, n).
    """
    moves = shooting.increments(np.repeat(states[:1], len(states), axis=0), states)
    units, nu = moves.std(axis=0), shooting.model.nu
    for block in (slice(0, nu), slice(nu, 2 * nu), slice(2 * nu, None)):
        most = float(units[block].max(initial=0.0))
        units[block] = np.maximum(units[block], LEAST * most) if most > 0 else 1.0
    return units, moves / units
