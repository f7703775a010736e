"""``cardan continuation``: cycles and their starts, pages, files and reports."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq

from cardan.cli import main

DUFFING = """\
cardan: 2
name: duffing
gravity: [0, 0, 0]
parameters: {omega: 1.4, c: 0.1}
inputs: {more: {}}
bodies: {mass: {mass: 1}}
joints:
  x: {type: prismatic, axis: x, parent: ground, child: mass}
forces:
  force: {type: joint_force, joint: x, force: "0.5*cos(omega*t) - c*u(x) - q(x) - q(x)^3 + more"}
"""
# x'' = mu x' (1 - x^2) - x: a Hopf point at mu = 0
ROTOR = """\
cardan: 2
name: rotor
gravity: [0, 0, 0]
parameters: {speed: 0}
bodies: {mass: {mass: 1}}
joints:
  x: {type: prismatic, axis: x, parent: ground, child: mass}
forces:
  force: {type: joint_force, joint: x, force: "(speed - 1)*u(x) - u(x)*q(x)^2 - q(x)"}
"""
# a ball on a floor: a push along its motion gives back what impacts take
BALL = """\
cardan: 2
name: ball
gravity: [0, 0, -9.81]
parameters: {gain: 0.5}
bodies: {ball: {mass: 1}}
joints:
  z: {type: prismatic, axis: z, parent: ground, child: ball}
forces:
  floor: {type: stop, joint: z, lower: 0, restitution: 0.5}
  drive: {type: joint_force, joint: z, force: gain*u(z)}
