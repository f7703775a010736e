"""Stress at nodes out of the rows of an operator, and the equivalent stress of von Mises."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import checked
from ..arrays import Array, Integers
from ..errors import ModelError

STRESSES = ("xx", "yy", "zz", "yz", "zx", "xy")


def nodal_names(ids: Sequence[int]) -> list[str]:
    """Names of six rows of stress for each node, such as ``"17 xx"``."""
    return [f"{number} {one}" for number in ids for one in STRESSES]


def nodal_rows(names: Sequence[str], ids: Integers) -> tuple[Integers, Integers]:
    """Nodes that have all six components of stress, and their rows.

    Args:
        names: Of the rows of stress.
        ids: Numbers of the nodes.

    Returns:
        Places of nodes (k,) and rows (k, 6), components xx, yy, zz, yz, zx, xy.
    """
    row = {name: k for k, name in enumerate(names)}
    # nothing else is looked up: names may be anything
    firsts = {name.removesuffix(" xx") for name in names if name.endswith(" xx")}
    chosen = [k for k, number in enumerate(ids.tolist()) if f"{number}" in firsts]
    rows = [[row.get(f"{ids[k]} {one}", -1) for one in STRESSES] for k in chosen]
    table = np.array(rows, dtype=np.intp).reshape(-1, 6)
    complete = (table >= 0).all(axis=1)
    return np.array(chosen, dtype=np.intp)[complete], table[complete]


@checked
def von_mises(stress: ArrayLike) -> Array:
    """The equivalent stress of von Mises.

    Args:
        stress: Stresses (..., 6) [Pa]: xx, yy, zz, yz, zx, xy.

    Returns:
        Its value (...) [Pa].

    Raises:
        ModelError: another number of components.

    Source: O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, 5th ed., vol. 2, chapter 3.
    """
    s = np.asarray(stress, dtype=float)
    if not s.ndim or s.shape[-1] != 6:
        raise ModelError(f"von_mises: stress of shape {s.shape}, expected (..., 6)")
    normal = (
        (s[..., 0] - s[..., 1]) ** 2 + (s[..., 1] - s[..., 2]) ** 2 + (s[..., 2] - s[..., 0]) ** 2
    )
    result: Array = np.sqrt(normal / 2 + 3 * (s[..., 3:] ** 2).sum(axis=-1))
    return result
