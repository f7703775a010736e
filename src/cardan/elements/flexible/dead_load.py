"""A force along a beam that keeps its direction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from ...ir.matrix import Matrix
from .ends import Ends, Pose
from .loading import DENSITIES, LoadElement, shares


@dataclass(frozen=True)
class DeadLoad(LoadElement):
    """Force per length of the reference shape in ground axes, linear along the element.

    Source: Przemieniecki, Theory of Matrix Structural Analysis (1968), section 5.6.
    """

    kind: ClassVar[str] = "dead_load"
    source: ClassVar[str] = (
        "J. S. Przemieniecki, Theory of Matrix Structural Analysis, 1968, section 5.6"
    )
    common: ClassVar[tuple[str, ...]] = DENSITIES
    own: ClassVar[tuple[str, ...]] = ("length",)

    def densities(self, ends: Ends, poses: Sequence[Pose]) -> tuple[Matrix, Matrix]:
        return ends.vector(*DENSITIES[:3]), ends.vector(*DENSITIES[3:])

    def potential(self, ends: Ends, poses: Sequence[Pose]) -> Matrix | None:
        total = Matrix.zeros(ends.graph, 1)
        for pose, (along, force) in zip(
            poses, shares(ends, self.densities(ends, poses)), strict=True
        ):
            total = total - along.T @ pose.rotation.column(0) - force.T @ pose.position
        return total
