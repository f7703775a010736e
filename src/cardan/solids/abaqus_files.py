"""Meshes of Abaqus and CalculiX: nodes, elements, and NSET, ELSET and SURFACE.

Source: CalculiX CrunchiX User's Manual, version 2.20, chapter 7 (keywords) and section 6.2
(elements and numbers of their faces).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import field
from pathlib import Path

import numpy as np

from .. import regular_file
from ..arrays import Integers
from ..errors import ModelError
from ..records import dataclass
from .cells import CELLS, FACES, SOLIDS
from .checks import checked_cells, checked_points
from .contents import Contents
from .topology import FACE_KINDS

KINDS = {name: cell.kind for cell in CELLS.values() for name in cell.abaqus}
# of elements without volume or face, whose nodes a set may list: trusses, beams, springs, masses
LINES = re.compile(r"(T2D|T3D|B2|B3|SPRING|DASHPOT|MASS|GAP|DCOUP)")
SIDE = re.compile(r"S([1-6])$")
FLAT = "write the deck without parts and instances"
LONGEST = 200  # characters of a reason
MOST_LABELS = 10_000_000  # of all sets together, which lines may generate or repeat


@dataclass
class Deck:
    """An input deck, in its own labels; names keep their first spelling, whatever the case.

    Attributes:
        source: What messages call it.
        nodes: Positions by label.
        elements: Kind and labels of the nodes, by label.
        nsets, elsets: Labels by name.
        sides: Element or set, and number of a face, by name of a surface.
        spelling: The first spelling of a name, by capital letters.
        listed: Labels in all sets together.
    """

    source: str
    nodes: dict[int, list[float]] = field(default_factory=dict)
    elements: dict[int, tuple[str, list[int]]] = field(default_factory=dict)
    nsets: dict[str, list[int]] = field(default_factory=dict)
    elsets: dict[str, list[int]] = field(default_factory=dict)
    sides: dict[str, list[tuple[str, int]]] = field(default_factory=dict)
    spelling: dict[str, str] = field(default_factory=dict)
    listed: int = 0

    def name(self, written: str) -> str:
        """A name in its first spelling."""
        return self.spelling.setdefault(written.upper(), written)


def contents(path: Path) -> Contents:
    """The mesh of an input deck.

    Raises:
        ModelError: a line cannot be read, or labels do not fit each other; the line is named.
    """
    deck = Deck(path.name)
    try:
        text = regular_file.content(path).decode("utf-8", "replace")
    except OSError as error:
        raise ModelError(f"{path}: it cannot be read: {error.strerror}") from error
    for number, keyword, options, rows in _blocks(text):
        reader = READERS.get(keyword)
        if reader is None:
            continue
        try:
            reader(deck, options, rows)
        except (ValueError, IndexError, KeyError) as error:
            reason = f"{error} is missing" if isinstance(error, KeyError) else str(error)
            raise ModelError(
                f"{deck.source}: *{keyword} in line {number} cannot be read: {reason[:LONGEST]}"
            ) from error
    return _numbered(deck)


def _blocks(text: str) -> Iterator[tuple[int, str, dict[str, str], list[list[str]]]]:
    """Line, keyword, options and rows of data of each keyword."""
    line, keyword = 0, ""
    options: dict[str, str] = {}
    rows: list[list[str]] = []
    for number, raw in enumerate(text.splitlines(), 1):
        row = raw.strip()
        if row.startswith("**") or not row:
            continue
        if not row.startswith("*"):
            rows.append([entry.strip() for entry in row.split(",")])
            continue
        if keyword:
            yield line, keyword, options, rows
        head, *entries = row[1:].split(",")
        pairs = (entry.partition("=") for entry in entries)
        # blanks inside of keywords do not count
        keyword = "".join(head.split()).upper()
        options = {key.strip().upper(): value.strip() for key, _, value in pairs}
        line, rows = number, []
    if keyword:
        yield line, keyword, options, rows


def _node(deck: Deck, options: dict[str, str], rows: list[list[str]]) -> None:
    if options.get("SYSTEM", "R").upper() != "R":
        raise ValueError(
            "nodes in cylindrical or spherical coordinates are not read; write x, y, z"
        )
    for label, *coordinates in rows:
        if int(label) in deck.nodes:
            raise ValueError(f"node {label} is there twice: {FLAT}")
        position = [float(x) for x in coordinates if x][:3]
        deck.nodes[int(label)] = position + [0.0] * (3 - len(position))
    if "NSET" in options:
        deck.nsets.setdefault(deck.name(options["NSET"]), []).extend(int(row[0]) for row in rows)


def _element(deck: Deck, options: dict[str, str], rows: list[list[str]]) -> None:
    name = options["TYPE"].upper()
    kind = KINDS.get(name, "")
    if not kind and not LINES.match(name):
        names = ", ".join(n for cell in CELLS.values() for n in cell.abaqus if n.startswith("C3D"))
        raise ValueError(f"elements {name} are not treated; of solids these are: {names}")
    width = len(CELLS[kind].nodes) if kind else 0
    labels: list[int] = []
    entries: list[int] = []
    for row in rows:
        entries += [int(entry) for entry in row if entry]
        # a row that is too short goes on in the next one
        if len(entries) <= width:
            continue
        label, *nodes = entries
        if label in deck.elements:
            raise ValueError(f"element {label} is there twice: {FLAT}")
        if width and len(nodes) != width:
            raise ValueError(f"element {label} has {len(nodes)} nodes, {name} has {width}")
        labels.append(label)
        if kind:
            deck.elements[label] = (kind, nodes)
        entries = []
    if entries and width:
        raise ValueError(f"element {entries[0]} has {len(entries) - 1} nodes, {name} has {width}")
    if "ELSET" in options and kind:
        deck.elsets.setdefault(deck.name(options["ELSET"]), []).extend(labels)


def _set(
    deck: Deck,
    sets: dict[str, list[int]],
    name: str,
    options: dict[str, str],
    rows: list[list[str]],
) -> None:
    """Labels and names of other sets; GENERATE: first, last, step."""
    target = sets.setdefault(deck.name(name), [])
    for row in rows:
        entries = [entry for entry in row if entry]
        if "GENERATE" in options:
            first, last, step = [int(entry) for entry in (*entries, "1")][:3]
            if step < 1 or (last - first) // step > MOST_LABELS:
                raise ValueError(f"set {name}: {first}, {last}, {step}")
            _extend(deck, name, target, range(first, last + 1, step))
            continue
        for entry in entries:
            if entry.lstrip("-").isdigit():
                _extend(deck, name, target, (int(entry),))
            elif deck.name(entry) in sets:
                _extend(deck, name, target, sets[deck.name(entry)])
            else:
                raise ValueError(f"set {name}: there is no set {entry}")


def _extend(deck: Deck, name: str, target: list[int], labels: Sequence[int]) -> None:
    """Add labels to a set, in limits: a few lines could fill the memory."""
    deck.listed += len(labels)
    if deck.listed > MOST_LABELS:
        raise ValueError(f"set {name}: more than {MOST_LABELS} labels in all sets; leave some out")
    target.extend(labels)


def _nset(deck: Deck, options: dict[str, str], rows: list[list[str]]) -> None:
    _set(deck, deck.nsets, options["NSET"], options, rows)


def _elset(deck: Deck, options: dict[str, str], rows: list[list[str]]) -> None:
    _set(deck, deck.elsets, options["ELSET"], options, rows)


def _surface(deck: Deck, options: dict[str, str], rows: list[list[str]]) -> None:
    name = deck.name(options["NAME"])
    if options.get("TYPE", "").upper() == "NODE":
        _set(deck, deck.nsets, name, {}, [row[:1] for row in rows])
        return
    for row in rows:
        side = SIDE.match(row[1].upper() if len(row) > 1 else "")
        if side is None:
            raise ValueError(f"surface {name}: {', '.join(row)}: give element or set, and S1 to S6")
        deck.sides.setdefault(name, []).append((deck.name(row[0]), int(side[1]) - 1))


def _instance(deck: Deck, options: dict[str, str], rows: list[list[str]]) -> None:
    if rows:
        raise ValueError(
            f"{options.get('NAME', '')}: instances that are moved are not read: {FLAT}"
        )


def _generated(deck: Deck, options: dict[str, str], rows: list[list[str]]) -> None:
    raise ValueError("nodes and elements that a program has to generate are not read; list them")


def _include(deck: Deck, options: dict[str, str], rows: list[list[str]]) -> None:
    raise ValueError(
        f"{options.get('INPUT', '')}: files that include others are not read; join them"
    )


READERS = {
    "NODE": _node,
    "ELEMENT": _element,
    "NSET": _nset,
    "ELSET": _elset,
    "SURFACE": _surface,
    "INCLUDE": _include,
    "INSTANCE": _instance,
    **dict.fromkeys(("NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM"), _generated),
}


def _numbered(deck: Deck) -> Contents:
    """A deck in numbers from 0, in the order of its lines."""
    node = {label: k for k, label in enumerate(deck.nodes)}
    result = Contents(checked_points(deck.source, list(deck.nodes.values()), None))
    members: dict[str, list[list[int]]] = {}
    row: dict[int, tuple[str, int]] = {}
    for label, (kind, labels) in deck.elements.items():
        missing = [one for one in labels if one not in node]
        if missing:
            raise ModelError(f"{deck.source}: element {label}: there is no node {missing[0]}")
        listed = members.setdefault(kind, [])
        row[label] = (kind, len(listed))
        listed.append([node[one] for one in labels])
    arrays = {kind: np.array(rows) for kind, rows in members.items()}
    count = len(result.points)
    solids = {kind: cells for kind, cells in arrays.items() if kind in SOLIDS}
    result.cells = checked_cells(deck.source, solids, count)
    for name, labels in deck.nsets.items():
        missing = [one for one in labels if one not in node]
        if missing:
            raise ModelError(f"{deck.source}: set {name}: there is no node {missing[0]}")
        if labels:
            result.node_sets[name] = np.unique([node[one] for one in labels]).astype(np.intp)
    for name, labels in deck.elsets.items():
        # elements that are neither solids nor faces were left out
        for kind, rows in _by_kind(row, labels).items():
            if kind in SOLIDS:
                result.regions.setdefault(name, {})[kind] = rows
            elif kind in FACES:
                result.surfaces.setdefault(name, {})[kind] = arrays[kind][rows]
    for name, sides in deck.sides.items():
        result.surfaces.setdefault(name, {}).update(_faces(deck, row, arrays, name, sides))
    return result


def _by_kind(row: dict[int, tuple[str, int]], labels: list[int]) -> dict[str, Integers]:
    """Rows of elements by kind."""
    result: dict[str, list[int]] = {}
    for label in labels:
        if label in row:
            kind, number = row[label]
            result.setdefault(kind, []).append(number)
    return {kind: np.unique(numbers).astype(np.intp) for kind, numbers in result.items()}


def _faces(
    deck: Deck,
    row: dict[int, tuple[str, int]],
    cells: dict[str, Integers],
    name: str,
    sides: list[tuple[str, int]],
) -> dict[str, Integers]:
    """Nodes of the faces of a surface by kind."""
    result: dict[str, list[Integers]] = {}
    for target, side in sides:
        if target.isdigit():
            labels = [int(target)]
        elif target in deck.elsets:
            labels = deck.elsets[target]
        else:
            raise ModelError(f"{deck.source}: surface {name}: there is no set {target}")
        for kind, rows in _by_kind(row, labels).items():
            faces = CELLS[kind].faces
            if side >= len(faces):
                raise ModelError(f"{deck.source}: surface {name}: a {kind} has no face S{side + 1}")
            nodes = cells[kind][rows][:, list(faces[side])]
            result.setdefault(FACE_KINDS[nodes.shape[1]].kind, []).append(nodes)
    if not result:
        raise ModelError(f"{deck.source}: surface {name}: its elements do not exist")
    return {kind: np.unique(np.concatenate(rows), axis=0) for kind, rows in result.items()}
