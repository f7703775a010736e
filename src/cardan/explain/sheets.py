"""The sections of a page in the order of reading."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from ..equations.finite_elements.record import FiniteElementRecord
from ..equations.reading.book_symbols import CARDAN, BookNotation
from ..equations.reading.loop_report import loop_lines
from ..equations.reading.notation import Notation, notation
from . import book_forms, elements, kane, motion, tables
from . import content as d
from .formulas import NOTEBOOK, Formulas
from .graph import figure

if TYPE_CHECKING:
    from ..equations.reading.explained import Explained

Progress = Callable[[str], object]


def document(
    equations: Explained | FiniteElementRecord, progress: Progress, book: BookNotation
) -> d.Document:
    """The page of equations in whatever coordinates."""
    if isinstance(equations, FiniteElementRecord):
        numbers = (*equations.parameters, *equations.inputs)
        names = {p: notation(p, numbers=book.numbers) for p in numbers}
        return _page(equations, tuple(_absolute(equations, progress, book)), names, book)
    formulas = Formulas(equations, book=book)
    sections = tuple(_relative(equations, formulas, progress))
    return _page(equations, sections, dict(book.of(equations)) | formulas.symbols, book)


def cell(equations: Explained | FiniteElementRecord) -> d.Document:
    """The parts of a page that a notebook shows: those quick to derive, tables folded."""
    formulas: list[d.Section] = []
    names: dict[str, Notation] = {}
    if isinstance(equations, FiniteElementRecord):
        tables_of = [*tables.parameters(equations.system), *elements.sections(equations, CARDAN)]
    else:
        formulas_drawn = Formulas(equations, NOTEBOOK)
        formulas = [d.Section("", _circuits(equations)), formulas_drawn.section()]
        names = dict(CARDAN.of(equations)) | formulas_drawn.symbols
        tables_of = [*tables.coordinates(equations), *tables.parameters(equations.system)]
        tables_of += tables.operations(equations)
    folded = tuple(d.Folded(section.title, section.blocks) for section in tables_of)
    return _page(equations, (*formulas, d.Section("", folded)), names)


def _page(
    equations: Explained | FiniteElementRecord,
    sections: tuple[d.Section, ...],
    names: dict[str, Notation],
    book: BookNotation = CARDAN,
) -> d.Document:
    system = equations.system
    lead = [d.Paragraph((_lead(equations),))]
    lead += [d.Paragraph((text,), quiet=True) for text in book_forms.notes(book)]
    lead += [d.Paragraph((f"Note: {note}",), quiet=True) for note in system.notes]
    return d.Document(system.name, tuple(lead), sections, names)


def _lead(equations: Explained | FiniteElementRecord) -> str:
    system = equations.system
    bodies = sum(len(body.parts) for body in system.bodies)
    if isinstance(equations, FiniteElementRecord):
        how, nq, nu = "in absolute coordinates", equations.places.nq, equations.places.nu
    else:
        method = equations.method.replace("_", "-")
        how = f"by the method {method}" + (f" ({equations.reason})" if equations.reason else "")
        nq, nu = len(equations.coordinates), len(equations.speeds)
    return (
        f"Equations of motion {how}: {_many(bodies, 'body', 'bodies')}, "
        f"{_many(nq, 'coordinate')}, {_many(nu, 'speed')}, "
        f"{_many(len(system.parameters), 'parameter')}, {_many(len(system.inputs), 'input')}."
    )


def _many(count: int, one: str, several: str = "") -> str:
    return f"{count} {one if count == 1 else several or one + 's'}"


def _relative(equations: Explained, formulas: Formulas, progress: Progress) -> Iterator[d.Section]:
    progress("drawing the graph")
    yield _graph(equations, _circuits(equations))
    yield from tables.coordinates(equations)
    yield from tables.parameters(equations.system)
    progress("simplifying equations")
    yield formulas.section()
    if formulas.book.key == "kane":
        yield from kane.partial_velocities(equations)
    progress("looking for conserved quantities")
    yield from motion.conserved(equations, formulas.book)
    progress("finding base parameters")
    yield from motion.base_parameters(equations, formulas.book)
    yield from tables.frames(equations.system)
    progress("counting operations")
    yield from tables.operations(equations)
    yield _sources(equations)


def _absolute(
    equations: FiniteElementRecord, progress: Progress, book: BookNotation
) -> Iterator[d.Section]:
    progress("drawing the graph")
    yield _graph(equations)
    yield from tables.parameters(equations.system)
    progress("counting operations")
    yield from elements.sections(equations, book)
    yield from tables.frames(equations.system)
    yield _sources(equations)


def _graph(
    equations: Explained | FiniteElementRecord, circuits: tuple[d.Block, ...] = ()
) -> d.Section:
    return d.Section("Bodies and joints", (figure(equations.system), *circuits))


def _circuits(equations: Explained) -> tuple[d.Block, ...]:
    lines = tuple((_sentence(" ".join(line.split())),) for line in loop_lines(equations))
    return (d.Listing(lines),) if lines else ()


def _sentence(line: str) -> str:
    """A line with a capital, unless it begins with a name of ours."""
    word = line.split()[0]
    return (line[0].upper() + line[1:] if word.isalpha() else line) + "."


def _sources(equations: Explained | FiniteElementRecord) -> d.Section:
    return d.Section("Sources", (d.Listing(tuple((source,) for source in equations.sources)),))
