"""General equations in the notation of a book, and what a reader of it must know."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ..equations.reading.book_symbols import DEFAULT, BookNotation
from ..equations.reading.typesetting import typeset, unbroken
from ..records import dataclass
from . import content as d


@dataclass(frozen=True)
class Forms:
    """General equations of a notation.

    Attributes:
        balance: Of a tree.
        bound: With constraint forces.
        levels: Constraints on accelerations.
        rates: Where speeds are the rates of the coordinates.
        elements: A sum over elements.
    """

    balance: d.Written
    bound: d.Written
    levels: d.Written
    rates: d.Written
    elements: d.Written


_RATE = d.letter("u", 1).mathml
_FORCE = "<mo>+</mo><msup><mi>G</mi><mi>T</mi></msup><mi>λ</mi>"
_BALANCE = d.Written(
    "<mi>M</mi>" + _RATE + "<mo>+</mo><mi>h</mi><mo>=</mo><mi>f</mi><mo>+</mo><mi>τ</mi>",
    r"M \dot u + h = f + \tau",
    "M udot + h = f + tau",
)
_CARDAN = Forms(
    _BALANCE,
    d.Written(
        _BALANCE.mathml + _FORCE, _BALANCE.latex + r" + G^T \lambda", _BALANCE.text + " + Gᵀ lam"
    ),
    d.Written(
        "<mi>G</mi>" + _RATE + "<mo>=</mo><mi>γ</mi>", r"G \dot u = \gamma", "G udot = gamma"
    ),
    d.Written(d.letter("q", 1).mathml + "<mo>=</mo><mi>u</mi>", r"\dot q = u", "qdot = u"),
    d.Written(
        '<mo>∑</mo><mo stretchy="false">(</mo><mi>M</mi><mover><mi>u</mi><mo>.</mo></mover>'
        '<mo>+</mo><mi>h</mi><mo>−</mo><mi>f</mi><mo stretchy="false">)</mo><mo>=</mo>'
        "<msup><mi>G</mi><mi>T</mi></msup><mi>λ</mi>",
        r"\sum (M \dot u + h - f) = G^T \lambda",
        "sum (M udot + h - f) = Gᵀ lam",
    ),
)


def equation(left: str, right: str) -> d.Written:
    """left = right, either side an expression in the language of formulas."""
    sides = [unbroken(typeset(side)) for side in (left, right)]
    return d.Written(
        "<mo>=</mo>".join(side.mathml for side in sides),
        " = ".join(side.latex for side in sides),
        " = ".join(side.text for side in sides),
    )


# a sum over the elements e
_SUM = "total(e, 1, N, {})"
FORMS: Mapping[str, Forms] = {
    DEFAULT: _CARDAN,
    "rs": Forms(
        equation("M @ zdot_II + h_c", "h_a + tau"),
        equation("M @ zdot_II + h_c", "h_a + tau + G.T @ lam"),
        equation("G @ zdot_II", "gamma"),
        equation("zdot_I", "z_II"),
        equation(_SUM.format("M @ zdot_II + h_c - h_a"), "G.T @ lam"),
    ),
    "gc": Forms(
        equation("M @ vdot + g_c", "g_a + tau"),
        equation("M @ vdot + B.T @ lam + g_c", "g_a + tau"),
        equation("B @ vdot", "gamma"),
        equation("qdot", "v"),
        equation(_SUM.format("M @ vdot + g_c - g_a") + " + B.T @ lam", "0"),
    ),
    "kane": Forms(
        equation("F + tau + Fstar", "0"),
        equation("F + tau + Fstar + A.T @ lam", "0"),
        equation("A @ udot", "gamma"),
        equation("qdot", "u"),
        equation(_SUM.format("m_rs @ udot + h - f_a"), "A.T @ lam"),
    ),
}
NOTES: Mapping[str, tuple[str, ...]] = {
    DEFAULT: (),
    "rs": (
        "z_I are the position variables and z_II the velocity variables of the joints, in columns. "
        "A joint keeps the name that the scene gives it.",
    ),
    "gc": (
        "The multipliers have the sign of the book, opposite to that of model.multipliers. "
        "v are the rates of q, or, where rotations are no rates of coordinates, material angular "
        "velocities.",
    ),
    "kane": (
        "u are generalized speeds, also where they are the rates of coordinates. A row of F, the "
        "generalized active forces, and of F*, the generalized inertia forces, belongs to each. "
        "F is what the model applies: tau comes to it.",
    ),
}


def notes(book: BookNotation) -> Iterator[str]:
    """What the notation is, for the head of a page."""
    if book.key != DEFAULT:
        said = (
            "Symbols are those of our table for this book; docs/companions/symbols.md lists them."
        )
        yield f"In the notation of {book.book}. {said}"
    yield from NOTES[book.key]
