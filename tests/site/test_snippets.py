"""The examples of the reference run, program by program."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PROGRAMS = sorted((ROOT / "docs" / "site" / "snippets").glob("*.py"))
FILES = [*(ROOT / "tests/superelements/files").glob("bar.*"), ROOT / "examples/lug.inp"]


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.stem)
def test_program(program: Path, tmp_path: Path) -> None:
    for file in FILES:
        shutil.copy(file, tmp_path)
    command = [sys.executable, str(program)]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
