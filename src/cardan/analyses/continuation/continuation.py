"""``model.continuation``: every equilibrium that a change of a load leads to.

Where :func:`cardan.analyses.statics.statics.statics` ends at a limit load, this goes on: the load
is an unknown like the position, and turns back.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Count, LockedValues, checked
from ...errors import ModelError, SolveError, SolveWarning, warn
from ...runtime.models.loaded_model import LoadedModel
from ..simulation.progress import Show, showing
from ..statics.equilibrium import WAYS, missed, read
from ..statics.load_path import Loading, loading
from ..statics.settling import settled
from ..statics.static_problem import Point, Problem
from ..statics.statics import sweepable
from ..systems import dynamic_system_of
from ..systems.dynamic_system import DynamicSystem
from .curve import BRANCH, Curve, Special, Test, Watch, trace
from .equilibria import EquilibriumFamily
from .family import length
from .follow import Place, Reach, place
from .quantities import Quantity, quantity
from .record import BranchRecord, ContinuationRecord
from .stability_cache import StabilityCache

POINTS = 300
MAIN = "main"
SAME = 1e-6  # lengths of increments between points that are one
PARALLEL = 0.999  # cosine of directions that are one
LETTERS = "abcdefghijklmnopqrstuvwxyz"


@checked
def continuation(
    model: LoadedModel,
    swept: Mapping[str, object] | None = None,
    *,
    q: Mapping[str, ArrayLike] | ArrayLike | None = None,
    locked: LockedValues | None = None,
    inputs: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    t: float = 0.0,
    until: Mapping[str, float] | None = None,
    bounds: Mapping[str, tuple[float, float]] | None = None,
    events: Mapping[str, float] | None = None,
    branches: int | bool = 0,
    points: Count = POINTS,
    step: float | None = None,
    check: bool = False,
    progress: bool | Callable[[float], None] | None = None,
    **named: object,
) -> ContinuationRecord:
    """All equilibria that a load leads to, through limit loads: ``model.continuation(P=(0, 10))``.

    Args:
        model: The compiled model.
        swept, named: Parameter, input or ``t`` -> (start, end). The path ends at the end, and may
            turn back and leave the range before. Several go together.
        q: Coordinates to start from, by name or (nq,).
        locked: Coordinate -> value it keeps, or (start, end): displacements are prescribed.
        inputs, parameters: Values by name that stay, else those of the model.
        t: Time [s], where something is prescribed.
        until: Name -> value at which the path ends as well: of a coordinate, an output, what is
            swept, or ``<coordinate>.holding_force``.
        bounds: Name -> (low, high): the path ends where it leaves that range.
        events: Name -> value: where it is passed is noted.
        branches: How many generations of branches to follow from branch points; True for all.
        points: Points of a branch at most.
        step: Longest step, as a part of the size of the system, of a radian and of the range.
        check: Raise where the path ends in between, instead of warning.
        progress: Show a bar; by default where standard error is a terminal. Or a function of the
            part of ``points`` that is done.

    Returns:
        The path and its branches, with folds, branch points, Hopf points and events in ``points``;
        what was found before Ctrl-C too.

    Raises:
        ModelError: unknown names, nothing swept. ArgumentError: values of a wrong shape.
        SolveError: no equilibrium at the start; with ``check``, a path that ends in between.

    Source: H. B. Keller, Applications of Bifurcation Theory (1977), 359-384; M. Géradin, A.
    Cardona, Flexible Multibody Dynamics (2001), chapter 9.
    """
    if not isinstance(locked, Mapping | None) or not isinstance(swept, Mapping | None):
        raise ModelError("continuation: locked= and what is swept go by name, such as P=(0, 10)")
    moved = {n: v for n, v in (locked or {}).items() if np.ndim(v) > 0}
    still = {n: v for n, v in (locked or {}).items() if n not in moved}
    system = dynamic_system_of(model)
    base = read(system, still, inputs, parameters, t)
    way = loading(system, sweepable(model), base, {**(swept or {}), **named}, moved, "continuation")
    start = _start(system, way, q)
    family = EquilibriumFamily.of(Problem(system), way, start)
    longest = {} if step is None else {"longest": step, "first": min(step, Reach().first)}
    run = _Run(
        model, family, StabilityCache(family.problem), _tests(model, family, until, bounds, events),
        points, Reach(**longest),
    )  # fmt: skip
    begin = place(family, family.start(start), family.along_parameter)
    depth = 99 if branches is True else int(branches)
    with showing(progress, f"continuation of '{model.name}'") as show:
        record = run.all_of(begin, depth, show)
    ended = record.branches[MAIN]
    if ended.status not in ("finished", "closed"):
        if check:
            raise SolveError(ended.message)
        warn(ended.message, SolveWarning)
    return record


def _start(system: DynamicSystem, way: Loading, q: object) -> Point:
    """The equilibrium at the start of the loads.

    Raises:
        ModelError: more than the ends of a range. SolveError: there is no equilibrium.
    """
    if way.stations is not None:
        raise ModelError("continuation: give (start, end) of what is swept, and no values within")
    problem, load = Problem(system), way.at(0.0)
    start = settled(problem, problem.begin(load, q), load, WAYS)
    if not start.converged:
        raise SolveError(f"continuation, at the start: {missed(system, start, load)}")
    return start.point


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

    def is_at(self, family: EquilibriumFamily, special: Special) -> bool:
        """True when a point of a curve is this one."""
        return length(family, family.step(self.special.place.point, special.place.point)) < SAME

    def passed(self, family: EquilibriumFamily, special: Special) -> None:
        """Note that a curve passes here: what it comes and leaves along is followed."""
        for k, half in enumerate(self.special.halves):
            along = float(half.tangent @ (family.weights * special.place.tangent))
            if abs(along) > PARALLEL:
                self.followed.add(k)


@dataclass(eq=False)
class _Run:
    """Branches as they are followed.

    Attributes:
        model, family: Of what.
        stabilities: Stability at places.
        tests: Ends and events.
        points: Of a branch at most.
        reach: Controls of steps.
        branches: Branches by name.
        junctions: Branch points that they pass.
    """

    model: LoadedModel
    family: EquilibriumFamily
    stabilities: StabilityCache
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
                first = place(self.family, half.point, half.direction)
                curve = self._traced(name, first, show)
                waiting += [(*one, generations - 1) for one in self._leaving(name, curve)]
        except KeyboardInterrupt:
            if not self.branches:
                raise
        return ContinuationRecord(self.model, self.family, dict(self.branches))

    def _traced(self, name: str, first: Place, show: Show) -> Curve:
        """The curve through a place."""
        curve = Curve(self.family, [first])
        watch = Watch(self.stabilities.count, self.stabilities.growth, self.tests, self.points)

        def on_step(curve: Curve) -> None:
            show(len(curve.places) / self.points)

        try:
            trace(curve, watch, self.reach, on_step)
        except KeyboardInterrupt:
            curve.status, curve.ended = "interrupted", "interrupted; what was computed is kept"
            raise
        finally:
            self.branches[name] = BranchRecord.of(name, self.model, curve, self.stabilities)
        return curve

    def _leaving(self, name: str, curve: Curve) -> list[tuple[str, _Junction, int]]:
        """Names of branches that leave a curve, and where; points passed before lead to no more."""
        leaving = list[tuple[str, _Junction, int]]()
        prefix, number = "" if name == MAIN else f"{name}.", 0
        for k, special in enumerate(curve.special):
            if special.kind != BRANCH:
                continue
            number += 1
            there = (one for one in self.junctions if one.is_at(self.family, special))
            if (junction := next(there, None)) is not None:
                junction.passed(self.family, special)
                curve.special[k] = replace(special, halves=(), label=junction.name)
                continue
            junction = _Junction(f"branch point {number} of '{name}'", special)
            self.junctions.append(junction)
            letters = LETTERS[: len(special.halves)]
            leaving += [(f"{prefix}{number}{x}", junction, i) for i, x in enumerate(letters)]
        return leaving


def _tests(
    model: LoadedModel,
    family: EquilibriumFamily,
    until: Mapping[str, float] | None,
    bounds: Mapping[str, tuple[float, float]] | None,
    events: Mapping[str, float] | None,
) -> list[Test]:
    """Ends of a path and events on it."""
    way: Loading = family.way

    def test(name: str, value: float, ends: bool) -> Test:
        of: Quantity = quantity(model, family, name)
        return Test(f"{name} = {value:.10g}", lambda at: of(at.point) - value, ends)

    end = ", ".join(f"{name} = {value:.10g}" for name, value in way.values(1.0).items())
    tests = [Test(end, lambda at: at.point.s - 1.0, ends=True)]
    tests += [test(name, float(value), True) for name, value in (until or {}).items()]
    for name, limits in (bounds or {}).items():
        tests += [test(name, float(value), True) for value in limits]
    return tests + [test(name, float(value), False) for name, value in (events or {}).items()]
