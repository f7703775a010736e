"""Motions by cardan and by other programs: time against error, in one interleaved run.

Writes docs/performance/runs.md with its pictures and prints the table of figures to reach. Times
are reported, never asserted.

usage: runs.py [--quick] [--only NAME ...] [--rounds N]
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import warnings
from collections.abc import Callable, Sequence
from contextlib import chdir
from dataclasses import replace
from pathlib import Path

# the zoo and the cases stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

from rich.console import Console
from rich.table import Table

from benchmarks.all_figures import save
from benchmarks.motion import own, page, pictures
from benchmarks.motion.contest import Outcome, measure
from benchmarks.motion.figures import Measured, figures
from benchmarks.motion.problem import Problem
from benchmarks.motion.problems import PROBLEMS
from benchmarks.motion.programs import PROGRAMS
from cardan.cli.terminal import progress
from cardan.errors import CardanError

FOLDER = Path(__file__).parents[2] / "docs" / "performance"
ROUNDS, QUICK_ROUNDS = 15, 3
QUICK = ("double_pendulum", "four_bar")
WIDTH = 150


def main() -> int:
    """Measure, write, print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="two problems; writes no page")
    parser.add_argument("--only", nargs="+", choices=PROBLEMS, help="these; writes no page")
    parser.add_argument("--rounds", type=int, default=ROUNDS, help="turns of every run")
    given = parser.parse_args()
    names = given.only or (QUICK if given.quick else tuple(PROBLEMS))
    whole = not given.quick and not given.only
    warnings.simplefilter("ignore")
    rounds = QUICK_ROUNDS if given.quick else given.rounds
    problems = [thinned(PROBLEMS[n]) if given.quick else PROBLEMS[n] for n in names]
    # programs leave their objects and logs where they stand
    with tempfile.TemporaryDirectory(prefix="cardan-runs-") as private, progress() as show:
        with chdir(private):
            found = motions(problems, rounds, show)
        if whole and not found.lacking:
            show("ensemble of Panda runs")
            found = replace(found, gain=own.gain(), steps=own.saved_steps())
    rows = figures(found)
    save("runs.md", [row.texts() for row in rows])
    if whole:
        pictures.write(dict(found.outcomes), FOLDER / "runs")
        page.write(found, rows, FOLDER)
    tables(found, [row for row in rows if row.value is not None or whole])
    return 0


def motions(problems: Sequence[Problem], rounds: int, show: Callable[[str], None]) -> Measured:
    """The problems in turn; what cannot be built here is named."""
    outcomes: dict[str, Outcome] = {}
    lacking: dict[str, str] = {}
    for problem in problems:
        try:
            outcomes[problem.name] = measure(problem, PROGRAMS, rounds, show)
        except (CardanError, FileNotFoundError) as why:
            lacking[problem.title] = str(why).splitlines()[0]
    return Measured(outcomes, lacking=lacking)


def thinned(problem: Problem) -> Problem:
    """The same with two settings of everything: our tightest, loose ones of the others."""
    methods = {method: each[-2:] for method, each in problem.methods.items()}
    return replace(
        problem, methods=methods, tolerances=problem.tolerances[1:3], steps=problem.steps[:2]
    )


def tables(found: Measured, rows: list[page.Figure]) -> None:
    """Everything on a screen."""
    out = Console(width=WIDTH)
    sections = [(o.problem.title, page.HEADINGS, page.lines(o)) for o in found.outcomes.values()]
    figure_rows = [row.texts() for row in rows]
    sections.append(("figures to reach", ("figure", "target", "measured", ""), figure_rows))
    for title, headings, lines in sections:
        table = Table(title=title, title_justify="left", box=None, pad_edge=False)
        for k, heading in enumerate(headings):
            numbers = len(headings) == len(page.HEADINGS) and k > 1
            table.add_column(heading, justify="right" if numbers else "left", no_wrap=True)
        for line in lines:
            table.add_row(*line)
        out.print(table, "")
    for line in page.left_out(found):
        out.print(line)


if __name__ == "__main__":
    sys.exit(main())
