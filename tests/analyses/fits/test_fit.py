"""Fits against references, closed forms and what noise does to them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import ArgumentError, ModelError, SolveWarning
from table import each

REFERENCES = Path(__file__).parents[2] / "references"
TIGHT = {"rtol": 1e-13, "atol": 1e-14, "method": "DOP853"}


def reference(name: str) -> dict[str, Any]:
    return json.loads((REFERENCES / f"{name}.json").read_text("utf-8"))


def double_pendulum() -> cd.CompiledModel:
    scene = cd.Scene("double pendulum", gravity=(0, 0, -9.81))
    m1, m2, l1, l2 = (scene.parameter(name, 1.0) for name in ("m1", "m2", "l1", "l2"))
    upper = scene.body("A", mass=m1, com=(0, 0, -l1 / 2), inertia=cd.inertia.rod(m1, l1, axis="z"))
    lower = scene.body("B", mass=m2, com=(0, 0, -l2 / 2), inertia=cd.inertia.rod(m2, l2, axis="z"))
    scene.joint("a", cd.Revolute("y"), scene.ground, upper)
    scene.joint("b", cd.Revolute("y"), upper.at(0, 0, -l1), lower)
    return cd.compile(scene)


@each("factor", [1.03, 1.1, 1.3, 1.6])
def test_chaotic_double_pendulum(factor: float) -> None:
    """Errors of a single run grow by 1e5: parameters are found from far away all the same."""
    known, model = reference("est_double_pendulum"), double_pendulum()
    true = dict(zip(("m2", "l1", "l2"), known["parameters"]["true"], strict=True))
    t, k = 0.05 * np.arange(161), np.arange(161)
    x = model.simulate(t, q={"a": 2.0, "b": 1.0}, parameters=true, **TIGHT).x
    data = {"t": t}
    data |= {
        name: x[:, j] + 0.01 * np.sin(12.9898 * (2 * k + j) ** 2) for j, name in enumerate("ab")
    }
    found = model.fit(
        data,
        unknown=("m2", "l1", "l2", "x0"),
        parameters={name: factor * value for name, value in true.items()},
        q={"a": data["a"][0], "b": data["b"][0]},
        rtol=1e-10,
    )
    assert found.converged
    assert found.iterations <= 12
    answer = known["reference"]
    for name, error in zip(true, answer["standard_errors"], strict=True):
        assert found.parameters[name] == pytest.approx(answer["estimate"][name], rel=1e-8)
        assert found.standard_errors[name] == pytest.approx(error, rel=1e-5)
    np.testing.assert_allclose(found.start, answer["x0_estimate"], atol=1e-8)
    assert 2 * found.cost == pytest.approx(answer["cost"], rel=1e-7)
    assert not found.undetermined


@each("start", [(2.0, 1.0), (0.3, 0.2)])
def test_segments_follow_from_growth(start: tuple[float, float]) -> None:
    """As many as errors grow by e^2 of a chaotic motion, one of a mild one.

    All states are measured without noise: no run leaves what was measured.
    """
    known, model = reference("est_double_pendulum"), double_pendulum()
    true = dict(zip(("m2", "l1", "l2"), known["parameters"]["true"], strict=True))
    t = 0.05 * np.arange(161)
    motion = model.simulate(
        (0, t[-1]),
        q=dict(zip("ab", start, strict=True)),
        parameters=true,
        sensitivity="x0",
        **TIGHT,
    )
    x, changes = motion.at(t), motion.sensitivity.at([t[-1]])["x0"][0]
    data = dict(zip(("t", "a", "b", "a.u", "b.u"), (t, *x.T), strict=True))
    found = model.fit(
        data, unknown=("m2", "x0"), q=dict(zip("ab", x[0, :2], strict=True)),
        parameters=true | {"m2": 1.0001 * true["m2"]}, rtol=1e-10,
    )  # fmt: skip
    assert found.parameters["m2"] == pytest.approx(true["m2"], rel=1e-7)
    # norms of products are at most products of norms
    units = x.std(axis=0)
    growth = np.linalg.norm(changes * units / units[:, None], 2)
    print(f"errors grow by {growth:.3g} over {found.segments} segments")
    if start == (2.0, 1.0):
        assert growth > 1e4
        assert np.log(growth) / 2 <= found.segments <= 20
    else:
        assert found.segments == 1


def test_segments_from_values_that_are_far_off() -> None:
    """A mild motion needs one run near the truth, and several where the first run leaves it."""
    model = pendulum()
    data = measured(model, 1e-3, 6)
    near, far = (
        model.fit(data, unknown=("w2", "q0"), q={"y": 1.0}, parameters={"w2": w2})
        for w2 in (9.01, 30.0)
    )
    assert near.segments == 1
    assert far.segments > 3
    assert far.parameters["w2"] == pytest.approx(near.parameters["w2"], rel=1e-7)
    # a single run from there ends where the costs are no minimum, or takes longer
    one = model.fit(data, unknown=("w2", "q0"), q={"y": 1.0}, parameters={"w2": 30.0}, segments=1)
    assert not one.converged or one.cost > 2 * far.cost or one.iterations > far.iterations


def pendulum() -> cd.CompiledModel:
    """y'' = -w2 sin y - c y' by a mass of 1 on an arm of 1."""
    scene = cd.Scene("pendulum", gravity=(0, 0, 0))
    w2, c = scene.parameter("w2", 9.0), scene.parameter("c", 0.3)
    bob = scene.body("bob", mass=1.0, com=(0, 0, -1.0))
    scene.joint("y", cd.Revolute("y"), scene.ground, bob)
    import sympy as sp

    scene.force("law", cd.JointForce("y", -w2 * sp.sin(scene.q("y")) - c * scene.u("y")))
    return cd.compile(scene)


