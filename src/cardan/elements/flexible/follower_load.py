"""A force along a beam that turns with its section."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from ...ir.matrix import Matrix
from .ends import Ends, Pose
from .loading import DENSITIES, LoadElement


@dataclass(frozen=True)
class FollowerLoad(LoadElement):
    """Force per length of the reference shape in section axes, linear along the element.

    It has no potential, and its tangent is not symmetric.

    Source: Argyris and Symeonidis, CMAME 26 (1981).
    """

    kind: ClassVar[str] = "follower_load"
    source: ClassVar[str] = (
        "J. H. Argyris, S. Symeonidis, Nonlinear finite element analysis of elastic systems under "
        "nonconservative loading, CMAME 26, 1981"
    )
    common: ClassVar[tuple[str, ...]] = DENSITIES
    own: ClassVar[tuple[str, ...]] = ("length",)

    def densities(self, ends: Ends, poses: Sequence[Pose]) -> tuple[Matrix, Matrix]:
        first, last = poses
        return (
            first.rotation @ ends.vector(*DENSITIES[:3]),
            last.rotation @ ends.vector(*DENSITIES[3:]),
        )

    def potential(self, ends: Ends, poses: Sequence[Pose]) -> Matrix | None:
        return None
