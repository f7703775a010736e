"""Energies, rates of rotations, mechanisms and the bicycle come out as books have them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from equations import whipple
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


def test_rolling_disk() -> None:
    # Neimark and Fufaev, chapter 2: the point of contact runs along the heading as the disk spins
    scene = cd.Scene("coin", gravity=(0, 0, -9.81))
    r = scene.parameter("r", 0.5, unit="m")
    coin = scene.body("coin", mass=1.0, inertia=(1.0, 2.0, 1.0))
    scene.joint("roll", cd.RollingDisk(r), scene.ground, coin)
    yaw = sp.Symbol("roll.yaw")
    along, across = (sp.cos(yaw), sp.sin(yaw)), (-sp.sin(yaw), sp.cos(yaw))
    book = [*along, 0, 0, -r, *across, 0, 0, 0]
    check(cd.derive(scene).constraint_jacobian, book, [1, 1, 0, 0, 1, 1, 1, 0, 0, 0])


def test_whipple_bicycle() -> None:
    v, g, rR, rF = sp.symbols("v g rR rF")
    straight = {"wheel.u.x": v, "wheel.u.spin": v / rR, "hub.u": -v / rR, "axle.u": v / rF}
    linear = cd.derive(whipple.scene()).linearize(u=straight)
    found = linear.second_order(["wheel.lean", "steer"])
    book = whipple.Paper
    stiffness = g * sp.Matrix(book.K0) + v**2 * sp.Matrix(book.K2)
    stiffness_terms = np.add(book.K0_terms, book.K2_terms)
    random = np.random.default_rng(3)
    for ours, theirs, counted in (
        (found.M, sp.Matrix(book.M), book.M_terms),
        (found.damping, v * sp.Matrix(book.C1), book.C1_terms),
        (found.K, stiffness, stiffness_terms),
    ):
        assert [terms(sp.expand(in_waves(entry))) for entry in theirs] == list(counted)
        assert all(terms(a) <= n for a, n in zip(ours, counted, strict=True))
        for _ in range(5):
            values = {s: sp.Float(str(x), 40) for s, x in draw(ours, theirs, random)}
            difference = (ours - theirs).subs(values).evalf(40)
            assert max(map(abs, difference)) < 1e-33


def draw(a: sp.Matrix, b: sp.Matrix, random: np.random.Generator) -> list[tuple[Any, float]]:
    symbols = sorted(a.free_symbols | b.free_symbols, key=str)
    return list(zip(symbols, random.uniform(0.5, 1.5, len(symbols)), strict=True))


def in_waves(entry: Any) -> Any:
    """An entry of the paper without denominators but those of lengths: those of masses cancel."""
    waves = dict(zip((whipple.Paper.sine, whipple.Paper.cosine), sp.symbols("s c_"), strict=True))
    return sp.cancel(sp.together(sp.sympify(entry).subs(waves)))
