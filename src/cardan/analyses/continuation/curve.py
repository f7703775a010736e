"""A curve with its special points and events, followed to an end."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from scipy.optimize import brentq

from ...errors import SolveError
from .family import Family, length
from .follow import End, Place, Reach, Step, steps
from .special_points import EVENT, EXACT, Special, Test, Watch, within

CLOSED = 1e-7  # of a step: a curve that comes back to its start


@dataclass(eq=False)
class Curve:
    """What was found of a curve so far.

    Attributes:
        family: Of what.
        places: In their order.
        special: Its special points.
        ended: Why it ended.
        status: ``"finished"``, ``"closed"``, ``"budget"``, ``"singular"`` or ``"interrupted"``.
        corrections, refused: Linear systems solved, steps that were halved.
    """

    family: Family
    places: list[Place]
    special: list[Special] = field(default_factory=list)
    ended: str = ""
    status: str = "budget"
    corrections: int = 0
    refused: int = 0


def trace(
    curve: Curve, watch: Watch, reach: Reach, on_step: Callable[[Curve], None] = lambda _: None
) -> None:
    """Follow a curve from its last place to an end; what was found stays, whatever happens."""
    family, start = curve.family, curve.places[-1]
    values = [test.value(start) for test in watch.tests]
    try:
        for step in steps(family, start, reach):
            curve.corrections += step.corrections
            curve.refused += step.refused
            after = [test.value(step.after) for test in watch.tests]
            end = _tested(curve, watch.tests, step, values, after)
            special = [*within(family, len(curve.places) - 1, watch, step)]
            curve.special += [s for s in special if end is None or s.part <= end.part]
            if end is not None:
                curve.special.append(end)
                curve.places.append(end.place)
                curve.status, curve.ended = "finished", f"reached {end.label}"
                break
            curve.places.append(step.after)
            values = after
            on_step(curve)
            if _comes_back(family, start, step):
                curve.status, curve.ended = "closed", "closed: it leads back to its start"
                break
            if len(curve.places) >= watch.most:
                curve.ended = f"after {watch.most} points, the most that points= allows"
                break
    except End as end_of_steps:
        curve.status, curve.ended = "singular", str(end_of_steps)
    curve.special.sort(key=lambda s: (s.after, s.part))


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


# folds, crossings and changes of stability
