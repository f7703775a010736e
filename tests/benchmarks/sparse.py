"""Factors and solutions of sparse matrices of blocks beside SuperLU: time, error, growth.

Times are reported, never asserted.

usage: sparse.py [structure ...]
"""

from __future__ import annotations

import ctypes
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

# made-up structures stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from rich.console import Console
from rich.table import Table
from scipy.sparse import csr_array
from scipy.sparse.linalg import splu

from cardan.build import cache
from cardan.runtime.sparse.block_solver import FactorsRecord, Memory, plan_record
from cardan.runtime.sparse.plan import Plan, plan
from cardan.runtime.sparse.systems import assembled
from cardan.schema import kernel_files
from runtime.absolute.structures import Structure, bars, grid, line

DRIVER = Path(__file__).with_name("sparse.c")
SECONDS = 0.3


def _chain(n: int) -> Plan:
    return plan([6] * n, [line(n)])


def _bodies(n: int) -> Plan:
    return Structure(n, [], bars(n)).plan()


def _ring(n: int) -> Plan:
    return plan([6] * n, [[*line(n), (n - 1, 0)]])


def _grid(n: int) -> Plan:
    side = round(n**0.5)
    return plan([6] * side**2, [grid(side)])


STRUCTURES: dict[str, tuple[Callable[[int], Plan], tuple[int, ...]]] = {
    "chain": (_chain, (10, 100, 1_000, 10_000)),
    "bodies": (_bodies, (10, 100, 1_000)),
    "ring": (_ring, (10, 100, 1_000, 10_000)),
    "grid": (_grid, (100, 1_000, 10_000)),
}


@dataclass(frozen=True)
class Row:
    """One matrix.

    Attributes:
        structure, nodes, operations: Which, and multiplications of a factorization.
        planning: Time of the plan [s].
        factor, solve: Our times [s].
        superlu_factor, superlu_solve: Those of SuperLU [s].
        error, superlu_error: Largest residual over the largest right-hand side.
    """

    structure: str
    nodes: int
    operations: int
    planning: float
    factor: float
    solve: float
    superlu_factor: float
    superlu_solve: float
    error: float
    superlu_error: float


def measured(names: list[str], most: int = 10_000) -> Iterator[Row]:
    """Rows of the structures that are asked for, up to some number of nodes."""
    sources = [DRIVER, *kernel_files.files("sparse*.c")]
    library = cache.build(sources, kernel_files.includes()).load()
    for name in names:
        make, sizes = STRUCTURES[name]
        for nodes in sizes:
            if nodes <= most:
                yield _row(library, name, nodes, make)


def _row(library: ctypes.CDLL, name: str, nodes: int, make: Callable[[int], Plan]) -> Row:
    start = time.perf_counter()
    made = make(nodes)
    planning = time.perf_counter() - start
    a, b = matrix(made), np.cos(np.arange(float(made.pattern.n)))
    factor, solve, x = _ours(library, made, a.data, b)
    csc = a.tocsc()
    theirs = splu(csc)
    limits = np.abs(b).max()
    return Row(
        name, nodes, made.operations, planning, factor, solve,
        _least(lambda: splu(csc)), _least(lambda: theirs.solve(b)),
        float(np.abs(a @ x - b).max() / limits),
        float(np.abs(a @ theirs.solve(b) - b).max() / limits),
    )  # fmt: skip


def matrix(made: Plan) -> csr_array:
    """Random numbers in the pattern, and something on the diagonals of speeds."""
    numbers = np.random.default_rng(0).standard_normal(made.pattern.values)
    columns, starts = made.pattern.csr
    numbers[columns == np.repeat(np.arange(made.pattern.n), np.diff(starts))] += 20.0
    return assembled(made, numbers)


def _ours(
    library: ctypes.CDLL, made: Plan, values: np.ndarray, b: np.ndarray
) -> tuple[float, float, np.ndarray]:
    """Times of factor and solve [s], and the solution."""
    memory = Memory.of(made)
    factors = FactorsRecord(*(array.ctypes.data for array in vars(memory).values()))
    units, x, times = np.ones(len(b)), np.zeros(len(b)), np.zeros(2)
    factors.rows = factors.columns = units.ctypes.data
    record = plan_record(made)
    rounds = max(3, min(10_000, int(SECONDS / (1e-9 * made.operations))))
    pointers = [ctypes.c_void_p(array.ctypes.data) for array in (values, b, x, times)]
    where = ctypes.byref(record), pointers[0], ctypes.byref(factors)
    assert library.sparse_times(*where, *pointers[1:3], ctypes.c_int(rounds), pointers[3]) == 0
    return float(times[0]), float(times[1]), x


def _least(call: Callable[[], object]) -> float:
    """The least time of a call [s]."""
    found, end = np.inf, time.perf_counter() + SECONDS
    while True:
        start = time.perf_counter()
        call()
        found = min(found, time.perf_counter() - start)
        if time.perf_counter() > end:
            return float(found)


def table(rows: list[Row]) -> Table:
    """For the screen; times in microseconds."""
    titles = ("structure", "nodes", "plan [ms]", "factor", "solve", "error")
    found = Table(*titles, "SuperLU factor", "solve", "error", "GFLOP/s", box=None)
    for row in rows:
        ours = (f"{1e6 * row.factor:.1f}", f"{1e6 * row.solve:.1f}", f"{row.error:.0e}")
        theirs = (f"{1e6 * row.superlu_factor:.0f}", f"{1e6 * row.superlu_solve:.0f}")
        speed = f"{2e-9 * row.operations / row.factor:.1f}"
        found.add_row(
            row.structure, f"{row.nodes:,}", f"{1e3 * row.planning:.1f}", *ours, *theirs,
            f"{row.superlu_error:.0e}", speed,
        )  # fmt: skip
    return found


if __name__ == "__main__":
    Console(width=120).print(table(list(measured(sys.argv[1:] or list(STRUCTURES)))))
