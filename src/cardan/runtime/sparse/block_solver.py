"""Block elimination with pivots inside blocks: the C of ``kernels/sparse/sparse.h`` for Python."""

from __future__ import annotations

import ctypes
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...errors import ArgumentError, SolveError
from ...records import dataclass
from ...schema.records import FactorsRecord, PlanRecord
from ..build import kernels
from .plan import Plan
from .systems import Reals, checked, guess, named, refused, scales, sides

STEPS = 10
ENOUGH = 1e-14
GOOD = 1e-9
MAX_PERTURBATION = 1e-3
NUMBERS = ("n", "blocks", "values", "supernodes", "factors", "widest")
MATRIX = ("first", "row", "column", "at", "stride")
ELIMINATION = (
    *("order", "multiplier", "start", "panel", "later", "open_start", "open"),
    *("load_start", "load", "run_start", "run", "target_start", "target"),
)


def plan_fields(plan: Plan) -> dict[str, int | NDArray[np.int32]]:
    """The fields of ``cardan_sparse``."""
    matrix = plan.pattern
    sizes = (matrix.n, len(matrix.sizes), matrix.values, len(plan.later), plan.factors)
    tables = {name: getattr(matrix, name) for name in MATRIX}
    tables |= {name: getattr(plan, name) for name in ELIMINATION}
    return dict(zip(NUMBERS, (*sizes, plan.widest), strict=True)) | tables


def plan_record(plan: Plan) -> PlanRecord:
    """A plan as C sees it; the plan must outlive it."""
    fields = plan_fields(plan).items()
    return PlanRecord(**{k: v if isinstance(v, int) else v.ctypes.data for k, v in fields})


@dataclass(frozen=True)
class Memory:
    """Memory of a factorization, in the order of ``cardan_sparse_factors``."""

    values: Reals
    scale: Reals
    work: Reals
    shift: Reals
    pivot: NDArray[np.int32]
    exchanged: NDArray[np.int32]
    replaced: NDArray[np.int32]

    @staticmethod
    def of(plan: Plan) -> Memory:
        """Memory of the sizes that a plan asks for."""
        n = plan.pattern.n
        values, scale, work, shift = (np.zeros(size) for size in (plan.factors, n, plan.work, n))
        return Memory(values, scale, work, shift, *(np.zeros(n, np.int32) for _ in range(3)))


