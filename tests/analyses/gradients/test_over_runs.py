"""Gradients of several runs at once."""

from __future__ import annotations

import signal

import numpy as np
import pytest

import cardan as cd


def double_pendulum() -> cd.CompiledModel:
    scene = cd.Scene("double pendulum", gravity=(0, 0, -9.81))
    m1 = scene.parameter("m1", 1.0)
    upper = scene.body("A", mass=m1, com=(0, 0, -0.5), inertia=cd.inertia.rod(m1, 1.0, axis="z"))
    lower = scene.body("B", mass=1.0, com=(0, 0, -0.5), inertia=cd.inertia.rod(1.0, 1.0, axis="z"))
    scene.joint("a", cd.Revolute("y"), scene.ground, upper)
    scene.joint("b", cd.Revolute("y"), upper.at(0, 0, -1), lower)
    scene.force("motor", cd.JointForce("b", scene.input("tau", unit="N*m")))
    return cd.compile(scene)


def test_several_runs_have_the_gradients_of_each() -> None:
    model, cost = double_pendulum(), cd.cost(final="a^2 + b^2", running="b.u^2")
    masses, angles = np.array([0.8, 1.0, 1.3]), np.array([1.0, 0.5, -0.2])
    names = ("m1", "x0", "q0.a")
    found = model.gradient(1.0, cost, wrt=names, vary={"m1": masses, "a": angles}, q={"b": 0.3})
    assert found.value.shape == (3,)
    assert found.slope["x0"].shape == (3, 4)
    assert len(found.motion) == 3
    for k in range(3):
        alone = model.gradient(
            1.0, cost, wrt=names, q={"a": angles[k], "b": 0.3}, parameters={"m1": masses[k]}
        )
        assert found.value[k] == alone.value
        for name in names:
            np.testing.assert_array_equal(found.slope[name][k], alone.slope[name])
    table = (np.array([0.0, 1.0]), np.array([0.5, -0.5]))
    driven = model.gradient(1.0, cost, wrt="tau", vary={"m1": masses}, inputs={"tau": table})
    assert driven.slope["tau"].shape == (3, 2)
    drawn = {"m1": cd.sample.uniform(0.5, 1.5)}
    assert model.gradient(0.1, cost, wrt="m1", vary=drawn, runs=4, seed=1).value.shape == (4,)
    with pytest.raises(cd.CardanError, match=r"'m9'"):
        model.gradient(1.0, cost, wrt=names, vary={"m9": masses})


def test_progress_and_ctrl_c() -> None:
    model, cost, seen = double_pendulum(), cd.cost(final="a^2"), list[float]()
    masses = np.array([0.8, 1.0, 1.3, 1.5])
    options = {"wrt": ("m1", "x0"), "vary": {"m1": masses}}
    whole = model.gradient(0.5, cost, **options, progress=seen.append)
    assert seen == [0.25, 0.5, 0.75, 1.0]

    def second(fraction: float) -> None:
        if fraction == 0.5:
            signal.raise_signal(signal.SIGINT)

    with pytest.warns(cd.SolveWarning, match="interrupted when 2 of 4 runs were done"):
        half = model.gradient(0.5, cost, **options, progress=second)
    assert len(half.motion) == 2
    pairs = [(half.value, whole.value), *((half.slope[n], whole.slope[n]) for n in whole.slope)]
    for part, complete in pairs:
        np.testing.assert_array_equal(part[:2], complete[:2])
        assert np.isnan(part[2:]).all()
        assert part.shape == complete.shape

    def stop(t: float, x: np.ndarray) -> float:
        signal.raise_signal(signal.SIGINT)
        return 1.0

    # nothing is done yet: within the first run, and within a single one
    for more in ({"vary": {"m1": masses}}, {}):
        with pytest.raises(KeyboardInterrupt):
            model.gradient(0.5, cost, wrt="m1", events={"stop": stop}, **more)


def test_times_of_rows_are_refused() -> None:
    """A cost is one of the end and of the entire way: rows at other times are no steps."""
    for more in ({}, {"vary": {"m1": [1.0, 1.1]}}):
        with pytest.raises(cd.ArgumentError, match=r"t has 11 times: give the end"):
            double_pendulum().gradient(np.linspace(0, 1, 11), cd.cost(final="a"), wrt="m1", **more)
