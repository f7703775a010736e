"""Derivatives of the data of elements by the parameters of a model."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, final

import numpy as np

from ....arrays import Array, Integers
from ....ir.derivative import directional, forward
from ....ir.function import Function, Output
from ....ir.graph import ONE, ZERO, Graph
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
        rows: Data of all elements that parameters change, counted once where elements share them.
    """

    def __init__(self, model: LoadedModel, tables: Tables) -> None:
        self._model, self._groups, self._curved = model, tables.groups, False
        self._tables, self.rows = list[object](), 0
        self._slopes = dict[str, tuple[Array, tuple[int, ...]]]()
        self.records = (DataSlopes * max(1, len(tables.groups)))()
        for record, group in zip(self.records, tables.groups, strict=False):
            if not group.common:
                continue
            slopes, shape = self._slopes[group.common] = _slopes(model, group.common)
            rows, parameters = np.nonzero(slopes)
            starts = np.searchsorted(rows, np.arange(len(slopes) + 1)).astype(np.intp)
            record.count, record.shared = shape[-1], int(len(shape) == 1)
            record.first_row, record.rows = self.rows, len(slopes)
            self.rows += len(slopes)
            slope = np.ascontiguousarray(slopes[rows, parameters])
            self._set(record, start=starts, parameter=parameters.astype(np.intp), slope=slope)

    def curve(self) -> None:
        """Add second derivatives, which Hessians read."""
        for record, group in zip(self.records, self._groups, strict=False):
            if not group.common or self._curved:
                continue
            rows, pairs, values = _second(self._model, group.common)
            starts = np.searchsorted(rows, np.arange(record.rows + 1)).astype(np.intp)
            self._set(record, second_start=starts, second_parameters=pairs, second=values)
        self._curved = True

    def _set(self, record: DataSlopes, **tables: Array | Integers) -> None:
        for name, table in tables.items():
            setattr(record, name, table.ctypes.data)
            self._tables.append(table)

    def parameters_of(self, common: str, data: Collection[int], count: int) -> list[int]:
        """Numbers of the parameters that some of the ``count`` data of every element depend on."""
        slopes = self._slopes[common][0].reshape(-1, count, len(self._slopes[common][0][0]))
        return np.flatnonzero(slopes[:, [*data]].any(axis=(0, 1))).tolist()


def _slopes(model: LoadedModel, common: str) -> tuple[Array, tuple[int, ...]]:
    """Derivatives (data, parameters) of the data of a group, and the shape of these."""
    function = model._objects.function(common)
    graph, roots, read, columns = _columns(function)
    slopes = np.zeros((len(roots), len(model.parameters)))
    if read:
        values = _values(model, function, graph, [node for column in columns for node in column])
        slopes[:, read] = np.reshape(values, (len(read), len(roots))).T
    return slopes, function.outputs[0].shape


def _second(model: LoadedModel, common: str) -> tuple[Integers, Integers, Array]:
    """Second derivatives of the data of a group by parameters, where they are not 0.

    Returns:
        Rows of data in their order, pairs of parameters in both orders (n, 2), and values (n,).
    """
    function = model._objects.function(common)
    graph, _, read, columns = _columns(function)
    # (row, one parameter) of every slope that is no number
    slopes = [
        (row, k, node)
        for k, column in zip(read, columns, strict=True)
        for row, node in enumerate(column)
        if graph.value(node) is None
    ]
    entries, nodes = list[tuple[int, int, int]](), list[int]()
    for other in read if slopes else ():
        changes = forward(graph, [node for *_, node in slopes], {graph.var("p", other): ONE})
        for (row, k, _), change in zip(slopes, changes, strict=True):
            if change != ZERO:
                entries.append((row, k, other))
                nodes.append(change)
    places = np.array(entries, dtype=np.intp).reshape(-1, 3)
    values = _values(model, function, graph, nodes) if nodes else np.zeros(0)
    order = np.argsort(places[:, 0], kind="stable")
    return places[order, 0], np.ascontiguousarray(places[order, 1:]), values[order]


def _columns(function: Function) -> tuple[Graph, list[int], list[int], list[list[int]]]:
    """A graph of data, these, the parameters that they read, and their slopes by each of them."""
    graph, roots = rebuild(function.graph, function.roots)
    read = sorted({node[2] for node in graph.nodes if node[0] == "var"})
    return graph, roots, read, directional(graph, roots, [{graph.var("p", k): ONE} for k in read])


def _values(model: LoadedModel, function: Function, graph: Graph, nodes: list[int]) -> Array:
    """Values of nodes at the parameters of the model."""
    output = Output("slopes", (len(nodes),), tuple(nodes))
    derivative = Function("slopes", graph, function.inputs, (output,))
    values = evaluate(derivative, {"p": model.parameters.vector.tolist()})
    return np.array(values["slopes"], dtype=float)
