"""``cardan ensemble``: words of the command line as runs."""

from __future__ import annotations

import json
import re
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.io import netcdf_file

import cardan as cd
from cardan.cli import main
from cardan.cli.options import sweep

ARM = str(Path(__file__).parents[2] / "examples" / "arm.urdf")


def status(*words: str) -> int:
    try:
        return main(words)
    except SystemExit as stop:
        return int(stop.code or 0)


def test_a_grid_with_random_values(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["ensemble", ARM, "--time", "0.2", "--vary", "waist=linspace(0, 1, 4)"]
    words += ["--vary", "elbow=normal(0, 0.1)", "--runs", "40", "--reduce", "max of elbow"]
    words += ["--reduce", "mean of elbow", "--points", "11", "-o", str(tmp_path / "a" / "runs.nc")]
    assert status(*words, "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert found["runs"] == 40
    assert found["statuses"] == {"finished": 40}
    assert found["varied"]["waist"] == {"min": 0.0, "mean": 0.5, "max": 1.0}
    assert len(found["results"]["mean of elbow"]) == 11
    with netcdf_file(tmp_path / "a" / "runs.nc", mmap=False) as file:
        waist = file.variables["varied_waist"][:]
        np.testing.assert_allclose(np.unique(waist), np.linspace(0, 1, 4), rtol=0, atol=1e-15)
        assert file.variables["max_of_elbow"].shape == (40,)
        assert file.variables["final"].shape == (40, 6)
    assert status(*words) == 0
    shown = capsys.readouterr().out
    assert "40 runs from 0 s to 0.2 s" in shown
    assert "max of elbow: " in shown


def test_a_checkpoint(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["ensemble", ARM, "--time", "0.1", "--vary", "waist=1,2,5", "--json"]
    words += ["--checkpoint", str(tmp_path / "runs")]
    assert status(*words) == 0
    first = json.loads(capsys.readouterr().out)
    assert status(*words) == 0
    again = json.loads(capsys.readouterr().out)
    assert again["steps"] == first["steps"]
    assert status(*words, "--rtol", "1e-3") == 1
    assert "belongs to another ensemble" in capsys.readouterr().err


def test_parts_are_joined(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["ensemble", ARM, "--time", "0.1", "--vary", "waist=uniform(0, 1)", "--runs", "40"]
    words += ["--reduce", "mean of elbow", "--reproducible"]
    for k in (1, 2, 3):
        file = str(tmp_path / f"runs-{k}.part")
        assert status(*words, "--part", f"{k}/3", "--checkpoint", file) == 0
    assert "part 3 of 3: runs " in capsys.readouterr().out
    assert status(*words, "-o", str(tmp_path / "whole.nc")) == 0
    join = ["ensemble", "--join", str(tmp_path / "runs-*.part")]
    capsys.readouterr()
    assert status(*join, "-o", str(tmp_path / "all.nc"), "--json") == 0
    assert json.loads(capsys.readouterr().out)["runs"] == 40
    made, joined = (cd.load_ensemble(tmp_path / f"{name}.nc") for name in ("whole", "all"))
    assert made.final.tobytes() == joined.final.tobytes()
    assert made["mean of elbow"].tobytes() == joined["mean of elbow"].tobytes()
    assert made.varied["waist"].tobytes() == joined.varied["waist"].tobytes()
    (tmp_path / "runs-2.part").unlink()
    assert status(*join) == 1
    assert "part 2 of 3 is missing" in capsys.readouterr().err


WRONG = {
    "no file": ([], "name a FILE, or --join"),
    "no checkpoint": ([ARM, "--part", "1/3"], "--part needs --checkpoint FILE"),
    "part 0": ([ARM, "--part", "0/3"], "parts are counted from 1 to N"),
    "no part": ([ARM, "--part", "three"], "does not read K/N"),
    "join and a file": ([ARM, "--join", "a"], "FILE: --join takes the files alone"),
    "join and a time": (["--join", "a", "--time", "3"], "--time: --join takes the files alone"),
}


@pytest.mark.parametrize("case", WRONG)
def test_parts_that_make_no_sense(case: str, capsys: pytest.CaptureFixture[str]) -> None:
    words, message = WRONG[case]
    assert status("ensemble", *words) == 2
    assert message in capsys.readouterr().err


FORMS: dict[str, Any] = {
    "m=1": [1.0],
    "m= 1, -2.5e-3 ,.5": [1.0, -2.5e-3, 0.5],
    "m=linspace(0, 1, 3)": [0, 0.5, 1],
    "m = geomspace(1, 100, 3)": [1, 10, 100],
}


@pytest.mark.parametrize("text", FORMS)
def test_lists(text: str) -> None:
    name, values = sweep.vary(text)
    assert name == "m"
    np.testing.assert_allclose(values, FORMS[text], rtol=1e-15)


REFUSED = {
    "m": "does not read NAME=VALUES",
    "=1": "does not read NAME=VALUES",
    "m=one": "values are linspace",
    "m=linspace(1,2)": "linspace takes first, last, count",
    "m=linspace(1,2,2.5)": "2.5 is not a number of values",
    "m=linspce(1,2,3)": "Did you mean 'linspace'",
    "m=normal(0,-1)": "the deviation must be positive",
    "m=uniform(2,1)": "low must be below high",
    "m=1e999": "numbers must be finite",
    "m=__import__('os')": "values are linspace",
}


@pytest.mark.parametrize("text", REFUSED)
def test_words_that_mean_nothing(text: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert status("ensemble", ARM, "--vary", text) == 2
    assert REFUSED[text] in capsys.readouterr().err


COUNTS = {
    (
        "--vary",
        "waist=1,2,3",
        "--vary",
        "elbow=normal(0,1)",
        "--runs",
        "10",
    ): "not a multiple of the 3",
    ("--vary", "elbow=normal(0,1)"): "say of how many runs with --runs",
    ("--vary", "waist=1,2", "--runs", "4"): "have 2 combinations, all alike",
    ("--vary", "waist=1", "--vary", "waist=2"): "'waist' is given twice",
    (): "nothing differs between the runs",
    ("--vary", "waste=1,2"): "Did you mean 'waist'",
}


@pytest.mark.parametrize("words", COUNTS)
def test_runs_that_do_not_fit(words: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    assert status("ensemble", ARM, "--time", "0.1", *words) == 1
    assert COUNTS[words] in capsys.readouterr().err


def test_ctrl_c_says_what_is_kept_and_how_to_go_on(tmp_path: Path) -> None:
    path = tmp_path / "runs.part"
    words = [ARM, "--vary", "waist=uniform(-1, 1)", "--runs", "2000000", "--threads", "1"]
    command = [sys.executable, "-m", "cardan", "ensemble", *words, "--checkpoint", str(path)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as it:
        until = time.monotonic() + 120
        while not path.exists() or path.stat().st_size < 100_000:
            assert it.poll() is None
            assert time.monotonic() < until
            time.sleep(0.02)
        it.send_signal(signal.SIGINT)
        out, err = it.communicate(timeout=60)
    assert it.returncode == 130
    assert "not_run" in out
    assert re.search(r"cardan ensemble: interrupted when \d+ of 2000000 runs were done", err)
    assert re.search(r"\d+ runs are kept in .*runs.part, and the same call goes on", err)
    assert "Warning" not in err


def test_sensitivities(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Those of ``model.ensemble``; names between commas, or the option again."""
    words = ["ensemble", ARM, "--time", "0.1", "--vary", "waist=0,0.5", "--points", "3"]
    words += ["--sensitivity", "q0.elbow,u0", "--sensitivity", "gravity.z"]
    assert status(*words, "-o", str(tmp_path / "runs.nc"), "--json") == 0
    results = json.loads(capsys.readouterr().out)["results"]
    names = ("q0.elbow", "u0", "gravity.z")
    assert set(results) == {f"sensitivity to {name}" for name in names}
    runs = cd.load_ensemble(tmp_path / "runs.nc")
    direct = cd.compile(cd.load(ARM)).ensemble(
        np.linspace(0, 0.1, 3), vary={"waist": [0.0, 0.5]}, sensitivity=names
    )
    for name in names:
        np.testing.assert_array_equal(runs.sensitivity[name], direct.sensitivity[name])
    assert status(*words[:-1], "elbo") == 1
    assert "Did you mean 'u0.elbow'" in capsys.readouterr().err
    assert status(*words[:-1], "a,,b") == 2
