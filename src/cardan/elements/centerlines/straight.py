"""A straight line."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from ...arrays import Array
from ...records import dataclass
from ..quantity import Quantity
from .centerline import Centerline, Curve


@dataclass(frozen=True)
class Straight(Centerline):
    """The straight line between the ends."""

    kind: ClassVar[str] = "straight"

    def quantities(self) -> dict[str, Quantity]:
        return {}

    def curve(self, start: Array, end: Array, data: Mapping[str, Array]) -> Curve:
        length = float(np.linalg.norm(end - start))
        along = (end - start) / (length or 1.0)

        def at(s: Array) -> tuple[Array, Array]:
            # from the nearer end, so that both are met exactly
            k = (s / (length or 1.0))[:, None]
            positions = np.where(k <= 0.5, start + k * (end - start), end - (1 - k) * (end - start))
            return positions, np.broadcast_to(along, (len(s), 3)).copy()

        return Curve(length, at)
