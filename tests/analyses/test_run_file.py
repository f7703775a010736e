"""Runs of ``simulate`` that go on from a file, to the bit."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.test_events import servo
from cardan.analyses.simulation import run
from cardan.runtime.trajectory.trajectory import TrajectoryRecord
from hostile.kinds import records, together
from hostile.kinds import servo as sampled

__all__ = ["servo"]


def feedback(t: float, x: np.ndarray) -> float:
    """An input that depends on the state."""
    return float(0.1 * np.sin(t) - 0.2 * x[2])


PUSH = ([0.0, 1.0, 1.0, 60.0], [0.0, 0.2, -0.1, 0.1])
CASES: dict[str, dict[str, Any]] = {
    "dense": {"t": 20.0, "rtol": 1e-10},
    "times": {"t": np.linspace(0, 20, 77), "rtol": 1e-10, "inputs": {"torque": PUSH}},
    "RK45": {"t": 20.0, "method": "RK45", "inputs": {"torque": PUSH}},
    "Radau": {"t": 20.0, "method": "Radau", "rtol": 1e-8},
    "Rosenbrock": {"t": (0.5, 20.0), "method": "Rosenbrock", "rtol": 1e-6},
    "alpha": {"t": 10.0, "method": "GeneralizedAlpha", "rtol": 1e-6},
    "events": {"t": 20.0, "rtol": 1e-10, "events": {"up": (("elbow", 0.0), "mark")}},
    "function": {"t": 20.0, "inputs": {"torque": feedback}, "sample": 0.5, "rtol": 1e-9},
}
KILLED = """
import os, pickle, signal, sys
from cardan.analyses.simulation import run
def stop(done):
    if done > float(sys.argv[2]):
        os.kill(os.getpid(), signal.SIGKILL)
run.SLICE = float(sys.argv[3])
with open(sys.argv[1], "rb") as file:
    model, options = pickle.load(file)
model.simulate(**options, progress=stop)
"""


def alike(one: TrajectoryRecord, other: TrajectoryRecord) -> None:
    """Two motions are the same to the bit."""
    assert one.status == other.status
    for name in ("t", "x", "r", "s", "work_done"):
        assert getattr(one, name).tobytes() == getattr(other, name).tobytes()
    times = np.linspace(one.t[0], one.t[-1], 50)
    if one.dense is not None:
        assert one.at(times).tobytes() == other.at(times).tobytes()
    assert one.event_log.log.tobytes() == other.event_log.log.tobytes()
    counts = (dict(m.statistics) | {"milliseconds": 0} for m in (one, other))
    assert next(counts) == next(counts)


def killed(
    model: cd.CompiledModel,
    options: dict[str, Any],
    where: Path,
    at: float,
    piece: float = run.SLICE,
) -> None:
    """Begin a run in another process, which is killed on the way, between slices of so many s."""
    (where / "job").write_bytes(pickle.dumps((model, options)))
    command = [sys.executable, "-c", KILLED, str(where / "job"), str(at), str(piece)]
    paths = [*sys.path, str(Path(__file__).parents[1])]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(paths)}
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
    assert done.returncode == -signal.SIGKILL, done.stderr


@pytest.mark.parametrize("case", CASES)
def test_a_killed_run_goes_on_to_the_bit(
    case: str, double: cd.CompiledModel, tmp_path: Path
) -> None:
    options = {"q": {"elbow": 0.7}, "u": {"shoulder": 3.0}} | CASES[case]
    kept = options | {"checkpoint": tmp_path / "run", "every": 0.0}
    whole = double.simulate(**options)
    killed(double, kept, tmp_path, 0.3)
    fractions: list[float] = []
    motion = double.simulate(**kept, progress=fractions.append)
    # it began where the other one was
    assert fractions[0] > 0.3
    alike(motion, whole)
    fractions.clear()
    alike(double.simulate(**kept, progress=fractions.append), motion)
    assert fractions == []


def test_samples_and_modes_go_on_too(servo: cd.CompiledModel, tmp_path: Path) -> None:
    options: dict[str, Any] = {"t": 30.0, "rtol": 1e-10}
    kept = options | {"checkpoint": str(tmp_path / "run"), "every": 0}
    for at in (0.2, 0.6):
        killed(servo, kept, tmp_path, at)
    motion = servo.simulate(**kept)
    alike(motion, servo.simulate(**options))
    assert len(motion.ticks) == 601


def test_a_run_goes_on_whatever_the_model_has_done_before(tmp_path: Path) -> None:
    """A model is the same model, whether or not its functions have been called."""
    path, fresh = tmp_path / "run", sampled()
    whole = fresh.simulate(1.5, checkpoint=path)
    for model in (fresh, sampled()):
        alike(model.simulate(1.5, checkpoint=path), whole)


def test_a_run_goes_on_from_every_place(
    servo: cd.CompiledModel, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Between a sample and what it changes too: such a file was called damaged."""
    path, whole = tmp_path / "run", servo.simulate(1.5)
    kept: dict[str, Any] = {"t": 1.5, "checkpoint": path, "every": 0.0}
    with monkeypatch.context() as slices:
        # of one step or sample each, with a record after every one
        slices.setattr(run, "SLICE", 0.0)
        servo.simulate(**kept)
    parts = records(path.read_bytes())
    places = {one["head"]["record"]["event_pending"] for one in parts["records"]}
    assert places == {0, 1}
    for count in range(1, len(parts["records"])):
        path.write_bytes(together({**parts, "records": parts["records"][:count]}))
        alike(servo.simulate(**kept), whole)


