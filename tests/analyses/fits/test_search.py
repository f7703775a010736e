"""How searches end: with the best so far, and what the data do not tell by name."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.gradients.test_gradients import double_pendulum
from cardan.analyses.simulation.progress import Bar
from cardan.errors import SolveWarning

T = np.linspace(0, 4, 81)
FIRST: dict[str, Any] = {"measured": {"tip": "x"}, "q": {"hinge": 1.0}}


@functools.cache
def swing() -> cd.CompiledModel:
    """A pendulum with a spring far too soft to matter."""
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    length, damping = scene.parameter("length", 0.8), scene.parameter("damping", 0.1)
    stiffness = scene.parameter("stiffness", 1e-6)
    inertia = cd.inertia.rod(1.0, length, axis="z")
    bar = scene.body("bar", mass=1.0, com=(0, 0, -length / 2), inertia=inertia)
    scene.joint("hinge", cd.Revolute("y"), scene.ground, bar)
    scene.force("bearing", cd.JointDamper("hinge", damping))
    scene.force("spring", cd.JointSpring("hinge", stiffness=stiffness))
    scene.output("tip", bar.at(0, 0, -length).position()[0])
    return cd.compile(scene)


def data() -> dict[str, Any]:
    truth = swing().simulate(T, q={"hinge": 1.2}, parameters={"length": 1.1, "damping": 0.06})
    return {"t": T, "x": truth["tip"] + 0.002 * np.random.default_rng(1).standard_normal(81)}


def test_what_noise_hides_is_named_and_does_no_harm() -> None:
    """The stiffness would have to be thousands of times as large to be seen."""
    unknown = ("length", "damping", "stiffness", "q0")
    with pytest.warns(SolveWarning, match=r"cannot determine combinations of stiffness"):
        fit = swing().fit(data(), unknown=unknown, **FIRST)
    assert fit.converged
    assert [set(one) for one in fit.undetermined] == [{"stiffness"}]
    # it has an error, many times its value
    assert 1e3 * 1e-6 < fit.standard_errors["stiffness"] < np.inf
    for name, value in (("length", 1.1), ("damping", 0.06)):
        assert abs(fit.parameters[name] - value) < 4 * fit.standard_errors[name]
    assert "cannot determine" in str(fit)


def test_it_is_named_where_the_fit_has_not_converged() -> None:
    with pytest.warns(SolveWarning, match=r"not converged after 2.* combinations of .*stiffness"):
        fit = swing().fit(data(), unknown=("length", "stiffness", "q0"), most=2, **FIRST)
    assert not fit.converged
    (one,) = fit.undetermined
    assert abs(one["stiffness"]) > 0.9


@pytest.mark.filterwarnings("ignore::cardan.errors.SolveWarning")
def test_a_search_that_goes_astray_ends_with_the_best_so_far() -> None:
    """A chaotic motion in one run, from values that are off: costs have minima everywhere."""
    model, t = double_pendulum(), np.linspace(0, 8, 161)
    truth = model.simulate(t, q={"a": 2.0, "b": 2.5}, rtol=1e-10)
    samples = {"t": t, "a": truth["a"], "b": truth["b"]}
    far = {"parameters": {"m2": 1.3, "l1": 1.2}, "q": {"a": 2.0, "b": 2.5}, "segments": 1}
    unknown = ("m2", "l1", "u0")
    fit = model.fit(samples, unknown=unknown, most=500, **far)
    print(fit.message)
    assert not fit.converged
    assert fit.message.startswith("no progress: nothing better was found after iteration ")
    assert fit.iterations < 100
    # the best of all, wherever a shorter search stops
    for most in (1, 4, fit.iterations // 2):
        assert fit.cost <= model.fit(samples, unknown=unknown, most=most, **far).cost


def test_ctrl_c_keeps_the_best_so_far() -> None:
    calls = 0

    def stop(part: float) -> None:
        nonlocal calls
        calls += 1
        if part > 3 / 60:
            raise KeyboardInterrupt

    with pytest.warns(SolveWarning, match="interrupted in iteration 4"):
        fit = swing().fit(data(), unknown=("length", "damping", "q0"), progress=stop, **FIRST)
    assert fit.interrupted
    with pytest.warns(SolveWarning, match="not converged"):
        three = swing().fit(data(), unknown=("length", "damping", "q0"), most=3, **FIRST)
    assert fit.cost <= three.cost
    # runs within an iteration show that it goes on
    assert calls > 8


def test_the_bar_says_how_the_search_stands(monkeypatch: pytest.MonkeyPatch) -> None:
    shown: list[str] = []
    monkeypatch.setattr(Bar, "show", lambda bar, fraction: shown.append(bar.text))
    swing().fit(data(), unknown=("length", "damping", "q0"), progress=True, **FIRST)
    assert shown[0].startswith("pendulum: first runs")
    assert shown[-1].startswith("pendulum: iteration ")
    assert "cost" in shown[-1]
