"""Two folds within one step: the parameter turns back and forth again, unseen from its ends."""

from __future__ import annotations

import numpy as np

from ...errors import SolveError
from .family import Family
from .follow import Place, Step
from .interval import FLAT

LOOKS = 6  # places at which it is looked for
PROMISING = 0.5  # of the lesser rate at the ends: what a parabola leaves where there may be folds
APART = 1e-4  # of a step: places that tell more than one


def turn_inside(family: Family, step: Step) -> tuple[Place, float] | None:
    """The place and the part of a step at which the parameter runs back, though at neither end.

    Looked for along parabolas through rates of the parameter; the first one is that of the cubic
    with the parameters and the rates of both ends.
    """
    side = np.sign(step.before.parameter_rate)
    low, high = (side * place.parameter_rate for place in (step.before, step.after))
    if not min(low, high) > FLAT:
        return None
    change = family.parameter(step.after.point) - family.parameter(step.before.point)
    part, inside = 0.5, 1.5 * side * change / step.ds - 0.25 * (low + high)
    for _ in range(LOOKS):
        # rates low + slope h + bend h^2 through both ends and the part
        bend = (high - low - (inside - low) / part) / (1 - part)
        slope = high - low - bend
        bottom = -0.5 * slope / bend if bend > 0 else -1.0
        if not 0 < bottom < 1 or low + 0.5 * slope * bottom > PROMISING * min(low, high):
            return None
        if not APART < bottom < 1 - APART:
            return None
        try:
            place = step.at(family, bottom)
        except SolveError:
            return None
        rate = side * place.parameter_rate
        if rate < 0:
            return place, bottom
        if abs(bottom - part) < APART:
            return None
        part, inside = bottom, rate
    return None
