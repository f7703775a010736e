"""The page docs/performance/README.md, and the tables it shares with the screen."""

from __future__ import annotations

import platform
from collections.abc import Iterator, Sequence
from pathlib import Path

from benchmarks.cases import CASES, FORWARD
from benchmarks.figures import EPS, SINCOS, Figure
from benchmarks.measure import Found
from benchmarks.provenance import signed
from cardan.peers import PEERS, peer
from cardan.peers.comparison import LANES, OURS
from cardan.peers.processor import name as processor
from cardan.runtime.build import cache

BUSY = "it has no core of its own, or other work was on the processor"
CIRCUITS = {case.name for case in CASES if case.closed}
Section = tuple[str, tuple[str, ...], list[tuple[str, ...]]]

# where the time of figures goes that are hard to reach, by the profiler and by counts of operations
CAUSES = {
    "derivatives, Talos, scalar, of Pinocchio's time": (
        "Two fifths of the time are the columns: 53,000 multiply-adds, 0.8 us at the peak of "
        "vectors, need 3 us, since every body waits for the one that carries it. A third are "
        "articulated bodies, one after the other in single numbers; a fifth are the numbers of the "
        "bodies, 17,000 operations."
    ),
    "derivatives, Talos, batch, of Pinocchio's time": (
        "Half of the time are the columns, a seventh is writing results state by state. What the "
        "columns read of its 38 speeds for 8 states, 39 KB, does not fit into the first cache "
        "together with panels and results."
    ),
    "mass matrix, Talos, of Pinocchio's time": (
        "It is straight-line code. A tenth of its time clears results, half of which are 0, and "
        "a tenth is lost where their memory is not in the cache."
    ),
    "forward dynamics, chain of 100, of CasADi's time": (
        "Nine tenths of the time are the steps over its bodies: 240 operations in 150 cycles each. "
        "Calls of the steps are the other tenth."
    ),
    "forward dynamics, chain of 100, full inertias, of Pinocchio's time": (
        "Its 36,900 operations take twice the time that one core needs for so many in single "
        "numbers: a body waits for the one inboard or outboard of it."
    ),
    "Panda, forward dynamics, two threads, of one": (
        "Arithmetic alone is done by two threads in half the time; batches larger than the caches "
        "wait for memory, which both threads share."
    ),
    "prepare 10,000 bodies, random tree": (
        "No part stands out: a fifth each are deriving one body of every kind with a look at all "
        "others, the compiler of C, checks of the build over all bodies, and the graph of the "
        "scene; the rest are texts and files."
    ),
    "prepare 10,000 bodies, chain": (
        "A fifth each are the graph of the scene, its files, and checks of the build over all "
        "bodies."
    ),
    "prepare 10,000 bodies, chain in absolute coordinates": (
        "A third each are the graph of the scene with its members, its files, and the states of "
        "all nodes at the start."
    ),
}


def causes(rows: Sequence[Figure]) -> Iterator[str]:
    """Where the time of missed figures goes."""
    for row in rows:
        if not row.reached and row.name in CAUSES:
            yield f"{row.name}: {CAUSES[row.name]}"


def titles() -> dict[str, str]:
    return {case.name: case.title for case in CASES}


def sections(found: Found) -> Iterator[Section]:
    """Title, headings and rows of every table."""
    yield comparisons(found)
    yield circuits(found)
    yield batches(found)
    yield buildings(found)
    yield counts(found)


def comparisons(found: Found) -> Section:
    """Speed, error and agreement."""
    headings = (
        "mechanism", "program", "least [ns]", "median [ns]", "to ours", "error", "in eps cond(M)",
        "from Pinocchio",
    )  # fmt: skip
    lines: list[tuple[str, ...]] = []
    last = ""
    for case, comparison in found.comparisons.items():
        for row in comparison.rows if case not in CIRCUITS else ():
            ours = comparison.row(row.function, OURS)
            what = f"{titles()[case]}, {row.function.replace('_', ' ')}"
            first = what != last
            last = what
            lines.append((
                what if first else "",
                row.program if row.program in (OURS, LANES) else peer(row.program).name,
                f"{1e9 * row.time.least:.1f}",
                f"{1e9 * row.time.median:.1f}",
                f"{row.time.least / ours.time.least:.2f}" if ours else "",
                "" if row.error is None else f"{row.error:.1e}",
                "" if row.error is None else f"{row.error / EPS / comparison.condition:.2g}",
                "" if row.agreement is None else f"{row.agreement:.1e}",
            ))  # fmt: skip
    return "speed and error, per call on one core, of a batch per state", headings, lines


