"""Sparse linear systems of blocks, solved by the C of ``kernels/sparse.h``."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any, Final, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import csr_array

from ...errors import ArgumentError, CompilerMissing, SolveError
from .. import kernels
from .plan import Plan

Reals = NDArray[np.float64]
ENOUGH, STEPS = 1e-14, 10
NUMBERS = ("n", "blocks", "values", "supernodes", "factors", "widest")
MATRIX = ("first", "row", "column", "at", "stride")
ELIMINATION = (
    *("order", "multiplier", "start", "panel", "width", "later", "turned", "open_start", "open"),
    *("load_start", "load", "run_start", "run", "target_start", "target"),
)
POINTER = ctypes.c_void_p


class PlanRecord(ctypes.Structure):
    """``cardan_sparse``."""

    _fields_ = [
        *((name, ctypes.c_ssize_t) for name in NUMBERS),
        *((name, POINTER) for name in (*MATRIX, *ELIMINATION)),
    ]


class FactorsRecord(ctypes.Structure):
    """``cardan_sparse_factors``."""

    _fields_ = [
        *((name, POINTER) for name in ("values", "scale", "work", "shift", "pivot", "replaced")),
        *((name, POINTER) for name in ("rows", "columns")),
        *((name, ctypes.c_int32) for name in ("count", "weak", "singular", "positive", "negative")),
    ]


def plan_record(plan: Plan) -> PlanRecord:
    """A plan as C sees it; the plan must outlive it."""
    matrix = plan.pattern
    numbers = (matrix.n, len(matrix.sizes), matrix.values, len(plan.later), plan.factors)
    tables = [getattr(matrix, name) for name in MATRIX]
    tables += [getattr(plan, name) for name in ELIMINATION]
    return PlanRecord(*numbers, plan.widest, *(table.ctypes.data for table in tables))


class Solver(Protocol):
    """What both ways to solve offer; one object holds one factorization at a time.

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


def solver(plan: Plan, reproducible: bool = False) -> Solver:
    """The best way to solve here: in C, by SuperLU where there is no compiler."""
    from .superlu import SuperluSolver

    try:
        return BlockSolver(plan, kernels.library(reproducible, only="sparse*"))
    except CompilerMissing:
        return SuperluSolver(plan)


def assembled(plan: Plan, values: ArrayLike) -> csr_array:
    """The matrix of SciPy with these values (not copied if they are float64)."""
    matrix = plan.pattern
    columns, starts = matrix.csr
    return csr_array((np.asarray(values, float), columns, starts), shape=(matrix.n, matrix.n))


@dataclass
class _Memory:
    """What a factorization is kept in."""

    values: Reals
    scale: Reals
    work: Reals
    shift: Reals
    pivot: NDArray[np.int32]
    replaced: NDArray[np.int32]

    @staticmethod
    def of(plan: Plan) -> _Memory:
        n = plan.pattern.n
        reals = [np.zeros(size) for size in (plan.factors, n, plan.work, n)]
        return _Memory(*reals, np.zeros(n, np.int32), np.zeros(n, np.int32))


