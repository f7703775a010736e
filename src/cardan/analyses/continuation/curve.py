"""A curve with its special points, as far as it was followed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field
from itertools import pairwise

from ...records import dataclass
from .family import Family
from .follow import Place, Reach, Step
from .special_points import Special, Test


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
        contraction: The largest of the corrections of a step.
        seconds: Time spent.
        reach: Controls of its steps.
        tests: Ends and events that were looked for.
    """

    family: Family
    places: list[Place]
    special: list[Special] = field(default_factory=list)
    ended: str = ""
    status: str = "budget"
    corrections: int = 0
    refused: int = 0
    contraction: float = 0.0
    seconds: float = 0.0
    reach: Reach = field(default_factory=Reach)
    tests: Sequence[Test] = ()

    def passes(self, there: Place) -> bool:
        """True when it leads through a place, as of positions that differ by full turns."""
        for before, after in pairwise(self.places):
            way = self.family.step(before.point, after.point)
            ds = float(before.tangent @ (self.family.weights * way))
            if Step(before, after, ds, 0, 0).passes(self.family, there)[1]:
                return True
        return False
