"""Special points of a curve: folds, points where curves cross, changes of stability.

Signs at both ends of a step tell what lies within: of the rate of the parameter a fold, of the
orientation an odd number of crossings, of its onset another change of stability such as a period
doubling, of the number of unstable directions what the others do not explain. The step is halved
until one of them is left, which is then located.

Source: R. Seydel, Practical Bifurcation and Stability Analysis (2010), sections 5.2 to 5.4.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import field, replace

import numpy as np
from scipy.optimize import brentq

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from .family import Family, length
from .follow import EXACT, Place, Step
from .hidden_points import SMALL, UNDAMPED, oscillation_inside, turn_inside
from .interval import Interval
from .singular_point import HalfBranch, SingularPoint, other_curves, singular_point

FOLD, BRANCH, HOPF, EVENT = "fold", "branch point", "Hopf point", "event"
NARROW, THIN = 0.05, 2.0**-30  # of a step: where points are looked for, and given up
SINGLE = 1e-6  # of a step: oscillations that begin so near to one another count as one
NEAR = 2.0  # widths of a bracket within which a point must lie
MOST_LOST = 3  # of the rank
# length of increments that rounding leaves of a singular point; halvings that tell it better
UNCERTAIN, BISECTED = 1e-10, 40
AROUND = 1e-5, 1e-4, 1e-3, 1e-2  # of a step: places on either side of a fold
JUMP = 2.0  # distance of the ends of a part of a step, over its length
SURE = 1e-5  # steps that are not shortened where they seem to lead to another curve
Count = Callable[[Place], int | None]


@dataclass(frozen=True, eq=False)
class Test:
    """A number along a curve whose passage through 0 counts.

    Attributes:
        name: Of the event.
        value: The number.
        ends: Whether the curve ends there.
        parameter: Value of the parameter at which that is so; None where it depends on more.
        kind: Of the special point; the equations are singular at others than events.
    """

    name: str
    value: Callable[[Place], float]
    ends: bool = False
    parameter: float | None = None
    kind: str = EVENT

    @classmethod
    def at(cls, name: str, parameter: float, family: Family) -> Test:
        """The end of a curve at a value of its parameter."""
        return cls(name, lambda at: family.parameter(at.point) - parameter, True, parameter)

    def within(self, family: Family, step: Step, last: float) -> tuple[Place, float]:
        """Where it passes 0 within a step, and at which part of that.

        Args:
            family, step: Of what, within which step.
            last: Its value at the end of the step.

        Raises:
            SolveError: it is not found.
        """
        if last == 0:
            return step.after, 1.0
        if self.parameter is not None and (there := step.at_parameter(family, self.parameter)):
            return there
        if not self.value(step.before) * last <= 0:
            raise SolveError(f"{self.name} does not change its sign within a step")
        part = float(brentq(lambda part: self.value(step.at(family, part)), 0.0, 1.0, xtol=EXACT))
        return step.at(family, part), part


@dataclass(frozen=True, eq=False)
class Onset:
    """A change of stability at which curves neither turn back nor cross.

    Attributes:
        kind: Of the special point.
        value: A smooth number along the curve that passes 0 there.
    """

    kind: str
    value: Callable[[Place], float]


@dataclass(frozen=True, eq=False)
class Special:
    """A special point of a curve.

    Attributes:
        kind: ``"fold"``, ``"branch point"``, ``"event"``, or what the solutions call it, such as
            ``"Hopf point"``.
        label: What of; the name of an event.
        place: Where.
        after: Place of the curve behind which it lies.
        part: Of the step from there.
        singular: The singular point; None of others.
        halves: The curves that leave it other than this one.
        frequency: Of the oscillation that begins there [rad/s], or [rad] from lap to lap; NaN of
            others.
        accurate: False where it is only known to lie within a short step.
        jump: True where the step leads to another curve.
        followed: Names of the curves that follow the halves, by their numbers.
    """

    kind: str
    label: str
    place: Place
    after: int
    part: float
    singular: SingularPoint | None = None
    halves: Sequence[HalfBranch] = ()
    frequency: float = np.nan
    accurate: bool = True
    jump: bool = False
    followed: Mapping[int, str] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Corner:
    """A point of a curve behind which the equations are others.

    Attributes:
        special: The point.
        onward: The same point with the other equations, in the direction in which the curve goes
            on; None where none is possible.
    """

    special: Special
    onward: Place | None


@dataclass(frozen=True, eq=False)
class Watch:
    """What is looked for along a curve.

    Attributes:
        count: Unstable directions with the parameter kept; None where they are not known.
        growth: Real part of the oscillation next to growing and its frequency; None without.
        oscillation: Kind of the points at which it begins.
        onsets: Other changes of stability.
        tests: Events and ends.
        most: Places at most.
        switches: Whether curves that leave branch points are looked for.
        corner: The first corner within a step from the place with a number; None without any.
        ends: Ends of other curves, by what they are; the curve ends there too.
    """

    count: Count
    growth: Callable[[Place], tuple[float, float]] | None = None
    oscillation: str = HOPF
    onsets: Sequence[Onset] = ()
    tests: Sequence[Test] = ()
    most: int = 300
    switches: bool = True
    corner: Callable[[Step, int], Corner | None] = lambda *_: None
    ends: Sequence[tuple[str, Place]] = ()


def within(family: Family, number: int, watch: Watch, step: Step) -> Iterator[Special]:
    """Special points within a step that follows a place of a curve."""
    ends = step.before, step.after
    counts = watch.count(ends[0]), watch.count(ends[1])
    onsets = _signs(watch, ends[0]), _signs(watch, ends[1])
    interval = Interval.of(family, (0.0, 1.0), *ends, counts, onsets)
    if interval.quiet and (peak := _inside(family, watch, step)) is not None:
        middle, part = peak
        inside = watch.count(middle), _signs(watch, middle)
        for span, before, after in (
            ((0.0, part), (ends[0], counts[0], onsets[0]), (middle, *inside)),
            ((part, 1.0), (middle, *inside), (ends[1], counts[1], onsets[1])),
        ):
            (one, low, first), (other, high, last) = before, after
            half = Interval.of(family, span, one, other, (low, high), (first, last))
            yield from _searched(family, number, watch, step, half)
        return
    yield from _searched(family, number, watch, step, interval)


def _inside(family: Family, watch: Watch, step: Step) -> tuple[Place, float] | None:
    """A place of a step where the load runs back or an oscillation grows as at neither end."""
    if (turn := turn_inside(family, step)) is not None:
        return turn
    small = len(family.weights) <= SMALL
    if watch.growth is None or watch.oscillation != HOPF or not small:
        return None
    return oscillation_inside(family, watch.growth, step)


def _signs(watch: Watch, place: Place) -> Array:
    """Signs of the onsets at a place."""
    return np.array([np.sign(onset.value(place)) for onset in watch.onsets])


def _searched(
    family: Family, number: int, watch: Watch, step: Step, interval: Interval
) -> Iterator[Special]:
    """Special points within a part of a step."""
    if interval.quiet:
        return
    width = interval.high - interval.low
    if length(family, interval.chord(family)) > JUMP * width * step.ds:
        place, part = interval.after, interval.high
        yield Special(BRANCH, "", place, number, part, accurate=False, jump=True)
        return
    if interval.folds and not (interval.crosses or interval.unexplained or interval.begins):
        fold = _fold(family, step, interval, number)
        yield fold
        if watch.growth is not None and fold.accurate:
            yield from _around_fold(family, number, watch, step, interval, fold.part)
        return
    if interval.begins and not (interval.folds or interval.crosses or interval.unexplained):
        for k in interval.begins:
            yield _onset(family, watch.onsets[k], step, interval, number)
        return
    lost = max(1, abs(interval.change)) if not interval.folds else 1
    if width <= NARROW and not interval.folds:
        if (crossing := _crossing(family, watch, step, interval, lost, number)) is not None:
            yield crossing
            return
        counted = watch.growth is not None and None not in interval.counts
        even = not interval.crosses and interval.unexplained % 2 == 0
        # of several oscillations that begin the step is halved until one of them is left
        if counted and even and (interval.unexplained <= 2 or width <= SINGLE):
            yield _hopf(family, watch, step, interval, number)
            return
    middle = 0.5 * (interval.low + interval.high)
    try:
        middle_place = step.at(family, middle) if width > THIN else None
    except SolveError:
        middle_place = None
    if middle_place is None:
        kind = BRANCH if interval.crosses or not interval.folds else FOLD
        # no point in between: the curve that is left ends there, or is singular
        place, part, jump = interval.after, interval.high, width > THIN
        yield Special(kind, "", place, number, part, accurate=False, jump=jump)
        return
    count, signs = watch.count(middle_place), _signs(watch, middle_place)
    (first, last), (before, after) = interval.counts, interval.onsets
    for half in (
        Interval.of(
            family, (interval.low, middle), interval.before, middle_place,
            (first, count), (before, signs),
        ),
        Interval.of(
            family, (middle, interval.high), middle_place, interval.after,
            (count, last), (signs, after),
        ),
    ):  # fmt: skip
        yield from _searched(family, number, watch, step, half)


def _around_fold(
    family: Family, number: int, watch: Watch, step: Step, interval: Interval, part: float
) -> Iterator[Special]:
    """Special points on either side of a fold, which explains but one direction that changes."""
    first, last = interval.counts
    for around in AROUND:
        low, high = part - around, part + around
        try:
            before = step.at(family, low) if low > interval.low else interval.before
            after = step.at(family, high) if high < interval.high else interval.after
        except SolveError:
            continue
        counts = watch.count(before), watch.count(after)
        # one real motion begins or ends to grow at a fold, others in pairs: an even change tells
        # that growth next to the fold is rounding still
        if counts[0] is None or counts[1] is None or (counts[1] - counts[0]) % 2:
            break
    else:
        return
    sides = (
        (interval.low, low, interval.before, before, (first, counts[0]), interval.onsets[0]),
        (high, interval.high, after, interval.after, (counts[1], last), _signs(watch, after)),
    )
    for start, end, here, there, both, signs in sides:
        if start < end:
            onsets = (signs, _signs(watch, there))
            side = Interval.of(family, (start, end), here, there, both, onsets)
            if not side.folds:
                yield from _searched(family, number, watch, step, side)


def _fold(family: Family, step: Step, interval: Interval, number: int) -> Special:
    """The place where the parameter turns back."""
    try:
        place = step.fold(family, interval.low, interval.high)
        return Special(FOLD, "", place, number, step.part(family, place.point))
    except SolveError:
        return Special(FOLD, "", interval.after, number, interval.high, accurate=False)


def _onset(family: Family, onset: Onset, step: Step, interval: Interval, number: int) -> Special:
    """The place where an onset lies."""

    def value(part: float) -> float:
        return onset.value(step.at(family, part))

    try:
        part = float(brentq(value, interval.low, interval.high, xtol=EXACT))
        return Special(onset.kind, "", step.at(family, part), number, part)
    except SolveError:
        return Special(onset.kind, "", interval.after, number, interval.high, accurate=False)


def _crossing(
    family: Family, watch: Watch, step: Step, interval: Interval, lost: int, number: int
) -> Special | None:
    """The point within a part of a step where curves cross; None where none is found."""
    start = family.moved(interval.before.point, 0.5 * interval.chord(family))
    for k in range(lost, MOST_LOST + 1):
        try:
            singular = singular_point(family, start, k)
        except SolveError:
            continue
        part = step.part(family, singular.point)
        width = interval.high - interval.low
        if not interval.low - NEAR * width <= part <= interval.high + NEAR * width:
            continue
        halves, tangent = other_curves(singular, step.before.tangent, watch.switches)
        place = Place(singular.point, tangent, float(tangent[-1]), 0.0)
        if singular.uncertainty > UNCERTAIN:
            part, place = _bisected(family, watch, step, interval, place)
        return Special(BRANCH, "", place, number, part, singular, halves)
    return None


def _bisected(
    family: Family, watch: Watch, step: Step, interval: Interval, place: Place
) -> tuple[float, Place]:
    """The place at which signs of pivots change: in slender beams they tell more than J does."""
    low, high = interval.low, interval.high
    for _ in range(BISECTED):
        middle = 0.5 * (low + high)
        try:
            there = step.at(family, middle)
        except SolveError:
            break
        count = watch.count(there)
        if interval.change and count is not None:
            behind = count != interval.counts[0]
        else:
            behind = there.orientation * interval.before.orientation < 0
        low, high = (low, middle) if behind else (middle, high)
        place = replace(there, tangent=place.tangent, parameter_rate=place.parameter_rate)
    return high, place


def _hopf(family: Family, watch: Watch, step: Step, interval: Interval, number: int) -> Special:
    """The place where an oscillation begins to grow."""
    growth = watch.growth
    assert growth is not None
    low, high, count = interval.low, interval.high, interval.counts[0]
    frequency = np.nan
    try:
        with suppress(SolveError):
            (before, slow), (after, fast) = map(growth, (interval.before, interval.after))
            if before * after < 0 and min(abs(before / slow), abs(after / fast)) > UNDAMPED:
                low = high = float(
                    brentq(lambda part: growth(step.at(family, part))[0], low, high, xtol=EXACT)
                )
        # without damping nothing grows before, and nothing decays; near folds nothing oscillates
        while high - low > EXACT:
            middle = 0.5 * (low + high)
            if watch.count(step.at(family, middle)) == count:
                low = middle
            else:
                high = middle
        place = step.at(family, high)
        frequency = growth(place)[1]
        return Special(watch.oscillation, "", place, number, high, frequency=frequency)
    except SolveError:
        return Special(watch.oscillation, "", interval.after, number, interval.high, accurate=False)
