"""Sparse linear systems of blocks: their matrices, units, right-hand sides, and what is refused."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arrays import Array
from ...errors import ArgumentError, SolveError
from .plan import Plan

if TYPE_CHECKING:
    from scipy.sparse import csr_array

Reals = Array
EVEN = 0.3  # units are good enough where largest numbers are between this and its inverse


def assembled(plan: Plan, values: ArrayLike) -> csr_array:
    """The matrix of SciPy with these values (not copied if they are float64)."""
    from scipy.sparse import csr_array

    matrix = plan.pattern
    columns, starts = matrix.csr
    return csr_array((np.asarray(values, float), columns, starts), shape=(matrix.n, matrix.n))


def balanced(
    plan: Plan, values: ArrayLike, sweeps: int = 6, start: tuple[Reals, Reals] | None = None
) -> tuple[Reals, Reals]:
    """Units of equations and unknowns (n,), (n,) that bring rows and columns near 1.

    Units of symmetric matrices are equal, where they start from such ones: 1, or those of a
    matrix before.

    Source: D. Ruiz, A scaling algorithm to equilibrate both rows and columns norms, 2001.
    """
    columns, starts = plan.pattern.csr
    rows, transposed, begins = plan.pattern.transposed
    size, units = np.abs(np.asarray(values, float)), np.ones((2, plan.pattern.n))
    if start is not None:
        units *= start
        size *= units[0][rows] * units[1][columns]
        # columns follow where matrices are nearly symmetric, as those of one pattern are here
        if _even(_largest(size, starts)):
            return start
    for _ in range(sweeps):
        most = _largest(size, starts), _largest(size[transposed], begins)
        if all(map(_even, most)):
            break
        shares = [1 / np.sqrt(x) for x in most]
        units *= shares
        size *= shares[0][rows] * shares[1][columns]
    return units[0], units[1]


def _even(most: Reals) -> bool:
    """True of numbers near 1."""
    return bool(most.min(initial=1.0) >= EVEN and most.max(initial=1.0) * EVEN <= 1)


def _largest(size: Reals, starts: NDArray[np.integer]) -> Reals:
    """The largest of numbers from each start to the next, 1 where there are none but zeros."""
    most = np.ones(len(starts) - 1)
    some = np.flatnonzero(np.diff(starts))
    if len(some):
        maxima = np.maximum.reduceat(size, starts[some])
        most[some] = np.where(maxima > 0, maxima, 1.0)
    return most


def guess(n: int) -> Reals:
    """Numbers between 0.5 and 1.5 that no symmetry of a scene shares (n,)."""
    return np.asarray(0.5 + (0.6180339887498949 * np.arange(1, n + 1)) % 1)


def checked(name: str, values: ArrayLike, size: int) -> Reals:
    """An array of that many numbers.

    Raises:
        ArgumentError: there are more or fewer.
    """
    array = np.ascontiguousarray(values, float)
    if array.shape != (size,):
        raise ArgumentError(f"{name}: shape {array.shape} instead of ({size},)")
    return array


def sides(plan: Plan, b: ArrayLike) -> Reals:
    """Right-hand sides one behind the other: (n,) or (count, n), a copy.

    Raises:
        ArgumentError: they are not (n,) or (n, count).
    """
    right = np.asarray(b, float)
    if right.ndim not in (1, 2) or right.shape[0] != plan.pattern.n:
        raise ArgumentError(f"b: shape {right.shape} for {plan.pattern.n} unknowns")
    return np.array(right.T, order="C")


def scales(
    plan: Plan, rows: ArrayLike | None, columns: ArrayLike | None
) -> tuple[Reals | None, Reals | None]:
    """Units of equations and unknowns.

    Raises:
        ArgumentError: one of them is not a positive number.
    """
    scaled: list[Reals | None] = []
    for name, factors in (("rows", rows), ("columns", columns)):
        scale = None if factors is None else checked(name, factors, plan.pattern.n)
        if scale is not None and not bool((np.isfinite(scale) & (scale > 0)).all()):
            raise ArgumentError(f"{name}: units are positive numbers")
        scaled.append(scale)
    return scaled[0], scaled[1]


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
