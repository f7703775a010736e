"""Free-interface reductions: modes of the free component and residual attachment modes.

Source: R. R. Craig, C.-J. Chang, On the use of attachment modes in substructure coupling for
dynamic analysis, AIAA/ASME 18th Structures Conference, 1977.
"""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from ..component import Component
from ..eigenproblem import dense_modes
from .method import ReducedBasis

RANK = 1e-10  # of energies of attachment modes, and of motions of the interfaces
WAYS = "with all interfaces free"


def free_interface_basis(component: Component, count: int, residual_mass: bool) -> ReducedBasis:
    """Rigid motions, free modes and the static response that these modes leave out.

    The residual flexibility is never inverted, which would lose the digits that the subtraction
    of the modes costs. A basis of unit mass is combined instead: what moves the interfaces
    by the pseudo-inverse of its rows there, the remainder by their null space.

    Args:
        component: The component.
        count: Modes with all interfaces free, lowest first.
        residual_mass: False for a residual part without mass.
    """
    omega, modes, dropped = component.free_modes(count)
    rigid = component.rigid_of_unit_mass
    n, r = component.n_boundary, rigid.shape[1]
    unit_loads = np.eye(component.K.shape[0], n)
    residual = _orthogonal(component, component.flexible(unit_loads), np.hstack([rigid, modes]))
    basis = np.hstack([rigid, modes, residual])
    M, K = basis.T @ (component.M @ basis), basis.T @ (component.K @ basis)
    # rigid motions have no strain
    K[:r], K[:, :r] = 0.0, 0.0
    free = r + count
    massless = 0
    if not residual_mass:
        M[free:], M[:, free:] = 0.0, 0.0
        massless = basis.shape[1] - free
    coordinates = _boundary_coordinates(component, basis[:n], (M + M.T) / 2, (K + K.T) / 2)
    M, K = coordinates.T @ M @ coordinates, coordinates.T @ K @ coordinates
    # exact by the choice of the coordinates
    K[:n, n:], K[n:, :n] = 0.0, 0.0
    inner = K.diagonal()[n:].copy()
    K[n:, n:] = np.diag(inner)
    M[n:, n:] = np.eye(len(M) - n)
    M, K = (M + M.T) / 2, (K + K.T) / 2
    return ReducedBasis(basis @ coordinates, M, K, omega, dropped, "all interfaces free", massless)


def _orthogonal(component: Component, shapes: Array, basis: Array) -> Array:
    """Shapes with unit modal mass, orthogonal to a basis and to each other."""
    for _ in range(2):
        shapes = shapes - basis @ (basis.T @ (component.M @ shapes))
    size = np.sqrt(np.maximum(np.einsum("ij,ij->j", shapes, component.K @ shapes), 1e-300))
    shapes = shapes / size
    energy = shapes.T @ (component.K @ shapes)
    values, vectors = np.linalg.eigh((energy + energy.T) / 2)
    independent = values > RANK * values[-1]
    shapes = shapes @ (vectors[:, independent] / np.sqrt(values[independent]))
    # unit stiffness by now: turn to unit mass, where there is mass
    mass = shapes.T @ (component.M @ shapes)
    nu, vectors = np.linalg.eigh((mass + mass.T) / 2)
    weights = np.sqrt(np.where(nu > RANK**2 * nu[-1], nu, 1.0))
    unit: Array = shapes @ (vectors / weights)
    for _ in range(2):
        unit = unit - basis @ (basis.T @ (component.M @ unit))
    return unit


def _boundary_coordinates(component: Component, rows: Array, M: Array, K: Array) -> Array:
    """Coordinates that are motions of the interfaces first, modal ones behind them.

    Raises:
        ModelError: the shapes do not move all interfaces; it names their motions.
    """
    scale = component.boundary_scale[:, None]
    left, values, right = np.linalg.svd(scale * rows, full_matrices=True)
    if values[-1] <= RANK * values[0] or len(right) < len(rows):
        weak = abs(left[:, -1])
        names = component.boundary_labels
        lost = ", ".join(f"'{names[k]}'" for k in np.flatnonzero(weak > 0.3 * weak.max()))
        raise ModelError(
            f"the shapes do not move all interfaces: {lost} follow from other motions. Leave out "
            "an interface or its motions by frame_dofs=, or take method='craig_bampton'"
        )
    n = len(rows)
    moving = right[:n].T @ (left.T / values[:, None]) * scale.T
    still = right[n:].T
    _, modal = dense_modes(still.T @ K @ still, still.T @ M @ still, still.shape[1])
    still = still @ modal
    # static shapes of the interfaces, which no modal force holds
    stiffness = np.einsum("ij,ij->j", still, K @ still)
    moving = moving - still @ ((still.T @ (K @ moving)) / stiffness[:, None])
    return np.hstack([moving, still])
