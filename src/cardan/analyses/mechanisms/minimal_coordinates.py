"""The minimal form of a closed system: as many coordinates and speeds as it has freedoms.

Some coordinates and speeds are independent; the others follow from the constraints, coordinates by
Newton's method from where they were last, speeds by one linear system. Which are independent is
chosen at a position by pivoted orthogonal factorization and stays so until it is chosen anew:
between steps of an integrator, never inside one.

Source: R. A. Wehage, E. J. Haug, J. Mech. Design 104 (1982), for the partition; N. K. Mani, E. J.
Haug, K. E. Atkinson, J. Mech. Trans. Automation 107 (1985), for its choice by orthogonal bases.
"""

from __future__ import annotations

from math import comb
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike
from scipy.linalg import qr

from ...arguments import checked
from ...arrays import Array
from ...errors import ArgumentError, SolveError
from ...runtime.calls.evaluation import State
from ...runtime.models.loaded_model import LoadedModel
from .mechanism import Mechanism
from .position_solver import LOST, PositionSolver
from .redundancy import rank_of
from .targets import Coordinates, Target

CLOSED = 1e-11  # residuals without units, as in runs
HALVINGS = 12
# below this part of the largest singular value a position counts as next to a singular one; places
# around it, in radians or sizes along the motion, and their weights in Lagrange's interpolation
SINGULAR = 0.015
COUNT = 6
SPREADS = (1.0, 0.5, 2.0)
NODES = 0.36 * np.array([k for k in range(-COUNT, COUNT + 1) if k])
WEIGHTS = np.array(
    [-((-1) ** k) * comb(2 * COUNT, COUNT + k) for k in range(-COUNT, COUNT + 1) if k]
)
WEIGHTS = WEIGHTS / comb(2 * COUNT, COUNT)


