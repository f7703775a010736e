"""Laps of a model and what is left of a cycle behind them.

A lap leads from a state x behind the section, or at a phase of what forces the motion, to the state
S(flow(x)) at the start of the next lap, S the symmetry. A cycle is x = S(flow(x)). States are moved
by increments (rotations in body axes) in units of the motion. A start is brought onto constraints
and onto the section first; along what that takes away the derivative of a lap is 0.

Source: R. Seydel, Practical Bifurcation and Stability Analysis (2010), chapter 7 (shooting,
monodromy matrix).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field, replace
from functools import cached_property
from typing import TypeAlias

import numpy as np
from scipy.linalg import block_diag, null_space

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ..simulation.events import event_table_of
from ..simulation.settings import Settings
from ..systems.central_differences import by_differences
from ..systems.dynamic_system import DynamicSystem, Moment, dense
from .energy_level import ENERGY, EnergyLevel
from .flow import Flow, Passage
from .named_states import StateMap
from .section import Section

Values: TypeAlias = Mapping[str, float]
PeriodRule: TypeAlias = Callable[[Values], float]
FLOWS = 8  # parameter sets whose runs are kept
RESOLUTION = 1e-9  # of the longest lap: an event so soon is that at which a lap begins
ON_SECTION = 1e-6  # of the change along a unit: a value that is 0
PROJECTIONS, CLOSE = 60, 1e-15
RANK = 1e-9  # rows of constraints that say nothing new
NEARBY = 0.02  # of the steps of differences
SLOPE = 1e-5  # of units: differences of the value at a section


@dataclass(frozen=True, eq=False)
class CycleState:
    """A start of a lap.

    Attributes:
        x, s: State (nx,) and modes (ns,).
        period: Of a lap [s].
        values: Parameters and inputs by name that differ from those of the problem.
    """

    x: Array
    s: Array
    period: float
    values: Values = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class CycleProblem:
    """What repeats.

    Attributes:
        model, system: Whose motion.
        how: Settings of runs.
        inputs: Constants and functions by name.
        t: Time at which a lap begins [s].
        longest: Time within which a lap must end [s].
        section: The event that ends a lap; None of laps that time ends.
        period: Of a lap, by parameters and inputs; None where it is unknown or the section's.
        symmetry: Of states (nx,) behind a lap; None without.
        laps: After how many the motion repeats.
        units: Of increments (n,).
        normal: The increment that moves starts off the section (n,), by 1 of what passes zero
            there; None where they need not lie on it.
        level: The energy that a cycle has to have; None where energy is not kept.
        reasons: Why the last derivative of a lap is one by differences; empty if it is not.
    """

    model: LoadedModel
    system: DynamicSystem
    how: Settings
    inputs: Mapping[str, object]
    t: float
    longest: float
    section: Section | None
    period: PeriodRule | None
    symmetry: StateMap | None
    laps: int
    units: Array
    normal: Array | None = None
    level: EnergyLevel | None = None
    _flows: dict[tuple[tuple[str, float], ...], Flow] = field(default_factory=dict)
    reasons: list[str] = field(default_factory=list)

    @property
    def free_period(self) -> bool:
        """True where the period is an unknown."""
        return self.section is None and self.period is None

    @property
    def constrained(self) -> bool:
        """True where runs begin on constraints, wherever they are begun."""
        return len(self.system.rows) > 0 and self.model.manifest.projected

    def lost(self, at: CycleState) -> int:
        """Number of increments that constraints and the section take away."""
        section = int(self.section is not None)
        if not self.constrained:
            return section
        G = dense(self.system.tangents(self.moment(at)).G)
        ranks = (np.linalg.matrix_rank(rows, RANK) for rows in (G, G[self.system.positions]))
        return section + sum(int(rank) for rank in ranks)

    def allowed(self, at: CycleState) -> tuple[Array, Array] | None:
        """Increments of starts that lead along the constraints; None where all do.

        Returns:
            Those increments (n, d), and the parts of them (d, n) that any increment moves the start
            of a run by.
        """
        if not self.constrained or self.normal is not None:
            return None
        nu, n = self.model.nu, len(self.units)
        G = dense(self.system.tangents(self.moment(at)).G) / self.system.rows[:, None]
        places = null_space(G[self.system.positions] * self.units[:nu], RANK)
        speeds = null_space(G * self.units[nu : 2 * nu], RANK)
        ways = block_diag(places, speeds, np.eye(n - 2 * nu))
        flow = self.flow(at.values)

        def begun(dx: Array) -> Array:
            return self.step(at.x, flow.closed(self.moved(at.x, dx), at.s, self.t))

        onto = by_differences(begun, np.full(n, NEARBY))
        return ways, np.linalg.lstsq(onto @ ways, onto)[0]

    def moment(self, at: CycleState) -> Moment:
        """The start of a lap, without accelerations and multipliers."""
        q, u, z = self.model.parts_of(at.x)
        names = self.model.parameters
        parameters = {name: value for name, value in at.values.items() if name in names}
        r, lam = self.flow(at.values).inputs(self.t), np.zeros(len(self.system.rows))
        return Moment(self.t, q, u, 0 * u, lam, r, z, at.s, parameters or None)

    def flow(self, values: Values) -> Flow:
        """Runs with parameters and inputs."""
        if () not in self._flows:
            section = self.section
            table = section.event_table if section else event_table_of(self.model, None)
            self._flows[()] = Flow(self.model, self.how, self.inputs, table)
        key = tuple(sorted((n, v) for n, v in values.items() if not self._is_energy(n)))
        if key not in self._flows:
            while len(self._flows) >= FLOWS:
                # the first one is that of the problem itself
                del self._flows[[*self._flows][1]]
            self._flows[key] = self._flows[()].changed(dict(key))
        return self._flows[key]

    def _is_energy(self, name: str) -> bool:
        return self.level is not None and name == ENERGY

    @cached_property
    def _ends(self) -> tuple[int, int]:
        """Ends of q and u in a state."""
        return self.model.nq, self.model.nq + self.model.nu

    def _parts_of(self, x: Array) -> tuple[Array, Array, Array]:
        """q, u and z of a state, unchecked."""
        nq, end = self._ends
        return x[:nq], x[nq:end], x[end:]

    # increments

    def moved(self, x: Array, dx: Array) -> Array:
        """The state (nx,) an increment (n,) away."""
        q, u, z = self._parts_of(x)
        step, nu = dx * self.units, len(u)
        place = self.system.integrate(q, step[:nu]) if step[:nu].any() else q
        return np.concatenate([place, u + step[nu : 2 * nu], z + step[2 * nu :]])

    def step(self, before: Array, after: Array) -> Array:
        """The increment (n,) from one state to another."""
        q0, u0, z0 = self._parts_of(before)
        q, u, z = self._parts_of(after)
        step = np.concatenate([self.system.difference(q0, q), u - u0, z - z0])
        return np.asarray(step / self.units)

    def closed(self, at: CycleState) -> CycleState:
        """The start moved onto the constraints, as runs begin there."""
        if not self.constrained:
            return at
        return replace(at, x=self.flow(at.values).closed(at.x, at.s, self.t))

    # laps

    def period_of(self, at: CycleState) -> float:
        """The period of a lap that is prescribed, or that of the state."""
        if self.period is None:
            return at.period
        inputs = {n: float(v) for n, v in self.inputs.items() if isinstance(v, int | float)}
        return float(self.period({**self.model.parameters, **inputs, **at.values}))

    def lap(self, at: CycleState) -> CycleState:
        """The start behind all laps, at the time that they took.

        Raises:
            SolveError: a run breaks down, or does not come to the section.
        """
        flow, x, s = self.flow(at.values), self.on_section(at), at.s
        spent = 0.0
        for _ in range(self.laps):
            x, s, took = self._lap(flow, x, s, at)
            spent += took
        return CycleState(x, s, spent, at.values)

    def _lap(self, flow: Flow, x: Array, s: Array, at: CycleState) -> tuple[Array, Array, float]:
        t, length, match = self.t, self.lap_length(at), self.lap_match()
        if match is None:
            x, s = flow.end(x, s, t, t + length)
            return self.mapped(x), s, length
        passage = flow.passage(x, s, t, t + length, match)
        if passage is None:
            assert self.section is not None
            raise SolveError(
                f"cycle: the motion does not come back to '{self.section.name}' within "
                f"{self.longest:g} s. Look at a run from there: its events, and where= and "
                "crossing= that single one out; or give longest="
            )
        return self.mapped(passage.x_after), passage.s_after, passage.t - t

    def lap_length(self, at: CycleState) -> float:
        """Time [s] that a lap takes, or within which it comes to the section.

        Raises:
            SolveError: a period is out of range.
        """
        if self.section is not None:
            return self.longest
        period = self.period_of(at)
        if self.period is None:
            period /= self.laps
        if not (period > 0 and (self.period is not None or period <= self.longest)):
            raise SolveError(
                f"cycle: the period became {period:.6g} s, not within longest={self.longest:g}"
            )
        return period

    def lap_match(self) -> Callable[[Passage], bool] | None:
        """What says that an event ends a lap; None where time does."""
        if self.section is None:
            return None
        return self.section.counter(self.t, RESOLUTION * self.longest)

    def mapped(self, x: Array) -> Array:
        """The state (nx,) at the start of the next lap."""
        return x if self.symmetry is None else self.symmetry(x)

    def motion(self, at: CycleState) -> TrajectoryRecord:
        """The motion over the period; with a symmetry over one lap."""
        flow, x, span = self.flow(at.values), self.on_section(at), at.period
        if self.symmetry is not None:
            span = self._lap(flow, x, at.s, at)[2]
        return flow.motion(x, at.s, self.t, self.t + span)

    def rate(self, at: CycleState, t: float | None = None) -> Array:
        """Time derivative of a state as an increment (n,)."""
        flow = self.flow(at.values)
        time = self.t if t is None else t
        rates = flow.rates(at.x, at.s, time)
        rates = np.concatenate([self.model.parts_of(at.x)[1], rates[self.model.nq :]])
        return np.asarray(rates / self.units)

    # the energy

    def energy_off(self, at: CycleState) -> float:
        """The energy of a start over the one that it has to have, in large ones."""
        assert self.level is not None
        return (self.energy(at) - self.level.target(at.values)) / self.level.size

    def energy(self, at: CycleState) -> float:
        """The energy of a start over that of the state of rest [J]."""
        assert self.level is not None
        return self.level.energy(self.system, self.flow(at.values), self.moment(at))

    def amplitude(self, at: CycleState) -> float:
        """Size of the increment from the state of rest."""
        assert self.level is not None
        return float(np.linalg.norm(self.step(self.level.equilibrium, at.x)))

    def uphill(self, at: CycleState) -> Array:
        """The direction (n,) along which the energy grows, of length 1."""
        assert self.level is not None
        gradient = self.level.gradient(self.system, self.flow(at.values), at.x, self.t) * self.units
        return np.asarray(gradient / (np.linalg.norm(gradient) or 1.0))

    # the section

    def value(self, at: CycleState) -> float:
        """What passes zero at the section."""
        assert self.section is not None
        return self.section.value(self.flow(at.values), self.t, at.x, at.s)

    def on_section(self, at: CycleState) -> Array:
        """The state moved onto the section."""
        if self.normal is None:
            return at.x
        x, size, last = at.x, float(np.linalg.norm(self.normal)), np.inf
        for _ in range(PROJECTIONS):
            value = self.value(CycleState(x, at.s, at.period, at.values))
            change = abs(value) * size
            # what is left is rounding
            if not change > CLOSE or change >= last:
                break
            x, last = self.moved(x, -value * self.normal), change
        return x

    def normal_of(self, at: CycleState) -> Array | None:
        """The increment (n,) straight off the section over the change of its value; None off it."""
        if self.section is None:
            return None
        n = len(self.units)
        sides = [
            [
                self.value(CycleState(self.moved(at.x, side * e), at.s, at.period, at.values))
                for side in (SLOPE, -SLOPE)
            ]
            for e in np.eye(n)
        ]
        gradient = np.array([(a - b) / (2 * SLOPE) for a, b in sides])
        size = float(np.linalg.norm(gradient))
        return gradient / size**2 if abs(self.value(at)) <= ON_SECTION * size else None
