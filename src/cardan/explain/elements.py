"""Pages of equations in absolute coordinates: kinds of elements, their members, what they cost."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from ..equations.reading.book_symbols import BookNotation
from ..ir.function import Function
from ..ir.routine import Routine
from . import content as d
from .book_forms import FORMS, Forms
from .formulas import formula_line

if TYPE_CHECKING:
    from ..equations.finite_elements.record import BlockKind, FiniteElementRecord, Kind

NAMED = 12


def sections(scene: FiniteElementRecord, book: BookNotation) -> Iterator[d.Section]:
    """Sections beyond graph, parameters and frames."""
    yield _places(scene)
    yield _elements(scene, FORMS[book.key])
    yield _formulas(scene, book)
    yield _energy(scene)
    yield _operations(scene)


def _places(scene: FiniteElementRecord) -> d.Section:
    """Table of the nodes that own the coordinates and speeds."""
    places, rows = scene.places, []
    for n, kind in enumerate(places.kinds):
        members = [places.names[k] for k in range(len(places)) if places.kind[k] == n]
        rows.append((kind.name, float(len(members)), some(members), _entries(kind)))
    said = (
        f"{len(places)} places hold {places.nq} coordinates and {places.nu} speeds: nodes have a "
        "position and a rotation each, joints coordinates of their own."
    )
    table = d.Table(("kind of place", "number", "places", "coordinates of each"), tuple(rows))
    return d.Section("Coordinates and speeds", (d.Paragraph((said,)), table))


def _entries(kind: BlockKind) -> str:
    units = zip(kind.coordinates, kind.q_units, strict=True)
    return ", ".join(f"{name or 'its own'} [{unit or '1'}]" for name, unit in units)


def _elements(scene: FiniteElementRecord, forms: Forms) -> d.Section:
    rows, massed = [], []
    for group in scene.groups:
        kind = group.kind
        places = " and ".join(block.name for block in kind.blocks) or "ground"
        rows.append((kind.name, float(len(group)), some(group.members), places, float(kind.m)))
        if kind.m:
            names = ", ".join(name or "itself" for name, _ in kind.rows)
            massed.append((kind.name, float(kind.m), float(kind.mp), names))
    said: d.Text = (
        forms.elements, " and ", forms.levels, ": every element adds its part to the rows of its "
        "places, and has rows of its own where it imposes constraints.",
    )  # fmt: skip
    blocks: list[d.Block] = [
        d.Paragraph(said),
        d.Table(("element", "members", "names", "between", "rows"), tuple(rows)),
    ]
    if massed:
        head = ("element", "rows", "of positions", "what it holds")
        blocks.append(d.Table(head, tuple(massed)))
    return d.Section("Elements", tuple(blocks))


def _energy(scene: FiniteElementRecord) -> d.Section:
    """Energy is conserved where nothing has power and nothing reads the time."""
    timed = [
        group.kind.name
        for group in scene.groups
        if any(_reads_time(f) for f in group.kind.functions.values())
    ]
    damped = [segment.name for segment in scene.system.segments if any(segment.data["damping"][2])]
    sources = list(dict.fromkeys((*scene.powers, *damped)))
    if sources:
        said = f"Energy is not conserved: {', '.join(sources)} can take or give power."
    elif timed:
        said = f"Energy is not conserved: the time stands in {', '.join(dict.fromkeys(timed))}."
    else:
        said = "Energy is conserved: nothing has power of its own, and nothing depends on the time."
    return d.Section("Conserved quantities", (d.Paragraph((said,)),))


def _reads_time(function: Function) -> bool:
    return any(function.graph.nodes[i][:2] == ("var", "t") for i in function.live())


def _operations(scene: FiniteElementRecord) -> d.Section:
    rows: list[d.Cells] = []
    for group in scene.groups:
        kind = group.kind
        counts = [
            float(scene.operations[kind.c_name(name)].total) if name in kind.functions else 0.0
            for name in ("balance", "balance_tangent")
        ]
        total = counts[0] * len(group)
        rows.append((kind.name, float(len(group)), *counts, total))
    head = ("element", "members", "balance", "tangent", "balance of all")
    said = "Operations for one member at every call, and of the balance of all members."
    return d.Section("Operations", (d.Paragraph((said,), quiet=True), d.Table(head, tuple(rows))))


def some(names: Iterable[str]) -> str:
    """A few names, and how many more there are."""
    listed = list(names)
    listing = ", ".join(listed[:NAMED])
    return listing + (f", ... ({len(listed)})" if len(listed) > NAMED else "")


ENDS = (
    "{rotation} and {position} are pose and position of a body or of an end, {angular_velocity} "
    "its angular velocity in its own axes and {velocity} its velocity, {gravity} gravity. A tilde "
    "or square brackets make a matrix of a cross product; (a; b) stacks; {rotation}_32 is an "
    "entry of {rotation}. Forces on an end that is not at its node are carried to the node, and "
    "those on an end at the ground are left out. In a plane, the rows of x, y and the angle are "
    "left, and those of {constraints} that motion in the plane changes. At {x} = 0 coefficients "
    "are their limits. {balance} adds up over all elements, as above. {constraint_jacobian} is "
    "the derivative of {constraints}, and of the velocities that vanish, along the speeds. Forces "
    "{force} at the origin of a frame, moments {moment} on it and forces tau along a joint enter "
    "{balance} with the opposite sign."
)


def _formulas(scene: FiniteElementRecord, book: BookNotation) -> d.Section:
    """Formulas of every kind of element."""
    ends = ENDS.format(**book.texts, x=book.local("x"))
    blocks: list[d.Block] = [d.Paragraph((ends,), quiet=True)]
    shared: dict[tuple[tuple[str, str], ...], list[Kind]] = {}
    for kind in scene.kinds:
        shared.setdefault(book.renamed(kind.formulas), []).append(kind)
    unread = shared.pop((), [])
    for lines, kinds in shared.items():
        blocks += _kind(lines, kinds)
    if unread:
        names = ", ".join(kind.name for kind in unread)
        said = (
            f"Without formulas here: {names}. equations.function(kind, 'balance') has what they "
            "compute as expressions."
        )
        blocks.append(d.Paragraph((said,)))
    return d.Section("Equations of the elements", tuple(blocks))


def _kind(lines: Sequence[tuple[str, str]], kinds: Sequence[Kind]) -> Iterator[d.Block]:
    """Names, formulas, sources."""
    yield d.Paragraph((", ".join(kind.name for kind in kinds) + ":",))
    yield d.Listing(tuple(formula_line(about, formula) for about, formula in lines))
    sources = dict.fromkeys(kind.source for kind in kinds if kind.source)
    routines = [f for kind in kinds for f in kind.functions.values() if isinstance(f, Routine)]
    if routines:
        calls, headers = (
            ", ".join(dict.fromkeys(names))
            for names in ((f.call for f in routines), (f.headers[-1] for f in routines))
        )
        said = f"Routines of the kernels compute it, in {headers}: {calls}."
        yield d.Paragraph((said,))
    for source in sources:
        yield d.Paragraph((f"Source: {source}",), quiet=True)
