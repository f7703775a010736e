"""Sparse linear systems of blocks: what can be asked, whichever way they are solved."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import csr_array

from ...errors import ArgumentError, CompilerMissing, SolveError
from .. import kernels
from .plan import Plan

Reals = NDArray[np.float64]
ENOUGH = 1e-14
GOOD = 1e-9
EVEN = 0.3  # units are good enough where largest numbers are between this and its inverse
CARRIED = 1e-3


class Solver(Protocol):
    """One factorization at a time.

    Vectors are in the order of the unknowns of the pattern, values as the pattern has them.
    """

    @property
    def plan(self) -> Plan:
        """The plan."""

    def factor(
        self,
        values: ArrayLike,
        rows: ArrayLike | None = None,
        columns: ArrayLike | None = None,
        symmetric: bool = False,
    ) -> None:
        """Factor a matrix.

        Args:
            values: Its numbers, as the pattern has them.
            rows: What equations are multiplied with (n,), 1 by default.
            columns: The units of the unknowns (n,), 1 by default.
            symmetric: Whether to count the signs of its eigenvalues; rows are as columns then.

        Raises:
            SolveError: an unknown or an equation is empty, or numbers are not finite.
        """

    def solve(self, b: ArrayLike, transposed: bool = False) -> Reals:
        """x of a x = b for one right-hand side (n,) or several (n, count)."""

    def refine(self, b: ArrayLike, x: ArrayLike, enough: float = ENOUGH) -> tuple[Reals, float]:
        """A better solution (n,) and its backward error, see ``cardan_sparse_refine``."""

    def determinant(self) -> tuple[float, float]:
        """The sign of the determinant and the logarithm of its size."""

    def inertia(self) -> tuple[int, int, int]:
        """How many eigenvalues are positive, negative, zero to rounding."""

    def smallest(self, steps: int = 4) -> tuple[float, Reals]:
        """Estimate of the smallest singular value in units, and its unknowns (n,), not in units."""

    @property
    def weak(self) -> NDArray[np.int32]:
        """The unknowns whose pivots were lost in rounding and replaced."""

    @property
    def shifts(self) -> Reals:
        """What was added to those pivots, in units."""

    def carried(self, b: ArrayLike, x: ArrayLike) -> tuple[float, int]:
        """How much of b replaced pivots carry, and the unknown; see ``cardan_sparse_carried``."""


def solver(plan: Plan, reproducible: bool = False) -> Solver:
    """The best way to solve here: in C, by SuperLU where there is no compiler."""
    # both build on this module
    from .blocks import BlockSolver
    from .superlu import SuperluSolver

    try:
        return BlockSolver(plan, kernels.library(reproducible))
    except CompilerMissing:
        return SuperluSolver(plan)


def solution(by: Solver, b: ArrayLike) -> Reals:
    """x of a x = b (n,), refined where pivots were replaced.

    Raises:
        SolveError: the matrix is singular and b does not fit it; the message names the block.
    """
    x = by.solve(b)
    if not len(by.weak):
        return x
    x, error = by.refine(b, x)
    carried, unknown = by.carried(b, x)
    if carried <= CARRIED and error <= GOOD:
        return x
    raise SolveError(
        f"the matrix is singular: nothing but rounding holds {named(by.plan, unknown)}"
        f" (backward error {error:.1e})"
    )


def assembled(plan: Plan, values: ArrayLike) -> csr_array:
    """The matrix of SciPy with these values (not copied if they are float64)."""
    matrix = plan.pattern
    columns, starts = matrix.csr
    return csr_array((np.asarray(values, float), columns, starts), shape=(matrix.n, matrix.n))


def balanced(plan: Plan, values: ArrayLike, sweeps: int = 6) -> tuple[Reals, Reals]:
    """Units of equations and unknowns (n,), (n,) that bring rows and columns near 1.

    Units of symmetric matrices are equal.

    Source: D. Ruiz, A scaling algorithm to equilibrate both rows and columns norms, 2001.
    """
    columns, starts = plan.pattern.csr
    rows, turned, begins = plan.pattern.turned
    size, units = np.abs(np.asarray(values, float)), np.ones((2, plan.pattern.n))
    for _ in range(sweeps):
        most = _largest(size, starts), _largest(size[turned], begins)
        if all(np.all((x >= EVEN) & (x * EVEN <= 1)) for x in most):
            break
        shares = [1 / np.sqrt(x) for x in most]
        units *= shares
        size *= shares[0][rows] * shares[1][columns]
    return units[0], units[1]


def _largest(size: Reals, starts: NDArray[np.integer]) -> Reals:
    """The largest of numbers from each start to the next, 1 where there are none but zeros."""
    most = np.ones(len(starts) - 1)
    some = np.flatnonzero(np.diff(starts))
    if len(some):
        found = np.maximum.reduceat(size, starts[some])
        most[some] = np.where(found > 0, found, 1.0)
    return most


def guess(n: int) -> Reals:
    """Numbers between 0.5 and 1.5 that no symmetry of a scene shares (n,)."""
    return np.asarray(0.5 + (0.6180339887498949 * np.arange(1, n + 1)) % 1)


def checked(name: str, given: ArrayLike, size: int) -> Reals:
    """An array of that many numbers.

    Raises:
        ArgumentError: there are more or fewer.
    """
    array = np.ascontiguousarray(given, float)
    if array.shape != (size,):
        raise ArgumentError(f"{name}: shape {array.shape} instead of ({size},)")
    return array


def sides(plan: Plan, b: ArrayLike) -> Reals:
    """Right-hand sides one behind the other: (n,) or (count, n), a copy.

    Raises:
        ArgumentError: they are not (n,) or (n, count).
    """
    given = np.asarray(b, float)
    if given.ndim not in (1, 2) or given.shape[0] != plan.pattern.n:
        raise ArgumentError(f"b: shape {given.shape} for {plan.pattern.n} unknowns")
    return np.array(given.T, order="C")


def scales(
    plan: Plan, rows: ArrayLike | None, columns: ArrayLike | None
) -> tuple[Reals | None, Reals | None]:
    """Units of equations and unknowns.

    Raises:
        ArgumentError: one of them is not a positive number.
    """
    found: list[Reals | None] = []
    for name, given in (("rows", rows), ("columns", columns)):
        scale = None if given is None else checked(name, given, plan.pattern.n)
        if scale is not None and not bool((np.isfinite(scale) & (scale > 0)).all()):
            raise ArgumentError(f"{name}: units are positive numbers")
        found.append(scale)
    return found[0], found[1]


def named(plan: Plan, unknown: int) -> str:
    """An unknown by its block."""
    matrix = plan.pattern
    block = matrix.block_of(unknown)
    kind = "multiplier" if matrix.multiplier[block] else "speed"
    return f"{kind} {unknown - int(matrix.first[block])} of block {block}"


def refused(plan: Plan, values: Reals, unknown: int) -> SolveError:
    """Why there are no factors."""
    bad = np.flatnonzero(~np.isfinite(values))
    if len(bad):
        starts = plan.pattern.csr[1]
        row = int(np.searchsorted(starts, bad[0], side="right")) - 1
        return SolveError(f"the equation of {named(plan, row)} holds {values[bad[0]]}")
    where = f" at {named(plan, unknown)}" if unknown >= 0 else ""
    return SolveError(f"the matrix is singular{where}: no equation holds this unknown")
