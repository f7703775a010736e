"""Stability of the stretches of a branch between its special points."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby, pairwise

from ..analyses.continuation.equilibrium_solutions import EquilibriumSolutions
from ..analyses.continuation.record import BranchRecord
from ..analyses.continuation.special_points import EVENT
from . import content as d

NEAR = 1e-9  # of a step: rows that are special points
LABELS = {True: "stable", False: "unstable", None: "not known"}


def stability(branch: BranchRecord) -> Iterator[d.Block]:
    """Stretches as a table, and where stability changes without a special point."""
    solutions = branch.solutions
    if solutions.kind == "positions":
        yield d.Paragraph(("No forces act: positions have no stability.",), quiet=True)
        return
    prescribed = isinstance(solutions, EquilibriumSolutions) and _prescribes(solutions)
    columns: list[tuple[str, Sequence[bool | None]]] = [("stability", branch.stable)]
    if prescribed:
        columns = [("under its load", branch.stable), ("held", branch.stable_held)]
    load = next(iter(branch.values))
    values, counts = branch.values[load], branch.n_negative
    rows, changed = list[d.Cells](), list[str]()
    for start, end, numbers in _stretches(branch):
        texts = list[str]()
        for heading, flags in columns:
            text, changes = _flags([flags[k] for k in numbers], [float(values[k]) for k in numbers])
            texts.append(text)
            if changes:
                at = ", ".join(f"{load} = {value:.6g}" for value in changes)
                changed.append(f"between {start} and {end} ({heading}) from {at} on")
        rows.append((start, end, float(len(numbers)), *texts, _counts([*counts[numbers]])))
    heads = tuple(heading for heading, _ in columns)
    cycles = solutions.kind == "cycles"
    directions = "multipliers outside" if cycles else "unstable directions" + ", held" * prescribed
    yield d.Table(("from", "to", "points", *heads, directions), tuple(rows))
    if prescribed:
        said = "Under its load: dead weight in place of what prescribes displacements."
        yield d.Paragraph((said,), quiet=True)
    if changed:
        listed = "; ".join(changed)
        said = f"Stability changes between points of the path, where none was located: {listed}."
        yield d.Paragraph((said,))


def _prescribes(solutions: EquilibriumSolutions) -> bool:
    """True where coordinates are held, as a testing machine does."""
    way = solutions.family.way
    return bool(way.base.locked) or "locked" in way.kinds.values()


def _stretches(branch: BranchRecord) -> Iterator[tuple[str, str, list[int]]]:
    """Names of both ends, and the rows in between."""
    last, place = len(branch) - 1, branch.curve.places[-1]
    marks = [("start", -1.0)]
    for point in branch.points:
        special = point.special
        # what ends a path is its last row, and stands as those before it
        ends = special.kind == EVENT and special.place is place
        marks.append((point.name, last + 0.5 if ends else special.after + special.part))
    if marks[-1][1] < last - NEAR:
        marks.append(("end", float(last) + 1.0))
    for (start, low), (end, high) in pairwise(marks):
        numbers = [k for k in range(last + 1) if low + NEAR < k < high - NEAR]
        if numbers or end != "end":
            yield start, end, numbers


def _flags(flags: Sequence[bool | None], values: Sequence[float]) -> tuple[str, list[float]]:
    """Stability of rows in words, and values at which it is another one than before."""
    if not flags:
        return "no point within", []
    runs = [(flag, [k for k, _ in run]) for flag, run in groupby(enumerate(flags), lambda e: e[1])]
    return ", then ".join(LABELS[flag] for flag, _ in runs), [values[run[0]] for _, run in runs[1:]]


def _counts(counts: Sequence[int]) -> str:
    """Numbers of unstable directions of rows."""
    distinct = list(dict.fromkeys("not known" if n < 0 else str(n) for n in counts))
    return ", then ".join(distinct) if distinct else ""
