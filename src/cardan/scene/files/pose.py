"""Poses in plain numbers: how the parts of a file stand to each other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ...records import dataclass
from ...spatial.numbers import UPRIGHT, Rows, Vector, product, roll_pitch_yaw, rotated, transposed
from .angles import RESIDUE


@dataclass(frozen=True)
class Pose:
    """A frame seen from another.

    Attributes:
        rotation: Its axes to those of the other, rows of R (3, 3).
        position: Its origin in axes of the other (3) [m].
    """

    rotation: Rows
    position: Vector

    def then(self, inner: Pose) -> Pose:
        """A frame that is seen from this one, seen from the other."""
        return Pose(product(self.rotation, inner.rotation), self.point(inner.position))

    def point(self, point: Sequence[float]) -> Vector:
        """A point of this frame, seen from the other."""
        moved = rotated(self.rotation, point)
        x, y, z = (a + b for a, b in zip(self.position, moved, strict=True))
        return x, y, z

    def inverse(self) -> Pose:
        """The other frame seen from this one."""
        back = transposed(self.rotation)
        x, y, z = (-entry for entry in rotated(back, self.position))
        return Pose(back, (x, y, z))


HERE = Pose(UPRIGHT, (0.0, 0.0, 0.0))


def written(rotation: Rows) -> Any:
    """A rotation as bodies and frames take it: ("xyz", roll, pitch, yaw), None for none."""
    angles = [0.0 if abs(a) <= 4 * RESIDUE else a for a in roll_pitch_yaw(rotation)]
    return ("xyz", *angles) if any(angles) else None
