"""MATLAB files of runs and ensembles as GNU Octave reads them."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from view.test_motion_files import ODD, arm

OCTAVE = shutil.which("octave-cli") or shutil.which("octave")
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(OCTAVE is None, reason="GNU Octave is not installed"),
]


def octave(program: str, folder: Path) -> Any:
    """The value of ``result`` after a program, through JSON; numbers with all digits."""
    script = folder / "program.m"
    script.write_text(f"{program}\nprintf('%s', jsonencode(result));\n", encoding="utf-8")
    command = [str(OCTAVE), "--no-gui", "--no-window-system", "--quiet", str(script)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, cwd=folder)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_runs(tmp_path: Path) -> None:
    motion = cd.compile(arm()).simulate(1.0, q={"shoulder": 1.0})
    motion.save(tmp_path / "run.mat")
    read = octave(
        "s = load('run.mat');\n"
        # every bit, which decimal digits would lose
        "hex = @(x) cellstr(num2hex(x(:)));\n"
        "result = struct('t', {hex(s.t)}, 'q', {hex(s.q)}, 'tip', {hex(s.outputs)});\n"
        "result.names = s.q_names; result.units = s.q_units; result.speeds = s.u_units;\n"
        "result.output = s.outputs_names; result.size = size(s.q); result.pose = s.pose_1_names;",
        tmp_path,
    )
    for name, values in (("t", motion.t), ("q", motion.q), ("tip", motion["height of hand"])):
        bits = [f"{np.float64(x).view(np.uint64):016x}" for x in np.ravel(values, order="F")]
        assert read[name] == bits
    assert read["size"] == [*motion.q.shape]
    assert read["names"] == ["shoulder", "elbow"]
    assert read["units"] == ["rad", "rad"]
    assert read["speeds"] == ["rad/s", "rad/s"]
    assert read["output"] == ["height of hand"]
    assert json.loads(f'"{read["pose"][3]}"') == f"{ODD}.pose.px"


def test_beams_loops_and_ensembles(tmp_path: Path) -> None:
    model = cd.compile(cd.examples["four_bar"])
    motion = model.simulate(0.2, q={"A": 0.470659})
    motion.save(tmp_path / "loop.mat")
    runs = model.ensemble(0.1, q={"A": [0.470659, 0.5]}, reduce="states")
    runs.save(tmp_path / "runs.mat")
    read = octave(
        "s = load('loop.mat'); e = load('runs.mat');\n"
        "result = struct('last', s.q(end, :), 'rows', rows(s.constraints));\n"
        "result.status = e.status; result.final = e.final;",
        tmp_path,
    )
    assert read["rows"] == len(motion)
    np.testing.assert_allclose(read["last"], motion.q[-1], rtol=1e-4)
    assert read["status"] == [*runs.status]
    np.testing.assert_allclose(read["final"], runs.final, rtol=1e-3, atol=1e-4)
