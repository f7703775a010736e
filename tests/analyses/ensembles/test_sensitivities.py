"""Sensitivities of many runs: those of each alone, and differences of runs beside."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd

STENCIL = {-3: -1, -2: 9, -1: -45, 1: 45, 2: -9, 3: 1}  # over 60: sixth order
TIMES = np.linspace(0.0, 1.0, 6)
TABLE = (np.array([0.0, 0.5, 1.0]), np.array([0.0, 1.0, -1.0]))
RUNS: dict[str, Any] = {
    "vary": cd.sample.grid(**{"upper.mass": (0.8, 1.4, 3), "elbow": (-0.5, 1.0, 3)}),
    "inputs": {"torque": TABLE},
    "q": {"shoulder": 0.4},
    "rtol": 1e-9,
    "sensitivity": ("upper.mass", "q0.elbow", "u0", "torque"),
}


def test_runs_have_the_bits_of_simulate(double: cd.CompiledModel) -> None:
    runs = double.ensemble(TIMES, **RUNS, threads=2)
    assert runs.success
    assert list(runs.sensitivity) == ["upper.mass", "q0.elbow", "u0", "torque"]
    shapes = [runs.sensitivity[name].shape for name in runs.sensitivity]
    assert shapes == [(9, 6, 4), (9, 6, 4), (9, 6, 4, 2), (9, 6, 4, 3)]
    for k in range(9):
        alone = double.simulate(
            1.0,
            q={"shoulder": 0.4, "elbow": runs.varied["elbow"][k]},
            parameters={"upper.mass": runs.varied["upper.mass"][k]},
            inputs=RUNS["inputs"],
            rtol=1e-9,
            sensitivity=RUNS["sensitivity"],
        )
        again = runs.run(k)
        for name, changes in alone.sensitivity.at(TIMES).items():
            np.testing.assert_array_equal(runs.sensitivity[name][k], changes)
            np.testing.assert_array_equal(again.sensitivity[name], alone.sensitivity[name])
    # states are those of runs without them, and default times are those of reductions
    plain = double.ensemble(TIMES, **RUNS | {"sensitivity": ()}, method="DOP853")
    kept = double.ensemble(TIMES, **RUNS, reduce="states")
    np.testing.assert_array_equal(kept["states"], plain["states"])
    np.testing.assert_array_equal(kept.final, plain.final)
    usual = double.ensemble(1.0, **RUNS)
    assert usual.sensitivity["upper.mass"].shape == (9, 201, 4)
    assert len(usual.t) == 201


def differences(
    model: cd.CompiledModel, runs: cd.Ensemble, k: int, name: str, h: float, **more: Any
) -> np.ndarray:
    """Derivative (nt, nx) of a run by a parameter, by differences of others beside it."""
    at, total = float(runs.varied[name][k]), np.zeros((len(runs.t), model.nx))
    others = {n: float(v[k]) for n, v in runs.varied.items() if n != name}
    for side, weight in STENCIL.items():
        changed = {**others, name: at + side * h}
        states = model.simulate(runs.t, parameters=changed, rtol=1e-13, method="DOP853", **more).x
        total += weight * states / (60 * h)
    return total


def bounces() -> cd.CompiledModel:
    """A ball that falls on a floor again and again."""
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    e = scene.parameter("e", 0.8)
    height = scene.parameter("height", 1.0)
    ball = scene.body("ball", mass=1.0, com=(0, 0, 0), inertia=(1, 1, 1))
    scene.joint("slide", cd.Prismatic("z"), scene.ground, ball)
    scene.force("floor", cd.Stop("slide", lower=-height, restitution=e))
    return cd.compile(scene)


def four_bar() -> cd.CompiledModel:
    """A crank-rocker, whose crank is named at the start."""
    scene = cd.Scene("four_bar", gravity=(0, 0, -9.81))
    length = scene.parameter("length", 0.25)
    crank = scene.body("crank", mass=1.0, com=(0.05, 0, 0), inertia=(0.01, 0.01, 0.01))
    rod = scene.body("rod", mass=1.0, com=(length / 2, 0, 0), inertia=(0.01, 0.01, 0.01))
    rocker = scene.body("rocker", mass=1.0, com=(0.1, 0, 0), inertia=(0.01, 0.01, 0.01))
    scene.joint("A", cd.Revolute("y"), scene.ground, crank, q0=-1.0)
    scene.joint("B", cd.Revolute("y"), crank.at(0.1, 0, 0), rod, q0=0.8)
    scene.joint("D", cd.Revolute("y"), scene.ground.at(0.3, 0, 0), rocker, q0=-1.9)
    scene.joint("C", cd.Revolute("y"), rod.at(length, 0, 0), rocker.at(0.2, 0, 0))
    return cd.compile(scene)


def test_events_and_loops_against_differences() -> None:
    ball = bounces()
    runs = ball.ensemble(
        TIMES, vary={"e": [0.7, 0.8], "height": [0.5, 0.9]}, sensitivity=("e", "height"), rtol=1e-12
    )
    for k in range(2):
        for name in ("e", "height"):
            expected = differences(ball, runs, k, name, 1e-3)
            np.testing.assert_allclose(runs.sensitivity[name][k], expected, rtol=1e-8, atol=1e-8)
    loop = four_bar()
    start: dict[str, Any] = {"q": {"A": -1.0}, "u": {"A": 3.0}}
    runs = loop.ensemble(
        0.4 * TIMES, vary={"length": [0.24, 0.25, 0.26]}, sensitivity="length", rtol=1e-12, **start
    )
    for k in range(3):
        expected = differences(loop, runs, k, "length", 1e-3, **start)
        # projections close to 1e-10 or so, and differences magnify that by 1/h
        np.testing.assert_allclose(runs.sensitivity["length"][k], expected, rtol=1e-6, atol=1e-6)


def test_beams_against_differences() -> None:
    scene = cd.Scene("rubber", gravity=(0, 0, -9.81))
    E = scene.parameter("E", 5e6, unit="Pa")
    rubber = cd.material(E=E, nu=0.45, rho=1100, damping=1e-3)
    square = cd.section.rectangle(0.03, 0.03)
    hub = scene.body("hub", mass=0.5, inertia=(0.01, 0.01, 0.01))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    scene.beam("bar", hub, (0.5, 0, 0), square, rubber, elements=1)
    model = cd.compile(scene)
    times, moduli = np.array([0.0, 0.02, 0.05]), [4e6, 5e6]
    runs = model.ensemble(times, vary={"E": moduli}, sensitivity="E", rtol=1e-10)
    assert runs.sensitivity["E"].shape == (2, 3, model.nx)
    for k in range(2):
        expected = differences(model, runs, k, "E", 1e-3 * moduli[k])
        found = runs.sensitivity["E"][k]
        # as far as runs at rtol 1e-10 are right, per entry of one kind
        for kind in (slice(0, model.nq), slice(model.nq, model.nx)):
            size = np.abs(expected[:, kind]).max()
            assert size > 0
            assert np.abs(found - expected)[:, kind].max() <= 1e-5 * size


def test_runs_that_fail_are_named(edge: cd.CompiledModel) -> None:
    with pytest.warns(cd.SolveWarning, match="did not reach their end"):
        runs = edge.ensemble(
            np.linspace(0, 3, 4), vary={"push": [1.0, -1.0]}, sensitivity="push", rtol=1e-8
        )
    assert runs.status.tolist()[1] == "finished"
    assert runs.status.tolist()[0] not in ("finished", "no_derivative")
    assert np.isnan(runs.sensitivity["push"][0]).all()
    assert np.isfinite(runs.sensitivity["push"][1]).all()


def test_a_run_without_derivative_is_named() -> None:
    scene = cd.Scene("two", gravity=(0, 0, -9.81))
    drop = scene.parameter("drop", 1.0)
    for name, height in (("left", 1.0), ("right", drop)):
        ball = scene.body(name, mass=1.0, com=(0, 0, 0), inertia=(1, 1, 1))
        scene.joint(f"slide {name}", cd.Prismatic("z"), scene.ground, ball)
        scene.force(f"floor of {name}", cd.Stop(f"slide {name}", lower=-height, restitution=0.5))
    model = cd.compile(scene)
    heights, reduced = [0.7, 1.0, 1.3], ["mean of slide right", "max of slide right"]
    with pytest.warns(cd.SolveWarning, match=r"1 of 3 runs have no .* run 1: .*at the same time"):
        runs = model.ensemble(0.6, vary={"drop": heights}, sensitivity="drop", reduce=reduced)
    assert runs.status.tolist() == ["finished", "no_derivative", "finished"]
    assert np.isnan(runs.sensitivity["drop"][1]).all()
    assert np.isfinite(runs.sensitivity["drop"][[0, 2]]).all()
    # where it ends is right all the same
    plain = model.ensemble(0.6, vary={"drop": heights}, reduce=reduced, rtol=1e-9)
    np.testing.assert_array_equal(runs.final, plain.final)
    assert runs.finished.all()
    for name, result in plain.results.items():
        np.testing.assert_array_equal(np.asarray(runs[name]), np.asarray(result))
    assert not runs.run(1).sensitivity
    with pytest.raises(cd.SolveError, match="at the same time"):
        model.ensemble(0.6, vary={"drop": heights}, sensitivity="drop", check=True)


def test_files_and_parts_keep_them(double: cd.CompiledModel, tmp_path: Path) -> None:
    whole = double.ensemble(TIMES, **RUNS | {"runs": None})
    back = cd.load_ensemble(whole.save(tmp_path / "runs.nc"))
    for k in (1, 2):
        double.ensemble(TIMES, **RUNS, part=(k, 2), checkpoint=tmp_path / f"{k}.part")
    joined = cd.Ensemble.join(str(tmp_path / "*.part"))
    for name in RUNS["sensitivity"]:
        np.testing.assert_array_equal(back.sensitivity[name], whole.sensitivity[name])
        np.testing.assert_array_equal(joined.sensitivity[name], whole.sensitivity[name])
    assert whole.to_xarray()["sensitivity_to_upper.mass"].dims == ("run", "time", "entry")
    with pytest.raises(cd.ModelError, match="it keeps other reductions"):
        double.ensemble(
            TIMES, **RUNS | {"sensitivity": "u0"}, part=(1, 2), checkpoint=tmp_path / "1.part"
        )


def test_what_is_refused(double: cd.CompiledModel) -> None:
    runs = double.ensemble(0.1, **RUNS)
    with pytest.raises(cd.ModelError, match=r"'upper.mas' was not asked for\..* Did you mean"):
        runs.sensitivity["upper.mas"]
    for more, match in (
        ({"sensitivity": "lower.mas"}, r"'lower.mas' is not a start.*Did you mean 'lower.mass'"),
        ({"method": "Rosenbrock"}, "Take Radau"),
        ({"inputs": {"torque": lambda t: t}}, "input 'torque' is a function"),
        ({"reduce": {"sensitivity to u0": "states"}}, "is the name of a sensitivity"),
        ({"reduce": "sensitivity to u0 in 2 columns"}, "is not a reduction"),
    ):
        with pytest.raises(cd.ModelError, match=match):
            double.ensemble(0.1, **RUNS | more)


def test_outputs_of_many_runs(tmp_path: Path) -> None:
    """Those of every run alone; NaN behind the end of one, and of those without any."""
    model = bounces()
    runs = model.ensemble(
        np.linspace(0.0, 0.6, 7), vary={"height": [0.5, 1.0, 3.0]}, sensitivity=("e", "height"),
        events={"low": ("slide", -0.9)},
    )  # fmt: skip
    changes = runs.sensitivity.of("energy")
    assert changes["e"].shape == (3, 7)
    for k, height in enumerate(runs.varied["height"]):
        alone = model.simulate(
            0.6, parameters={"height": height}, sensitivity=("e", "height"),
            events={"low": ("slide", -0.9)},
        )  # fmt: skip
        inside = runs.t[runs.t <= alone.t[-1]]
        for name, values in alone.sensitivity.of("energy", inside).items():
            np.testing.assert_array_equal(changes[name][k, : len(inside)], values)
            assert np.isnan(changes[name][k, len(inside) :]).all()
    assert np.isnan(changes["e"][2, -1])
    assert np.abs(changes["e"][0, -1]) > 1.0
    stored = cd.load_ensemble(runs.save(tmp_path / "runs.nc"))
    with pytest.raises(cd.ModelError, match="ensemble of a file has no model"):
        stored.sensitivity.of("energy")
    with pytest.raises(cd.ModelError, match="with sensitivity="):
        model.ensemble(0.1, vary={"e": [0.5, 0.6]}, reduce="states").sensitivity.of("energy")