@each("segments", ["auto", 1, 5])
def test_damped_pendulum(segments: str | int) -> None:
    known = reference("est_pendulum")
    p, answer, model = known["parameters"], known["reference"], pendulum()
    t, k = p["dt"] * np.arange(p["n"] + 1), np.arange(p["n"] + 1)
    true = {"w2": p["w2"], "c": p["c"]}
    y = model.simulate(t, q={"y": 1.5}, parameters=true, **TIGHT).x[:, 0]
    y = y + p["amp"] * np.sin(12.9898 * k**2)
    # the first sample is the start itself, which was not measured
    y[0] = np.nan
    found = model.fit(
        {"t": t, "y": y}, unknown=("w2", "c", "q0", "u0"), q={"y": 1.4}, segments=segments,
        rtol=1e-11,
    )  # fmt: skip
    ours = [found.parameters["w2"], found.parameters["c"], *found.start]
    np.testing.assert_allclose(ours, answer["estimate"], rtol=1e-6, atol=1e-7)
    names = ("w2", "c", "q0.y", "u0.y.u")
    assert [found.values[name] for name in names] == ours
    errors = [found.standard_errors[name] for name in names]
    np.testing.assert_allclose(errors, answer["standard_errors"], rtol=1e-5)
    assert found.sigma == pytest.approx(answer["sigma"], rel=1e-6)
    np.testing.assert_allclose(
        found.residuals["y"][1:], (y - found.motion.at(t)[:, 0])[1:], atol=1e-7
    )


def measured(model: cd.CompiledModel, sigma: float, seed: int, n: int = 60) -> dict[str, Any]:
    t = np.linspace(0, 3, n)
    y = model.simulate(t, q={"y": 1.0}, rtol=1e-10, method="DOP853").x[:, 0]
    return {"t": t, "y": y + sigma * np.random.default_rng(seed).standard_normal(n)}


def test_what_the_data_do_not_tell_is_named() -> None:
    """Of a bar that swings freely mass and gravity, and mass and damping, are known as ratios."""
    scene = cd.Scene("bar", gravity=(0, 0, -9.81))
    m, d = scene.parameter("m", 2.0), scene.parameter("d", 0.2)
    bar = scene.body("bar", mass=m, com=(0, 0, -0.5), inertia=cd.inertia.rod(m, 1.0, axis="z"))
    scene.joint("y", cd.Revolute("y"), scene.ground, bar)
    scene.force("bearing", cd.JointDamper("y", d))
    model = cd.compile(scene)
    data = measured(model, 1e-3, 1)
    start = {"m": 2.4, "d": 0.22}
    with pytest.warns(SolveWarning, match="cannot determine"):
        found = model.fit(data, unknown=("m", "d", "q0"), parameters=start, q={"y": 1.0})
    (one,) = found.undetermined
    # m and d may grow by the same part
    assert set(one) == {"m", "d"}
    assert one["m"] == pytest.approx(one["d"], rel=1e-5)
    assert found.parameters["d"] / found.parameters["m"] == pytest.approx(0.1, rel=0.01)
    assert found.standard_errors["m"] == np.inf
    assert found.standard_errors["q0.y"] < 1e-3
    assert "cannot determine" in str(found)
    with pytest.warns(SolveWarning, match="cannot determine"):
        still = bar_with_inertia().fit(data, unknown=("bar.inertia.zz", "q0"), q={"y": 1.0})
    assert [set(one) for one in still.undetermined] == [{"bar.inertia.zz"}]


