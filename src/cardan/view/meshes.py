"""Meshes for pictures: read from files of others, reduced, and packed for pages."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .. import regular_file
from ..errors import ModelError
from ..records import dataclass
from .mesh_files import collada, obj, stl
from .mesh_files.part import MOST_TRIANGLES, Part
from .mesh_reduction import reduced

__all__ = ["MOST_TRIANGLES", "Packed", "Part", "encoded", "read", "reduced"]

LARGEST_FILE = 64 * 2**20  # bytes
READERS = {".stl": stl.parts, ".obj": obj.parts, ".dae": collada.parts}
STEPS = 2**16 - 1  # of a packed position


def read(path: Path) -> list[Part]:
    """The triangles of a mesh file, a part for every color, in the axes of the file.

    Args:
        path: An STL, OBJ or DAE file, told by the end of its name. OBJ files may have material
            files below their folder; pictures on surfaces are not read.

    Returns:
        The parts that have triangles. Lengths are as in the file; those of a DAE file are in
        meters, and its direction of "up" has no effect.

    Raises:
        ModelError: another kind of file, or one that cannot be read.
    """
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        raise ModelError(
            f"mesh '{path.name}': '{path.suffix}' files are not read, only STL, OBJ and DAE"
        )
    try:
        parts = reader(regular_file.content(path, LARGEST_FILE), path)
    except OSError as problem:
        raise ModelError(f"mesh '{path.name}' cannot be read: {problem.strerror}") from problem
    except ModelError as problem:
        raise ModelError(f"mesh '{path.name}' cannot be read: {problem}") from problem
    return [part for part in parts if len(part.triangles)]


@dataclass(frozen=True)
class Packed:
    """A part in few bytes.

    Attributes:
        positions: Steps from ``low`` (n, 3); all ``65535`` of them are ``size``.
        low, size: Corner and edges of the box around the part (3).
        triangles: Rows of vertices (m, 3), in two bytes each where that is enough.
        color: Red, green, blue in 0 ... 1, or None.
    """

    positions: NDArray[np.uint16]
    low: NDArray[np.float32]
    size: NDArray[np.float32]
    triangles: NDArray[np.uint16] | NDArray[np.uint32]
    color: tuple[float, float, float] | None


def encoded(part: Part) -> Packed:
    """A part with positions in steps of a 65535th of the box around it.

    Args:
        part: A part with at least one triangle.
    """
    low, high = part.vertices.min(axis=0), part.vertices.max(axis=0)
    size = high - low
    # in double precision: 65535 steps in the smallest single numbers overflow these
    scales = STEPS / np.where(size > 0, size, 1).astype(np.float64)
    steps = np.rint((part.vertices - low) * scales)
    rows: NDArray[np.uint16] | NDArray[np.uint32] = part.triangles
    if len(part.vertices) <= STEPS + 1:
        rows = part.triangles.astype(np.uint16)
    return Packed(steps.astype(np.uint16), low, size, rows, part.color)
