"""Elements of COLLADA documents: read strictly, looked up by id."""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree.ElementTree import Element

import numpy as np

from ...arrays import Array, Integers
from ...errors import ModelError
from ...records import dataclass

LARGEST_INDEX = 2**40


def parsed(content: bytes) -> Element:
    """The root of a document.

    Raises:
        ModelError: no XML, a document type or entities in it, or no COLLADA.
    """
    from defusedxml import DefusedXmlException
    from defusedxml.ElementTree import ParseError, fromstring

    try:
        root: Element = fromstring(content, forbid_dtd=True)
    except DefusedXmlException:
        raise ModelError("it declares a document type or entities; remove that") from None
    except (ParseError, ValueError, LookupError, RecursionError) as problem:
        raise ModelError(f"it is not XML: {problem}") from None
    if tag(root) != "COLLADA":
        raise ModelError(f"its root is <{tag(root)[:40]}>, not <COLLADA>")
    return root


def tag(element: Element) -> str:
    """Tag of an element without its namespace."""
    return element.tag.rpartition("}")[2]


def children(element: Element, kind: str) -> Iterator[Element]:
    """The children of a tag."""
    return (one for one in element if tag(one) == kind)


def child(element: Element, *path: str) -> Element | None:
    """The first child along a path of tags."""
    for kind in path:
        inner = next(children(element, kind), None)
        if inner is None:
            return None
        element = inner
    return element


def numbers(element: Element | None, count: int | None = None) -> Array:
    """The numbers in an element; whether they are finite is judged where they are used.

    Raises:
        ModelError: text that is not a number, or another count.
    """
    text = "" if element is None else (element.text or "").strip()
    kind = "element" if element is None else tag(element)
    try:
        values = np.fromstring(text, sep=" ") if text else np.zeros(0)
    except ValueError:
        raise ModelError(f"<{kind}> contains what is not a number") from None
    if count is not None and values.size != count:
        raise ModelError(f"<{kind}> has {values.size} numbers instead of {count}")
    return values


def integers(element: Element | None) -> Integers:
    """The indices or counts in an element.

    Raises:
        ModelError: text that is not a number, or numbers of absurd size.
    """
    values = numbers(element)
    if not np.all(np.abs(values) < LARGEST_INDEX):
        raise ModelError("an index or a count is not a number of sane size")
    return values.astype(np.intp)


def natural(element: Element, attribute: str, default: int = 0) -> int:
    """An attribute that counts something.

    Raises:
        ModelError: it does not.
    """
    text = element.get(attribute, str(default))
    if not (text.isascii() and text.isdigit() and len(text) < 10):
        raise ModelError(f"{attribute}={text[:40]!r} of <{tag(element)}> is not a count")
    return int(text)


@dataclass(frozen=True)
class References:
    """Elements of a document by their id."""

    ids: dict[str, Element]

    @staticmethod
    def of(root: Element) -> References:
        """The elements below a root that have an id."""
        return References({name: one for one in root.iter() if (name := one.get("id"))})

    def target(self, element: Element, attribute: str) -> Element:
        """The element that ``#id`` in an attribute refers to.

        Raises:
            ModelError: nothing in this document.
        """
        reference = element.get(attribute, "")
        match = self.ids.get(reference[1:]) if reference.startswith("#") else None
        if match is None:
            raise ModelError(f"<{tag(element)}> refers to {reference[:80]!r}, which is not here")
        return match
