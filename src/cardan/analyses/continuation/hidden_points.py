"""Pairs of special points within one step, unseen from its ends: folds, and Hopf points."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...errors import SolveError
from .family import Family
from .follow import Place, Step
from .interval import FLAT

LOOKS = 6  # places of a step at which a pair is looked for
PROMISING = 0.5  # of the least rate so far: what a parabola leaves of it where a pair may lie
DISTINCT = 1e-4  # of a step: places that tell more than one
# decay, as a part of the frequency, behind which growth may lie; unknowns at most
LIGHT, SMALL = 0.05, 60
UNDAMPED = 1e-9  # decay, as a part of the frequency, that is rounding


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
        if not DISTINCT < bottom < 1 - DISTINCT:
            return None
        try:
            place = step.at(family, bottom)
        except SolveError:
            return None
        rate = side * place.parameter_rate
        if rate < 0:
            return place, bottom
        if abs(bottom - part) < DISTINCT:
            return None
        part, inside = bottom, rate
    return None


def oscillation_inside(
    family: Family, growth: Callable[[Place], tuple[float, float]], step: Step
) -> tuple[Place, float] | None:
    """The place and the part of a step at which an oscillation grows, though not at its ends.

    Looked for along parabolas through decay rates where little damping is left. A growth within a
    part of the step over which decay is not a parabola is not seen, as where one oscillation begins
    and another one ends, and none of large systems.
    """
    try:
        ends = [growth(place) for place in (step.before, step.after)]
        side = np.sign(ends[0][0])
        margins = [side * rate / turns for rate, turns in ends]
        if min(margins) < UNDAMPED or min(margins) > LIGHT:
            return None
        parts, rates, part = [0.0, 1.0], [side * rate for rate, _ in ends], 0.5
        for _ in range(LOOKS):
            place = step.at(family, part)
            rate = side * growth(place)[0]
            if rate < 0:
                return place, part
            parts, rates = [*parts, part], [*rates, rate]
            nearest = np.argsort(rates)[:3]
            parabola = np.polyfit(np.array(parts)[nearest], np.array(rates)[nearest], 2)
            bottom = -0.5 * parabola[1] / parabola[0] if parabola[0] > 0 else -1.0
            if not 0 < bottom < 1 or np.polyval(parabola, bottom) > PROMISING * min(rates):
                return None
            part = float(bottom)
    except SolveError:
        pass
    return None
