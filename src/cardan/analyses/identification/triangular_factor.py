"""The triangular factor of many rows, by products of matrices.

Source: Yamamoto, Nakatsukasa, Yanagisawa and Fukaya, Roundoff Error Analysis of the CholeskyQR2
Algorithm, Electronic Transactions on Numerical Analysis 44 (2015).
"""

from __future__ import annotations

import numpy as np

from ...arrays import Array

# condition up to which the first of two Cholesky factors is near enough
REGULAR = 1e6


def triangle(rows: Array) -> Array:
    """R (n, n) with Rᵀ R = Aᵀ A of rows A (m, n): it stands for them in least squares."""
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
