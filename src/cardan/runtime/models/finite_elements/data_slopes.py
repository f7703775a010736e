"""Derivatives of the data of elements by the parameters of a model."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, final

import numpy as np

from ....arrays import Array
from ....ir.derivative import directional
from ....ir.function import Function, Output
from ....ir.graph import ONE
from ....ir.interpreter import evaluate
from ....ir.rewrite import rebuild
from ....schema.product_records import DataSlopes
from .tables import Tables

if TYPE_CHECKING:
    from ..loaded_model import LoadedModel


@final
class DataByParameters:
    """Slopes of the data of every group by the parameters, where they are not 0.

    Args:
        model: At its parameters.
        tables: Its elements.

    Attributes:
        records: As C knows them, group by group.
    """

    def __init__(self, model: LoadedModel, tables: Tables) -> None:
        self._tables = list[object]()
        self._slopes = dict[str, tuple[Array, tuple[int, ...]]]()
        self.records = (DataSlopes * max(1, len(tables.groups)))()
        for record, group in zip(self.records, tables.groups, strict=False):
            if not group.common:
                continue
            slopes, shape = self._slopes[group.common] = _slopes(model, group.common)
            rows, parameters = np.nonzero(slopes)
            starts = np.searchsorted(rows, np.arange(len(slopes) + 1)).astype(np.intp)
            record.count, record.shared = shape[-1], int(len(shape) == 1)
            for name, table in (
                ("start", starts),
                ("parameter", parameters.astype(np.intp)),
                ("slope", np.ascontiguousarray(slopes[rows, parameters])),
            ):
                setattr(record, name, table.ctypes.data)
                self._tables.append(table)

    def parameters_of(self, common: str, data: Collection[int], count: int) -> list[int]:
        """Numbers of the parameters that some of the ``count`` data of every element depend on."""
        slopes = self._slopes[common][0].reshape(-1, count, len(self._slopes[common][0][0]))
        return np.flatnonzero(slopes[:, [*data]].any(axis=(0, 1))).tolist()


def _slopes(model: LoadedModel, common: str) -> tuple[Array, tuple[int, ...]]:
    """Derivatives (data, parameters) of the data of a group, and the shape of these."""
    function = model._objects.function(common)
    graph, roots = rebuild(function.graph, function.roots)
    read = sorted({node[2] for node in graph.nodes if node[0] == "var"})
    columns = directional(graph, roots, [{graph.var("p", k): ONE} for k in read])
    nodes = tuple(node for column in columns for node in column)
    slopes = np.zeros((len(roots), len(model.parameters)))
    if read:
        output = Output("slopes", (len(read), len(roots)), nodes)
        derivative = Function("slopes", graph, function.inputs, (output,))
        values = evaluate(derivative, {"p": model.parameters.vector.tolist()})
        slopes[:, read] = np.reshape(values["slopes"], (len(read), len(roots))).T
    return slopes, function.outputs[0].shape