def test_ctrl_c_and_a_cut_file(double: cd.CompiledModel, tmp_path: Path) -> None:
    path = tmp_path / "run"
    options: dict[str, Any] = {"t": 20.0, "q": {"elbow": 0.7}, "rtol": 1e-10}

    def stop(done: float) -> None:
        if done > 0.2:
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.warns(cd.SolveWarning, match="kept in .*run, and the same call goes on") as told:
        part = double.simulate(**options, checkpoint=path, progress=stop)
    assert told[0].filename == __file__
    assert part.status == "interrupted"
    whole = double.simulate(**options)
    alike(double.simulate(**options, checkpoint=path), whole)
    path.write_bytes(path.read_bytes()[:-100])
    alike(double.simulate(**options, checkpoint=path), whole)


def test_a_method_that_the_first_steps_ask_for(tmp_path: Path) -> None:
    scene = cd.Scene("stiff", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    scene.force("spring", cd.JointSpring("x", stiffness=100.0))
    scene.force("damper", cd.JointDamper("x", 1e5))
    model = cd.compile(scene)
    options: dict[str, Any] = {"t": 50.0, "q": {"x": 1.0}}
    whole = model.simulate(**options)
    assert whole.solver_info.method == "Rosenbrock"
    kept = options | {"checkpoint": tmp_path / "run", "every": 0.0}
    killed(model, kept, tmp_path, 0.001)
    motion = model.simulate(**kept)
    alike(motion, whole)
    assert motion.solver_info.reason == whole.solver_info.reason


def test_files_of_other_runs_are_refused(
    double: cd.CompiledModel, ball: cd.CompiledModel, tmp_path: Path, bare: Any
) -> None:
    path = tmp_path / "run"
    double.simulate(1.0, checkpoint=path)
    for call, words in (
        (lambda: double.simulate(2.0, checkpoint=path), "another time, method, tolerance"),
        (lambda: double.simulate(1.0, q={"elbow": 1.0}, checkpoint=path), "starts elsewhere"),
        (lambda: ball.simulate(1.0, checkpoint=path), "another run: it was computed with another"),
        (lambda: double.ensemble(1.0, runs=3, checkpoint=path), "not a file of an ensemble"),
        (lambda: double.simulate(1.0, checkpoint=3), "checkpoint=3: give the path of a file"),
        (lambda: double.simulate(1.0, checkpoint=path, every=-1), "every=-1.*: the time between"),
        (lambda: double.simulate(1.0, checkpoint=tmp_path / "a" / "b"), "cannot be opened"),
        (lambda: bare(double).simulate(1.0, checkpoint=path), "another compiler, processor"),
    ):
        with pytest.raises(cd.CardanError, match=words):
            call()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert double.simulate(1.0, checkpoint=path).success
