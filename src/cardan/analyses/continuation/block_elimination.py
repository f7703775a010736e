"""Bordered systems with a large sparse core, by the factors of the core alone.

The core may be singular: its factors replace pivots, the bordered solution is corrected for that.

Source: W. Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria (2000), section 3.5
(block elimination with iterative refinement).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import final

import numpy as np

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from ..systems.saddle_point import Matrix
from ..systems.sparse_saddle_point import Near, SparseSaddle

CORRECTIONS, ENOUGH, SLOW = 6, 1e-13, 0.3
ITERATIONS = 3  # of inverse iteration for null spaces


@final
@dataclass(frozen=True, eq=False)
class SaddleJacobian:
    """J = [K -Gᵀ b; G 0 ...]: sparse blocks and the column of the load.

    Attributes:
        K, G: Sparse (p, p), (m, p).
        column: The last one (n,), n = p + m.
        core: What factors the blocks.
        symmetric: Whether K is symmetric.
    """

    K: Matrix
    G: Matrix
    column: Array
    core: SparseSaddle
    symmetric: bool = False

    @cached_property
    def factors(self) -> Near:
        """Factors of the core."""
        return self.core.near(self.K, self.G, self.symmetric)

    def apply(self, dz: Array) -> Array:
        """Same as :meth:`.Jacobian.apply`."""
        p = self.K.shape[0]
        x, y = dz[:p], dz[p:-1]
        top = self.K @ x - self.G.T @ y
        load: Array = np.multiply.outer(self.column, dz[-1])
        return np.concatenate([top, self.G @ x]) + load

    def apply_transposed(self, psi: Array) -> Array:
        """Jᵀ psi (N, ...)."""
        p = self.K.shape[0]
        x, y = psi[:p], psi[p:]
        last = np.tensordot(self.column, psi, axes=(0, 0))
        return np.concatenate([self.K.T @ x + self.G.T @ y, -(self.G @ x), np.asarray(last)[None]])

    def bordered(self, rows: Array, columns: Array) -> SaddleBordered:
        """Same as :meth:`.Jacobian.bordered`."""
        return SaddleBordered(self, rows, columns)

    def weakest(self, count: int) -> tuple[Array, Array, Array]:
        """Same as :meth:`.Jacobian.weakest`, by inverse iteration on bordered systems."""
        n, rng = len(self.column), np.random.default_rng(0)
        B = np.linalg.qr(rng.normal(size=(n, count)))[0]
        C = np.linalg.qr(rng.normal(size=(n + 1, count + 1)))[0]
        for _ in range(ITERATIONS):
            by = self.bordered(C.T, B)
            zeros = np.zeros((n, count + 1))
            C = np.linalg.qr(by.solve(zeros, np.eye(count + 1))[0])[0]
            B = np.linalg.qr(by.solve_transposed(np.eye(count))[0])[0]
        # rotated to singular vectors of what is left of J between the two spaces
        U, s, Vt = np.linalg.svd(B.T @ self.apply(C))
        return s, B @ U, C @ Vt.T


@final
@dataclass(frozen=True, eq=False)
class SaddleBordered:
    """A bordered system, solved by its core.

    Attributes:
        jacobian: J.
        rows, columns: (k, N), (n, k - 1).
    """

    jacobian: SaddleJacobian
    rows: Array
    columns: Array

    @cached_property
    def _right(self) -> tuple[Array, Array]:
        """Core^-1 [b B] (n, k), and the small matrix (k, k) that is left of the rows."""
        J, solve = self.jacobian, self.jacobian.factors.solve
        solved_columns = solve(np.column_stack([J.column, self.columns]))
        k = len(self.rows)
        corner = np.concatenate([self.rows[:, -1:], np.zeros((k, k - 1))], axis=1)
        return solved_columns, corner - self.rows[:, :-1] @ solved_columns

    @cached_property
    def _below(self) -> tuple[Array, Array]:
        """The same of the transposed system."""
        J, solve = self.jacobian, self.jacobian.factors.solve_transposed
        solved_columns = solve(self.rows[:, :-1].T)
        k = len(self.rows)
        corner = np.concatenate([self.rows[:, -1:], np.zeros((k, k - 1))], axis=1)
        right = np.column_stack([J.column, self.columns])
        return solved_columns, corner.T - right.T @ solved_columns

    def solve(self, a: Array, c: Array) -> tuple[Array, Array]:
        """Same as :meth:`.Bordered.solve`."""
        J, (solved_columns, small), n = self.jacobian, self._right, len(self.jacobian.column)

        def once(a: Array, c: Array) -> Array:
            first = J.factors.solve(a)
            border = np.linalg.solve(small, c - self.rows[:, :-1] @ first)
            return np.concatenate([first - solved_columns @ border, border])

        def left(z: Array) -> tuple[Array, Array]:
            top = J.apply(z[: n + 1]) + self.columns @ z[n + 1 :]
            return a - top, c - self.rows @ z[: n + 1]

        z = self._refined(once, left, (a, c))
        return z[: n + 1], z[n + 1 :]

    def solve_transposed(self, d: Array) -> tuple[Array, Array]:
        """Same as :meth:`.Bordered.solve_transposed`."""
        J, (solved_columns, small), n = self.jacobian, self._below, len(self.jacobian.column)
        last = np.zeros((1, *d.shape[1:]))
        right = np.zeros((n, *d.shape[1:])), np.concatenate([last, d])

        def once(a: Array, c: Array) -> Array:
            first = J.factors.solve_transposed(a)
            above = np.column_stack([J.column, self.columns])
            border = np.linalg.solve(small, c - above.T @ first)
            return np.concatenate([first - solved_columns @ border, border])

        def left(z: Array) -> tuple[Array, Array]:
            psi, gamma = z[:n], z[n:]
            top = J.apply_transposed(psi) + self.rows.T @ gamma
            return right[0] - top[:n], right[1] - np.concatenate([top[n:], self.columns.T @ psi])

        z = self._refined(once, left, right)
        return z[:n], z[n:]

    def _refined(
        self,
        once: Callable[[Array, Array], Array],
        left: Callable[[Array], tuple[Array, Array]],
        right: tuple[Array, Array],
    ) -> Array:
        """A solution, corrected until what is left of the right-hand side is rounding."""
        try:
            z = once(*right)
            size, last = max(float(np.abs(part).max(initial=0.0)) for part in right), np.inf
            for _ in range(CORRECTIONS):
                open_parts = left(z)
                worst = max(float(np.abs(part).max(initial=0.0)) for part in open_parts)
                # what does not become less is rounding
                if not ENOUGH * size < worst < SLOW * last:
                    break
                z, last = z + once(*open_parts), worst
        except np.linalg.LinAlgError:
            raise SolveError("the bordered equations are singular") from None
        if not np.isfinite(z).all():
            raise SolveError("the bordered equations are singular")
        return np.asarray(z)

    @property
    def sign(self) -> float:
        """Same as :meth:`.Bordered.sign`."""
        core = self.jacobian.factors.sign
        return core * float(np.sign(np.linalg.slogdet(self._right[1])[0]))

    @property
    def below(self) -> int | None:
        """Same as :meth:`.Bordered.below`."""
        return self.jacobian.factors.below
