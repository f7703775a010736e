"""Equations with one more unknown than there are equations: their solutions are curves.

An increment dz (N,) holds all unknowns without units; the last one is that of the parameter. With
J the derivative of the equations (n, N), n = N - 1, rows C (k, N) and columns B (n, k - 1) make a
square system

    [J B] [dz  ]   [a]
    [C 0] [beta] = [c]

which is regular on the curve for k = 1 and the tangent as the row, and at a point where J has lost
k - 1 of its rank for rows and columns that span its null spaces.

Source: W. Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria (2000), chapter 3.
"""

from __future__ import annotations

from typing import Any, Protocol, TypeAlias, final

import numpy as np
from scipy.linalg.lapack import dgetrf, dgetrs

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass

Point: TypeAlias = Any  # a place of a family: coordinates, forces, parameter


class Bordered(Protocol):
    """The bordered system at a point, factored."""

    def solve(self, a: Array, c: Array) -> tuple[Array, Array]:
        """dz (N, ...) and beta (k - 1, ...) for right-hand sides a (n, ...), c (k, ...).

        Raises:
            SolveError: the system is singular.
        """

    def solve_transposed(self, d: Array) -> tuple[Array, Array]:
        """psi (n, ...), gamma (k, ...): Jᵀ psi + Cᵀ gamma = 0 and Bᵀ psi = d (k - 1, ...)."""

    @property
    def sign(self) -> float:
        """Of the determinant; 0 where that is not known."""

    @property
    def below(self) -> int | None:
        """Eigenvalues below 0 of symmetric equations at a fixed parameter; None where not known."""


class Jacobian(Protocol):
    """J at a point."""

    def bordered(self, rows: Array, columns: Array) -> Bordered:
        """The system with rows (k, N) and columns (n, k - 1).

        Raises:
            SolveError: numbers are not finite.
        """

    def apply(self, dz: Array) -> Array:
        """J dz (n, ...)."""

    @property
    def column(self) -> Array:
        """The derivative by the parameter (n,)."""

    def weakest(self, count: int) -> tuple[Array, Array, Array]:
        """Smallest singular values (count,), left (n, count) and right vectors (N, count + 1).

        The right ones span the null space of J as well.
        """


class Family(Protocol):
    """Equations, and how their unknowns change."""

    @property
    def weights(self) -> Array:
        """Of the unknowns in the length of an increment (N,): sum of weights dz^2."""

    def residual(self, point: Point) -> Array:
        """What is left (n,), without units: rounding on the curve.

        Raises:
            SolveError: the point lies outside of a domain.
        """

    def jacobian(self, point: Point, rough: bool | Jacobian = False) -> Jacobian:
        """J at a point.

        Args:
            point: Where.
            rough: As exact as steps of Newton's method ask for; or J of a point next to this one,
                from which what changes little may be taken.

        Raises:
            SolveError: the point lies outside of a domain.
        """

    def moved(self, point: Point, dz: Array) -> Point:
        """The point an increment away."""

    def with_internal_unknowns(self, point: Point) -> Point:
        """The point with unknowns of its own that elements keep while one corrects."""

    def without_internal_unknowns(self, point: Point) -> Point:
        """The point without these, which increments do not hold."""

    def step(self, before: Point, after: Point) -> Array:
        """The increment (N,) between two points."""

    def parameter(self, point: Point) -> float:
        """The parameter of the curve."""


def length(family: Family, dz: Array) -> float:
    """Length of an increment."""
    return float(np.sqrt(np.sum(family.weights * dz**2)))


def along_parameter(family: Family) -> Array:
    """The direction (N,) in which the parameter grows alone."""
    direction = np.zeros(len(family.weights))
    direction[-1] = 1.0
    return direction


def row(family: Family, dz: Array) -> Array:
    """The row (1, N) whose product with an increment is that with dz."""
    return (family.weights * dz)[None, :]


@final
@dataclass(frozen=True, eq=False)
class DenseBordered:
    """LU factors of a bordered matrix.

    Attributes:
        size: N.
        factors, swaps: Of LAPACK.
    """

    size: int
    factors: Array
    swaps: Array

    def solve(self, a: Array, c: Array) -> tuple[Array, Array]:
        """Same as :meth:`Bordered.solve`."""
        return self._solved(np.concatenate([a, c]), self.size, 0)

    def solve_transposed(self, d: Array) -> tuple[Array, Array]:
        """Same as :meth:`Bordered.solve_transposed`."""
        zeros = np.zeros((self.size, *d.shape[1:]))
        return self._solved(np.concatenate([zeros, d]), self.size - 1, 1)

    def _solved(self, right: Array, stop: int, transposed: int) -> tuple[Array, Array]:
        solution, _ = dgetrs(self.factors, self.swaps, right, trans=transposed)
        if not np.isfinite(solution).all():
            raise SolveError("the bordered equations are singular")
        return solution[:stop], solution[stop:]

    @property
    def sign(self) -> float:
        """Same as :meth:`Bordered.sign`."""
        swapped = np.sum(self.swaps != np.arange(len(self.swaps)))
        return float(np.prod(np.sign(np.diag(self.factors))) * (-1) ** swapped)

    @property
    def below(self) -> None:
        """Same as :meth:`Bordered.below`: LU factors do not tell."""


@final
@dataclass(frozen=True, eq=False)
class DenseJacobian:
    """J as an array (n, N).

    Attributes:
        matrix: The array.
    """

    matrix: Array

    @property
    def column(self) -> Array:
        """Same as :meth:`Jacobian.column`."""
        last: Array = self.matrix[:, -1]
        return last

    def bordered(self, rows: Array, columns: Array) -> DenseBordered:
        """Same as :meth:`Jacobian.bordered`."""
        corner = np.zeros((len(rows), columns.shape[1]))
        matrix = np.block([[self.matrix, columns], [rows, corner]])
        if not np.isfinite(matrix).all():
            raise SolveError("the derivatives of the equations are not finite")
        factors, swaps, _ = dgetrf(matrix)
        return DenseBordered(self.matrix.shape[1], factors, swaps)

    def apply(self, dz: Array) -> Array:
        """Same as :meth:`Jacobian.apply`."""
        product: Array = self.matrix @ dz
        return product

    def weakest(self, count: int) -> tuple[Array, Array, Array]:
        """Same as :meth:`Jacobian.weakest`."""
        U, s, Vt = np.linalg.svd(self.matrix)
        first = len(s) - min(count, len(s))
        return s[first:], U[:, first:], Vt[first:].T
