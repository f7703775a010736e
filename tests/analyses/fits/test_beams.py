"""Fits in absolute coordinates: beams, and mechanisms beside those in joint coordinates."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd

TIMES = np.linspace(0.0, 0.6, 61)
TRUTH = {"E": 4e6, "eta": 2e-3}
STENCIL = {-2: 1 / 12, -1: -2 / 3, 1: 2 / 3, 2: -1 / 12}


def rubber(elements: int = 1) -> cd.CompiledModel:
    """A rubber bar on a hinge with a spring, let go: its tip is measured."""
    scene = cd.Scene("rubber", gravity=(0, 0, -9.81))
    E, eta = scene.parameter("E", 4e6, unit="Pa"), scene.parameter("eta", 2e-3, unit="s")
    material = cd.material(E=E, nu=0.45, rho=1100, damping=eta)
    hub = scene.body("hub", mass=0.2, inertia=(0.002, 0.002, 0.002))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    scene.force("spring", cd.JointSpring("hinge", stiffness=scene.parameter("k", 8.0)))
    square = cd.section.rectangle(0.03, 0.02)
    bar = scene.beam("bar", hub, (0.4, 0, 0), square, material, elements=elements)
    scene.output("tip_x", bar.end.position()[0])
    scene.output("tip_z", bar.end.position()[2])
    return cd.compile(scene)


@pytest.fixture(scope="module")
def bar() -> cd.CompiledModel:
    return rubber()


def outputs(model: cd.CompiledModel, start: float, **parameters: float) -> np.ndarray:
    """Tip positions (nt, 2) of a run by itself."""
    motion = model.simulate(
        TIMES, q={"hinge": start}, parameters=parameters, rtol=1e-11, method="DOP853"
    )
    return np.stack([motion["tip_x"], motion["tip_z"]], axis=1)


def test_modulus_and_damping_of_rubber(bar: cd.CompiledModel) -> None:
    """From 30 % off to the truth; standard errors are those of differences of runs."""
    noise = 2e-4
    exact = outputs(bar, 0.3, **TRUTH)
    measured = exact + noise * np.random.default_rng(3).standard_normal(exact.shape)
    data = {"t": TIMES, "tip_x": measured[:, 0], "tip_z": measured[:, 1]}
    found = bar.fit(
        data, unknown=("E", "eta", "q0.hinge"), q={"hinge": 0.35},
        parameters={"E": 5.2e6, "eta": 1.4e-3}, noise=noise, method="DOP853",
    )  # fmt: skip
    assert found.converged
    # from there a single run is off the measurements soon
    assert found.segments > 1
    truth = {**TRUTH, "q0.hinge": 0.3}
    # of a normal law one in 15,000 is that far off
    for name, value in truth.items():
        assert abs(found.values[name] - value) < 4 * found.standard_errors[name], name
    assert found.standard_errors["E"] < 0.01 * TRUTH["E"]
    assert found.sigma == pytest.approx(1.0, abs=0.2)  # of noise; 122 samples tell it to 0.064
    # J by differences of fourth order of runs that no sweep is in
    at = dict(found.values)
    columns = []
    for name, value in at.items():
        h = 1e-3 * abs(value)
        total = np.zeros_like(exact)
        for side, weight in STENCIL.items():
            moved = at | {name: value + side * h}
            total += weight / h * outputs(bar, moved.pop("q0.hinge"), **moved)
        columns.append(total.ravel() / noise)
    J = np.stack(columns, axis=1)
    sizes = np.array(list(at.values()))
    covariance = (
        found.sigma**2 * np.linalg.inv((J * sizes).T @ (J * sizes)) * np.outer(sizes, sizes)
    )
    expected = dict(zip(at, np.sqrt(np.diag(covariance)), strict=True))
    for name in at:
        assert found.standard_errors[name] == pytest.approx(expected[name], rel=1e-4), name
    # the minimum does not depend on segments; steps end at 1e-10 of the unknowns
    one = bar.fit(
        data, unknown=tuple(at), q={"hinge": at["q0.hinge"]}, noise=noise, method="DOP853",
        parameters={"E": at["E"], "eta": at["eta"]}, segments=1,
    )  # fmt: skip
    for name, error in found.standard_errors.items():
        assert one.values[name] == pytest.approx(found.values[name], rel=1e-6), name
        assert one.standard_errors[name] == pytest.approx(error, rel=1e-6), name


def test_exact_measurements_give_the_truth(bar: cd.CompiledModel) -> None:
    exact = outputs(bar, 0.3, **TRUTH)
    data = {"t": TIMES, "tip_x": exact[:, 0], "tip_z": exact[:, 1]}
    found = bar.fit(
        data, unknown=("E", "eta", "k"), q={"hinge": 0.3},
        parameters={"E": 3.4e6, "eta": 2.5e-3, "k": 8.8}, rtol=1e-11, method="DOP853",
    )  # fmt: skip
    assert found.converged
    for name, value in {**TRUTH, "k": 8.0}.items():
        assert found.parameters[name] == pytest.approx(value, rel=1e-6)


def pendulum(coordinates: str) -> Any:
    scene = cd.Scene("double", gravity=(0, 0, -9.81))
    m = scene.parameter("m", 1.0)
    upper = scene.body("upper", mass=m, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.05))
    lower = scene.body("lower", mass=0.7, com=(0, 0, -0.4), inertia=(0.1, 0.1, 0.05))
    scene.joint("a", cd.Revolute("y"), scene.ground, upper)
    scene.joint("b", cd.Revolute("y"), upper.at(0, 0, -1), lower)
    scene.force("damper", cd.JointDamper("a", damping=scene.parameter("c", 0.3)))
    return cd.compile(scene, coordinates=coordinates)


def four_bar(coordinates: str) -> Any:
    scene = cd.Scene("four_bar", gravity=(0, 0, -9.81))
    m = scene.parameter("m", 1.0)
    bodies = {name: scene.body(name, mass=1.0, inertia=(0.1, 0.1, 0.1)) for name in "bc"}
    crank = scene.body("crank", mass=m, com=(0.5, 0, 0), inertia=(0.1, 0.1, 0.1))
    b, c = bodies.values()
    scene.joint("a", cd.Revolute("y"), scene.ground, crank)
    scene.joint("elbow", cd.Revolute("y"), crank.at(1, 0, 0), b)
    scene.joint("rocker", cd.Revolute("y"), scene.ground.at(2.5, 0, 0), c)
    scene.joint("pin", cd.Revolute("y"), b.at(2.2, 0, 0), c.at(0, 0, 2))
    scene.force("damper", cd.JointDamper("a", damping=scene.parameter("c", 0.5)))
    return cd.compile(scene, coordinates=coordinates)


@pytest.mark.parametrize("build", [pendulum, pytest.param(four_bar, marks=pytest.mark.slow)])
def test_absolute_and_joint_coordinates_have_the_same_fit(build: Any) -> None:
    times = np.linspace(0, 1, 41)
    models = [build(kind) for kind in ("relative", "absolute")]
    motion = models[0].simulate(times, q={"a": 0.4}, parameters={"m": 1.2, "c": 0.4}, rtol=1e-10)
    noise = 1e-3 * np.random.default_rng(1).standard_normal(41)
    data = {"t": times, "a": motion["a"] + noise}
    names = ("m", "c", "q0.a", "u0.a")
    first, other = (
        model.fit(data, unknown=names, q={"a": 0.5}, segments=1, method="DOP853", rtol=1e-10)
        for model in models
    )
    assert first.converged
    assert other.converged
    for name in first.values:
        # the data tell what they tell: both searches end within a small part of the errors
        error = first.standard_errors[name]
        assert abs(other.values[name] - first.values[name]) < 1e-3 * error, name
        assert other.standard_errors[name] == pytest.approx(error, rel=1e-4), name


def test_what_is_refused(bar: cd.CompiledModel) -> None:
    data = {"t": TIMES, "tip_z": np.sin(TIMES)}
    for more, match in (
        ({"unknown": ("E", "q0")}, r"'q0': .*Name what is free, such as 'q0\.hinge'"),
        ({"segments": 61}, r"segments=61: give 'auto' or a number from 1 to 60"),
        ({"q": np.zeros(bar.nq)}, r"give the start by names of joints"),
        ({"q": {"hing": 0.1}}, r"Did you mean 'hinge'"),
        ({"inputs": {"wind": 1.0}}, r"wind"),
    ):
        with pytest.raises(cd.CardanError, match=match):
            bar.fit(data, **{"unknown": "E", "q": {"hinge": 0.1}} | more)
