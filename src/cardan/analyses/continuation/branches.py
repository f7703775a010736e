"""A path and the branches that leave its branch points, each followed once."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace

from ..simulation.progress import Show
from .curve import Curve
from .deflation import new_solutions
from .family import Family, Point, length
from .follow import Place, Reach, ahead, place
from .record import BranchRecord, ContinuationRecord
from .solutions import Solutions
from .special_points import BRANCH, Special, Test, Watch
from .tracing import trace

MAIN, OTHER = "main", "other"
SAME = 1e-6  # lengths of increments between points that are one
PARALLEL = 0.999  # cosine of directions that are one
SEARCHES = 60  # for a solution to which no branch leads
LETTERS = "abcdefghijklmnopqrstuvwxyz"


@dataclass(eq=False)
class _Junction:
    """A branch point, and which of the branches that leave it were followed.

    Attributes:
        name: ``"branch point 1 of 'main'"``.
        special: The point.
        family: Whose.
        followed: Numbers of the branches.
    """

    name: str
    special: Special
    family: Family
    followed: set[int] = field(default_factory=set)

    def is_at(self, family: Family, special: Special) -> bool:
        """True when a point of a curve is this one."""
        if family is not self.family:
            return False
        return length(family, family.step(self.special.place.point, special.place.point)) < SAME

    def passed(self, family: Family, special: Special) -> None:
        """Note that a curve passes here: what it comes and leaves along is followed."""
        for k, half in enumerate(self.special.halves):
            along = float(half.tangent @ (family.weights * special.place.tangent))
            if abs(along) > PARALLEL:
                self.followed.add(k)

    def leave(self, k: int) -> Place | None:
        """The first place of a branch; None where it was followed."""
        if k in self.followed:
            return None
        self.followed.add(k)
        half = self.special.halves[k]
        return place(self.family, half.point, half.direction)


@dataclass(frozen=True, eq=False)
class _Waiting:
    """A branch that was not followed yet.

    Attributes:
        name: Its name.
        first: The solutions that it consists of, and its first place; None where it was followed.
        generations: How many may follow, with it.
    """

    name: str
    first: Callable[[], tuple[Solutions, Place] | None]
    generations: int


def _started(solutions: Solutions, first: Place) -> Callable[[], tuple[Solutions, Place]]:
    """A branch that starts at a place, whatever was followed."""
    return lambda: (solutions, first)


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

    def all_of(
        self, solutions: Solutions, begin: Place, depth: int, show: Show
    ) -> ContinuationRecord:
        """The curve through a place, and the branches that leave it, each once."""
        try:
            self._follow(_Waiting(MAIN, lambda: (solutions, begin), depth + 1), show)
            for k in range(self.search):
                value = (k + 1) / self.search
                for number, point in enumerate(self._disconnected(solutions, begin, value), 1):
                    for letter, sign in (("a", -1.0), ("b", 1.0))[: 1 if value == 1.0 else 2]:
                        toward = sign * ahead(solutions.family, point)
                        first = place(solutions.family, point, toward)
                        name = f"{OTHER} {k + 1}.{number}{letter}"
                        start = _Waiting(name, _started(solutions, first), depth + 1)
                        self._follow(start, show)
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
            start = branch.first() if branch.generations > 0 else None
            if start is None:
                continue
            curve = self._traced(branch.name, *start, show)
            waiting += self._leaving(branch, start[0], curve)

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

    def _traced(self, name: str, of: Solutions, first: Place, show: Show) -> Curve:
        """The curve through a place."""
        curve = Curve(of.family, [first])
        tests = self.tests(of)
        if name.startswith(OTHER):
            # what no path leads to from the start of the range ends there
            tests.append(Test("the start", lambda at: of.family.parameter(at.point), ends=True))
        watch = Watch(
            of.count, of.growth, of.oscillation, of.onsets, tests, self.points,
            corner=of.corner, ends=[*self._ends(of)],
        )  # fmt: skip

        def on_step(curve: Curve) -> None:
            show(len(curve.places) / self.points)

        try:
            trace(curve, watch, self.reach, on_step)
        except KeyboardInterrupt:
            curve.status, curve.ended = "interrupted", "interrupted; what was computed is kept"
            raise
        finally:
            self.branches[name] = BranchRecord.of(name, curve, of)
        return curve

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

                def begin(special: Special = special) -> tuple[Solutions, Place] | None:
                    return of.beginning(special)

                name = f"{prefix}{special.kind} {number}"
                leaving.append(_Waiting(name, begin, generations - 1))
                continue
            there = (one for one in self.junctions if one.is_at(of.family, special))
            if (junction := next(there, None)) is not None:
                junction.passed(of.family, special)
                curve.special[k] = replace(special, halves=(), label=junction.name)
                continue
            junction = _Junction(f"branch point {number} of '{branch.name}'", special, of.family)
            self.junctions.append(junction)
            for i, letter in enumerate(LETTERS[: len(special.halves)]):

                def leave(i: int = i, at: _Junction = junction) -> tuple[Solutions, Place] | None:
                    first = at.leave(i)
                    return None if first is None else (of, first)

                leaving.append(_Waiting(f"{prefix}{number}{letter}", leave, generations - 1))
        return leaving
