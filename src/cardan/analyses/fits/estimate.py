"""Steps of the generalized Gauss-Newton method, and what the data do not tell.

Increments of all nodes follow from those of the first one and of the parameters, as nodes meet:
what is left is a linear least-squares problem in these alone (condensing).

Source: H. G. Bock, in: Numerical Treatment of Inverse Problems in Differential and Integral
Equations (1983), 95-121.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...records import dataclass

# of the largest singular value, columns in their units: combinations below are not told
RANK = 1e-9
# standard deviation of a combination in units of its size, from which on it is as good as unknown
UNKNOWN = 1.0
NOISE = 3.0  # standard deviations: what noise gains
FARTHEST = 1.0  # units that a step goes along a combination


@dataclass(frozen=True)
class Condensed:
    """The linear problem about the present nodes: residuals + slopes @ free unknowns.

    Attributes:
        residuals: With the gaps closed (m,).
        slopes: (m, free).
        residual_norm: Root of the sum of squares of the residuals of the segments as they are,
            which say more of the noise than those of segments that are made to meet.
        nodes: Increments of every node per unit of the free unknowns (nodes, n, free).
        offsets: Increments of every node without any (nodes, n): what closes the gaps.
    """

    residuals: Array
    slopes: Array
    residual_norm: float
    nodes: Array
    offsets: Array


@dataclass(frozen=True)
class Solved:
    """A step and what is known of it.

    Attributes:
        step: Of the free unknowns (free,).
        covariance: Of them, for residuals of variance 1 (free, free); infinite where the data do
            not tell.
        untold: Combinations that the data do not tell (k, free), of length 1 in their units.
        determined: Those that they tell (m, free), likewise.
        deviations: Standard deviations of these in their units (m,), for residuals of variance 1.
        fixed: True for unknowns that bounds hold (free,): nothing is known of their errors.
    """

    step: Array
    covariance: Array
    untold: Array
    determined: Array
    deviations: Array
    fixed: NDArray[np.bool_]


def solved(problem: Condensed, units: Array, fixed: NDArray[np.bool_], weights: Array) -> Solved:
    """The least-squares step.

    Args:
        problem: The linear problem.
        units: Of the free unknowns (free,).
        fixed: True for unknowns at a bound, which stay.
        weights: Of the residuals (m,), of a robust loss.
    """
    # columns in their units: ranks say what the data tell, not in which units
    root = np.sqrt(weights)
    moving = ~fixed
    A = problem.slopes[:, moving] * units[moving] * root[:, None]
    U, sizes, V = np.linalg.svd(A, full_matrices=False)
    significant = sizes > RANK * max(float(sizes.max(initial=0.0)), np.finfo(float).tiny)
    step = np.zeros(len(units))
    along = -(U.T @ (problem.residuals * root))
    amounts = along[significant] / sizes[significant]
    # the problem is one of these directions each by itself: one that would go far stops short and
    # lets the others go on, one that gains no more than noise does, wherever it goes, stays
    sigma = problem.residual_norm / np.sqrt(max(1, A.shape[0] - len(V)))
    idle = (sigma / sizes[significant] > UNKNOWN) & (np.abs(along[significant]) < NOISE * sigma)
    amounts = np.where(idle, 0.0, np.clip(amounts, -FARTHEST, FARTHEST))
    step[moving] = units[moving] * (V[significant].T @ amounts)
    covariance = np.zeros((len(units), len(units)))
    inner = (V[significant].T / sizes[significant] ** 2) @ V[significant]
    # what is not told may be anything
    missing = np.eye(V.shape[1]) - V[significant].T @ V[significant]
    open_ended = np.abs(np.diag(missing)) > RANK
    inner[open_ended, :] = inner[:, open_ended] = np.inf
    covariance[np.ix_(moving, moving)] = inner * np.outer(units[moving], units[moving])
    untold = np.zeros((0, len(units)))
    if open_ended.any():
        directions = np.linalg.svd(missing)[0][:, : round(float(np.trace(missing)))].T
        untold = np.zeros((len(directions), len(units)))
        untold[:, moving] = directions
    determined = np.zeros((int(significant.sum()), len(units)))
    determined[:, moving] = V[significant]
    covariance[fixed, fixed] = np.inf
    return Solved(step, covariance, untold, determined, 1 / sizes[significant], fixed)
