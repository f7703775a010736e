"""Sine and cosine in lanes of single precision: error over the whole range, special values."""

from __future__ import annotations

import ctypes
from functools import cache

import numpy as np
import pytest

from cardan.runtime.build import single_sources
from cardan.schema import kernel_files
from codegen.running import CONTRACT, STRICT, compilers, shared
from table import each

CALL = """
#include "cardan.h"
#include "lanes.h"
void many(int n, const float *x, float *s, float *c);
void many(int n, const float *x, float *s, float *c)
{
    cardan_sincos(n / CARDAN_LANES, (const real *)x, (real *)s, (real *)c);
}
"""
RANGE, STATED = 100.0, 0.91  # ulp, in the head of sincos.h
BLOCK = 1 << 20
WAYS = [(name, lanes, kind) for name in compilers() for lanes in (4, 8, 16) for kind in (0, 1)]


@cache
def library(compiler: str, lanes: int, contracted: int) -> ctypes.CDLL:
    contract = CONTRACT[compiler] if contracted else ("-ffp-contract=off",)
    flags = ("-O2", "-march=native", "-fno-math-errno", "-DCARDAN_FLOAT", f"-DCARDAN_LANES={lanes}")
    sources = [kernel_files.file("batch.c")]
    with single_sources.written(sources, kernel_files.includes()) as (_, (folder,)):
        return shared(CALL, compiler, (*STRICT, *flags, *contract, f"-I{folder}"))


def sincos(way: tuple[str, int, int], x: np.ndarray) -> np.ndarray:
    """Sines and cosines (2, n) of a multiple of 16 floats."""
    n = len(x)
    memory = np.empty(3 * n + 16, np.float32)
    start = -memory.ctypes.data % 64 // 4
    a, s, c = memory[start : start + 3 * n].reshape(3, n)
    a[:] = x
    library(*way).many(n, *[ctypes.c_void_p(row.ctypes.data) for row in (a, s, c)])
    return np.array([s, c])


def largest_error(way: tuple[str, int, int], bits: np.ndarray) -> float:
    """Against doubles, whose own error is 2e-9 of a unit [ulp]."""
    x = bits.astype(np.uint32).view(np.float32)
    exact = np.array([f(x.astype(float)) for f in (np.sin, np.cos)])
    unit = np.spacing(np.abs(exact.astype(np.float32))).astype(float)
    return float((np.abs(sincos(way, x) - exact) / unit).max())


@each("way", WAYS)
def test_error_up_to_100(way: tuple[str, int, int]) -> None:
    top = int(np.float32(RANGE).view(np.uint32))
    bits = np.random.default_rng(5).integers(0, top + 1, 1 << 18)
    # of either sign, and the neighbors of multiples of pi/2
    multiples = (np.arange(1, int(RANGE * 2 / np.pi)) * (np.pi / 2)).astype(np.float32)
    near = (multiples.view(np.uint32)[:, None] + np.arange(-8, 9)).reshape(-1)
    near = near[: len(near) // 16 * 16]
    assert largest_error(way, bits) <= STATED
    assert largest_error(way, bits | 1 << 31) <= STATED
    assert largest_error(way, near) <= STATED


@pytest.mark.slow
def test_error_of_all_floats_up_to_100() -> None:
    way = (next(iter(compilers())), 16, 1)
    top = int(np.float32(RANGE).view(np.uint32))
    worst = 0.0
    for start in range(0, top, 64 * BLOCK):
        # every third of them, all binades
        bits = np.arange(start, min(top, start + 64 * BLOCK), 3)
        worst = max(worst, largest_error(way, bits[: len(bits) // 16 * 16]))
    assert worst <= STATED


@each("way", WAYS)
def test_special_values(way: tuple[str, int, int]) -> None:
    huge = [1e10, -1e30, 3e38, 100.0, np.nextafter(np.float32(100), np.float32(300))]
    x = np.array([0.0, -0.0, np.nan, np.inf, -np.inf, *huge, 1e-45, -1e-40, *[0.5] * 4], np.float32)
    s, c = sincos(way, x)
    assert s[:2].tobytes() == x[:2].tobytes()
    assert (c[:2] == 1).all()
    assert np.isnan([*s[2:5], *c[2:5]]).all()
    # beyond the range the mathematical library answers
    exact = np.array([f(x[5:10].astype(float)) for f in (np.sin, np.cos)])
    assert np.abs(np.array([s[5:10], c[5:10]]) - exact).max() <= 2.0**-23
    assert s[10:12].tobytes() == x[10:12].tobytes()
