"""Arguments of users as arrays."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ...arrays import Array, Numbers
from ...errors import ArgumentError, ModelError, near

if TYPE_CHECKING:
    from .calling import Argument


def numbers(where: str, value: object, dtype: Numbers = np.float64) -> Array:
    """A value as an array of float64, or float32, in the order in memory that it has.

    Raises:
        ArgumentError: it holds other things than real numbers, masked ones, or rows of different
            lengths.
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
    return np.asarray(array, dtype=dtype)


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
