"""Strict access to the values of a scene file; errors say where they stand."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from ....errors import ModelError, TopologyError, near
from ....records import dataclass
from .keys import Key
from .tree import Listing, Mapping, Node, Scalar

NUMBER = re.compile(r"[-+]?(\d+(\.\d*)?|\.\d+)([eE][-+]?\d+)?")
LONGEST_NUMBER = 60
COMMAS = " In [] and {} an expression with commas needs quotes."
NULL = ("", "~", "null", "Null", "NULL")


@dataclass(frozen=True, eq=False)
class Item:
    """A value of the file.

    Attributes:
        node: What stands there.
        path: Dotted name of the place, such as ``joints.elbow.axis``.
        file: Name of the file.
        name: The key it stands under.
        key: The node of that key; ``line`` and ``column`` are where the value begins, or its key.
    """

    node: Node
    path: str
    file: str
    name: str = ""
    key: Scalar | None = None

    @property
    def position(self) -> str:
        """``scene.yaml:12:7``: of the value."""
        return f"{self.file}:{self.node.line}:{self.node.column}"

    @property
    def spot(self) -> str:
        """``scene.yaml:12:3``: of the key, or of the value where it has none."""
        node = self.key or self.node
        return f"{self.file}:{node.line}:{node.column}"

    @property
    def where(self) -> str:
        """Position and path: the head of a message."""
        return f"{self.position}: {self.path}" if self.path else self.position

    def error(self, message: str) -> ModelError:
        return ModelError(f"{self.where}: {message}")

    def at_key(self, message: str) -> ModelError:
        """An error about the key rather than its value."""
        return ModelError(f"{self.spot}: {self.path}: {message}")

    @contextmanager
    def at_item(self, named: bool = False) -> Iterator[None]:
        """Errors of the model raised inside say where in the file the item stands.

        Args:
            named: Say the path too, for errors that do not name the item themselves.
        """
        path = f"{self.path}: " if named else ""
        try:
            yield
        except (ModelError, TopologyError) as problem:
            raise type(problem)(f"{self.spot}: {path}{problem}") from problem

    @property
    def is_null(self) -> bool:
        """True where nothing is given: the same as leaving the key out."""
        return isinstance(self.node, Scalar) and self.node.plain and self.node.text in NULL

    @property
    def is_text(self) -> bool:
        return isinstance(self.node, Scalar)

    @property
    def is_list(self) -> bool:
        return isinstance(self.node, Listing)

    def text(self) -> str:
        """A text, quoted or not; numbers and ``on`` are texts here.

        Raises:
            ModelError: a list, a mapping or nothing.
        """
        if not isinstance(self.node, Scalar) or self.is_null:
            raise self.error(f"a text is wanted, not {self.description()}")
        return self.node.text

    def number(self) -> int | float | None:
        """The number an unquoted word is, None where it is none.

        Raises:
            ModelError: a number of absurd length, or too large for the machine.
        """
        node = self.node
        if not isinstance(node, Scalar) or not node.plain or not NUMBER.fullmatch(node.text):
            return None
        if len(node.text) > LONGEST_NUMBER:
            raise self.error(f"a number of {len(node.text)} characters is too long")
        integer = node.text.lstrip("+-").isdigit()
        value = int(node.text) if integer else float(node.text)
        if abs(value) > 1e300:
            raise self.error(f"{node.text} is too large; numbers go up to 1e300")
        return value

    def description(self) -> str:
        """Description of the entry, for messages."""
        if isinstance(self.node, Scalar):
            return "nothing" if self.is_null else f"'{self.node.text[:60]}'"
        return "a list" if isinstance(self.node, Listing) else "a mapping"

    def entries(self, what: str = "a list") -> list[Item]:
        """The entries of a list.

        Raises:
            ModelError: no list.
        """
        if not isinstance(self.node, Listing):
            raise self.error(f"{what} is wanted, not {self.description()}")
        return [
            Item(node, f"{self.path}[{i}]", self.file) for i, node in enumerate(self.node.entries)
        ]

    def three(self) -> list[Item]:
        """The entries of a list of three.

        Raises:
            ModelError: no list, or another count.
        """
        entries = self.entries("a list of three")
        if len(entries) != 3:
            split = any(entry.description().count("(") for entry in entries)
            hint = "." + COMMAS if split else ""
            raise self.error(f"three entries are wanted, not {len(entries)}{hint}")
        return entries

    def items(self, what: str = "a mapping of names") -> dict[str, Item]:
        """The values of a mapping by name.

        Raises:
            ModelError: no mapping.
        """
        if not isinstance(self.node, Mapping):
            raise self.error(f"{what} is wanted, not {self.description()}")
        head = f"{self.path}." if self.path else ""
        keys = self.node.keys
        return {
            name: Item(node, head + name[:80], self.file, name, keys[name])
            for name, node in self.node.entries.items()
        }

    def fields(self, keys: Sequence[Key], what: str) -> dict[str, Item]:
        """The values of a mapping with known keys; those that are null are left out.

        Args:
            keys: What it may have.
            what: Such as ``a body``, for messages.

        Raises:
            ModelError: no mapping, an unknown key or a missing one.
        """
        items = self.items(f"{what} such as {example(keys)}")
        names = [key.name for key in keys]
        for name, item in items.items():
            if name not in names:
                listed = near(name, names).replace(" Known:", " Keys:")
                listed = COMMAS if name.count(")") > name.count("(") else listed
                raise item.at_key(f"{what} has no key '{name[:80]}'.{listed}")
        missing = [key.name for key in keys if key.required and key.name not in items]
        if missing:
            raise self.error(f"{what} needs the key '{missing[0]}'")
        empty = [key.name for key in keys if key.required and items[key.name].is_null]
        if empty:
            raise items[empty[0]].error(f"{what} needs a value here")
        return {name: item for name, item in items.items() if not item.is_null}


def example(keys: Sequence[Key]) -> str:
    """``{joint: ..., damping: ...}``: the keys that must be there, or the first ones."""
    names = [key.name for key in keys if key.required] or [key.name for key in keys[:2]]
    return "{" + ", ".join(f"{name}: ..." for name in names) + "}"
