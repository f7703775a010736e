"""The equations of motion as formulas, and where their terms come from."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from ..equations.reading.book_symbols import CARDAN, BookNotation
from ..equations.reading.chain_pattern import chain_pattern
from ..equations.reading.contributions import LETTERS, Contribution
from ..equations.reading.formula import LONGEST, SIMPLIFIED, rates_are_speeds
from ..equations.reading.notation import GREEK, Notation, notation
from ..equations.reading.typesetting import typeset
from ..errors import DerivationError
from ..ir.function import length
from ..records import dataclass
from ..schema.blocks import of_rate
from . import content as d
from . import kane
from .book_forms import FORMS

if TYPE_CHECKING:
    import sympy

    from ..equations.reading.explained import Explained


@dataclass(frozen=True)
class Limits:
    """Limits on simplification and on the length of formulas.

    Attributes:
        simplified: Operations of a function, written out in full, that is simplified.
        read: Operations of a simplified function that is shown.
        listed: Named intermediates of a function that are listed.
        entries: Entries of matrices, times owners, whose contributions are written out one by one.
        owners: Speeds of systems whose longer matrices say by entry who contributes.
    """

    simplified: int
    read: int
    listed: int
    entries: int
    owners: int


PAGE = Limits(simplified=30_000, read=1_500, listed=400, entries=400, owners=12)
# a cell answers within a second: contributions would be derived body by body
NOTEBOOK = Limits(simplified=SIMPLIFIED, read=LONGEST, listed=40, entries=0, owners=0)
# function, quantity, dots, and what it is
FUNCTIONS = (
    ("mass_matrix", "mass_matrix", 0, "mass matrix"),
    ("bias", "bias", 0, "velocity products and gravity"),
    ("applied_forces", "applied_forces", 0, "generalized applied forces of the model"),
    ("constraints", "constraints", 0, "what vanishes at position level"),
    ("constraint_jacobian", "constraint_jacobian", 0, "constraint Jacobian"),
    ("constraint_bias", "constraint_bias", 0, "velocity terms of the constraints"),
    ("qdot", "coordinates", 1, "rates of the coordinates"),
)


class Formulas:
    """Formulas of equations; ``symbols`` collects how named intermediates are set."""

    def __init__(
        self, equations: Explained, limits: Limits = PAGE, book: BookNotation = CARDAN
    ) -> None:
        self.equations = equations
        self.limits = limits
        self.book = book
        self._forms = FORMS[book.key]
        self.symbols: dict[str, Notation] = {}
        self._definitions: dict[sympy.Expr, sympy.Expr] = {}

    def section(self) -> d.Section:
        """All functions that make up the equations of motion."""
        if not self.equations.speeds:
            said = "Nothing moves freely: there are no equations of motion."
            return d.Section("Equations of motion", (d.Paragraph((said,)),))
        names = self.equations.names()
        blocks: list[d.Block] = [d.Paragraph(self._general()), *self._pattern()]
        balances: tuple[d.Block, ...] = ()
        if self.book.key == "kane":
            forces = kane.GeneralizedForces(self.equations, self.book, self._readable, self._shares)
            balances = tuple(forces.blocks())
            blocks += balances or [d.Paragraph((kane.BY_FUNCTION,))]
        for name, quantity, dots, about in FUNCTIONS:
            if name in names and not (balances and name in LETTERS):
                blocks += self._function(name, quantity, dots, about)
        return d.Section("Equations of motion", (*blocks, *self._determined()))

    def _pattern(self) -> Iterator[d.Block]:
        """A chain of equal links by its pattern."""
        lines = chain_pattern(self.equations.system)
        if lines:
            links = len(self.equations.system.bodies)
            yield d.Paragraph((f"A chain of n = {links} equal links:",))
            lines = self.book.renamed(lines)
            yield d.Listing(tuple(formula_line(about, line) for about, line in lines))

    def _general(self) -> d.Text:
        tau, multipliers = (
            d.symbol(self.book.sign(quantity)) for quantity in ("outer_forces", "multipliers")
        )
        if not self.equations.system.closed:
            return (self._forms.balance, ", where ", tau, " is what is applied from outside.")
        said = " is what is applied from outside and "
        where = (", where ", tau, said, multipliers, " are the constraint forces.")
        return (self._forms.bound, " and ", self._forms.levels, *where)

    def _function(self, name: str, quantity: str, dots: int, about: str) -> Iterator[d.Block]:
        symbol = d.symbol(self.book.sign(quantity, "", dots))
        try:
            matrix = self._readable(name)
        except DerivationError as problem:
            reason = str(problem).rstrip(".")
            yield d.Paragraph((symbol, f", {about}. {reason}."))
            yield from self._intermediates(name, quantity, dots)
            return
        if name == "qdot" and rates_are_speeds(self.equations, matrix):
            yield d.Paragraph(
                ("The speeds are the rates of the coordinates: ", self._forms.rates, ".")
            )
            return
        entries = self._entries(name, quantity, matrix)
        nonzero = [(k, index, value) for k, index, value in entries if value != 0]
        if not nonzero:
            if name in ("bias", "applied_forces"):
                yield d.Paragraph((symbol, f", {about}: zero."))
            return
        absent = "; entries that are not listed are zero" * (len(nonzero) < len(entries))
        same = ", symmetric" * (name == "mass_matrix" and matrix.rows > 1)
        yield d.Paragraph((symbol, f", {about}{same}{absent}:"))
        shares = self._shares(name, matrix)
        for k, index, value in nonzero:
            terms = tuple(
                (kane.label(one), one.matrix[k]) for one in shares or () if one.matrix[k] != 0
            )
            one = terms[0][0] if len(terms) == 1 else ""
            left = self.book.sign(quantity, index, dots)
            yield d.Formula(left, value, () if one else terms, one)
        if shares is None and name in LETTERS:
            yield from self._owners(name, [(k, index) for k, index, _ in nonzero], quantity)

    def _readable(self, name: str) -> sympy.Matrix:
        """A function as a SymPy matrix; what loops determine keeps its names in it.

        Raises:
            DerivationError: nobody would read it.
        """
        equations = self.equations
        function = equations.without_rewrites.function
        size = length(equations.named_function(name)[0] if equations.follows else function(name))
        if size <= self.limits.simplified:
            definitions, matrix = equations.named(name)
            size = sum(entry.count_ops() for entry in matrix)
        if size > self.limits.read:
            raise DerivationError(f"Written out it has {size:,} operations")
        self._definitions |= dict(definitions)
        self.symbols |= {symbol.name: parameter_notation(symbol.name) for symbol, _ in definitions}
        return matrix

    def _determined(self) -> Iterator[d.Block]:
        """Quantities that kinematic loops determine, under the names that formulas use."""
        if self._definitions:
            yield d.Paragraph(("With what the loops determine:",))
        longer = 0
        for symbol, value in self._definitions.items():
            if value.count_ops() > self.limits.read:
                longer += 1
            else:
                yield d.Formula(self.symbols[symbol.name], value)
        if longer:
            yield d.Paragraph((f"And {longer} longer ones: equations.named(...) has them.",))

    def _entries(
        self, name: str, quantity: str, matrix: sympy.Matrix
    ) -> list[tuple[int, str, sympy.Expr]]:
        """Position, index and value; a symmetric matrix is said once."""
        return [
            (k, index, value)
            for k, (index, value) in enumerate(zip(self._indices(quantity), matrix, strict=True))
            if name != "mass_matrix" or k // matrix.cols <= k % matrix.cols
        ]

    def _indices(self, quantity: str) -> Sequence[str]:
        """Rows and columns by coordinate or speed; the speed of a joint is called after it."""
        equations = self.equations
        speeds = [of_rate(name) for name in equations.speeds]
        rows = equations.constraint_rows
        if quantity == "mass_matrix":
            return [f"{a}, {b}" for a in speeds for b in speeds]
        if quantity == "constraint_bias":
            return [row.name for row in rows]
        if quantity == "constraint_jacobian":
            return [f"{row.name}, {b}" for row in rows for b in speeds]
        if quantity == "constraints":
            return [row.name for row in rows if row.level == "position"]
        return equations.coordinates if quantity == "coordinates" else speeds

    def _shares(self, name: str, matrix: sympy.Matrix) -> tuple[Contribution, ...] | None:
        """Contributions that add up to a matrix; None where they are too long to write out."""
        if name not in LETTERS:
            return ()
        owners = len(self.equations.system.bodies) + len(self.equations.system.forces)
        # what follows has its name in a matrix, but not in what is added up to it
        if len(matrix) * owners > self.limits.entries or self.equations.follows:
            return None
        contributions = self.equations.contributions(name)
        try:
            return contributions if all(one.matrix is not None for one in contributions) else None
        except DerivationError:
            return None

    def _owners(
        self, name: str, entries: Sequence[tuple[int, str]], quantity: str
    ) -> Iterator[d.Block]:
        """Who contributes to which entry, where the contributions are too long to be written."""
        if len(self.equations.speeds) > self.limits.owners:
            return
        contributions = self.equations.contributions(name)
        letter = self.book.texts[quantity]
        rows = []
        for k, index in entries:
            who = [kane.label(one) for one in contributions if one.function.roots[k]]
            rows.append((f"{letter}[{index}]", ", ".join(dict.fromkeys(who))))
        table = d.Table(("entry", "comes from"), tuple(rows))
        yield d.Folded(f"Where the terms of {letter} come from", (table,))

    def _intermediates(self, name: str, quantity: str, dots: int) -> Iterator[d.Block]:
        """A long function with named intermediates, where there are not too many to list."""
        replacements, matrix = self.equations.symbolic(name)
        has = f"equations.symbolic('{name}') has them"
        entries = [entry for entry in self._entries(name, quantity, matrix) if entry[2] != 0]
        if len(replacements) > self.limits.listed:
            said = f"{len(replacements):,} named intermediates, too many to be listed: {has}."
            yield d.Paragraph((said,))
        else:
            blocks = [d.Formula(self._sign(symbol), value) for symbol, value in replacements]
            blocks += [
                d.Formula(self.book.sign(quantity, index, dots), x) for _, index, x in entries
            ]
            title = (
                f"{self.book.sign(quantity).character} with {len(replacements)} named intermediates"
            )
            yield d.Folded(f"{title}: {has}", tuple(blocks))
        if name in LETTERS:
            yield from self._owners(name, [(k, index) for k, index, _ in entries], quantity)

    def _sign(self, symbol: sympy.Symbol) -> Notation:
        """Choose the notation of a named intermediate for all formulas that follow."""
        return self.symbols.setdefault(symbol.name, intermediate(symbol.name))


def parameter_notation(name: str) -> Notation:
    """Notation of a quantity that loops determine: ``phi.theta.theta`` is a φ with the index θθ."""
    head, *by = name.split(".")
    first, index = notation(head), "".join(notation(part).character for part in by)
    return Notation(first.letter, ", ".join(filter(None, (first.index, index))))


def intermediate(name: str) -> Notation:
    """Notation of a named intermediate: ``lower.omega_y`` is an ω with the index lower, y."""
    owner, _, quantity = name.rpartition(".")
    letter, _, component = quantity.partition("_")
    if letter and (letter in GREEK or len(letter) == 1) and owner:
        return Notation(letter, ", ".join(filter(None, (owner, component))))
    return Notation(quantity, owner) if owner else notation(name)


def formula_line(about: str, formula: str) -> d.Text:
    """A formula behind what it is; lines may end between its segments."""
    parts = list[d.Inline]([f"{about}: "] if about else [])
    for segment in typeset(formula):
        parts += [d.Written(segment.mathml, segment.latex, segment.text), " "]
    return tuple(parts[:-1])
