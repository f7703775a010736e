"""Equilibria under a load that changes, as a family: the load is the last unknown."""

from __future__ import annotations

from dataclasses import field, replace
from typing import Any, final

import numpy as np
from scipy.linalg import qr
from scipy.sparse import csr_array, diags_array, issparse

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from ..statics.load_path import Loading
from ..statics.static_problem import Load, Point, Problem, scaled
from ..systems.saddle_point import FULL, RANK, SKEW, Lowest, Matrix, Sparse
from ..systems.sparse_saddle_point import SparseSaddle
from .block_elimination import SaddleJacobian
from .family import DenseJacobian, Jacobian
from .singular_point import singular_point

# of the range of the load: steps of differences of order 2, where those leave the domain of order 1
LOAD_STEP, SHORT_STEP = 1e-4, 1e-7
ROUNDED = 1e-15  # of energies that cancel: what is left of one of nothing
FREE = 1e-11  # of the largest stiffness: what is free still
# increments that tell whether something pushes along free directions, and pushes that are rounding
TRIED, PUSH = 0.02, 1e-10
NODE = 6  # speeds of a node: lengths of increments count nodes, and do not grow with the mesh


@dataclass(frozen=True, eq=False)
class Loaded:
    """An equilibrium under a load.

    Attributes:
        s: Place of the load on its path: 0 and 1 at the ends that were given, and beyond them.
        load: The load there.
        point: The position and its forces.
    """

    s: float
    load: Load
    point: Point


@final
@dataclass(frozen=True, eq=False)
class EquilibriumFamily:
    """Equilibria of a system under a load.

    Increments are those of positions and internal states, of multipliers and of forces that hold
    what is held (in units of ``unit``), and of the place of the load.

    Attributes:
        problem: What is loaded.
        way: The loads.
        unit: Of forces, without units: the largest stiffness of positions at the start.
        weights: See :class:`.Family`: forces follow from the rest and do not count.
        free: Directions (nu, k) that nothing resists at the start, such as a turn about the load.
        columns, rows: What positions and internal states are divided by, and their forces and rates
            (nu + nz,), so that units do not matter.
    """

    problem: Problem
    way: Loading
    unit: float
    weights: Array
    free: Array
    columns: Array
    rows: Array
    # the point whose residual was asked for last, and that
    _last: list[Any] = field(default_factory=list, repr=False)

    @classmethod
    def of(cls, problem: Problem, way: Loading, point: Point, s: float = 0.0) -> EquilibriumFamily:
        """The family through an equilibrium at a place of the loads."""
        load, system = way.at(s), problem.system
        K, G = problem.tangent(point, load)
        nu, nz, m = len(system.columns), len(system.internals), len(system.rows)
        unit = float(abs(K[:nu, :nu]).max()) if nu else 0.0
        unit = unit or 1.0
        free = _unresisted(K[:nu, :nu], system.saddle.lowest(K[:nu, :nu], G[:, :nu]))
        position = np.full(nu + nz, 1.0 / max(1.0, nu / NODE))
        weights = np.concatenate([position, np.zeros(m + len(load.locked)), [1.0]])
        units = _units(_array(K[:, nu:]), K, nu, unit)
        family = cls(problem, way, unit, weights, free[:, :0], *units)
        if free.shape[1] and family._indifferent(family.start(point, s), free.shape[1]):
            return replace(family, free=free, _last=[])
        return family

    def _indifferent(self, at: Loaded, count: int) -> bool:
        """True when nothing pushes along directions in which K is singular, however far they go.

        Where something does, the load is a critical one, and curves cross or turn back.
        """
        if self.jacobian(at).weakest(count)[0].max() > PUSH:
            return False
        axes = np.eye(count + 1)
        try:
            singular = singular_point(self, at, count)
            pushes = [singular.surface(TRIED * a)[1] for a in (*axes, *(axes[:-1] + 1.0))]
        except SolveError:
            return True
        return bool(np.abs(pushes).max() <= PUSH)

    def start(self, point: Point, s: float = 0.0) -> Loaded:
        """An equilibrium under the load at a place of its path."""
        return Loaded(s, self.way.at(s), point)

    def parameter(self, at: Loaded) -> float:
        """Same as :meth:`.Family.parameter`: the place of the load."""
        return at.s

    def residual(self, at: Loaded) -> Array:
        """Same as :meth:`.Family.residual`."""
        last = self._last
        if not last or last[0] is not at:
            force, gap = self.problem.residual(at.point, at.load)
            last[:] = at, np.concatenate([force / self.rows, gap])
        residual: Array = last[1]
        return residual

    def moved(self, at: Loaded, dz: Array) -> Loaded:
        """Same as :meth:`.Family.moved`."""
        n = self.positions
        s = at.s + float(dz[-1])
        load = self.way.at(s)
        under = self.problem.under(at.point, load)
        x, y = dz[:n] * self.columns, dz[n:-1] * self.unit
        return Loaded(s, load, self.problem.moved(under, x, y, load))

    def with_internal_unknowns(self, at: Loaded) -> Loaded:
        """Same as :meth:`.Family.with_internal_unknowns`: the stress of beams."""
        return replace(at, point=self.problem.with_internal_unknowns(at.point))

    def without_internal_unknowns(self, at: Loaded) -> Loaded:
        """Same as :meth:`.Family.without_internal_unknowns`."""
        return replace(at, point=self.problem.closed(at.point))

    def step(self, before: Loaded, after: Loaded) -> Array:
        """Same as :meth:`.Family.step`."""
        x, y = self.problem.step(before.point, after.point)
        return np.concatenate([x / self.columns, y / self.unit, [after.s - before.s]])

    def jacobian(self, at: Loaded, rough: bool | Jacobian = False) -> Jacobian:
        """Same as :meth:`.Family.jacobian`."""
        K, G = self.problem.tangent(at.point, at.load)
        K = self._anchored(K)
        by_load = self._by_load(at, bool(rough)) if isinstance(rough, bool) else rough.column
        core = self._core
        if core is None or sum(G.shape) <= FULL:
            stiffness = _array(K) * self.columns / self.rows[:, None]
            return DenseJacobian(_dense(stiffness, _array(G), by_load))
        symmetric = not (rough or self.problem.system.internals)
        symmetric = symmetric and bool(abs(K - K.T).max() <= SKEW * self.unit)
        K = scaled(K, 1.0 / self.rows, self.columns)
        return SaddleJacobian(K, G, by_load, core, symmetric)

    def _anchored(self, K: Matrix) -> Matrix:
        """A stiffness with springs on directions that are free still: nothing pushes along them."""
        nu, count = self.free.shape
        if not count:
            return K
        unresisted = np.abs(K[:nu, :nu] @ self.free).max(axis=0) <= FREE * self.unit
        springs = np.zeros(K.shape[0])
        springs[qr(self.free[:, unresisted].T, pivoting=True)[2][: int(unresisted.sum())]] = (
            self.unit
        )
        return csr_array(K + diags_array(springs)) if issparse(K) else K + np.diag(springs)

    @property
    def _core(self) -> SparseSaddle | None:
        """The solver that factors sparse matrices; None of a system with arrays."""
        saddle = self.problem.system.saddle
        factored = saddle.factored if isinstance(saddle, Sparse) else None
        return factored if isinstance(factored, SparseSaddle) else None

    @property
    def positions(self) -> int:
        """Number of increments of positions and internal states, which come first."""
        system = self.problem.system
        return len(system.columns) + len(system.internals)

    def _by_load(self, at: Loaded, rough: bool) -> Array:
        """Derivative of the residual by the place of the load (n,)."""
        here = self.residual(at)

        def off(h: float) -> Array:
            load = self.way.at(at.s + h)
            force, gap = self.problem.residual(self.problem.under(at.point, load), load)
            return np.concatenate([force / self.rows, gap])

        if not rough:
            try:
                slope: Array = (off(LOAD_STEP) - off(-LOAD_STEP)) / (2 * LOAD_STEP)
                if np.isfinite(slope).all():
                    return slope
            except SolveError:
                pass
        return (off(SHORT_STEP) - here) / SHORT_STEP


