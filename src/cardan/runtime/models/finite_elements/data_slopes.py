"""Derivatives of the data of elements by the parameters of a model."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING, final

import numpy as np

from ....arrays import Array, Integers
from ....ir.derivative import directional, forward
from ....ir.function import Function, Output
from ....ir.graph import ONE, ZERO, Graph
from ....ir.interpreter import evaluate
from ....ir.rewrite import rebuild
from ....schema.finite_elements import ElementKind
from ....schema.product_records import DataSlopes
from .tables import Tables

if TYPE_CHECKING:
    from ..loaded_model import LoadedModel

# rows of data in their order, pairs of parameters (n, 2), and values (n,)
Second = tuple[Integers, Integers, Array]
# data of a superelement that say how it is turned on what carries it, the first ones
ROTATION = 9


def without_slopes(model: LoadedModel, kind: ElementKind) -> int:
    """Number of data of a kind, the first ones, that have no derivatives.

    Routines of C, which have no expressions, know none by rotations.
    """
    return 0 if model._objects.saved().keys() >= {*kind.functions.values()} else ROTATION


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
            record.count, record.shared = shape[-1], int(len(shape) == 1)
            self._tables += _fill(record, slopes)
            record.first_row, self.rows = self.rows, self.rows + record.rows

    def curve(self) -> None:
        """Add second derivatives, which Hessians read."""
        for record, group in zip(self.records, self._groups, strict=False):
            if not group.common or self._curved:
                continue
            self._tables += _fill_second(record, _second(self._model, group.common))
        self._curved = True

    def parameters_of(self, common: str, data: Collection[int], count: int) -> list[int]:
        """Numbers of the parameters that some of the ``count`` data of every element depend on."""
        slopes = self._slopes[common][0].reshape(-1, count, len(self._slopes[common][0][0]))
        return np.flatnonzero(slopes[:, [*data]].any(axis=(0, 1))).tolist()


def _fill(record: DataSlopes, slopes: Array) -> list[object]:
    """Fill in slopes (rows, parameters) of data; what is returned must live as long."""
    record.rows = len(slopes)
    rows, parameters = np.nonzero(slopes)
    starts = np.searchsorted(rows, np.arange(len(slopes) + 1)).astype(np.intp)
    slope = np.ascontiguousarray(slopes[rows, parameters])
    return _set(record, start=starts, parameter=parameters.astype(np.intp), slope=slope)


def _fill_second(record: DataSlopes, second: Second) -> list[object]:
    """Fill in second derivatives of the same data; what is returned must live as long."""
    rows, pairs, values = second
    starts = np.searchsorted(rows, np.arange(record.rows + 1)).astype(np.intp)
    return _set(record, second_start=starts, second_parameters=pairs, second=values)


def _set(record: DataSlopes, **tables: Array | Integers) -> list[object]:
    for name, table in tables.items():
        setattr(record, name, table.ctypes.data)
    return [*tables.values()]


def of_frame(model: LoadedModel, number: int, curved: bool) -> tuple[DataSlopes, list[object]]:
    """Slopes of the axes (9) of a frame where it stands and of its origin (3), and what must live
    as long.

    Args:
        model: Whose.
        number: Of the frame in the manifest.
        curved: Whether second derivatives are wanted too.
    """
    frames = model.manifest.elements.frames
    places = {output.name: output.nodes for output in model._objects.function(frames).outputs}
    nodes = [
        *places["rotation"][9 * number : 9 * number + 9],
        *places["position"][3 * number : 3 * number + 3],
    ]
    record = DataSlopes(count=len(nodes), shared=1)
    tables = _fill(record, _slopes(model, frames, nodes)[0])
    if curved:
        tables += _fill_second(record, _second(model, frames, nodes))
    return record, tables


def _slopes(
    model: LoadedModel, saved: str, nodes: Sequence[int] | None = None
) -> tuple[Array, tuple[int, ...]]:
    """Derivatives (data, parameters) of what a saved function gives, and the shape of that.

    Args:
        model: At its parameters.
        saved: The function.
        nodes: Which of its results, all by default.
    """
    function = model._objects.function(saved)
    graph, roots, read, columns = _columns(function, nodes)
    slopes = np.zeros((len(roots), len(model.parameters)))
    if read:
        values = _values(model, function, graph, [node for column in columns for node in column])
        slopes[:, read] = np.reshape(values, (len(read), len(roots))).T
    return slopes, function.outputs[0].shape


def _second(model: LoadedModel, saved: str, nodes: Sequence[int] | None = None) -> Second:
    """Second derivatives of what a saved function gives by parameters, where they are not 0.

    Args:
        model: At its parameters.
        saved: The function.
        nodes: Which of its results, all by default.

    Returns:
        Rows of data in their order, pairs of parameters in both orders (n, 2), and values (n,).
    """
    function = model._objects.function(saved)
    graph, _, read, columns = _columns(function, nodes)
    # (row, one parameter) of every slope that is no number
    slopes = [
        (row, k, node)
        for k, column in zip(read, columns, strict=True)
        for row, node in enumerate(column)
        if graph.value(node) is None
    ]
    entries, bends = list[tuple[int, int, int]](), list[int]()
    for other in read if slopes else ():
        changes = forward(graph, [node for *_, node in slopes], {graph.var("p", other): ONE})
        for (row, k, _), change in zip(slopes, changes, strict=True):
            if change != ZERO:
                entries.append((row, k, other))
                bends.append(change)
    places = np.array(entries, dtype=np.intp).reshape(-1, 3)
    values = _values(model, function, graph, bends) if bends else np.zeros(0)
    order = np.argsort(places[:, 0], kind="stable")
    return places[order, 0], np.ascontiguousarray(places[order, 1:]), values[order]


def _columns(
    function: Function, nodes: Sequence[int] | None = None
) -> tuple[Graph, list[int], list[int], list[list[int]]]:
    """A graph of data, these, the parameters that they read, and their slopes by each of them."""
    graph, roots = rebuild(function.graph, function.roots if nodes is None else nodes)
    read = sorted({node[2] for node in graph.nodes if node[0] == "var"})
    return graph, roots, read, directional(graph, roots, [{graph.var("p", k): ONE} for k in read])


def _values(model: LoadedModel, function: Function, graph: Graph, nodes: list[int]) -> Array:
    """Values of nodes at the parameters of the model."""
    output = Output("slopes", (len(nodes),), tuple(nodes))
    derivative = Function("slopes", graph, function.inputs, (output,))
    values = evaluate(derivative, {"p": model.parameters.vector.tolist()})
    return np.array(values["slopes"], dtype=float)
