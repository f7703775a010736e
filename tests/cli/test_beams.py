"""Commands on scenes with beams."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from cardan.cli import main

SCENE = """\
cardan: 2
name: crane
bodies:
  load: {mass: 20, inertia: [0.1, 0.1, 0.1]}
beams:
  boom:
    start: ground
    end: [3, 0, 0]
    section: {tube: {outer: 0.05, inner: 0.04}}
    material: {E: 2.1e11, nu: 0.3, rho: 7850}
    elements: 3
joints:
  hook: {type: spherical, parent: boom.end, child: load}
"""


@pytest.fixture
def crane(tmp_path: Path) -> Path:
    path = tmp_path / "crane.yaml"
    path.write_text(SCENE, encoding="utf-8")
    return path


def test_check(crane: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", str(crane), "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == []
    crane.write_text(SCENE.replace("start: ground", "start: [0, 0, 0]"), encoding="utf-8")
    assert main(["check", str(crane)]) == 0
    assert "warning: beam 'boom' flies" in capsys.readouterr().out
    crane.write_text(SCENE.replace("boom.end", "boom.ende"), encoding="utf-8")
    assert main(["check", str(crane)]) == 1
    assert "crane.yaml:13:27: joints.hook.parent" in capsys.readouterr().out


def test_inspect(crane: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["inspect", str(crane)]) == 0
    text = capsys.readouterr().out
    assert "beam: ground == boom.end  [boom: 3 elements]" in text
    assert "b = Bᵀ sigma" in text
    assert "hellinger_reissner" in text
    assert main(["inspect", str(crane), "--json"]) == 0
    counts = json.loads(capsys.readouterr().out)["elements"]
    # the one on the ground is of a kind of its own
    assert sum(n for name, n in counts.items() if name.startswith("hellinger")) == 3
    page = crane.with_suffix(".html")
    assert main(["inspect", str(crane), "-o", str(page)]) == 0
    assert "hellinger_reissner" in page.read_text("utf-8")
    assert main(["inspect", str(crane), "-o", str(crane.with_suffix(".pdf"))]) == 1
    assert "pages end in .html, .tex, .md" in capsys.readouterr().err


def test_simulate(crane: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = crane.with_suffix(".html")
    words = ["simulate", str(crane), "--time", "1e-3", "--rtol", "1e-3", "--view", str(page)]
    assert main(words) == 0
    assert "boom.end.pz" in capsys.readouterr().out
    assert '"beams":[{"name":"boom"' in page.read_text(encoding="utf-8")


def test_simulate_goes_on_from_a_file(crane: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["simulate", str(crane), "--time", "1e-3", "--rtol", "1e-3", "--json"]
    words += ["--checkpoint", str(crane.with_suffix(".part"))]
    assert main(words) == 0
    first = capsys.readouterr().out
    assert main(words) == 0
    assert capsys.readouterr().out == first
    assert main([*words, "--rtol", "1e-4"]) == 1
    assert "belongs to another run" in capsys.readouterr().err
