"""Cycles as a parameter changes: a family whose curves are followed."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping
from dataclasses import field, replace
from typing import final

import numpy as np

from ...arrays import Array
from ...errors import ModelError, SolveError
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ..continuation.family import DenseJacobian, Jacobian
from ..continuation.solutions import PathRequest
from ..statics.equilibrium import read
from ..statics.load_path import Loading, loading
from ..statics.statics import sweepable
from ..systems import dynamic_system_of
from .cycle_problem import CycleProblem, CycleState
from .energy_level import ENERGY
from .multipliers import Complexes, monodromy, multipliers_of
from .shooting import Phase, Shooting

CACHED = 12  # derivatives, each of many runs
MOTIONLESS = 1e-9  # of units: a motion that is none
NODE = 6  # increments: lengths do not grow with the system
ON_WAY = 1e-6  # of a range: values that lie on it


@dataclass(frozen=True, eq=False)
class CyclePoint:
    """A cycle on a path.

    Attributes:
        s: Place of what is swept: 0 and 1 at the ends of its range.
        at: The start of a lap.
    """

    s: float
    at: CycleState


@final
@dataclass(frozen=True, eq=False)
class CycleFamily:
    """Cycles of a model as parameters or inputs are swept.

    Increments are those of the state at the start of a lap in units of the motion, of a free
    period as a part of it, and of the place of what is swept.

    Attributes:
        shooting: Equations of a cycle.
        way: What is swept.
        weights: See :class:`.Family`.
    """

    shooting: Shooting
    way: Loading
    weights: Array
    _jacobians: OrderedDict[int, tuple[CyclePoint, Array]] = field(default_factory=OrderedDict)
    _multipliers: dict[int, tuple[CyclePoint, Complexes]] = field(default_factory=dict)

    @classmethod
    def of(cls, problem: CycleProblem, way: Loading, phase: Phase | None) -> CycleFamily:
        """The family of a problem."""
        n = len(problem.units)
        weights = np.concatenate([np.full(n, 1.0 / max(1.0, n / NODE)), np.ones(1)])
        if problem.free_period:
            weights = np.append(weights, 1.0)
        return cls(Shooting(problem, phase), way, weights)

    @property
    def problem(self) -> CycleProblem:
        """What repeats."""
        return self.shooting.problem

    def point(self, at: CycleState, s: float) -> CyclePoint:
        """A start of a lap at a place of what is swept."""
        return CyclePoint(s, replace(at, values=self.way.values(s)))

    def parameter(self, point: CyclePoint) -> float:
        """Same as :meth:`.Family.parameter`."""
        return point.s

    def residual(self, point: CyclePoint) -> Array:
        """Same as :meth:`.Family.residual`.

        Raises:
            SolveError: as there; the point is at rest, which repeats with any period.
        """
        self._refuse_motionless(point.at)
        return self.shooting.residual(point.at)

    def _refuse_motionless(self, at: CycleState) -> None:
        """Refuse what repeats with any period.

        Raises:
            SolveError: it is at rest.
        """
        problem = self.problem
        if problem.free_period and at.period * np.linalg.norm(problem.rate(at)) < MOTIONLESS:
            raise SolveError("cycle: the motion shrinks to rest")

    def moved(self, point: CyclePoint, dz: Array) -> CyclePoint:
        """Same as :meth:`.Family.moved`."""
        return self.point(self.shooting.moved(point.at, dz[:-1]), point.s + float(dz[-1]))

    def with_internal_unknowns(self, point: CyclePoint) -> CyclePoint:
        """Same as :meth:`.Family.with_internal_unknowns`: there are none."""
        return point

    def without_internal_unknowns(self, point: CyclePoint) -> CyclePoint:
        """Same as :meth:`.Family.without_internal_unknowns`."""
        return point

    def step(self, before: CyclePoint, after: CyclePoint) -> Array:
        """Same as :meth:`.Family.step`."""
        step = self.problem.step(before.at.x, after.at.x)
        if self.problem.free_period:
            step = np.append(step, after.at.period / before.at.period - 1)
        return np.append(step, after.s - before.s)

    def jacobian(self, point: CyclePoint, rough: bool | Jacobian = False) -> Jacobian:
        """Same as :meth:`.Family.jacobian`; rough of second order, by half of the laps."""
        if not rough or id(point) in self._jacobians:
            return DenseJacobian(self._matrix(point))
        return DenseJacobian(self._derivative(point, rough=True))

    def _derivative(self, point: CyclePoint, rough: bool) -> Array:
        # a sweep finds derivatives at rest too, where a correction may have led
        self._refuse_motionless(point.at)
        return self.shooting.derivative(
            point.at,
            lambda dz: self.residual(self.moved(point, dz)),
            len(self.weights),
            rough,
            lambda ds: self.way.values(point.s + ds),
        )

    def _matrix(self, point: CyclePoint) -> Array:
        if id(point) not in self._jacobians:
            matrix = self._derivative(point, rough=False)
            if not np.isfinite(matrix).all():
                raise SolveError("cycle: derivatives of a lap are not finite")
            while len(self._jacobians) >= CACHED:
                self._jacobians.popitem(last=False)
            self._jacobians[id(point)] = point, matrix
        return self._jacobians[id(point)][1]

    def monodromy(self, point: CyclePoint) -> Array:
        """Derivative of a lap across the flow (n, n), less of a free period."""
        n, at = len(self.problem.units), point.at
        along = self.problem.rate(at) if self.problem.free_period else None
        gradient = None if self.problem.level is None else self.problem.uphill(at)
        return monodromy(self._matrix(point)[:n, :n] + np.eye(n), along, gradient)

    def multipliers(self, point: CyclePoint) -> Complexes:
        """Multipliers of a cycle (m,)."""
        if id(point) not in self._multipliers:
            values = multipliers_of(self.monodromy(point), self.problem.lost(point.at))
            self._multipliers[id(point)] = point, values
        return self._multipliers[id(point)][1]

    def finished(self, point: CyclePoint) -> CycleState:
        """The start of a lap, on the section, with the period that the lap takes."""
        problem, at = self.problem, point.at
        period = at.period if problem.free_period else problem.lap(at).period
        return replace(at, x=problem.on_section(at), period=period)


def problem_and_way(
    problem: CycleProblem, model: LoadedModel, request: PathRequest
) -> tuple[CycleProblem, Loading]:
    """The problem with what stays, and what is swept.

    Raises:
        ModelError: an unknown name, values between the ends, an energy that is not told.
    """
    model = model.with_parameters(dict(request.parameters)) if request.parameters else model
    system = dynamic_system_of(model)
    kinds = {name: kind for name, kind in sweepable(model).items() if kind != "t"}
    level = problem.level
    if level is not None:
        kinds[ENERGY] = ENERGY
    elif ENERGY in request.swept and ENERGY not in kinds:
        raise ModelError(
            "continuation of cycles: energy= is swept from a mode, start=model.modes()[0], or from "
            "a cycle of such a path"
        )
    base = read(system, {}, None, None, problem.t)
    way = loading(system, kinds, base, request.swept, {}, "continuation")
    if way.stations is not None:
        raise ModelError("continuation: give (start, end) of what is swept, and no values within")
    if level is not None:
        size = float(np.ptp(way.swept[ENERGY])) if ENERGY in way.swept else level.size
        # the work of forces is another one with other parameters
        level = replace(level, size=size, _works={})
    inputs = {**problem.inputs, **(request.inputs or {})}
    problem = replace(problem, model=model, system=system, inputs=inputs, level=level, _flows={})
    return problem, way


def place_of(way: Loading, values: Mapping[str, float]) -> float:
    """The place of swept values on a way.

    Raises:
        ModelError: something else is swept, or it does not pass these values together.
    """
    (name, ends), *_ = way.swept.items()
    s = float((values.get(name, np.nan) - ends[0]) / (ends[-1] - ends[0]))
    for swept, value in way.values(s).items():
        if not abs(value - values.get(swept, np.nan)) <= ON_WAY * np.ptp(way.swept[swept]):
            where = ", ".join(f"{name} = {value:.6g}" for name, value in values.items())
            raise ModelError(
                f"continuation of cycles: start= is at {where}: sweep that, through it"
            )
    return s
