"""A bushing: springs in six directions between two ends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ...ir.matrix import Matrix
from ...spatial.short_rotations import Slopes
from ..formulas import Lines
from .element_ends import Ends
from .formulas import BUSHING
from .relative import Relative, mean_axes
from .section import flat
from .strain import STRAIN_DATA, Elastic, Field, StrainElement

# the upper triangle of a symmetric (6, 6) matrix, row by row
ENTRIES = tuple(f"k{i + 1}{j + 1}" for i in range(6) for j in range(i, 6))


@dataclass(frozen=True)
class Bushing(StrainElement):
    """Linear springs in all six relative directions, coupled as one likes.

    Strain is the rotation vector and the distance of the ends in the axes halfway between them, so
    that both ends are treated alike: ``energy = y·k y / 2``; at angles up to pi. Rows and columns
    of the stiffness are rotations [N m/rad] before displacements [N/m].

    Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), section 7.7; Masarati and
        Morandini, Multibody System Dynamics 24 (2010) for the halfway axes.
    """

    kind: ClassVar[str] = "bushing"
    geometric: ClassVar[tuple[str, ...]] = STRAIN_DATA
    formulas: ClassVar[Lines] = BUSHING
    # springs that are missing have no flexibility
    mixed: ClassVar[bool] = False

    @property
    def common(self) -> tuple[str, ...]:
        return ENTRIES

    def measures(self, at: Relative) -> tuple[Slopes, Slopes]:
        return mean_axes(at.turn)

    def field(self, ends: Ends, at: Relative, e: Matrix) -> Field:
        strain = Matrix.vstack(at.turn, e)
        names = [[f"k{min(i, j) + 1}{max(i, j) + 1}" for j in range(6)] for i in range(6)]
        stiffness = Matrix.of(ends.graph, [[ends.number(name) for name in row] for row in names])
        return Elastic(strain - flat(ends, ends.vector(*STRAIN_DATA)), stiffness, None, 1.0)
