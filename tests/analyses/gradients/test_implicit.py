"""Gradients of stiff motions, by implicit methods."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import cardan as cd
from table import each


@each("method", ["GeneralizedAlpha", "HHT", "EnergyMidpoint"])
def test_errors_of_gradients_are_those_of_motions(method: str) -> None:
    """Of methods of order 2: a quarter of both with half of the step. Against the closed form."""
    scene = cd.Scene("spring")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    scene.force("spring", cd.JointSpring("x", stiffness=scene.parameter("k", 9.0)))
    model, cost = cd.compile(scene), cd.cost(final="x")
    errors = []
    for step in (2e-3, 1e-3):
        found = model.gradient(2.0, cost, wrt=("k", "q0.x"), q={"x": 1.0}, method=method, step=step)
        errors.append(
            [
                found.value - np.cos(6.0),
                found.slope["k"] + np.sin(6.0) / 3.0,
                found.slope["q0.x"] - np.cos(6.0),
            ]
        )
    first, second = np.abs(errors)
    assert first[0] / second[0] == pytest.approx(4.0, rel=0.05)
    assert (second[1:] <= second[0]).all()


def test_stiff_motions_by_radau() -> None:
    """A damper whose force dies out in 0.1 ms, against the closed form by complex step."""
    scene = cd.Scene("damped")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    c, k = scene.parameter("c", 1e4), scene.parameter("k", 400.0)
    scene.force("spring", cd.JointSpring("x", stiffness=k, damping=c))
    cost = cd.cost(final="x + 3*x.u", running="x^2")
    given = {"q": {"x": 1.0}, "rtol": 1e-10, "atol": 1e-13, "method": "Radau"}
    found = cd.compile(scene).gradient(20.0, cost, wrt=("c", "k", "q0.x"), **given)

    def value(c: complex, k: complex, start: complex) -> complex:
        root = np.sqrt(c * c - 4 * k)
        slow, fast = -2 * k / (c + root), -(c + root) / 2
        a, b = start * fast / (fast - slow), -start * slow / (fast - slow)
        end = sum(w * (1 + 3 * r) * np.exp(20 * r) for w, r in ((a, slow), (b, fast)))
        pairs = ((a * a, 2 * slow), (2 * a * b, slow + fast), (b * b, 2 * fast))
        return end + sum(w * np.expm1(20 * r) / r for w, r in pairs)

    assert found.value == pytest.approx(value(1e4, 400.0, 1.0).real, rel=1e-10)
    for n, name in enumerate(("c", "k", "q0.x")):
        at = np.array([1e4, 400.0, 1.0]) + 1e-30j * np.eye(3)[n]
        assert found.slope[name] == pytest.approx(value(*at).imag / 1e-30, rel=1e-9), name
    assert len(found.motion.t) < 500


def four_bar() -> cd.CompiledModel:
    scene = cd.Scene("four-bar", gravity=(0, -9.81, 0))
    crank, coupler, rocker = (
        scene.body(name, mass=1.0, com=(size / 2, 0, 0), inertia=cd.inertia.rod(1.0, 0.5))
        for name, size in (("crank", 0.3), ("coupler", 0.8), ("rocker", 0.6))
    )
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("B", cd.Revolute("z"), crank.at(0.3, 0, 0), coupler)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(0.9, 0, 0), rocker)
    scene.joint("C", cd.Revolute("z"), coupler.at(0.8, 0, 0), rocker.at(0.6, 0, 0), cut=True)
    return cd.compile(scene)


def flexible_crank() -> cd.CompiledModel:
    """A crank that moves a slider by a rod of rubber, which closes a loop."""
    scene = cd.Scene("flexible_crank", gravity=(0, 0, -9.81))
    rubber = cd.material(E=5e7, nu=0.45, rho=1100)
    inertia = cd.inertia.rod(1.0, 0.2, axis="x")
    crank = scene.body("crank", mass=1.0, com=(0.1, 0, 0), inertia=inertia)
    section = cd.section.rectangle(0.02, 0.02)
    rod = scene.beam("rod", (0.2, 0, 0), (0.7, 0, 0), section, rubber, elements=2)
    slider = scene.body("slider", mass=0.5)
    scene.joint("A", cd.Revolute("y"), scene.ground, crank)
    scene.joint("B", cd.Revolute("y"), crank.at(0.2, 0, 0), rod.start)
    scene.joint("S", cd.Prismatic("x"), scene.ground.at(0.7, 0, 0), slider)
    scene.joint("C", cd.Revolute("y"), rod.end, slider, cut=True)
    return cd.compile(scene)


# method, model, how far its gradients are from those of a tight motion by DOP853
CASES = [
    ("Radau", four_bar, {"rtol": 1e-10}, 1e-8),
    ("GeneralizedAlpha", four_bar, {"step": 1e-4}, 1e-5),
    ("Radau", flexible_crank, {"rtol": 1e-7}, 1e-4),
    ("GeneralizedAlpha", flexible_crank, {"rtol": 1e-8}, 1e-2),
]


@each("method, make, how, error", CASES)
def test_loops_and_beams(
    method: str, make: Callable[[], cd.CompiledModel], how: dict[str, Any], error: float
) -> None:
    """Another method with another derivative of its steps; forward and backward are the same."""
    model, names = make(), ("u0.A", "crank.mass", "gravity.y")
    if make is flexible_crank:
        names = ("u0.A", "crank.mass", "gravity.z", "rod.material.E", "rod.section.height")
    given: dict[str, Any] = {"q": {"A": 0.7}, "u": {"A": 3.0}}
    cost = cd.cost(final="A", running="A.u^2")
    tight = model.gradient(0.1, cost, wrt=names, method="DOP853", rtol=1e-11, **given)
    found = model.gradient(0.1, cost, wrt=names, method=method, **how, **given)
    final = model.gradient(0.1, cd.cost(final="A"), wrt=names, method=method, **how, **given)
    motion = model.simulate(0.1, sensitivity=names, method=method, **how, **given)
    place = model.coordinates.index("A")
    for name in names:
        assert found.slope[name] == pytest.approx(tight.slope[name], rel=error), name
        forward = motion.sensitivity[name][-1, place]
        assert forward == pytest.approx(final.slope[name], rel=1e-9, abs=1e-16), name
