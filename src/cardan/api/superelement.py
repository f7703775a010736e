"""Superelements: bodies from finite elements, from matrices or from a mesh.

::

    import cardan as cd

    arm = cd.superelement.from_mesh("arm.inp", cd.material(E=70e9, nu=0.33, rho=2700),
                                    {"hinge": "hole", "tip": "face"}, modes=8)
    print(arm)
"""

from __future__ import annotations

from .. import solids as mesh
from ..solids import from_mesh
from ..superelements import (
    METHODS,
    READERS,
    ComponentMatrices,
    InterfaceFrame,
    ProjectedInertia,
    ReducedModes,
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
    "Superelement",
    "from_mesh",
    "load",
    "mesh",
    "read",
    "reduce",
]
