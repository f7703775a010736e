"""Data computed for a model in its folder before a run: its matrices, and its start."""

from __future__ import annotations

from contextlib import nullcontext, suppress
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...errors import ModelError
from ...runtime.models.constraint_projection import columns_of, size_of
from ...runtime.models.finite_elements import table_loading
from ...runtime.models.finite_elements.joint_driven_nodes import Carrier, leading
from ...runtime.models.finite_elements.record_fields import group_fields, mesh_fields, mover_fields
from ...runtime.models.initial import start_of
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.sparse.block_solver import plan_fields
from ...runtime.sparse.matrices import Matrices
from ...schema.planned import Planned
from .settings import Values
from .starts.start import initial

DIGITS = 12


def planned(
    kind: type[LoadedModel], folder: Path, q: Values | None = None, u: Values | None = None
) -> Planned:
    """Plan the matrices of a model in absolute coordinates.

    Args:
        kind: Its class.
        folder: Its folder.
        q, u: Coordinates and speeds to start from, by name, as ``simulate`` takes them.

    Raises:
        ModelError: an unknown name, or loops that cannot be closed with what is named.
    """
    model = kind(folder)
    tables, size = table_loading.tables_of(model), size_of(model)
    return Planned(
        mesh_fields(tables, model.manifest.functions),
        group_fields(tables),
        mover_fields(tables),
        plan_fields(tables.once(Matrices.of).plan),
        _start(folder, model, q, u),
        _locked(model),
        size,
        columns_of(model, size),
    )


def started(
    kind: type[LoadedModel], folder: Path, q: Values | None = None, u: Values | None = None
) -> dict[str, list[float]]:
    """Coordinates, speeds and internal states in which a run starts, by block.

    Empty where that is where the scene says, and where loops cannot be assembled: a run says why
    when it is asked for its start.

    Args:
        kind: Its class.
        folder: Its folder, in joint coordinates.
        q, u: Coordinates and speeds by name, as ``simulate`` takes them.

    Raises:
        ModelError: an unknown name, or loops that cannot be closed with what is named.
    """
    model, named = kind(folder, reproducible=True), bool(q or u)
    if model.manifest.multipliers or model.manifest.cuts or named:
        with nullcontext() if named else suppress(ModelError):
            # as many digits as are the same on every machine; a run closes the rest
            state = initial(model, q, u)
            if model.manifest.multipliers or model.manifest.cuts:
                state = np.round(state, DIGITS) + 0.0
            values = zip("quz", model.parts_of(state), strict=True)
            return {block: entries.tolist() for block, entries in values}
    return {}


def _start(folder: Path, model: LoadedModel, q: Values | None, u: Values | None) -> Array:
    """Initial state of a run (nx,); joints of a tree need no search."""
    if q or u:
        return initial(type(model)(folder, reproducible=True), q, u)
    start, _ = start_of(model, {}, {}, {})
    tree = {row.name for row in model.manifest.joints}
    closed = any(row.joint not in tree for row in model.manifest.multipliers)
    if closed or Carrier(model, np.zeros(model.nq + model.nu, dtype=bool)).links:
        # equal bits on every machine; a start that cannot be assembled is told when it is asked for
        with suppress(ModelError):
            start = initial(type(model)(folder, reproducible=True))
    return start


def _locked(model: LoadedModel) -> NDArray[np.bool_]:
    locked = np.ones(model.nq + model.nu, dtype=bool)
    if not table_loading.tables_of(model).beams:
        lead = leading(model)
        locked[model.nq :] = lead
        for row in model.manifest.joints:
            (place, count), (first, _) = row.slot("q"), row.slot("u")
            locked[place : place + count] = lead[first]
    return locked
