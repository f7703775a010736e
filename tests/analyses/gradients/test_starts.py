"""Gradients by starts of loops, against differences of values and against each other."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from laws.circuits import compiled
from laws.circuits import start as closed_start
from table import each


def four_bar(coordinates: str = "auto", q0: float = 0.3) -> cd.CompiledModel:
    scene = cd.Scene("four-bar", gravity=(0, -9.81, 0))
    length = scene.parameter("length", 0.8)
    crank, coupler, rocker = (
        scene.body(name, mass=1.0, com=(size / 2, 0, 0), inertia=cd.inertia.rod(1.0, 0.5))
        for name, size in (("crank", 0.3), ("coupler", length), ("rocker", 0.6))
    )
    scene.joint("A", cd.Revolute("z"), scene.ground, crank, q0=q0)
    scene.joint("B", cd.Revolute("z"), crank.at(0.3, 0, 0), coupler)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(0.9, 0, 0), rocker)
    scene.joint("C", cd.Revolute("z"), coupler.at(length, 0, 0), rocker.at(0.6, 0, 0), cut=True)
    return cd.compile(scene, coordinates=coordinates)


def slider_crank(coordinates: str, size: float) -> cd.CompiledModel:
    """A crank of some size whose slide is off its center by a parameter that is 0."""
    scene = cd.Scene("slider", gravity=(0, -9.81, 0))
    off = scene.parameter("off", 0.0, unit="m")
    crank, rod = (
        scene.body(n, mass=1.0, com=(k * size / 2, 0, 0), inertia=cd.inertia.rod(1.0, k * size))
        for n, k in (("crank", 1), ("rod", 3))
    )
    slider = scene.body("slider", mass=1.0)
    scene.joint("A", cd.Revolute("z"), scene.ground, crank, q0=0.5)
    scene.joint("B", cd.Revolute("z"), crank.at(size, 0, 0), rod)
    scene.joint("S", cd.Prismatic("x"), scene.ground.at(0, off, 0), slider)
    scene.joint("C", cd.Revolute("z"), rod.at(3 * size, 0, 0), slider, cut=True)
    return cd.compile(scene, coordinates=coordinates)


def judge(
    model: cd.CompiledModel, names: dict[str, float], within: float = 1e-6, **given: Any
) -> None:
    """By names of coordinates that were named, and of parameters, with steps of differences."""
    span, cost = 0.02, cd.cost(final="A", running="A^2")

    def value(name: str, by: float) -> float:
        changed = dict(given)
        if name.startswith("q0."):
            changed["q"] = {**given["q"], name[3:]: given["q"][name[3:]] + by}
        else:
            changed["parameters"] = {name: model.parameters[name] + by}
        return model.gradient(span, cost, wrt="u0", method="DOP853", rtol=1e-11, **changed).value

    how = {"method": "DOP853", "rtol": 1e-11}
    found = model.gradient(span, cost, wrt=tuple(names), **how, **given)
    for name, h in names.items():
        near, far = ((value(name, x) - value(name, -x)) / (2 * x) for x in (h, 2 * h))
        assert found.slope[name] == pytest.approx((4 * near - far) / 3, rel=within), name


@each("coordinates", ["auto", "absolute"])
def test_named_coordinates_move_the_others(coordinates: str) -> None:
    model = four_bar(coordinates)
    judge(model, {"q0.A": 1e-3, "length": 1e-3}, q={"A": 0.8})
    # next to the limit of the rocker, which it reaches at 1.534
    judge(model, {"q0.D": 1e-4, "length": 1e-4}, 1e-5, q={"D": 1.565})
    small = slider_crank(coordinates, 0.01)
    judge(small, {"q0.S": 1e-5, "off": 1e-5}, 1e-5, q={"S": 0.034})
    judge(slider_crank(coordinates, 1.0), {"q0.S": 1e-3, "off": 1e-3}, q={"S": 3.4})


def test_one_entry_of_a_joint_is_named() -> None:
    """Speeds are left to the loop, and so is the rest of the joint."""
    model = compiled("cam")
    at = model.parts_of(np.concatenate([*closed_start(model, "cam", 0.3), np.zeros(model.nz)]))[0]
    start = float(at[model.coordinates.index("edge.s")])
    cost = cd.cost(final="edge.s + 0.3*post.a")

    def value(h: float) -> float:
        found = model.gradient(0.1, cost, wrt="u0", rtol=1e-11, q={"edge.s": start + h})
        return float(found.value)

    found = model.gradient(0.1, cost, wrt="q0", rtol=1e-11, q={"edge.s": start}).slope["q0"]
    place = model.speeds.index("edge.u.s")
    near, far = ((value(h) - value(-h)) / (2 * h) for h in (1e-3, 2e-3))
    assert found[place] == pytest.approx((4 * near - far) / 3, rel=1e-6)


@each("given", [{}, {"u": {"A": 1.0}}])
def test_what_nobody_named_begins_next_to_the_scene(given: dict[str, Any]) -> None:
    """Against differences of the cost: which of many starts it is depends on distances."""
    # the nearest position is found to about 1e-9, which differences magnify
    judge(four_bar(), {"length": 5e-3}, 1e-5, **given)


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
    # and entry by entry: coordinates by the shortest way in sizes of the scene, speeds by impulses
    for k, unit in enumerate(np.eye(model.nx)):
        near, far = (
            (
                model.gradient(0.3, cost, wrt="x0", x0=x0 + h * unit, rtol=1e-12).value
                - model.gradient(0.3, cost, wrt="x0", x0=x0 - h * unit, rtol=1e-12).value
            )
            / (2 * h)
            for h in (1e-5, 2e-5)
        )
        assert whole[k] == pytest.approx((4 * near - far) / 3, abs=1e-6 * np.abs(whole).max())