simulate: {q: {z: 0}, u: {z: 14}}
"""
FORCED = ("--of", "cycles", "--period", "2*pi/omega", "--settle", "20")


@pytest.fixture(autouse=True)
def scenes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for name, text in (("duffing", DUFFING), ("rotor", ROTOR), ("ball", BALL)):
        Path(f"{name}.yaml").write_text(text, encoding="utf-8")


def status(*words: str) -> int:
    try:
        return main(("continuation", *words))
    except SystemExit as stop:
        return int(stop.code or 0)


def test_forced_cycles(capsys: pytest.CaptureFixture[str]) -> None:
    """The folds of the resonance, as AUTO has them in tests of paths of cycles."""
    follow = ("duffing.yaml", *FORCED, "--vary", "omega=0.7:3", "--q", "x=0.6")
    assert status(*follow) == 0
    said = capsys.readouterr().out
    assert "fold 1: omega = 2.2119353" in said
    assert "fold 2: omega = 1.4386701" in said
    assert status(*follow, "--json", "--report", "--save", "path.npz") == 0
    found = json.loads(capsys.readouterr().out)
    branch = found["branches"]["main"]
    np.testing.assert_allclose(branch["period"], 2 * np.pi / np.array(branch["values"]["omega"]))
    assert branch["multiplier"][0] == pytest.approx(np.exp(-0.05 * branch["period"][0]))
    assert branch["points"][0]["accurate"] is True
    assert branch["points"][0]["frequency"] is None
    assert found["report"]["branches"][0]["residual"] < 1e-9
    assert found["files"] == ["path.npz"]
    assert Path("path.npz").is_file()


def test_where_a_forced_cycle_is_looked_for(capsys: pytest.CaptureFixture[str]) -> None:
    """Inputs and parameters: what varies begins at its first value, the rest is as set."""
    words = ("duffing.yaml", *FORCED, "--set", "omega=0.7", "--set", "c=0.2", "--json")
    assert status(*words, "--vary", "more=0:0.1") == 0
    branch = json.loads(capsys.readouterr().out)["branches"]["main"]
    assert [branch["values"]["more"][k] for k in (0, -1)] == pytest.approx([0, 0.1])
    assert branch["multiplier"][0] == pytest.approx(np.exp(-0.1 * 2 * np.pi / 0.7), rel=1e-6)


def test_cycles_from_a_hopf_point(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("matplotlib")
    words = ("rotor.yaml", "--of", "cycles", "--vary", "speed=0:1.5", "--hopf", "--plot", "x.png")
    assert status(*words) == 0
    said = capsys.readouterr().out
    assert "reached speed = 1.5" in said
    assert "wrote x.png" in said
    assert status(*words[:-2], "--json") == 0
    branch = json.loads(capsys.readouterr().out)["branches"]["main"]
    # B. van der Pol: close to speed = 1 the amplitude is 2 sqrt(speed - 1), the period 2 pi
    assert branch["values"]["speed"][0] == pytest.approx(1.0, abs=1e-2)
    assert branch["period"][0] == pytest.approx(2 * np.pi, rel=1e-3)
    assert branch["stable"][0] is True
    assert status(*words[:-3], "--hopf", "2") == 1
    assert "--hopf 2: the equilibria have 1 Hopf point" in capsys.readouterr().err


def test_a_limit_cycle_next_to_a_state(capsys: pytest.CaptureFixture[str]) -> None:
    words = ("rotor.yaml", "--of", "cycles", "--vary", "speed=1.5:1.2", "--q", "x=1.4")
    assert status(*words, "--settle", "5", "--guess", "6.3") == 0
    assert "reached speed = 1.2" in capsys.readouterr().out
    assert status(*words[:-2]) == 1
    assert "the start is at rest" in capsys.readouterr().err


def test_cycles_of_a_mode_by_energy(capsys: pytest.CaptureFixture[str]) -> None:
    words = ("double_pendulum", "--of", "cycles", "--vary", "energy=0:0.5")
    assert status(*words, "--mode", "0", "--json") == 0
    branch = json.loads(capsys.readouterr().out)["branches"]["main"]
    assert branch["values"]["energy"][-1] == pytest.approx(0.5)
    # the period of a pendulum grows with its amplitude
    assert np.all(np.diff(branch["period"]) > 0)
    assert status(*words, "--mode", "2") == 1
    assert "no mode 2" in capsys.readouterr().err
    assert status(*words, "--mode", "0", "--period", "2") == 1
    assert "--period is of a cycle that is looked for" in capsys.readouterr().err


def test_laps_that_events_end(capsys: pytest.CaptureFixture[str]) -> None:
    """v' = k v - g: in 3 a / k the speed of a flight doubles, (1 - a) (exp 3 a - 1) = 3 a."""
    words = ("ball.yaml", "--of", "cycles", "--vary", "gain=0.5:0.6", "--section", "floor.lower")
    assert status(*words, "--json") == 0
    branch = json.loads(capsys.readouterr().out)["branches"]["main"]
    a = brentq(lambda a: (1 - a) * np.expm1(3 * a) - 3 * a, 0.5, 0.9)
    np.testing.assert_allclose(branch["period"], 3 * a / np.array(branch["values"]["gain"]))
    assert not any(branch["stable"])
    assert status(*words[:-1], "flor") == 1
    assert "there is no event 'flor'" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--period", "2"), "--period says where cycles start: it goes with --of cycles"),
        (("--of", "cycles", "--mode", "0", "--hopf"), "leave one out"),
        (("--of", "cycles", "--hopf", "--settle", "3"), "--settle is of a cycle that is looked"),
        (("--of", "cycles", "--lock", "x=0"), "--lock does not go with --of cycles"),
        (("--of", "cycles", "--vary", "x=0:1"), "'x' is a coordinate"),
        (("--of", "cycles", "--period", "2*pi/omga"), "omga"),
        (("--of", "cycles", "--period", "6", "--section", "force"), "both end a lap"),
        (("--of", "cycles", "--period", "1.234"), "does not have this period"),
        (("--of", "cycles", "--settle", "1"), "give --period"),
        (
            ("--of", "cycles", "--period", "6", "--u", "y=1"),
            "'y' has 0 speeds, not 1. Known: x, x.u",
        ),
    ],
)
def test_what_does_not_go_is_1(
    words: tuple[str, ...], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert status("duffing.yaml", "--vary", "omega=0.7:3", *words) == 1
    assert message in capsys.readouterr().err


def test_options_that_do_not_read_are_2(capsys: pytest.CaptureFixture[str]) -> None:
    follow = ("duffing.yaml", "--vary", "omega=0.7:3")
    assert status(*follow, "--of", "orbits") == 2
    assert status(*follow, "--of", "cycles", "--settle", "0") == 2
    assert status(*follow, "--explain", "page.pdf") == 2
    assert "does not end in .html or .md or .tex" in capsys.readouterr().err
    assert status(*follow, "--save", "path.xls") == 2


def test_pages_files_and_reports(capsys: pytest.CaptureFixture[str]) -> None:
    follow = ("four_bar", "--of", "positions", "--vary", "D=2:3")
    more = ("--explain", "page.html", "--axes", "D,B", "--save", "path.csv", "--report")
    assert status(*follow, *more) == 0
    said = capsys.readouterr().out
    assert "wrote page.html" in said
    assert "wrote path.csv" in said
    assert "paths of positions" in said
    assert "residual: what loops, drivers and locks miss" in " ".join(said.split())
    assert "B over D." in Path("page.html").read_text("utf-8")
    with Path("path.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert {"branch_name", "D", "B"} <= set(rows[0])
    assert status(*follow, "--axes", "D,E", "--explain", "page.md") == 1
    assert "there is no 'E'" in capsys.readouterr().err
