"""Tries every cell and writes docs/what_goes_with_what.md.

usage: python tests/combinations/page.py --accept
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
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
Cells = dict[tuple[str, str, str], str]


def measured() -> tuple[Cells, dict[tuple[str, str], str]]:
    """What is said in every cell (kind of scene, feature, integrator or use), and by pairs."""
    table: Cells = {}
    for kind in (cells.RIGID, cells.ELASTIC):
        for name in PRESENT:
            table |= {(kind, n, asked): said for n, asked, said in cells.of_feature(name, kind)}
    return table, {(one, other): said for one, other, said in cells.pairs()}


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


def page(table: Cells, pairs: dict[tuple[str, str], str]) -> str:
    """The page."""
    letters, parts = Letters(), [HEAD, "## Features with each other\n\n"]
    refused = {pair: said for pair, said in pairs.items() if said}
    parts.append(
        f"{len(FEATURES)} features make {len(pairs)} pairs. {len(pairs) - len(refused)} of them "
        "have equations together.\n"
    )
    for pair, said in refused.items():
        parts.append(f"\n- {' and '.join(pair)}: {letters.of(pair, 'derive', said)}\n")
    titles = {
        cells.RIGID: "rigid bodies, joint coordinates",
        cells.ELASTIC: "a beam in the scene, nodes and rigid trees",
    }
    for what, columns in (("integrators", list(INTEGRATORS)), ("uses", list(cells.USES))):
        for kind, title in titles.items():
            parts.append(f"\n## Features with {what}: {title}\n\n")
            parts.append(grid(table, kind, columns, letters))
    parts.append("\n## Refusals\n\n" + letters.text())
    return "".join(parts)


def main() -> int:
    """Write the page, or say whether it is up to date."""
    text = page(*measured())
    if "--accept" in sys.argv[1:]:
        PAGE.write_text(text, "utf-8")
        return 0
    current = PAGE.read_text("utf-8") if PAGE.exists() else ""
    if current != text:
        print(f"docs/{PAGE.name} is not up to date: {SCRIPT}")
    return int(current != text)


if __name__ == "__main__":
    sys.exit(main())
