"""Everybody's turn at every problem, round after round, and what comes out."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from time import perf_counter

import numpy as np

from benchmarks.motion.problem import Array, Problem, Task
from benchmarks.motion.programs.program import Entry, Program
from benchmarks.motion.reference import task
from cardan.errors import CardanError

# seconds that all rounds of a run may take, and those beyond which it has one
SHARE, LONG = 1.5, 4.0
# a motion with larger errors [m] or [rad] was lost
LOST = 1.0
# what other programs raise where they give up
GAVE_UP = (ArithmeticError, RuntimeError, ValueError, CardanError)


@dataclass(frozen=True)
class Row:
    """A program with a method and a setting on one problem.

    Attributes:
        program, method: Who and how.
        setting: Tolerance, or number of steps.
        least, median: Seconds of the whole motion, of all rounds.
        error: Largest error of the places at the end.
    """

    program: str
    method: str
    setting: float
    least: float
    median: float
    error: float


@dataclass(frozen=True)
class Outcome:
    """A problem with everything measured on it.

    Attributes:
        problem: Which one.
        rows: Who got there.
        doubt: How sure the end is known, in the unit of the places.
        absent: Program -> why it has no row.
        lost: Program and method with the settings at which it did not get there.
    """

    problem: Problem
    rows: tuple[Row, ...]
    doubt: float
    absent: dict[str, str] = field(default_factory=dict)
    lost: dict[str, list[float]] = field(default_factory=dict)

    def best(self, error: float, programs: Sequence[str]) -> Row | None:
        """The fastest run of some programs with at most this error, None without one."""
        enough = [r for r in self.rows if r.program in programs and r.error <= error]
        return min(enough, key=lambda row: row.least, default=None)


def measure(
    problem: Problem, programs: Sequence[Program], rounds: int, show: Callable[[str], None]
) -> Outcome:
    """One problem: who can, and how long and how wrong."""
    show(f"{problem.title}: its end")
    ready = task(problem)
    absent: dict[str, str] = {}
    entries: list[Entry] = []
    for program in programs:
        why = program.missing() or program.refusal(ready)
        if why:
            absent[program.name] = why
            continue
        show(f"{problem.title}: {program.name}")
        entries += program.entries(ready)
    lost: dict[str, list[float]] = {}
    first: dict[Entry, tuple[float, float]] = {}
    for entry in entries:
        show(f"{problem.title}: {entry.program} {entry.method} {entry.setting:g}")
        found = _once(entry, ready)
        if found is None or found[1] > LOST:
            lost.setdefault(f"{entry.program} {entry.method}", []).append(entry.setting)
        else:
            first[entry] = found
    times = _rounds(first, rounds, lambda k: show(f"{problem.title}: round {k + 1}"))
    rows = tuple(
        Row(e.program, e.method, e.setting, min(times[e]), float(np.median(times[e])), error)
        for e, (_, error) in first.items()
    )
    return Outcome(problem, rows, ready.doubt, absent, lost)


def _once(entry: Entry, ready: Task) -> tuple[float, float] | None:
    """Seconds and error of a first run, None where it gives up."""
    began = perf_counter()
    try:
        end: Array = entry.run()
    except GAVE_UP:
        return None
    return perf_counter() - began, ready.error(end)


def _rounds(
    first: dict[Entry, tuple[float, float]], rounds: int, show: Callable[[int], None]
) -> dict[Entry, list[float]]:
    """Times by entry, all in turn; what takes long has fewer turns."""
    times: dict[Entry, list[float]] = {e: [] for e in first}
    for k in range(rounds):
        show(k)
        for entry in first:
            spent = times[entry]
            if not spent and first[entry][0] > LONG:
                spent.append(first[entry][0])
            elif sum(spent) < SHARE:
                began = perf_counter()
                entry.run()
                spent.append(perf_counter() - began)
    return times


def fronts(outcome: Outcome) -> Iterator[tuple[str, str, list[tuple[float, float]]]]:
    """Program, method and its points (error, seconds) in the order of its settings."""
    lines: dict[tuple[str, str], list[tuple[float, float]]] = {}
    for row in outcome.rows:
        lines.setdefault((row.program, row.method), []).append((row.error, row.least))
    for (program, method), points in lines.items():
        yield program, method, points
