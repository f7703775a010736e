"""A path and the branches that leave its branch points, each followed once."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import field, replace
from functools import partial
from time import perf_counter

import numpy as np

from ...records import dataclass
from ..simulation.progress import Show
from .curve import Curve
from .deflation import new_solutions
from .family import Family, Point, length
from .follow import Place, Reach, ahead, place
from .record import BranchRecord, ContinuationRecord
from .solutions import PathStart, Solutions
from .special_points import BRANCH, EVENT, Special, Test, Watch
from .tracing import trace

MAIN, OTHER = "main", "other"
SAME = 1e-6  # lengths of increments between points that are one
STILL = 1e-12  # parts of a tangent that do not move the system
PARALLEL = 0.999  # cosine of directions that are one
SEARCHES = 60  # for a solution to which no branch leads
LETTERS = "abcdefghijklmnopqrstuvwxyz"


@dataclass(eq=False)
class _Junction:
    """A branch point, and which of the branches that leave it were followed.

    Attributes:
        name: ``"branch point 1 of 'main'"``.
        curve, number: The curve that came to it first, and its number there.
    """

    name: str
    curve: Curve
    number: int

    def is_at(self, family: Family, special: Special) -> bool:
        """True when a point of a curve is this one."""
        if family is not self.curve.family:
            return False
        return length(family, family.step(self.special.place.point, special.place.point)) < SAME

    @property
    def special(self) -> Special:
        """The point."""
        return self.curve.special[self.number]

    def _follow(self, k: int, name: str) -> None:
        """Note that a branch is followed by the curve of a name."""
        followed = {**self.special.followed, k: name}
        self.curve.special[self.number] = replace(self.special, followed=followed)

    def passed(self, name: str, special: Special) -> None:
        """Note that a curve passes here: what it comes and leaves along is followed."""
        for k, half in enumerate(self.special.halves):
            along = float(half.tangent @ (self.curve.family.weights * special.place.tangent))
            if abs(along) > PARALLEL:
                self._follow(k, name)

    def leave(self, k: int, name: str) -> Place | None:
        """The first place of a branch under a name; None where it was followed."""
        if k in self.special.followed:
            return None
        self._follow(k, name)
        half = self.special.halves[k]
        return place(self.curve.family, half.point, half.direction)


@dataclass(frozen=True, eq=False)
class _Waiting:
    """A branch that was not followed yet.

    Attributes:
        name: Its name.
        first: The solutions that it consists of, and its first places; None where it was followed.
        generations: How many may follow, with it.
    """

    name: str
    first: Callable[[], tuple[Solutions, Curve] | None]
    generations: int


def _started(solutions: Solutions, *places: Place) -> tuple[Solutions, Curve]:
    """The first places of a branch."""
    return solutions, Curve(solutions.family, [*places])


def _outside(name: str, family: Family) -> Iterator[Test]:
    """The ends of branches that leave the range at its start, or begin at its end and go on."""
    if name.startswith(OTHER):
        # no path leads there from the start of the range
        yield Test.at("the start", 0.0, family)
    elif name != MAIN and family.weights[-1] > 0:
        yield Test.at("a range before the start", -1.0, family)
        yield Test.at("a range behind the end", 2.0, family)


def _noted(of: Solutions, curve: Curve) -> str:
    """Facts that users should know of a curve besides why it ended."""
    moving = of.moving(curve.places[-1].tangent)
    if curve.status == "singular" and moving:
        return f"; most of all it moves along {moving} there"
    if all(special.kind == EVENT for special in curve.special) and not any(
        np.abs(of.motion(place.tangent)).max(initial=0.0) > STILL for place in curve.places
    ):
        names = " and ".join(of.values(curve.places[0].point))
        return f"; nothing moves on the way: it stays where it is at any {names}"
    return ""


@dataclass(eq=False)
class Tracer:
    """Branches as they are followed.

    Attributes:
        tests: Ends and events of solutions.
        points: Of a branch at most.
        search: At how many values of the parameter to look for branches that are not connected.
        reach: Controls of steps.
        branches: Branches by name.
        junctions: Branch points that they pass.
    """

    tests: Callable[[Solutions], list[Test]]
    points: int
    search: int
    reach: Reach
    branches: dict[str, BranchRecord] = field(default_factory=dict)
    junctions: list[_Junction] = field(default_factory=list)

    def all_of(self, start: PathStart, depth: int, show: Show) -> ContinuationRecord:
        """The curve from a start, and the branches that leave it, each once."""
        solutions, begin = start.solutions, start.places[0]
        main = Curve(solutions.family, [*start.places], [*start.special])
        try:
            self._follow(_Waiting(MAIN, lambda: (solutions, main), depth + 1), show)
            for k in range(self.search):
                value = (k + 1) / self.search
                for number, point in enumerate(self._disconnected(solutions, begin, value), 1):
                    for letter, sign in (("a", -1.0), ("b", 1.0))[: 1 if value == 1.0 else 2]:
                        toward = sign * ahead(solutions.family, point)
                        first = place(solutions.family, point, toward)
                        name = f"{OTHER} {k + 1}.{number}{letter}"
                        begun = partial(_started, solutions, first)
                        self._follow(_Waiting(name, begun, depth + 1), show)
                        if self.branches[name].status == "closed":
                            break
        except KeyboardInterrupt:
            if not self.branches:
                raise
        return ContinuationRecord(solutions.model, dict(self.branches))

    def _follow(self, branch: _Waiting, show: Show) -> None:
        """A curve and the branches that leave it."""
        waiting = [branch]
        while waiting:
            branch = waiting.pop(0)
            first = branch.first() if branch.generations > 0 else None
            if first is None:
                continue
            of, curve = first
            self._trace(branch.name, of, curve, show)
            waiting += self._leaving(branch, of, curve)

    def _disconnected(self, of: Solutions, begin: Place, value: float) -> Iterator[Point]:
        """Solutions within the bounds at a value of the parameter, to which no branch leads."""
        ends = [test for test in self.tests(of) if test.ends]
        signs = [test.value(begin) for test in ends]

        def inside(point: Point) -> bool:
            at = Place(point, begin.tangent, 0.0, 0.0)
            return all(s * test.value(at) >= 0 for s, test in zip(signs, ends, strict=True))

        while True:
            curves = [b.curve for b in self.branches.values() if b.solutions is of]

            def new(point: Point, curves: list[Curve] = curves) -> bool:
                if not (inside(point) and of.consistent(point)):
                    return False
                there = place(of.family, point, ahead(of.family, point))
                return not any(curve.passes(there) for curve in curves)

            point = next(filter(new, new_solutions(curves, value, SEARCHES)), None)
            if point is None:
                return
            yield point

    def _trace(self, name: str, of: Solutions, curve: Curve, show: Show) -> None:
        """Follow a curve from its first places."""
        started = perf_counter()
        tests = [*self.tests(of), *_outside(name, of.family)]
        curve.reach, curve.tests = self.reach, tests
        watch = Watch(
            of.count, of.growth, of.oscillation, of.onsets, tests, self.points,
            corner=of.corner, ends=[*self._ends(of)],
        )  # fmt: skip

        def on_step(curve: Curve) -> None:
            show(len(curve.places) / self.points)

        try:
            trace(curve, watch, self.reach, on_step)
            curve.ended += _noted(of, curve)
        except KeyboardInterrupt:
            curve.status, curve.ended = "interrupted", "interrupted; what was computed is kept"
            raise
        finally:
            curve.seconds += perf_counter() - started
            self.branches[name] = BranchRecord.of(name, curve, of)

    def _ends(self, of: Solutions) -> Iterator[tuple[str, Place]]:
        """Ends of the curves so far: where one leads to them the other was followed from there."""
        for name, branch in self.branches.items():
            places = branch.curve.places
            if branch.solutions is not of:
                continue
            if name == MAIN:
                yield f"the start of '{name}'", places[0]
            if branch.status not in ("closed", "joined"):
                yield f"the end of '{name}'", places[-1]

    def _leaving(self, branch: _Waiting, of: Solutions, curve: Curve) -> list[_Waiting]:
        """Branches that leave a curve; points passed before lead to no more."""
        leaving, numbers = list[_Waiting](), dict[str, int]()
        prefix, generations = "" if branch.name == MAIN else f"{branch.name}.", branch.generations
        for k, special in enumerate(curve.special):
            number = numbers[special.kind] = numbers.get(special.kind, 0) + 1
            if special.kind != BRANCH:

                def begin(special: Special = special) -> tuple[Solutions, Curve] | None:
                    first = of.beginning(special)
                    return None if first is None else _started(*first)

                name = f"{prefix}{special.kind} {number}"
                leaving.append(_Waiting(name, begin, generations - 1))
                continue
            there = (one for one in self.junctions if one.is_at(of.family, special))
            if (junction := next(there, None)) is not None:
                junction.passed(branch.name, special)
                curve.special[k] = replace(special, halves=(), label=junction.name)
                continue
            junction = _Junction(f"{BRANCH} {number} of '{branch.name}'", curve, k)
            self.junctions.append(junction)
            for i, letter in enumerate(LETTERS[: len(special.halves)]):
                name = f"{prefix}{number}{letter}"

                def leave(
                    i: int = i, at: _Junction = junction, name: str = name
                ) -> tuple[Solutions, Curve] | None:
                    first = at.leave(i, name)
                    return None if first is None else _started(of, first)

                leaving.append(_Waiting(name, leave, generations - 1))
        return leaving
