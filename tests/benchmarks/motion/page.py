"""The page docs/performance/runs.md, and the tables it shares with the screen."""

from __future__ import annotations

import importlib.metadata
import platform
import textwrap
from collections.abc import Iterator, Sequence
from pathlib import Path

from benchmarks.figures import Figure
from benchmarks.motion.contest import Outcome
from benchmarks.motion.figures import Measured
from benchmarks.motion.programs import PEERS, PROGRAMS
from benchmarks.page import markdown
from benchmarks.provenance import signed
from cardan.build import cache
from cardan.peers.processor import name as processor

HEADINGS = ("program", "method", "setting", "least [ms]", "median [ms]", "error")
PACKAGES = ("mujoco", "exudyn", "casadi", "scipy", "scikit-sundae")
# errors at which the fastest of everybody are shown
DECADES = (1e-3, 1e-5, 1e-7, 1e-9, 1e-11)


def lines(outcome: Outcome) -> list[tuple[str, ...]]:
    """Every row."""
    return [
        (
            r.program, r.method, f"{r.setting:g}", f"{1e3 * r.least:.3g}", f"{1e3 * r.median:.3g}",
            f"{r.error:.1e}",
        )
        for r in outcome.rows
    ]  # fmt: skip


def fastest(outcome: Outcome) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """Least time of every program at errors: headings and rows."""
    unit = outcome.problem.unit
    headings = ("fastest [ms] with an error of at most", *(f"{e:g} {unit}" for e in DECADES))
    rows = []
    for program in PROGRAMS:
        found = [outcome.best(error, (program.name,)) for error in DECADES]
        if any(found):
            cells = (f"{1e3 * row.least:.3g} ({row.method})" if row else "" for row in found)
            rows.append((program.name, *cells))
    return headings, rows


def left_out(found: Measured) -> Iterator[str]:
    """Who was not measured, or did not get to the end, with the reason."""
    for program in PEERS:
        if program.missing():
            yield f"{program.name} was not measured: {program.missing()}"
    for title, why in found.lacking.items():
        yield f"{title} was not measured: {why}"
    for outcome in found.outcomes.values():
        title = outcome.problem.title
        for name, why in outcome.absent.items():
            if why not in {program.missing() for program in PEERS}:
                yield f"{title}: {name} was not measured: {why}"
        for who, settings in outcome.lost.items():
            where = ", ".join(f"{setting:g}" for setting in settings)
            yield f"{title}: {who} lost the motion or gave up at {where}"


def wrapped(text: str) -> list[str]:
    """Lines of a paragraph."""
    return textwrap.wrap(text, 100, break_long_words=False, break_on_hyphens=False)


def versions() -> Iterator[str]:
    """Of the packages that are here."""
    for package in PACKAGES:
        try:
            yield f"{package} {importlib.metadata.version(package)}"
        except importlib.metadata.PackageNotFoundError:
            continue


def write(found: Measured, rows: Sequence[Figure], folder: Path) -> None:
    """The page; pictures stand beside it."""
    text = [
        "# Motions: time against error",
        "",
        "Written by `make bench`. Six motions, each computed by cardan's methods and by other",
        "programs over their tolerances or steps: in turn, round after round, on one core, in one",
        "run. Times are of the whole call from Python, everything prepared and compiled before;",
        "those of cardan include finding a start that closes loops, dense output and energies.",
        "Errors are the largest of the end.",
        "",
        f"- {processor()}, {platform.system()}, Python {platform.python_version()}",
        f"- C by {cache.compiler().identity.splitlines()[0]}",
        f"- {', '.join(versions())}",
        "",
        "CasADi's dynamics is the articulated-body recursion written in it (loops: multipliers",
        "in one linear system), compiled with -O2 -march=native. SciPy and scikit-sundae call the",
        "C that cardan wrote. MuJoCo steps in its own loop in C. Exudyn has trees in minimal",
        "coordinates and loops of bodies in the plane. IDA's residual makes several calls from",
        "Python.",
        "",
        "## Figures to reach",
        "",
        *markdown(("figure", "target", "measured", ""), [row.texts() for row in rows], 4),
    ]
    for name, outcome in found.outcomes.items():
        problem = outcome.problem
        known = problem.source or "two methods at their tightest"
        text += [
            "",
            f"## {problem.title[0].upper()}{problem.title[1:]}",
            "",
            *wrapped(
                f"{problem.text[0].upper()}{problem.text[1:]}. The end is known from {known}; "
                f"another way to it is {outcome.doubt:.1e} {problem.unit} apart."
            ),
            "",
            f"![time against error](runs/{name}.svg)",
            "",
            *markdown(*fastest(outcome), 1),
            "",
            *markdown(HEADINGS, lines(outcome), 2),
        ]
    notes = list(left_out(found))
    if notes:
        text += ["", "## Left out", "", *(f"- {note}" for note in notes)]
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "runs.md").write_text(signed("\n".join(text)), "utf-8")
