"""Sparse linear systems of blocks by the SuperLU of SciPy, where there is no compiler."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import csr_array, diags_array
from scipy.sparse.linalg import splu

from ...errors import ArgumentError, SolveError
from .plan import Plan
from .solver import (
    ENOUGH,
    Reals,
    assembled,
    checked,
    guess,
    refused,
    scales,
    sides,
)

STEPS = 10
NOISE = 1e-14
REPLACEMENT = 1e-10
DENSE = 3000


class SuperluSolver:
    """A :class:`~cardan.runtime.absolute.solver.Solver` by SuperLU.

    Where the matrix is singular to rounding, multipliers get a small negative diagonal.

    Attributes:
        plan: The plan.
    """

    def __init__(self, plan: Plan) -> None:
        self.plan: Final = plan
        self._lu: Any = None
        self._matrix: csr_array | None = None
        self._rows = self._columns = np.ones(plan.pattern.n)
        self._shift = np.zeros(plan.pattern.n)
        self._symmetric = False

    def factor(
        self,
        values: ArrayLike,
        rows: ArrayLike | None = None,
        columns: ArrayLike | None = None,
        symmetric: bool = False,
    ) -> None:
        """See :meth:`Solver.factor`."""
        n = self.plan.pattern.n
        given = checked("values", values, self.plan.pattern.values)
        self._lu = self._matrix = None
        scale = scales(self.plan, rows, columns)
        self._rows, self._columns = (np.ones(n) if x is None else x for x in scale)
        self._symmetric, self._shift = symmetric, np.zeros(n)
        if not np.isfinite(given).all():
            raise refused(self.plan, given, -1)
        matrix = assembled(self.plan, given)
        if n:
            self._lu = self._factored(given, self._scaled(matrix))
        self._matrix = matrix

    def _factored(self, given: Reals, scaled: Any) -> Any:
        """Factors, with something on the diagonals of multipliers where there is no other way."""
        empty = np.flatnonzero(abs(scaled).sum(axis=0) == 0)
        if len(empty):
            raise refused(self.plan, given, int(empty[0]))
        lu = _splu(scaled)
        if lu is not None and not self._noisy(lu).any():
            return lu
        lam = np.repeat(self.plan.pattern.multiplier, self.plan.pattern.sizes)
        self._shift = np.where(lam, -REPLACEMENT * abs(scaled).max(), 0)
        shifted = _splu(scaled + diags_array(self._shift))
        if shifted is None:
            raise refused(self.plan, given, -1)
        noisy = self._noisy(shifted)
        self._shift[noisy] = shifted.U.diagonal()[shifted.perm_c][noisy]
        return shifted

    def _noisy(self, lu: Any) -> NDArray[np.bool_]:
        """Which unknowns have pivots lost in rounding (n,)."""
        upper = abs(lu.U)
        most = upper.max(axis=0).toarray().reshape(-1)
        return np.asarray((upper.diagonal() <= NOISE * most)[lu.perm_c])

    def _scaled(self, matrix: csr_array) -> Any:
        return (diags_array(self._rows) @ matrix @ diags_array(self._columns)).tocsc()

    def solve(self, b: ArrayLike, transposed: bool = False) -> Reals:
        """See :meth:`Solver.solve`."""
        self._ready()
        x = sides(self.plan, b).T
        if self._lu is None:
            return x
        into, out = (self._rows, self._columns)[:: -1 if transposed else 1]
        shaped = (-1, *(1,) * (x.ndim - 1))
        found = self._lu.solve(into.reshape(shaped) * x, "T" if transposed else "N")
        return np.asarray(out.reshape(shaped) * found)

    def refine(self, b: ArrayLike, x: ArrayLike, enough: float = ENOUGH) -> tuple[Reals, float]:
        """See :meth:`Solver.refine`."""
        n = self.plan.pattern.n
        given, best = checked("b", b, n), checked("x", x, n).copy()
        error, r = self._residual(given, best)
        for _ in range(STEPS):
            if not error > enough:
                break
            better = best + self.solve(r)
            next_error, next_r = self._residual(given, better)
            if not next_error < error:
                break
            best, error, r = better, next_error, next_r
        return best, error

    def _residual(self, b: Reals, x: Reals) -> tuple[float, Reals]:
        matrix = self._ready()
        r = b - matrix @ x
        if not np.isfinite(r).all():
            return np.inf, r
        size = self._rows * (abs(matrix) @ np.abs(x) + np.abs(b))
        most = float(np.abs(self._rows * r).max(initial=0))
        return (most / float(size.max()) if most else 0.0), r

    def determinant(self) -> tuple[float, float]:
        """See :meth:`Solver.determinant`."""
        self._ready()
        if self._lu is None:
            return 1.0, 0.0
        diagonal = self._lu.U.diagonal()
        sign = np.prod(np.sign(diagonal)) * _parity(self._lu.perm_r) * _parity(self._lu.perm_c)
        units = np.log(self._rows).sum() + np.log(self._columns).sum()
        return float(sign), float(np.log(np.abs(diagonal)).sum() - units)

    def inertia(self) -> tuple[int, int, int]:
        """See :meth:`Solver.inertia`.

        Raises:
            ArgumentError: signs were not asked for, or the matrix is too large without a compiler.
        """
        matrix = self._ready()
        if not self._symmetric:
            raise ArgumentError("signs were not counted: factor(values, symmetric=True)")
        n = self.plan.pattern.n
        if n > DENSE:
            raise ArgumentError(
                f"signs of {n} eigenvalues are counted with a C compiler only, at most {DENSE} "
                "without. pip install 'cardan[compiler]'"
            )
        values = np.linalg.eigvalsh(self._scaled(matrix).toarray()) if n else np.zeros(0)
        noise = NOISE * n * np.abs(values).max(initial=0)
        positive, negative = int((values > noise).sum()), int((values < -noise).sum())
        return positive, negative, n - positive - negative

    def smallest(self, steps: int = 4) -> tuple[float, Reals]:
        """See :meth:`Solver.smallest`."""
        self._ready()
        x, grown = guess(self.plan.pattern.n), 0.0
        for _ in range(steps if self._lu is not None else 0):
            for way in ("T", "N"):
                x = self._lu.solve(x / np.linalg.norm(x), way)
            grown = float(np.linalg.norm(x))
            x /= grown
        return (1 / grown if grown else 0.0), x * self._columns

    @property
    def weak(self) -> NDArray[np.int32]:
        """See :attr:`Solver.weak`."""
        self._ready()
        return np.flatnonzero(self._shift).astype(np.int32)

    @property
    def shifts(self) -> Reals:
        """See :attr:`Solver.shifts`."""
        return self._shift[self.weak]

    def carried(self, b: ArrayLike, x: ArrayLike) -> tuple[float, int]:
        """See :meth:`Solver.carried`."""
        n = self.plan.pattern.n
        given, found = checked("b", b, n), checked("x", x, n)
        own = np.abs(self._shift * found / self._columns)
        if not own.any():
            return 0.0, -1
        return float(own.max() / np.abs(self._rows * given).max()), int(own.argmax())

    def _ready(self) -> csr_array:
        if self._matrix is None:
            raise SolveError("there are no factors: call factor first")
        return self._matrix


def _splu(matrix: Any) -> Any:
    """Factors, None where a pivot is exactly zero."""
    try:
        return splu(matrix)
    except RuntimeError:
        return None


def _parity(order: NDArray[Any]) -> int:
    """The sign of a permutation."""
    seen, sign = np.zeros(len(order), bool), 1
    for start in range(len(order)):
        at = start
        while not seen[at]:
            seen[at] = True
            at = order[at]
            sign = -sign if at != start else sign
    return sign
