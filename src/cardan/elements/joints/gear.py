"""Gear: a rotation that follows that of another joint."""

from __future__ import annotations

from typing import ClassVar

from ...records import dataclass
from ..quantity import Direction, JointName, Value
from ..validation import number
from .hinge import Hinge


@dataclass(frozen=True)
class Gear(Hinge):
    """A wheel whose angle is ratio times the coordinate of another joint plus an offset.

    It has no coordinate of its own: the equations are those of the leader, which carries the
    torque of the teeth. Between two joints that both have coordinates, :meth:`Model.constraint`
    says the same as a relation, with the torque of the teeth as its multiplier.

    Args:
        leader: The joint it follows, or its name; one coordinate.
        ratio: Angle per coordinate of the leader; negative for wheels that mesh outside.
        axis: Direction in the parent frame: "x", "y", "z", "-x", ... or three numbers or
            expressions (of any length but 0).
        offset: Angle where the leader is at 0 [rad].

    Raises:
        ModelError: the axis is zero, NaN or not a direction; ratio or offset are not numbers.

    Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, section 9.6.
    """

    kind: ClassVar[str] = "gear"
    title: ClassVar[str] = "gear"
    leader: JointName
    ratio: Value = 1.0
    axis: Direction = "z"
    offset: Value = 0.0

    def __post_init__(self) -> None:
        super().__post_init__()
        for name in ("ratio", "offset"):
            object.__setattr__(self, name, number("gear", name, getattr(self, name)))

    @property
    def follows(self) -> tuple[JointName, Value, Value] | None:
        return self.leader, self.ratio, self.offset