def _unresisted(K: Matrix, lowest: Lowest) -> Array:
    """Directions (nu, k) whose energy is rounding of those that cancel in it.

    That of a slender beam which bends is a small part of the largest stiffness, and is not.
    """
    free = lowest.free_directions
    energy = np.abs(np.sum(free * (K @ free), axis=0))
    return free[:, energy <= ROUNDED * np.sum(np.abs(free) * (abs(K) @ np.abs(free)), axis=0)]


def _units(by_states: Array, K: Matrix, nu: int, unit: float) -> tuple[Array, Array]:
    """Units of positions and internal states, and of their forces and rates.

    That of an internal state changes a force by the largest stiffness, or itself as fast as the
    positions do; that of its rate is the rate that a unit of a position or of a state makes.

    Args:
        by_states: Columns (nu + nz, nz) of K.
        K: The tangent (nu + nz, nu + nz). nu: Number of speeds. unit: The largest stiffness.
    """
    n = K.shape[0]
    columns, rows = np.ones(n), np.full(n, unit)
    along = _array(abs(K[nu:, :nu])).max(axis=1, initial=0.0)
    forces = np.abs(by_states[:nu]).max(axis=0, initial=0.0)
    for k in range(n - nu):
        rates = float(np.abs(by_states[nu:, k]).max())
        if forces[k] > 0:
            columns[nu + k] = unit / forces[k]
        elif rates > 0 and along[k] > 0:
            columns[nu + k] = along[k] / rates
    by = np.abs(by_states[nu:] * columns[nu:]).max(axis=1, initial=0.0)
    largest = np.maximum(along, by)
    rows[nu:] = np.where(largest > 0, largest, unit)
    return columns, rows


def _array(matrix: Matrix) -> Array:
    return np.asarray(matrix.toarray() if issparse(matrix) else matrix)


def _dense(K: Array, G: Array, by_load: Array) -> Array:
    """[K -Gᵀ; G -P] and the column of the load, P the projection onto redundant rows.

    It leaves multipliers that nothing determines as they are.
    """
    m, redundant = len(G), np.zeros((len(G), len(G)))
    if m:
        U, values, _ = np.linalg.svd(G)
        rank = int(np.sum(values > RANK * values.max(initial=0.0)))
        redundant = U[:, rank:] @ U[:, rank:].T
    return np.concatenate([np.block([[K, -G.T], [G, -redundant]]), by_load[:, None]], axis=1)
