"""Untrusted XML documents: parsed safely, numbers read strictly."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Self
from xml.etree.ElementTree import Element as XmlElement
from xml.etree.ElementTree import TreeBuilder

from ... import regular_file
from ...errors import ModelError, counted

LARGEST_FILE = 64 * 2**20
DEEPEST = 200
LARGEST_NUMBER = 1e30
LONGEST_QUOTE = 20  # letters of a text that a message repeats
# how a message begins that says where it is, in this file or an included one
PLACE = re.compile(r"^[^:]+:\d+: ")


def content(path: Path) -> bytes:
    """The bytes of a regular file of sane size.

    Raises:
        ModelError: it cannot be read, is a pipe or a device, or is too large.
    """
    try:
        return regular_file.content(path, LARGEST_FILE)
    except OSError as problem:
        raise ModelError(f"file '{path.name}' cannot be read: {problem.strerror}") from problem


class Numbered(XmlElement):
    """An element that knows where it began: its line, and its file where that was included."""

    line = 0
    file: str | None = None


def place(raw: XmlElement, file: str) -> str:
    """Place of an element for messages, ``<file>:<line>``."""
    assert isinstance(raw, Numbered)
    return f"{raw.file or file}:{raw.line}"


def element_at(raw: XmlElement, tag: str, attributes: dict[str, str]) -> XmlElement:
    """A new element that stands where another one does."""
    element = Numbered(tag, attributes)
    element.line, element.file = (raw.line, raw.file) if isinstance(raw, Numbered) else (0, None)
    return element


def parse(text: str | bytes, name: str) -> XmlElement:
    """The root element of an XML document.

    Raises:
        ModelError: no XML, entities or external references, or nested too deeply.
    """
    from defusedxml import DefusedXmlException
    from defusedxml.ElementTree import ParseError

    try:
        root = _numbered(text)
    except DefusedXmlException as problem:
        raise ModelError(
            f"file '{name}': it declares entities or refers to other documents; remove that"
        ) from problem
    except (ParseError, ValueError, LookupError, RecursionError) as problem:
        raise ModelError(f"file '{name}' is not XML: {problem}") from problem
    _check_depth(root, name)
    return root


def _numbered(text: str | bytes) -> XmlElement:
    """The root; every element is :class:`Numbered`."""
    from defusedxml.ElementTree import DefusedXMLParser

    class Builder(TreeBuilder):
        """Writes the line of the parser into every element."""

        def start(self, tag: str, attributes: dict[str, str]) -> XmlElement:
            element = super().start(tag, attributes)
            assert isinstance(element, Numbered)
            element.line = parser.parser.CurrentLineNumber
            return element

    parser = DefusedXMLParser(target=Builder(element_factory=Numbered))
    parser.feed(text)
    return parser.close()


def _check_depth(root: XmlElement, name: str) -> None:
    level, depth = [root], 0
    while level:
        depth += 1
        if depth > DEEPEST:
            raise ModelError(f"file '{name}': elements are nested more than {DEEPEST} deep")
        level = [child for element in level for child in element]


class Element:
    """An XML element with strict access; errors say where it stands.

    Args:
        raw: The parsed element.
        where: Such as ``joint 'elbow'``.
    """

    __slots__ = ("raw", "where")

    def __init__(self, raw: XmlElement, where: str) -> None:
        self.raw = raw
        self.where = where

    def child(self, tag: str) -> Self | None:
        """The first child of that name."""
        child = self.raw.find(tag)
        return None if child is None else type(self)(child, self.where)

    def children(self, tag: str) -> Iterator[Self]:
        """All children of that name."""
        return (type(self)(raw, self.where) for raw in self.raw.findall(tag))

    def word(self, name: str) -> str | None:
        """The text of an attribute, None where it is missing."""
        return self.raw.get(name)

    def lacks(self, name: str) -> str:
        """Message that something is missing."""
        missing = f"{self.where}: <{self.raw.tag}> lacks the attribute '{name}'"
        text = (self.raw.text or "").strip()
        if not text or len(text) > LONGEST_QUOTE:
            return missing
        return f'{missing}: write <{self.raw.tag} {name}="{text}"/>'

    def text(self, name: str, default: str | None = None) -> str:
        """An attribute.

        Raises:
            ModelError: it is missing and has no default.
        """
        value = self.word(name)
        if value is None:
            if default is None:
                raise ModelError(self.lacks(name))
            return default
        return str(value)

    def number(self, name: str, default: str | None = None) -> float:
        """An attribute that is a finite number of sane size."""
        return self.numbers(name, 1, default)[0]

    def numbers(self, name: str, count: int, default: str | None = None) -> list[float]:
        """An attribute of so many numbers, see :meth:`several`."""
        return self.several(name, count, count, default)

    def several(self, name: str, least: int, most: int, default: str | None = None) -> list[float]:
        """An attribute of a few numbers, with blanks between them.

        Raises:
            ModelError: too few or too many, text, NaN or an absurd size.
        """
        text = self.text(name, default)
        # where one number is expected, '1 kg' is a faulty number rather than two
        texts = [text.strip()] if most == 1 else text.split()
        values = [self._finite(name, word, text) for word in texts]
        if not least <= len(values) <= most:
            expected = f"{least} to {most}" if least < most else f"{most}"
            raise ModelError(
                f"{self.where}: {name}={text[:80]!r} of <{self.raw.tag}> has "
                f"{counted(len(values), 'number')}, expected {expected}"
            )
        return values

    def _finite(self, name: str, word: str, text: str) -> float:
        """A number of an attribute, of which the whole text is given too."""
        try:
            value = float(word) if "_" not in word else math.nan
        except ValueError:
            value = math.nan
        if not abs(value) <= LARGEST_NUMBER:
            where = f"{self.where}: {name} of <{self.raw.tag}>"
            if "," in word:
                blanks = " ".join(text[:80].replace(",", " ").split())
                raise ModelError(
                    f"{where}: {text[:80]!r} has commas, but blanks separate numbers: write "
                    f"{blanks!r}"
                )
            size = f" up to {LARGEST_NUMBER:g}" if _is_number(word) else ""
            raise ModelError(f"{where}: {word[:40]!r} is not a number{size}")
        return value

    def optional(self, name: str) -> float | None:
        """An attribute that may be missing or infinite: then None."""
        word = self.word(name)
        if word is None:
            return None
        try:
            value = float(word)
        except ValueError as problem:
            raise ModelError(
                f"{self.where}: {name} of <{self.raw.tag}>: {word[:40]!r} is not a number"
            ) from problem
        if math.isnan(value):
            raise ModelError(f"{self.where}: {name} of <{self.raw.tag}> is not a number")
        return value if abs(value) <= LARGEST_NUMBER else None


def _is_number(word: str) -> bool:
    """True where a text is a number of any size."""
    try:
        return not math.isnan(float(word)) and "_" not in word
    except ValueError:
        return False
