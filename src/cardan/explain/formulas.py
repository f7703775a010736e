"""The equations of motion as formulas, and where their terms come from."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from ..equations.contributions import LETTERS, TURNING, WEIGHT, Contribution
from ..equations.formula import rates_are_speeds
from ..equations.notation import GREEK, Notation, notation
from ..errors import DerivationError
from ..ir.function import Function, operands
from ..ir.names import of_rate
from . import content as d

if TYPE_CHECKING:
    from ..equations.record import Equations

# named intermediates that are listed
LISTED = 400
# operations of a function that is simplified, and of one that is read, both written out in full
LONGEST, READ = 30_000, 1_500
# entries of matrices, times owners, whose contributions are written out one by one
ENTRIES = 400
# function, letter, dots, and what it is
FUNCTIONS = (
    ("mass_matrix", "M", 0, "mass matrix"),
    ("bias", "h", 0, "velocity products and gravity"),
    ("applied", "f", 0, "generalized applied forces of the model"),
    ("constraints", "g", 0, "what vanishes at position level"),
    ("constraint_jacobian", "G", 0, "constraint Jacobian"),
    ("qdot", "q", 1, "rates of the coordinates"),
)
# parts of h that are told apart
CAUSES = (TURNING, WEIGHT)


_RATE = d.letter("u", 1).mathml
_FORCE = "<mo>+</mo><msup><mi>G</mi><mi>T</mi></msup><mi>λ</mi>"
BALANCE = d.Written(
    "<mi>M</mi>" + _RATE + "<mo>+</mo><mi>h</mi><mo>=</mo><mi>f</mi><mo>+</mo><mi>τ</mi>",
    r"M \dot u + h = f + \tau",
    "M udot + h = f + tau",
)
BOUND = d.Written(
    BALANCE.mathml + _FORCE, BALANCE.latex + r" + G^T \lambda", BALANCE.text + " + Gᵀ lam"
)
HELD = d.Written(
    "<mi>G</mi>" + _RATE + "<mo>=</mo><mi>γ</mi>", r"G \dot u = \gamma", "G udot = gamma"
)
RATES = d.Written(d.letter("q", 1).mathml + "<mo>=</mo><mi>u</mi>", r"\dot q = u", "qdot = u")
TAU = d.Written("<mi>τ</mi>", r"\tau", "tau")
LAMBDA = d.Written("<mi>λ</mi>", r"\lambda", "lam")


class Formulas:
    """Formulas of equations; ``symbols`` collects how named intermediates are set."""

    def __init__(self, equations: Equations) -> None:
        self.equations = equations
        self.symbols: dict[str, Notation] = {}

    def section(self) -> d.Section:
        """All functions that make up the equations of motion."""
        if not self.equations.speeds:
            said = "Nothing moves freely: there are no equations of motion."
            return d.Section("Equations of motion", (d.Paragraph((said,)),))
        known = self.equations.names()
        blocks: list[d.Block] = [d.Paragraph(self._general())]
        for name, letter, dots, about in FUNCTIONS:
            if name in known:
                blocks += self._function(name, letter, dots, about)
        return d.Section("Equations of motion", tuple(blocks))

    def _general(self) -> d.Text:
        if not self.equations.system.closed:
            return (BALANCE, ", where ", TAU, " is what is applied from outside.")
        said = " is what is applied from outside and "
        return (BOUND, " and ", HELD, ", where ", TAU, said, LAMBDA, " are the forces of "
                "constraint.")  # fmt: skip

    def _function(self, name: str, letter: str, dots: int, about: str) -> Iterator[d.Block]:
        if name == "qdot" and self._plain():
            yield d.Paragraph(("The speeds are the rates of the coordinates: ", RATES, "."))
            return
        try:
            matrix = self._readable(name)
        except DerivationError as problem:
            told = str(problem).rstrip(".")
            yield d.Paragraph((d.letter(letter, dots), f", {about}. {told}."))
            yield from self._intermediates(name, letter, dots)
            return
        entries = self._entries(name, letter, matrix)
        nonzero = [(k, index, value) for k, index, value in entries if value != 0]
        if not nonzero:
            if name in ("bias", "applied"):
                yield d.Paragraph((d.letter(letter, dots), f", {about}: zero."))
            return
        absent = "; entries that are not listed are zero" * (len(nonzero) < len(entries))
        same = ", symmetric" * (name == "mass_matrix" and matrix.rows > 1)
        yield d.Paragraph((d.letter(letter, dots), f", {about}{same}{absent}:"))
        shares = self._shares(name, matrix)
        for k, index, value in nonzero:
            terms = tuple((_who(one), one.matrix[k]) for one in shares or () if one.matrix[k] != 0)
            one = terms[0][0] if len(terms) == 1 else ""
            yield d.Formula(Notation(letter, index, dots), value, () if one else terms, one)
        if shares is None and name in LETTERS:
            yield from self._owners(name, [(k, index) for k, index, _ in nonzero], letter)

    def _readable(self, name: str) -> Any:
        """A function as a SymPy matrix.

        Raises:
            DerivationError: nobody would read it.
        """
        function = self.equations.as_described.function(name)
        whole = size(function)
        matrix = self.equations.written(name) if whole <= LONGEST else None
        length = whole if matrix is None else sum(entry.count_ops() for entry in matrix)
        if matrix is None or length > READ:
            raise DerivationError(f"Written out it has {length:,} operations")
        return matrix

    def _plain(self) -> bool:
        try:
            return rates_are_speeds(self.equations, self.equations.kinematics)
        except DerivationError:
            return False

    def _entries(self, name: str, letter: str, matrix: Any) -> list[tuple[int, str, Any]]:
        """Position, index and value; a symmetric matrix is said once."""
        return [
            (k, index, value)
            for k, (index, value) in enumerate(zip(self._indices(letter), matrix, strict=True))
            if name != "mass_matrix" or k // matrix.cols <= k % matrix.cols
        ]

    def _indices(self, letter: str) -> Sequence[str]:
        """Rows and columns by coordinate or speed; the speed of a joint is called after it."""
        equations = self.equations
        speeds = [of_rate(name) for name in equations.speeds]
        rows = equations.constraint_rows
        if letter == "M":
            return [f"{a}, {b}" for a in speeds for b in speeds]
        if letter == "G":
            return [f"{row.name}, {b}" for row in rows for b in speeds]
        if letter == "g":
            return [row.name for row in rows if row.level == "position"]
        return equations.coordinates if letter == "q" else speeds

    def _shares(self, name: str, matrix: Any) -> tuple[Contribution, ...] | None:
        """What adds up to a matrix; None where that is too much to write out."""
        if name not in LETTERS:
            return ()
        owners = len(self.equations.system.bodies) + len(self.equations.system.forces)
        if len(matrix) * owners > ENTRIES:
            return None
        found = self.equations.contributions(name)
        try:
            return found if all(one.matrix is not None for one in found) else None
        except DerivationError:
            return None

    def _owners(
        self, name: str, entries: Sequence[tuple[int, str]], letter: str
    ) -> Iterator[d.Block]:
        """Who contributes to which entry, where the contributions are too long to be written."""
        if len(self.equations.speeds) > LARGE:
            return
        found = self.equations.contributions(name)
        rows = []
        for k, index in entries:
            who = [_who(one) for one in found if one.function.roots[k]]
            rows.append((f"{letter}[{index}]", ", ".join(dict.fromkeys(who))))
        table = d.Table(("entry", "comes from"), tuple(rows))
        yield d.Folded(f"Where the terms of {letter} come from", (table,))

    def _intermediates(self, name: str, letter: str, dots: int) -> Iterator[d.Block]:
        """A long function with named intermediates, where there are not too many to list."""
        replacements, matrix = self.equations.symbolic(name)
        if len(replacements) > LISTED:
            yield d.Paragraph(
                (f"It has {len(replacements):,} named intermediates: too many to be listed.",)
            )
        else:
            known = self.equations.blocks
            taken = {entry for block in known.values() for entry in block.entries}
            for symbol, _ in replacements:
                if symbol.name not in taken:
                    self.symbols[symbol.name] = intermediate(symbol.name)
            blocks = [d.Formula(self.symbols[s.name], value) for s, value in replacements]
            entries = self._entries(name, letter, matrix)
            blocks += [
                d.Formula(Notation(letter, index, dots), value)
                for _, index, value in entries
                if value != 0
            ]
            yield d.Folded(f"{letter} with named intermediates", tuple(blocks))
        if name in LETTERS and len(self.equations.speeds) <= LARGE:
            indices = self._entries(name, letter, matrix)
            yield from self._owners(name, [(k, index) for k, index, v in indices if v], letter)


# speeds of systems whose entries are listed with their owners
LARGE = 12


def size(function: Function) -> int:
    """Operations of all entries written out in full."""
    nodes, sizes = function.graph.nodes, dict[int, int]()
    for i in function.live():
        read = operands(nodes[i])
        sizes[i] = sum(sizes[k] for k in read) + bool(read)
    return sum(sizes[root] for root in function.roots)


def _who(one: Contribution) -> str:
    """Body or force element, and of which kind its terms are."""
    return f"{one.owner}, {one.cause}" if one.cause in CAUSES else one.owner


def intermediate(name: str) -> Notation:
    """How a named intermediate is set: ``lower.omega_y`` is an ω with the index lower, y."""
    owner, _, quantity = name.rpartition(".")
    letter, _, rest = quantity.partition("_")
    if letter and (letter in GREEK or len(letter) == 1) and owner:
        return Notation(letter, ", ".join(filter(None, (owner, rest))))
    return Notation(quantity, owner) if owner else notation(name)
