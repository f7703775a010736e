"""Symbols of quantities in the notations of books: one table, from which pages and lists are made.

A symbol is a letter or the name of a Greek one, with a word for a mark (``dot``, ``star``) and an
index behind ``_``. A star at its end says that the book has no symbol for this quantity, or
none that could be confirmed: the symbol is then ours, and differs from all others of the notation.

Source: R. E. Roberson and R. Schwertassek, Dynamics of Multibody Systems (1988), with R.
Schwertassek and O. Wallrapp, Dynamik flexibler Mehrkörpersysteme (1999), for the state variables;
M. Géradin and A. Cardona, Flexible Multibody Dynamics (2001); T. R. Kane and D. A. Levinson,
Dynamics: Theory and Applications (1985).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

from ...elements.formulas import Lines
from ...errors import DerivationError, near
from ...records import dataclass
from .notation import NUMBERS, Notation, symbols

if TYPE_CHECKING:
    from ..record import EquationRecord

DEFAULT = "cardan"
# notation -> the book it is of
BOOKS: Mapping[str, str] = {
    DEFAULT: "cardan",
    "rs": "Roberson and Schwertassek, Dynamics of Multibody Systems (1988)",
    "gc": "Géradin and Cardona, Flexible Multibody Dynamics (2001)",
    "kane": "Kane and Levinson, Dynamics: Theory and Applications (1985)",
}
OURS = "*"

# quantity, what it is, and its symbol in every notation, in the order of BOOKS
TABLE = (
    # the system and its graph
    ("coordinates", "generalized coordinates", "q", "z_I", "q", "q"),
    ("speeds", "speeds", "u", "z_II", "v*", "u"),
    ("kinematic_matrix", "speeds to rates of the coordinates", "N", "Z", "N*", "W"),
    ("incidence", "incidence matrix of the graph", "S_g", "S", "S_g*", "S_g*"),
    ("paths", "path matrix of the spanning tree", "T_g", "T", "T_g*", "T_g*"),
    ("joint_modes", "velocities that a joint allows, by its speeds", "S", "phi", "S*", "S*"),
    # equations of motion
    ("mass_matrix", "mass matrix", "M", "M", "M", "m_rs"),
    ("bias", "velocity products and gravity", "h", "h_c*", "g_c*", "h*"),
    ("applied_forces", "generalized applied forces of the model", "f", "h_a*", "g_a*", "f_a*"),
    ("outer_forces", "what is applied from outside", "tau", "tau*", "tau*", "tau*"),
    ("active_forces", "generalized active forces", "f_w", "h_w*", "g_w*", "F"),
    ("inertia_forces", "generalized inertia forces", "f_i", "h_i*", "g_i*", "Fstar"),
    ("partial_velocities", "derivatives of a velocity by the speeds", "J_v", "J_v*", "J_v*", "v_r"),
    ("partial_angular_velocities", "derivatives of an angular velocity by the speeds",
     "J_w", "J_w*", "J_w*", "omega_r"),
    # constraints
    ("constraints", "what vanishes at position level", "g", "g", "Phi", "f"),
    ("constraint_jacobian", "constraint Jacobian", "G", "G", "B", "A"),
    ("constraint_bias", "velocity terms of the constraints", "gamma", "gamma*", "gamma*", "gamma*"),
    ("multipliers", "constraint forces", "lambda", "lambda", "lambda", "lambda*"),
    # what is conserved
    ("energy", "energy", "E", "W*", "E*", "E"),
    ("kinetic_energy", "kinetic energy", "T", "E_k*", "K", "K"),
    ("potential_energy", "potential energy", "V", "V", "V", "P"),
    ("linear_momentum", "linear momentum", "P", "P*", "P*", "L"),
    ("angular_momentum", "angular momentum", "L", "H", "L*", "H"),
    ("momentum", "momentum dT/du of a speed", "p", "p*", "p*", "p_r"),
    # bodies
    ("mass", "mass of a body", "m", "m", "m", "m"),
    ("center_of_mass", "center of mass in axes of the body", "c", "c*", "c*", "c*"),
    ("inertia", "inertia about the center of mass", "I", "I*", "J", "I"),
    ("gravity", "acceleration of gravity", "g", "g_0*", "g", "g"),
    ("base_mass", "base parameter: mass", "mu", "mu*", "mu*", "mu*"),
    ("base_moment", "base parameter: first moment", "sigma", "sigma*", "sigma*", "sigma*"),
    ("base_inertia", "base parameter: second moment", "J", "K*", "Theta*", "J*"),
    # elements between nodes
    ("rotation", "rotation: axes of a frame to axes of the ground", "R", "A", "R", "C"),
    ("position", "position of an origin", "p", "r", "x", "p"),
    ("angular_velocity", "angular velocity in axes of the body",
     "omega", "omega", "Omega", "omega"),
    ("velocity", "velocity of an origin", "v", "v", "xdot", "v"),
    ("balance", "part of an element in the balance of forces", "b", "b*", "b*", "b*"),
    ("force", "force on an end", "F", "F", "F", "R"),
    ("moment", "moment on an end", "M", "M_e*", "M_e*", "T"),
    ("unit_matrix", "unit matrix", "I", "E", "I", "U"),
)  # fmt: skip
# letters that our own pages use for two quantities each, which their index or place tells apart
OVERLOADED = frozenset({"g", "p", "M", "I"})
# letters of formulas of elements -> quantity; rows of constraints are a ``g`` too
LETTERS: Mapping[str, str] = {
    "q": "coordinates",
    "u": "speeds",
    "G": "constraint_jacobian",
    "lam": "multipliers",
    "b": "balance",
    "R": "rotation",
    "p": "position",
    "omega": "angular_velocity",
    "v": "velocity",
    "T": "kinetic_energy",
    "V": "potential_energy",
    "F": "force",
    "M": "moment",
    "I": "unit_matrix",
    "g": "gravity",
}
# which of them have an index always, and which never: without it F is a flexibility
INDEXED, PLAIN = frozenset("FM"), frozenset("I")
# end of the name of a number -> quantity
NUMBER_QUANTITIES: Mapping[str, str] = {
    "mass": "mass",
    "com": "center_of_mass",
    "inertia": "inertia",
    "gravity": "gravity",
}
# indices that stand for those of an entry
ENTRY_INDICES = frozenset({"r", "rs"})
# functions of the language of formulas
CALLS = frozenset(
    {"sin", "cos", "cot", "sqrt", "dot", "skew", "inverse", "block", "column", "matrix", "row",
     "diagonal", "unit", "rotation", "rotation_vector", "trace", "total", "min", "max", "atan2"}
)  # fmt: skip
_SYMBOL = re.compile(r"([A-Za-z]+?)(star|bar)?(d?dot)?(?:_(\w+))?")
_WORD = re.compile(r"(?<![\w.])[A-Za-z]\w*")


@dataclass(frozen=True)
class BookNotation:
    """Symbols of one notation.

    Attributes:
        key: ``"cardan"``, ``"rs"``, ``"gc"`` or ``"kane"``.
        symbols: Symbol by quantity.
        ours: Quantities for which the symbol is not from the book.
        rates: True where the speed of a joint is written as the rate of its coordinate.
    """

    key: str
    symbols: Mapping[str, str]
    ours: frozenset[str]
    rates: bool

    @property
    def book(self) -> str:
        return BOOKS[self.key]

    def sign(self, quantity: str, index: str = "", dots: int = 0) -> Notation:
        """Notation of a quantity, with an index behind its own."""
        sign = parsed(self.symbols[quantity])
        base = "" if index and sign.index in ENTRY_INDICES else sign.index
        joined = ", ".join(filter(None, (base, index)))
        return replace(sign, index=joined, dots=sign.dots + dots)

    @property
    def texts(self) -> dict[str, str]:
        """Symbol of every quantity in text: without a mark that says where it is from."""
        return {quantity: _typed(self.sign(quantity)) for quantity in self.symbols}

    def local(self, letter: str) -> str:
        """A letter that formulas of elements use for something of their own."""
        return _typed(self._local(parsed(letter)))

    def _local(self, sign: Notation) -> Notation:
        """A bar where the book uses the letter for a quantity of the table."""
        taken = self.key != DEFAULT and sign.letter in self._element_letters
        return replace(sign, mark="bar") if taken else sign

    @cached_property
    def numbers(self) -> Mapping[str, str]:
        """Letters of gravity and of the numbers of a body, by the end of their names."""
        return {end: self.symbols[NUMBER_QUANTITIES[end]] for end in NUMBERS}

    def of(self, equations: EquationRecord) -> Mapping[str, Notation]:
        """Notation by name of symbol, for coordinates, speeds, inputs and parameters."""
        return symbols(equations, self.sign("speeds"), self.rates, self.numbers)

    @cached_property
    def _element_letters(self) -> frozenset[str]:
        """Letters of this notation that formulas of elements contain."""
        quantities = {*LETTERS.values(), "constraints"}
        return frozenset(parsed(self.symbols[quantity]).letter for quantity in quantities)

    def renamed(self, lines: Lines) -> Lines:
        """Formulas of an element, and what is said of them, in the symbols of this notation.

        A letter of the element that the book uses for a quantity of the table gets a bar.
        """
        if self.key == DEFAULT:
            return lines
        names = set(_WORD.findall(" ".join(line for _, line in lines)))
        closes = any(line.startswith("g = ") for _, line in lines) or "G" in names
        quantities = {**LETTERS, **({"g": "constraints"} if closes else {})}

        def formula_name(match: re.Match[str]) -> str:
            return _typed(self._symbol(match[0], quantities))

        def said_name(match: re.Match[str]) -> str:
            # 'a' is a word there, and M the mass matrix
            letter = parsed(match[0]).letter
            is_name = match[0] in names or (letter in (*quantities, "lambda") and letter != "M")
            return formula_name(match) if is_name and match[0] != "a" else match[0]

        return tuple(
            (_WORD.sub(said_name, about), _WORD.sub(formula_name, line)) for about, line in lines
        )

    def _symbol(self, name: str, quantities: Mapping[str, str]) -> Notation:
        """Notation of a name in a formula of an element."""
        sign = parsed(name)
        letter = "lam" if sign.letter == "lambda" else sign.letter
        local = letter in (PLAIN if sign.index else INDEXED)
        if name in CALLS:
            return Notation(name)
        if letter in quantities and not local:
            return self.sign(quantities[letter], sign.index, sign.dots)
        return self._local(sign)


def parsed(symbol: str) -> Notation:
    """Notation of a name such as ``omegadot_1`` or ``Fstar``."""
    match = _SYMBOL.fullmatch(symbol)
    assert match is not None, symbol
    letter, mark, dotted, index = match.groups()
    dots = {None: 0, "dot": 1, "ddot": 2}[dotted]
    return Notation("lambda" if letter == "lam" else letter, index or "", dots, mark or "")


def _typed(sign: Notation) -> str:
    """A notation as a name in the language of formulas."""
    letter = "lam" if sign.letter == "lambda" else sign.letter
    dotted = ("", "dot", "ddot")[sign.dots]
    index = sign.index.replace(", ", "_")
    return letter + sign.mark + dotted + (f"_{index}" if index else "")


def _notations() -> Iterator[BookNotation]:
    for column, key in enumerate(BOOKS, 2):
        cells = {row[0]: row[column] for row in TABLE}
        ours = frozenset(quantity for quantity, cell in cells.items() if cell.endswith(OURS))
        symbols = {quantity: cell.removesuffix(OURS) for quantity, cell in cells.items()}
        yield BookNotation(key, symbols, ours, rates=key != "kane")


NOTATIONS: Mapping[str, BookNotation] = {one.key: one for one in _notations()}
CARDAN = NOTATIONS[DEFAULT]


def book_notation(key: str) -> BookNotation:
    """Symbols of a notation by its name.

    Raises:
        DerivationError: there is none of this name.
    """
    if key not in NOTATIONS:
        raise DerivationError(f"there is no notation '{key}'.{near(key, NOTATIONS)}")
    return NOTATIONS[key]
