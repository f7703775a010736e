"""What runs with events show: histories, summaries, files, steppers, mistakes."""

from __future__ import annotations

import pickle
import re
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.runtime.build import toolchain
from cardan.runtime.trajectory.storage import load
from cardan.runtime.trajectory.trajectory import TrajectoryRecord
from cardan.schema.integrators import INTEGRATORS

G = 9.81
FINE: dict[str, Any] = {"rtol": 1e-11, "atol": 1e-12}
START = {"z": 1.0}


@pytest.fixture(scope="module")
def ball() -> cd.CompiledModel:
    """A ball that bounces on a floor, against air, and a motor that lags."""
    scene = cd.Scene("ball", gravity=(0, 0, -G))
    scene.joint("z", cd.Prismatic("z"), scene.ground, scene.body("ball", mass=2.0))
    scene.force("floor", cd.Stop("z", lower=0.0, restitution=0.7, settle=1e-3))
    scene.force("air", cd.JointDamper("z", 0.05))
    scene.force("motor", cd.Actuator("z", command=scene.input("push"), lag=0.2))
    return cd.compile(scene)


@pytest.fixture(scope="module")
def servo() -> cd.CompiledModel:
    """A mass on a rail under a sampled controller."""
    scene = cd.Scene("servo")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    x, v = scene.q("x"), scene.u("x")
    pid = cd.Controller.pid("x", x, v, target=1.0, kp=8.0, ki=1.0, kd=5.0, sample=0.05)
    scene.force("pid", pid)
    return cd.compile(scene)


def test_energy_is_accounted_for_over_impacts(ball: cd.CompiledModel) -> None:
    motion = ball.simulate(3.0, q=START, inputs={"push": 1.5}, **FINE)
    hits = [event for event in motion.events if event.name == "floor.lower"]
    assert len(hits) > 3
    lost = sum(float(e.x[1] ** 2 - e.x_after[1] ** 2) for e in hits)
    assert motion.work["floor.impact"][-1] == pytest.approx(-lost, rel=1e-9)
    assert np.abs(motion.energy_residual).max() < 1e-9
    found = motion.balance
    assert found.impacts == {"floor.impact": pytest.approx(lost, rel=1e-9)}
    assert set(found.dissipated) == {"air"}
    assert found.dissipated["air"] == pytest.approx(-motion.work["air"][-1], rel=1e-9)
    assert found.supplied > 0
    assert found.after - found.before == pytest.approx(
        found.supplied - found.taken - found.dissipated["air"] - lost, abs=1e-9
    )
    assert found.residual < 1e-9


def test_summary_says_what_happened(ball: cd.CompiledModel) -> None:
    text = repr(ball.simulate(3.0, q=START))
    for words in (
        "1 internal state, 1 mode",
        "events    floor.lower (impact), ",
        "times: 0.45",
        "floor.impact = -",
        "balance   ",
        "impacts ",
        "given: z = 1",
        "motor.force = 0",
    ):
        assert words in text
    assert max(len(line) for line in text.splitlines()) <= 100
    assert "events    none" in repr(ball.simulate(0.1, q=START))


def test_samples_stay_out_of_the_way(servo: cd.CompiledModel) -> None:
    motion = servo.simulate(
        2.0, events={"half": ("x", 0.5), "soon": (lambda t, x: t - 0.07, "mark")}
    )
    assert [event.name for event in motion.events] == ["soon", "half"]
    text = repr(motion)
    assert "events    soon (mark): 0.07 s\n            half (end): " in text
    assert f"samples   pid.sample {len(motion.ticks)} times" in text
    assert motion.statistics["events"] == 2
    assert motion.statistics["ticks"] == len(motion.ticks)
    assert motion.ticks[1].kind == "tick"
    # rows are those of steps, and between them what was held last holds
    assert len(np.unique(motion.t)) == len(motion) == motion.statistics["steps"] + 1
    forces = [tick.s_after[1] for tick in motion.ticks]
    times = np.array([tick.t for tick in motion.ticks])
    np.testing.assert_array_equal(motion.resample(times)["pid.force"], forces)
    np.testing.assert_array_equal(motion.resample(times[:-1] + 0.02)["pid.force"], forces[:-1])


def test_histories_by_name(ball: cd.CompiledModel) -> None:
    motion = ball.simulate(8.0, q=START, inputs={"push": 0.5}, z={"motor.force": 2.0}, **FINE)
    np.testing.assert_allclose(
        motion["motor.force"], 0.5 + 1.5 * np.exp(-motion.t / 0.2), rtol=0, atol=1e-10
    )
    assert motion.solver_info.initial["motor.force"] == 2.0
    # it lies on the floor in the end
    assert motion["floor"][0] == 0
    assert motion["floor"][-1] == -1
    later = motion.resample([0.1, 7.9])
    assert later["floor"].tolist() == [0, -1]
    assert motion.x.shape[1] == ball.nx == 3


