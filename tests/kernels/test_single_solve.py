"""Linear systems of many columns in single precision: solutions as the condition allows."""

from __future__ import annotations

import ctypes

import numpy as np

from cardan.runtime.build import single_sources
from cardan.schema import kernel_files
from cardan.schema.single_precision import single
from codegen.running import compilers, shared
from table import each

CALL = """
#include "solve.h"
int answer(int kind, int n, int m, float *a, float *b, float *scratch);
int answer(int kind, int n, int m, float *a, float *b, float *scratch)
{
    if (kind == 0) return cardan_solve_spd(n, m, a, b, scratch);
    if (kind == 1) return cardan_solve_symmetric_indefinite(n, m, a, b, scratch);
    return cardan_solve_rank_revealing(n, m, a, b, scratch);
}
"""
UNIT = 2.0**-24
# remainders of columns that vectors take two, four and eight at a time
COLUMNS = (1, 2, 3, 5, 7, 8, 15)


@each("compiler", sorted(compilers()))
def test_columns_of_floats_are_solved_each(compiler: str) -> None:
    sources = [kernel_files.file("batch.c")]
    flags = ("-std=c99", "-O2", "-DCARDAN_FLOAT")
    with single_sources.written(sources, kernel_files.includes()) as (_, (folder,)):
        (folder / "solve.h").write_text(single(kernel_files.text("solve.h")), "utf-8")
        library = shared(CALL, compiler, (*flags, f"-I{folder}"))
    rng = np.random.default_rng(11)
    for kind in range(3):
        for n in (1, 4, 7):
            A = rng.uniform(-1, 1, (n, n))
            A = A @ A.T + np.eye(n) if kind == 0 else A + A.T + 3 * np.diag((-1.0) ** np.arange(n))
            A = A.astype(np.float32).astype(float)
            for m in COLUMNS:
                B = rng.uniform(-1, 1, (n, m)).astype(np.float32)
                # a number to spare at the end, which nobody may touch
                a, b = A.astype(np.float32), np.append(B, np.float32(7)).astype(np.float32)
                scratch = np.empty(4 * n + 4, np.float32)
                places = [ctypes.c_void_p(x.ctypes.data) for x in (a, b, scratch)]
                assert library.answer(kind, n, m, *places) == 0
                exact = np.linalg.solve(A, B.astype(float))
                error = np.linalg.norm(b[:-1].reshape(n, m) - exact)
                allowed = 8 * n * UNIT * np.linalg.cond(A) * np.linalg.norm(exact)
                assert error <= allowed, (kind, n, m)
                assert b[-1] == 7
