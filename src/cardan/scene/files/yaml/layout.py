"""Layout of a scene file: sections and their items in blocks, short ones on one line."""

from __future__ import annotations

import io
from collections.abc import Mapping
from typing import Any

# the longest line; longer items get a line for every key
WIDTH = 100
UNFOLDED = 2**20


class Number(str):
    """A number as it is to be written, digit by digit."""


class Flow(dict[str, Any]):
    """A mapping on one line: ``{body: upper, at: [0, 0, -l]}``."""


class Row(list[Any]):
    """A list on one line."""


def dumped(document: Mapping[str, Any]) -> str:
    """The YAML text of a document of mappings, lists, texts and :class:`Number`."""
    from ruamel.yaml import YAML
    from ruamel.yaml.representer import SafeRepresenter

    class Representer(SafeRepresenter):
        """Without anchors: equal numbers are not one number."""

        def ignore_aliases(self, data: object) -> bool:
            return True

    def mapping(representer: Any, data: Mapping[str, Any]) -> Any:
        return representer.represent_mapping("tag:yaml.org,2002:map", data, flow_style=True)

    def number(representer: Any, data: Number) -> Any:
        kind = "int" if data.lstrip("-").isdigit() else "float"
        return representer.represent_scalar(f"tag:yaml.org,2002:{kind}", str(data))

    def row(representer: Any, data: Row) -> Any:
        return representer.represent_sequence("tag:yaml.org,2002:seq", data, flow_style=True)

    Representer.add_representer(Flow, mapping)
    Representer.add_representer(Number, number)
    Representer.add_representer(Row, row)
    yaml = YAML(typ="safe", pure=True)
    yaml.Representer = Representer
    yaml.width, yaml.allow_unicode, yaml.default_flow_style = UNFOLDED, True, False
    yaml.sort_base_mapping_type_on_output = False  # type: ignore[assignment]
    stream = io.StringIO()
    yaml.dump({name: _section(name, section) for name, section in document.items()}, stream)
    return stream.getvalue()


def _section(name: str, section: object) -> Any:
    """A section: one item a line, or more lines where an item is long."""
    if not isinstance(section, dict):
        return _laid_out(section, WIDTH - len(name) - 2)
    return {key: _laid_out(item, WIDTH - len(key) - 4) for key, item in section.items()}


def _laid_out(value: object, room: int) -> Any:
    """A value on one line where it fits, in a block otherwise."""
    if not isinstance(value, (dict, list, tuple)) or _length(value) <= room:
        return _flat(value)
    if isinstance(value, dict):
        return {key: _laid_out(entry, room - 4) for key, entry in value.items()}
    return [_laid_out(entry, room - 4) for entry in value]


def _flat(value: object) -> Any:
    if isinstance(value, dict):
        return Flow((key, _flat(entry)) for key, entry in value.items())
    return Row(map(_flat, value)) if isinstance(value, (list, tuple)) else value


def _length(value: object) -> int:
    """About how many characters a value takes on one line."""
    if isinstance(value, dict):
        return sum(len(key) + 4 + _length(entry) for key, entry in value.items())
    if isinstance(value, (list, tuple)):
        return 2 + sum(2 + _length(entry) for entry in value)
    return len(str(value))
