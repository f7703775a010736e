"""A path and the branches that leave its branch points, each followed once."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from ..simulation.progress import Show
from .curve import Curve, trace
from .family import Family, length
from .follow import Place, Reach, place
from .record import BranchRecord, ContinuationRecord
from .solutions import Solutions
from .special_points import BRANCH, Special, Test, Watch

MAIN = "main"
SAME = 1e-6  # lengths of increments between points that are one
PARALLEL = 0.999  # cosine of directions that are one
LETTERS = "abcdefghijklmnopqrstuvwxyz"


@dataclass(eq=False)
class _Junction:
    """A branch point, and which of the branches that leave it were followed.

    Attributes:
        name: ``"branch point 1 of 'main'"``.
        special: The point.
        followed: Numbers of the branches.
    """

    name: str
    special: Special
    followed: set[int] = field(default_factory=set)

    def is_at(self, family: Family, special: Special) -> bool:
        """True when a point of a curve is this one."""
        return length(family, family.step(self.special.place.point, special.place.point)) < SAME

    def passed(self, family: Family, special: Special) -> None:
        """Note that a curve passes here: what it comes and leaves along is followed."""
        for k, half in enumerate(self.special.halves):
            along = float(half.tangent @ (family.weights * special.place.tangent))
            if abs(along) > PARALLEL:
                self.followed.add(k)


@dataclass(eq=False)
class Tracer:
    """Branches as they are followed.

    Attributes:
        solutions: Of what.
        tests: Ends and events.
        points: Of a branch at most.
        reach: Controls of steps.
        branches: Branches by name.
        junctions: Branch points that they pass.
    """

    solutions: Solutions
    tests: list[Test]
    points: int
    reach: Reach
    branches: dict[str, BranchRecord] = field(default_factory=dict)
    junctions: list[_Junction] = field(default_factory=list)

    def all_of(self, begin: Place, depth: int, show: Show) -> ContinuationRecord:
        """The curve through a place, and the branches that leave it, each once."""
        waiting = list[tuple[str, _Junction, int, int]]()
        try:
            curve = self._traced(MAIN, begin, show)
            waiting += [(*one, depth) for one in self._leaving(MAIN, curve)]
            while waiting:
                name, junction, k, generations = waiting.pop(0)
                if generations < 1 or k in junction.followed:
                    continue
                junction.followed.add(k)
                half = junction.special.halves[k]
                first = place(self.solutions.family, half.point, half.direction)
                curve = self._traced(name, first, show)
                waiting += [(*one, generations - 1) for one in self._leaving(name, curve)]
        except KeyboardInterrupt:
            if not self.branches:
                raise
        return ContinuationRecord(self.solutions.model, dict(self.branches))

    def _traced(self, name: str, first: Place, show: Show) -> Curve:
        """The curve through a place."""
        of = self.solutions
        curve = Curve(of.family, [first])
        watch = Watch(of.count, of.growth, of.oscillation, of.onsets, self.tests, self.points)

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

    def _leaving(self, name: str, curve: Curve) -> list[tuple[str, _Junction, int]]:
        """Names of branches that leave a curve, and where; points passed before lead to no more."""
        leaving = list[tuple[str, _Junction, int]]()
        prefix, number = "" if name == MAIN else f"{name}.", 0
        for k, special in enumerate(curve.special):
            if special.kind != BRANCH:
                continue
            number += 1
            there = (one for one in self.junctions if one.is_at(self.solutions.family, special))
            if (junction := next(there, None)) is not None:
                junction.passed(self.solutions.family, special)
                curve.special[k] = replace(special, halves=(), label=junction.name)
                continue
            junction = _Junction(f"branch point {number} of '{name}'", special)
            self.junctions.append(junction)
            letters = LETTERS[: len(special.halves)]
            leaving += [(f"{prefix}{number}{x}", junction, i) for i, x in enumerate(letters)]
        return leaving
