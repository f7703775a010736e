"""The C of the sparse solver by itself: records, memory, the mode of the processor."""

from __future__ import annotations

import ctypes

import numpy as np
import pytest

from cardan.runtime.build import kernels
from cardan.runtime.sparse.block_solver import FactorsRecord, Memory, plan_record, solver
from cardan.runtime.sparse.plan import Plan, plan
from cardan.runtime.sparse.systems import Reals


def test_denormals_are_flushed_inside_only() -> None:
    """A chain along which numbers fade below the smallest normal one."""
    n = 400
    made = plan([1] * n, [np.stack([np.arange(n - 1), np.arange(1, n)], 1)])
    columns, starts = made.pattern.csr
    rows = np.repeat(np.arange(n), np.diff(starts))
    by = solver(made)
    by.factor(np.where(columns == rows, 10.0, np.where(columns < rows, 1.0, 0.0)))
    b = np.zeros(n)
    b[0] = 1.0
    x = by.solve(b)
    tiny = np.finfo(float).tiny
    assert x[:100] == pytest.approx(0.1 * (-0.1) ** np.arange(100.0), rel=1e-12)
    assert ((np.abs(x) >= tiny) | (x == 0)).all()
    assert (x[320:] == 0).all()
    # outside they are there as ever
    assert tiny / np.array([4.0]) > 0


def test_no_memory_beyond_its_own_is_touched() -> None:
    """Every array of a factorization stands between guards."""
    made = plan(
        [6, 5, 1, 7, 6, 3], [[[0, 1], [1, 3]], [[3, 4, 5]], [[2, 0, 4]]], [0, 0, 0, 0, 0, 1]
    )
    library = kernels.library()
    rng, guard = np.random.default_rng(9), -12345.0
    memory, arrays = vars(Memory.of(made)), {}
    for name, array in memory.items():
        arrays[name] = np.full(len(array) + 16, guard, array.dtype)
    starts = [array.ctypes.data + 8 * array.itemsize for array in arrays.values()]
    factors = FactorsRecord(*starts)
    factors.count = 1
    record, numbers = plan_record(made), rng.standard_normal(made.pattern.values)
    x = np.full(made.pattern.n + 16, guard)
    x[8:-8] = 1.0
    at = ctypes.c_void_p(x[8:].ctypes.data)
    where = ctypes.byref(record), ctypes.byref(factors)
    given = ctypes.c_void_p(numbers.ctypes.data)
    assert library.cardan_sparse_factor(where[0], given, where[1]) == 0
    for solve in (library.cardan_sparse_solve, library.cardan_sparse_solve_transposed):
        solve(*where, ctypes.c_ssize_t(1), at, at)
    library.cardan_sparse_smallest(*where, ctypes.c_ssize_t(2), at)
    library.cardan_sparse_work.restype = ctypes.c_ssize_t
    assert library.cardan_sparse_work(where[0]) == made.work
    for array in (*arrays.values(), x):
        assert (array[:8] == guard).all()
        assert (array[-8:] == guard).all()
    assert np.isfinite(x).all()


def test_the_library_multiplies() -> None:
    made = plan([6, 5, 3], [[[0, 1], [1, 2]]])
    rng = np.random.default_rng(10)
    numbers, x, y = rng.standard_normal(made.pattern.values), rng.standard_normal(14), np.zeros(14)
    record = plan_record(made)
    pointers = (ctypes.c_void_p(v.ctypes.data) for v in (numbers, x, y))
    kernels.library().cardan_sparse_multiply(ctypes.byref(record), *pointers)
    dense = np.zeros((14, 14))
    columns, starts = made.pattern.csr
    dense[np.repeat(np.arange(14), np.diff(starts)), columns] = numbers
    assert y == pytest.approx(dense @ x, rel=1e-13)


def _certain(made: Plan, a: Reals, b: Reals) -> tuple[float, float]:
    """The bound of the backward error of a solution, and that error with more digits."""
    n, library = made.pattern.n, kernels.library()
    columns, starts = made.pattern.csr
    rows = np.repeat(np.arange(n), np.diff(starts))
    memory = vars(Memory.of(made))
    factors = FactorsRecord(*(array.ctypes.data for array in memory.values()))
    smallest = float(np.abs(a[rows == columns]).min())
    certainty, x = np.array([0.0, smallest]), np.zeros(n)
    factors.certainty = certainty.ctypes.data
    where = ctypes.byref(plan_record(made)), ctypes.byref(factors)
    at = [ctypes.c_void_p(array.ctypes.data) for array in (a, b, x)]
    assert library.cardan_sparse_factor(where[0], at[0], where[1]) == 0
    assert factors.weak == 0
    solve = library.cardan_sparse_solve_certain
    solve.restype = ctypes.c_double
    bound = solve(*where, at[1], at[2])
    dense = np.zeros((n, n), np.longdouble)
    dense[rows, columns] = a
    missing = np.abs(b - dense @ x).max() / (np.abs(b) + np.abs(dense) @ np.abs(x)).max()
    return float(bound), float(missing)


def test_solutions_are_as_certain_as_is_said() -> None:
    """Random chains of blocks, of which those of six have code of their own."""
    rng, bounds = np.random.default_rng(3), []
    for sizes in ([6] * 40, [3] * 40, [6, 1, 6, 6, 2] * 8, [15, 6, 6, 6, 12]):
        n = len(sizes)
        made = plan(sizes, [np.stack([np.arange(n - 1), np.arange(1, n)], 1)])
        columns, starts = made.pattern.csr
        diagonal = columns == np.repeat(np.arange(made.pattern.n), np.diff(starts))
        a = rng.uniform(-1, 1, made.pattern.values) + 20 * diagonal
        bound, missing = _certain(made, a, rng.uniform(-1, 1, made.pattern.n))
        assert missing <= bound
        bounds.append(bound)
    assert max(bounds) < 1e-10


@pytest.mark.parametrize("pivot", [1e-6, 1e-9, 1e-12])
def test_factors_that_have_grown_are_not_certain(pivot: float) -> None:
    """A small pivot that stands alone in its supernode: others lose digits by it."""
    made = plan([1, 1, 1], [[[0, 1]], [[1, 2]]])
    columns, starts = made.pattern.csr
    rows = np.repeat(np.arange(3), np.diff(starts))
    a = np.where(rows == columns, 1.0, 1.3)
    a[(rows == columns) & (rows == made.order[0])] = pivot
    bound, missing = _certain(made, a, np.array([0.3, 0.7, -0.2]))
    assert missing <= bound
    assert bound > np.finfo(float).eps / pivot


def test_what_is_not_a_number_is_not_certain() -> None:
    """No maximum tells of it."""
    made = plan([6, 6], [[[0, 1]]])
    columns, starts = made.pattern.csr
    a = np.where(columns == np.repeat(np.arange(12), np.diff(starts)), 4.0, 0.5)
    b = np.ones(12)
    b[7] = np.nan
    assert _certain(made, a, b)[0] == np.inf
