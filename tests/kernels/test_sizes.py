"""Sizes that no array can have are refused before anything is read or written."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
import pytest

from cardan.analyses.simulation import run_record
from cardan.runtime.build import kernels
from cardan.runtime.calls import abi, abi_ctypes
from cardan.schema.blocks import ORDER
from cardan.schema.records import Run
from table import each

MOST = 2**63 - 1
NEVER = ctypes.CFUNCTYPE(ctypes.c_int, *[ctypes.c_void_p] * 3)


@pytest.mark.parametrize(
    ("count", "width", "stride"),
    [(2**61, 4, 0), (2**62, 1, 0), (2, MOST, 0), (2**40, 0, 2**30), (2**64 - 1, 2**64 - 1, 1)],
)
def test_map_refuses(count: int, width: int, stride: int) -> None:
    called = []

    @NEVER
    def f(*_: Any) -> int:
        called.append(1)
        return 0

    numbers, failed = np.zeros(4), ctypes.c_ssize_t(7)
    pointers = abi_ctypes.Pointers(*[numbers.ctypes.data] * abi_ctypes.SLOTS)
    strides = abi_ctypes.Strides(*[stride] * abi_ctypes.SLOTS)
    out, library = np.zeros(4), kernels.library()
    status = library.cardan_map(
        f,
        pointers,
        strides,
        ctypes.c_size_t(count),
        ctypes.c_void_p(out.ctypes.data),
        ctypes.c_size_t(width),
        None,
        ctypes.byref(failed),
    )
    assert status == -1
    assert failed.value == -1
    assert called == []
    assert not out.any()


ABSURD = [
    ("n", -1),
    ("n", 2**62),
    ("nx", -5),
    ("nq", 7),
    ("nu", -2),
    ("nz", 1),
    ("ns", -1),
    ("nr", 2**61),
    ("stages", 2**60),
    ("dense_rows", -1),
    ("capacity", 2**60),
    ("capacity", -1),
    ("time_count", 2**61),
    ("stop_count", 0),
    ("signal_count", -1),
    ("quaternion_count", 2**61),
    ("bounded_count", -1),
    ("positions", -1),
    ("rates", 2**61),
]


@each(("name", "size"), ABSURD)
def test_run_refuses(name: str, size: int) -> None:
    run = Run()
    run.n, run.nx, run.nq, run.nu, run.nr, run.stages, run.dense_rows = 4, 4, 2, 2, 1, 16, 7
    run.capacity, run.stop_count = 10, 1
    setattr(run, name, size)
    assert run_record.kernels(kernels.library()).cardan_run_start(run) == run_record.SIZE
    assert run.steps == run.evaluations == 0


@pytest.mark.skipif(abi.NAME != "cython", reason="the extension is not built here")
@pytest.mark.parametrize("size", [-1, -(2**62), 2**60, MOST])
def test_extension_refuses_absurd_work_memory(size: int) -> None:
    with pytest.raises((MemoryError, OverflowError)):
        abi.run(1, [None] * len(ORDER), [0] * len(ORDER), 0, np.zeros((0, 1)), size)


@pytest.mark.skipif(abi.NAME != "cython", reason="the extension is not built here")
def test_extension_refuses_more_states_than_rows() -> None:
    called = []

    @NEVER
    def f(*_: Any) -> int:
        called.append(1)
        return 0

    address = ctypes.cast(f, ctypes.c_void_p).value
    with pytest.raises(ValueError, match="3 states do not fit into 2 rows"):
        abi.run(address, [None] * len(ORDER), [0] * len(ORDER), 3, np.zeros((4, 1))[:2], 0)
    assert called == []
