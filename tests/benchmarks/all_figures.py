"""One table of every figure to reach, from all programs of ``make bench``, the missed ones first.

The programs leave their figures in out/figures; this one, the last, prints them and writes
docs/performance/figures.md, which says of each on which page it stands.

usage: all_figures.py [--quick]
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from rich.console import Console
from rich.table import Table

from benchmarks.page import markdown
from benchmarks.provenance import signed

ROOT = Path(__file__).parents[2]
SAVED = ROOT / "out" / "figures"
PAGE = ROOT / "docs" / "performance" / "figures.md"
HEADINGS = ("figure", "to reach", "measured", "reached", "page")
REACHED = {"reached": "yes", "missed": "no", "time": "no"}
WIDTH = 160
TEXT = """# Figures to reach

Every figure that is to be reached, those that are missed first. The page of a row has the peers
beside it, the errors and, of what is missed, where the time goes. Written by the end of `make
bench`.
"""
Row = tuple[str, str, str, str]


def save(page: str, rows: Iterable[Row]) -> None:
    """Leave figures for the table of all.

    Args:
        page: Where they stand, ``python_calls.md``.
        rows: Name, what is to be reached, what was measured and ``yes`` or ``no`` each.
    """
    SAVED.mkdir(parents=True, exist_ok=True)
    (SAVED / page).with_suffix(".json").write_text(json.dumps([*rows]), "utf-8")


def saved() -> list[tuple[str, ...]]:
    """Rows of all programs with their pages, the missed ones first."""
    rows = []
    for file in sorted(SAVED.glob("*.json")):
        page = file.with_suffix(".md").name
        for name, target, measured, reached in json.loads(file.read_text("utf-8")):
            rows.append((name, target, measured, REACHED.get(reached, reached), page))
    return sorted(rows, key=lambda row: row[3] == "yes")


def show(rows: Sequence[Sequence[str]]) -> None:
    """On the screen."""
    table = Table(title="figures to reach", title_justify="left", box=None, pad_edge=False)
    for heading in HEADINGS:
        table.add_column(heading)
    for row in rows:
        table.add_row(*row)
    Console(width=WIDTH).print(table)


def write(rows: Sequence[Sequence[str]]) -> None:
    """On its page."""
    linked = [(*row[:-1], f"[{row[-1]}]({row[-1]})") for row in rows]
    PAGE.write_text(signed(f"{TEXT}\n" + "\n".join(markdown(HEADINGS, linked, 5))), "utf-8")


def main() -> None:
    """Print, write."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="write no page")
    quick = parser.parse_args().quick
    rows = saved()
    show(rows)
    if not quick:
        write(rows)


if __name__ == "__main__":
    main()
