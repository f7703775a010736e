"""MATLAB files (level 5): every array under its name, times as ``t``.

Names of columns and units stand beside, as cell arrays ``q_names``, ``q_units``. They are written
only: the model is not in them.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np

from .contents import Array, Attributes, FileFormat, Variable, Variables

TEXTS = ("names", "units")
LONGEST = 63  # letters of a name


def _written(path: Path, attributes: Attributes, variables: Variables) -> None:
    from scipy.io import savemat

    arrays: dict[str, Array] = {}
    for name, one in variables.items():
        key = "t" if name == "time" else _identifier(name)
        arrays[key] = _texts(one) if one.values.dtype.kind == "S" else one.values
        for what in TEXTS:
            text = one.attributes.get(what, "")
            if text.startswith("["):
                arrays[_identifier(f"{name}_{what}")] = np.array(json.loads(text), dtype=object)
    with path.open("wb") as file:
        savemat(file, arrays, long_field_names=True, do_compression=True, oned_as="column")


def _identifier(name: str) -> str:
    """A name that MATLAB accepts: letters, digits and _, a letter first."""
    clean = re.sub(r"\W", "_", name, flags=re.ASCII)
    return (clean if clean[:1].isalpha() else f"x{clean}")[:LONGEST]


def _texts(one: Variable) -> Array:
    return np.array([b"".join(row).rstrip(b"\0").decode() for row in one.values], dtype=object)


MATLAB = FileFormat("MATLAB file", (".mat",), _written, limit=2**31 - 1)
