"""Stepping by hand: the same motion, new inputs, and checkpoints to the bit."""

from __future__ import annotations

import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd

METHODS = pytest.mark.parametrize(
    "options", [{"rtol": 1e-11, "atol": 1e-12}, {"method": "RK4", "step": 1e-3}], ids=str
)


@METHODS
def test_steps_lead_where_a_run_leads(double: cd.CompiledModel, options: dict) -> None:
    stepper = double.stepper(q={"elbow": 0.4}, inputs={"torque": 0.3}, **options)
    for _ in range(20):
        state = stepper.step(0.05)
    motion = double.simulate(1.0, q={"elbow": 0.4}, inputs={"torque": 0.3}, **options)
    assert stepper.t == pytest.approx(1.0, abs=1e-14)
    np.testing.assert_allclose(state, motion.x[-1], rtol=0, atol=1e-9)
    assert stepper.work["motor"] == pytest.approx(motion.work["motor"][-1], abs=1e-9)


@METHODS
def test_restore_is_bit_for_bit(double: cd.CompiledModel, options: dict) -> None:
    stepper = double.stepper(q={"elbow": 0.9}, **options)
    stepper.step(0.37)
    saved = stepper.save()
    inputs = [{"torque": 0.2}, None, {"torque": -1.0}, None]
    first = [stepper.step(0.05 * (k + 1), inputs[k]) for k in range(4)]
    stepper.restore(saved)
    assert stepper.t == pytest.approx(0.37)
    assert stepper.inputs == {"torque": 0.0}
    again = [stepper.step(0.05 * (k + 1), inputs[k]) for k in range(4)]
    np.testing.assert_array_equal(first, again)


def test_inputs_hold_until_changed(double: cd.CompiledModel) -> None:
    stepper = double.stepper(inputs={"torque": 1.0})
    stepper.step(0.1)
    assert stepper.inputs == {"torque": 1.0}
    stepper.step(0.1, inputs={"torque": -2.0})
    assert stepper.inputs == {"torque": -2.0}
    assert "t = 0.2 s" in repr(stepper)


def test_backward_and_forward(double: cd.CompiledModel) -> None:
    stepper = double.stepper(t=2.0, q={"elbow": 0.4}, rtol=1e-12, atol=1e-13)
    start = stepper.state
    stepper.step(0.5)
    stepper.step(-0.5)
    assert stepper.t == 2.0
    np.testing.assert_allclose(stepper.state, start, rtol=0, atol=1e-11)


def test_mistakes(double: cd.CompiledModel, ball: cd.CompiledModel) -> None:
    stepper = double.stepper()
    with pytest.raises(cd.ModelError, match="takes some time"):
        stepper.step(0.0)
    with pytest.raises(cd.ModelError, match="Did you mean 'torque'"):
        stepper.step(0.1, inputs={"torqu": 1.0})
    with pytest.raises(cd.SolveError, match="'torque' is nan"):
        stepper.step(0.1, inputs={"torque": np.nan})
    with pytest.raises(cd.ModelError, match="RK4 needs step="):
        double.stepper(method="RK4")
    with pytest.raises(cd.ModelError, match="takes numbers"):
        double.stepper(inputs={"torque": np.sin})
    with pytest.raises(cd.ModelError, match="another stepper"):
        stepper.restore(ball.stepper().save())


def test_one_step_from_many_states(double: cd.CompiledModel) -> None:
    """Leading axes broadcast, and there and back again is where it began."""
    rng = np.random.default_rng(3)
    x = rng.uniform(-1, 1, (2, 3, double.nx))
    options = {"rtol": 1e-12, "atol": 1e-13}
    there = double.step(x, 0.2, **options)
    assert there.shape == x.shape
    for place in np.ndindex(2, 3):
        motion = double.simulate(0.2, x0=x[place], **options)
        np.testing.assert_allclose(there[place], motion.x[-1], rtol=0, atol=1e-11)
    np.testing.assert_allclose(double.step(there, -0.2, **options), x, rtol=0, atol=1e-10)


# checkpoints on disk


GO_ON = """
import sys, cardan as cd
model = cd.load_model(sys.argv[1])
stepper = model.resume(sys.argv[2])
print(stepper.step(0.7).tobytes().hex())
"""
WAYS = [
    {"method": "DOP853", "rtol": 1e-9},
    {"method": "RK45", "rtol": 1e-7, "max_step": 0.1},
    {"method": "RK4", "step": 0.003},
    {"method": "Radau"},
    {"method": "Rosenbrock"},
    {"method": "GeneralizedAlpha"},
    {"method": "EnergyMidpoint", "step": 0.01},
]


@pytest.mark.parametrize("how", WAYS, ids=lambda how: str(how["method"]))
def test_a_file_goes_on_to_the_bit(
    double: cd.CompiledModel, how: dict[str, Any], tmp_path: Path
) -> None:
    stepper = double.stepper(q={"elbow": 0.4}, inputs={"torque": 0.1}, **how)
    stepper.step(0.31, inputs={"torque": 0.3})
    stepper.save(tmp_path / "run.npz")
    there = stepper.step(0.7)
    again = double.resume(tmp_path / "run.npz")
    assert again.t == 0.31
    assert again.inputs == {"torque": 0.3}
    assert again.step(0.7).tobytes() == there.tobytes()
    assert again.work == stepper.work
    assert repr(again) == repr(stepper)


