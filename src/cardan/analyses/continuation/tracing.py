"""Follow a curve to an end, and note what it passes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from scipy.optimize import brentq

from ...errors import SolveError
from .curve import Curve
from .family import Family, length
from .follow import End, Place, Reach, Step, steps
from .special_points import EVENT, EXACT, Special, Test, Watch, within

CLOSED = 1e-7  # of a step: a curve that comes back to its start


def trace(
    curve: Curve, watch: Watch, reach: Reach, on_step: Callable[[Curve], None] = lambda _: None
) -> None:
    """Follow a curve from its last place to an end; what was found stays, whatever happens."""
    begin: Place | None = curve.places[-1]
    try:
        while begin is not None:
            begin = _traced(curve, watch, reach, begin, on_step)
    except End as end_of_steps:
        curve.status, curve.ended = "singular", str(end_of_steps)
    curve.special.sort(key=lambda s: (s.after, s.part))


def _traced(
    curve: Curve, watch: Watch, reach: Reach, begin: Place, on_step: Callable[[Curve], None]
) -> Place | None:
    """Follow a curve to its end, or to a corner; the place behind that.

    Raises:
        End: the curve is not followed any further.
    """
    family = curve.family
    values = [test.value(begin) for test in watch.tests]
    for step in steps(family, begin, reach):
        curve.corrections += step.corrections
        curve.refused += step.refused
        corner = watch.corner(step, len(curve.places) - 1)
        if corner is not None:
            step = step.shortened(corner.special.place, corner.special.part)
        after = [test.value(step.after) for test in watch.tests]
        end = _tested(curve, watch.tests, step, values, after)
        special = [*within(family, len(curve.places) - 1, watch, step)]
        curve.special += [s for s in special if end is None or s.part <= end.part]
        if end is not None:
            curve.special.append(end)
            curve.places.append(end.place)
            curve.status, curve.ended = "finished", f"reached {end.label}"
            return None
        if corner is not None:
            curve.special.append(replace(corner.special, part=1.0))
            if corner.onward is None:
                curve.places.append(step.after)
                raise End(f"nothing balances behind {corner.special.label}", step.after)
            curve.places.append(corner.onward)
            on_step(curve)
            return corner.onward
        curve.places.append(step.after)
        values = after
        on_step(curve)
        if _comes_back(family, curve.places[0], step):
            curve.status, curve.ended = "closed", "closed: it leads back to its start"
            return None
        if len(curve.places) >= watch.most:
            curve.ended = f"after {watch.most} points, the most that points= allows"
            return None
    return None


def _tested(
    curve: Curve, tests: Sequence[Test], step: Step, before: list[float], after: list[float]
) -> Special | None:
    """Note events within a step; the first that ends the curve."""
    events, number = list[Special](), len(curve.places) - 1
    for test, low, high in zip(tests, before, after, strict=True):
        if low == 0 or not low * high <= 0:
            continue

        def value(part: float, test: Test = test) -> float:
            return test.value(step.at(curve.family, part))

        try:
            part = 1.0 if high == 0 else float(brentq(value, 0, 1, xtol=EXACT))
            place, accurate = step.at(curve.family, part), True
        except SolveError:
            part, place, accurate = 1.0, step.after, False
        events.append(Special(EVENT, test.name, place, number, part, accurate=accurate))
    ends = {test.name for test in tests if test.ends}
    last = min((s for s in events if s.label in ends), key=lambda s: s.part, default=None)
    curve.special += [
        s for s in events if s.label not in ends and (last is None or s.part <= last.part)
    ]
    return last


def _comes_back(family: Family, start: Place, step: Step) -> bool:
    """True when a step passes the start in the direction in which the curve left it."""
    if start is step.before:
        return False
    to = family.step(step.before.point, start.point)
    along = float(step.before.tangent @ (family.weights * to))
    if not 0 < along <= step.ds * (1 + 1e-9) or length(family, to) > 2 * step.ds:
        return False
    try:
        there = step.at(family, along / step.ds)
    except SolveError:
        return False
    off = length(family, family.step(there.point, start.point))
    same = float(there.tangent @ (family.weights * start.tangent)) > 0
    return bool(off <= CLOSED * max(1.0, step.ds) and same)
