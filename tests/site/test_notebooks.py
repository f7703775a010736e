"""The notebook of the first hour runs within a minute, a picture in each of its ten steps."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

PAGE = Path(__file__).parents[2] / "docs" / "site" / "first_hour.md"
STEP = re.compile(r"^## (\d+)\. ", re.MULTILINE)
CELL = re.compile(r"^```\{code-cell\}[^\n]*\n(.*?)^```$", re.MULTILINE | re.DOTALL)
# what the last line of a cell must be for a picture to appear below it
PICTURE = re.compile(r"(\w+\.(animate|plot|page)\(.*\)|.*\.graph|axes\.set\(.*\);)")


def test_ten_steps_with_pictures() -> None:
    parts = STEP.split(PAGE.read_text(encoding="utf-8"))
    assert parts[1::2] == [str(n) for n in range(1, 11)]
    for number, text in zip(parts[1::2], parts[2::2], strict=True):
        last = [cell.splitlines()[-1] for cell in CELL.findall(text)]
        assert any(map(PICTURE.fullmatch, last)), f"step {number}"


def test_the_first_hour_runs(tmp_path: Path) -> None:
    program = "\n".join(CELL.findall(PAGE.read_text(encoding="utf-8")))
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True,
        check=False, timeout=60, env={**os.environ, "MPLBACKEND": "agg"},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    match = re.search(r"torques differ by (\S+) N m", done.stdout)
    assert match is not None
    assert float(match[1]) < 1e-12
