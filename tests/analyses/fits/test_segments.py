"""Segments of motions in absolute coordinates, beside joint coordinates and differences of runs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.analyses.fits.samples import samples_of
from cardan.analyses.fits.shooting import Shooting, Trial
from cardan.errors import SolveWarning

TRUTH = {"m2": 1.3, "l1": 0.9, "l2": 1.2}


def double_pendulum(coordinates: str) -> Any:
    scene = cd.Scene("double pendulum", gravity=(0, 0, -9.81))
    m2, l1, l2 = (scene.parameter(name, 1.0) for name in ("m2", "l1", "l2"))
    upper = scene.body("A", mass=1, com=(0, 0, -l1 / 2), inertia=cd.inertia.rod(1, l1, axis="z"))
    lower = scene.body("B", mass=m2, com=(0, 0, -l2 / 2), inertia=cd.inertia.rod(m2, l2, axis="z"))
    scene.joint("a", cd.Revolute("y"), scene.ground, upper)
    scene.joint("b", cd.Revolute("y"), upper.at(0, 0, -l1), lower)
    return cd.compile(scene, coordinates=coordinates)


@pytest.mark.slow
def test_a_chaotic_pendulum_from_far_off() -> None:
    """From 1.4 times the truth: several segments find it in both coordinates, one run does not."""
    models = [double_pendulum(kind) for kind in ("relative", "absolute")]
    t = np.linspace(0, 3, 61)
    motion = models[0].simulate(
        t, q={"a": 2.0, "b": 1.0}, parameters=TRUTH, rtol=1e-12, method="DOP853"
    )
    noise = 0.01 * np.random.default_rng(5).standard_normal((61, 2))
    data = {"t": t} | {name: motion[name] + noise[:, k] for k, name in enumerate("ab")}

    def fitted(model: Any, segments: str | int, most: int = 60) -> Any:
        return model.fit(
            data, unknown=(*TRUTH, "q0.a", "q0.b", "u0.a", "u0.b"), q={"a": 2.0, "b": 1.0},
            parameters={name: 1.4 * value for name, value in TRUTH.items()}, segments=segments,
            method="DOP853", rtol=1e-9, most=most,
        )  # fmt: skip

    first, other = (fitted(model, "auto") for model in models)
    for one in (first, other):
        assert one.converged
        assert one.segments > 3
        for name, value in TRUTH.items():
            # of a normal law one in 15,000 is that far off
            assert abs(one.parameters[name] - value) < 4 * one.standard_errors[name], name
    sizes = np.sqrt(np.diag(first.covariance))
    for name, size in zip(first.names, sizes, strict=True):
        # searches end where steps are 1e-10 of the unknowns
        assert abs(other.values[name] - first.values[name]) < 1e-5 * size, name
    np.testing.assert_allclose(
        other.covariance / np.outer(sizes, sizes),
        first.covariance / np.outer(sizes, sizes),
        atol=1e-5,
    )
    with pytest.warns(SolveWarning):
        one = fitted(models[1], 1, most=other.iterations)
    assert one.cost > 1e3 * other.cost


def four_bar() -> Any:
    scene = cd.Scene("four_bar", gravity=(0, 0, -9.81))
    length = scene.parameter("length", 2.2)
    crank = scene.body("crank", mass=1.0, com=(0.5, 0, 0), inertia=(0.1, 0.1, 0.1))
    b, c = (scene.body(name, mass=1.0, inertia=(0.1, 0.1, 0.1)) for name in "bc")
    scene.joint("a", cd.Revolute("y"), scene.ground, crank)
    scene.joint("elbow", cd.Revolute("y"), crank.at(1, 0, 0), b)
    scene.joint("rocker", cd.Revolute("y"), scene.ground.at(2.5, 0, 0), c)
    scene.joint("pin", cd.Revolute("y"), b.at(length, 0, 0), c.at(0, 0, 2))
    return cd.compile(scene, coordinates="absolute")


def test_a_segment_changes_as_differences_of_runs_do() -> None:
    """Along increments of a node, those too that constraints do not allow, and a length."""
    model, t = four_bar(), np.linspace(0, 0.4, 5)
    motion = model.simulate(t, q={"a": 0.4}, u={"a": 2.0}, rtol=1e-11, method="DOP853")
    samples = samples_of(model, {"t": t, "a": motion["a"]}, None, None)
    free = np.zeros(0, dtype=np.intp)
    shooting = Shooting(model, samples, (0, 2, 4), ("length",), free, None, "DOP853", 1e-11)
    n, count = shooting.size, 3
    columns = np.random.default_rng(2).standard_normal((n, count))
    # out of its plane the loop has rows too many to be closed
    columns[[name.endswith((".x", ".z", ".py")) for name in (*model.speeds, *model.speeds)]] = 0.0
    by_length = np.array([[0.0], [0.0], [1.0]])

    def trial(value: float) -> Trial:
        return Trial(shooting, np.array([value]), by_length)

    here = trial(2.2)
    begin = here.begin(1, motion.x[2])
    run = here.run(1, begin, columns)
    moved = here.increments_of(run.end, run.moved)
    h, stencil = 1e-3, {-2: 1 / 12, -1: -2 / 3, 1: 2 / 3, 2: -1 / 12}
    for k in range(count):
        slope = np.zeros(n)
        for side, weight in stencil.items():
            start = shooting.moved(begin.x[None], side * h * columns[None, :, k])[0]
            there = trial(2.2 + side * h * by_length[k, 0])
            end = there.run(1, there.begin(1, start), columns).end
            slope += weight / h * shooting.increments(run.end[None], end[None])[0]
        # h^4 of the differences and 1e-11 of runs over h
        np.testing.assert_allclose(moved[:, k], slope, atol=1e-6 * np.abs(slope).max())
