"""``cardan check`` and ``cardan inspect`` of scene files with superelements."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import cardan as cd
from cardan.cli import main
from superelements.components import brick


@pytest.fixture
def file(tmp_path: Path) -> Path:
    scene = cd.Scene("lever")
    scene.superelement("arm", brick(modes=1), {"root": scene.ground.at(0, 0, 1)}, frame="root")
    scene.save(tmp_path / "lever.yaml")
    return tmp_path / "lever.yaml"


def test_check(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", str(file)]) == 0
    assert "0 errors, 0 warnings, 0 notes" in capsys.readouterr().err
    text = file.read_text("utf-8")
    file.write_text(text.replace("frame: root", "frame: rot"), "utf-8")
    assert main(["check", str(file)]) == 1
    said = capsys.readouterr().out
    assert said.startswith("error: lever.yaml:7:3: superelement 'arm': ")
    assert "there is no frame 'rot'. Known: mean, chord, root, tip. Did you mean 'root'?" in said
    (file.parent / "lever.arm.npz").unlink()
    assert main(["check", str(file)]) == 1
    assert "there is no file 'lever.arm.npz' below the folder" in capsys.readouterr().out


def test_inspect(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["inspect", str(file)]) == 0
    said = capsys.readouterr().out
    assert "arm.tip  [arm.tip: elastic]" in said
    assert "potential energy: V = (z · K z) / 2 - g · (m p + R s)" in said
    assert "Routines of the kernels compute it, in superelement.h" in said
    assert main(["inspect", str(file), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["elements"]["superelement"] == 1
    page = file.with_suffix(".html")
    assert main(["inspect", str(file), "-o", str(page)]) == 0
    assert "thick: what is inside of a flexible body" in page.read_text("utf-8")
