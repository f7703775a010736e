"""MATLAB files (level 5): every array under its name, times as ``t``.

Names of columns and units stand beside, as cell arrays ``q_names``, ``q_units``. They are written
only: the model is not in them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Container, Sequence
from pathlib import Path

import numpy as np

from .contents import Array, Attributes, FileFormat, Variables, texts

TEXTS = ("names", "units")
LONGEST = 63  # letters of a name
# words of the language
RESERVED = frozenset(
    {
        *("break", "case", "catch", "classdef", "continue", "else", "elseif", "end", "for"),
        *("function", "global", "if", "otherwise", "parfor", "persistent", "return", "spmd"),
        *("switch", "try", "while"),
    }
)


def _written(path: Path, attributes: Attributes, variables: Variables) -> None:
    from scipy.io import savemat

    arrays: dict[str, Array] = {}
    for name, one in variables.items():
        key = _identifier("t" if name == "time" else name, arrays)
        is_text = one.values.dtype.kind == "S"
        arrays[key] = _cells(texts(one)) if is_text else one.values
        for what in TEXTS:
            text = one.attributes.get(what, "")
            if text.startswith("["):
                arrays[_identifier(f"{name}_{what}", arrays)] = _cells(json.loads(text))
    with path.open("wb") as file:
        savemat(file, arrays, long_field_names=True, do_compression=True, oned_as="column")


def _identifier(name: str, taken: Container[str]) -> str:
    """A name that MATLAB accepts, and no other variable has: a letter, then letters, digits, _."""
    clean = re.sub(r"\W", "_", name, flags=re.ASCII)
    clean = clean if clean[:1].isalpha() and clean not in RESERVED else f"x{clean}"
    candidate, k = clean[:LONGEST], 1
    while candidate in taken:
        k += 1
        candidate = f"{clean[: LONGEST - len(str(k)) - 1]}_{k}"
    return candidate


def _cells(entries: Sequence[str]) -> Array:
    """Texts as a cell array: a column of them, characters beyond ASCII as \\u00e9.

    Octave counts bytes where MATLAB counts characters, and would cut off the ends of others.
    """
    cells = np.empty((len(entries), 1), dtype=object)
    cells[:, 0] = [json.dumps(text)[1:-1] if not text.isascii() else text for text in entries]
    return cells


MATLAB = FileFormat("MATLAB file", (".mat",), _written, limit=2**31 - 1)
