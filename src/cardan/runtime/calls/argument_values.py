"""Arguments of users as arrays; what single precision cannot hold is refused by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ...arrays import Array, Numbers
from ...errors import ArgumentError, ModelError, near

if TYPE_CHECKING:
    from .calling import Argument

RANGE = np.finfo(np.float32)
CURE = "Give arrays of float64, or choose other units"
# parameters by name and value that a prepared one, by its place, is computed from
Sources = Callable[[int], dict[str, float]]


def numbers(where: str, value: object, dtype: Numbers = np.float64) -> Array:
    """A value as an array of float64, or float32, in the order in memory that it has.

    Raises:
        ArgumentError: it holds other things than real numbers, masked ones, rows of different
            lengths, or what single precision cannot hold.
    """
    try:
        array = np.asarray(value)
    except ValueError:
        raise ArgumentError(f"{where}: its rows have different lengths") from None
    # NumPy leaves out the mask in silence
    plain = type(value) is np.ndarray or not isinstance(value, np.ndarray)
    if not plain and np.any(getattr(value, "mask", False)):
        raise ArgumentError(f"{where} has masked entries. Fill them: .filled(number)")
    if array.dtype.kind not in "fiub":
        raise ArgumentError(f"{where} must be real numbers, not {array.dtype}")
    return converted(where, array, dtype)


def common(where: str, shapes: Mapping[str, tuple[int, ...]]) -> tuple[int, ...]:
    """The leading axes that several arguments broadcast to.

    Raises:
        ArgumentError: there are none.
    """
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        text = ", ".join(f"{name} {shape}" for name, shape in shapes.items() if shape)
        raise ArgumentError(f"{where}: leading axes do not broadcast together: {text}") from None


def by_name(where: str, argument: Argument, values: Mapping[str, ArrayLike]) -> Array:
    """A vector from named values, the rest as it starts.

    Args:
        where: Function and argument, for errors.
        values: Name -> number (...), or the name of a joint -> all its numbers (..., n).

    Raises:
        ModelError: an unknown name, with near ones.
    """
    lead: tuple[int, ...] = ()
    read: dict[str, Array] = {}
    for name, entry_value in values.items():
        if name not in argument.places:
            raise ModelError(f"{where}: '{name}' does not exist.{near(name, argument.places)}")
        value, place = numbers(f"{where}: '{name}'", entry_value), argument.places[name]
        size = place.stop - place.start
        if size == 1:
            value = value[..., None]
        elif value.ndim == 0 or value.shape[-1] != size:
            raise ArgumentError(
                f"{where}: '{name}' has shape {value.shape}, expected (..., {size}): "
                f"{', '.join(argument.entries[place])}"
            )
        read[name] = value
        lead = common(where, {"the others": lead, f"'{name}'": value.shape[:-1]})
    result: Array = np.broadcast_to(
        np.zeros(argument.size) if argument.start is None else argument.start,
        (*lead, argument.size),
    ).copy()
    for name, value in read.items():
        result[..., argument.places[name]] = value
    return result


def converted(where: str, value: ArrayLike, dtype: Numbers) -> Array:
    """A value as an array of a type.

    Raises:
        ArgumentError: a finite number is infinite in single precision.
    """
    if dtype == np.float64:
        return np.asarray(value, dtype=dtype)
    with np.errstate(over="ignore"):
        result = np.asarray(value, dtype=dtype)
    if result is not value:
        numbers = np.asarray(value)
        lost = np.isinf(result) & np.isfinite(numbers)
        if lost.any():
            raise ArgumentError(
                f"{where}: {numbers[lost][0]:g} is more than the {RANGE.max:.1e} that single "
                f"precision can hold. {CURE}"
            )
    return result


def prepared(where: str, w: Array, sources: Sources | None) -> Array:
    """Prepared parameters (..., nw) in single precision.

    Args:
        where: The function, for errors.
        w: In doubles.
        sources: Names what one of them comes from.

    Raises:
        ModelError: one would be 0, or lose digits, as it is too small, or would be infinite.
    """
    size = np.abs(w)
    # below the smallest normal number digits are lost one by one, and some processors take 0
    wrong = ((size > 0) & (size < RANGE.tiny)) | ((size > RANGE.max) & np.isfinite(w))
    if wrong.any():
        place = tuple(map(int, np.argwhere(wrong)[0]))
        named = sources(place[-1]) if sources else {}
        # states may have other values than the model
        among = ", ".join(f"'{n}'" + f" ({x:g})" * (w.ndim == 1) for n, x in named.items())
        of = f"{w[place]:g}, computed from parameter{'s' * (len(named) != 1)} {among},"
        raise ModelError(
            f"{where}: {of} is outside of what single precision can hold, {RANGE.tiny:.1e} to "
            f"{RANGE.max:.1e}. {CURE}"
        )
    return np.ascontiguousarray(w, np.float32)
