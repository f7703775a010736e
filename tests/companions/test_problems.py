"""Problem sheets: their code cells run, and their answers hold.

``pytest tests/companions/test_problems.py --accept`` writes their figures anew.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from companions.pages import DOCS
from examples.page_pictures import labels

FOLDER = DOCS / "problems"
SHEETS = sorted(path for path in FOLDER.glob("*.md") if path.stem != "README")
CELL = re.compile(r"^```\{code-cell\} python\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def test_five_sheets_go_along_each_book() -> None:
    texts = [path.read_text("utf-8") for path in SHEETS]
    for book in ("Roberson and Schwertassek", "Géradin and Cardona"):
        assert sum(f"*Along {book}, " in text for text in texts) == 5
    index = (FOLDER / "README.md").read_text("utf-8")
    assert {path.name for path in SHEETS} == set(re.findall(r"\]\((\w+\.md)\)", index))


@pytest.mark.parametrize("sheet", SHEETS, ids=lambda path: path.stem)
def test_a_sheet_states_hints_and_checks(sheet: Path) -> None:
    text = sheet.read_text("utf-8")
    assert text.startswith("---\njupytext:\n")
    assert "<summary>Hints</summary>" in text
    assert "## Solution" in text
    cells = CELL.findall(text)
    assert len(cells) == text.count("```{code-cell}") == text.count("\n```\n")
    assert sum(len(re.findall(r"^ *assert ", cell, re.MULTILINE)) for cell in cells) >= 5


@pytest.mark.parametrize("sheet", SHEETS, ids=lambda path: path.stem)
def test_answers_hold(sheet: Path, tmp_path: Path, pytestconfig: pytest.Config) -> None:
    text = sheet.read_text("utf-8")
    program = "\n".join(CELL.findall(text))
    (tmp_path / "matplotlibrc").write_text("svg.hashsalt: cardan\n", "utf-8")
    environment = {**os.environ, "MPLBACKEND": "agg"}
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", program],
        cwd=tmp_path, env=environment, capture_output=True, text=True, check=False, timeout=300,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    figures = sorted(tmp_path.glob("*.svg"))
    shown = re.findall(r"!\[[^\]]+\]\(figures/([\w.]+)\)", text)
    assert [path.name for path in figures] == sorted(shown)
    for figure in figures:
        place = FOLDER / "figures" / figure.name
        if pytestconfig.getoption("--accept"):
            place.parent.mkdir(exist_ok=True)
            before, _, dated = figure.read_text("utf-8").partition(" <metadata>")
            place.write_text(before + dated.partition("</metadata>\n")[2], "utf-8")
        assert labels(place.read_text("utf-8")) == labels(figure.read_text("utf-8"))
