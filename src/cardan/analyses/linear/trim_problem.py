"""Unknowns and conditions of a trim."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from ...arrays import Array, Integers
from ...errors import ModelError, SolveError
from ...records import dataclass
from ..mechanisms.consistent_rates import read, speeds
from ..mechanisms.mechanism import Mechanism
from ..mechanisms.position_solver import PositionSolver
from ..systems.dynamic_system import Moment
from ..systems.joint_system import JointSystem
from .first_order import FirstOrder, chosen, first_order, unit_force_accelerations

FORCE = ".driving_force"
NAMED, LEADING = 1e6, 1e3  # preference of speeds that are spoken of, and of the others
SLOW = 1e-4  # of the speed of vibrations by a unit: speeds below which nothing is seen to change
STEP = 1e-5  # of central differences by what is free: their error of 1e-10 slows no search


@dataclass(frozen=True, eq=False)
class Guess:
    """A motion on the constraints.

    Attributes:
        at: The state with its accelerations.
        tau: Forces along the speeds that are free (nu,).
    """

    at: Moment
    tau: Array


@dataclass(frozen=True, eq=False)
class Trimming:
    """Conditions of a steady motion.

    Attributes:
        system: The system.
        targets: Coordinate, speed or output -> value.
        free: Name -> ``"input"``, ``"parameter"``, ``"force"`` or ``"speed"``; speeds last but
            they are unknown anyway.
        fixed_speeds: Speeds that keep a value or start there.
        base: Parameters by name, as they stay or start.
        r, t: Inputs (nr,) and time [s].
        v: Independent speeds of a search, as places of speeds; chosen where it begins.
    """

    system: JointSystem
    targets: Mapping[str, float]
    kinds: Mapping[str, str]
    fixed_speeds: Mapping[str, Any]
    base: Mapping[str, float]
    r: Array
    t: float
    v: Integers | None = None

    def searching(self, guess: Guess) -> Trimming:
        """The same with speeds that are independent where a search begins."""
        free = replace(self, v=None)
        return replace(self, v=free.first(guess).v)

    @cached_property
    def free(self) -> tuple[str, ...]:
        """Free quantities other than states."""
        return tuple(n for n, kind in self.kinds.items() if kind != "speed")

    def model(self, guess: Guess) -> Any:
        """The model with the parameters of a guess."""
        p = guess.at.parameters
        return self.system.model.with_parameters(dict(p)) if p else self.system.model

    def begin(self, q: object) -> Guess:
        """The start, assembled, with the speeds that were given."""
        at = self.system.start(self.t, q, self.r, {}, dict(self.base) or None)
        start = dict(self.fixed_speeds)
        for name, value in self.targets.items():
            if name in self.system.speeds and not self._prescribes(start, name):
                start[name] = value
        free = {n: 0.0 for n in self.system.speeds if self.kinds.get(n) == "speed"}
        allowed = {**{n: v for n, v in free.items() if not self._prescribes(start, n)}, **start}
        m = self._mechanism(at)
        try:
            u = speeds(m, at.q, allowed, np.zeros(len(self.system.speeds)))
        except ModelError:
            # what is wanted need not fit the position where the search begins
            u = speeds(m, at.q, dict(self.fixed_speeds), np.zeros(len(self.system.speeds)))
        return self._accelerated(replace(at, u=u), np.zeros(len(u)))

    def _prescribes(self, start: Mapping[str, object], name: str) -> bool:
        return self.system.speeds.index(name) in self._places(start)

    def _places(self, start: Mapping[str, object]) -> list[int]:
        return [int(k) for k in read("u", self.system.model, start)[0]]

    def _mechanism(self, at: Moment) -> Mechanism:
        return self.system._at(at)

    def _accelerated(self, at: Moment, tau: Array) -> Guess:
        return Guess(self.system.accelerations(at, tau), tau)

    # first order

    @cached_property
    def _first(self) -> Callable[[Guess], FirstOrder]:
        return lru_cache(maxsize=4)(self._linear)

    def first(self, guess: Guess) -> FirstOrder:
        """Small motions about a guess, in independent speeds of which those that are named lead."""
        return self._first(guess)

    def _linear(self, guess: Guess) -> FirstOrder:
        system, tangents = self.system, self.system.tangents(guess.at)
        G = tangents.G / system.rows[:, None] * system.columns
        weights = np.full(len(system.columns), LEADING)
        weights[self._named] = NAMED
        e = chosen(G[system.positions], np.full(len(weights), LEADING))[1]
        v = chosen(G, weights, self.v)[1]
        return first_order(system, guess.at, (), guess.tau, (e, v))

    @cached_property
    def _named(self) -> list[int]:
        """Speeds that are spoken of."""
        named = self._places(self.fixed_speeds)
        spoken = {*self.targets, *self.kinds}
        return named + [k for k, name in enumerate(self.system.speeds) if name in spoken]

    # conditions

    def states(self, guess: Guess) -> Array:
        """Units of independent increments and speeds and of internal states (n,)."""
        first = self.first(guess)
        columns = self.system.columns
        return np.concatenate([columns[first.e], columns[first.v], np.ones(len(guess.at.z))])

    def constant_speeds(self, guess: Guess) -> list[int]:
        """Independent speeds that are neither targets nor free."""
        names = self.system.speeds
        return [k for k in self.first(guess).v if names[k] not in {*self.targets, *self._open}]

    @property
    def _open(self) -> set[str]:
        return {n for n, kind in self.kinds.items() if kind == "speed"}

    def miss(self, guess: Guess) -> Array:
        """Accelerations, rates of internal states, targets, speeds that stay."""
        at, system = guess.at, self.system
        accelerations = at.udot[self.first(guess).v] / system.columns[self.first(guess).v]
        free_speeds = self.constant_speeds(guess)
        stay = (at.u - self._start)[free_speeds] / system.columns[free_speeds]
        parts = [accelerations, system.internal_rates(at), self._off(guess), stay]
        return np.concatenate(parts)

    @cached_property
    def _start(self) -> Array:
        """Speeds that are kept have these values (nu,)."""
        places, values = read("u", self.system.model, self.fixed_speeds)
        speeds_at_start = np.zeros(len(self.system.speeds))
        speeds_at_start[places] = values
        return speeds_at_start

    def _off(self, guess: Guess) -> Array:
        """Requested values less their targets, without units of length."""
        values = self._named_values(guess)
        return np.array([(values[n] - v) / self._unit(n) for n, v in self.targets.items()])

    def _unit(self, name: str) -> float:
        system = self.system
        speed = name if name in system.speeds else f"{name}.u"
        return float(system.columns[system.speeds.index(speed)]) if speed in system.speeds else 1.0

    def _named_values(self, guess: Guess) -> dict[str, float]:
        system, at = self.system, guess.at
        values = dict(zip(system.coordinates, at.q.tolist(), strict=True))
        values |= dict(zip(system.speeds, at.u.tolist(), strict=True))
        if any(name in system.outputs for name in self.targets):
            outputs = system.model.outputs(at.q, at.u, **system._arguments(at))
            values |= dict(zip(system.outputs, np.ravel(outputs).tolist(), strict=False))
        return values

    def matrix(self, guess: Guess) -> Array:
        """Derivatives of the conditions by the unknowns (m, n), without units."""
        return self._matrices(guess)

    @cached_property
    def _matrices(self) -> Callable[[Guess], Array]:
        return lru_cache(maxsize=2)(self._matrix)

    def _matrix(self, guess: Guess) -> Array:
        system, first = self.system, self.first(guess)
        n, v = len(first.e), first.v
        units, columns = self.states(guess), system.columns
        accelerations = first.A[n : n + len(v)] / columns[v][:, None]
        rows = [accelerations, first.A[n + len(v) :], self._target_rows(guess)]
        constant = self.constant_speeds(guess)
        rows.append(first.speeds[constant] / columns[constant][:, None])
        by_states = np.concatenate(rows) * units
        by_free = [self._by(guess, name) for name in self.free]
        return np.column_stack([by_states, *by_free])

    def _target_rows(self, guess: Guess) -> Array:
        system, first, nz = self.system, self.first(guess), len(guess.at.z)
        count = len(first.A)
        rows, inner = np.zeros((len(self.targets), count)), np.eye(nz, count, count - nz)
        jacobians = (
            system.output_jacobians(guess.at)
            if any(n in system.outputs for n in self.targets)
            else None
        )
        kinematic_matrix = system.kinematic_matrix(guess.at)
        for k, name in enumerate(self.targets):
            if name in system.coordinates:
                rows[k] = kinematic_matrix[system.coordinates.index(name)] @ first.increments
            elif name in system.speeds:
                rows[k] = first.speeds[system.speeds.index(name)]
            elif jacobians is not None:
                i = system.outputs.index(name)
                rows[k] = jacobians.along[i] @ first.increments + jacobians.by_u[i] @ first.speeds
                rows[k] += jacobians.by_z[i] @ inner
            rows[k] /= self._unit(name)
        return rows

    def _by(self, guess: Guess, name: str) -> Array:
        """Derivatives of the conditions by a free quantity."""
        if self.kinds[name] == "force":
            system, first = self.system, self.first(guess)
            answer = unit_force_accelerations(system, guess.at, [self._speed(name)])[:, 0]
            column = np.zeros(len(self.miss(guess)))
            column[: len(first.v)] = answer[first.v] / system.columns[first.v]
            return column * self._size(guess, name)
        h = STEP
        sides = [self.miss(self._with(guess, {name: sign * h}, guess)) for sign in (1, -1)]
        return np.asarray((sides[0] - sides[1]) / (2 * h))

    # values

    def _speed(self, name: str) -> int:
        base_name = name.removesuffix(FORCE)
        return self.system.speeds.index(
            base_name if base_name in self.system.speeds else f"{base_name}.u"
        )

    def _size(self, guess: Guess, name: str) -> float:
        """A unit of something free."""
        return max(abs(self.values(guess).get(name, 0.0)), 1.0)

    def values(self, guess: Guess) -> dict[str, float]:
        """Free quantities and their values."""
        at, system, values_by_name = guess.at, self.system, dict[str, float]()
        for name, kind in self.kinds.items():
            if kind == "input":
                values_by_name[name] = float(at.r[system.inputs.index(name)])
            elif kind == "parameter":
                default = system.model.parameters[name]
                values_by_name[name] = float(np.asarray((at.parameters or {}).get(name, default)))
            elif kind == "force":
                values_by_name[name] = float(guess.tau[self._speed(name)])
            else:
                values_by_name[name] = float(at.u[system.speeds.index(name)])
        return values_by_name

    def _with(self, guess: Guess, change: Mapping[str, float], sizes: Guess) -> Guess:
        """The guess with other free values (changes in their units), on its constraints."""
        at, tau, r = guess.at, guess.tau.copy(), guess.at.r.copy()
        parameters, now = dict(at.parameters or {}), self.values(guess)
        for name, step in change.items():
            value = now[name] + step * self._size(sizes, name)
            if self.kinds[name] == "input":
                r[self.system.inputs.index(name)] = value
            elif self.kinds[name] == "parameter":
                parameters[name] = value
            else:
                tau[self._speed(name)] = value
        v = self.first(guess).v
        return self._guess(replace(at, r=r, parameters=parameters or None), tau, v)

    def _guess(self, at: Moment, tau: Array, v: Any) -> Guess:
        """A motion on the constraints next to one, with its independent speeds."""
        m = self._mechanism(at)
        q, u = at.q, at.u
        if len(self.system.positions):
            end = PositionSolver(m).search(q)
            if not end.met:
                raise SolveError("trim: loops do not close there")
            q = end.q
        if len(self.system.rows):
            independent = {self.system.speeds[k]: u[k] for k in v}
            u = speeds(m, q, independent, u)
        return self._accelerated(replace(at, q=q, u=u), tau)

    def moved(self, guess: Guess, step: Array) -> Guess:
        """The guess after a step of the unknowns, without units."""
        system, first = self.system, self.first(guess)
        count, nz = len(first.A), len(guess.at.z)
        x = step[:count] * self.states(guess)
        at = system.retract(guess.at, first.increments @ x)
        at = replace(at, u=at.u + first.speeds @ x, z=at.z + x[count - nz :])
        change = dict(zip(self.free, step[count:].tolist(), strict=True))
        start = self._guess(at, guess.tau, first.v)
        return self._with(start, change, guess) if change else start

    # what is told

    def unsteady(self, guess: Guess, tolerance: float) -> str:
        """The speed with which accelerations change most as the motion goes on; "" if none do."""
        system, at, first = self.system, guess.at, self.first(guess)
        rates = system.rates(at, guess.tau)
        along = rates.along[first.v] / system.columns[first.v][:, None]
        by_u = rates.by_u[first.v] / system.columns[first.v][:, None]
        jerk = along @ at.u + by_u @ at.udot
        stiff = float(np.abs(along).max(initial=0.0))
        # below this speeds are rounding, against those of vibrations
        moving = max(float(np.abs(at.u).max(initial=0.0)), SLOW * stiff**0.5)
        scale = stiff * moving
        scale += np.abs(by_u).max(initial=0.0) * np.abs(at.udot).max(initial=0.0)
        if np.abs(jerk).max(initial=0.0) <= tolerance * scale:
            return ""
        # by independent increments: of others alone loops would not stay closed
        n = len(first.e)
        shares = np.abs(along @ first.increments[:, :n] * at.u[first.e]).max(axis=0)
        return system.speeds[int(first.e[shares.argmax()])]

    def settled(self, name: str) -> bool:
        """True when a speed has a value that was asked for."""
        return name in {*self.targets, *self.kinds} or self._prescribes(self.fixed_speeds, name)

    def with_zero_speed(self, name: str) -> Trimming:
        """The same with a speed that is 0."""
        return replace(self, targets={**self.targets, name: 0.0}, v=None)

    def free_motions(self, guess: Guess, directions: Array, tolerance: float) -> tuple[str, ...]:
        """Coordinates of which any value would do, by directions in which nothing changes."""
        first = self.first(guess)
        moved = first.increments @ (directions[:, : len(first.A)] * self.states(guess)).T
        sizes = np.abs(moved / self.system.columns[:, None]).max(axis=1, initial=0.0)
        return tuple(n for n, x in zip(self.system.increments, sizes, strict=True) if x > tolerance)

    def left_over(self, guess: Guess, directions: Array) -> dict[str, float]:
        """Share of the free quantities in directions (k, n) in which nothing changes."""
        first, names = self.first(guess), self.system.speeds
        count = len(first.A)
        sizes = np.abs(directions).max(axis=0, initial=0.0)[count:]
        shares = dict(zip(self.free, sizes.tolist(), strict=True))
        changed = first.speeds @ (directions[:, :count] * self.states(guess)).T
        for name in self._open:
            k = names.index(name)
            shares[name] = float(np.abs(changed[k]).max(initial=0.0)) / self.system.columns[k]
        return shares

    def cure(self) -> str:
        """Advice for the case that the free quantities do not help."""
        inputs = [name for name in self.system.inputs if name not in self.kinds]
        candidates = ", ".join([*inputs, f"<joint>{FORCE}", "<joint>.u"])
        return f"Free something that does: {candidates}; or want something else, start nearer"

    def wishes(self, guess: Guess) -> slice:
        """The conditions of the targets."""
        first = len(self.first(guess).v) + len(guess.at.z)
        return slice(first, first + len(self.targets))

    def complaint(self, guess: Guess, row: int, miss: float) -> str:
        """Message about a condition that does not hold, with a remedy."""
        first = self.first(guess)
        nv, nz, nw = len(first.v), len(guess.at.z), len(self.targets)
        cure = self.cure()
        if row < nv:
            name = self.system.speeds[first.v[row]]
            value = miss * self.system.columns[first.v[row]]
            return f"'{name}' changes at {value:.3g}, and nothing that is free stops it. {cure}"
        if row < nv + nz:
            name = self.system.internals[row - nv]
            return f"'{name}' changes at {miss:.3g}, and nothing that is free stops it. {cure}"
        if row < nv + nz + nw:
            name = list(self.targets)[row - nv - nz]
            value = self.targets[name] + miss * self._unit(name)
            return f"'{name}' is {value:.6g}, not {self.targets[name]:.6g}, at the nearest. {cure}"
        name = self.system.speeds[self.constant_speeds(guess)[row - nv - nz - nw]]
        return f"'{name}' cannot stay as it is given (0 if it is not). Free '{name}', or: {cure}"
