"""Gradients by starts of loops that what was named leaves free to move."""

from __future__ import annotations

from typing import Any

import pytest

import cardan as cd
from table import each


def four_bar() -> cd.CompiledModel:
    scene = cd.Scene("four-bar", gravity=(0, -9.81, 0))
    length = scene.parameter("length", 0.8)
    crank, coupler, rocker = (
        scene.body(name, mass=1.0, com=(size / 2, 0, 0), inertia=cd.inertia.rod(1.0, 0.5))
        for name, size in (("crank", 0.3), ("coupler", length), ("rocker", 0.6))
    )
    scene.joint("A", cd.Revolute("z"), scene.ground, crank, q0=0.3)
    scene.joint("B", cd.Revolute("z"), crank.at(0.3, 0, 0), coupler)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(0.9, 0, 0), rocker)
    scene.joint("C", cd.Revolute("z"), coupler.at(length, 0, 0), rocker.at(0.6, 0, 0), cut=True)
    return cd.compile(scene)


@each("given", [{}, {"u": {"A": 1.0}}, {"q": {"A": 0.8}}])
def test_what_nobody_named_begins_next_to_the_scene(given: dict[str, Any]) -> None:
    """Against differences of the cost: which of many starts it is depends on distances."""
    model, cost = four_bar(), cd.cost(final="A", running="B^2")

    def run(wrt: tuple[str, ...], length: float) -> Any:
        how = {"rtol": 1e-12, "parameters": {"length": length}}
        return model.gradient(0.3, cost, wrt=wrt, **how, **given)

    found = run(("length", "u0.A"), 0.8).slope["length"]
    near, far = (
        (run(("u0.A",), 0.8 + h).value - run(("u0.A",), 0.8 - h).value) / (2 * h)
        for h in (1e-3, 2e-3)
    )
    # the nearest position is found to about 1e-9, which differences magnify
    assert found == pytest.approx((4 * near - far) / 3, rel=1e-5)


def test_a_start_that_was_given_as_a_whole() -> None:
    """Its state moves along the loops: by coordinate A all others follow."""
    model, cost = four_bar(), cd.cost(final="A", running="B^2")
    x0 = model.initial(q={"A": 0.8}, u={"A": 1.0})
    whole = model.gradient(0.3, cost, wrt="x0", x0=x0, rtol=1e-12).slope["x0"]
    named = model.gradient(
        0.3, cost, wrt=("q0.A", "u0.A"), q={"A": 0.8}, u={"A": 1.0}, rtol=1e-12
    ).slope
    ahead, behind = (model.initial(q={"A": 0.8 + h}, u={"A": 1.0}) for h in (1e-4, -1e-4))
    assert (ahead - behind) / 2e-4 @ whole == pytest.approx(named["q0.A"], rel=1e-7)
    faster = model.initial(q={"A": 0.8}, u={"A": 2.0}) - x0
    assert faster @ whole == pytest.approx(named["u0.A"], rel=1e-9)
