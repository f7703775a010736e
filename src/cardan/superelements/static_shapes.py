"""Static response to loads as more shapes of a reduced component.

Interfaces move exactly under static loads whatever the shapes; what is behind them does so only if
its response to the load, with all interfaces fixed, is one of the shapes.

Source: J. M. Dickens, J. M. Nakagawa, M. J. Wittbrodt, A critique of mode acceleration and modal
truncation augmentation methods, Computers & Structures 62 (1997).
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..errors import ModelError
from .component import Component
from .eigenproblem import dense_modes
from .methods.method import ReducedBasis

INDEPENDENT = 1e-10  # of the energy of a response: what shapes leave of one that they span


def with_static_shapes(
    component: Component, basis: ReducedBasis, forces: Array, names: tuple[str, ...]
) -> ReducedBasis:
    """A basis that has the static response to loads too; its modal coordinates are combined anew.

    Args:
        component: The component.
        basis: Shapes of a method.
        forces: Loads in the unknowns of the component (n_b + n_i, loads).
        names: Of the loads, for messages.

    Raises:
        ModelError: the method gives the shapes another mass than that of the component.
    """
    if basis.massless:
        raise ModelError(
            f"static_shapes={[*names]}: 'macneal' leaves out the mass of static shapes; take "
            "method='rubin'"
        )
    n = component.n_boundary
    modal = basis.shapes[:, n:]
    response = np.vstack([np.zeros((n, forces.shape[1])), component.inner_factor.solve(forces[n:])])
    # what the modes do not span, each response with unit energy
    stiffness = basis.K.diagonal()[n:]
    total = np.einsum("ij,ij->j", response, component.K @ response)
    for _ in range(2):
        coefficients = (modal.T @ (component.K @ response)) / stiffness[:, None]
        response = response - modal @ coefficients
    response = response / np.sqrt(np.maximum(total, 1e-300))
    energy = response.T @ (component.K @ response)
    values, vectors = np.linalg.eigh((energy + energy.T) / 2)
    new = values > INDEPENDENT
    more = np.hstack([modal, response @ (vectors[:, new] / np.sqrt(values[new]))])
    K, M = more.T @ (component.K @ more), more.T @ (component.M @ more)
    omega, combined = dense_modes((K + K.T) / 2, (M + M.T) / 2)
    shapes = np.hstack([basis.shapes[:, :n], more @ combined])
    size = shapes.shape[1]
    M, K = shapes.T @ (component.M @ shapes), np.zeros((size, size))
    K[:n, :n] = basis.K[:n, :n]
    K[n:, n:] = np.diag(omega**2)
    M[n:, n:] = np.eye(size - n)
    return ReducedBasis(shapes, (M + M.T) / 2, K, basis.frequencies, basis.dropped, basis.modes_of)