@final
class Partition:
    """A partition into independent and dependent coordinates, with the last values of the latter.

    The dependent ones are sought next to those found before: a partition belongs to one motion.

    Attributes:
        model: The model.
        coordinates, speeds: Names of the independent ones: y = [coordinates, speeds].
        condition: Of the map from them to motions; above 1e3 or so another choice is better.
    """

    def __init__(self, model: LoadedModel, q: ArrayLike, t: float = 0.0, r: Any = None) -> None:
        """Choose at a position.

        Args:
            model: A model; without loops everything is independent.
            q: Coordinates (nq,) that close its loops.
            t, r: Time [s] and inputs.

        Raises:
            ArgumentError: a wrong shape. SolveError: loops are open at this position.
        """
        self.model, self._inputs = model, r
        place = np.array(q, dtype=np.float64)
        if place.shape != (model.nq,):
            raise ArgumentError(f"q has shape {place.shape}, expected ({model.nq},)")
        m = self._at(t)
        gap = float(np.abs(m.residuals(place)).max(initial=0.0))
        if not gap <= 1e3 * CLOSED:
            raise SolveError(
                f"partition: loops are open by {gap:.3g} at this position; take one from "
                "model.assemble(...) or from a motion"
            )
        self._last = place
        G, count = m.jacobian(place), m.closing.positions
        units = [row.unit for row in model.manifest.coordinates]
        lengths = np.array([m.size if name == "m" else 1.0 for name in units])
        moves = m.kinematics(place) @ _free(G[:count]) / lengths[:, None]
        self._q, worst = _independent(moves)
        self._u, other = _independent(_free(G))
        self.condition = max(worst, other)
        self._rank = model.nu - moves.shape[1]
        self.coordinates = tuple(model.coordinates[k] for k in self._q)
        self.speeds = tuple(model.speeds[k] for k in self._u)

    def __repr__(self) -> str:
        return (
            f"Partition of '{self.model.name}': independent {', '.join(self.coordinates)}; "
            f"{', '.join(self.speeds)} (condition {self.condition:.3g})"
        )

    @checked
    def reduce(self, x: ArrayLike) -> Array:
        """y = [independent coordinates, independent speeds] (..., n) of states x (..., nx)."""
        q, u = self.model.split(x)
        return np.concatenate([q[..., self._q], u[..., self._u]], axis=-1)

    @checked
    def full(self, t: float, y: ArrayLike) -> Array:
        """The state x (nx,) with independent parts y (n,): all loops closed.

        Raises:
            ArgumentError: a wrong shape.
            SolveError: there is no such position near the last one: choose a partition anew.
        """
        return self._state(t, y)[0]

    @checked
    def rhs(self, t: float, y: ArrayLike) -> Array:
        """Derivative (n,) of y (n,).

        Raises:
            As :meth:`full`.
        """
        x, around = self._state(t, y)
        rates = self.reduce(self.model.rhs(t, x if around is None else around, r=self._inputs))
        return rates if around is None else WEIGHTS @ rates

    def _state(self, t: float, y: ArrayLike) -> tuple[Array, Array | None]:
        """The state of y, and beside a singular position those around it (nodes, nx).

        Motion on its branch is smooth there, but G alone does not tell the branch: what belongs to
        y is interpolated between positions before and behind it.
        """
        values = np.asarray(y, dtype=np.float64)
        n = len(self._q)
        if values.shape != (n + len(self._u),):
            names = ", ".join((*self.coordinates, *self.speeds))
            raise ArgumentError(
                f"y has shape {values.shape}, expected ({n + len(self._u)},): {names}"
            )
        m = self._at(t)
        q = self._follow(m, values[:n], self._last)
        speeds = self._speeds(m, q, values[n:])
        length = float(np.linalg.norm(speeds / m.columns))
        if not self._singular(m, q) or length == 0:
            self._last = q
            return np.concatenate([q, speeds]), None
        # the last regular speeds have the direction of the branch
        before = self._speeds(m, self._last, values[n:])
        rates = self.model.qdot(self._last, before, t=t, r=self._inputs)[self._q]
        way = rates / float(np.linalg.norm(before / m.columns))
        for width in SPREADS:
            around = self._around(m, values, way * width)
            if around is not None:
                x: Array = WEIGHTS @ around
                return x, around
        return np.concatenate([q, speeds]), None

    def _around(self, m: Mechanism, y: Array, way: Array) -> Array | None:
        """States (nodes, nx) before and behind y, each followed from the one before it.

        None where they end, or are singular themselves.
        """
        n, states = len(self._q), np.zeros((len(NODES), m.model.nx))
        for nodes in (range(COUNT - 1, -1, -1), range(COUNT, 2 * COUNT)):
            place = self._last
            for k in nodes:
                try:
                    place = self._follow(m, y[:n] + NODES[k] * way, place)
                except SolveError:
                    return None
                if self._singular(m, place):
                    return None
                states[k] = np.concatenate([place, self._speeds(m, place, y[n:])])
        return states

    def _at(self, t: float) -> Mechanism:
        return Mechanism(self.model, t, self._inputs)

    def _singular(self, m: Mechanism, q: Array) -> bool:
        """True when constraints of positions nearly lose rank."""
        s = np.linalg.svd(m.jacobian(q)[: m.closing.positions], compute_uv=False)
        return self._rank > 0 and bool(s[self._rank - 1] < SINGULAR * s[0])

    def _follow(self, m: Mechanism, goal: Array, q: Array) -> Array:
        """Coordinates with given independent ones, followed from other coordinates."""
        done, part, start = 0.0, 1.0, q[self._q]
        while part >= 0.5**HALVINGS:
            share = min(1.0, done + part)
            solution = PositionSolver(m, [self._target(start + share * (goal - start))]).follow(q)
            if solution is None:
                part *= 0.5
                continue
            q, done = solution.q, share
            if done == 1.0:
                return q
        raise SolveError(
            f"at t = {m.t:g} s: no position with {self._said(goal)} near the last one, with "
            f"{self._said(q[self._q])}. The independent coordinates are badly chosen there: take "
            "model.partition(...) anew between steps"
        )

    def _target(self, values: Array) -> Target:
        """The independent coordinates at given values."""
        return Coordinates(
            "",
            "coordinates",
            values,
            entries=np.array(self._q, np.intp),
            scales=np.ones(len(values)),
        )

    def _said(self, values: Array) -> str:
        pairs = zip(self.coordinates, values.tolist(), strict=True)
        return ", ".join(f"{name} = {value:.6g}" for name, value in pairs)

    def _speeds(self, m: Mechanism, q: Array, independent: Array) -> Array:
        """Speeds (nu,) that the constraints allow, with given independent ones."""
        selection = np.zeros((len(self._u), m.model.nu))
        selection[np.arange(len(self._u)), self._u] = 1.0
        right = np.concatenate(
            [-m.rates(q, np.zeros(m.model.nu)), independent / m.columns[list(self._u)]]
        )
        system = np.concatenate([m.jacobian(q), selection])
        speeds: Array = m.columns * np.linalg.lstsq(system, right, rcond=LOST)[0]
        speeds[list(self._u)] = independent
        return speeds


@checked
def partition(
    model: LoadedModel, q: ArrayLike, *, t: float = 0.0, r: State | None = None
) -> Partition:
    """Independent coordinates and speeds, chosen at a position: the minimal form.

    Args:
        model: The compiled model; without loops everything is independent.
        q: Coordinates (nq,) that close all loops.
        t, r: Time [s] and inputs.

    Returns:
        A :class:`Partition`: ``reduce(x)`` gives y, ``full(t, y)`` gives x.

    Raises:
        ArgumentError: a wrong shape. SolveError: loops are open at this position.
    """
    return Partition(model, q, t, r)


@checked
def reduced_rhs(model: LoadedModel, t: float, y: ArrayLike, partition: Partition) -> Array:
    """Derivative (n,) of y = [independent coordinates, independent speeds] (n,).

    Args:
        model: The compiled model.
        t: Time [s].
        y: Of ``partition.reduce(x)``.
        partition: Chosen anew between steps where it becomes bad.
    """
    return partition.rhs(t, y)


def _free(G: Array) -> Array:
    """An orthonormal basis (nu, n) of what rows G (m, nu) allow."""
    _, s, Vt = np.linalg.svd(G)
    basis: Array = Vt[rank_of(s) :].T
    return basis


def _independent(basis: Array) -> tuple[list[int], float]:
    """The rows of a basis (n, k) that describe it best, and the condition of that choice."""
    n = basis.shape[1]
    if n == 0:
        return [], 1.0
    chosen = sorted(qr(basis.T, mode="r", pivoting=True)[1][:n].tolist())
    return chosen, float(np.linalg.cond(basis[chosen]))
