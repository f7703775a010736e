"""The displacement beam with helicoidal strain."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.short_rotations import Slopes
from ..formulas import Lines, Shapes
from .element_ends import Ends
from .formulas import HELICOIDAL, STRAIN_SHAPES
from .relative import Relative
from .section import SECTION, SHAPE, Section
from .strain import Elastic, Field, StrainElement


@dataclass(frozen=True)
class Helicoidal(StrainElement):
    """Geometrically exact beam whose shape is a helix: constant strain, exact for pure bending.

    Second order in statics, ``energy = y·C y / (2 L), y = (theta, e) - free``; does not lock in
    bending of slender beams.

    Source: V. Sonneville, A. Cardona, O. Brüls, Geometrically exact beam finite element formulated
        on the special Euclidean group SE(3), CMAME 268, 2014.
    """

    kind: ClassVar[str] = "helicoidal"
    geometric: ClassVar[tuple[str, ...]] = SHAPE
    symbol_shapes: ClassVar[Shapes] = STRAIN_SHAPES
    formulas: ClassVar[Lines] = HELICOIDAL

    @property
    def common(self) -> tuple[str, ...]:
        return SECTION

    def measures(self, at: Relative) -> tuple[Slopes, Slopes]:
        return Slopes(-0.5), at.inverse

    def field(self, ends: Ends, at: Relative, e: Matrix) -> Field:
        section = Section.of(ends)
        strain = Matrix.vstack(at.turn, e)
        return Elastic.of(strain, section.free, section.stiffness, section.length)