class BlockSolver:
    """One factorization at a time.

    Vectors are in the order of the unknowns of the pattern, values as the pattern has them.

    Attributes:
        plan: The plan.
        library: The kernels.
    """

    def __init__(self, plan: Plan, library: ctypes.CDLL) -> None:
        self.plan: Final = plan
        self.library: Final = library
        self._record = plan_record(plan)
        self._memory = Memory.of(plan)
        self._factors = FactorsRecord(*(x.ctypes.data for x in vars(self._memory).values()))
        self._values: Reals | None = None
        self._scales: tuple[Reals | None, Reals | None] = (None, None)

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
            rows: Factors by which the equations are scaled (n,), 1 by default.
            columns: Factors of the unknowns (n,): x = columns * unknown solved for; 1 by default.
            symmetric: Whether to count the signs of its eigenvalues; rows are as columns then.

        Raises:
            SolveError: an unknown or an equation is empty, or numbers are not finite.
        """
        array = checked("values", values, self.plan.pattern.values)
        self._values = None
        self._scales = scales(self.plan, rows, columns)
        self._factors.rows, self._factors.columns = (
            None if scale is None else scale.ctypes.data for scale in self._scales
        )
        self._factors.count = symmetric
        if self._call("factor", ctypes.c_int, array, ctypes.byref(self._factors)):
            raise refused(self.plan, array, self._factors.singular)
        self._values = array

    def solve(self, b: ArrayLike, transposed: bool = False) -> Reals:
        """x of a x = b for one right-hand side (n,) or several (n, count)."""
        self._ready()
        x = sides(self.plan, b)
        count = ctypes.c_ssize_t(x.size // max(self.plan.pattern.n, 1))
        name = "solve_transposed" if transposed else "solve"
        self._call(name, None, ctypes.byref(self._factors), count, x, x)
        return x.T

    def refine(self, b: ArrayLike, x: ArrayLike, enough: float = ENOUGH) -> tuple[Reals, float]:
        """A better solution (n,) and its backward error, see ``cardan_sparse_refine``."""
        values, n = self._ready(), self.plan.pattern.n
        right, better, room = checked("b", b, n), checked("x", x, n).copy(), np.zeros(2 * n)
        limits = ctypes.c_double(enough), ctypes.c_ssize_t(STEPS)
        factors = ctypes.byref(self._factors)
        error = self._call("refine", ctypes.c_double, factors, values, right, *limits, better, room)
        return better, float(error)

    def determinant(self) -> tuple[float, float]:
        """The sign of the determinant and the logarithm of its size."""
        self._ready()
        sign, factors = ctypes.c_double(), ctypes.byref(self._factors)
        size = self._call("determinant", ctypes.c_double, factors, ctypes.byref(sign))
        return sign.value, float(size)

    def inertia(self) -> tuple[int, int, int]:
        """Number of eigenvalues that are positive, negative, zero to rounding."""
        self._ready()
        if not self._factors.count:
            raise ArgumentError("signs were not counted: factor(values, symmetric=True)")
        positive, negative = self._factors.positive, self._factors.negative
        return positive, negative, self.plan.pattern.n - positive - negative

    def smallest(self, steps: int = 4) -> tuple[float, Reals]:
        """Estimate of the smallest singular value in units, and its unknowns (n,), not in units."""
        self._ready()
        x, factors = guess(self.plan.pattern.n), ctypes.byref(self._factors)
        least = self._call("smallest", ctypes.c_double, factors, ctypes.c_ssize_t(steps), x)
        columns = self._scales[1]
        return float(least), x if columns is None else x * columns

    @property
    def weak(self) -> NDArray[np.int32]:
        """The unknowns on whose diagonal something was added.

        Those whose pivots were lost in rounding; if multipliers are among them, all rows that
        close loops.
        """
        self._ready()
        return self.plan.order[self._memory.replaced[: self._factors.weak]]

    @property
    def shifts(self) -> Reals:
        """What was added there, in units."""
        self._ready()
        return self._memory.shift[: self._factors.weak]

    def perturbation(self, b: ArrayLike, x: ArrayLike) -> tuple[float, int]:
        """Share of b that what was added takes, and the unknown.

        See ``cardan_sparse_perturbation``.
        """
        self._ready()
        n, unknown = self.plan.pattern.n, ctypes.c_int32()
        right, solution = checked("b", b, n), checked("x", x, n)
        factors = ctypes.byref(self._factors)
        part = self._call(
            "perturbation", ctypes.c_double, factors, right, solution, ctypes.byref(unknown)
        )
        return float(part), unknown.value

    def _ready(self) -> Reals:
        if self._values is None:
            raise SolveError("there are no factors: call factor first")
        return self._values

    def _call(self, name: str, answer: object, *arguments: object) -> Any:
        """Call a function of the kernels; arrays go as pointers."""
        function = getattr(self.library, f"cardan_sparse_{name}")
        function.restype = answer
        addresses = (
            ctypes.c_void_p(x.ctypes.data) if isinstance(x, np.ndarray) else x for x in arguments
        )
        return function(ctypes.byref(self._record), *addresses)


def solver(plan: Plan, reproducible: bool = False) -> BlockSolver:
    """A solver for matrices of a plan."""
    return BlockSolver(plan, kernels.library(reproducible))


def solution(by: BlockSolver, b: ArrayLike) -> Reals:
    """x of a x = b (n,), refined where pivots were replaced.

    Raises:
        SolveError: the matrix is singular and b does not fit it; the message names the block.
    """
    x = by.solve(b)
    if not len(by.weak):
        return x
    x, error = by.refine(b, x)
    perturbation, unknown = by.perturbation(b, x)
    if perturbation <= MAX_PERTURBATION and error <= GOOD:
        return x
    raise SolveError(
        f"the matrix is singular: nothing but rounding holds {named(by.plan, unknown)}"
        f" (backward error {error:.1e})"
    )
