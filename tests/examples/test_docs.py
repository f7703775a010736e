"""Pages of docs are true: their Python runs and prints what they show; commands and links exist.

In what a page shows ``...`` stands for what differs between machines and runs.
"""

from __future__ import annotations

import inspect
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import cardan as cd
from cardan.analyses.simulation import outcome
from cardan.cli import build_parser
from cardan.runtime.trajectory.solver_info import EVENT, FINISHED
from examples.page_pictures import labels
from table import each

DOCS = Path(__file__).parents[2] / "docs"
PAGES = sorted(DOCS.glob("*.md"))
SHOWN = [
    pytest.param(page, id=page.stem)
    for page in PAGES
    if "```python" in page.read_text(encoding="utf-8")
]
# files that programs of a page read
FILES = {
    "superelements": [
        *sorted((DOCS.parent / "tests/superelements/files").glob("bar.*")),
        DOCS.parent / "examples/lug.inp",
    ]
}
# `cardan NAME` alone speaks of a command; with its file, or indented, it can be typed
COMMANDS = sorted(
    line
    for page in [*PAGES, *(DOCS / "performance").glob("*.md")]
    for line in re.findall(
        r"^    cardan (.+)$|`cardan (\w+ [\w.]*(?:FILE|\.yaml|\.urdf)[^`]*)`",
        page.read_text(encoding="utf-8"),
        re.MULTILINE,
    )
    for line in line
    if line
)


@pytest.mark.parametrize("page", SHOWN)
def test_python_prints_what_is_shown(page: Path, tmp_path: Path) -> None:
    text = page.read_text(encoding="utf-8")
    blocks = re.findall(r"^```(\w*)\n(.*?)^```$", text, flags=re.DOTALL | re.MULTILINE)
    programs = [body for language, body in blocks if language == "python"]
    for file in FILES.get(page.stem, []):
        shutil.copy(file, tmp_path)
    command = [sys.executable, "-c", "\n".join(programs)]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    for shown in (body for language, body in blocks if not language):
        pattern = re.escape(shown.strip()).replace(re.escape("..."), ".*")
        assert re.search(pattern, done.stdout), f"{page.name} shows:\n{shown}\n{done.stdout}"
    for picture in tmp_path.glob("*.svg"):
        kept = DOCS / picture.name
        if kept.exists():
            assert labels(kept.read_text("utf-8")) == labels(picture.read_text("utf-8"))


@each("line", COMMANDS)
def test_commands_can_be_typed(line: str) -> None:
    words = shlex.split(line)
    assert build_parser(words[0]).parse_args(words).command == words[0]


@each("page", PAGES)
def test_links(page: Path) -> None:
    links = re.findall(r"\]\(([^)#]+)[^)]*\)", page.read_text(encoding="utf-8"))
    missing = [x for x in links if "://" not in x and not (page.parent / x).exists()]
    assert not missing


def test_the_table_of_statuses_is_that_of_the_runs() -> None:
    page = (DOCS / "events.md").read_text(encoding="utf-8")
    told = {name for row in re.findall(r"^\| (`.*?`) \|", page, re.MULTILINE) for name in
            re.findall(r"`(\w+)`", row)}  # fmt: skip
    source = inspect.getsource(outcome)
    assert told >= {FINISHED, EVENT, *re.findall(r'return "(\w+)", ', source)}


def test_the_table_of_modes_is_that_of_the_elements() -> None:
    page = (DOCS / "forces.md").read_text(encoding="utf-8")
    body = cd.Scene("scene").body("ball", mass=1.0)
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