def test_runs_come_back_from_files_and_pickles(ball: cd.CompiledModel, tmp_path: Path) -> None:
    motion = ball.simulate(3.0, q=START, inputs={"push": 1.0})
    path = motion.save(tmp_path / "run.nc")
    for again in (load(path), load(path, ball), pickle.loads(pickle.dumps(motion))):
        np.testing.assert_array_equal(again.x, motion.x)
        np.testing.assert_array_equal(again.s, motion.s)
        assert [repr(e) for e in again.events] == [repr(e) for e in motion.events]
        np.testing.assert_array_equal(again.events[0].x_after, motion.events[0].x_after)
        np.testing.assert_array_equal(again["motor.force"], motion["motor.force"])
        np.testing.assert_allclose(again.at(1.7), motion.at(1.7), rtol=0, atol=1e-14)
        np.testing.assert_allclose(
            again.work["floor.impact"], motion.work["floor.impact"], rtol=1e-12
        )
        assert str(again.balance) == str(motion.balance)


def test_a_data_set_holds_the_states_of_elements(ball: cd.CompiledModel) -> None:
    pytest.importorskip("xarray")
    motion = ball.simulate(1.0, q=START)
    data = motion.to_xarray()
    np.testing.assert_array_equal(data["z"].sel(internal_state="motor.force"), motion.z[:, 0])
    np.testing.assert_array_equal(data["s"].sel(mode="floor"), motion.s[:, 0])


def test_the_caller_may_watch(ball: cd.CompiledModel) -> None:
    top = {"top": (lambda t, x: x[1], "mark", "down"), "over": ("motor.force", 0.9)}
    motion = ball.simulate(3.0, q=START, inputs={"push": 1.0}, events=top, **FINE)
    assert motion.status == "event"
    assert motion.success
    assert motion.message == f"ended at t = {motion.t[-1]:.6g} s of 3 s by 'over'"
    assert motion.t[-1] == pytest.approx(0.2 * np.log(10), abs=1e-9)
    assert motion.events[-1].kind == "end"


def test_steppers_go_over_events(servo: cd.CompiledModel, ball: cd.CompiledModel) -> None:
    whole = servo.simulate(2.0, **FINE)
    stepper = servo.stepper(**FINE)
    ticks = 0
    while stepper.t < 1.99:
        stepper.step(0.125)
        ticks += len(stepper.ticks)
        assert stepper.events == ()
    np.testing.assert_allclose(stepper.state, whole.x[-1], rtol=0, atol=1e-9)
    assert ticks == len(whole.ticks) == 41
    assert stepper.modes["pid.integral"] == pytest.approx(whole["pid.integral"][-1], abs=1e-9)
    falling = ball.stepper(q=START, events={"low": ("z", 0.25)}, **FINE)
    falling.step(0.1)
    state = falling.step(10.0)
    assert falling.t == pytest.approx(np.sqrt(1.5 / G), rel=1e-2)
    assert state[0] == pytest.approx(0.25, abs=1e-13)
    assert [event.name for event in falling.events] == ["low"]
    with pytest.raises(cd.SolveError, match=r"ended at t = .* by 'low'; restore an earlier state"):
        falling.step(0.1)
    with pytest.raises(cd.ModelError, match="forward only"):
        ball.stepper(q=START).step(-0.1)


def test_steppers_restore_events_to_the_bit(ball: cd.CompiledModel) -> None:
    stepper = ball.stepper(q=START, z={"motor.force": 0.3})
    stepper.step(0.7)
    saved = stepper.save()
    there = stepper.step(1.3).tobytes()
    events = [event.t for event in stepper.events]
    stepper.restore(saved)
    assert stepper.step(1.3).tobytes() == there
    assert [event.t for event in stepper.events] == events


def test_files_of_steppers_know_samples_and_modes(
    servo: cd.CompiledModel, ball: cd.CompiledModel, tmp_path: Path
) -> None:
    path = tmp_path / "run.npz"
    for model, options in ((servo, {}), (ball, {"q": START})):
        stepper = model.stepper(**options)
        stepper.step(0.97)
        stepper.save(path)
        there = stepper.step(1.1).tobytes()
        again = model.resume(path)
        assert again.step(1.1).tobytes() == there
        assert [repr(e) for e in again.events] == [repr(e) for e in stepper.events]
        assert again.modes == stepper.modes


