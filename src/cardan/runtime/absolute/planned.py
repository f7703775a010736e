"""What is planned for a model in its folder before a run: its matrices, and where it starts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...errors import ModelError
from ..calling import Array
from ..closing import columns_of, size_of
from ..compiled import CompiledModel
from ..initial import start_of
from . import loading
from .blocks import plan_numbers, plan_tables
from .carried import Carrier, leading
from .matrices import Matrices
from .tables import Integers


@dataclass(frozen=True, eq=False)
class Planned:
    """What programs without Python are told.

    Attributes:
        numbers, tables: Of the factorization, by the names of ``cardan_sparse``.
        spots, unknown, diagonal: As :class:`.Matrices` has them.
        start: State (nx,) in which a run without named values starts: assembled, unless no such
            state is found.
        held: Which entries of it (nx,) stay as they are when parameters change: those of joints,
            which nodes follow; all where beams are, which do not follow there.
        size: Of the model [m], against which lengths count.
        columns: What speeds count in (nu,): that, or 1.
    """

    numbers: Mapping[str, int]
    tables: Mapping[str, NDArray[np.int32]]
    spots: Sequence[Integers]
    unknown: Integers
    diagonal: Integers
    start: Array
    held: NDArray[np.bool_]
    size: float
    columns: Array


def planned(folder: Path) -> Planned:
    """Plan the matrices of a model in absolute coordinates.

    Args:
        folder: Of the model.
    """
    model = CompiledModel(folder)
    found = loading.tables_of(model).once(Matrices.of)
    size = size_of(model)
    return Planned(
        plan_numbers(found.plan),
        plan_tables(found.plan),
        found.spots,
        found.unknown,
        found.diagonal,
        _start(folder, model),
        _held(model),
        size,
        columns_of(model, size),
    )


def _start(folder: Path, model: CompiledModel) -> Array:
    """Where a run starts (nx,); what joints of the tree carry needs no search."""
    start, free = start_of(model, {}, {}, {})
    tree = {row["name"] for row in model.manifest["joints"]}
    closed = any(row["joint"] not in tree for row in model.manifest["multipliers"])
    if closed or Carrier(model, free).links:
        # equal bits on every machine; a start that cannot be assembled is told when it is asked for
        with suppress(ModelError):
            start = CompiledModel(folder, reproducible=True).initial()
    return start


def _held(model: CompiledModel) -> NDArray[np.bool_]:
    held = np.ones(model.nq + model.nu, dtype=bool)
    if not loading.tables_of(model).beams:
        lead = leading(model)
        held[model.nq :] = lead
        for row in model.manifest["joints"]:
            (place, count), (first, _) = row["q"], row["u"]
            held[place : place + count] = lead[first]
    return held
