"""Guyan's static condensation: what is behind the interfaces follows them as in statics."""

from __future__ import annotations

import numpy as np

from ..component import Component
from .method import ReducedBasis


def guyan(component: Component, count: int) -> ReducedBasis:
    """Constraint modes alone.

    Args:
        component: The component.
        count: Has no meaning here, 0.

    Source: R. J. Guyan, Reduction of stiffness and mass matrices, AIAA J. 3 (1965), 380.
    """
    shapes = component.constraint_modes
    M, K = shapes.T @ (component.M @ shapes), shapes.T @ (component.K @ shapes)
    _, _, dropped = component.fixed_modes(count)
    none = np.zeros(0)
    return ReducedBasis(shapes, (M + M.T) / 2, (K + K.T) / 2, none, dropped, "all interfaces fixed")