MISTAKES: list[tuple[dict[str, Any], type[Exception], str]] = [
    ({"a": 1}, ValueError, r"'a' is 1; give f\(t, x\), or a name and the value"),
    ({"a": ("y", 1.0)}, cd.ModelError, "no coordinate, speed or internal state 'y'"),
    ({"a": ("motor.fore", 1.0)}, cd.ModelError, "Did you mean 'motor.force'"),
    ({"a": ("z", np.nan)}, cd.SolveError, "'z' cannot pass nan"),
    ({"a": (("z", 1.0), "mrk")}, cd.ModelError, "Did you mean 'mark'"),
    ({"a": (("z", 1.0), "mark", "left")}, cd.ModelError, "'left' is none of end, mark, down"),
    ({"a": lambda: 1.0}, ValueError, r"the function of 'a' must take \(t, x\)"),
    (
        {"a": lambda t, x: "soon"},
        ValueError,
        "the function of 'a' gave 'soon', which is not a number",
    ),
    ({"floor.lower": ("z", 1.0)}, cd.ModelError, "the model has an event 'floor.lower'"),
]


@pytest.mark.parametrize(("events", "error", "words"), MISTAKES)
def test_mistakes_are_named(
    ball: cd.CompiledModel, events: dict[str, Any], error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        ball.simulate(1.0, q=START, events=events)


def test_a_watch_that_is_not_finite_ends_the_run(ball: cd.CompiledModel) -> None:
    def root(t: float, x: Any) -> float:
        return float(np.sqrt(np.maximum(x[0] - 0.5, -np.inf)) if x[0] > 0.5 else np.nan)

    with pytest.warns(cd.SolveWarning, match="what says when 'root' happens is not finite"):
        motion = ball.simulate(1.0, q=START, events={"root": root})
    assert isinstance(motion, TrajectoryRecord)
    assert motion.status == "not_finite"
    assert motion["z"][-1] > 0.5


def test_an_unknown_internal_state(ball: cd.CompiledModel) -> None:
    with pytest.raises(cd.ModelError, match=r"no internal state 'motor.fore'.*motor.force"):
        ball.simulate(1.0, z={"motor.fore": 1.0})
    with pytest.raises(cd.ModelError, match="given twice"):
        ball.simulate(1.0, x0=[1, 0, 0], z={"motor.force": 1.0})


def test_the_same_without_a_compiler(
    ball: cd.CompiledModel, servo: cd.CompiledModel, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    runs: list[tuple[cd.CompiledModel, dict[str, Any]]] = [
        (ball, {"q": START, "inputs": {"push": 1.0}, "events": {"top": ("z", 0.1)}}),
        (ball, {"q": START, "inputs": {"push": 0.5}, "z": {"motor.force": 1.0}}),
        (servo, {}),
    ]
    compiled = [model.simulate(1.5, **given, **FINE) for model, given in runs]
    models = [pickle.dumps(model) for model, _ in runs]
    monkeypatch.setenv("PATH", "/nonexistent")
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(toolchain, "ziglang", lambda: [])
    monkeypatch.setattr("cardan.runtime.calls.webassembly.available", lambda: False)
    for (_, given), text, fast in zip(runs, models, compiled, strict=True):
        bare = pickle.loads(text)
        with warnings.catch_warnings():
            # it says once that there is no compiler
            warnings.simplefilter("ignore", cd.BuildWarning)
            motion = bare.simulate(1.5, **given, **FINE)
        assert "in Python" in motion.solver_info.settings
        assert motion.status == fast.status
        assert [e.name for e in motion.events] == [e.name for e in fast.events]
        times = [[e.t for e in some.events] for some in (motion, fast)]
        np.testing.assert_allclose(*times, rtol=0, atol=1e-9)
        np.testing.assert_allclose(motion.x[-1], fast.x[-1], rtol=0, atol=1e-8)
        np.testing.assert_allclose(motion.s[-1], fast.s[-1], rtol=0, atol=1e-8)


# by every method: bound of times and of states between rows
BOUNDS = {
    **dict.fromkeys(("DOP853", "RK45", "RKMK853", "RKMK45", "Radau", "Rosenbrock"), 1e-6),
    **dict.fromkeys(("RK4", "RKMK4"), 1e-9),
    # order 2
    **dict.fromkeys(("GeneralizedAlpha", "HHT"), 3e-4),
}


@pytest.fixture(scope="module")
def turning() -> tuple[cd.CompiledModel, TrajectoryRecord]:
    """A rod that hits a stop, with a body that tumbles at its end; and its motion."""
    scene = cd.Scene("turning", gravity=(0, 0, -G))
    rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5), inertia=(0.01, 0.02, 0.015))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, rod)
    top = scene.body("top", mass=0.2, inertia=(0.01, 0.02, 0.015))
    scene.joint("ball", cd.Spherical(), rod.at(0, 0, -1), top)
    scene.force("wall", cd.Stop("hinge", lower=-0.3, restitution=0.8))
    model = cd.compile(scene)
    return model, model.simulate(2.5, **TURN, rtol=1e-12, atol=1e-12)


