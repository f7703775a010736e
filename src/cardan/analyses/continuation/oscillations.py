"""Oscillations that begin and end again within a step of a path."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...errors import SolveError
from .family import Family
from .follow import Place, Step

# decay, as a part of the frequency, behind which growth may lie; looks for it; unknowns at most
LIGHT, PEAKS, SMALL = 0.05, 6, 60
PROMISING = 0.5  # of the least decay: what a parabola leaves of it where growth may lie
UNDAMPED = 1e-9  # decay, as a part of the frequency, that is rounding


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
        for _ in range(PEAKS):
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
