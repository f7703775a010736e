"""A curve with its special points, as far as it was followed."""

from __future__ import annotations

from dataclasses import dataclass, field

from .family import Family
from .follow import Place
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
