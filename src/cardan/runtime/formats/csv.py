"""Tables of comma-separated values: what changes along a run, or from run to run.

A row for every time of a run, or for every run of an ensemble; a column for every number of it,
headed by the name that a motion takes and its unit: ``t [s]``, ``elbow [rad]``, ``elbow.u
[rad/s]``. What has no unit, and what none is stated of, is headed by its name alone. Numbers have
all their digits. They are written only: a table does not hold the model.
"""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from .contents import Attributes, FileFormat, Variable, Variables, texts

# axes along which tables go, by what a file holds; of runs the time
ROWS = {"cardan_ensemble": "run", "cardan_path": "row"}


def _written(path: Path, attributes: Attributes, variables: Variables) -> None:
    along = next((axis for name, axis in ROWS.items() if name in attributes), "time")
    entries = texts(variables["entry"]) if "entry" in variables else []
    columns = [
        column
        for name, one in variables.items()
        if one.dimensions[0] == along
        for column in _columns(name, one, entries)
    ]
    with path.open("w", encoding="utf-8", newline="") as file:
        out = csv.writer(file)
        out.writerow(name for name, _ in columns)
        out.writerows(zip(*(values for _, values in columns), strict=True))


def _columns(
    name: str, one: Variable, entries: Sequence[str]
) -> Iterator[tuple[str, Sequence[str]]]:
    """Heading and texts of every column of an array; ``entries``: of a state, by name."""
    if one.values.dtype.kind == "S":
        yield name, texts(one)
        return
    name = json.loads(one.attributes.get("name", json.dumps("t" if name == "time" else name)))
    flat = one.values.reshape(len(one.values), -1)
    stated = one.attributes.get("units", "")
    units = json.loads(stated) if stated.startswith("[") else [stated]
    heads = json.loads(one.attributes.get("names", "[]"))
    if not heads and one.dimensions[-1] == "entry":
        # final angle; states at several times: states[3] angle
        places = np.ndindex(one.values.shape[1:-1])
        axes = ["".join(f"[{k}]" for k in place) for place in places]
        heads = [f"{name}{place} {entry}" for place in axes for entry in entries]
    heads = heads or [
        name if one.values.ndim == 1 else f"{name}[{k}]" for k in range(flat.shape[1])
    ]
    for k, head in enumerate(heads):
        yield headed(head, units[k % len(units)]), [repr(float(x)) for x in flat[:, k]]


def headed(name: str, unit: str) -> str:
    """The heading of a column: its name, and its unit where it has one."""
    return f"{name} [{unit}]" if unit and unit != "1" else name


CSV = FileFormat("table", (".csv",), _written)
