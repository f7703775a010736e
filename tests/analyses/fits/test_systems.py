"""Fits of loops, of what bounces, of rotations in space and of stiff models."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import least_squares

import cardan as cd
from cardan.analyses.fits import shooting
from cardan.errors import ArgumentError, ModelError, SolveError

TIGHT = {"rtol": 1e-12, "atol": 1e-14, "method": "DOP853"}


def noisy(values: np.ndarray, size: float, seed: int) -> np.ndarray:
    return values + size * np.random.default_rng(seed).standard_normal(values.shape)


def test_a_closed_loop_against_single_shooting_by_differences() -> None:
    """A four-bar by a length, a mass and its first angle; the other angles follow from the loop."""
    model = cd.compile(cd.examples["four_bar"])
    t, names = np.linspace(0, 2, 81), ("B.position.x", "crank.mass")
    true = np.array([1.02 * model.parameters["B.position.x"], 1.3 * model.parameters["crank.mass"]])

    def angles(unknown: np.ndarray) -> np.ndarray:
        values = dict(zip(names, unknown[1:], strict=True))
        return model.simulate(t, q={"A": unknown[0]}, parameters=values, **TIGHT).q

    seen = noisy(angles(np.array([0.8, *true])), 1e-3, 1)
    data = {"t": t, "A": seen[:, 0], "D": seen[:, 2]}
    found = model.fit(data, unknown=(*names, "q0.A"), rtol=1e-12)
    assert found.converged

    def misfit(unknown: np.ndarray) -> np.ndarray:
        return (angles(unknown) - seen)[:, [0, 2]].ravel()

    answer = [found.values[name] for name in ("q0.A", *names)]
    beside = np.array(answer) * (1 + 1e-3)
    other = least_squares(misfit, beside, x_scale=beside, jac="3-point", xtol=1e-14, ftol=1e-14)
    np.testing.assert_allclose(answer, other.x, rtol=1e-6)
    variance = 2 * other.cost / found.freedom
    errors = np.sqrt(np.diag(np.linalg.inv(other.jac.T @ other.jac)) * variance)
    ours = [found.standard_errors[name] for name in ("q0.A", *names)]
    np.testing.assert_allclose(ours, errors, rtol=1e-3)
    # the start is closed with the lengths that were found
    q, _ = found.model.split(found.start)
    assert np.abs(found.model.constraints(q)).max() < 1e-10
    with pytest.raises(ModelError, match=r"'x0': loops determine most of it.*'q0\.A'"):
        model.fit(data, unknown="x0")


def test_impacts_and_stiff_models() -> None:
    """Restitution of a ball that bounces; a stiffness by a method for stiff models."""
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    e = scene.parameter("e", 0.7)
    scene.joint("z", cd.Prismatic("z"), scene.ground, scene.body("ball", mass=1.0))
    scene.force("floor", cd.Stop("z", lower=0.0, restitution=e))
    model, t = cd.compile(scene), np.linspace(0, 2, 101)
    z = model.simulate(t, q={"z": 1.0}, parameters={"e": 0.8}, **TIGHT)["z"]
    found = model.fit({"t": t, "z": noisy(z, 1e-3, 2)}, unknown=("e", "q0"))
    for name, value in (("e", 0.8), ("q0.z", 1.0)):
        low, high = found.interval(name, 0.999)
        assert low <= value <= high
        assert high - low < 0.01
    scene = cd.Scene("stiff")
    k, d = scene.parameter("k", 1e4), scene.parameter("d", 2e3)
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    scene.force("spring", cd.JointSpring("x", k))
    scene.force("damper", cd.JointDamper("x", d))
    model, t = cd.compile(scene), np.linspace(0, 0.5, 51)
    # slow part of the decay: x = exp(-k/d t) to 0.3 %
    rates = np.roots([1.0, 2e3, 1e4])
    weights = np.linalg.solve([[1, 1], rates], [1.0, 0.0])
    x = np.exp(np.outer(t, rates)) @ weights
    found = model.fit(
        {"t": t, "x": x}, unknown="k", q={"x": 1.0}, parameters={"k": 5e3}, method="Radau"
    )
    assert found.parameters["k"] == pytest.approx(1e4, rel=1e-6)


def test_a_ball_joint_from_positions() -> None:
    """Length and first speeds of a spherical pendulum; its angles have no numbers of their own."""
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    length = scene.parameter("L", 1.0)
    bob = scene.body("bob", mass=1.0, com=(0, 0, -length), inertia=(0.4, 0.3, 0.2))
    scene.joint("ball", cd.Spherical(), scene.ground, bob)
    for k, axis in enumerate("xyz"):
        scene.output(axis, bob.at(0.2, 0, -length).position()[k])
    model, t = cd.compile(scene), np.linspace(0, 2, 81)
    start = {"q": {"ball": [np.cos(0.4), np.sin(0.4), 0, 0]}, "u": {"ball": [0.5, 1.0, 0.3]}}
    truth = model.simulate(t, parameters={"L": 1.2}, **start, **TIGHT)
    data = {"t": t} | {axis: noisy(truth[axis], 1e-4, k) for k, axis in enumerate("xyz")}
    found = model.fit(data, unknown=("L", "x0"), q=start["q"], u=start["u"])
    assert found.converged
    assert found.values["L"] == pytest.approx(1.2, abs=5 * found.standard_errors["L"])
    for axis, value in zip("xyz", (0.5, 1.0, 0.3), strict=True):
        name = f"ball.u.{axis}"
        assert found.values[f"u0.{name}"] == pytest.approx(
            value, abs=5 * found.standard_errors[f"u0.{name}"]
        )
        assert np.isnan(found.values[f"q0 along {name}"])
        assert 0 < found.standard_errors[f"q0 along {name}"] < 1e-3
    assert found.start[:4] @ found.start[:4] == pytest.approx(1.0, abs=1e-12)
    assert "nan" not in str(found)


def test_parameters_without_sense_do_not_fill_the_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = cd.Scene("spring", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    scene.force("spring", cd.JointSpring("x", stiffness=scene.parameter("k", 5e9)))
    t = np.linspace(0, 10, 51)
    data = {"t": t, "x": np.cos(np.sqrt(5) * t)}
    monkeypatch.setattr(shooting, "MOST_STEPS", 2000)
    with pytest.raises(SolveError, match=r"more than 2,000 steps .*bounds="):
        cd.compile(scene).fit(data, unknown="k", q={"x": 1.0}, u={"x": 0.0})


def pendulum_data() -> tuple[cd.CompiledModel, np.ndarray, np.ndarray]:
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    length = scene.parameter("L", 1.2)
    bar = scene.body("bar", mass=1.0, com=(0, 0, -length / 2), inertia=(0.1, 0.1, 0.01))
    scene.joint("h", cd.Revolute("y"), scene.ground, bar)
    model, t = cd.compile(scene), np.linspace(0, 2, 41)
    return model, t, model.simulate(t, q={"h": 1.0}, parameters={"L": 1.0})["h"]


def test_what_a_bound_holds_is_not_known_exactly() -> None:
    model, t, h = pendulum_data()
    found = model.fit({"t": t, "h": h}, unknown=("L", "q0.h"), bounds={"L": (1.1, 2.0)})
    assert found.at_bounds == ("L",)
    assert found.values["L"] == 1.1
    assert found.standard_errors["L"] == np.inf
    assert "L is held by its bound" in repr(found)


def test_samples_are_more_than_unknowns_and_in_units_of_the_model() -> None:
    model, t, h = pendulum_data()
    with pytest.raises(ArgumentError, match="2 samples cannot determine 3 unknowns"):
        model.fit({"t": t[:2], "h": h[:2]}, unknown=("L", "q0.h", "u0.h"))
    with pytest.raises(ArgumentError, match=r"'t \[ms\]': 't' is in s"):
        model.fit({"t [ms]": 1e3 * t, "h": h}, unknown="L")
    with pytest.raises(ArgumentError, match=r"'angle \[deg\]': 'angle' is in rad"):
        model.fit({"t": t, "angle [deg]": h}, unknown="L", measured={"h": "angle"})
    found = model.fit({"t [s]": t, "h [rad]": h}, unknown="L", q={"h": 1.0})
    assert found.values["L"] == pytest.approx(1.0, rel=1e-6)
    with pytest.raises(ModelError, match="'elbow'"):
        model.fit({"t": t, "h": h}, unknown="L", q={"elbow": 1.0})
