"""NumPy archives: every variable is an array that ``numpy.load`` gives by its name.

Names of axes, units and everything the run says about itself stand as JSON in the entry ``about``.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from ...number_file import packed, plain, unpacked
from .contents import Array, Attributes, FileFormat, Variable, Variables

ABOUT = "about"
LETTERS = "S1"  # texts, as bytes


def _written(path: Path, attributes: Attributes, variables: Variables) -> None:
    rows = {
        name: {"dimensions": one.dimensions, "attributes": dict(one.attributes)}
        for name, one in variables.items()
    }
    about = json.dumps({"attributes": dict(attributes), "variables": rows})
    # letters are numbers in a file that holds no objects
    arrays = {
        name: one.values.view("u1") if one.values.dtype == LETTERS else one.values
        for name, one in variables.items()
    }
    path.write_bytes(packed({**arrays, ABOUT: np.array(about)}))


def _parsed(data: bytes) -> tuple[Attributes, Variables]:
    """Attributes and variables.

    Raises:
        ValueError: it is damaged.
    """
    arrays = unpacked(data)
    if ABOUT not in arrays or arrays[ABOUT].ndim:
        raise ValueError(f"it has no '{ABOUT}'")
    about = plain(str(arrays.pop(ABOUT)).encode())
    tables = about if isinstance(about, dict) else {}
    attributes, rows = tables.get("attributes"), tables.get("variables")
    if not (isinstance(attributes, dict) and isinstance(rows, dict) and set(rows) == set(arrays)):
        raise ValueError(f"'{ABOUT}' does not say what it holds")
    if not all(isinstance(value, str) or type(value) is int for value in attributes.values()):
        raise ValueError("its texts are damaged")
    return attributes, {name: _variable(name, rows[name], arrays[name]) for name in rows}


def _variable(name: str, row: object, values: Array) -> Variable:
    """An array with the names of its axes and its texts, checked."""
    dimensions = row.get("dimensions") if isinstance(row, dict) else None
    texts = row.get("attributes") if isinstance(row, dict) else None
    if not (isinstance(dimensions, list) and isinstance(texts, dict)):
        raise ValueError(f"nothing is said about '{name}'")
    if (
        not values.ndim
        or len(dimensions) != values.ndim
        or not all(isinstance(text, str) for text in (*dimensions, *texts.values()))
    ):
        raise ValueError(f"what is said about '{name}' is damaged")
    if values.dtype.kind == "U":
        raise ValueError(f"'{name}' is a text")
    numbers = values.view(LETTERS) if values.dtype == "u1" else values.astype(np.float64)
    return Variable(tuple(dimensions), numbers, texts)


NPZ = FileFormat("NumPy archive", (".npz",), _written, (b"PK\x03\x04",), _parsed)
