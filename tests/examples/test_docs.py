"""Pages of docs are true: their Python runs and prints what they show; their links exist."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

import cardan as cd

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


def test_the_table_of_modes_is_that_of_the_elements() -> None:
    page = (DOCS / "forces.md").read_text(encoding="utf-8")
    body = cd.Model("scene").body("ball", mass=1.0)
    elements = (
        cd.Friction("x", coulomb=1.0),
        cd.Stop("x", lower=0.0),
        cd.Lock("x", when=1.0),
        cd.Contact(body, body, radius=0.1, stiffness=1e5),
    )
    table = page[page.index("| element | its mode") :]
    for element in elements:
        (mode,) = element.modes()
        found = re.search(rf"^\| `{type(element).__name__}` \| (.*) \|$", table, re.MULTILINE)
        assert found is not None
        assert set(found[1].split(", ")) == {f"{value} {words}" for value, words in mode.labels}
