"""Superelements: bodies from the mass and stiffness matrices of finite elements.

A component is known by its matrices M and K and by its nodes. :func:`reduce` keeps the motions of
its interfaces and some modes; :func:`read` takes the matrices out of files of other programs::

    import cardan as cd

    matrices = cd.superelement.read("arm.sti")
    arm = matrices.reduce({"hinge": [11, 12, 13, 14], "tip": [51, 52, 53, 54]}, modes=8)
    print(arm)
    arm.save("arm.npz")
"""

from .cost import ReductionCost
from .inertia import ProjectedInertia
from .interfaces import InterfaceFrame
from .methods import METHODS
from .readers import READERS, read
from .readers.matrix_files import ComponentMatricesRecord
from .record import SuperelementRecord
from .reduction import reduce
from .response import ReducedModes
from .storage import load
from .surface import Surface

__all__ = [
    "METHODS",
    "READERS",
    "ComponentMatricesRecord",
    "InterfaceFrame",
    "ProjectedInertia",
    "ReducedModes",
    "ReductionCost",
    "SuperelementRecord",
    "Surface",
    "load",
    "read",
    "reduce",
]