class BlockSolver:
    """Block elimination with pivots inside blocks; see :class:`Solver`.

    Attributes:
        plan: The plan.
        library: The kernels.
    """

    def __init__(self, plan: Plan, library: ctypes.CDLL) -> None:
        self.plan: Final = plan
        self.library: Final = library
        self._record = plan_record(plan)
        self._memory = _Memory.of(plan)
        self._factors = FactorsRecord(*(x.ctypes.data for x in vars(self._memory).values()))
        self._values: Reals | None = None
        self._scales: tuple[Reals | None, Reals | None] = (None, None)
        for name in ("refine", "determinant", "smallest"):
            getattr(library, f"cardan_sparse_{name}").restype = ctypes.c_double

    def factor(
        self,
        values: ArrayLike,
        rows: ArrayLike | None = None,
        columns: ArrayLike | None = None,
        symmetric: bool = False,
    ) -> None:
        """See :meth:`Solver.factor`."""
        given = checked("values", values, self.plan.pattern.values)
        self._values = None
        self._scales = scales(self.plan, rows, columns)
        self._factors.rows, self._factors.columns = (
            None if scale is None else scale.ctypes.data for scale in self._scales
        )
        self._factors.count = symmetric
        if self._call("factor", given.ctypes.data, ctypes.byref(self._factors)):
            raise SolveError(singular(self.plan, self._factors.singular))
        self._values = given

    def solve(self, b: ArrayLike, transposed: bool = False) -> Reals:
        """See :meth:`Solver.solve`."""
        self._ready()
        given = np.asarray(b, float)
        # right-hand sides one behind the other
        x = np.array(given.T, order="C")
        if given.ndim not in (1, 2) or given.shape[0] != self.plan.pattern.n:
            raise ArgumentError(f"b: shape {given.shape} for {self.plan.pattern.n} unknowns")
        count = ctypes.c_ssize_t(x.size // max(self.plan.pattern.n, 1))
        name = "solve_turned" if transposed else "solve"
        at = POINTER(x.ctypes.data)
        self._call(name, ctypes.byref(self._factors), count, at, at)
        return x.T

    def refine(self, b: ArrayLike, x: ArrayLike, enough: float = ENOUGH) -> tuple[Reals, float]:
        """See :meth:`Solver.refine`."""
        values, n = self._ready(), self.plan.pattern.n
        given, better = checked("b", b, n), checked("x", x, n).copy()
        room = np.zeros(2 * n)
        error = self._call(
            "refine",
            ctypes.byref(self._factors),
            *(POINTER(array.ctypes.data) for array in (values, given)),
            ctypes.c_double(enough),
            ctypes.c_ssize_t(STEPS),
            *(POINTER(array.ctypes.data) for array in (better, room)),
        )
        return better, float(error)

    def determinant(self) -> tuple[float, float]:
        """See :meth:`Solver.determinant`."""
        self._ready()
        sign = ctypes.c_double()
        size = self._call("determinant", ctypes.byref(self._factors), ctypes.byref(sign))
        return sign.value, float(size)

    def inertia(self) -> tuple[int, int, int]:
        """See :meth:`Solver.inertia`."""
        self._ready()
        if not self._factors.count:
            raise ArgumentError("signs were not counted: factor(values, symmetric=True)")
        positive, negative = self._factors.positive, self._factors.negative
        return positive, negative, self.plan.pattern.n - positive - negative

    def smallest(self, steps: int = 4) -> tuple[float, Reals]:
        """See :meth:`Solver.smallest`."""
        self._ready()
        x = guess(self.plan.pattern.n)
        least = self._call(
            "smallest", ctypes.byref(self._factors), ctypes.c_ssize_t(steps), POINTER(x.ctypes.data)
        )
        columns = self._scales[1]
        return float(least), x if columns is None else x * columns

    @property
    def weak(self) -> NDArray[np.int32]:
        """The unknowns whose pivots were lost in rounding and replaced."""
        self._ready()
        return self.plan.order[self._memory.replaced[: self._factors.weak]]

    def _ready(self) -> Reals:
        if self._values is None:
            raise SolveError("there are no factors: call factor first")
        return self._values

    def _call(self, name: str, *arguments: Any) -> Any:
        function = getattr(self.library, f"cardan_sparse_{name}")
        first = (POINTER(arguments[0]) if isinstance(arguments[0], int) else arguments[0],)
        return function(ctypes.byref(self._record), *first, *arguments[1:])


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


def singular(plan: Plan, unknown: int) -> str:
    """What is wrong, by the number of the unknown."""
    matrix = plan.pattern
    block = matrix.block_of(unknown)
    kind = "multiplier" if matrix.multiplier[block] else "speed"
    return (
        f"the matrix is singular or not finite at {kind} {unknown - matrix.first[block]} of block "
        f"{block}: no equation holds it"
    )
