"""A force along a beam that keeps its direction."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines, Shapes
from .element_ends import Ends
from .formulas import DEAD_LOAD, LOAD_SHAPES
from .loading import LoadElement
from .node_set import Pose
from .section import DEAD

MOMENT = ("dead_moment_1", "dead_moment_2", "dead_moment_3")


@dataclass(frozen=True)
class DeadLoad(LoadElement):
    """Force and moment per length of the reference shape in ground axes.

    The force has a potential, ``potential = -f · integral of x``; a moment that keeps its
    direction has none.

    Source: J. S. Przemieniecki, Theory of Matrix Structural Analysis, 1968, section 5.6.
    """

    kind: ClassVar[str] = "dead_load"
    geometric: ClassVar[tuple[str, ...]] = ("length",)
    symbol_shapes: ClassVar[Shapes] = LOAD_SHAPES
    formulas: ClassVar[Lines] = DEAD_LOAD
    quantities: ClassVar[tuple[str, ...]] = (*DEAD, *MOMENT)
    fixed: ClassVar[bool] = True

    def densities(self, ends: Ends, pose: Pose) -> tuple[Matrix, Matrix]:
        return ends.vector(*DEAD), pose.rotation.T @ ends.vector(*MOMENT)
