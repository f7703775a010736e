"""STL files, binary and text: triangles without colors.

Source: 3D Systems, StereoLithography Interface Specification (1988).
"""

from __future__ import annotations

from array import array
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path

import numpy as np

from ...errors import ModelError
from .part import MOST_TRIANGLES, Part, merged

HEADER, RECORD = 84, np.dtype([("normal", "<f4", 3), ("corners", "<f4", 9), ("attribute", "<u2")])
LONGEST_NUMBER = 40  # letters


def parts(content: bytes, path: Path) -> list[Part]:
    """The triangles of an STL file as one part.

    Raises:
        ModelError: it is neither kind of STL file, or is cut off.
    """
    del path
    count = int.from_bytes(content[HEADER - 4 : HEADER], "little")
    size = HEADER + count * RECORD.itemsize
    # headers of binary files may begin like text
    text = content[:5].lower() == b"solid" and len(content) != size
    if text:
        corners = np.frombuffer(_text_corners(content))
        count = len(corners) // 9
    elif len(content) < HEADER or len(content) < size:
        raise ModelError(
            f"{len(content)} bytes are neither text that begins with 'solid' nor a binary STL file"
            + (f" of {count} triangles, which has {size}" if len(content) >= HEADER else "")
        )
    else:
        triangles = np.frombuffer(content, RECORD, count, HEADER)
        corners = triangles["corners"].astype(np.float64).ravel()
    return [merged(corners, np.arange(3 * count))] if count else []


def _text_corners(content: bytes) -> array[float]:
    """The corners of all facets, one behind the other."""
    corners = array("d")
    for number, tokens in _vertices(content):
        if len(tokens) != 4 or max(map(len, tokens)) > LONGEST_NUMBER:
            raise ModelError(f"line {number}: a vertex has three numbers")
        try:
            corners.extend(map(float, tokens[1:]))
        except ValueError:
            raise ModelError(f"line {number}: a vertex has three numbers") from None
        if len(corners) > 9 * MOST_TRIANGLES:
            raise ModelError(f"more than {MOST_TRIANGLES} triangles")
    if len(corners) % 9 or b"endsolid" not in content[-4096:]:
        raise ModelError("it is cut off: 'endsolid' or a vertex of the last facet is missing")
    return corners


def _vertices(content: bytes) -> Iterator[tuple[int, list[bytes]]]:
    for number, line in enumerate(BytesIO(content), 1):
        tokens = line.split(None, 4)
        if tokens and tokens[0].lower() == b"vertex":
            yield number, tokens
