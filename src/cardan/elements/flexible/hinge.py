"""A flexible hinge: soft about one axis, stiff in all other directions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ...ir.matrix import Matrix
from ...spatial.short_rotations import Slopes
from ..formulas import Lines
from .element_ends import Ends
from .formulas import BUSHING
from .relative import Relative, mean_axes
from .section import diagonal, flat
from .strain import STRAIN_DATA, Elastic, Field, StrainElement

# about axis 1 and across it [N m/rad], along axis 1 and across it [N/m]
STIFFNESSES = ("turn", "tilt", "axial", "radial")


@dataclass(frozen=True)
class FlexibleHinge(StrainElement):
    """A solid hinge that turns about axis 1 of its ends and gives a little elsewhere.

    Four stiffnesses: about the axis, across it, along it, and across it. Strain as of a bushing:
    the rotation vector and the distance of the ends in the axes halfway between them;
    ``energy = y·k y / 2``.

    Source: Howell, Compliant Mechanisms (2001), chapter 5; Masarati and Morandini, Multibody System
        Dynamics 24 (2010).
    """

    kind: ClassVar[str] = "flexible_hinge"
    geometric: ClassVar[tuple[str, ...]] = STRAIN_DATA
    formulas: ClassVar[Lines] = BUSHING
    # a hinge that turns freely has no flexibility
    mixed: ClassVar[bool] = False

    @property
    def common(self) -> tuple[str, ...]:
        return STIFFNESSES

    def measures(self, at: Relative) -> tuple[Slopes, Slopes]:
        return mean_axes(at.turn)

    def field(self, ends: Ends, at: Relative, e: Matrix) -> Field:
        strain = Matrix.vstack(at.turn, e)
        turn, tilt, axial, radial = ends.vector(*STIFFNESSES)
        stiffness = diagonal(ends.graph, [turn, tilt, tilt, axial, radial, radial])
        return Elastic(strain - flat(ends, ends.vector(*STRAIN_DATA)), stiffness, None, 1.0)
