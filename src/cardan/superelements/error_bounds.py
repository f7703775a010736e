"""A-posteriori bounds of the frequencies of a reduced component, without those of the full one.

For a reduced mode u with omega^2 = l, r = K u - l M u is what its equations leave. In the norm of
K^-1, delta = |r| / |u|_K: some exact l' has |l' - l| <= delta l'. Where the neighbors are at a
relative distance g, the error is about delta^2 / g.

Source: B. N. Parlett, The Symmetric Eigenvalue Problem, 4.5 and 10.1; T. Kato (1949), G. Temple
(1928).
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Integers
from ..records import dataclass
from .component import Component
from .methods.method import ReducedBasis

EQUAL = 1e-6  # relative distance of 1 / omega^2 below which frequencies count as one


@dataclass(frozen=True, eq=False)
class Residuals:
    """Norms of residuals of all reduced modes, by products of their shapes.

    With y = (x, -l x) of a mode x: |r|^2 = y^T inner y + s^T S^-1 s, s = boundary y. S is the
    static stiffness of the interfaces that are free.

    Attributes:
        inner: Products behind the interfaces (2 n, 2 n).
        boundary: Forces that remain at the interfaces (n_b, 2 n).
        stiffness: Static stiffness of the interfaces (n_b, n_b).
    """

    inner: Array
    boundary: Array
    stiffness: Array

    def norms(self, eigenvalues: Array, shapes: Array, free: Integers) -> Array:
        """|r| in the norm of K^-1.

        Args:
            eigenvalues: omega^2 (modes,).
            shapes: In the reduced coordinates (n, modes).
            free: Motions of the interfaces that are free.
        """
        y = np.vstack([shapes, -eigenvalues * shapes])
        squares = np.einsum("ij,ij->j", y, self.inner @ y)
        force = (self.boundary @ y)[free]
        S = self.stiffness[np.ix_(free, free)]
        squares = squares + np.einsum("ij,ij->j", force, np.linalg.pinv(S, rcond=1e-12) @ force)
        norms: Array = np.sqrt(np.maximum(squares, 0.0))
        return norms


def residuals(component: Component, basis: ReducedBasis) -> Residuals:
    """Products of the shapes of a reduction that give the residuals of its modes."""
    n = component.n_boundary
    products = np.hstack([component.K @ basis.shapes, component.M @ basis.shapes])
    inner = products[n:].T @ component.inner_factor.solve(products[n:])
    static = component.constraint_modes[n:]
    return Residuals(
        (inner + inner.T) / 2, products[:n] + static.T @ products[n:], basis.K[:n, :n].copy()
    )


def relative_bounds(norms: Array, energies: Array, eigenvalues: Array) -> tuple[Array, Array]:
    """Bounds of the relative errors of frequencies, and estimates that use their distances.

    Args:
        norms: |r| of each mode.
        energies: x^T K x.
        eigenvalues: omega^2, rising.

    Returns:
        (modes,) each: within the bound lies an exact frequency; inf where none can be told.
    """
    delta = norms / np.sqrt(energies)
    with np.errstate(divide="ignore", invalid="ignore"):
        bound = np.where(delta < 1, 1 / np.sqrt(np.maximum(1 - delta, 0.0)) - 1, np.inf)
        nu = 1 / eigenvalues
        # equal frequencies, as round sections have, are one subspace of residuals
        cluster = np.cumsum(np.diff(nu, prepend=nu[:1]) < -EQUAL * nu)
        squares = np.bincount(cluster, delta**2)[cluster] if len(nu) else delta
        unequal = cluster[:, None] != cluster
        distance = abs(nu[:, None] - nu).min(axis=1, initial=np.inf, where=unequal)
        distance = np.where(np.isinf(distance), nu, distance)
        estimate = np.minimum(bound, squares * nu / np.maximum(distance, 1e-300) / 2)
    return bound, estimate
