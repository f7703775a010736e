"""``cardan parts``: listed, explained, written."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import cardan as cd
from cardan.cli import main
from cardan.parts import PARTS


def status(*words: str) -> int:
    try:
        return main(words)
    except SystemExit as stop:
        return int(stop.code or 0)


def test_parts_are_listed_and_explained(capsys: pytest.CaptureFixture[str]) -> None:
    assert status("parts") == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == list(PARTS)
    assert status("parts", "four_bar") == 0
    shown = capsys.readouterr().out
    assert "crank_length, coupler_length, rocker_length: Lengths of the links [m]." in shown
    assert "model 'four_bar': 3 bodies" in shown


def test_parts_are_told_to_programs(capsys: pytest.CaptureFixture[str]) -> None:
    assert status("parts", "--json") == 0
    told = json.loads(capsys.readouterr().out)
    assert list(told) == list(PARTS)
    assert status("parts", "slider_crank", "--set", "offset=0.01", "--json") == 0
    crank = json.loads(capsys.readouterr().out)
    assert crank["parameters"]["offset"] == {"value": 0.01, "unit": "m"}
    assert crank["outputs"]["piston.x"] == "m"
    assert {**crank, "parameters": 0} == {**told["slider_crank"], "parameters": 0}


def test_a_part_is_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "new" / "gear.yaml"
    words = ["parts", "planetary_gear", "--set", "fixed=sun", "--set", "planets=5"]
    assert status(*words, "--set", "gear_module=0.002", "-o", str(path)) == 0
    assert f"cardan simulate {path}" in capsys.readouterr().out
    scene = cd.load(path)
    assert "planet5" in scene.joints
    assert scene.parameters["gear_module"].value == 0.002
    hub = ["parts", "double_wishbone", "--set", "wheel_center=0,0.8,0.01"]
    assert status(*hub, "-o", str(path)) == 0
    assert cd.load(path).parameters["wheel_center.y"].value == 0.8


WRONG = {
    "no such part": (["nix"], 1, "there is no part 'nix'"),
    "no such number": (["four_bar", "--set", "crank=1"], 1, "Did you mean 'crank_mass'"),
    "no part": (["--set", "lift=1"], 2, "name the PART"),
    "no value": (["four_bar", "--set", "lift"], 2, "does not read NAME=VALUE"),
    "another file": (["four_bar", "-o", "a.txt"], 2, "does not end in .yaml"),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_is_refused(case: str, capsys: pytest.CaptureFixture[str]) -> None:
    words, code, message = WRONG[case]
    assert status("parts", *words) == code
    assert message in capsys.readouterr().err
