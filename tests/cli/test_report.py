"""``cardan report``: table, advice, files, JSON."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from cardan.cli import main

ARM = str(Path(__file__).parents[2] / "examples" / "arm.urdf")
WORDS = (
    "report",
    ARM,
    "--time",
    "0.2",
    "--q",
    "elbow=0.5",
    "--methods",
    "DOP853",
    "RKMK853",
    "RK4",
)


def status(*words: str) -> int:
    try:
        return main(words)
    except SystemExit as stop:
        return int(stop.code or 0)


def test_table_advice_and_page(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "new" / "arm.html"
    assert status(*WORDS, "-o", str(file)) == 0
    said = capsys.readouterr().out
    assert "DOP853" in said
    assert "RKMK853: the same as DOP853: no joint here turns by a quaternion" in said
    assert "for an error of 1e-06: " in said
    assert f"wrote {file}" in said
    page = file.read_text("utf-8")
    assert "<svg" in page
    assert "http://" not in page.split("</svg>")[1]
    assert "for an error of 1e-06: " in page


def test_picture_and_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "arm.png"
    assert status(*WORDS, "-o", str(file), "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert found["time"] == [0.0, 0.2]
    assert {point["method"] for point in found["points"]} == {"DOP853", "RK4"}
    assert all(point["error"] is not None for point in found["points"])
    assert found["files"] == [str(file)]
    assert file.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--methods", "DOP583"), "invalid choice: 'DOP583'"),
        (("-o", "arm.csv"), "does not end in .html"),
        (("--patience", "-1"), "-1 is not a positive number"),
    ],
)
def test_wrong_use(words: tuple[str, ...], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert status("report", ARM, *words) == 2
    assert said in capsys.readouterr().err


def test_a_start_that_is_not_there_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    assert status("report", ARM, "--time", "0.1", "--q", "elbw=1") == 1
    assert "Did you mean 'elbow'" in capsys.readouterr().err
