"""A force along a beam that turns with its section."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines, Shapes
from .element_ends import Ends
from .formulas import FOLLOWER_LOAD, LOAD_SHAPES
from .loading import LoadElement
from .node_set import Pose
from .section import FOLLOWER

MOMENT = ("follower_moment_1", "follower_moment_2", "follower_moment_3")


@dataclass(frozen=True)
class FollowerLoad(LoadElement):
    """Force and moment per length of the reference shape in section axes.

    As ends have it, ``load = R_i f per length``; it has no potential, and its tangent is not
    symmetric.

    Source: J. H. Argyris, S. Symeonidis, Nonlinear finite element analysis of elastic systems under
        nonconservative loading, CMAME 26, 1981.
    """

    kind: ClassVar[str] = "follower_load"
    geometric: ClassVar[tuple[str, ...]] = ("length",)
    symbol_shapes: ClassVar[Shapes] = LOAD_SHAPES
    formulas: ClassVar[Lines] = FOLLOWER_LOAD
    quantities: ClassVar[tuple[str, ...]] = (*FOLLOWER, *MOMENT)
    fixed: ClassVar[bool] = False

    def densities(self, ends: Ends, pose: Pose) -> tuple[Matrix, Matrix]:
        return pose.rotation @ ends.vector(*FOLLOWER), ends.vector(*MOMENT)
