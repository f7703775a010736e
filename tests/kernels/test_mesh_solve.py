"""Linear systems of a step by themselves: what counts as solved."""

from __future__ import annotations

import ctypes
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from cardan.build import cache as objects
from cardan.runtime.sparse.block_solver import FactorsRecord, Memory, plan_record
from cardan.runtime.sparse.plan import plan
from cardan.schema import kernel_files

# a mesh of unknowns alone, with a matrix that is given; what assembles matrices is not called
HARNESS = """
#include "mesh_matrix.h"
#include "run.h"
int solve(const cardan_sparse *plan, cardan_sparse_factors *factors, real *a, real *right,
          real *found, real *work);
int unsolved(void);
int unsolved(void) { return CARDAN_UNSOLVED; }
ptrdiff_t cardan_mesh_room(const cardan_mesh *mesh) { (void)mesh; return 0; }
int cardan_mesh_matrix(const cardan_mesh *mesh, const cardan_state *at,
                       const cardan_assembly *parts, const cardan_mesh_system *system)
{
    (void)mesh, (void)at, (void)parts, (void)system;
    return 0;
}
ptrdiff_t cardan_not_finite(const real *y, ptrdiff_t n)
{
    for (ptrdiff_t i = 0; i < n; i++)
        if (!(y[i] - y[i] == 0))
            return i;
    return -1;
}
int solve(const cardan_sparse *plan, cardan_sparse_factors *factors, real *a, real *right,
          real *found, real *work)
{
    const cardan_mesh mesh = {.nu = plan->n, .plan = plan};
    cardan_mesh_system system = {.a = a, .right = right, .solution = found, .work = work};
    system.factors = *factors;
    return cardan_mesh_solve(&mesh, &system);
}
"""


@cache
def library(folder: Path) -> ctypes.CDLL:
    """The harness with the kernels."""
    source = folder / "harness.c"
    source.write_text(HARNESS)
    names = ("mesh_solve.c", "mesh_open.c", "sparse*.c")
    needed = [path for name in names for path in sorted(kernel_files.files(name))]
    return objects.build([source, *needed], kernel_files.includes()).load()


@pytest.mark.parametrize(("wrong", "status"), [(0.0, 0), (1e-4, 0), (3.0, -1)])
def test_a_solution_that_leaves_more_than_rounding_is_none(
    wrong: float, status: int, tmp_path: Path
) -> None:
    """Factors of another matrix stand for those whose pivots have grown: what they give was taken
    for the solution."""
    made = plan([3, 2, 4], [[[0, 1], [1, 2]]])
    rng = np.random.default_rng(4)
    columns, starts = made.pattern.csr
    rows = np.repeat(np.arange(9), np.diff(starts))
    a = rng.uniform(-1, 1, made.pattern.values) + np.where(rows == columns, 8.0, 0.0)
    other = a * (1 + wrong * rng.uniform(-1, 1, len(a)))
    compiled, memory = library(tmp_path), vars(Memory.of(made))
    record = plan_record(made)
    factors = FactorsRecord(*(array.ctypes.data for array in memory.values()))
    factors.count = 1
    at = [ctypes.c_void_p(x.ctypes.data) for x in (a, other)]
    where = ctypes.byref(record), ctypes.byref(factors)
    assert compiled.cardan_sparse_factor(where[0], at[0], where[1]) == 0
    b, x, work = rng.uniform(-1, 1, 9), np.zeros(9), np.zeros(27)
    given = [ctypes.c_void_p(v.ctypes.data) for v in (b, x, work)]
    found = compiled.solve(*where, at[1], *given)
    assert found == (0 if status == 0 else compiled.unsolved())
    if status == 0:
        dense = np.zeros((9, 9))
        dense[rows, columns] = other
        np.testing.assert_allclose(x, np.linalg.solve(dense, b), rtol=1e-6, atol=1e-9)
