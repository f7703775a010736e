"""JSON: every array under its name, with its axes, names and units; for programs of any language.

They are written only. What is not a finite number is null.
"""

from __future__ import annotations

import json
from pathlib import Path

from .contents import Attributes, FileFormat, Variable, Variables, for_json, texts


def _written(path: Path, attributes: Attributes, variables: Variables) -> None:
    named = {"t" if name == "time" else name: one for name, one in variables.items()}
    notes = {name: _plain(text) for name, text in attributes.items()}
    document = {**notes, "arrays": {name: _entry(one) for name, one in named.items()}}
    # the bytes of an archive of the same numbers, whatever the language of the machine
    path.write_text(json.dumps(document, allow_nan=False), encoding="ascii", newline="\n")


def _entry(one: Variable) -> dict[str, object]:
    """An array with its axes and what is said of it."""
    if one.values.dtype.kind == "S":
        return {"axes": one.dimensions[:1], "values": texts(one)}
    said = {key: _plain(text) for key, text in one.attributes.items()}
    return {"axes": one.dimensions, **said, "values": for_json(one.values).tolist()}


def _plain(text: object) -> object:
    """What a text of JSON says; any other as it is."""
    if not (isinstance(text, str) and text[:1] in ("[", "{", '"')):
        return text
    try:
        value: object = json.loads(text)
    except ValueError:
        return text
    return value


JSON = FileFormat("JSON", (".json",), _written)