def bar_with_inertia() -> cd.CompiledModel:
    """A bar that never turns about its long axis."""
    scene = cd.Scene("bar", gravity=(0, 0, -9.81))
    bar = scene.body("bar", mass=2.0, com=(0, 0, -0.5), inertia=(0.2, 0.2, 0.01))
    scene.joint("y", cd.Revolute("y"), scene.ground, bar)
    return cd.compile(scene)


def test_formulas_files_and_noise(tmp_path: Path) -> None:
    model = pendulum()
    data = measured(model, 1e-3, 2)
    data["height"] = -np.cos(data["y"]) + 1e-2 * np.random.default_rng(3).standard_normal(60)
    file = tmp_path / "run.csv"
    rows = np.column_stack([data["t"], data["y"], data["height"]])
    np.savetxt(file, rows, delimiter=",", header="t [s],y [rad],height [m]", comments="")
    names = {"unknown": ("w2", "c", "q0"), "q": {"y": 0.9}, "parameters": {"w2": 8.0, "c": 0.2}}
    given = {"measured": {"y": "y", "-cos(y)": "height"}, "noise": {"y": 1e-3, "-cos(y)": 1e-2}}
    found = model.fit(file, **names, **given)
    assert found.sigma == pytest.approx(1.0, abs=0.3)
    for name, value in (("w2", 9.0), ("c", 0.3)):
        assert abs(found.parameters[name] - value) <= 4 * found.standard_errors[name]
    assert found.durbin_watson["y"] == pytest.approx(2.0, abs=0.7)
    again = model.fit(data, **names, **given)
    assert again.parameters["w2"] == pytest.approx(found.parameters["w2"], rel=1e-9)


def test_wrong_samples_and_bounds() -> None:
    model = pendulum()
    data = measured(model, 1e-3, 4)
    data["y"][[7, 23, 41]] += 0.8
    names = {"unknown": ("w2", "c", "q0"), "q": {"y": 1.0}}
    plain, robust = model.fit(data, **names), model.fit(data, loss="huber", **names)
    assert abs(robust.parameters["w2"] - 9.0) < 0.1 * abs(plain.parameters["w2"] - 9.0)
    bounded = model.fit(data, loss="huber", bounds={"c": (0.4, 1.0)}, **names)
    assert bounded.parameters["c"] == 0.4
    assert bounded.converged


def test_what_makes_no_sense_is_refused() -> None:
    model = pendulum()
    data = measured(model, 1e-3, 5)
    with pytest.raises(ModelError, match=r"'w' is neither a parameter nor a start"):
        model.fit(data, unknown="w")
    with pytest.raises(ArgumentError, match="no column 't'"):
        model.fit({"y": data["y"]}, unknown="w2")
    with pytest.raises(ArgumentError, match="measured="):
        model.fit({"t": data["t"], "angle": data["y"]}, unknown="w2")
    with pytest.raises(ArgumentError, match="no column 'x'"):
        model.fit(data, unknown="w2", measured={"y": "x"})
    with pytest.raises(ArgumentError, match="segments"):
        model.fit(data, unknown="w2", segments=1000)
    with pytest.raises(ArgumentError, match="loss"):
        model.fit(data, unknown="w2", loss="cubic")
    with pytest.raises(ArgumentError, match="ascending"):
        model.fit({"t": data["t"][::-1], "y": data["y"]}, unknown="w2")
    with pytest.raises(ArgumentError, match="bounds"):
        model.fit(data, unknown="w2", bounds={"c": (0, 1)})


@pytest.mark.slow
def test_intervals_cover() -> None:
    """95 % intervals of 1,000 fits to noise by chance contain the truth in 93 to 97 % of them."""
    model, inside = pendulum(), []
    for seed in range(1000):
        found = model.fit(
            measured(model, 0.02, seed, n=40), unknown=("w2", "c", "q0"), q={"y": 1.0},
            segments=1, rtol=1e-7,
        )  # fmt: skip
        truth = {"w2": 9.0, "c": 0.3, "q0.y": 1.0}
        intervals = {n: found.interval(n) for n in truth}
        inside.append([low <= truth[n] <= high for n, (low, high) in intervals.items()])
    covered = np.mean(inside, axis=0)
    print(f"95 % intervals cover {100 * covered} %")
    assert (covered >= 0.93).all()
    assert (covered <= 0.97).all()
