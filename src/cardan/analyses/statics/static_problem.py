"""Rest under loads as equations without units: forces balance, loops are closed, states rest.

Unknowns are an increment of the coordinates, internal states, multipliers, and the forces that
hold what is held. Lengths count in sizes of the mechanism, forces in energies.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from typing import Any, TypeAlias, final

import numpy as np
from scipy.sparse import block_array, csr_array, diags_array, issparse

from ...arrays import Array
from ...errors import ModelError
from ...records import dataclass
from ..systems.dynamic_system import DynamicSystem, Moment, Parameters

Matrix: TypeAlias = Any  # an array, or a sparse one of scipy


@dataclass(frozen=True, eq=False)
class Load:
    """Loads, inputs and locked coordinates.

    Attributes:
        t, r, parameters: Time [s], inputs (nr,), values by name.
        locked: Coordinate -> the value it has.
        prescribed: Those of them that are moved in place of a load.
        u: Speed -> value, of a steady motion; None at rest.
        left: Forces and gaps (nu + nz,), (m + k,) that are left over on purpose, None for none.
    """

    t: float
    r: Array
    parameters: Parameters = None
    locked: Mapping[str, float] = field(default_factory=dict)
    u: Mapping[str, Any] | None = None
    left: tuple[Array, Array] | None = None
    prescribed: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Point:
    """A position with its forces.

    Attributes:
        at: Position, internal states, multipliers, load.
        reaction_forces: Forces along the speeds of what is held, without units: energies (k,).
    """

    at: Moment
    reaction_forces: Array


@final
@dataclass(frozen=True, eq=False)
class Problem:
    """Rest of a system.

    Attributes:
        system: What is to rest.
    """

    system: DynamicSystem

    def begin(self, load: Load, q: object) -> Point:
        """A point next to named coordinates, with the multipliers that balance it best.

        Raises:
            ModelError: nothing can move.
        """
        s = self.system
        if not len(s.columns):
            raise ModelError("nothing in this model can move, so that it rests as it is")
        at = s.start(load.t, q, load.r, load.locked, load.parameters)
        return self.supported(self.under(Point(at, np.zeros(len(load.locked))), load), load)

    def supported(self, point: Point, load: Load) -> Point:
        """The point with forces of constraint that balance it best."""
        system, tangents = self.system, self.system.tangents(point.at)
        G = self._bound(tangents.G, load)
        if not G.shape[0]:
            return point
        # constraints bear forces, not the rates of internal states
        force, n = self.residual(point, load)[0], G.shape[1]
        unit: Matrix = csr_array(diags_array(np.ones(n))) if issparse(G) else np.eye(n)
        _, y = system.saddle.solve(unit, G, -force[:n], np.zeros(G.shape[0]))
        return self.moved(point, np.zeros(len(force)), y, load)

    def under(self, point: Point, load: Load) -> Point:
        """The point under another load, with the speeds that belong to it."""
        at = replace(point.at, t=load.t, r=load.r, parameters=load.parameters)
        return replace(point, at=self._steady(at, load))

    def _steady(self, at: Moment, load: Load) -> Moment:
        return at if load.u is None else self.system.steady_state(at, load.u)

    def residual(self, point: Point, load: Load) -> tuple[Array, Array]:
        """Forces and rates (nu + nz,), gaps of constraints and of what is held (m + k,)."""
        s, at = self.system, point.at
        values, nu, m = s.balance(at), len(s.columns), len(s.rows)
        force = values[:nu] * s.columns
        gap = np.zeros(m + len(load.locked))
        gap[s.positions] = values[nu : nu + len(s.positions)] / s.rows[s.positions]
        for k, (name, value) in enumerate(load.locked.items()):
            q, u = s.place(name)
            force[u] -= point.reaction_forces[k]
            gap[m + k] = (at.q[q] - value) / s.columns[u]
        force = np.concatenate([force, s.internal_rates(at)])
        return (force, gap) if load.left is None else (force - load.left[0], gap - load.left[1])

    def tangent(self, point: Point, load: Load) -> tuple[Matrix, Matrix]:
        """K (nu + nz, nu + nz) and G (m + k, nu + nz)."""
        s, at = self.system, point.at
        stiffness, constraints = s.stiffness(at)
        G = self._bound(constraints, load)
        if load.u is not None:
            tangents = s.tangents(at)
            # speeds follow the position, for the given ones to stay
            by, rates = s.steady_state_tangent(at, load.u)
            stiffness = stiffness + tangents.C @ by + tangents.M @ rates
            if issparse(stiffness):
                stiffness = self._anchored(csr_array(stiffness), load)
        K = scaled(stiffness, s.columns, s.columns)
        if not s.internals:
            return K, G
        internal = s.internal(at)
        blocks = [
            [K, internal.balance * s.columns[:, None]],
            [internal.along * s.columns, internal.by_z],
        ]
        if issparse(K):
            empty = csr_array((G.shape[0], len(s.internals)))
            return csr_array(block_array(blocks)), csr_array(block_array([[G, empty]]))
        return np.block(blocks), np.hstack([G, np.zeros((len(G), len(s.internals)))])

    def _anchored(self, K: Matrix, load: Load) -> Matrix:
        """A stiffness with springs on coordinates that run: where nothing pushes along, none gives.

        Without them sparse matrices would be singular, as one position is as good as another.
        """
        s, anchors = self.system, np.zeros(K.shape[0])
        for name in load.u or {}:
            if name in s.coordinates and f"{name}.u" in s.speeds and name not in load.locked:
                k = s.speeds.index(f"{name}.u")
                anchors[k] = float(abs(K).max()) / s.columns[k] ** 2
        return csr_array(K + diags_array(anchors))

    def moved(self, point: Point, x: Array, y: Array, load: Load) -> Point:
        """The point after a step of the unknowns, with the speeds that belong to it."""
        s, at = self.system, point.at
        nu, m = len(s.columns), len(s.rows)
        lam = at.lam + y[:m] / s.rows
        moved = replace(s.retract(at, x[:nu] * s.columns), z=at.z + x[nu:], lam=lam)
        return Point(self._steady(moved, load), point.reaction_forces + y[m:])

    def with_internal_unknowns(self, point: Point) -> Point:
        """The point with what elements keep themselves while one searches."""
        return replace(point, at=self.system.with_internal_unknowns(point.at))

    def closed(self, point: Point) -> Point:
        """The point without that."""
        return replace(point, at=replace(point.at, inner=np.zeros(0)))

    def locked_forces(self, point: Point, load: Load) -> tuple[list[int], Array]:
        """Speeds (places) that are held, and the forces (nu,) that hold them."""
        s, tau = self.system, np.zeros(len(self.system.columns))
        places = [s.place(name)[1] for name in load.locked]
        for k, place in enumerate(places):
            tau[place] += point.reaction_forces[k] / s.columns[place]
        return places, tau

    def step(self, before: Point, after: Point) -> tuple[Array, Array]:
        """The unknowns that lead from a point to another."""
        s = self.system
        du = s.difference(before.at.q, after.at.q) / s.columns
        change = (after.at.lam - before.at.lam) * s.rows
        forces = np.concatenate([change, after.reaction_forces - before.reaction_forces])
        return np.concatenate([du, after.at.z - before.at.z]), forces

    def _bound(self, constraints: Matrix, load: Load) -> Matrix:
        """Constraints, then what is held, without units."""
        s = self.system
        G = scaled(constraints, 1.0 / s.rows, s.columns)
        if not load.locked:
            return G
        rows = [s.place(name)[1] for name in load.locked]
        if issparse(G):
            ones = np.ones(len(rows))
            locked = csr_array((ones, (np.arange(len(rows)), rows)), (len(rows), G.shape[1]))
            return csr_array(block_array([[G], [locked]])) if G.shape[0] else locked
        return np.concatenate([G, np.eye(len(s.columns))[rows]])


def scaled(matrix: Matrix, left: Array, right: Array) -> Matrix:
    """A matrix with rows and columns in other units."""
    if issparse(matrix):
        rows = csr_array(matrix)
        data = rows.data * np.repeat(left, np.diff(rows.indptr)) * right[rows.indices]
        return csr_array((data, rows.indices, rows.indptr), shape=rows.shape)
    return matrix * right * left[:, None]