def test_another_process_goes_on_to_the_bit(double: cd.CompiledModel, tmp_path: Path) -> None:
    stepper = double.stepper(q={"elbow": 0.4})
    stepper.step(0.3)
    stepper.save(tmp_path / "run.npz")
    command = [sys.executable, "-c", GO_ON, str(double.directory), str(tmp_path / "run.npz")]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == stepper.step(0.7).tobytes().hex()


def test_a_run_that_an_event_ended_stays_ended(double: cd.CompiledModel, tmp_path: Path) -> None:
    watched = {"up": ("elbow", 0.2)}
    stepper = double.stepper(q={"elbow": 0.4}, events=watched)
    before = stepper.save()
    stepper.step(5.0)
    assert stepper.t < 5.0
    ended = stepper.save(tmp_path / "run.npz")
    for again in (stepper, double.resume(tmp_path / "run.npz", events=watched)):
        with pytest.raises(cd.SolveError, match="by 'up'; restore an earlier state"):
            again.step(0.1)
    stepper.restore(before)
    stepper.step(0.01)
    stepper.restore(ended)
    with pytest.raises(cd.SolveError, match="by 'up'; restore an earlier state"):
        stepper.step(0.1)


def test_files_that_are_no_checkpoint_of_this(
    double: cd.CompiledModel, ball: cd.CompiledModel, tmp_path: Path
) -> None:
    stepper = double.stepper(events={"up": ("elbow", 1.0)})
    path = tmp_path / "run.npz"
    stepper.save(path)
    with pytest.raises(cd.ModelError, match="watches for up: give the same events="):
        double.resume(path)
    assert double.resume(path, events={"up": ("elbow", 1.0)}).t == 0
    for other in (ball, double.with_parameters({"upper.mass": 2.0})):
        with pytest.raises(cd.ModelError, match="other equations or parameters"):
            other.resume(path)
    with pytest.raises(cd.ModelError, match="no such file"):
        double.resume(tmp_path / "none.npz")
    with pytest.raises(cd.ModelError, match="does not exist"):
        stepper.save(tmp_path / "none" / "run.npz")
    objects = pickle.dumps({"a": 1})
    for content in (b"", b"PK not at all", b"junk" * 99, objects, path.read_bytes()[:500]):
        (tmp_path / "bad.npz").write_bytes(content)
        with pytest.raises(cd.ModelError, match=r"bad\.npz is not a checkpoint") as told:
            double.resume(tmp_path / "bad.npz")
        assert "pickle" not in str(told.value)
    np.save(tmp_path / "bad.npy", np.zeros(3))
    with pytest.raises(cd.ModelError, match="is not a checkpoint"):
        double.resume(tmp_path / "bad.npy")
    with pytest.raises(cd.ModelError, match=r"cannot be read: it is a directory"):
        double.resume(tmp_path)
    with pytest.raises(cd.ArgumentError, match="path=3: give the path of a file"):
        double.resume(3)


def test_an_end_is_remembered(double: cd.CompiledModel, tmp_path: Path) -> None:
    events = {"up": ("elbow", 0.3)}
    stepper = double.stepper(q={"elbow": 0.4}, events=events)
    before = stepper.save()
    stepper.step(2.0)
    ended = stepper.save(tmp_path / "run.npz")
    with pytest.raises(cd.SolveError, match="by 'up'; restore an earlier state"):
        double.resume(tmp_path / "run.npz", events=events).step(0.1)
    stepper.restore(before)
    stepper.step(0.01)
    stepper.restore(ended)
    with pytest.raises(cd.SolveError, match="by 'up'; restore an earlier state"):
        stepper.step(0.1)


def test_misspelt_arguments_are_told(double: cd.CompiledModel) -> None:
    for call in (double.simulate, double.ensemble, double.step):
        with pytest.raises(cd.ArgumentError, match=r"\(rtoll=...\).* Did you mean 'rtol'"):
            call(1.0, *([1.0] if call == double.step else []), rtoll=1e-3)
    with pytest.raises(cd.ArgumentError, match=r"report\(metods=...\).* Did you mean 'methods'"):
        double.report(1.0, metods=["RK4"])
    with pytest.raises(TypeError, match=r"stepper\(event=...\).* Did you mean 'events'"):
        double.stepper(event={})
    with pytest.raises(TypeError, match=r"no such argument\. Known: path, events\."):
        double.resume("run.npz", evnt={})


@pytest.mark.parametrize("beam", [False, True])
@pytest.mark.parametrize("sample", [None, 0.01])
def test_auto_takes_the_method_that_a_run_takes(beam: bool, sample: float | None) -> None:
    """An explicit method would follow the vibrations of beams, with 500 times as many steps."""
    scene = cd.Scene("arm")
    arm = scene.body("arm", mass=1.0, com=(0.1, 0, 0), inertia=(0.01, 0.01, 0.01))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, arm)
    angle, rate = scene.q("hinge"), scene.u("hinge")
    pid = cd.Controller.pid("hinge", angle, rate, target=0.1, kp=5, ki=1, kd=1, sample=sample)
    scene.force("pid", pid)
    if beam:
        dural = cd.material(E=7e10, nu=0.3, rho=2700)
        scene.beam("rod", arm, (1, 0, 0), cd.section.circle(0.01), dural, elements=2)
    model = cd.compile(scene)
    motion, stepper = model.simulate(0.2), model.stepper()
    assert model.simulate(6.0).solver_info.method in repr(stepper)
    state = stepper.step(0.2)
    np.testing.assert_allclose(state, motion.x[-1], rtol=0, atol=1e-4)
