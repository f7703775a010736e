"""Revolute joint."""

from __future__ import annotations

from typing import ClassVar

from ...records import dataclass
from ..quantity import Direction
from .hinge import Hinge


@dataclass(frozen=True)
class Revolute(Hinge):
    """One rotation about an axis fixed in both bodies.

    Args:
        axis: Direction in the parent frame: "x", "y", "z", "-x", ... or three numbers or
            expressions (of any length but 0). The angle [rad] is the coordinate.

    Raises:
        ModelError: the axis is zero, NaN or not a direction.

    Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, table 4.1.
    """

    kind: ClassVar[str] = "revolute"
    axis: Direction = "z"
