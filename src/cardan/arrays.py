"""Arrays as annotations name them."""

from __future__ import annotations

from math import prod
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
# type of the numbers of a batch, which may be float32, too; arrays of such are annotated as Array
Numbers: TypeAlias = type[np.float64]
Complex: TypeAlias = NDArray[np.complex128]
Booleans: TypeAlias = NDArray[np.bool_]
Integers: TypeAlias = NDArray[np.intp]


def on_lines(*shape: int) -> Array:
    """An empty array that begins at a multiple of 64 bytes, as the longest vectors do."""
    size = prod(shape)
    room = np.empty(size + 8)
    start = (-room.ctypes.data // 8) % 8
    return room[start : start + size].reshape(shape)
