"""Mass matrix and bias come out as books have them: equal, and with no more terms."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.equations.formalisms import FORMALISMS
from equations.classical import CLASSICAL, Classical
from table import each


def terms(entry: sp.Expr) -> int:
    """Summands with brackets multiplied out."""
    return 0 if entry == 0 else len(sp.Add.make_args(sp.expand(entry)))


@each("method", list(FORMALISMS))
@each("name", CLASSICAL)
def test_equal_to_the_book(name: str, method: str) -> None:
    book = CLASSICAL[name]
    equations = cd.derive(book.scene(), method=method)
    for ours, theirs in (
        (equations.mass_matrix, sp.Matrix(book.mass_matrix)),
        (equations.bias, sp.Matrix(book.bias)),
    ):
        assert (ours - theirs).applyfunc(sp.simplify) == sp.zeros(*theirs.shape)
        check_numbers(ours, theirs)


def check_numbers(ours: sp.Matrix, theirs: sp.Matrix) -> None:
    """Equal at random values of all symbols."""
    symbols = sorted(ours.free_symbols | theirs.free_symbols, key=str)
    values = np.random.default_rng(7).uniform(0.5, 1.5, len(symbols))
    first, second = (
        np.array(sp.lambdify(symbols, m, cse=True)(*values), dtype=float) for m in (ours, theirs)
    )
    # sums of less than ten products of numbers near 1
    np.testing.assert_allclose(first, second, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("name", CLASSICAL)
def test_no_more_terms_than_the_book(name: str) -> None:
    book: Classical = CLASSICAL[name]
    equations = cd.derive(book.scene())
    for ours, theirs, counted in zip(
        (equations.mass_matrix, equations.bias),
        (sp.Matrix(book.mass_matrix), sp.Matrix(book.bias)),
        book.terms,
        strict=True,
    ):
        assert tuple(terms(entry) for entry in theirs) == counted, "the book was counted wrongly"
        assert all(terms(entry) <= n for entry, n in zip(ours, counted, strict=True))
        assert all(a.count_ops() <= b.count_ops() for a, b in zip(ours, theirs, strict=True))


def test_form_of_the_book() -> None:
    M = cd.derive(CLASSICAL["top"].scene()).mass_matrix
    I1, I3, theta = sp.symbols("I1 I3 theta")
    assert M[0, 0] == I1 * sp.sin(theta) ** 2 + I3 * sp.cos(theta) ** 2
    h = cd.derive(CLASSICAL["double"].scene()).bias
    assert sp.sin(sp.Symbol("theta1") + sp.Symbol("theta2")) in h.atoms(sp.sin)


def test_opposed_axes_give_a_difference_of_angles() -> None:
    scene = cd.Scene("opposed", gravity=(0, 0, -9.81))
    l = scene.parameter("l", 1.0, unit="m")
    upper = scene.body("upper", mass=1.0, com=(0, 0, -l))
    lower = scene.body("lower", mass=1.0, com=(0, 0, -l))
    scene.joint("a", cd.Revolute("y"), scene.ground, upper)
    scene.joint("b", cd.Revolute((0, -1, 0)), upper.at(0, 0, -l), lower)
    waves = cd.derive(scene).bias.atoms(sp.sin)
    a, b = sp.symbols("a b")
    assert waves == {sp.sin(a), sp.sin(b), sp.sin(a - b)}


def test_numbers_of_a_book() -> None:
    scene = cd.Scene("rod", gravity=(0, 0, -9.81))
    m, l = scene.parameter("m", 1.0, unit="kg"), scene.parameter("l", 1.0, unit="m")
    rod = scene.body("rod", mass=m, com=(0, 0, -l / 2), inertia=cd.inertia.rod(m, l, axis="z"))
    scene.joint("theta", cd.Revolute("y"), scene.ground, rod)
    (entry,) = cd.derive(scene).mass_matrix
    assert entry == sp.Rational(1, 3) * sp.Symbol("m") * sp.Symbol("l") ** 2
