"""XML written by hand: elements with attributes, escaped, one to a line."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from xml.sax.saxutils import quoteattr

from ...records import dataclass

# what XML 1.0 has no way to write
_IMPOSSIBLE = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


@dataclass(frozen=True)
class Element:
    """An element.

    Attributes:
        name: Its tag.
        attributes: Text by name; None leaves one out.
        children: Elements inside.
    """

    name: str
    attributes: Mapping[str, str | None] = field(default_factory=dict)
    children: Sequence[Element] = ()


def document(root: Element) -> str:
    """The document of an element."""
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + "\n".join(_lines(root, "")) + "\n"


def plain(text: str) -> str:
    """Text without characters that XML cannot hold."""
    return _IMPOSSIBLE.sub("\ufffd", text)


def _lines(one: Element, indent: str) -> Iterator[str]:
    attributes = "".join(
        f" {name}={quoteattr(plain(text))}"
        for name, text in one.attributes.items()
        if text is not None
    )
    if not one.children:
        yield f"{indent}<{one.name}{attributes}/>"
        return
    yield f"{indent}<{one.name}{attributes}>"
    for child in one.children:
        yield from _lines(child, indent + "  ")
    yield f"{indent}</{one.name}>"
