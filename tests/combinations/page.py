"""Tries every cell and writes docs/what_goes_with_what.md.

usage: python tests/combinations/page.py --accept [FEATURE ...]

With names of features these alone are tried; the page is believed of the others.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Collection, Iterable
from itertools import product
from math import comb
from pathlib import Path

# the package of these files stands in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

from cardan.schema.integrators import INTEGRATORS
from combinations import cells
from combinations.features import FEATURES, PRESENT
from combinations.refusals import Refusal, expected

PAGE = Path(__file__).parents[2] / "docs" / "what_goes_with_what.md"
SCRIPT = "python tests/combinations/page.py --accept"
HEAD = f"""\
# What goes with what

This page is written by `{SCRIPT}`, from what cardan says when
each combination is tried. A dot means that it runs. A letter means that it is refused. The refusals
with their reasons and cures stand at the end.

The features are added to two bars that swing; `tests/combinations` has the scenes. It also runs
sets of seven in which every two features meet, each in two kinds of coordinates.

"""
TITLES = {
    cells.RIGID: "rigid bodies, joint coordinates",
    cells.ELASTIC: "a beam in the scene, nodes and rigid trees",
}
COLUMNS = {"integrators": tuple(INTEGRATORS), "uses": tuple(cells.USES)}
MESSAGE = re.compile(r"^\*\*(\w)\*\*: .*\n\n    (.*)$", re.M)
REFUSED_PAIR = re.compile(r"^- (.*) and (.*): (\w)$", re.M)
Cells = dict[tuple[str, str, str], str]
Pairs = dict[tuple[str, str], str]


def measured(names: Collection[str] = PRESENT) -> tuple[Cells, Pairs]:
    """What is said in every cell (kind of scene, feature, integrator or use), and by pairs."""
    table: Cells = {}
    for kind in TITLES:
        for name in names:
            table |= {(kind, n, asked): said for n, asked, said in cells.of_feature(name, kind)}
    return table, {(one, other): said for one, other, said in cells.pairs(names)}


def stated(text: str) -> tuple[Cells, Pairs]:
    """The same as a page has it, a message for every letter."""
    messages = dict(MESSAGE.findall(text)) | {"·": ""}
    pairs = {(one, other): messages[mark] for one, other, mark in REFUSED_PAIR.findall(text)}
    table: Cells = {}
    sections = text.split("\n## Features with ")[2:]
    for (columns, kind), section in zip(product(COLUMNS.values(), TITLES), sections, strict=True):
        for line in section.split("\n## ")[0].splitlines()[4:]:
            name, *marks = (mark.strip() for mark in line.strip("|").split("|"))
            said = (messages[mark] for mark in marks)
            table |= {(kind, name, c): x for c, x in zip(columns, said, strict=True)}
    return table, pairs


class Letters:
    """Refusals in the order in which they are met, with their letters."""

    def __init__(self) -> None:
        self.rows: dict[Refusal, str] = {}
        self.messages: dict[Refusal, str] = {}

    def of(self, names: Iterable[str], asked: str, said: str) -> str:
        """The mark of a cell."""
        if not said:
            return "·"
        row = expected(names, asked, said)
        self.messages.setdefault(row, said)
        return self.rows.setdefault(row, chr(ord("a") + len(self.rows)))

    def text(self) -> str:
        """The refusals."""
        lines = []
        for row, letter in self.rows.items():
            lines.append(f"**{letter}**: {row.reason}\n")
            lines.append(f"    {self.messages[row]}\n")
        return "\n".join(lines)


def grid(table: Cells, kind: str, columns: Iterable[str], letters: Letters) -> str:
    """One table: features down, integrators or uses across."""
    columns = list(columns)
    lines = [f"| | {' | '.join(columns)} |", f"|---|{'---|' * len(columns)}"]
    for name in PRESENT:
        names = (name,) if kind == cells.RIGID else (name, "beam")
        marks = [letters.of(names, c, table[kind, name, c]) for c in columns]
        lines.append(f"| {name} | {' | '.join(marks)} |")
    return "\n".join(lines) + "\n"


def page(table: Cells, pairs: Pairs) -> str:
    """The page."""
    letters, parts = Letters(), [HEAD, "## Features with each other\n\n"]
    refused = {pair: said for pair, said in pairs.items() if said}
    count = comb(len(FEATURES), 2)
    parts.append(
        f"{len(FEATURES)} features make {count} pairs. {count - len(refused)} of them "
        "have equations together.\n"
    )
    for pair, said in refused.items():
        parts.append(f"\n- {' and '.join(pair)}: {letters.of(pair, 'derive', said)}\n")
    for what, columns in COLUMNS.items():
        for kind, title in TITLES.items():
            parts.append(f"\n## Features with {what}: {title}\n\n")
            parts.append(grid(table, kind, columns, letters))
    parts.append("\n## Refusals\n\n" + letters.text())
    return "".join(parts)


def main() -> int:
    """Write the page, or say whether it is up to date."""
    current = PAGE.read_text("utf-8") if PAGE.exists() else ""
    names = [name for name in sys.argv[1:] if name != "--accept"]
    table, pairs = stated(current) if names else ({}, {})
    tried, tried_pairs = measured(names or PRESENT)
    text = page(table | tried, pairs | tried_pairs)
    if "--accept" in sys.argv[1:]:
        PAGE.write_text(text, "utf-8")
        return 0
    if current != text:
        print(f"docs/{PAGE.name} is not up to date: {SCRIPT}")
    return int(current != text)


if __name__ == "__main__":
    sys.exit(main())
