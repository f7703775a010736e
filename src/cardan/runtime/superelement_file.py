"""Superelements as files: archives that are read again, and matrices for other programs."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from ..arguments import checked
from ..arrays import Array
from ..superelements import storage
from ..superelements.record import SuperelementRecord
from ..version import SUPERELEMENT
from . import formats
from .formats.contents import Contents, FileFormat, Variable, letters
from .formats.json_text import JSON
from .formats.matlab import MATLAB

ARCHIVE = FileFormat("NumPy archive", (".npz",), lambda path, attributes, variables: None)
FORMATS = (ARCHIVE, MATLAB, JSON)
CURE = "Reduce it to fewer modes"


@checked
def save(record: SuperelementRecord, path: str | Path) -> Path:
    """Write the component; the ending of the name says the format.

    ``.npz`` holds everything and is read by ``cd.superelement.load``. ``.mat`` (MATLAB, Octave) and
    ``.json`` hold, for other programs, ``M``, ``C`` and ``K`` of the coordinates named in
    ``coordinates``, the loads, the frequencies [rad/s] of the modes, and positions and axes of the
    interfaces. The file appears complete or not at all.

    Args:
        record: The component.
        path: The file; one that exists is replaced.

    Returns:
        The path.

    Raises:
        ModelError: another ending, or the file cannot be written.
    """
    path = Path(path)
    if formats.by_ending(path, FORMATS, "superelements") is ARCHIVE:
        return storage.save(record, path)
    interfaces = record.interfaces
    square = "coordinate", "coordinate_again"
    variables = {name: Variable(square, getattr(record, name)) for name in ("M", "C", "K")}
    variables |= {
        "coordinates": letters(record.labels, "coordinate", "coordinates"),
        "frequencies": Variable(("mode",), record.frequencies),
        "interfaces": letters([frame.name for frame in interfaces], "interface", "interfaces"),
        "interface_positions": Variable(
            ("interface", "axis"),
            np.array([frame.position for frame in interfaces], np.float64).reshape(-1, 3),
            {"units": "m"},
        ),
    }
    if record.loads:
        loads: Array = np.array([*record.loads.values()])
        variables["loads"] = Variable(("load", "coordinate"), loads)
        variables["load_names"] = letters(record.loads, "load", "load_names")
    notes = {"title": "superelement", "method": json.dumps(record.method)}
    return formats.save(path, SUPERELEMENT, Contents(variables, notes), CURE, FORMATS)
