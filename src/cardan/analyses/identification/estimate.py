"""Weighted least squares with a noise of every channel that the residuals tell.

Source: Gautier and Poignet, Extended Kalman Filtering and Weighted Least Squares Dynamic
Identification of Robot, Control Engineering Practice 9 (2001).
"""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass

PASSES = 3  # of weights by residuals: the second changes them by parts of a thousand
LEAST = 1e-12  # noise relative to what was measured: less is rounding
EXACT = 1e-4  # noise of a channel beside that of others: no force at all is known that well
REGULAR = 1e6  # condition up to which the first of two Cholesky factors is near enough
SINGULAR = 1e10  # condition of scaled columns beyond which data tell nothing about some


@dataclass(frozen=True)
class Fit:
    """A solution of A x = b.

    Attributes:
        x: (n,).
        covariance: (n, n).
        noise: Standard deviation of every channel (c,).
        residuals: b - A x (nt, c).
        condition: Of A with columns of length 1, weighted.
        chi: Sum of squares of weighted residuals over their degrees of freedom.
    """

    x: Array
    covariance: Array
    noise: Array
    residuals: Array
    condition: float
    chi: float


def fitted(A: Array, b: Array, scale: Array, noise: Array | None, names: tuple[str, ...]) -> Fit:
    """Least squares of rows weighted by their noise.

    Args:
        A, b: (nt, c, n), (nt, c).
        scale: Of the noise of samples relative to that of their channel (nt, c).
        noise: Of the channels (c,); None: as the residuals tell.
        names: Of the unknowns, for messages.

    Raises:
        SolveError: the data do not tell the unknowns apart.
    """
    channels, count = b.shape[1], A.shape[-1]
    if b.size <= count:
        raise SolveError(f"{b.size} equations do not determine {count} parameters: more samples")
    least = LEAST * np.maximum(np.sqrt(np.mean(b**2, axis=0)), np.abs(A).max(initial=0.0) * 1e-6)
    least = np.maximum(least, np.finfo(float).tiny)
    sigma = np.ones(channels) if noise is None else noise
    for _ in range(PASSES if noise is None else 1):
        weights = 1 / (scale * sigma)
        rows = (A * weights[..., None]).reshape(-1, count)
        x, inverse, condition = _solved(rows, (b * weights).ravel(), names)
        residuals = b - (A.reshape(-1, count) @ x).reshape(b.shape)
        if noise is None:
            # what every channel has taken of the degrees of freedom
            taken = ((rows @ inverse) ** 2).sum(axis=1).reshape(b.shape).sum(axis=0)
            squares = ((residuals / scale) ** 2).sum(axis=0)
            sigma = np.maximum(np.sqrt(squares / np.maximum(len(b) - taken, 1.0)), least)
            sigma = np.maximum(sigma, EXACT * sigma.max())
    # the weights of the last pass against the noise that came out of it
    chi = float(((residuals / (scale * sigma)) ** 2).sum() / (b.size - count))
    return Fit(x, inverse @ inverse.T, sigma, residuals, condition, chi)


def _solved(rows: Array, right: Array, names: tuple[str, ...]) -> tuple[Array, Array, float]:
    """Solution, a factor of its covariance, condition of the scaled columns.

    Solved by the triangular factor alone, and corrected once, which is as good as with the
    orthogonal one (Björck, Linear Algebra and its Applications 88, 1987).

    Raises:
        SolveError: columns that are not independent.
    """
    sizes = np.linalg.norm(rows, axis=0)
    scaled = rows / np.where(sizes > 0, sizes, 1.0)
    factor = triangle(scaled)
    _, values, ways = np.linalg.svd(factor)
    condition = float(values[0] / max(values[-1], np.finfo(float).tiny))
    if condition > SINGULAR or np.any(sizes == 0):
        worst = np.abs(ways[-1])
        silent = np.flatnonzero(sizes == 0)
        which = silent if len(silent) else np.flatnonzero(worst > 0.3 * worst.max())
        listed = ", ".join(f"'{names[k]}'" for k in which[:8])
        raise SolveError(
            f"the data do not tell {listed} (condition {condition:.1e}): move more joints, "
            "farther and faster; model.excitation() finds such a motion"
        )
    back = np.linalg.inv(factor)
    y = np.zeros(rows.shape[1])
    for _ in range(2):
        y = y + back @ (back.T @ (scaled.T @ (right - scaled @ y)))
    return y / sizes, back / sizes[:, None], condition


def triangle(rows: Array) -> Array:
    """R (n, n) with Rᵀ R = Aᵀ A of rows A (m, n): it stands for them in least squares.

    Source: Yamamoto, Nakatsukasa, Yanagisawa and Fukaya, Roundoff Error Analysis of the CholeskyQR2
    Algorithm, Electronic Transactions on Numerical Analysis 44 (2015).
    """
    try:
        first = np.linalg.cholesky(rows.T @ rows).T
        if np.linalg.cond(first) < REGULAR:
            # what is left to do is nearly orthogonal already
            nearly = rows @ np.linalg.inv(first)
            return np.asarray(np.linalg.cholesky(nearly.T @ nearly).T @ first)
    except np.linalg.LinAlgError:
        pass
    # fewer rows than columns leave zeros below
    R = np.zeros((rows.shape[1], rows.shape[1]))
    factor = np.linalg.qr(rows, mode="r")
    R[: len(factor)] = factor
    return R
