"""Speed beside error, and beside other programs, in one interleaved run.

Writes docs/performance and prints the table of figures to reach. Times are reported, never
asserted; the status is 1 where a batch does one state at a time on a processor with vectors.

usage: bench.py [--quick]
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import warnings
from pathlib import Path

# the zoo and the cases stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

from rich.console import Console
from rich.table import Table

from benchmarks import page, pictures
from benchmarks.all_figures import save
from benchmarks.figures import Figure, figures
from benchmarks.measure import Found, run
from cardan.cli.terminal import progress

FOLDER = Path(__file__).parents[2] / "docs" / "performance"
ROUNDS, QUICK_ROUNDS = 15, 5
WIDTH = 150


def main() -> int:
    """Measure, write, print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="a few mechanisms; writes no page")
    quick = parser.parse_args().quick
    warnings.simplefilter("ignore")
    with tempfile.TemporaryDirectory(prefix="cardan-bench-") as private, progress() as show:
        # peers may be kept compiled; ours start from nothing
        os.environ.setdefault("CARDAN_CACHE", f"{private}/cache")
        found = run(quick, QUICK_ROUNDS if quick else ROUNDS, show)
    rows = figures(found)
    save("README.md", [row.texts() for row in rows])
    if not quick:
        pictures.write(found, FOLDER)
        page.write(found, rows, FOLDER)
    out = Console(width=WIDTH)
    tables(found, [row for row in rows if row.value is not None or not quick], out)
    if found.lanes == 1 and found.peak.lanes > 2:
        out.print(f"FAILED: a batch does one state at a time; {found.peak.lanes} lanes are here")
        return 1
    return 0


def tables(found: Found, rows: list[Figure], out: Console) -> None:
    """Everything on a screen."""
    for title, headings, lines in page.sections(found):
        table = Table(title=title, title_justify="left", box=None, pad_edge=False)
        for k, heading in enumerate(headings):
            table.add_column(heading, justify="right" if k > 1 else "left", no_wrap=True)
        for line in lines:
            table.add_row(*line)
        out.print(table, "")
    table = Table(title="figures to reach", title_justify="left", box=None, pad_edge=False)
    for heading in ("figure", "target", "measured", ""):
        table.add_column(heading, no_wrap=True)
    for row in rows:
        table.add_row(*row.texts())
    out.print(table)
    for line in (*page.slower(found), *page.left_out(found)):
        out.print(line)


if __name__ == "__main__":
    sys.exit(main())