def circuits(found: Found) -> Section:
    """Closed mechanisms: accelerations on the constraints, beside constrained dynamics."""
    headings = (
        "mechanism", "one call [us]", "in a batch [ns]", "by formulas [us]", "in a batch [ns]",
        "Pinocchio [us]", "of its time", "error", "from Pinocchio",
    )  # fmt: skip
    lines = []
    for case, comparison in found.comparisons.items():
        ours, lanes, judge = (comparison.row(FORWARD, name) for name in (OURS, LANES, "pinocchio"))
        if case not in CIRCUITS or ours is None or lanes is None:
            continue
        theirs = judge.time.least if judge else None
        one, many = found.formulas.get(case, (None, None))
        lines.append((
            titles()[case],
            f"{1e6 * ours.time.least:.3f}",
            f"{1e9 * lanes.time.least:.1f}",
            f"{1e6 * one.least:.3f}" if one else "",
            f"{1e9 * many.least:.1f}" if many else "",
            f"{1e6 * theirs:.3f}" if theirs else "",
            f"{ours.time.least / theirs:.3f}" if theirs else "",
            "" if ours.error is None else f"{ours.error:.1e}",
            "" if ours.agreement is None else f"{ours.agreement:.1e}",
        ))  # fmt: skip
    return "closed mechanisms, forward dynamics with constraints", headings, lines


def batches(found: Found) -> Section:
    """Batches from Python, as they lie in memory; what ensembles and a second thread gain."""
    headings = ("mechanism", "batch or runs", "least [ns]", "error", "gain")
    lines: list[tuple[str, ...]] = []
    for case, ways in found.batches.items():
        for way in ways:
            gain = ways[0].seconds / way.seconds
            cells = f"{1e9 * way.seconds:.1f}", f"{way.error:.1e}", f"{gain:.2f}"
            lines.append((titles()[case], way.name, *cells))
    for case, second in found.threads.items():
        gain = "not measurable" if second is None else f"{second:.2f}"
        lines.append((titles()[case], "two threads, of the time of one", "", "", gain))
    for case, (alone, lanes) in found.ensembles.items():
        cells = f"{1e9 * lanes:.0f}", "0", f"{alone / lanes:.2f}"
        lines.append((titles()[case], "a run of an ensemble in lanes, of our loop in C", *cells))
    return "many states and runs in one thread, per state or run", headings, lines


def buildings(found: Found) -> Section:
    """From the scene to the first number."""
    headings = (
        "mechanism", "method", "derive [ms]", "compile [s]", "check [s]", "load [ms]", "C lines",
        "object [KiB]", "memory [MiB]", "compiler [MiB]", "per body [ns]", "in a batch",
    )  # fmt: skip
    lines = []
    for name, row in found.buildings.items():
        loaded, bodies = row.get("loaded"), [row.get(key) for key in ("call", "state")]
        lines.append((
            titles().get(name) or f"chain of {int(name):,}",
            row["method"],
            f"{1e3 * row['derived']:.1f}",
            f"{row['compiled']:.2f}",
            f"{row['checked']:.2f}",
            "" if loaded is None else f"{1e3 * loaded:.1f}",
            str(row["lines"]),
            f"{row['bytes'] / 1024:.0f}",
            f"{row['memory']:.0f}",
            f"{row['compiler_memory']:.0f}",
            *("" if body is None else f"{body:.1f}" for body in bodies),
        ))  # fmt: skip
    return "forward dynamics, from the scene to the first number", headings, lines


