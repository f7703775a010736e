"""Combinations of constraints that vanish, in a plain basis and in words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
SHARE = 0.2  # entries below this part of the largest are not told
FORMS = {"p": "translation along {}", "r": "rotation about {}"}


def plain(vectors: Array) -> Array:
    """A basis of the same space with as many zeros as elimination gives, largest entry 1."""
    if not vectors.size:
        return vectors
    basis, row = vectors.copy(), 0
    for column in range(basis.shape[1]):
        if row == len(basis):
            break
        best = row + int(np.abs(basis[row:, column]).argmax())
        if abs(basis[best, column]) < 1e-6:
            continue
        basis[[row, best]] = basis[[best, row]]
        basis[row] /= basis[row, column]
        others = np.arange(len(basis)) != row
        basis[others] -= np.outer(basis[others, column], basis[row])
        row += 1
    largest = np.take_along_axis(basis, np.abs(basis).argmax(axis=1)[:, None], axis=1)
    return np.asarray(basis / np.where(largest == 0, 1.0, largest))


def words(vector: Array, rows: Sequence[Mapping[str, Any]]) -> str:
    """A combination of constraints in words: ``translation along y of joint 'J3'``."""
    told: list[tuple[str, str]] = []
    sizes = np.abs(vector).round(9) / np.abs(vector).max()

    # a translation first, if it has much of it
    def order(k: int) -> tuple[bool, float]:
        return sizes[k] < 0.5 or rows[k]["unit"] != "N", -float(sizes[k])

    for k in sorted(np.flatnonzero(sizes >= SHARE).tolist(), key=order):
        joint, name = str(rows[k]["joint"]), str(rows[k]["name"])
        part = name.removeprefix(f"{joint}.")
        form = FORMS.get(part[:1]) if len(part) == 2 and part[1] in "xyz" else None
        told.append((form.format(part[1]) if form else f"'{part}'", joint))
    first, joint = told[0]
    if len(told) == 1 and not rows[int(sizes.argmax())].get("level"):
        return f"{first} of joint '{joint}' (its loop moves in a group that holds it)"
    others = [part if owner == joint else f"{part} of joint '{owner}'" for part, owner in told[1:]]
    rest = f" (it follows from {', '.join(others)} and the other joints)" if others else ""
    return f"{first} of joint '{joint}'{rest}"
