"""Companions to two books: every section has a row, every row is true.

``pytest tests/companions/test_companions.py --accept`` writes the pages anew.
"""

from __future__ import annotations

import ast
import io
import re
from contextlib import redirect_stdout
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from scipy.spatial.transform import Rotation

import cardan as cd
from companions import pages, scenes
from companions.pages import BOOKS, DOCS, ROOT, Row, compiled, rows, statements, subject

ACCEPT = "pytest tests/companions/test_companions.py --accept"
# calls in a group: a scene is compiled once for all calls on it
GROUPS = sorted({(b, r.data["on"]) for b in BOOKS for r in rows(b) if "on" in r.data})


@pytest.mark.parametrize("book", BOOKS)
def test_every_section_has_a_row(book: str) -> None:
    titles = pages.sections(book)
    numbers = [row["s"] for row in pages.companion(book)["rows"]]
    assert len(numbers) == len(set(numbers))
    assert set(numbers) <= set(titles), "rows of sections that the book does not have"
    for row in rows(book):
        assert row.data or row.parts, f"{row.number} {row.title} has no row"
        parent = row.number.rpartition(".")[0]
        assert not parent or parent in titles, f"{row.number} has no section above it"


@pytest.mark.parametrize("book", BOOKS)
def test_rows_are_complete(book: str) -> None:
    by_number = {row.number: row for row in rows(book)}
    for row in by_number.values():
        data = row.data
        assert set(data) <= pages.FIELDS, row.number
        if "as" in data:
            assert set(data) == {"s", "as"}, row.number
            assert "as" not in by_number[data["as"]].data, row.number
            assert by_number[data["as"]].data, row.number
        elif "lacks" in data:
            assert "call" not in data, row.number
        elif data:
            missing = pages.NEEDED - set(data)
            assert not missing, f"{row.number} lacks {missing}"
            assert data["holds"].strip(), row.number
            assert data["number"].strip(), row.number


def run(row: Row) -> None:
    """A call and what it must hold."""
    code = statements(row)
    tree = ast.parse(f"{code}\n{row.data['holds']}")
    names = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    space = {"cd": cd, "np": np, "sp": sp, "Rotation": Rotation, "scenes": scenes}
    space |= subject(row.data["on"])
    if names & {"model", "q", "u"}:
        space |= compiled(row.data["on"])
    exec(code, space)
    assert eval(row.data["holds"], space), f"{row.number}: {row.data['holds']}: {space['result']}"


@pytest.mark.filterwarnings("ignore::cardan.SolveWarning", "ignore::cardan.ModelWarning")
@pytest.mark.parametrize(("book", "scene"), GROUPS)
def test_calls_do_what_rows_say(
    book: str, scene: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for row in rows(book):
        if row.data.get("on") == scene:
            with redirect_stdout(io.StringIO()):
                run(row)


def anchors(page: Path) -> set[str]:
    text = re.sub(r"^```.*?^```", "", page.read_text("utf-8"), flags=re.DOTALL | re.MULTILINE)
    heads = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    return {pages.anchor(head.replace("`", "")) for head in heads}


@pytest.mark.parametrize("book", BOOKS)
def test_what_rows_name_exists(book: str) -> None:
    for row in rows(book):
        data = row.data
        if "theory" in data:
            file, _, place = data["theory"].partition("#")
            assert (DOCS / file).exists(), f"{row.number}: {file}"
            assert not place or place in anchors(DOCS / file), f"{row.number}: {file}#{place}"
        if "example" in data:
            assert (ROOT / "examples" / data["example"]).exists(), f"{row.number}"
        if "problem" in data:
            assert (DOCS / "problems" / f"{data['problem']}.md").exists(), f"{row.number}"
        if "test" in data:
            file, _, name = data["test"].partition("::")
            text = (ROOT / file).read_text("utf-8")
            assert f"\ndef {name or 'test_'}" in text, f"{row.number}: {data['test']}"
            if name:
                assert f"\ndef {name}(" in text, f"{row.number}: {data['test']}"


@pytest.mark.parametrize("page", sorted((DOCS / "companions").rglob("*.md")), ids=lambda p: p.name)
def test_links(page: Path) -> None:
    for link in re.findall(r"\]\(([^)\s]+)\)", page.read_text("utf-8")):
        file, _, place = link.partition("#")
        target = (page.parent / file).resolve() if file else page
        assert target.exists(), link
        if place and target.suffix == ".md":
            assert place in anchors(target), link


@pytest.mark.parametrize("book", BOOKS)
def test_pages_are_those_of_the_rows(book: str, pytestconfig: pytest.Config) -> None:
    place, text = DOCS / "companions" / f"{book}.md", pages.page(book)
    if pytestconfig.getoption("--accept"):
        place.write_text(text, "utf-8")
    assert place.read_text("utf-8") == text, ACCEPT
