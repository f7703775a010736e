"""Pages of docs are true: their Python runs and prints what they show; their links exist."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[2] / "docs"
PAGES = sorted(DOCS.glob("*.md"))
SHOWN = [
    pytest.param(page, id=page.stem)
    for page in PAGES
    if "```python" in page.read_text(encoding="utf-8")
]


@pytest.mark.parametrize("page", SHOWN)
def test_python_prints_what_is_shown(page: Path, tmp_path: Path) -> None:
    text = page.read_text(encoding="utf-8")
    blocks = re.findall(r"^```(\w*)\n(.*?)^```$", text, flags=re.DOTALL | re.MULTILINE)
    programs = [body for language, body in blocks if language == "python"]
    command = [sys.executable, "-c", "\n".join(programs)]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    for shown in (body for language, body in blocks if not language):
        assert shown.strip() in done.stdout, f"{page.name} shows:\n{shown}\n{done.stdout}"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_links(page: Path) -> None:
    links = re.findall(r"\]\(([^)#]+)[^)]*\)", page.read_text(encoding="utf-8"))
    missing = [x for x in links if "://" not in x and not (page.parent / x).exists()]
    assert not missing
