"""Conserved quantities of motions, and the inertia parameters they depend on."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from ..equations.functions.base_parameters import base_parameters as combinations_of
from ..equations.reading.book_symbols import CARDAN, BookNotation
from ..equations.reading.notation import Notation
from ..errors import DerivationError
from ..ir.function import length
from . import content as d
from .tables import unit

if TYPE_CHECKING:
    from ..equations.functions.base_parameters import BaseParameters
    from ..equations.reading.conserved import Quantity
    from ..equations.reading.explained import Explained

# speeds of systems whose integrals are looked for, bodies of those whose base parameters are listed
LARGEST = 60
# operations of a conserved quantity that is written out, and before it is simplified
WRITTEN, LONGEST = 250, 20_000


def conserved(equations: Explained, book: BookNotation = CARDAN) -> Iterator[d.Section]:
    """Momenta and energy that stay constant."""
    if not 0 < len(equations.speeds) <= LARGEST:
        return
    integrals = equations.conserved()
    blocks: list[d.Block] = []
    for one in integrals.quantities:
        blocks += _quantity(one, book)
    sentences = []
    if "energy" not in integrals.names:
        explanation = integrals.energy_statement()
        sentences.append(explanation[0].upper() + explanation[1:] + ".")
    if not integrals.quantities and integrals.count:
        sentences.append("No momentum is conserved.")
    if integrals.cyclic:
        sentences.append(f"Nothing depends on {', '.join(integrals.cyclic)}.")
    if integrals.events and integrals.quantities:
        sentences.append("All this holds between events: an impact may change it.")
    if sentences:
        blocks.append(d.Paragraph((" ".join(sentences),)))
    if integrals.count:
        said = (
            f"Rates looked at in {integrals.count} states drawn by chance; those taken for zero "
            "are "
            f"below {max(integrals.residual, 1e-16):.0e} of their terms."
        )
        blocks.append(d.Paragraph((said,), quiet=True))
    yield d.Section("Conserved quantities", tuple(blocks))


def _quantity(one: Quantity, book: BookNotation) -> Iterator[d.Block]:
    name = one.name[0].upper() + one.name[1:]
    same = f", which is the {' and the '.join(one.also)}" if one.also else ""
    holds = f"; {one.condition}" if one.condition else ""
    yield d.Paragraph((f"{name}{same}{holds} [{unit(one.unit)}]:",))
    try:
        if length(one.function) > LONGEST:
            raise DerivationError("too long")
        expression = one.expression
        if expression.count_ops() > WRITTEN:
            raise DerivationError("too long")
        yield d.Formula(_letter(one.name, book), expression)
    except DerivationError:
        yield d.Paragraph(("Its expression is too long to be written out here.",), quiet=True)


def _letter(name: str, book: BookNotation) -> Notation:
    parts = name.split()
    if name == "energy":
        return book.sign("energy")
    if name.startswith("linear"):
        return book.sign("linear_momentum", parts[3] if len(parts) == 4 else "")
    if name.startswith("angular"):
        return book.sign("angular_momentum", parts[3] + (", c" if name.endswith("mass") else ""))
    return book.sign("momentum", name.removeprefix("momentum of "))


def base_parameters(equations: Explained, book: BookNotation = CARDAN) -> Iterator[d.Section]:
    """Combinations of masses and inertias that determine the motion."""
    if len(equations.system.bodies) > LARGEST:
        return
    try:
        parameters = combinations_of(equations)
    except DerivationError:
        return
    if parameters.combinations:
        of = "the joint forces of the tree" if equations.system.closed else "the joint forces"
        yield d.Section("Base parameters", combinations(parameters, of, book))


def combinations(
    parameters: BaseParameters, of: str, book: BookNotation = CARDAN
) -> tuple[d.Block, ...]:
    """Base parameters, and what has no effect alone."""
    mass, moment, inertia = (book.sign(quantity).character for quantity in BASE_QUANTITIES)
    said = (
        f"{len(parameters.combinations)} combinations of masses ({mass}), first moments ({moment}) "
        f"and second moments ({inertia}) about the joints determine {of}:"
    )
    blocks: list[d.Block] = [d.Paragraph((said,))]
    formulas: list[d.Block] = [
        d.Formula(_base(name, book), expression)
        for name, expression in parameters.combinations.items()
    ]
    blocks += formulas if len(formulas) <= 24 else [d.Folded("All of them", tuple(formulas))]
    for title, names in (
        ("Their names", tuple(parameters.combinations)),
        ("Without any effect", parameters.without_effect),
        ("Only in combination with others", parameters.only_combined),
    ):
        if names:
            blocks.append(d.Paragraph((f"{title}: {', '.join(names)}.",), quiet=True))
    return tuple(blocks)


BASE_QUANTITIES = ("base_mass", "base_moment", "base_inertia")
INERTIAS = ("xx", "yy", "zz", "xy", "xz", "yz")


def _base(name: str, book: BookNotation) -> Notation:
    """``lower.base_xx`` is J with the index lower, xx; no parameter is called so."""
    owner, _, entry = name.rpartition(".base_")
    kind, _, axis = entry.partition("_")
    if kind in INERTIAS:
        return book.sign("base_inertia", ", ".join(filter(None, (owner, kind))))
    index = ", ".join(filter(None, (owner, axis)))
    quantity = f"base_{kind}"
    return book.sign(quantity, index) if quantity in BASE_QUANTITIES else Notation(entry, index)
