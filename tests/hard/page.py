"""Measures every cell and writes docs/hard_cases.md; status 1 where one is not as expected.

usage: python tests/hard/page.py
"""

from __future__ import annotations

import platform
import sys
from collections.abc import Iterator
from pathlib import Path

# the cases and the zoo stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

from benchmarks.provenance import signed
from cardan.cli.terminal import progress
from hard import CASES
from hard.case import FINISHED, METHODS, Case, Cell, Never, Outcome, measure

PAGE = Path(__file__).parents[2] / "docs" / "hard_cases.md"
Found = dict[tuple[str, str], Outcome]
HEAD = """\
# Hard cases

`make hard` writes this page. It runs every integrator for joint coordinates on every case
(`EnergyMomentum`, for absolute coordinates only, has its own tests). The expected results, a status
and an error bound, are in `tests/hard`, and the tests enforce them. Most bounds were set before
the first run. The bounds of micrometers, astronomical units, the free body, stick-slip, and
EnergyMidpoint on 100 links were set after it. They follow from theory or are at least three times
the measured error (twice for generalized-alpha over 1e7 steps). The step sizes for passing gimbal
lock and for the four-bar were also set after the first run.

Errors and times come from one run on one machine ({machine}). Methods of order 4 and higher
run at tight tolerances, methods of order 2 at loose ones. The cases show how reliable the methods
are, not which is fastest. `cardan report FILE` compares methods on your own scene.

In the table: ✓ as expected, ✗ not as expected, – not applicable, with the reason given below."""


def expectation(cell: Cell | Never) -> str:
    """What a cell expects, as the page says it."""
    if isinstance(cell, Never):
        return f"not applicable: {cell.reason}"
    status = "" if cell.status == FINISHED else f"{cell.status}, "
    return f"{status}≤ {cell.bound:.0e}" if cell.bound else cell.status


def settings(case: Case, method: str) -> str:
    """Tolerances or step in words."""
    return ", ".join(f"{name} {value:.2g}" for name, value in case.how(method).items())


def mark(case: Case, method: str, found: Found) -> str:
    """One sign for a cell."""
    cell = case.expected[method]
    if isinstance(cell, Never):
        return "–"
    return "✓" if found[case.name, method].meets(cell) else "✗"


def overview(found: Found) -> Iterator[str]:
    """Case by method."""
    yield f"| case | {' | '.join(METHODS)} |"
    yield f"|---|{':---:|' * len(METHODS)}"
    for case in CASES.values():
        marks = " | ".join(mark(case, method, found) for method in METHODS)
        yield f"| [{case.title}](#{anchor(case)}) | {marks} |"


def anchor(case: Case) -> str:
    """Where the section of a case stands in the page."""
    kept = "".join(c for c in case.title.lower() if c.isalnum() or c in " -")
    return kept.replace(" ", "-")


def section(case: Case, found: Found) -> Iterator[str]:
    """The table of a case."""
    yield f"\n## {case.title}\n"
    yield f"{case.hard[0].upper()}{case.hard[1:]}.\n"
    yield f"Measured by: {case.oracle}.\n"
    yield "| method | settings | expected | found | steps | ms |"
    yield "|---|---|---|---|---:|---:|"
    for method, cell in case.expected.items():
        if isinstance(cell, Never):
            yield f"| {method} | | {expectation(cell)} | | | |"
            continue
        one = found[case.name, method]
        status = "" if one.status == FINISHED else f"{one.status}, "
        missed = "" if one.meets(cell) else " ✗"
        yield (
            f"| {method} | {settings(case, method)} | {expectation(cell)} "
            f"| {status}{one.error:.1e}{missed} | {one.steps} | {one.milliseconds:.2g} |"
        )
    said = {
        found[case.name, method].message
        for method, cell in case.expected.items()
        if isinstance(cell, Cell) and found[case.name, method].status != FINISHED
    }
    if said:
        yield f"\nMessage of a run: {min(said, key=lambda words: (len(words), words))}."


def main() -> int:
    """Measure, write."""
    found: Found = {}
    with progress() as show:
        for k, case in enumerate(CASES.values()):
            for method, cell in case.expected.items():
                show(f"{case.name}, {method}", k / len(CASES))
                if isinstance(cell, Cell):
                    found[case.name, method] = measure(case, method)
    machine = f"{platform.machine()}, {platform.system()}"
    lines = [HEAD.format(machine=machine), "", *overview(found)]
    for case in CASES.values():
        lines += section(case, found)
    PAGE.write_text(signed("\n".join(lines)), "utf-8")
    wrong = 0
    for (name, method), one in found.items():
        cell = CASES[name].expected[method]
        if isinstance(cell, Cell) and not one.meets(cell):
            wrong += 1
            print(f"{name}, {method}: {one.status}, {one.error:.1e}; {expectation(cell)}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
