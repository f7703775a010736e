"""Whether the cells of a mesh hang together, and by faces."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..arrays import Array, Integers
from ..errors import ModelError, counted
from .topology import boundary, by_nodes, components


def check_parts(source: str, points: Array, cells: Mapping[str, Integers], parts: int) -> None:
    """Check that common nodes connect all cells to so many parts, and common faces as well.

    Raises:
        ModelError: more or fewer parts, cells that overlap, or parts that only touch.
    """
    outside = boundary(cells)
    if outside.crowded:
        corners = ", ".join(map(str, outside.crowded[0].tolist()))
        raise ModelError(
            f"{source}: three cells or more have the face with the corners {corners}: cells "
            "overlap; leave out those that are there twice"
        )
    count, label = by_nodes(cells, len(points))
    if count != parts:
        places = "; ".join(_part(points, cells, label, k) for k in range(min(count, 4)))
        more = "; ..." if count > 4 else ""
        raise ModelError(
            f"{source}: its cells are {counted(count, 'part')} without common nodes, expected "
            f"{parts}: {places}{more}. Merge nodes in one place with read(..., merge=), or give "
            f"parts={count} if they are meant to be apart, each connected to an interface"
        )
    total = sum(map(len, cells.values()))
    touching, face_label = components(total, outside.pairs)
    if touching > count:
        # two cells of the same part that no faces connect
        part = next(k for k in range(count) if len(np.unique(face_label[label == k])) > 1)
        first = np.flatnonzero(label == part)
        second = first[face_label[first] != face_label[first[0]]][0]
        raise ModelError(
            f"{source}: {_name(cells, int(first[0]))} and {_name(cells, int(second))} are "
            "connected by corners or edges alone, which turn like hinges; or their faces do not "
            "fit each other (four corners against three): let cells share faces"
        )


def _name(cells: Mapping[str, Integers], number: int) -> str:
    """A cell by its number over all kinds."""
    for kind, members in cells.items():
        if number < len(members):
            return f"cell {number} of {kind}"
        number -= len(members)
    raise IndexError(number)


def _part(points: Array, cells: Mapping[str, Integers], label: Integers, part: int) -> str:
    """A part in words."""
    numbers = np.flatnonzero(label == part)
    start, places = 0, []
    for members in cells.values():
        rows = numbers[(numbers >= start) & (numbers < start + len(members))] - start
        places.append(points[members[rows]].reshape(-1, 3))
        start += len(members)
    x, y, z = np.concatenate(places).mean(axis=0)
    first = _name(cells, int(numbers[0]))
    return f"{counted(len(numbers), 'cell')} around ({x:.4g}, {y:.4g}, {z:.4g}) with {first}"
