"""Data that beams share: stiffness of the section, thermal strain, reference shape.

Axes of the section: 1 along the beam, 2 and 3 principal. Stress is (m1 m2 m3, n1 n2 n3), torsion
and bending before tension and shear; strain (K1 K2 K3, E1 E2 E3) with E = (1, 0, 0) where a
straight beam is not strained.
"""

from __future__ import annotations

from dataclasses import dataclass

from ...ir.arithmetic import Scalar
from ...ir.matrix import Matrix
from .ends import Ends

# stiffness in the order of the stress [N m², N], and what temperature does freely [rad/m, -]
STIFFNESS = ("GJ", "EI2", "EI3", "EA", "GA2", "GA3")
THERMAL = ("thermal_K2", "thermal_K3", "thermal_E1")
SECTION = (*STIFFNESS, *THERMAL)
# length [m] and strain of the reference shape [rad/m, -]
SHAPE = ("length", "K1", "K2", "K3", "E1", "E2", "E3")


@dataclass(frozen=True)
class Section:
    """What the data of a beam element say.

    Attributes:
        length: L [m].
        stiffness: Of the section, six numbers.
        free: Strain without stress times L: reference shape and temperature (6, 1).
    """

    length: Scalar
    stiffness: tuple[Scalar, ...]
    free: Matrix

    @staticmethod
    def of(ends: Ends) -> Section:
        """From the data of an element that has ``SECTION`` and ``SHAPE``."""
        length = ends.number("length")
        strain = list(ends.vector(*SHAPE[1:]))
        for k, name in zip((1, 2, 3), THERMAL, strict=True):
            strain[k] = strain[k] + ends.number(name)
        free = Matrix.vector(ends.graph, strain) * length
        return Section(length, tuple(ends.vector(*STIFFNESS)), free)
