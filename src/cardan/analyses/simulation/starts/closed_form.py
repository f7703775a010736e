"""Starts of loops in closed form: joints that follow from others may be named as well.

Positions are those of all joints, as for every other treatment: what is named is held, whether
joints have coordinates of their own or follow from their loops, and the others are next to where
they start. Loops stay on the branch that their formulas are written for.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace

import numpy as np
from numpy.typing import NDArray

from ....arrays import Array
from ....errors import ArgumentError, ModelError, SolveError, brief, miscounted
from ....records import dataclass
from ....runtime.models.loaded_model import LoadedModel
from ....runtime.verification.closed_states import dependents
from ...mechanisms.mechanism import Mechanism
from ...mechanisms.nearest_position import EQUAL, NEAR, NEARLY, wished
from ...mechanisms.position_solver import PositionSolver, Solution, missed
from ...mechanisms.searches import drawn
from ...mechanisms.targets import Target, read

STEP = 1e-5  # of a central difference: Newton's steps need no more
ANGULAR_KINDS = ("revolute", "universal")  # kinds whose coordinates are angles
STARTS = 8  # searches for positions: loops close in several ways
SPEED_TOL = 1e-9  # speeds that loops carry otherwise, of the largest of them


@dataclass(frozen=True)
class Follower(Target):
    """Values of coordinates that follow from loops; angles count modulo full turns.

    Attributes:
        entries: Among all coordinates that follow (n,).
        scales: What each counts in (n,).
        angular: Which of them are angles (n,).
    """

    entries: NDArray[np.intp] = field(default_factory=lambda: np.zeros(0, dtype=np.intp))
    scales: Array = field(default_factory=lambda: np.ones(0))
    angular: NDArray[np.bool_] = field(default_factory=lambda: np.zeros(0, dtype=bool))

    def residual(self, m: Mechanism, q: Array) -> Array:
        """Residual of the target, without units (n,)."""
        return self._missed(_dependent_values(m, q[None])[0])

    def jacobian(self, m: Mechanism, q: Array) -> Array:
        """Derivative of the residual along steps (n, nu)."""
        ways = STEP * np.concatenate([np.eye(m.nu), -np.eye(m.nu)])
        ends = _dependent_values(m, np.array([m.advance(q, way) for way in ways]))[:, self.entries]
        # beside a dead point loops close on one side only: no slope is known there
        change = np.nan_to_num(ends[: m.nu] - ends[m.nu :])
        change = np.where(self.angular, np.remainder(change + np.pi, 2 * np.pi) - np.pi, change)
        return np.asarray(change / self.scales).T / (2 * STEP)

    def _missed(self, values: Array) -> Array:
        away = values[self.entries] - self.value
        away = np.where(self.angular, np.remainder(away + np.pi, 2 * np.pi) - np.pi, away)
        return np.asarray(away / self.scales)


def _dependent_values(m: Mechanism, q: Array) -> Array:
    """Coordinates (n, k) that follow from those of the model (n, nq); NaN where none closes."""
    r = m.model._layout.start("r") if m.r is None else m.r
    return dependents(m.model, q, np.zeros((len(q), m.model.nu)), m.t, np.tile(r, (len(q), 1)))[0]


def _numbers(m: Mechanism, letter: str, name: str, value: object) -> Array:
    """Values of a joint or entry that follows, checked."""
    numbers, where = np.asarray(value, dtype=np.float64).reshape(-1), f"{letter}={{'{name}': ...}}"
    dependent = {
        row.name: row.solved.names(letter) for row in m.model.manifest.joints if row.solved
    }
    entries = dependent.get(name, (name,))
    if numbers.size != len(entries):
        raise ArgumentError(miscounted(where, numbers.size, entries))
    if not np.isfinite(numbers).all():
        raise SolveError(f"{where} is {brief(value)}; it must be finite")
    return numbers


def _follower(m: Mechanism, entries: NDArray[np.intp], value: Array, name: str) -> Follower:
    kinds = _kinds(m.model)[entries]
    angular = np.isin(kinds, ANGULAR_KINDS)
    return Follower(
        name,
        "follower",
        value,
        entries=entries,
        scales=np.where(kinds == "prismatic", m.size, 1.0),
        angular=angular,
    )


def _kinds(model: LoadedModel) -> NDArray[np.str_]:
    """The kind of joint of every coordinate that follows."""
    joints = model.manifest.joints
    return np.array([joint.kind for joint in joints if joint.solved for _ in joint.solved.q])


def place(
    m: Mechanism, q: Array, named: Mapping[str, object], dependents: Mapping[str, object]
) -> Array:
    """Coordinates (nq,) next to a start, named ones held, of joints that follow too.

    Args:
        m, q: The mechanism and the start.
        named: Coordinates of the model that are held.
        dependents: Joints that follow from loops -> their values.

    Raises:
        ModelError: a loop gives another value, or does not close; names it.
    """
    places = m.model._layout.followers["q"]
    count = max(part.stop for part in places.values())
    goals = read(m, named)
    prescribed = [
        _follower(m, np.arange(count)[places[name]], _numbers(m, "q", name, value), name)
        for name, value in dependents.items()
    ]
    preferred = wished(m, goals, q)
    free = np.setdiff1d(np.arange(count), [k for one in prescribed for k in one.entries])
    starts = _starts(m.model, count)
    near: list[Target] = [preferred, _softly(_follower(m, free, starts[free], "start"))]
    end = _next_to(m, [*goals, *prescribed, *near], q) if len(preferred.entries) else q
    for one in prescribed:
        off = np.abs(missed(m, [one], end))
        if not (off <= NEARLY).all():
            _refuse(m, end, one)
    return end


def _next_to(m: Mechanism, targets: list[Target], q: Array) -> Array:
    """The nearest position that fulfills targets of those that searches from a few starts find;
    the start where none does."""
    rng, solver = np.random.default_rng(0), PositionSolver(m, targets)
    best: Solution | None = None
    for k in range(STARTS):
        begin = drawn(m, q, rng) if k else q
        if not np.isfinite(_dependent_values(m, begin[None])).all():
            continue
        end = solver.search(begin)
        if end.met and (best is None or end.cost < (1 - EQUAL) * best.cost):
            best = end
        if best is not None and best.cost <= NEAR**2:
            break
    return q if best is None else best.q


def _softly(one: Follower) -> Follower:
    return replace(one, weight=1.0)


def _starts(model: LoadedModel, count: int) -> Array:
    """Initial values of dependent joints: q0 as declared, else in the reference position."""
    values = np.zeros(count)
    places = model._layout.followers["q"]
    for joint in model.manifest.joints:
        if joint.name in places and joint.solved and joint.q0:
            values[places[joint.name]] = joint.q0
    return values


def _refuse(m: Mechanism, q: Array, one: Follower) -> None:
    solution = next(
        row.solved
        for row in m.model.manifest.joints
        if row.solved and (row.name == one.name or one.name in row.solved.q)
    )
    computed = _dependent_values(m, q[None])[0][one.entries]
    gives = ", ".join(f"{x:.6g}" for x in computed) if np.isfinite(computed).all() else "none"
    raise ModelError(
        f"q={{'{one.name}': {', '.join(f'{x:.6g}' for x in one.value)}}}: the loop that "
        f"'{solution.loop}' closes gives {gives} next to the other named values, on "
        f"the branch of its formulas. Named values must fit to {NEARLY:g}: name fewer coordinates, "
        f"compile with the other branch (branches={{'{solution.loop}': '+'}} or '-'), or take "
        "constraints='multipliers', which takes either branch"
    )


def speed(
    m: Mechanism, q: Array, u: Array, locked: list[int], named_values: Mapping[str, object]
) -> Array:
    """Speeds (nu,) next to a start with those of joints that follow, entries ``locked`` kept.

    Raises:
        ModelError: inconsistent speeds.
    """
    places = m.model._layout.followers["u"]
    r = m.model._layout.start("r") if m.r is None else m.r
    # rates of dependent joints are affine in the speeds: evaluate at 0 and unit speeds
    basis = np.concatenate([np.zeros((1, m.model.nu)), np.eye(m.model.nu)])
    inputs = np.tile(r, (len(basis), 1))
    rates = dependents(m.model, np.tile(q, (len(basis), 1)), basis, m.t, inputs)[1]
    G, offset = (rates[1:] - rates[0]).T, rates[0]
    chosen, values = list[int](), list[float]()
    for name, value in named_values.items():
        entries = range(*places[name].indices(len(offset)))
        chosen += entries
        values += _numbers(m, "u", name, value).tolist()
    free = np.setdiff1d(np.arange(m.model.nu), locked)
    gap = np.concatenate([np.array(values) - offset[chosen] - G[chosen] @ u, -m.rates(q, u)])
    rows = np.concatenate([G[chosen], m.jacobian(q) / m.columns])[:, free]
    # least change of the free speeds that meets named rates and constraints
    step = np.linalg.lstsq(rows, gap, rcond=None)[0]
    speeds = u.copy()
    speeds[free] += step
    left = np.abs(gap - rows @ step)
    size = max(1.0, float(np.abs(values).max(initial=0.0)))
    if not (left <= max(SPEED_TOL, m.closure_tol) * size).all():
        names = ", ".join(f"'{name}'" for name in named_values)
        raise ModelError(
            f"speeds of {names} are inconsistent with the others that are named: the loops "
            f"miss them by {left.max():.3g}. Leave one of them out"
        )
    return speeds
