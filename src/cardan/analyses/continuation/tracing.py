"""Follow a curve to an end, and note what it passes."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import field, replace

from scipy.optimize import brentq

from ...errors import SolveError
from ...records import dataclass
from .curve import Curve
from .family import length
from .follow import EXACT, End, Place, Reach, Step, steps
from .special_points import BRANCH, EVENT, FOLD, SURE, Corner, Special, Test, Watch, within

SAME = 1e-6  # lengths of increments between branch points that are one
ROOT, LEVEL = 1e-3, 1e-9  # the same of a fold at a branch point, and the difference of loads
AT_END = 1e-3  # of a step: a fold that is the end of the curve
PASSED = 1e-4  # of a number at the ends of a step: where equations can be solved beside its 0
HALVED = 30  # parts of steps beside points at which equations are singular
JUMPED = 0.1  # of a number at the ends of a step: what is left next to where it passes 0


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


@dataclass(eq=False)
class _Look:
    """What a step passes, looked at before it is accepted.

    Attributes:
        curve, watch: Of what.
        corner: The first corner within it.
        special: Points of the curve up to there.
    """

    curve: Curve
    watch: Watch
    corner: Corner | None = None
    special: list[Special] = field(default_factory=list)

    def stays(self, step: Step) -> bool:
        """True unless signs change where nothing crosses: the step leads to another curve."""
        number = len(self.curve.places) - 1
        self.corner, self.special = self.watch.corner(step, number), []
        passed = within(self.curve.family, number, self.watch, self.shortened(step))
        for special in sorted(passed, key=lambda special: special.kind != BRANCH):
            if not any(self._is_at(s, special) for s in self.special + self.curve.special[-1:]):
                self.special.append(special)
        return step.ds < SURE or not any(s.jump for s in self.special)

    def _is_at(self, one: Special, other: Special) -> bool:
        """True where a point is a branch point: on which a step ends, or where the load turns."""
        if one.kind != BRANCH or one.singular is None or other.kind not in (BRANCH, FOLD):
            return False
        if other.kind == BRANCH and other.singular is None:
            return False
        family, points = self.curve.family, (one.place.point, other.place.point)
        away = length(family, family.step(*points))
        if other.kind == BRANCH:
            return away < SAME
        # the rate of the load is 0 there up to rounding, so that its place is as good as a root
        here, there = map(family.parameter, points)
        return away < ROOT and abs(here - there) < LEVEL

    def shortened(self, step: Step) -> Step:
        """The step up to its first corner."""
        if self.corner is None:
            return step
        return step.shortened(self.corner.special.place, self.corner.special.part)


def _traced(
    curve: Curve, watch: Watch, reach: Reach, begin: Place, on_step: Callable[[Curve], None]
) -> Place | None:
    """Follow a curve to its end, or to a corner; the place behind that.

    Raises:
        End: the curve is not followed any further.
    """
    values, look = [test.value(begin) for test in watch.tests], _Look(curve, watch)
    for long_step in steps(curve.family, begin, reach, look.stays):
        step, corner = look.shortened(long_step), look.corner
        curve.corrections += step.corrections
        curve.refused += step.refused
        curve.contraction = max(curve.contraction, step.contraction)
        after = [test.value(step.after) for test in watch.tests]
        end = _tested(curve, watch.tests, step, values, after, look.special)
        curve.special += [s for s in look.special if end is None or _is_before(s, end)]
        if end is not None:
            curve.special.append(end)
            curve.places.append(end.place)
            curve.status, curve.ended = "finished", f"reached {end.label}"
            return None
        if corner is not None:
            curve.special.append(replace(corner.special, part=1.0))
            if corner.onward is None:
                curve.places.append(step.after)
                raise End(f"nothing balances behind {corner.special.label}")
            curve.places.append(corner.onward)
            on_step(curve)
            return corner.onward
        curve.places.append(step.after)
        values = after
        on_step(curve)
        if _ends(curve, watch, step):
            return None
    return None


def _is_before(special: Special, end: Special) -> bool:
    """True of a point in front of an end: one of its own kind of place is a fold as well."""
    return special.part <= end.part - (0.0 if end.kind == EVENT else AT_END)


def _ends(curve: Curve, watch: Watch, step: Step) -> bool:
    """True when a curve is closed, comes to an end of another one, or has all its places."""
    start, counts = curve.places[0], curve.family.weights[-1] > 0
    # where the parameter counts, a curve that is closed turns back
    reverses = any(p.parameter_rate * start.parameter_rate <= 0 for p in curve.places)
    if (reverses or not counts) and start is not step.before:
        part, along = step.passes(curve.family, start)
        if along > 0:
            _cut(curve, step, part)
            curve.status, curve.ended = "closed", "closed: it leads back to its start"
            return True
    for name, end in watch.ends:
        part, along = step.passes(curve.family, end)
        if along:
            _cut(curve, step, part)
            curve.status, curve.ended = "joined", f"reached {name}"
            return True
    if len(curve.places) >= watch.most:
        curve.ended = f"after {watch.most} points, the most that points= allows"
        return True
    return False


def _cut(curve: Curve, step: Step, part: float) -> None:
    """End a curve within its last step."""
    number = len(curve.places) - 2
    curve.places[-1] = step.at(curve.family, part)
    curve.special = [s for s in curve.special if s.after < number or s.part <= part]


def _tested(
    curve: Curve, tests: Sequence[Test], step: Step, before: list[float], after: list[float],
    passed: Sequence[Special],
) -> Special | None:  # fmt: skip
    """Note events within a step that passes special points; the first that ends the curve."""
    number = len(curve.places) - 1
    # what is passed on the way to a singular end may be undone behind it, as by cycles at rest
    events = _singular_ends(curve, tests, step, before, after)
    short, share = step, 1.0
    if events:
        short, share = step.shortened(events[0].place, events[0].part), events[0].part
        after = [test.value(short.after) for test in tests]
    for test, low, high in zip(tests, before, after, strict=True):
        if test.kind != EVENT or low == 0 or not low * high <= 0:
            continue
        try:
            (place, part), accurate = test.within(curve.family, short, high), True
            part *= share
        except SolveError:
            place, part, accurate = _at_singular(
                curve, test, step, passed, max(abs(low), abs(high))
            )
        events.append(Special(EVENT, test.name, place, number, part, accurate=accurate))
    ends = {test.name for test in tests if test.ends}
    last = min((s for s in events if s.label in ends), key=lambda s: s.part, default=None)
    curve.special += [
        s for s in events if s.label not in ends and (last is None or s.part <= last.part)
    ]
    return last


def _at_singular(
    curve: Curve, test: Test, step: Step, passed: Sequence[Special], size: float
) -> tuple[Place, float, bool]:
    """The place of an event at which equations are singular, its part, and whether it is exact."""
    for special in passed:
        if special.accurate and abs(test.value(special.place)) <= LEVEL * size:
            return special.place, special.part, True
    part, place = _singular_end(curve, test, step)
    return place, part, False


def _singular_ends(
    curve: Curve, tests: Sequence[Test], step: Step, before: list[float], after: list[float]
) -> list[Special]:
    """Where equations are singular within a step, the first of such places in front."""
    ends, number = list[Special](), len(curve.places) - 1
    for test, low, high in zip(tests, before, after, strict=True):
        if test.kind == EVENT or low == 0 or not low * high <= 0:
            continue
        part, place = _singular_end(curve, test, step)
        # where a sign alone changes nothing is passed
        if abs(test.value(place)) <= JUMPED * max(abs(low), abs(high)):
            ends.append(Special(test.kind, test.name, place, number, part))
    return sorted(ends, key=lambda special: special.part)


def _singular_end(curve: Curve, test: Test, step: Step) -> tuple[float, Place]:
    """The part of a step at which a number passes 0 where equations are singular, and the place.

    That is one a little before, at which they can be solved: nearer to it rounding grows.
    """
    nearest = 1.0, step.after
    before, after = test.value(step.before), test.value(step.after)
    small = PASSED * max(abs(before), abs(after))
    aim = math.copysign(small, before)
    smallest = abs(after - aim)

    def value(part: float) -> float:
        nonlocal nearest, smallest
        place = step.at(curve.family, part)
        off = test.value(place) - aim
        if abs(off) <= smallest:
            nearest, smallest = (part, place), abs(off)
        return 0.0 if abs(off) <= 0.5 * small else off

    # a step that begins nearer to it than where it is looked for: nothing lies in front
    if value(0.0) * value(1.0) > 0:
        return nearest
    try:
        brentq(value, 0, 1, xtol=EXACT)
    except SolveError:
        low, high = 0.0, 1.0
        for _ in range(HALVED):
            middle = 0.5 * (low + high)
            try:
                beyond = value(middle) * before <= 0
            except SolveError:
                beyond = True
            low, high = (low, middle) if beyond else (middle, high)
    return nearest
