"""``cardan equilibrium``, ``statics``, ``modes`` and ``linearize``: numbers, files, messages."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from cardan.cli import main

SCENE = """\
cardan: 2
name: column
gravity: [0, 0, 0]
parameters: {P: 0, k: 2}
inputs: {torque: {}}
bodies:
  bar: {mass: 1, com: [0, 0, 0.5], inertia: [0.1, 0.1, 0.01]}
joints:
  foot: {type: revolute, axis: y, parent: ground, child: bar}
forces:
  spring: {type: joint_force, joint: foot, force: torque - k*q(foot)}
  load: {type: force, frame: {body: bar, at: [0, 0, 1]}, force: [0, 0, -P]}
"""


@pytest.fixture
def scene(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "column.yaml").write_text(SCENE, encoding="utf-8")
    return "column.yaml"


def status(*words: str) -> int:
    try:
        return main(words)
    except SystemExit as stop:
        return int(stop.code or 0)


def test_angles_in_parts_of_pi(scene: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert status("equilibrium", scene, "--lock", "foot=-pi/4") == 0
    assert "foot = -0.7853981634" in capsys.readouterr().out
    assert status("equilibrium", scene, "--lock", "foot=pie") == 2
    assert "'foot=pie' does not read JOINT=VALUE" in capsys.readouterr().err


def test_equilibrium(scene: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert status("equilibrium", scene, "--set", "torque=1") == 0
    assert "foot = 0.5" in capsys.readouterr().out
    assert status("equilibrium", scene, "--lock", "foot=0.25", "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert found["holding_forces"]["foot"] == pytest.approx(0.5)
    assert found["stable"] is True
    assert status("equilibrium", scene, "--set", "P=3", "--stable", "--json") == 0
    found = json.loads(capsys.readouterr().out)
    angle = found["q"]["foot"]
    assert 3 * np.sin(angle) == pytest.approx(2 * angle)
    assert found["stable"] is True


def test_no_equilibrium_is_1(scene: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert status("equilibrium", scene, "--set", "k=0", "--set", "torque=1") == 1
    said = capsys.readouterr()
    assert "nothing holds 'foot'" in said.err
    assert not said.out


def test_statics(scene: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("matplotlib")
    assert status("statics", scene, "--sweep", "P=0,3", "--plot", "path.png") == 0
    assert "stability changes at P = 2" in capsys.readouterr().out
    assert (tmp_path / "path.png").is_file()
    assert status("statics", scene, "--sweep", "foot=0,1", "--steps", "4", "--json") == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    np.testing.assert_allclose([row["holding_forces"]["foot"] for row in rows], [0, 0.5, 1, 1.5, 2])
    assert status("statics", scene, "--sweep", "P") == 2
    assert "NAME=FROM,TO" in capsys.readouterr().err
    assert status("statics", scene, "--sweep", "Q=0,1") == 1
    assert "no parameter or input 'Q'" in capsys.readouterr().err


def test_continuation(scene: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("matplotlib")
    follow = ("continuation", scene, "--vary", "P=0:3", "--bound", "foot=-1.4:1.4")
    assert status(*follow, "--branches", "1", "--plot", "path.png", "--axes", "P,foot") == 0
    assert "branch point 1: P = 2; 2 branches (1a, 1b)" in capsys.readouterr().out
    assert (tmp_path / "path.png").is_file()
    assert status(*follow, "--branches", "1", "--json") == 0
    branch = json.loads(capsys.readouterr().out)["branches"]["1a"]
    foot = np.array(branch["q"]["foot"])
    np.testing.assert_allclose(branch["values"]["P"], 2 * foot / np.sin(foot))
    assert status("continuation", scene, "--vary", "P=0,3") == 2
    assert "NAME=FROM:TO" in capsys.readouterr().err
    assert status("continuation", "four_bar", "--of", "positions", "--vary", "D=2:3") == 0
    assert "a dead point: 'D' turns back" in capsys.readouterr().out
    assert status(*follow, "--points", "3") == 1
    assert "after 3 points" in capsys.readouterr().out


def test_modes(scene: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert status("modes", scene, "--set", "P=1", "--view", "mode.html") == 0
    said = capsys.readouterr().out
    assert "1 mode\n" in said
    assert "wrote mode.html" in said
    assert "<script" in (tmp_path / "mode.html").read_text("utf-8")
    assert status("modes", scene, "--json") == 0
    (mode,) = json.loads(capsys.readouterr().out)["modes"]
    assert mode["eigenvalue"][1] == pytest.approx(np.sqrt(2 / 0.35))
    assert status("modes", scene, "--mode", "5", "--view", "mode.html") == 1
    assert "no mode 5" in capsys.readouterr().err


def test_linearize(scene: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert status("linearize", scene, "--output", "foot", "--json") == 0
    found = json.loads(capsys.readouterr().out)
    np.testing.assert_allclose(found["A"], [[0, 1], [-2 / 0.35, 0]], atol=1e-12)
    np.testing.assert_allclose(found["B"], [[0], [1 / 0.35]], atol=1e-12)
    assert found["states"] == ["foot", "foot.u"]
    assert found["inputs"] == ["torque"]
    assert status("linearize", scene, "--output", "fot") == 1
    assert "Did you mean 'foot'" in capsys.readouterr().err


def test_formulas_of_a_linear_model(scene: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert status("linearize", scene, "--symbolic", "--about", "foot=0") == 0
    printed = capsys.readouterr().out
    assert "M y'' + (D + G) y' + (K + N) y = B r,  y = foot" in printed
    assert "K = [-P*load.frame.position.z + k]" in printed
    words = ("--symbolic", "--json", "--about", "foot=phi", "--independent", "foot")
    assert status("linearize", scene, *words) == 0
    assert json.loads(capsys.readouterr().out)["K"] == [["-P*load.frame.position.z*cos(phi) + k"]]
    assert status("linearize", scene, "--about", "foot=0") == 1
    assert "go with --symbolic" in capsys.readouterr().err
    for words in (("--vary", "k=1,2"), ("--target", "foot=0"), ("--plot", "x.png")):
        assert status("linearize", scene, "--symbolic", *words) == 1
        assert f"{words[0]} does not go with --symbolic" in capsys.readouterr().err
    assert status("linearize", scene, "--symbolic", "--about", "foot=") == 2


def test_trim(scene: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert status("trim", scene, "--target", "foot=0.25", "--free", "torque", "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert found["free"]["torque"] == pytest.approx(0.5)
    assert found["stable"] is True
    assert status("trim", scene, "--target", "foot=0.25", "--free", "k", "--set", "torque=1") == 0
    assert "k = 4  (free)" in capsys.readouterr().out
    assert status("trim", scene, "--target", "foot=0.25") == 1
    assert "no steady motion" in capsys.readouterr().err
    assert status("trim", scene, "--lock", "foot=0.25") == 1
    assert "--free JOINT.driving_force" in capsys.readouterr().err


def test_families(scene: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("matplotlib")
    assert status("linearize", scene, "--vary", "P=linspace(0, 3, 7)", "--plot", "l.png") == 0
    assert "divergence begins at P = 2" in capsys.readouterr().out
    assert (tmp_path / "l.png").is_file()
    assert status("linearize", scene, "--vary", "P=0,3", "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert found["stability_changes"][0]["values"]["P"] == pytest.approx(2)
    assert len(found["stable"]) == len(found["eigenvalues"]) == 31
    assert status("linearize", scene, "--sensitivity", "k", "--json") == 0
    change = json.loads(capsys.readouterr().out)["derivatives"]["k"][0]
    # w = sqrt(k / J)
    assert change == pytest.approx([0, 0.5 / np.sqrt(2 * 0.35)], abs=1e-9)
    assert status("linearize", scene, "--target", "foot=0.3", "--free", "torque") == 0
    assert "frequency" in capsys.readouterr().out
    assert status("linearize", scene, "--vary", "foot=0,30", "--campbell", "--json") == 0
    # a bar turned past its spring is not a rotor: nothing else moves
    assert json.loads(capsys.readouterr().out)["critical"] == []
    assert status("linearize", scene, "--campbell") == 1
    assert "say what changes" in capsys.readouterr().err
    assert status("linearize", scene, "--vary", "P=normal(0, 1)") == 1
    assert "not chances" in capsys.readouterr().err
