"""The README is true to the letter: its Python runs, its commands and links exist."""

from __future__ import annotations

import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from cardan.cli import build_parser
from table import each

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")


def test_the_way_in_is_short() -> None:
    assert len(TEXT.splitlines()) <= 45
    assert "when not to use it" in TEXT


def test_python_block(tmp_path: Path) -> None:
    (program,) = re.findall(r"```python\n(.*?)```", TEXT, flags=re.DOTALL)
    (tmp_path / "examples").mkdir()
    shutil.copy(ROOT / "examples" / "lug.inp", tmp_path / "examples")
    command = [sys.executable, "-c", program]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "Matrix" in done.stdout
    for page in ("pendulum", "robot"):
        assert (tmp_path / f"{page}.html").is_file()


@pytest.mark.parametrize("target", re.findall(r"make (\w+)", TEXT))
def test_make_targets(target: str) -> None:
    assert re.search(rf"^{target}:", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)


@pytest.mark.parametrize("line", re.findall(r"`cardan ([^`]+)`", TEXT))
def test_command_lines(line: str) -> None:
    words = shlex.split(line)
    assert build_parser(words[0]).parse_args(words).command == words[0]


@each("link", re.findall(r"\]\(([^)]+)\)", TEXT))
def test_links(link: str) -> None:
    assert (ROOT / link).exists()
