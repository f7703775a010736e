"""``cardan identify``: from a motion for the robot to estimates of what it is."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.cli import main

ARM = str(Path(__file__).parents[2] / "examples" / "arm.urdf")


def status(*words: str) -> int:
    try:
        return main(words)
    except SystemExit as stop:
        return int(stop.code or 0)


def test_from_motion_to_estimates(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert status("identify", ARM) == 0
    said = capsys.readouterr().out
    assert "without effect: column.mass" in said
    count = int(said.split(": ")[1].split()[0])
    words = ("--period", "5", "--speed", "2.5")
    assert status("identify", ARM, "--excite", "motion.csv", *words, "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert found["condition"] < found["condition_before"]
    # the robot does it, and is not quite what the file says
    table = np.genfromtxt("motion.csv", delimiter=",", names=True, deletechars="")
    assert len(table) == 500
    assert "elbow.udot" in table.dtype.names
    q, u, udot = (
        np.column_stack([table[f"{name}{word}"] for name in ("waist", "shoulder", "elbow")])
        for word in ("", ".u", ".udot")
    )
    model = cd.compile(cd.load(ARM))
    true = model.with_parameters({"forearm.mass": 1.0, "elbow.damping": 0.2})
    tau = true.inverse_dynamics(q, u, udot)
    tau += 0.02 * np.random.default_rng(1).normal(size=tau.shape)
    names = ["t", *model.coordinates, *(f"{name}.tau" for name in model.coordinates)]
    rows = np.column_stack([table["t"], q, tau])
    np.savetxt("run.csv", rows, delimiter=",", header=",".join(names), comments="")
    assert status("identify", ARM, "--data", "run.csv", "--period", "5", "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert len(found["base_parameters"]) == count
    damping = found["base_parameters"]["elbow.damping"]
    assert abs(damping["estimate"] - 0.2) < 4 * damping["deviation"] < 0.1
    assert damping["nominal"] == 0.1
    assert found["noise"]["elbow.u"] == pytest.approx(0.02, rel=0.15)
    # zeros of the file stay: its parameters are fewer than the base parameters
    assert abs(found["parameters"]["elbow.damping"] - 0.2) < 4 * damping["deviation"]
    assert found["parameters"]["forearm.mass"] == pytest.approx(1.0, rel=0.1)
    assert status("identify", ARM, "--data", "run.csv", "--cutoff", "20", "--noise",
                  "elbow=0.02") == 1  # fmt: skip
    assert "a positive number for every speed" in capsys.readouterr().err
    assert status("identify", ARM, "--data", "run.txt") == 2
