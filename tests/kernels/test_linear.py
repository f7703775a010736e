"""Dense factorizations of the implicit methods against NumPy."""

from __future__ import annotations

import ctypes
from pathlib import Path

import numpy as np
import pytest

from cardan.build import cache
from cardan.schema import kernel_files

PROGRAM = """
#include "linear.h"
int plain(ptrdiff_t n, real *a, real *order, real *b);
int paired(ptrdiff_t n, real *re, real *im, real *order, real *b, real *c);
int plain(ptrdiff_t n, real *a, real *order, real *b)
{
    int status = cardan_factor(n, a, order);
    if (status == 0) cardan_substitute(n, a, order, b);
    return status;
}
int paired(ptrdiff_t n, real *re, real *im, real *order, real *b, real *c)
{
    int status = cardan_factor_complex(n, re, im, order);
    if (status == 0) cardan_substitute_complex(n, re, im, order, b, c);
    return status;
}
"""
SHIFTED = """
#include "shift.h"
int shifted(ptrdiff_t nq, ptrdiff_t n, const real *size, const real *jacobian, real *memory,
            real *x, real *y);
int shifted(ptrdiff_t nq, ptrdiff_t n, const real *size, const real *jacobian, real *memory,
            real *x, real *y)
{
    cardan_run run = {0};
    int paired = size[1] != 0;
    cardan_shift at;
    run.nx = n, run.nq = nq;
    at = cardan_shift_in(&run, jacobian, memory, paired);
    if (cardan_shift_factor(&at, size[0], size[1])) return -1;
    cardan_shift_solve(&at, size[0], size[1], x, paired ? y : NULL);
    return (int)at.rows[0];
}
"""
EPS = float(np.finfo(float).eps)


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    path: Path = tmp_path_factory.mktemp("linear") / "linear.c"
    path.write_text(PROGRAM + SHIFTED)
    sources = [path, kernel_files.file("shift.c")]
    return ctypes.CDLL(str(cache.build(sources, kernel_files.includes()).path))


def call(function: object, n: int, *arrays: np.ndarray) -> int:
    pointers = [ctypes.c_void_p(a.ctypes.data) for a in arrays]
    return int(function(ctypes.c_ssize_t(n), *pointers))  # type: ignore[operator]


def matrices(n: int) -> list[np.ndarray]:
    """A full one, one that needs exchanges, one as of a mechanical system with small steps."""
    rng = np.random.default_rng(n)
    full = rng.normal(size=(n, n))
    without = full - np.diag(np.diag(full)) if n > 1 else full
    half = n // 2
    blocks = 1e5 * np.eye(n)
    blocks[:half, half : 2 * half] = -np.eye(half)
    blocks[half:, :half] = 1e12 * rng.normal(size=(n - half, half))
    return [full, without, blocks]


@pytest.mark.parametrize("n", [0, 1, 2, 3, 8, 21])
def test_real(library: ctypes.CDLL, n: int) -> None:
    for a in matrices(n):
        b = np.random.default_rng(7).normal(size=n)
        x, order = b.copy(), np.zeros(n)
        assert call(library.plain, n, a.copy(), order, x) == 0
        # backward stable, with some growth
        size = np.abs(a).sum(axis=1).max(initial=0.0) * np.abs(x).max(initial=0.0)
        assert np.abs(a @ x - b).max(initial=0.0) <= 20 * EPS * (n + 1) * size


@pytest.mark.parametrize("n", [0, 1, 2, 3, 8, 21])
def test_complex(library: ctypes.CDLL, n: int) -> None:
    for a in matrices(n):
        rng = np.random.default_rng(7)
        imaginary = rng.normal(size=(n, n))
        b = rng.normal(size=n) + 1j * rng.normal(size=n)
        x, y, order = b.real.copy(), b.imag.copy(), np.zeros(n)
        assert call(library.paired, n, a.copy(), imaginary.copy(), order, x, y) == 0
        whole, z = a + 1j * imaginary, x + 1j * y
        size = np.abs(whole).sum(axis=1).max(initial=0.0) * np.abs(z).max(initial=0.0)
        assert np.abs(whole @ z - b).max(initial=0.0) <= 20 * EPS * (n + 1) * size


@pytest.mark.parametrize("bad", [0.0, np.nan, np.inf])
def test_no_factors(library: ctypes.CDLL, bad: float) -> None:
    a, rest = np.eye(3), [np.zeros(3) for _ in range(3)]
    a[1, 1] = bad
    assert call(library.plain, 3, a.copy(), rest[0], rest[1]) != 0
    assert call(library.paired, 3, a.copy(), np.zeros((3, 3)), *rest) != 0


def jacobians() -> dict[str, tuple[np.ndarray, int, int]]:
    """Of a state whose first entries are coordinates: J, how many, and how many rows are kept."""
    rng = np.random.default_rng(3)
    plain = np.zeros((8, 8))
    plain[:4, 4:] = np.eye(4)
    plain[4:] = 1e6 * rng.normal(size=(4, 8))
    # a coordinate that moves as a sum of speeds, one that nothing moves, one that moves itself
    mixed = plain.copy()
    mixed[0, 5], mixed[1], mixed[2, 2] = 0.5, 0.0, -3.0
    geared = plain.copy()
    geared[3] = 0.0
    geared[3, 4] = -2.5
    full = rng.normal(size=(5, 5))
    return {
        "plain": (plain, 4, 4),
        "mixed": (mixed, 4, 7),
        "geared": (geared, 4, 4),
        "full": (full, 2, 5),
        "no speeds": (full, 5, 5),
        "nothing": (np.zeros((0, 0)), 0, 0),
    }


@pytest.mark.parametrize("name", jacobians())
@pytest.mark.parametrize("size", [(37.0, 0.0), (-2.0, 0.0), (26.0, 30.0)])
def test_shifted(library: ctypes.CDLL, name: str, size: tuple[float, float]) -> None:
    jacobian, nq, kept = jacobians()[name]
    n = len(jacobian)
    rng = np.random.default_rng(5)
    b, c = rng.normal(size=(2, n))
    whole, right = complex(*size) * np.eye(n) - jacobian, b + 1j * c
    memory, x, y = np.zeros(1 + n * (5 + 2 * n)), b.copy(), c.copy()
    shifted = library.shifted
    shifted.argtypes = [ctypes.c_ssize_t, ctypes.c_ssize_t, *[ctypes.c_void_p] * 5]
    arrays = [np.array(size), np.ascontiguousarray(jacobian), memory, x, y]
    assert shifted(nq, n, *(a.ctypes.data for a in arrays)) == kept
    if not size[1]:
        y[:], right = 0.0, b
    z = x + 1j * y
    scale = np.abs(whole).sum(axis=1).max(initial=0.0) * np.abs(z).max(initial=0.0)
    assert np.abs(whole @ z - right).max(initial=0.0) <= 100 * EPS * (n + 1) * scale
