"""YAML 1.2 text to a tree whose every value knows its line and column.

Only mappings, lists and scalars: no tags, no objects, no merge keys. Sizes and depths are checked
while the text is read, aliases before anything walks over what they repeat.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field, replace
from typing import Any

from ....errors import ModelError
from ....records import dataclass
from ....version import SCENE

FIRST_LINE = f"{SCENE.word}: {SCENE.version}"
LARGEST_TEXT = 8 * 2**20
MOST_NODES = 500_000
DEEPEST = 40
LONGEST_SCALAR = 10_000


@dataclass(eq=False, slots=True)
class Scalar:
    """A text; ``plain`` where it stands without quotes, so that it may be a number or null."""

    line: int
    column: int
    text: str
    plain: bool
    size: int = 1
    height: int = 0


@dataclass(eq=False, slots=True)
class Listing:
    """Values in order. ``size`` counts all values below, those behind aliases each time."""

    line: int
    column: int
    entries: list[Node] = field(default_factory=list)
    size: int = 1
    height: int = 0


@dataclass(eq=False, slots=True)
class Mapping:
    """Values by name; ``keys`` are the names with their places."""

    line: int
    column: int
    entries: dict[str, Node] = field(default_factory=dict)
    keys: dict[str, Scalar] = field(default_factory=dict)
    size: int = 1
    height: int = 0


Node = Scalar | Listing | Mapping


def decoded(data: bytes, name: str) -> str:
    """The text of a file.

    Raises:
        ModelError: it is empty, too large or no UTF-8.
    """
    if len(data) > LARGEST_TEXT:
        raise ModelError(
            f"file '{name}' has {len(data) / 2**20:.0f} MiB; a scene has at most "
            f"{LARGEST_TEXT // 2**20} MiB"
        )
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        line = data.count(b"\n", 0, problem.start) + 1
        raise ModelError(
            f"{name}:{line}: byte {problem.start} is not UTF-8; save the file as UTF-8 text"
        ) from problem
    if not text.strip():
        raise ModelError(f"file '{name}' is empty; a scene begins with '{FIRST_LINE}'")
    return text


def parse(text: str, name: str) -> Node:
    """The tree of a document.

    Args:
        text: The document.
        name: Of the file, for messages.

    Raises:
        ModelError: no YAML, duplicate keys, tags, or absurd sizes; with file, line and column.
    """
    from ruamel.yaml import YAML
    from ruamel.yaml.error import MarkedYAMLError, YAMLError

    try:
        return _Builder(name).document(YAML(typ="safe", pure=True).parse(text))
    except ModelError:
        raise
    except MarkedYAMLError as problem:
        mark = problem.problem_mark or problem.context_mark
        place = f"{name}:{mark.line + 1}:{mark.column + 1}" if mark else name
        problem_text = " ".join(str(problem.problem or problem.context).split())
        raise ModelError(f"{place}: no YAML: {problem_text}") from problem
    except (YAMLError, ValueError, OverflowError) as problem:
        problem_text = " ".join(str(problem).split())[:200]
        raise ModelError(f"file '{name}' is not YAML: {problem_text}") from problem


def renamed(node: Node, place: tuple[str, ...], version: int) -> Node:
    """A scene of an older version under the names that keys have today."""
    if not any(older >= version for older in SCENE.renamed):
        return node
    if isinstance(node, Listing):
        entries = [renamed(n, (*place, str(k)), version) for k, n in enumerate(node.entries)]
        return replace(node, entries=entries)
    if isinstance(node, Scalar):
        return replace(node, text=SCENE.text_today(node.text, place, version))
    names = {name: SCENE.today((*place, name), version) for name in node.entries}
    # a name of today in an older scene is as unknown as it was
    names = {name: name if new in node.entries else new for name, new in names.items()}
    inner = {names[n]: renamed(x, (*place, n), version) for n, x in node.entries.items()}
    return replace(node, entries=inner, keys={names[n]: x for n, x in node.keys.items()})


@dataclass
class _Builder:
    """One reading.

    Attributes:
        name: Of the file.
        anchors: What an anchor names; None while it is not complete.
        stack: The mappings and lists that are open, each with its anchor and its waiting key.
    """

    name: str
    anchors: dict[str, Node | None] = field(default_factory=dict)
    stack: list[_Open] = field(default_factory=list)
    root: Node | None = None

    def document(self, events: Iterator[Any]) -> Node:
        for event in events:
            kind = type(event).__name__
            self._check(event, kind)
            if kind == "ScalarEvent":
                self._add(event, self._scalar(event), event.anchor)
            elif kind == "AliasEvent":
                self._add(event, self._alias(event), None)
            elif kind in ("MappingStartEvent", "SequenceStartEvent"):
                self._open(event, kind)
            elif kind in ("MappingEndEvent", "SequenceEndEvent"):
                closed = self.stack.pop()
                self._add(event, closed.node, closed.anchor)
        if self.root is None:
            raise ModelError(f"file '{self.name}' is empty; a scene begins with '{FIRST_LINE}'")
        return self.root

    def _check(self, event: Any, kind: str) -> None:
        """Refuse constructs that no scene needs: other versions, several documents, tags."""
        if kind == "DocumentStartEvent":
            if event.version not in (None, (1, 2)):
                raise self._error(event, "only YAML 1.2 is read; leave the %YAML line out")
            if event.tags:
                raise self._error(event, "tags are not read; leave the %TAG line out")
            if self.root is not None:
                raise self._error(event, "a second document begins here; a scene is one document")
        elif getattr(event, "tag", None) is not None:
            raise self._error(event, f"the tag '{event.tag}' is not read; leave it out")

    def _error(self, event: Any, message: str) -> ModelError:
        mark = event.start_mark
        return ModelError(f"{self.name}:{mark.line + 1}:{mark.column + 1}: {message}")

    def _scalar(self, event: Any) -> Scalar:
        if len(event.value) > LONGEST_SCALAR:
            raise self._error(event, f"a text of {len(event.value)} characters is too long")
        if any("\ud800" <= character <= "\udfff" for character in event.value):
            raise self._error(event, "half a surrogate pair is not a character")
        mark, plain = event.start_mark, event.style in (None, "")
        return Scalar(mark.line + 1, mark.column + 1, event.value, plain)

    def _alias(self, event: Any) -> Node:
        target = self.anchors.get(event.anchor)
        if target is None:
            inside = event.anchor in self.anchors
            why = "contains itself" if inside else "names no &anchor above it"
            raise self._error(event, f"the alias *{event.anchor[:80]} {why}")
        return target

    def _open(self, event: Any, kind: str) -> None:
        mark = event.start_mark
        if len(self.stack) >= DEEPEST:
            raise self._error(event, f"values are nested more than {DEEPEST} deep")
        make = Mapping if kind == "MappingStartEvent" else Listing
        self.stack.append(_Open(make(mark.line + 1, mark.column + 1), event.anchor))
        if event.anchor is not None:
            self.anchors[event.anchor] = None

    def _add(self, event: object, node: Node, anchor: str | None) -> None:
        """Put a complete value where it belongs: a key, a value of a key, or an entry."""
        if anchor is not None:
            self.anchors[anchor] = node
        if not self.stack:
            self.root = node
            return
        outer = self.stack[-1]
        parent = outer.node
        parent.size += node.size
        parent.height = max(parent.height, node.height + 1)
        if parent.size > MOST_NODES or len(self.stack) + node.height > DEEPEST:
            what = f"{MOST_NODES} values" if parent.size > MOST_NODES else f"{DEEPEST} levels"
            raise self._error(event, f"more than {what}, those behind aliases counted each time")
        if isinstance(parent, Listing):
            parent.entries.append(node)
        elif outer.key is None:
            outer.key = self._key(event, parent, node)
        else:
            parent.entries[outer.key.text] = node
            outer.key = None

    def _key(self, event: object, parent: Mapping, node: Node) -> Scalar:
        if not isinstance(node, Scalar):
            raise self._error(event, "a key must be a text, not a list or a mapping")
        first = parent.keys.get(node.text)
        if first is not None:
            raise self._error(
                event,
                f"the key '{node.text[:80]}' is here twice, first in line {first.line}; "
                "rename or remove one of them",
            )
        parent.keys[node.text] = node
        return node


@dataclass(slots=True)
class _Open:
    """A mapping or list that is being read."""

    node: Listing | Mapping
    anchor: str | None
    key: Scalar | None = None