def counts(found: Found) -> Section:
    """Operations as they are committed."""
    columns = ("mul", "add", "neg", "div", "trig", "prepare", "lines", "work")
    lines = []
    for name in found.comparisons:
        for function in ("forward_dynamics", "inverse_dynamics"):
            row = found.counts.get(name, {}).get(function)
            if row:
                cells = (str(row.get(column, 0)) for column in columns)
                lines.append((titles()[name], function.replace("_", " "), *cells))
    return "operations of the C", ("mechanism", "function", *columns), lines


def slower(found: Found) -> Iterator[str]:
    """Where another program takes less time than ours for one state."""
    for case, comparison in found.comparisons.items():
        for row in comparison.rows:
            ours = comparison.row(row.function, OURS)
            if row.program in PEERS and ours and row.time.least < ours.time.least:
                share = row.time.least / ours.time.least
                what = f"{titles()[case]}, {row.function.replace('_', ' ')}"
                yield f"{what}: {peer(row.program).name} takes {share:.2f} of our time"


def left_out(found: Found) -> Iterator[str]:
    """Peers and cases that were not measured, each with the reason."""
    for name in PEERS:
        why = peer(name).missing()
        if why:
            yield f"{peer(name).name} was not measured: {why}"
    if None in found.threads.values():
        yield f"a second thread was not measured: {BUSY}"
    for title, why in found.lacking.items():
        yield f"{title} was not measured: {why}"
    where: dict[tuple[str, str], list[str]] = {}
    for case, comparison in found.comparisons.items():
        for name, why in comparison.absent.items():
            where.setdefault((name, why), []).append(titles()[case])
    for (name, why), cases in where.items():
        if why != peer(name).missing():
            yield f"{peer(name).name} was not measured on {', '.join(cases)}: {why}"


def markdown(headings: Sequence[str], lines: Sequence[Sequence[str]], left: int = 2) -> list[str]:
    """A table."""
    rule = ["---" if k < left else "---:" for k in range(len(headings))]
    return [f"| {' | '.join(row)} |" for row in (headings, rule, *lines)]


def write(found: Found, rows: Sequence[Figure], folder: Path) -> None:
    """The page."""
    programs = dict.fromkeys(
        row.title for c in found.comparisons.values() for row in c.rows if row.program in PEERS
    )
    peak = found.peak
    text = [
        "# Performance",
        "",
        "Written by `make bench`, which measures all of it again: cardan and its peers in turn,",
        "round after round, in loops in C, on the same mechanism at the same random states. The",
        "ratios hold elsewhere too; the times are those of one machine:",
        "",
        f"- {processor()}, {platform.system()}, Python {platform.python_version()}",
        f"- multiply-adds of one core: {peak.scalar:.1f} GFLOP/s scalar, {peak.vector:.1f} GFLOP/s "
        f"in {peak.lanes} lanes",
        f"- ours and CasADi's C by {cache.compiler().identity.splitlines()[0]}, "
        f"batches {found.lanes} states at once",
        *(f"- {title}" for title in programs),
        "",
        "`cardan bench FILE` does the same for a scene or robot of yours. Whole motions, time",
        "against error: [runs.md](runs.md).",
        "",
        "## Slower than another program",
        "",
        *([f"- {line}." for line in slower(found)] or ["Nothing, at one state."]),
        "",
        "## Figures to reach",
        "",
        *markdown(
            ("figure", "target", "measured", ""),
            [row.texts() for row in sorted(rows, key=lambda row: row.reached)],
            4,
        ),
        "",
        *(f"- Missed: {cause}" for cause in causes(rows)),
        "",
        "Operations are multiplications and additions of a call with symbolic parameters; what",
        "depends on parameters alone is counted under *prepare* below. The share of the peak",
        f"counts all arithmetic of a state, {SINCOS} operations for a sine with its cosine.",
        "",
        "![speed and error](error.svg)",
        "![ratios](ratios.svg)",
        "![cost and size](size.svg)",
    ]
    for title, headings, lines in sections(found):
        text += ["", f"## {title[0].upper()}{title[1:]}", "", *markdown(headings, lines)]
    notes = list(left_out(found))
    if notes:
        text += ["", "## Left out", "", *(f"- {note}" for note in notes)]
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "README.md").write_text(signed("\n".join(text)), "utf-8")
