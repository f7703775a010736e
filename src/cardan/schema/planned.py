"""Data computed for a model of elements before a run, for exports of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..records import dataclass

# fields of a record of C: numbers, and arrays for the pointers to them
Fields: TypeAlias = Mapping[str, int | NDArray[Any] | None]


@dataclass(frozen=True, eq=False)
class Planned:
    """Tables of elements for programs without Python.

    Attributes:
        mesh, groups, plan: Fields of ``cardan_mesh``, of every ``cardan_group``, and of
            ``cardan_sparse``.
        movers: Fields of every ``cardan_movers``, and the C names of its functions.
        start: State (nx,) in which a run without named values starts: assembled, unless no such
            state is found.
        locked: Which entries of it (nx,) stay as they are when parameters change: those of joints,
            which nodes follow; all where beams are, which do not follow there.
        size: Of the model [m], against which lengths count.
        columns: What speeds count in (nu,): that, or 1.
    """

    mesh: Fields
    groups: Sequence[Fields]
    movers: Sequence[tuple[Fields, Mapping[str, str]]]
    plan: Fields
    start: NDArray[np.float64]
    locked: NDArray[np.bool_]
    size: float
    columns: NDArray[np.float64]
