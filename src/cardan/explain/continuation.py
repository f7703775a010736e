"""A path and its branches as a page: what was solved, what lies on it, and how to read it."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from ..analyses.continuation.diagram import plot
from ..analyses.continuation.equilibrium_solutions import EquilibriumSolutions
from ..analyses.continuation.record import BranchRecord, ContinuationRecord, SpecialPointRecord
from ..analyses.continuation.special_points import BRANCH, FOLD
from ..analyses.cycles.cycle_starts import DOUBLING
from ..arguments import checked
from ..errors import ModelError, SolveError, counted
from . import content as d
from . import ending_of, published
from .path_equations import RATE, SOURCES, condition, equations, steps
from .path_stability import stability

SECTIONS = 12  # branches with a heading each; those of longer lists are folded
LEVEL = 1e-6  # Koiter's coefficients that are 0, as parts of the larger one or of 1
ENDS = {
    "finished": "an end that was asked for was reached",
    "closed": "back at its start",
    "joined": "at the end of another branch, or the start of the main one",
    "budget": "as many points as points= allows; more may follow",
    "singular": "steps became too short; look at the last point",
    "interrupted": "interrupted; more may follow",
}


@checked
def explain(
    path: ContinuationRecord, file: str | Path, along: str | None = None, up: str | None = None
) -> Path:
    """Write a page on a path: its equations, steps, branches, special points and stability.

    Args:
        path: The path.
        file: Its ending says how: ``.html``, ``.tex`` or ``.md``.
        along, up: Names of the histories on the axes of the diagram, as for ``plot``; what is swept
            and what moves most by default.

    Returns:
        The file.

    Raises:
        DerivationError: another ending. ModelError: unknown names.
    """
    file = Path(file)
    ending = ending_of(file)
    return published(document(path, along, up, drawn=ending != ".tex"), file)


def document(
    path: ContinuationRecord, along: str | None = None, up: str | None = None, drawn: bool = True
) -> d.Document:
    """Contents of the page, before it is written.

    Args:
        path: The path.
        along, up: Histories of the diagram.
        drawn: Whether it is drawn.
    """
    solutions = path.main.solutions
    sections = [
        d.Section("Range and ends", tuple(_range(path))),
        d.Section("Diagram", tuple(_diagram(path, along, up, drawn))),
        d.Section("Equations", tuple(equations(solutions))),
        d.Section("Steps", tuple(steps(path.main.curve))),
    ]
    kinds = dict.fromkeys(p.kind for b in path.branches.values() for p in b.points)
    if kinds:
        items = tuple(condition(kind, solutions) for kind in kinds)
        sections.append(d.Section("Conditions of special points", (d.Listing(items),)))
    branches = [*path.branches.values()]
    sections.append(d.Section("Branches", tuple(_overview(branches))))
    pages = [(f"Branch '{branch.name}'", tuple(_branch(path, branch))) for branch in branches]
    if len(pages) <= SECTIONS:
        sections += [d.Section(*page) for page in pages]
    else:
        sections.append(d.Section("Branch by branch", tuple(d.Folded(*page) for page in pages)))
    sections.append(d.Section("Sources", (d.Listing(tuple((one,) for one in SOURCES)),)))
    title = f"{solutions.kind.capitalize()} of {path.model.name}"
    return d.Document(title, tuple(_lead(path)), tuple(sections))


def _lead(path: ContinuationRecord) -> Iterator[d.Paragraph]:
    """What the path is, how it ended, and all that is not certain."""
    main, swept = path.main, ", ".join(path.main.values)
    count, points = len(path.branches), sum(map(len, path.branches.values()))
    said = (
        f"The {main.solutions.kind} of {path.model.name} as {swept} changes, followed along their "
        f"curve: {counted(count, 'branch', 'branches')} with {counted(points, 'point')}. "
        f"{main.message[0].upper()}{main.message[1:]}."
    )
    yield d.Paragraph((said,))
    for doubt in _doubts(path):
        yield d.Paragraph((f"Note: {doubt}",))


def _doubts(path: ContinuationRecord) -> Iterator[str]:
    """What a reader could take for certain or complete, and is not."""
    for status in ("budget", "singular", "interrupted"):
        names = [f"'{b.name}'" for b in path.branches.values() if b.status == status]
        if names:
            yield f"not complete ({status}): {', '.join(names)}, {ENDS[status]}."
    for branch in path.branches.values():
        of = f"of branch '{branch.name}'"
        for point in branch.points:
            if not point.accurate:
                yield f"{point.name} {of} is not accurate: it lies within a short step."
            if point.kind == BRANCH and not (point.branches or point.special.label):
                yield f"at {point.name} {of} no branches were told apart; some may leave it."
            missing = _not_followed(path, point)
            if missing:
                listed = ", ".join(missing)
                yield f"from {point.name} {of} not followed: {listed}. branches= asks for them."


def _not_followed(path: ContinuationRecord, point: SpecialPointRecord) -> list[str]:
    """What leaves a point and is not on the path; one branch may pass at both of its sides."""
    missing = [name for name in point.branches if name not in path.branches]
    prefix = "" if point.branch is path.main else f"{point.branch.name}."
    if point.kind == DOUBLING and f"{prefix}{point.name}" not in path.branches:
        missing.append("cycles of twice the period")
    return missing


def _range(path: ContinuationRecord) -> Iterator[d.Block]:
    """What is swept, and what ends the path or is noted on it."""
    values = path.main.values
    rows = tuple((name, float(column[0]), float(column[-1])) for name, column in values.items())
    yield d.Table(("swept", "first", "last"), rows)
    ends = [test.name for test in path.main.curve.tests if test.ends]
    events = [test.name for test in path.main.curve.tests if not test.ends]
    items: list[d.Text] = [(f"It ends where {one} is reached.",) for one in ends]
    items += [(f"It notes where {one} is passed.",) for one in events]
    yield d.Listing(tuple(items))


def _diagram(
    path: ContinuationRecord, along: str | None, up: str | None, drawn: bool
) -> Iterator[d.Block]:
    """The picture; what draws it where there is none."""
    x = along or next(iter(path.main.values))
    y = up or _moving(path, x)
    call = f"path.plot({x!r}, {y!r}, 'picture.pdf')"
    if not drawn:
        # names are checked here too
        path.main.solutions.quantity(x), path.main.solutions.quantity(y)
        yield d.Paragraph((f"{call} draws it; pages of HTML and Markdown have it.",))
        return
    try:
        picture = svg(path, x, y)
    except ModuleNotFoundError:
        said = f"It needs Matplotlib (pip install 'cardan[plot]'); then {call} draws it too."
        yield d.Paragraph((said,))
        return
    caption = (
        f"{y} over {x}. Unstable solutions are thin and dashed; all else are lines, also where "
        "stability is not known. Where branches meet the first one names the point."
    )
    yield d.Figure(picture, "", caption)


def svg(path: ContinuationRecord, along: str, up: str) -> str:
    """The diagram as SVG, the same every time.

    Raises:
        ModelError: unknown names. ModuleNotFoundError: Matplotlib is not installed.
    """
    figure = plot(path, along, up)
    from matplotlib import rc_context

    text = io.StringIO()
    with rc_context({"svg.hashsalt": "cardan"}):
        figure.savefig(text, format="svg", metadata={"Date": None})
    drawn = text.getvalue()
    return drawn[drawn.index("<svg") :]


def _moving(path: ContinuationRecord, along: str) -> str:
    """The history that shows most beside what is swept."""
    solutions, model = path.main.solutions, path.model
    if isinstance(solutions, EquilibriumSolutions) and (
        solutions.family.way.kinds.get(along) == "locked"
    ):
        return f"{along}.holding_force"
    swept = path.main.values
    names = [name for name in model.coordinates if name not in swept] or [*model.coordinates]
    if solutions.kind == "cycles":
        motion = path.main[-1].motion  # type: ignore[attr-defined]
        ranges = {name: float(np.ptp(motion[name])) for name in names}
        return f"{max(ranges, key=ranges.__getitem__)}.max"
    q = np.concatenate([branch.q for branch in path.branches.values()])
    sizes = {name: float(np.ptp(q[:, model.coordinates.index(name)])) for name in names}
    return max(sizes, key=sizes.__getitem__)


def _overview(branches: list[BranchRecord]) -> Iterator[d.Block]:
    """All branches as a table."""
    rows = tuple(
        (b.name, float(len(b)), float(b.iterations), float(b.refused), b.status) for b in branches
    )
    yield d.Table(("branch", "points", "linear systems", "steps halved", "status"), rows)
    statuses = dict.fromkeys(branch.status for branch in branches)
    yield d.Listing(tuple((f"{status}: {ENDS[status]}.",) for status in statuses))


def _branch(path: ContinuationRecord, branch: BranchRecord) -> Iterator[d.Block]:
    """Where a branch starts and ends, what lies on it, and where it is stable."""
    points = [p for b in path.branches.values() for p in b.points if b is not branch]
    leaves = [f"{p.name} of '{p.branch.name}'" for p in points if branch.name in p.branches]
    begins = f"It leaves {' and '.join(leaves)}. " * bool(leaves)
    first = ", ".join(f"{name} = {column[0]:.6g}" for name, column in branch.values.items())
    last = ", ".join(f"{name} = {column[-1]:.6g}" for name, column in branch.values.items())
    ended = branch.curve.ended or "it is not finished"
    yield d.Paragraph((f"{begins}From {first} to {last}; {ended}.",))
    if branch.points:
        yield d.Listing(tuple(_point(point) for point in branch.points))
    for point in branch.points:
        yield from _postbuckling(point)
    yield from stability(branch)


def _point(point: SpecialPointRecord) -> d.Text:
    """A special point as a sentence, with what was computed of its condition."""
    special = point.special
    parts: list[d.Inline] = [f"{point!r}."]
    if not point.accurate:
        parts.append(" Not accurate: it is only known to lie within a short step.")
    if point.kind == FOLD:
        parts += [" ", RATE, f" = {special.place.parameter_rate:.1e} there."]
    if special.singular is not None:
        k, uncertainty = special.singular.k, special.singular.uncertainty
        parts.append(
            f" The rank of J is lower by {k} there, and its null space has {k + 1} directions. "
            f"Rounding moves the point by up to {uncertainty:.1e}."
        )
    return tuple(parts)


def _postbuckling(point: SpecialPointRecord) -> Iterator[d.Block]:
    """Koiter's coefficients of the branches that leave a point, where it has any."""
    solutions = point.branch.solutions
    if point.kind != BRANCH or not point.branches:
        return
    if not isinstance(solutions, EquilibriumSolutions) or solutions.family.way.base.locked:
        return
    system = solutions.family.problem.system
    sizes = {name: np.abs(point.tangents[:, k]).max() for name, (_, k) in system.places.items()}
    try:
        name = max(sizes, key=sizes.__getitem__)
        coefficients = point.postbuckling(name)
    except (ModelError, SolveError, ValueError):
        # the load is 0 there, and coefficients are parts of it; or nothing has a name
        return
    rows = [(branch, _rounded(a, b), float(b)) for branch, (a, b) in coefficients.items()]
    cells = tuple((branch, a, b, _meaning(a, b)) for branch, a, b in rows)
    load = next(iter(point.values))
    said = f"Koiter's coefficients at {point.name}, x = {name}: {load} = "
    yield d.Paragraph((f"{said}{point.values[load]:.6g} (1 + a x + b x²) along the branch.",))
    yield d.Table(("branch", "a", "b", "size of the load"), cells)
    said = "Where the path is stable before, a load that falls along any branch means that small "
    yield d.Paragraph((f"{said}imperfections lower the largest load.",), quiet=True)


def _rounded(a: float, b: float) -> float:
    """A slope that is more than rounding beside the curvature, or 0."""
    return 0.0 if abs(a) <= LEVEL * max(1.0, abs(b)) else float(a)


def _meaning(a: float, b: float) -> str:
    """The load along a branch, away from its point."""
    if not (np.isfinite(a) and np.isfinite(b)):
        return "x does not change at first"
    if a:
        return "rises to one side, falls to the other"
    if abs(b) <= LEVEL:
        return "does not change to this order"
    return "rises" if b > 0 else "falls"
