"""Measured data of a scene: columns in the file itself, or in a CSV file beside it."""

from __future__ import annotations

import csv
from typing import TYPE_CHECKING

from ....elements.tables import Interpolation
from ....elements.tables import table as interpolation
from ....errors import ModelError
from ..document import content
from . import keys
from .item import Item
from .tree import decoded

if TYPE_CHECKING:
    from .values import Values


def table(values: Values, item: Item) -> Interpolation:
    """The function of a table: ``{x: [...], y: [...], kind: akima}`` or ``{file: torque.csv}``.

    Raises:
        ModelError: neither columns nor a file, a file that is not a table, or points that make no
            curve.
    """
    table_values = values.record(keys.TABLE, item, "a table")
    columns = [table_values.pop(name) for name in ("x", "y") if name in table_values]
    file = table_values.pop("file", None)
    if len(columns) != (2 if file is None else 0):
        raise item.error("a table has x and y, two lists of numbers, or file, a CSV of two columns")
    if file is not None:
        source = item.items()["file"]
        with source.at_item():
            columns = list(_columns(values, source))
    with item.at_item(named=True):
        return interpolation(*columns, **table_values)


def _columns(values: Values, item: Item) -> tuple[list[float], list[float]]:
    """Both columns of a CSV file; a first row of names is passed over."""
    path = values.meshes.locate(item.text(), item.path, "file")
    if path is None:
        raise ModelError(
            f"{item.path}: there is no file '{item.text()[:80]}' below the folder of the scene"
        )
    lines = decoded(content(path), path.name).splitlines()
    x: list[float] = []
    y: list[float] = []
    titles = False
    try:
        for number, row in enumerate(csv.reader(lines), 1):
            if not row or row[0].lstrip().startswith("#"):
                continue
            pair = _pair(row)
            if pair is None and (x or titles):
                raise ModelError(
                    f"{path.name}:{number}: two numbers with a comma between are wanted, not "
                    f"'{','.join(row)[:60]}'"
                )
            titles = titles or pair is None
            if pair is not None:
                x.append(pair[0])
                y.append(pair[1])
    except csv.Error as problem:
        raise ModelError(f"{path.name} is not a CSV file: {problem}") from problem
    return x, y


def _pair(row: list[str]) -> tuple[float, float] | None:
    try:
        x, y = (float(word) for word in row)
    except ValueError:
        return None
    return x, y
