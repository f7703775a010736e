"""The classical two-node beam with reduced integration."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.short_rotations import Slopes
from ..formulas import Lines, Shapes
from .element_ends import Ends
from .formulas import CLASSICAL, CLASSICAL_PLAIN, STRAIN_SHAPES
from .relative import Relative, mean_axes
from .section import SECTION, SHAPE, Section, without_locking
from .strain import Elastic, Field, StrainElement


@dataclass(frozen=True)
class Classical(StrainElement):
    """Simo's geometrically exact beam, two nodes, integrated by its middle point.

    Positions and the rotation between the ends vary linearly, so that the strain is objective and
    independent of the path, ``energy = y·C y / (2 L), y = (theta, R_middleᵀ (p_2 - p_1)) - free``.
    Second order in statics.

    Args:
        residual_flexibility: The shear compliance gains L²/(12 EI), which makes straight elements
            exact for small displacements under loads at nodes.

    Source: Simo and Vu-Quoc, CMAME 58 (1986); Crisfield and Jelenić, Proc. R. Soc. A 455 (1999);
        MacNeal, Computers and Structures 8 (1978) for the residual bending flexibility.
    """

    kind: ClassVar[str] = "classical"
    geometric: ClassVar[tuple[str, ...]] = SHAPE
    symbol_shapes: ClassVar[Shapes] = STRAIN_SHAPES
    residual_flexibility: bool = True

    @property
    def common(self) -> tuple[str, ...]:
        return SECTION

    @property
    def variant(self) -> str:
        return "" if self.residual_flexibility else "plain"

    @property
    def formula_lines(self) -> Lines:
        return CLASSICAL if self.residual_flexibility else CLASSICAL_PLAIN

    def measures(self, at: Relative) -> tuple[Slopes, Slopes]:
        return mean_axes(at.turn)

    def field(self, ends: Ends, at: Relative, e: Matrix) -> Field:
        section = Section.of(ends)
        stiffness, length = list(section.stiffness), section.length
        if self.residual_flexibility:
            stiffness = without_locking(stiffness, length)
        return Elastic.of(Matrix.vstack(at.turn, e), section.free, stiffness, length)
