"""Polygons of COLLADA geometries as triangles.

Source: Khronos Group, COLLADA Digital Asset Schema Release 1.4.1 (2008), chapter 5.
"""

from __future__ import annotations

from xml.etree.ElementTree import Element

import numpy as np

from ...arrays import Array, Integers
from ...errors import ModelError
from .collada_elements import References, child, children, integers, natural, numbers, tag


def triangles(polygons: Element) -> Integers | None:
    """Corners of triangles (m, 3) as rows of the positions; None of other elements.

    Args:
        polygons: Such as <triangles> or <polylist>.

    Raises:
        ModelError: counts that do not fit the indices.
    """
    kind = tag(polygons)
    if kind not in ("triangles", "polylist", "polygons", "trifans", "tristrips"):
        return None
    blocks = _corner_blocks(polygons)
    if kind == "tristrips":
        return np.concatenate([_strip(block) for block in blocks] or [np.zeros((0, 3), int)])
    if kind == "triangles":
        counts = [np.full(block.size // 3, 3) for block in blocks]
        blocks = [block[: 3 * len(count)] for block, count in zip(blocks, counts, strict=True)]
    elif kind == "polylist":
        counts = [integers(child(polygons, "vcount"))]
    else:
        counts = [np.array([block.size]) for block in blocks]
    corners = np.concatenate([*blocks, np.zeros(0, int)])
    return _fans(corners, np.concatenate([*counts, np.zeros(0, int)]))


def _corner_blocks(polygons: Element) -> list[Integers]:
    """Rows of positions of the corners in every <p>."""
    inputs = list(children(polygons, "input"))
    stride = 1 + max((natural(one, "offset") for one in inputs), default=0)
    offset = natural(vertex_input(polygons), "offset")
    blocks = []
    for element in children(polygons, "p"):
        values = integers(element)
        if values.size % stride:
            raise ModelError(f"<p> has {values.size} numbers, not a multiple of {stride}")
        blocks.append(values[offset::stride])
    return blocks


def vertex_input(element: Element, semantic: str = "VERTEX") -> Element:
    """The input of a kind.

    Raises:
        ModelError: there is none.
    """
    for one in children(element, "input"):
        if one.get("semantic") == semantic:
            return one
    raise ModelError(f"<{tag(element)}> has no input {semantic}")


def _fans(corners: Integers, counts: Integers) -> Integers:
    """Triangles around the first corner of every polygon."""
    if np.any(counts < 0) or counts.sum() != corners.size:
        raise ModelError(f"polygons of {counts.sum()} corners in all have {corners.size} of them")
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]]) if counts.size else counts
    triangles_of = np.maximum(counts - 2, 0)
    first = np.repeat(starts, triangles_of)
    before = np.repeat(np.cumsum(triangles_of) - triangles_of, triangles_of)
    second = first + 1 + np.arange(first.size) - before
    return np.asarray(corners[np.stack([first, second, second + 1], axis=1)])


def _strip(corners: Integers) -> Integers:
    """Triangles of a strip; every other one runs the other way round."""
    count = max(corners.size - 2, 0)
    rows = np.arange(count)[:, None] + np.arange(3)
    rows[1::2] = rows[1::2, [1, 0, 2]]
    return np.asarray(corners[rows])


def positions(polygons: Element, references: References) -> Element:
    """The <source> of the positions that the corners of polygons refer to.

    Raises:
        ModelError: there is none.
    """
    vertices = references.target(vertex_input(polygons), "source")
    return references.target(vertex_input(vertices, "POSITION"), "source")


def points(source: Element) -> Array:
    """Positions (n, 3) of a <source>.

    Raises:
        ModelError: its numbers do not fit its counts.
    """
    values = numbers(child(source, "float_array"))
    accessor = child(source, "technique_common", "accessor")
    stride = 3 if accessor is None else natural(accessor, "stride", 1)
    offset = 0 if accessor is None else natural(accessor, "offset")
    count = len(values) // 3 if accessor is None else natural(accessor, "count")
    if stride < 3 or offset + stride * count > values.size:
        raise ModelError(f"<source> has {values.size} numbers for {count} points")
    return values[offset : offset + stride * count].reshape(count, stride)[:, :3]
