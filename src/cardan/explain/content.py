"""Contents of a page, independent of its looks: text, formulas, tables, figures.

Strings are whatever users called their things; every writer escapes what it writes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING, TypeAlias

from ..equations.reading.notation import Notation
from ..records import dataclass

if TYPE_CHECKING:
    import sympy


@dataclass(frozen=True)
class Math:
    """A SymPy expression within a line."""

    expression: sympy.Basic


@dataclass(frozen=True)
class Written:
    """A formula that is always the same, in both languages."""

    mathml: str
    latex: str
    text: str


def letter(name: str, dots: int = 0) -> Written:
    """A letter in text, such as M or gamma."""
    return symbol(Notation(name, "", dots))


def symbol(sign: Notation) -> Written:
    """A symbol in text, such as M or q with a dot."""
    base = f"<mi>{sign.character}</mi>"
    marked = f"<msup>{base}<mo>*</mo></msup>" if sign.mark == "star" else base
    dotted = f"<mover>{marked}<mo>.</mo></mover>" if sign.dots else marked
    index = f"<msub>{dotted}<mi>{sign.index}</mi></msub>" if sign.index else dotted
    name = sign.letter + "*" * (sign.mark == "star") + "dot" * sign.dots
    return Written(index, sign.latex(), name + f"_{sign.index}" * bool(sign.index))


Inline: TypeAlias = str | Math | Written
Text: TypeAlias = tuple[Inline, ...]
Cells: TypeAlias = tuple[str | float | Math, ...]


@dataclass(frozen=True)
class Paragraph:
    """Text; ``quiet`` for what is said aside."""

    text: Text
    quiet: bool = False


@dataclass(frozen=True)
class Formula:
    """left = right on lines of its own, and what it is the sum of.

    Attributes:
        left: What is set.
        right: SymPy expression.
        terms: (who, expression): they add up to the right side.
        origin: Who it all comes from, where that is one.
    """

    left: Notation
    right: sympy.Basic
    terms: tuple[tuple[str, sympy.Expr], ...] = ()
    origin: str = ""

    @property
    def text(self) -> str:
        """The formula as plain text."""
        left = self.left
        mark = "*" if left.mark == "star" else ""
        index = f"[{left.index}]" if left.index else ""
        return f"{left.letter}{mark}{('', 'dot', 'ddot')[left.dots]}{index} = {self.right}"


@dataclass(frozen=True)
class Table:
    """Cells are text, numbers or formulas; a column of numbers stands to the right."""

    head: tuple[str, ...]
    rows: tuple[Cells, ...]


@dataclass(frozen=True)
class Figure:
    """A drawing in the languages of pages and of TeX."""

    svg: str
    tikz: str
    caption: str


@dataclass(frozen=True)
class Listing:
    """Short texts, one below the other."""

    items: tuple[Text, ...]


@dataclass(frozen=True)
class Folded:
    """Blocks that only some readers want."""

    title: str
    blocks: tuple[Block, ...]


Block: TypeAlias = "Paragraph | Formula | Table | Figure | Listing | Folded"


@dataclass(frozen=True)
class Section:
    """A heading and what stands below it."""

    title: str
    blocks: tuple[Block, ...]


@dataclass(frozen=True)
class Document:
    """A page.

    Attributes:
        title: Name of the scene.
        lead: What it is, below the title.
        sections: In the order of reading.
        symbols: How names of symbols are set.
    """

    title: str
    lead: tuple[Paragraph, ...]
    sections: tuple[Section, ...]
    symbols: Mapping[str, Notation] = field(default_factory=dict, repr=False)


def is_negative(expression: sympy.Expr) -> bool:
    """True when an expression is written with a leading minus."""
    first = expression.as_ordered_terms()[0] if expression.is_Add else expression
    return bool(first.could_extract_minus_sign())
