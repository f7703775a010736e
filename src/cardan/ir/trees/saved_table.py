"""The table of an assembly as plain data, and back: it names only what is there."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeVar

from .kernels import KERNELS
from .table import (
    BODY,
    MASS_BODY,
    MASS_SPEED,
    MOST_SPEEDS,
    SPEED,
    BodyRow,
    Entry,
    OutputRow,
    SpeedRow,
    Tree,
    chunks,
)

Row = TypeVar("Row", BodyRow, SpeedRow, OutputRow, Entry)
ROWS = ("bodies", "speeds", "rotors", "outputs", "changes")
MOST = 1_000_000
# numbers of a body and of a speed that a kernel reads
WIDTHS = {"tree_mass": (MASS_BODY, MASS_SPEED), "tree_derivatives": (BODY, SPEED)}


def to_dict(tree: Tree) -> dict[str, object]:
    """The table as lists of whole numbers."""
    rows = {name: [list(row) for row in getattr(tree, name)] for name in ROWS}
    return {**rows, "columns": tree.columns, "forward": tree.forward}


def from_dict(data: object, kernel: object, numbers: int, speeds: int, size: int) -> Tree:
    """The table that :func:`to_dict` saved.

    Args:
        data: What was saved.
        kernel: Name of its kernel.
        numbers: How many numbers of bodies there are.
        speeds: Length of u.
        size: Of the results.

    Raises:
        ValueError: it is none, or names what is not there.
    """
    if not isinstance(kernel, str) or kernel not in KERNELS:
        raise ValueError(f"a saved assembly names a kernel, not {kernel!r}")
    if not isinstance(data, Mapping):
        raise ValueError("a saved assembly needs a table 'tree'")
    columns, forward = data.get("columns"), data.get("forward")
    if type(columns) is not int or not 0 <= columns <= MOST or not isinstance(forward, bool):
        raise ValueError("a saved table of a tree needs a number 'columns' and a flag 'forward'")
    tree = Tree(
        _rows(BodyRow, data, "bodies"),
        _rows(SpeedRow, data, "speeds"),
        _rows(Entry, data, "rotors"),
        _rows(OutputRow, data, "outputs"),
        _rows(Entry, data, "changes"),
        columns,
        forward,
    )
    _check_bodies(tree, *WIDTHS[kernel], numbers)
    _check_speeds(tree, speeds)
    _check_results(tree, numbers, size)
    return tree


def _rows(kind: type[Row], data: Mapping[str, object], name: str) -> tuple[Row, ...]:
    rows = data.get(name)
    if not isinstance(rows, list) or len(rows) > MOST:
        raise ValueError(f"a saved table of a tree needs the rows '{name}'")
    return tuple(_row(kind, row) for row in rows)


def _row(kind: type[Row], row: object) -> Row:
    width = len(kind._fields)
    if not isinstance(row, list) or len(row) != width or not all(type(x) is int for x in row):
        raise ValueError(f"a row of a saved table has {width} whole numbers, not {row!r}")
    return kind(*row)


def _check_bodies(tree: Tree, body_width: int, speed_width: int, numbers: int) -> None:
    """Parents stand before their children, speeds one behind the other, numbers in their place."""
    first = 0
    for i, body in enumerate(tree.bodies):
        end = body.numbers + body_width + body.speeds * speed_width
        inside = 0 <= body.speeds <= MOST_SPEEDS and body.numbers >= 0 and end <= numbers
        if body.modes != -1:
            inside &= body.modes >= 0 and body.modes + 6 * body.speeds**2 <= numbers
        if not (-1 <= body.parent < i and body.first == first and inside):
            raise ValueError(f"body {i} of a saved table does not fit its tree")
        first += body.speeds
    if first != len(tree.speeds):
        raise ValueError("bodies of a saved table do not have the speeds that it lists")


def _check_speeds(tree: Tree, speeds: int) -> None:
    """Every slot has one speed, and speeds inboard stand before those outboard, level by level."""
    if sorted(speed.slot for speed in tree.speeds) != list(range(speeds)):
        raise ValueError("speeds of a saved table do not fit the slots of u")
    for k, speed in enumerate(tree.speeds):
        inboard = speed.before if k == speed.run else k - 1
        level = tree.speeds[inboard].level + 1 if inboard >= 0 else 0
        runs = speed.run == k or (k > 0 and tree.speeds[k - 1].run == speed.run)
        if not (-1 <= inboard < k and runs and speed.level == level and speed.place >= 0):
            raise ValueError(f"speed {k} of a saved table does not fit its tree")


def _check_results(tree: Tree, numbers: int, size: int) -> None:
    """Results fill what there is; what is added has a row, a column and a place."""
    n, width, half = len(tree.speeds), tree.width, chunks(len(tree.speeds))
    for row in tree.outputs:
        # M and what is along q and u come with all columns
        if row.of_mass or row.first < 2 * half:
            fits = row.columns == n and row.first in ((0,) if row.of_mass else (0, half))
        else:
            fits = row.columns >= 0 and row.first + row.columns <= width
        if not fits:
            raise ValueError("a saved table names columns that are not there")
    expected = n * (sum(row.columns for row in tree.outputs) if tree.outputs else n)
    if expected != size:
        raise ValueError(f"a saved table gives {expected} results; there are {size}")
    joints = [i for i, body in enumerate(tree.bodies) for _ in range(body.speeds)]
    for entries, columns in ((tree.rotors, n), (tree.changes, width)):
        for entry in entries:
            bounds = (n, columns, numbers)
            if not all(0 <= x < most for x, most in zip(entry, bounds, strict=True)):
                raise ValueError("a saved table adds a number that is not there")
    for rotor in tree.rotors:
        if not (rotor.column <= rotor.row and joints[rotor.row] == joints[rotor.column]):
            raise ValueError("a saved table has a rotor that ties joints together")
    if any(n <= entry.column % half < half for entry in tree.changes if entry.column < 2 * half):
        raise ValueError("a saved table adds a number to a column that is not there")
