"""Lowest frequencies of K x = omega^2 M x, dense or sparse, in their inverse form.

The inverse form M x = nu K x keeps the lowest frequencies accurate and allows rows without mass.

Source: B. N. Parlett, The Symmetric Eigenvalue Problem, chapter 15.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array
from ..errors import SolveError

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse

DENSE = 900  # rows up to which all frequencies are computed
MASSLESS = 1e-13  # of the largest nu: an infinite frequency


def dense_modes(K: Array, M: Array, count: int | None = None) -> tuple[Array, Array]:
    """Frequencies [rad/s] and shapes with unit modal mass, lowest first.

    Args:
        K: Stiffness (n, n), positive definite.
        M: Mass (n, n), may be singular.
        count: How many are finite, where that is known; those with mass otherwise.

    Raises:
        SolveError: K is not positive definite.
    """
    from scipy.linalg import LinAlgError, eigh

    if not len(K):
        return np.zeros(0), np.zeros((0, 0))
    # shapes with unit stiffness, the softest last
    scale = 1 / np.sqrt(np.maximum(K.diagonal(), 1e-300))
    try:
        nu, shapes = eigh(scale[:, None] * M * scale, scale[:, None] * K * scale)
    except LinAlgError:
        raise SolveError(
            "the stiffness is not positive definite behind the interfaces: check K, its units and "
            "its supports"
        ) from None
    nu, shapes = nu[::-1], scale[:, None] * shapes[:, ::-1]
    finite = int((nu > MASSLESS * nu[0]).sum()) if nu[0] > 0 else 0
    count = finite if count is None else min(count, finite)
    return 1 / np.sqrt(nu[:count]), shapes[:, :count] / np.sqrt(nu[:count])


def sparse_modes(
    solve: Callable[[Array], Array], K: Sparse, M: Sparse, count: int
) -> tuple[Array, Array]:
    """Frequencies [rad/s] and shapes with unit modal mass, lowest first.

    Args:
        solve: Displacements by forces; rigid motions are left out of both.
        K, M: Sparse, K only its action on shapes.
        count: How many, far fewer than rows.

    Raises:
        SolveError: the iteration does not converge.

    Source: R. B. Lehoucq, D. C. Sorensen, C. Yang, ARPACK Users' Guide, 1998.
    """
    from scipy.sparse.linalg import ArpackError, LinearOperator, eigsh

    size = M.shape[0]
    start = solve(np.random.default_rng(22).standard_normal(size))
    start /= np.linalg.norm(start)
    operator = LinearOperator((size, size), matvec=lambda x: solve(x.reshape(-1)), dtype=float)
    try:
        _, shapes = eigsh(K, k=count, M=M, sigma=0.0, OPinv=operator, which="LM", v0=start)
    except ArpackError as error:
        raise SolveError(f"{count} modes: {error}; ask for fewer modes") from None
    # clean what the iteration left of coupling
    within = shapes.T @ (M @ shapes)
    stiff = shapes.T @ (K @ shapes)
    omega, coefficients = dense_modes((stiff + stiff.T) / 2, (within + within.T) / 2)
    return omega, shapes @ coefficients
