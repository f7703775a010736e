"""Two folds within one step: the parameter turns back and forth again, unseen from its ends."""

from __future__ import annotations

import numpy as np

from ...errors import SolveError
from .family import Family
from .follow import Place, Step

LOOKS = 6  # places at which it is looked for
PROMISING = 0.5  # of the least rate: what a parabola leaves of it where there may be two folds


def turn_inside(family: Family, step: Step) -> tuple[Place, float] | None:
    """The place and the part of a step at which the parameter runs back, though at neither end.

    Looked for along parabolas through rates of the parameter; the first one is that of the cubic
    with the parameters and the rates of both ends.
    """
    ends = step.before, step.after
    side = np.sign(ends[0].parameter_rate)
    rates = [side * place.parameter_rate for place in ends]
    if not min(rates) > 0:
        return None
    low, high = (family.parameter(place.point) for place in ends)
    chord = side * (high - low) / step.ds
    parts, rates = [0.0, 1.0, 0.5], [*rates, 1.5 * chord - 0.25 * sum(rates)]
    for look in range(LOOKS):
        nearest = np.argsort(rates)[:3]
        parabola = np.polyfit(np.array(parts)[nearest], np.array(rates)[nearest], 2)
        bottom = float(-0.5 * parabola[1] / parabola[0]) if parabola[0] > 0 else -1.0
        if not 0 < bottom < 1 or np.polyval(parabola, bottom) > PROMISING * min(rates[:2]):
            return None
        try:
            place = step.at(family, bottom)
        except SolveError:
            return None
        rate = side * place.parameter_rate
        if rate < 0:
            return place, bottom
        # the rate of the cubic was none of the curve
        known = 2 if look == 0 else len(parts)
        parts, rates = [*parts[:known], bottom], [*rates[:known], rate]
    return None
