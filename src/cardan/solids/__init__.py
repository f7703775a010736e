"""Finite-element meshes of solids: reading, checks, matrices, loads and stresses.

The mesh is a :class:`Mesh`, with its material it is a :class:`Solid`, whose sparse matrices are
what reductions take. The loops over cells are C, in ``kernels/solids``.
"""

from __future__ import annotations

from ..superelements.stress_recovery import von_mises
from .files import read
from .loads import centrifugal, centrifugal_products, gravity, pressure, thermal
from .materials import SolidMaterial, orthotropic
from .record import Mesh, from_arrays
from .reduced import spin_stiffness
from .solid import Solid, assembled, solid
from .stress import stress_operator, thermal_stresses

__all__ = [
    "Mesh",
    "Solid",
    "SolidMaterial",
    "assembled",
    "centrifugal",
    "centrifugal_products",
    "from_arrays",
    "gravity",
    "orthotropic",
    "pressure",
    "read",
    "solid",
    "spin_stiffness",
    "stress_operator",
    "thermal",
    "thermal_stresses",
    "von_mises",
]
