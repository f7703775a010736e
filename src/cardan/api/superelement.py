"""Superelements: bodies from finite elements, from matrices, a mesh or the beams of a scene.

::

    import cardan as cd

    arm = cd.superelement.from_mesh("arm.inp", cd.material(E=70e9, nu=0.33, rho=2700),
                                    {"hinge": "hole", "tip": "face"}, modes=8)
    print(arm)
    arm.animate(1, "mode.html")
"""

from __future__ import annotations

from collections.abc import Callable
from typing import ParamSpec, cast

from .. import solids as mesh
from .. import superelements
from ..equations import components
from ..solids import reduced
from ..superelements import (
    METHODS,
    READERS,
    ComponentMatricesRecord,
    InterfaceFrame,
    ProjectedInertia,
    ReducedModes,
    ReductionCost,
    SuperelementRecord,
    Surface,
)
from .components import ComponentMatrices, Superelement
from .faces import faced

P = ParamSpec("P")


def _with_verbs(function: Callable[P, SuperelementRecord]) -> Callable[P, Superelement]:
    """A function whose component can be drawn."""
    return cast("Callable[P, Superelement]", faced(function))


def _with_reduction(
    function: Callable[P, ComponentMatricesRecord],
) -> Callable[P, ComponentMatrices]:
    """A function whose matrices can be reduced."""
    return cast("Callable[P, ComponentMatrices]", faced(function))


from_beams = _with_verbs(components.from_beams)
from_mesh = _with_verbs(reduced.from_mesh)
load = _with_verbs(superelements.load)
reduce = _with_verbs(superelements.reduce)
read = _with_reduction(superelements.read)

__all__ = [
    "METHODS",
    "READERS",
    "ComponentMatrices",
    "InterfaceFrame",
    "ProjectedInertia",
    "ReducedModes",
    "ReductionCost",
    "Superelement",
    "Surface",
    "from_beams",
    "from_mesh",
    "load",
    "mesh",
    "read",
    "reduce",
]