TURN: dict[str, Any] = {"q": {"hinge": 1.0}, "u": {"ball": [0.2, 5.0, -0.3]}}


@pytest.mark.parametrize("method", BOUNDS)
def test_by_every_method(method: str, turning: tuple[cd.CompiledModel, TrajectoryRecord]) -> None:
    model, wanted = turning
    fixed = not INTEGRATORS[method].adaptive
    how: dict[str, Any] = {"step": 1e-3} if fixed else {"rtol": 1e-8, "atol": 1e-9}
    motion = model.simulate(2.5, method=method, **TURN, **how)
    assert [e.name for e in motion.events] == [e.name for e in wanted.events]
    assert len(motion.events) >= 2
    times = [[e.t for e in some.events] for some in (motion, wanted)]
    np.testing.assert_allclose(*times, rtol=0, atol=BOUNDS[method])
    # apart from the moments around an impact
    inside = np.linspace(0, 2.5, 300)
    inside = inside[np.abs(inside[:, None] - times[1]).min(axis=1) > 1e-3]
    np.testing.assert_allclose(
        motion.at(inside), wanted.at(inside), rtol=0, atol=10 * BOUNDS[method]
    )


def test_reports_of_models_with_states_and_modes(ball: cd.CompiledModel) -> None:
    report = ball.report()
    assert {row.function for row in report.rows} >= {"rhs", "forward_dynamics"}
    assert all(row.error is not None and row.error < 1e-14 for row in report.rows)


def test_a_first_decision_is_no_event() -> None:
    scene = cd.Scene("box", gravity=(0, 0, -G))
    box = scene.body("box", mass=1.0)
    scene.joint("z", cd.Prismatic("z"), scene.ground, box)
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    scene.force("rail", cd.Friction("x", coulomb=0.5))
    scene.force("floor", cd.Contact(box, scene.ground, radius=0.1, stiffness=1e4, damping=0.1))
    motion = cd.compile(scene).simulate(0.5, q={"z": 0.3}, u={"x": 0.2})
    assert [e.name for e in motion.events if e.name != "floor.part"][:2] == [
        "floor.touch",
        "rail.stop",
    ]
    assert motion.statistics["events"] == len(motion.events)
    assert motion.t[:2].tolist() != [0, 0]
    assert (motion["rail"][0], motion["floor"][0]) == (1, 1)
    assert "stop (mode), 2" not in repr(motion)


CHANGED: list[tuple[dict[str, float], str]] = [
    ({"end.lower": 2.0}, "stop of joint 'z': lower=2 must be below upper=1"),
    ({"end.lower": 2.0, "end.upper": 2.0}, "lower=2 must be below upper=2"),
    ({"e": 1.5}, "parameter 'e': stop of joint 'z': restitution is 1.5; give 0 ... 1"),
    ({"end.settle": -1.0}, "settle is -1; give a speed of 0 or more"),
    ({"rub.coulomb": 3.0}, "friction on joint 'z': static is 2, less than the 3 of sliding"),
    ({"motor.lag": 0.0}, "actuator of joint 'z': lag is 0; give a time of more than 0"),
]


@pytest.fixture(scope="module")
def bounded() -> cd.CompiledModel:
    """Elements whose numbers have limits."""
    scene = cd.Scene("bounded", gravity=(0, 0, -G))
    scene.joint("z", cd.Prismatic("z"), scene.ground, scene.body("ball", mass=2.0))
    e = scene.parameter("e", 0.3)
    scene.force("end", cd.Stop("z", lower=-1.0, upper=1.0, restitution=e, settle=1e-3))
    scene.force("rub", cd.Friction("z", coulomb=0.5, static=2.0))
    scene.force("motor", cd.Actuator("z", command=1.0, lag=0.1))
    return cd.compile(scene)


@pytest.mark.parametrize(("values", "words"), CHANGED)
def test_numbers_of_elements_are_judged_when_they_change(
    bounded: cd.CompiledModel, values: dict[str, float], words: str
) -> None:
    with pytest.raises(cd.ModelError, match=re.escape(words)):
        bounded.with_parameters(values)
    many = {name: np.array([bounded.parameters[name], value]) for name, value in values.items()}
    with pytest.raises(cd.ModelError, match=re.escape(words.rpartition(": ")[2])):
        bounded.ensemble(0.1, parameters=many)
    with pytest.raises(cd.ModelError, match=r"at \(1,\): "):
        bounded.mass_matrix(np.zeros((2, 1)), parameters=many)


def test_numbers_within_their_limits_are_taken(bounded: cd.CompiledModel) -> None:
    changed = bounded.with_parameters({"end.lower": 2.0, "end.upper": 3.0, "e": 1.0})
    assert changed.parameters["e"] == 1.0
    again = pickle.loads(pickle.dumps(changed))
    assert dict(again.parameters) == dict(changed.parameters)
