"""Positions of a mechanism as its drivers move, as a family: their range is the last unknown.

Equations are the closure of loops, what is locked, and the values of coordinates that drive. Where
more of them are written than are independent, as in overconstrained loops, combinations of as many
as there are speeds are solved. These combinations are taken from the start along the path: each is
the projection of the last one, so that signs of determinants can be compared.

Source: W. C. Rheinboldt, Numer. Math. 53 (1988), 165-181 (frames moved along a manifold).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from functools import cached_property
from typing import final

import numpy as np

from ...arrays import Array
from ...errors import ModelError, SolveError
from ...records import dataclass
from ..mechanisms.branches import lost_conditions
from ..mechanisms.mechanism import Mechanism
from ..mechanisms.position_solver import PositionSolver
from ..mechanisms.redundancy import rank_of
from ..mechanisms.targets import read
from .family import DenseJacobian, Jacobian

COORDINATE, PARAMETER, INPUT, TIME = "coordinate", "parameter", "input", "t"
# of a range: steps of differences of order 4, where those leave the domain of order 1
RANGE_STEP, SHORT_STEP = 1e-3, 1e-7
DEPENDENT = 1e-6  # of the largest singular value: conditions that follow from others
ALIGNED = 0.9  # cosine between dependent conditions here and those of the last combinations
MOVES = 1e-6  # parts of a direction above this move
MOST_SOLVERS = 8  # places of a range whose solvers stay in memory


@dataclass(frozen=True, eq=False)
class Drivers:
    """Ranges that move a mechanism along its path.

    Attributes:
        m: The mechanism at the start.
        ranges: Name -> (start, end).
        kinds: Name -> ``"coordinate"``, ``"parameter"``, ``"input"`` or ``"t"``.
        locked: Coordinates and frames that keep their values.
    """

    m: Mechanism
    ranges: Mapping[str, Array]
    kinds: Mapping[str, str]
    locked: Mapping[str, object]
    _solvers: dict[float, PositionSolver] = field(default_factory=dict, repr=False)

    def values(self, s: float) -> dict[str, float]:
        """What is swept at a place of the ranges, straight on beyond their ends."""
        return {name: float((1 - s) * a + s * b) for name, (a, b) in self.ranges.items()}

    def named(self, kind: str) -> list[str]:
        """Names of a kind."""
        return [name for name in self.ranges if self.kinds[name] == kind]

    def mechanism(self, s: float) -> Mechanism:
        """The mechanism at a place of the ranges."""
        if self.constant:
            return self.m
        values, m = self.values(s), self.m
        r = m.inputs.copy()
        for name in self.named(INPUT):
            r[m.model.inputs.index(name)] = values[name]
        changed = {name: values[name] for name in self.named(PARAMETER)}
        model = m.model.with_parameters(changed) if changed else None
        return m.moved_to(values.get(TIME, m.t), r, model)

    @cached_property
    def constant(self) -> bool:
        """True where coordinates alone are swept."""
        return set(self.kinds.values()) <= {COORDINATE}

    def solver(self, s: float) -> PositionSolver:
        """Conditions at a place of the ranges, but for coordinates, which have their first values.

        Raises:
            SolveError: a parameter lies outside of its domain.
        """
        key = 0.0 if self.constant else s
        if key not in self._solvers:
            while len(self._solvers) >= MOST_SOLVERS:
                self._solvers.pop(next(iter(self._solvers)))
            m, first = self.mechanism(s), self.values(0.0)
            driven = {name: first[name] for name in self.named(COORDINATE)}
            self._solvers[key] = PositionSolver(m, read(m, {**self.locked, **driven}))
        return self._solvers[key]

    @cached_property
    def slopes(self) -> Array:
        """Changes of what the coordinates shall be by the place of the ranges (m,)."""
        solver = self.solver(0.0)
        slopes, row = np.zeros(solver.record.hard), solver.record.hard_count
        for target in solver.targets:
            if target.name in self.ranges:
                a, b = self.ranges[target.name]
                slopes[row] = (b - a) / target.scales_of(self.m)[0]
            row += target.rows
        return slopes

    def residual(self, s: float, q: Array) -> Array:
        """All conditions (m,) at a position (nq,), without units."""
        return self.solver(s).hard(q) - s * self.slopes

    def jacobian(self, s: float, q: Array) -> Array:
        """Their derivatives (m, nu + 1) by steps and by the place of the ranges."""
        along = self.solver(s).hard_jacobian(q)
        return np.concatenate([along, self._by_range(s, q)[:, None]], axis=1)

    def _by_range(self, s: float, q: Array) -> Array:
        if self.constant:
            return -self.slopes

        def off(h: float) -> Array:
            return self.residual(s + h, q)

        h = RANGE_STEP
        try:
            odd = [off(h) - off(-h), off(2 * h) - off(-2 * h)]
            slope: Array = (8 * odd[0] - odd[1]) / (12 * h)
            if np.isfinite(slope).all():
                return slope
        except SolveError:
            pass
        return (off(SHORT_STEP) - off(0.0)) / SHORT_STEP

    def lost(self, q: Array) -> Array:
        """Combinations (m, k) of conditions that are dependent at a position, and beside it not."""
        combinations = lost_conditions(self.m, q)
        rows = self.solver(0.0).record.hard - len(combinations)
        return np.concatenate([combinations, np.zeros((rows, combinations.shape[1]))])

    def check(self, q: Array) -> None:
        """Refuse a start from which the drivers do not say where to go.

        Raises:
            ModelError: freedoms are left, or conditions contradict one another.
        """
        J, m = self.jacobian(0.0, q), self.m
        nu, rank = m.nu, rank_of(np.linalg.svd(J, compute_uv=False))
        who = " and ".join(f"'{name}'" for name in self.ranges)
        if rank == nu + 1:
            raise ModelError(
                f"{who} cannot move: the loops and locked= determine the whole position"
            )
        if rank == nu or rank + self.lost(q).shape[1] == nu:
            return
        free = np.abs(np.linalg.svd(J)[2][rank:, :nu]).max(axis=0)
        rows = np.array([str(row.joint or row.name) for row in m.model.manifest.speeds])
        names = ", ".join(dict.fromkeys(rows[free > MOVES].tolist()))
        raise ModelError(
            f"the mechanism has {nu + 1 - rank} freedoms where {who} moves, and a path "
            f"has one: keep others where they are by locked={{'name': value}}, among {names}"
        )


@dataclass(frozen=True, eq=False)
class Configuration:
    """A position of a mechanism.

    Attributes:
        s: Place of the ranges: 0 and 1 at their ends, and beyond them.
        q: Coordinates (nq,).
        combinations: Of the conditions, orthonormal (m, nu).
    """

    s: float
    q: Array
    combinations: Array


@final
@dataclass(frozen=True, eq=False)
class ConfigurationFamily:
    """Positions of a mechanism as its drivers move.

    Increments are steps of the mechanism: radians, and lengths in sizes of it; then that of the
    place of the ranges. Angles that differ by full turns are the same position.

    Attributes:
        drivers: What moves it.
        weights: See :class:`.Family`: the range counts where no coordinate does for it.
    """

    drivers: Drivers
    weights: Array

    @classmethod
    def of(cls, drivers: Drivers) -> ConfigurationFamily:
        """The family of a mechanism."""
        weights = np.ones(drivers.m.nu + 1)
        weights[-1] = 0.0 if drivers.named(COORDINATE) else 1.0
        return cls(drivers, weights)

    @property
    def positions(self) -> int:
        """Number of steps, which come first."""
        return len(self.weights) - 1

    def start(self, q: Array) -> Configuration:
        """A position at the start of the ranges."""
        J, count = self.drivers.jacobian(0.0, q), self.positions
        if J.shape[0] == count:
            return Configuration(0.0, q, np.eye(count))
        U, values, _ = np.linalg.svd(J)
        dependent, lost = U[:, rank_of(values) :], self.drivers.lost(q)
        redundant = np.linalg.svd(dependent - lost @ (lost.T @ dependent))[0]
        redundant = redundant[:, : dependent.shape[1] - lost.shape[1]]
        return Configuration(0.0, q, np.linalg.svd(redundant)[0][:, -count:])

    def parameter(self, at: Configuration) -> float:
        """Same as :meth:`.Family.parameter`: the place of the ranges."""
        return at.s

    def residual(self, at: Configuration) -> Array:
        """Same as :meth:`.Family.residual`."""
        return at.combinations.T @ self.drivers.residual(at.s, at.q)

    def jacobian(self, at: Configuration, rough: bool | Jacobian = False) -> DenseJacobian:
        """Same as :meth:`.Family.jacobian`."""
        return DenseJacobian(at.combinations.T @ self.drivers.jacobian(at.s, at.q))

    def moved(self, at: Configuration, dz: Array) -> Configuration:
        """Same as :meth:`.Family.moved`."""
        q = self.drivers.m.advance(at.q, dz[:-1])
        return self._aligned(replace(at, s=at.s + float(dz[-1]), q=q))

    def _aligned(self, at: Configuration) -> Configuration:
        """The same position with combinations of conditions that are independent there."""
        before, count = at.combinations, self.positions
        if len(before) == count:
            return at
        U, values, _ = np.linalg.svd(self.drivers.solver(at.s).hard_jacobian(at.q))
        dependent = U[:, int(np.sum(values > DEPENDENT * values[0])) :]
        # where rank is lost, those of the dependent conditions that were before
        last = np.linalg.svd(before)[0][:, count:]
        W, cosines, Vt = np.linalg.svd(dependent.T @ last)
        if cosines.min() > ALIGNED:
            return at
        dependent = dependent @ W[:, : len(Vt)] @ Vt
        projected = before - dependent @ (dependent.T @ before)
        W, cosines, Vt = np.linalg.svd(projected, full_matrices=False)
        return replace(at, combinations=W @ Vt)

    def with_internal_unknowns(self, at: Configuration) -> Configuration:
        """Same as :meth:`.Family.with_internal_unknowns`: there are none."""
        return at

    def without_internal_unknowns(self, at: Configuration) -> Configuration:
        """Same as :meth:`.Family.without_internal_unknowns`."""
        return at

    def step(self, before: Configuration, after: Configuration) -> Array:
        """Same as :meth:`.Family.step`; of angles the way that is less than half a turn."""
        m = self.drivers.m
        way = m.difference(before.q, m.nearest(after.q, before.q))
        return np.append(way, after.s - before.s)
