"""Derivatives of laps by sweeps over their steps, through their events.

Increments of a start become those of a state on constraints and section, then changes of that state
as it is stored, which :class:`.Tangents` takes to the end of the run. Where time ends it, the end
moves along with the period; where an event does, along with that event. From there the way goes
back to increments, and through the symmetry to the start of the next lap.

Source: R. Seydel, Practical Bifurcation and Stability Analysis (2010), section 7.3 (variational
equations); P. C. Müller, Chaos, Solitons & Fractals 5 (1995), 1671-1681 (events).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TypeAlias

import numpy as np

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from ..gradients.jumps import EventInstant, event_instants
from ..gradients.steps import TABLES
from ..gradients.tangent import Directions, Tangents, directions_of
from ..gradients.tangent_jumps import TangentJumps
from ..simulation import run_record as abi
from ..simulation.discontinuities import jump_parameters
from ..systems.central_differences import by_differences
from .cycle_problem import CycleProblem, CycleState, Values
from .flow import Course

Sweep: TypeAlias = Callable[[float], Values]  # values behind a part of their range
WIDE = 0.3  # of the steps of differences: of what takes no run
COARSER = 1  # steps beside within one, up to which it is short enough
NEIGHBOR = 1e-3  # increments to the motion beside, whose steps tell what changes need


@dataclass(frozen=True, eq=False)
class LapDerivative:
    """A lap and its derivatives, of increments in units of the motion.

    Attributes:
        begun: Its start on the constraints and on the section.
        end: The start of the next one.
        onto: Of ``begun`` by the start (n, n).
        begun_by_value: Of ``begun`` by the place of what is swept (n,).
        by_start: Of ``end`` by the start (n, n).
        by_value: Of ``end`` by the place of what is swept (n,).
        by_period: Of ``end`` by an unknown period (n,), as a part of it.
    """

    begun: CycleState
    end: CycleState
    onto: Array
    begun_by_value: Array
    by_start: Array
    by_value: Array
    by_period: Array


def refusal(problem: CycleProblem) -> str:
    """Why laps have no derivative but by differences; "" if they have."""
    method, inputs = problem.how.method, problem.flow({}).runner.signals
    if method.kernel not in TABLES:
        return f"there is no sweep through steps of {method.name}"
    if inputs.functions:
        names = [problem.model.inputs[k] for k in inputs.functions]
        return f"input '{names[0]}' is a function, whose derivative is not known"
    if moving := jump_parameters(problem.model):
        return f"parameter '{moving[0]}' decides when the model jumps"
    if problem.flow({}).runner.interpreted:
        return "there is no C compiler"
    return ""


def lap_derivative(
    problem: CycleProblem, at: CycleState, values: Sweep | None = None
) -> LapDerivative:
    """The derivative of all laps from a start.

    Args:
        problem: What repeats.
        at: The start.
        values: What is swept, by the increment of its place; None where nothing is.

    Raises:
        SolveError: a lap breaks down, or has no derivative.
    """
    run, n = _Run(problem, at, values), len(problem.units)
    begun = problem.closed(replace(at, x=problem.on_section(at)))
    first = run.begun(_of_section(problem, at, values, run.columns), begun)
    changes, now, spent = first, begun, 0.0
    for _ in range(problem.laps):
        changes, now = run.through(changes, now)
        spent += now.period
    none, swept = np.zeros(n), values is not None
    return LapDerivative(
        begun,
        replace(now, period=spent),
        first[:, :n],
        first[:, n] if swept else none,
        changes[:, :n],
        changes[:, n] if swept else none,
        changes[:, -1] if problem.free_period else none,
    )


def _of_section(problem: CycleProblem, at: CycleState, values: Sweep | None, columns: int) -> Array:
    """Derivative (n, columns) of the state on the section that a start is moved to.

    No run is in it: its derivatives are those of a plane, whose slope differences give.
    """
    n = len(problem.units)
    # starts move as they are told, and what is swept moves none by itself
    result = np.eye(n, columns)
    if problem.normal is None:
        return result
    at = replace(at, x=problem.on_section(at))

    def value(dx: Array) -> Array:
        return np.array([problem.value(replace(at, x=problem.moved(at.x, dx)))])

    slope = by_differences(value, np.full(n, WIDE))[0]
    normal = problem.normal / float(slope @ problem.normal)
    result[:, :n] -= np.outer(normal, slope)
    if values is not None:
        there = values

        def by_value(ds: Array) -> Array:
            return np.array([problem.value(replace(at, values=there(float(ds[0]))))])

        result[:, n] = -normal * by_differences(by_value, np.full(1, WIDE))[0, 0]
    return result


class _Run:
    """Changes along the runs of laps: of the start, of what is swept, of the period."""

    def __init__(self, problem: CycleProblem, at: CycleState, values: Sweep | None) -> None:
        self.problem, self.at, self.flow = problem, at, problem.flow(at.values)
        self.columns = len(problem.units) + (values is not None) + problem.free_period
        model = self.model = self.flow.model
        runner = self.flow.runner
        self.tangents = Tangents(runner, self._directions(values, self.columns), model)
        self.jumps = TangentJumps(self.tangents, self.flow.event_table, problem.t)
        self.period_slope = 0.0
        if values is not None and problem.period is not None:
            there = values

            def period(ds: Array) -> Array:
                return np.array([problem.period_of(replace(at, values=there(float(ds[0]))))])

            self.period_slope = float(by_differences(period, np.full(1, WIDE))[0, 0])
        self.times = np.zeros(0)

    def _directions(self, values: Sweep | None, count: int) -> Directions:
        """Directions of everything that changes: what is swept is one of them."""
        model = self.model
        # tables of inputs are none of those that are swept
        segments = sum(len(one.coefficients) for one in self.flow.runner.signals.tabulated)
        directions, n = directions_of(model, segments, count), len(self.problem.units)
        if values is not None:
            names = list(model.parameters)
            ends = values(0.5), values(-0.5)
            for name, value in ends[0].items():
                slope = value - ends[1][name]
                if name in names:
                    directions.p[n, names.index(name)] = slope
                elif name in model.inputs:
                    directions.r[n, model.inputs.index(name)] = slope
        return directions

    def begun(self, changes: Array, at: CycleState) -> Array:
        """Increments (n, k) on the constraints, from those of a start that is moved onto them."""
        if not self.problem.constrained:
            return changes
        tangents, model, t = self.tangents, self.model, self.problem.t
        nq, nu, x = model.nq, model.nu, self._stored(changes, at)
        q, u, z = model.parts_of(at.x)
        values: dict[str, object] = {"t": t, "q": q, "u": u, "z": z, "s": at.s}
        values["r"] = self.flow.inputs(t)
        none, by_r = np.zeros(len(x)), tangents.input_changes(t)
        places = {"close_position": slice(0, nq), "close_velocity": slice(nq, nq + nu)}
        for function, place in places.items():
            if function in self.flow.runner.closing.functions:
                moved = tangents.along(function, values, none, x, tangents.by_s, by_r)
                x[:, place] = moved[:, : place.stop - place.start]
        return self._increments(x, at, t)

    def through(self, changes: Array, at: CycleState) -> tuple[Array, CycleState]:
        """Increments (n, k) at the start of the next lap, from those at the start of one.

        Raises:
            SolveError: the lap breaks down, or has no derivative.
        """
        problem, flow = self.problem, self.flow
        t, length = problem.t, problem.lap_length(self.at)
        course = flow.course(at.x, at.s, t, t + length, problem.lap_match())
        if course is None:
            raise SolveError("cycle: a lap does not come to its section")
        run = flow.runner.record
        if run.pass_count > run.pass_capacity:
            raise SolveError("cycle: a lap passes more places where branches meet than are noted")
        # time and section move along with changes only behind the run
        first = self._stored(changes, at)
        took = length if problem.section is None else course.t - t
        after = replace(at, x=course.x, s=course.s, period=took)
        self.times = self._perturbed_times(at, course.t)
        if problem.section is None:
            stored = self._swept(course, first)
            self._delay(stored, course)
        else:
            stored = self._to_section(course, first)
        increments = self._increments(stored, after, course.t)
        image = problem.mapped(after.x)
        if problem.symmetry is not None:
            increments = self._mirror(after.x, image) @ increments
        return increments, replace(after, x=image)

    def _delay(self, stored: Array, course: Course) -> None:
        """Add what the end of a lap changes by, as its period does."""
        n, problem = len(self.problem.units), self.problem
        inputs = self.tangents.inputs_at(course.t)[0]
        rate = np.asarray(self.model.rhs(course.t, course.x, inputs, s=course.s))
        if problem.free_period:
            # an unknown period is that of all laps, and counts as a part of itself
            stored[-1] += rate * (course.t - problem.t)
        elif self.period_slope:
            stored[n] += rate * self.period_slope

    def _swept(self, course: Course, first: Array, end: float = np.inf) -> Array:
        """Changes (k, nx) at the last row, from those at the first one, through events before."""
        rows, log, start, model = course.rows, course.log, 0, self.model
        log = log[log[:, 0] < end]
        for at in event_instants(log, self.flow.event_table, model.nx, model.ns):
            before = int(np.searchsorted(rows[:, 0], at.t, side="left"))
            behind = int(np.searchsorted(rows[:, 0], at.t, side="right")) - 1
            if not start <= before <= behind:
                raise SolveError(f"cycle: no step ends at the event at t = {at.t:.6g} s")
            first = self._over(rows[start : before + 1], first)
            first, start = self.jumps.push(at, first), behind
        return self._over(rows[start:], first)

    def _perturbed_times(self, at: CycleState, end: float) -> Array:
        """Times at which the steps of a motion beside that from a start end.

        Where a part of the motion is at rest, its steps do not measure changes of that part.
        """
        problem = self.problem
        if not problem.how.method.adaptive:
            return np.zeros(0)
        aside = NEIGHBOR * np.cos(1.0 + np.arange(len(problem.units)))
        x = problem.moved(at.x, aside)
        course = self.flow.course(x, at.s, problem.t, end, None)
        return np.zeros(0) if course is None else np.unique(course.rows[:, 0])

    def _over(self, rows: Array, first: Array) -> Array:
        """Changes at the last row, from those at the first one, by steps that are short enough."""
        parts = np.diff(np.searchsorted(self.times, rows[:, 0])) - 1
        start = 0
        for k in map(int, np.flatnonzero(parts > COARSER)):
            first = self.tangents.over(rows[start : k + 1], first)[-1]
            first, start = self._in_parts(rows[k : k + 2], first), k + 1
        return np.asarray(self.tangents.over(rows[start:], first)[-1])

    def _in_parts(self, rows: Array, first: Array) -> Array:
        """Changes at the end of a step, which is taken in several parts."""
        tangents, step, nx = self.tangents, rows.copy(), self.model.nx
        inside = (self.times > rows[0, 0]) & (self.times < rows[1, 0])
        for time in self.times[inside]:
            step[1, 0] = time
            first = tangents.over(step, first)[-1]
            step[0, 0], step[0, 1 : 1 + nx] = time, tangents.rooms["end"]
        step[1] = rows[1]
        return np.asarray(tangents.over(step, first)[-1])

    def _to_section(self, course: Course, first: Array) -> Array:
        """The same behind the event that ends a lap, whenever it is."""
        passage, section, model = course.passage, self.problem.section, self.model
        assert passage is not None
        assert section is not None
        rows = course.rows[course.rows[:, 0] < passage.t]
        # the run went on: its last step here ends at the event instead
        last = rows[-1].copy()
        last[0], last[1 : 1 + model.nx] = passage.t, passage.x
        before = self._swept(replace(course, rows=np.vstack([rows, last])), first, passage.t)
        table, nx = self.flow.event_table, model.nx
        # marks count if they are what the lap ends at
        log, start = course.log[course.log[:, 0] == passage.t], 1 + len(table.rows)
        counted = np.array([kind != abi.MARK for kind in table.kinds])
        counted[list(section.numbers)] = True
        fired = (log[:, 1:start] != 0) & counted
        log, fired = log[fired.any(axis=1)], fired[fired.any(axis=1)]
        x, s = log[:, start : start + nx], log[:, start + nx : start + nx + model.ns]
        at = EventInstant(passage.t, fired, x, s, passage.x_after, passage.s_after)
        return self.jumps.arrive(at, before)[0]

    # increments and states

    def _kinematic(self, at: CycleState, t: float) -> Array | None:
        """N (nq, nu): how coordinates change with increments; None where they are these."""
        system = self.problem.system
        if system.increments == system.coordinates:
            return None
        moment = self.problem.moment(replace(at, values=self.at.values))
        return system.kinematic_matrix(replace(moment, t=t))

    def _stored(self, changes: Array, at: CycleState) -> Array:
        """Changes of a state (k, nx) along increments (n, k)."""
        steps, nu = changes * self.problem.units[:, None], self.model.nu
        N = self._kinematic(at, self.problem.t)
        return np.vstack([steps[:nu] if N is None else N @ steps[:nu], steps[nu:]]).T

    def _increments(self, stored: Array, at: CycleState, t: float) -> Array:
        """Increments (n, k) of changes of a state (k, nx)."""
        nq, N = self.model.nq, self._kinematic(at, t)
        places = stored[:, :nq].T
        if N is not None:
            places = np.asarray(np.linalg.lstsq(N, places)[0], dtype=np.float64)
        return np.vstack([places, stored[:, nq:].T]) / self.problem.units[:, None]

    def _mirror(self, x: Array, image: Array) -> Array:
        """Derivative of the symmetry (n, n)."""
        problem = self.problem

        def mapped(dx: Array) -> Array:
            return problem.step(image, problem.mapped(problem.moved(x, dx)))

        return by_differences(mapped, np.full(len(problem.units), WIDE))
