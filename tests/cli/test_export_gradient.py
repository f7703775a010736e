"""``cardan export --gradient``: the gradient of a cost, on the command line."""

from __future__ import annotations

import filecmp
from pathlib import Path

import pytest

import cardan as cd
from cardan.cli import main

SCENE = str(Path(cd.__file__).parent / "scenes" / "cart_pole.yaml")


def status(*words: str) -> int:
    try:
        return main(words)
    except SystemExit as stop:
        return int(stop.code or 0)


def test_it_is_the_export_of_python(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    model, coordinate = cd.derive(cd.load(SCENE)), "rail"
    words = ("export", SCENE, "--language", "c", "--integrators", "rk4")
    cost = ("--gradient", f"{coordinate}^2", "--running", f"{coordinate}.u^2")
    assert status(*words, "-o", str(tmp_path / "typed"), *cost) == 0
    model.export(
        tmp_path / "called", language="c", integrators=["rk4"],
        gradient=cd.cost(final=f"{coordinate}^2", running=f"{coordinate}.u^2"),
    )  # fmt: skip
    files = sorted(path.name for path in (tmp_path / "called").iterdir() if path.is_file())
    assert "motion_gradient.h" in files
    same = filecmp.cmpfiles(tmp_path / "typed", tmp_path / "called", files, shallow=False)[0]
    assert sorted(same) == files
    capsys.readouterr()
    assert status("export", SCENE, "-o", str(tmp_path / "none"), "--running", coordinate) == 1
    assert "name its method" in capsys.readouterr().err
