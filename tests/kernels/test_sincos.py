"""Our own sine and cosine: error over the whole range, special values, the same bits everywhere."""

from __future__ import annotations

import ctypes
from functools import cache

import mpmath
import numpy as np
import pytest

from codegen.running import CONTRACT, STRICT, compilers, shared
from table import each

# the two ways through cardan_sincos: one angle, several at once; and the way of lanes
SOURCE = """
#include "cardan.h"
#include "lanes.h"
void one(int n, const double *x, double *s, double *c);
void one(int n, const double *x, double *s, double *c)
{
    for (int i = 0; i < n; ++i) cardan_sincos_any(x[i], s + i, c + i);
}
void many(int n, const double *x, double *s, double *c);
void many(int n, const double *x, double *s, double *c)
{
#if CARDAN_LANES > 1
    cardan_sincos(n / CARDAN_LANES, (const real *)x, (real *)s, (real *)c);
#else
    cardan_sincos(n, x, s, c);
#endif
}
"""
RANGE = 1e5
STATED = 0.83  # ulp, in the head of sincos.h
SPEED = (*STRICT, "-O2", "-march=native", "-fno-math-errno")
WAYS = [(name, lanes, kind) for name in compilers() for lanes in (1, 2, 4, 8) for kind in (0, 1)]


@cache
def library(compiler: str, lanes: int, contracted: int) -> ctypes.CDLL:
    contract = CONTRACT[compiler] if contracted else ("-ffp-contract=off",)
    return shared(SOURCE, compiler, (*SPEED, *contract, f"-DCARDAN_LANES={lanes}"))


def sincos(way: tuple[str, int, int], function: str, x: np.ndarray) -> np.ndarray:
    """Sines and cosines, (2, n); n a multiple of 8."""
    n = len(x)
    # vectors want to be aligned
    held = np.empty(3 * n + 8)
    start = -held.ctypes.data % 64 // 8
    a, s, c = held[start : start + 3 * n].reshape(3, n)
    a[:] = x
    pointers = [ctypes.c_void_p(row.ctypes.data) for row in (a, s, c)]
    getattr(library(*way), function)(n, *pointers)
    return np.array([s, c])


def arguments(n: int) -> np.ndarray:
    """Arguments of every size up to RANGE, uniform and near all multiples of pi/2; 8 k of them."""
    rng = np.random.default_rng(3)
    uniform = rng.uniform(-RANGE, RANGE, n)
    sizes = 10.0 ** rng.uniform(-12, 5, n) * rng.choice((-1, 1), n)
    turns = rng.uniform(-np.pi, np.pi, n)
    multiples = np.arange(1, int(RANGE * 2 / np.pi)) * (np.pi / 2)
    near = np.concatenate([np.nextafter(multiples, x) for x in (0.0, np.inf)] + [multiples])
    found = np.concatenate([uniform, sizes, turns, rng.permutation(near)[:n]])
    return found[: len(found) // 8 * 8]


def ulps(found: np.ndarray, x: np.ndarray) -> tuple[float, np.ndarray]:
    """Largest error against 64-bit mantissas [ulp], and the worst arguments by it."""
    exact = np.array([f(x.astype(np.longdouble)) for f in (np.sin, np.cos)])
    error = np.abs(found - exact) / np.spacing(np.abs(exact.astype(float)))
    return float(error.max()), x[np.argsort(error.max(axis=0))[-10:]]


def check(way: tuple[str, int, int], x: np.ndarray) -> float:
    """The error of one way; the worst of it against 40 digits, which judge the judge."""
    found = sincos(way, "many", x)
    worst, where = ulps(found, x)
    with mpmath.workdps(40):
        for angle in where:
            got = sincos(way, "many", np.full(8, angle))[:, 0]
            for value, function in zip(got, (mpmath.sin, mpmath.cos), strict=True):
                exact = function(mpmath.mpf(float(angle)))
                assert abs(value - exact) <= STATED * np.spacing(abs(float(exact)))
    return worst


@each("way", WAYS)
def test_error_up_to_1e5(way: tuple[str, int, int]) -> None:
    assert check(way, arguments(20_000)) <= STATED


@pytest.mark.slow
@pytest.mark.parametrize("contracted", [0, 1])
def test_error_over_many_arguments(contracted: int) -> None:
    # 1e7 of them; all widths have the same bits, below
    x = arguments(3_300_000)
    assert len(x) >= 10_000_000
    assert check((next(iter(compilers())), 8, contracted), x) <= STATED


@pytest.mark.parametrize("compiler", sorted(compilers()))
@pytest.mark.parametrize("contracted", [0, 1])
def test_one_result_for_all_widths(compiler: str, contracted: int) -> None:
    x = np.concatenate([arguments(2_000), [1e300, -3e9, 1e5, np.nextafter(1e5, 2e5)] * 2])
    one = sincos((compiler, 1, contracted), "one", x)
    for lanes in (1, 2, 4, 8):
        assert sincos((compiler, lanes, contracted), "many", x).tobytes() == one.tobytes()


@pytest.mark.skipif(len(compilers()) < 2, reason="needs gcc and the package ziglang")
def test_one_result_for_all_compilers_without_contraction() -> None:
    x = arguments(2_000)
    first, second = (sincos((name, 8, 0), "many", x) for name in compilers())
    assert first.tobytes() == second.tobytes()


@each("way", WAYS)
def test_special_values(way: tuple[str, int, int]) -> None:
    huge = [1e22, -1e300, np.finfo(float).max]
    tiny = [5e-324, -1e-310, 1e-200]
    x = np.array([0.0, -0.0, np.nan, np.inf, -np.inf, *huge, *tiny, *[0.5] * 5])
    for function in ("one", "many"):
        s, c = sincos(way, function, x)
        assert s[:2].tobytes() == x[:2].tobytes()
        assert (c[:2] == 1).all()
        assert np.isnan([*s[2:5], *c[2:5]]).all()
        # beyond the range the mathematical library answers: at most 1 ulp
        with mpmath.workdps(700):
            for k in range(5, 8):
                exact = float(mpmath.sin(mpmath.mpf(x[k]))), float(mpmath.cos(mpmath.mpf(x[k])))
                assert abs(s[k] - exact[0]) <= np.spacing(abs(exact[0]))
                assert abs(c[k] - exact[1]) <= np.spacing(abs(exact[1]))
        assert s[8:11].tobytes() == x[8:11].tobytes()
