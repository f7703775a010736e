"""Call generated functions through ctypes: the same interface as the extension ``_abi``.

Used where the extension was not built. A batch runs in the C loop of the kernels library, so
results are the same to the bit; only the overhead of a call is larger.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array, on_lines
from ...schema.blocks import ORDER
from ...schema.c_functions import FunctionRow
from ..build import kernels

if TYPE_CHECKING:
    from .calling import Caller

NAME = "ctypes"
SLOTS = len(ORDER)
Pointers = ctypes.c_void_p * SLOTS
Strides = ctypes.c_size_t * SLOTS
# what asks a text for its sizes, which stand before those of its blocks
LOADED = ("-DCARDAN_LOADED",)
SIZES = ("output_size", "work_size", "prepared_size")
FUNCTION = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p)
PREPARE = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p)


@lru_cache(maxsize=256)
def _function(address: int) -> Callable[..., int]:
    return FUNCTION(address)


def run(
    address: int,
    blocks: Sequence[Array | None],
    strides: Sequence[int],
    count: int,
    out: Array,
    work_size: int,
) -> tuple[int, int]:
    """Call a function at ``count`` states.

    Args:
        address: The C function.
        blocks: Arrays in the order of cardan_in, float64; only where they start matters.
        strides: Numbers from one state to the next, 0 for a block all states share.
        out: (count, output size), C-contiguous.
        work_size: Numbers of work memory; it begins where vectors of any length may.

    Returns:
        (first status that is not 0, index of that state or -1).
    """
    pointers = Pointers(*(None if b is None else b.ctypes.data for b in blocks))
    work = on_lines(work_size)
    if count == 1:
        status = _function(address)(ctypes.addressof(pointers), out.ctypes.data, work.ctypes.data)
        return status, 0 if status else -1
    failed = ctypes.c_ssize_t(-1)
    status = kernels.library().cardan_map(
        ctypes.c_void_p(address),
        pointers,
        Strides(*strides),
        ctypes.c_size_t(count),
        ctypes.c_void_p(out.ctypes.data),
        ctypes.c_size_t(out.strides[0] // 8),
        ctypes.c_void_p(work.ctypes.data),
        ctypes.byref(failed),
    )
    return status, failed.value


def prepare(address: int, p: Array, w: Array) -> None:
    """Call a ``prepare_`` function for every row of p, (count, np) -> (count, nw)."""
    function = PREPARE(address)
    for row, result in zip(p, w, strict=True):
        function(row.ctypes.data, result.ctypes.data)


def first_bad(x: Array) -> int:
    """Flat index of the first entry that is NaN or infinite, -1 if all are finite."""
    finite = np.isfinite(x).reshape(-1)
    return -1 if finite.all() else int(np.argmin(finite))


def fast(caller: Caller) -> Caller:
    """The quickest way to call one function for one state; here: the general one."""
    return caller


def block_sizes(library: ctypes.CDLL, symbol: str, entry: FunctionRow) -> dict[str, int]:
    """Sizes of the blocks that a function reads, from its object.

    Raises:
        ValueError: those of its results differ from the manifest, or other blocks are read.
    """
    kind = ctypes.c_int * (len(SIZES) + len(ORDER))
    try:
        numbers = list(kind.in_dll(library, f"{symbol}_sizes"))
    except ValueError:
        raise ValueError(f"the sizes of {symbol} do not stand in it") from None
    for name, size in zip(SIZES, numbers, strict=False):
        if getattr(entry, name) != size:
            raise ValueError(f"{name} of {symbol} is {size}, not {getattr(entry, name)}")
    blocks = dict(zip(ORDER, numbers[len(SIZES) :], strict=True))
    unsaid = [name for name, size in blocks.items() if size and name not in (*entry.inputs, "p")]
    if unsaid:
        raise ValueError(f"{symbol} reads {', '.join(unsaid)} too")
    return blocks
