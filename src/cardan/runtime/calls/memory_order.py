"""Arrays of states as they lie in memory: state by state, or entry by entry."""

from __future__ import annotations

from collections.abc import Sequence
from math import prod

import numpy as np

from ...arrays import Array, Numbers
from ...errors import ArgumentError
from . import abi, abi_ctypes


def first_bad(x: Array) -> int:
    """Index of the first number, row by row, that is NaN or infinite; -1 if all are finite."""
    return abi.first_bad(x) if x.dtype == np.float64 else abi_ctypes.first_bad(x)


def by_entry(array: Array, lead: int) -> Array:
    """The same with the axes of its states, the first ones, behind those of entries."""
    return array.transpose(*range(lead, array.ndim), *range(lead))


def laid_out(array: Array, lead: tuple[int, ...], axes: int) -> tuple[Array, int, int]:
    """Numbers of an array, how far apart its states are, and the entries of a state.

    Arrays of states row by row (order "C") and entry by entry (the transpose of such, order "F")
    are taken as they are.

    Args:
        array: Of shape ``lead`` or what broadcasts to it, and so many axes of a state.
    """
    first = array.ndim - axes
    leading, trail = array.shape[:first], array.shape[first:]
    if prod(leading) == 1:
        return np.ascontiguousarray(array).reshape(-1), 0, 1
    if leading != lead:
        array = np.broadcast_to(array, lead + trail)
    if not array.flags.c_contiguous:
        entries = by_entry(array, len(lead))
        if entries.flags.c_contiguous:
            return entries.reshape(-1), 1, prod(lead)
    return np.ascontiguousarray(array).reshape(-1), prod(trail), 1


def room(
    out: object,
    lead: tuple[int, ...],
    shape: tuple[int, ...],
    dtype: Numbers,
    columns: bool,
    blocks: Sequence[Array | None],
) -> Array:
    """Array for the results (count, size): ``out`` itself if it takes them so, else a new one.

    Args:
        out: Array of shape ``lead + shape``, or anything else.
        columns: Whether a new one lies entry by entry.
        blocks: What is read meanwhile.
    """
    count, size = prod(lead), prod(shape)
    if (
        isinstance(out, np.ndarray)
        and out.dtype == dtype
        and out.shape == lead + shape
        and out.flags.behaved
        and not any(block is not None and np.may_share_memory(block, out) for block in blocks)
    ):
        if out.flags.c_contiguous:
            return out.reshape(count, size)
        entries = by_entry(out, len(lead))
        if entries.flags.c_contiguous:
            return entries.reshape(size, count).T
    return np.empty((size, count), dtype).T if columns else np.empty((count, size), dtype)


def _single(out: object, result: Array) -> str:
    """What makes results of float32, where ``out`` wants those."""
    if getattr(out, "dtype", None) != np.float32 or result.dtype != np.float64:
        return ""
    return ". Arrays of float32 alone, and compile(dtype='float32'), give float32"


def into(result: Array, out: object, where: str = "") -> Array:
    """The result, in ``out`` if that was given.

    Args:
        where: What errors begin with.

    Raises:
        ArgumentError: it is not an array of the same shape and type, must not be written to, or
            has entries that share their memory.
    """
    if out is None:
        return result
    result = np.asarray(result)
    if not isinstance(out, np.ndarray) or (out.shape, out.dtype) != (result.shape, result.dtype):
        has = f"{getattr(out, 'shape', None)} of {getattr(out, 'dtype', 'no numbers')}"
        raise ArgumentError(
            f"{where}out has shape {has}, expected {result.shape} of {result.dtype}"
            + _single(out, result)
        )
    if not out.flags.writeable:
        raise ArgumentError(f"{where}out is read-only. Give an array that can be written to")
    if any(n > 1 and stride == 0 for n, stride in zip(out.shape, out.strides, strict=True)):
        raise ArgumentError(f"{where}out has one place for several numbers. Give an array of them")
    if not np.may_share_memory(out, result):
        out[...] = result
    return out
