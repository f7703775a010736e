"""Superelements: bodies from finite elements, from matrices, a mesh or the beams of a scene.

::

    import cardan as cd

    arm = cd.superelement.from_mesh("arm.inp", cd.material(E=70e9, nu=0.33, rho=2700),
                                    {"hinge": "hole", "tip": "face"}, modes=8)
    print(arm)
"""

from __future__ import annotations

from .. import solids as mesh
from ..equations.components import from_beams
from ..solids import from_mesh
from ..superelements import (
    METHODS,
    READERS,
    ComponentMatrices,
    InterfaceFrame,
    ProjectedInertia,
    ReducedModes,
    ReductionCost,
    Superelement,
    load,
    read,
    reduce,
)

__all__ = [
    "METHODS",
    "READERS",
    "ComponentMatrices",
    "InterfaceFrame",
    "ProjectedInertia",
    "ReducedModes",
    "ReductionCost",
    "Superelement",
    "from_beams",
    "from_mesh",
    "load",
    "mesh",
    "read",
    "reduce",
]
