"""Craig and Bampton's reduction: static shapes of the interfaces and modes behind them."""

from __future__ import annotations

import numpy as np

from ..component import Component
from .method import ReducedBasis


def craig_bampton(component: Component, count: int) -> ReducedBasis:
    """Constraint modes and fixed-interface modes.

    Errors of frequencies fall quickly for components that others hold at their interfaces; those
    of a free component converge slowest.

    Args:
        component: The component.
        count: Modes with all interfaces fixed, lowest first; none gives Guyan's reduction.

    Source: R. R. Craig, M. C. C. Bampton, Coupling of substructures for dynamic analyses, AIAA J.
    6 (1968), 1313-1319.
    """
    omega, modes, dropped = component.fixed_modes(count)
    shapes = np.hstack([component.constraint_modes, modes])
    n = component.n_boundary
    M, K = shapes.T @ (component.M @ shapes), np.zeros((n + count, n + count))
    # what the equations of the shapes say of K and of the modal mass is exact
    static = component.constraint_modes
    condensed = static.T @ (component.K @ static)
    K[:n, :n] = (condensed + condensed.T) / 2
    K[n:, n:] = np.diag(omega**2)
    M[n:, n:] = np.eye(count)
    return ReducedBasis(shapes, (M + M.T) / 2, K, omega, dropped, "all interfaces fixed")
