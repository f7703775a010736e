"""A frame as the kernels know it, for the derivatives of its functions."""

from __future__ import annotations

import ctypes

import numpy as np

from ....arrays import Array
from ....errors import ModelError
from ....schema.mechanism import FrameRow
from ....schema.product_records import DataSlopes, FrameRecord
from .tables import Integers, Tables

NONE = -1


def frame_record(
    tables: Tables, row: FrameRow, place: tuple[Array, Array], slopes: DataSlopes | None
) -> tuple[ctypes.Array[FrameRecord], list[object]]:
    """The record of a frame, and what must live as long.

    Args:
        tables: Of the model.
        row: Of the frame in the manifest.
        place: Its axes (3, 3) and origin (3,) on what carries it.
        slopes: Of these by the parameters, where derivatives by them are wanted.

    Raises:
        ModelError: its node is none of the model.
    """
    q, u = (NONE, NONE) if row.node is None or row.tree is not None else row.node
    arrays: dict[str, Array | Integers] = {
        "local": np.concatenate([np.ravel(part) for part in place]),
        "speed": _speeds(tables, row),
    }
    if q != NONE and row.plane is not None:
        arrays |= {"home": np.array(row.plane.home), "to_space": np.array(row.plane.spread).ravel()}
    records = (FrameRecord * 1)(FrameRecord(q=q, u=u, speeds=len(arrays["speed"])))
    references: list[object] = [*arrays.values(), slopes]
    for field, array in arrays.items():
        setattr(records[0], field, array.ctypes.data)
    if slopes is not None:
        records[0].data = ctypes.addressof(slopes)
    return records, references


def _speeds(tables: Tables, row: FrameRow) -> Integers:
    """The speeds that move a frame: those of its node, or of the tree that it is on.

    Raises:
        ModelError: the node is none of the model.
    """
    if row.tree is not None:
        group, member, _ = row.tree
        return np.unique(tables.columns(tables.groups[group])[member]).astype(np.intp)
    if row.node is None:
        return np.zeros(0, dtype=np.intp)
    q, u = row.node
    for place in np.flatnonzero(tables.q[:-1] == q):
        kind = tables.kinds[tables.kind[place]]
        if tables.u[place] == u and kind.node and (kind.plane is None) == (row.plane is None):
            return np.arange(u, u + kind.nu, dtype=np.intp)
    raise ModelError(
        f"frame '{row.name}' is on no node that the model has. Compile the scene again"
    )
