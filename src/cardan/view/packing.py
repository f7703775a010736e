"""Numbers of a page: rounded, as differences, bytes sorted, deflated; ``unpack.js`` reads it."""

from __future__ import annotations

import base64
import zlib
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arrays import Array
from ..errors import ModelError

HERE = Path(__file__).parent
# an object of JSON
JsonObject = dict[str, Any]
# what a second difference of whole numbers may be
MOST = 2**28


class Packer:
    """Collects arrays into one block of bytes."""

    def __init__(self) -> None:
        self._parts: list[bytes] = []
        self._size = 0

    def add(self, values: ArrayLike, step: float, orders: int = 2) -> JsonObject:
        """Add an array; returns what the page has to know of it.

        Args:
            values: (rows, ...) finite numbers.
            step: They are rounded to multiples of it, or of what 28 bits leave.
            orders: How often differences are taken along the rows: 2 for what moves smoothly.

        Raises:
            ModelError: a number is not finite.
        """
        table = np.asarray(values, dtype=np.float64)
        table = table.reshape(len(table), -1)
        most = float(np.abs(table).max(initial=0.0))
        if not np.isfinite(most):
            raise ModelError("a page shows finite numbers; some are not")
        origin: Array | None = None
        if most > MOST * step:
            # what is far away: as seen from where it starts
            origin = table[0]
            table = table - origin
            most = float(np.abs(table).max(initial=0.0))
        step = step_of(step, most)
        steps = np.rint(table / step).astype(np.int64)
        for order in range(orders):
            # the first row stays, the second becomes a first difference, the rest differ twice
            steps[order + 1 :] -= steps[order:-1].copy()
        zigzag = ((steps << 1) ^ (steps >> 63)).astype("<u4")
        planes = zigzag.reshape(-1, 1).view(np.uint8).T
        rows, columns = table.shape
        entry = {"at": self._size, "rows": rows, "columns": columns, "step": step, "orders": orders}
        if origin is not None:
            entry["origin"] = origin.tolist()
        self._parts.append(planes.tobytes())
        self._size += zigzag.nbytes
        return entry

    def text(self) -> str:
        """The block as text."""
        return deflated(b"".join(self._parts))


def step_of(step: float, most: float) -> float:
    """The step to which numbers up to ``most`` can be rounded: the one that is asked for, or what
    28 bits leave.
    """
    return max(step, most / MOST, 1e-300)


def below_one(size: float) -> int:
    """How many decimals more than at a size of one keep the same digits; 9 at most, 0 above."""
    return int(np.clip(-np.floor(np.log10(size)), 0, 9)) if size > 0 else 0


def deflated(content: bytes) -> str:
    """Bytes deflated, as text that a page may hold."""
    return base64.b64encode(zlib.compress(content, 9)).decode("ascii")


def turns(rotations: NDArray[np.float64]) -> NDArray[np.float64]:
    """Unit quaternions (x, y, z, w) of rotations (nt, ..., 3, 3), of like sign from row to row."""
    from scipy.spatial.transform import Rotation

    flat = Rotation.from_matrix(rotations.reshape(-1, 3, 3)).as_quat()
    quaternions: NDArray[np.float64] = flat.reshape(*rotations.shape[:-2], 4)
    against = np.sum(quaternions[1:] * quaternions[:-1], axis=-1) < 0
    signs = np.where(np.cumsum(against, axis=0) % 2, -1.0, 1.0)
    quaternions[1:] *= signs[..., None]
    return quaternions


def text_of(name: str) -> str:
    """A file of this folder."""
    return (HERE / name).read_text(encoding="utf-8")
