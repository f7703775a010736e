"""docs/architecture.md speaks of files that exist, and its picture is that of the imports."""

from __future__ import annotations

import re

import pytest

from architecture.picture import PATH, svg
from architecture.sources import PACKAGE, ROOT

PAGE = (ROOT / "docs" / "architecture.md").read_text("utf-8")
NAMED = re.compile(r"`((?:src/cardan/)?[\w/]+(?:\.(?:py|pyi|c|h)|/))`")


def test_the_picture_is_that_of_the_imports(pytestconfig: pytest.Config) -> None:
    if pytestconfig.getoption("--accept"):
        PATH.write_text(svg(), "utf-8")
    assert PATH.read_text("utf-8") == svg(), "python tests/architecture/picture.py draws it"


def test_every_file_that_the_page_names_exists() -> None:
    names = NAMED.findall(PAGE)
    assert len(names) > 80
    # folders in the table of rooms stand behind the name of their room
    rooms = re.findall(r"^\| `(\w+)` \| (.*)$", PAGE, re.M)
    inside = {f"{room}/{name}" for room, text in rooms for name in NAMED.findall(text)}
    listed = {name for _, text in rooms for name in NAMED.findall(text)}
    paths = [*(set(names) - listed), *inside]
    missing = [one for one in paths if not any((root / one).exists() for root in (ROOT, PACKAGE))]
    assert not missing


def test_every_table_that_the_page_names_exists() -> None:
    tables = set(re.findall(r"`([A-Z]{4,})`", PAGE))
    texts = [path.read_text("utf-8") for path in PACKAGE.rglob("__init__.py")]
    missing = [one for one in tables if not any(re.search(rf"^{one}\b", t, re.M) for t in texts)]
    assert len(tables) > 8
    assert not missing
