"""Energies, rates of rotations, mechanisms and the bicycle come out as books have them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from equations.classical import CLASSICAL
from equations.classical_energies import (
    ENERGIES,
    euler_equations,
    euler_rates,
    quaternion_rates,
    rigid,
)
from equations.slider_crank import Eksergian, Multipliers, by_angles, by_relative_angle
from equations.test_textbook import terms


def check(ours: Iterable[Any], theirs: Iterable[Any], counted: Sequence[int]) -> None:
    """Equal, and with no more terms than were counted in the book."""
    for mine, book, most in zip(ours, theirs, counted, strict=True):
        assert terms(sp.sympify(book)) == most, "the book was counted wrongly"
        assert sp.simplify(mine - book) == 0
        assert terms(mine) <= most


@pytest.mark.parametrize("name", CLASSICAL)
def test_energies(name: str) -> None:
    book = ENERGIES[name]
    kinetic, potential, total = cd.derive(CLASSICAL[name].scene()).written("energy")
    check((kinetic, potential), (book.kinetic, book.potential), book.terms)
    assert sp.expand(total - kinetic - potential) == 0


@pytest.mark.parametrize("rotation", ["quaternion", "ZXZ"])
def test_rigid_body(rotation: str) -> None:
    equations = cd.derive(rigid(rotation))
    check(equations.bias, *euler_equations())
    rates, counted = euler_rates() if rotation == "ZXZ" else quaternion_rates()
    names = ["", "theta", "psi"] if rotation == "ZXZ" else list("wabc")
    own = dict(zip(names, map(sp.Symbol, equations.coordinates), strict=True))
    own |= {axis: sp.Symbol(f"r.u.{axis}") for axis in "xyz"}
    check(equations.kinematics, [sp.sympify(r).subs(own) for r in rates], counted)


def crank(**options: Any) -> cd.Equations:
    return cd.derive(by_angles(), constraints="closed_form", **options)


def test_slider_crank_of_eksergian() -> None:
    book, equations = Eksergian, crank(independent=["theta"])
    assert equations.coordinates == ("theta",)
    for name, theirs, counted in (
        ("mass_matrix", book.mass, book.mass_terms),
        ("bias", book.bias, book.bias_terms),
    ):
        definitions, matrix = equations.named(name)
        assert {symbol for symbol, _ in definitions} <= set(book.definitions)
        check(matrix, [theirs], [counted])
    for symbol, value in definitions:
        assert terms(value) <= book.definition_terms[symbol]
        assert terms(book.definitions[symbol]) == book.definition_terms[symbol]
    compare(definitions, list(book.definitions.items()))


def compare(ours: list[tuple[Any, Any]], theirs: list[tuple[Any, Any]]) -> None:
    """The same numbers for all symbols, at crank angles where the rod is above and below."""
    numbers = {"r": 0.1, "l": 0.3}
    for angle in (-2.4, -0.7, 0.3, 1.2, 2.9):
        values = []
        for definitions in (ours, theirs):
            known = {sp.Symbol("theta"): angle} | {sp.Symbol(k): v for k, v in numbers.items()}
            for symbol, value in definitions:
                known[symbol] = float(value.subs(known))
            values.append([known[symbol] for symbol, _ in theirs])
        np.testing.assert_allclose(values[0], values[1], rtol=1e-12, atol=1e-13)


def test_named_equations_are_those_that_run() -> None:
    equations = crank(independent="theta")
    model = cd.compile(equations)
    for name in ("mass_matrix", "bias"):
        definitions, matrix = equations.named(name)
        known = {sp.Symbol(name): value for name, value in model.parameters.items()}
        known |= {sp.Symbol("theta"): 0.7, sp.Symbol("theta.u"): 1.3}
        for symbol, value in definitions:
            known[symbol] = value.subs(known)
        given = ([0.7],) if name == "mass_matrix" else ([0.7], [1.3])
        expected = np.ravel(getattr(model, name)(*given))
        np.testing.assert_allclose(float(matrix[0].subs(known)), expected[0], rtol=1e-12)


def test_names_are_offered_where_roots_are_too_long() -> None:
    with pytest.raises(cd.DerivationError, match=r"equations\.named\('bias'\), which names"):
        _ = crank(independent=["theta"]).bias
    definitions, matrix = cd.derive(by_relative_angle()).named("mass_matrix")
    assert not definitions
    assert matrix == cd.derive(by_relative_angle()).mass_matrix


def test_who_stays_independent() -> None:
    assert crank().coordinates == ("x",)
    with pytest.raises(
        cd.TopologyError, match=r"joint 'teta' does not exist.*Did you mean 'theta'"
    ):
        crank(independent=["teta"])


def test_slider_crank_with_multipliers() -> None:
    book, equations = Multipliers, cd.derive(by_relative_angle())
    assert equations.coordinates == ("theta", "x", "beta")
    for ours, theirs, counted in (
        (equations.mass_matrix, book.mass_matrix, book.mass_terms),
        (equations.bias, book.bias, book.bias_terms),
        (equations.constraints, book.constraints, book.constraint_terms),
        (equations.constraint_jacobian, book.jacobian, book.jacobian_terms),
        (equations.constraint_bias, book.gamma, book.gamma_terms),
    ):
        check(ours, sp.Matrix(theirs), counted)
