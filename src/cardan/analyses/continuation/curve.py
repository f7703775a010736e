"""A curve with its special points, as far as it was followed."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise

from .family import Family
from .follow import Place, Step
from .special_points import Special


@dataclass(eq=False)
class Curve:
    """What was found of a curve so far.

    Attributes:
        family: Of what.
        places: In their order.
        special: Its special points.
        ended: Why it ended.
        status: ``"finished"``, ``"closed"``, ``"joined"``, ``"budget"``, ``"singular"`` or
            ``"interrupted"``.
        corrections, refused: Linear systems solved, steps that were halved.
    """

    family: Family
    places: list[Place]
    special: list[Special] = field(default_factory=list)
    ended: str = ""
    status: str = "budget"
    corrections: int = 0
    refused: int = 0

    def passes(self, there: Place) -> bool:
        """True when it leads through a place, as of positions that differ by full turns."""
        for before, after in pairwise(self.places):
            way = self.family.step(before.point, after.point)
            ds = float(before.tangent @ (self.family.weights * way))
            if Step(before, after, ds, 0, 0).passes(self.family, there)[1]:
                return True
        return False
