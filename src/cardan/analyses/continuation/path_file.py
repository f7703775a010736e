"""Paths as files and tables: a row for every point of every branch."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from ...arguments import checked
from ...arrays import Array
from ...errors import ModelError
from ...runtime import formats
from ...runtime.formats.contents import Contents, Variable, letters, safe_name
from ...version import CONTINUATION
from .record import BranchRecord, ContinuationRecord

UNKNOWN = -1.0  # stability that is not known
OF_CYCLES = "period", "multiplier"
CURE = "Save fewer points: points="


@checked
def table(path: ContinuationRecord) -> dict[str, Array]:
    """Columns (n,) over the points of all branches, one branch after the other.

    What is swept, coordinates, outputs, of cycles ``period`` and ``multiplier`` (the largest
    modulus), ``stable`` and ``stable_held`` (1, 0, or -1 where they are not known), and ``branch``,
    the number of the branch in ``path.branches``.
    """
    branches = [*path.branches.values()]
    names = _names(branches[0])
    columns = {
        name: np.concatenate([np.asarray(branch[name], float) for branch in branches])
        for name in names
    }
    for name in ("stable", "stable_held"):
        flags = [flag for branch in branches for flag in getattr(branch, name)]
        columns[name] = np.array([UNKNOWN if flag is None else float(flag) for flag in flags])
    counts = [len(branch) for branch in branches]
    columns["branch"] = np.repeat(np.arange(len(branches), dtype=np.float64), counts)
    return columns


def _names(branch: BranchRecord) -> list[str]:
    """What is swept, then coordinates and outputs, as far as these solutions have them."""
    model, names = branch.model, [*branch.values]
    outputs = [row.name for row in model.manifest.outputs]
    for name in (*model.coordinates, *outputs, *OF_CYCLES):
        try:
            branch.solutions.quantity(name)
        except ModelError:
            continue
        names.append(name)
    return list(dict.fromkeys(names))


@checked
def save(path: ContinuationRecord, file: str | Path) -> Path:
    """Write all branches and their special points; the ending says the format.

    .nc (netCDF), .npz (NumPy archive), .csv (a table with a row for every point of every branch)
    or .mat (MATLAB). The file appears complete or not at all; it is for other programs.

    Returns:
        Its path.

    Raises:
        ModelError: a file that cannot be written, or of another format.
    """
    content = dict[str, Variable]()
    rows = table(path)
    names = [*path.branches]
    content["branch_name"] = letters([names[int(k)] for k in rows["branch"]], "row", "branch_name")
    for name, values in rows.items():
        content[safe_name(name, content)] = Variable(("row",), values, {"name": json.dumps(name)})
    points = [(b, point) for b in path.branches.values() for point in b.points]
    if points:
        content["point_name"] = letters([p.name for _, p in points], "point", "point_name")
        content["point_kind"] = letters([p.kind for _, p in points], "point", "point_kind")
        content["point_branch"] = letters([b.name for b, _ in points], "point", "point_branch")
        for name in path.main.values:
            values, safe = np.array([p.values[name] for _, p in points]), f"point_{name}"
            attributes = {"name": json.dumps(name)}
            content[safe_name(safe, content)] = Variable(("point",), values, attributes)
    notes = {
        "title": f"paths of {path.model.name}".encode("ascii", "replace").decode(),
        "branches": json.dumps({b.name: b.message for b in path.branches.values()}),
    }
    return formats.save(Path(file), CONTINUATION, Contents(content, notes), CURE)
