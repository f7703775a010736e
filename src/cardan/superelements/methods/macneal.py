"""MacNeal's reduction: modes of the free component and the residual part without mass."""

from __future__ import annotations

from ..component import Component
from .free_interface import free_interface_basis
from .method import ReducedBasis


def macneal(component: Component, count: int) -> ReducedBasis:
    """Rigid motions, free modes, residual attachment modes without mass.

    The mass matrix is singular: it has as many infinite frequencies as the residual part has
    shapes. Statics, frequency response and eigenvalues allow that; explicit integration and
    M^-1 do not. Errors of frequencies are those of :func:`craig_bampton`.

    Args:
        component: The component.
        count: Modes with all interfaces free, lowest first.

    Source: R. H. MacNeal, A hybrid method of component mode synthesis, Computers & Structures 1
    (1971), 581-601.
    """
    return free_interface_basis(component, count, residual_mass=False)
