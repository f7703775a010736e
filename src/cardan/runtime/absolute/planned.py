"""What is planned for a model in its folder before a run: its matrices, and where it starts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..calling import Array
from ..closing import columns_of, size_of
from ..compiled import CompiledModel
from ..initial import start_of
from . import loading
from .blocks import plan_numbers, plan_tables
from .matrices import Matrices
from .tables import Integers


@dataclass(frozen=True, eq=False)
class Planned:
    """What programs without Python are told.

    Attributes:
        numbers, tables: Of the factorization, by the names of ``cardan_sparse``.
        spots, unknown, diagonal: As :class:`.Matrices` has them.
        start: State (nx,) that the scene names, its nodes where the joints carry them; circuits may
            be open.
        size: Of the model [m], against which lengths count.
        columns: What speeds count in (nu,): that, or 1.
    """

    numbers: Mapping[str, int]
    tables: Mapping[str, NDArray[np.int32]]
    spots: Sequence[Integers]
    unknown: Integers
    diagonal: Integers
    start: Array
    size: float
    columns: Array


def planned(folder: Path) -> Planned:
    """Plan the matrices of a model in absolute coordinates.

    Args:
        folder: Of the model.
    """
    model = CompiledModel(folder)
    found = loading.tables_of(model).once(Matrices.of)
    start, _ = start_of(model, {}, {}, {})
    size = size_of(model)
    return Planned(
        plan_numbers(found.plan),
        plan_tables(found.plan),
        found.spots,
        found.unknown,
        found.diagonal,
        start,
        size,
        columns_of(model, size),
    )
