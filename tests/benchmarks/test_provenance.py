"""No page of measurements is older than the code without saying so."""

from __future__ import annotations

from pathlib import Path

import pytest

from benchmarks import provenance
from benchmarks.provenance import OLDER, current, mark, pages, signed
from cardan.peers.processor import name


@pytest.mark.parametrize("page", pages(), ids=lambda page: page.name)
def test_pages_are_current_or_say_that_they_are_not(page: Path) -> None:
    assert current(page.read_text("utf-8")), "run: python tests/benchmarks/provenance.py"


def test_all_pages_of_measurements_are_looked_at() -> None:
    names = {page.name for page in pages()}
    assert names >= {"README.md", "runs.md", "flexible.md", "sympy.md", "hard_cases.md"}


def test_a_change_of_the_source_is_seen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    source, folder = tmp_path / "source", tmp_path / "docs" / "performance"
    source.mkdir()
    folder.mkdir(parents=True)
    (source / "step.c").write_text("int step;\n")
    monkeypatch.setattr(provenance, "SOURCE", source)
    monkeypatch.setattr(provenance, "DOCS", folder.parent)
    page = folder / "runs.md"
    page.write_text(signed("# Runs\n\nFigures.\n"))
    assert mark() == []
    (source / "notes.txt").write_text("not part of it\n")
    assert mark() == []
    (source / "step.c").write_text("int other;\n")
    assert not current(page.read_text())
    assert mark() == ["runs.md"]
    # where a reader begins, and once
    assert page.read_text().startswith(f"# Runs\n\n{OLDER}\n\nFigures.\n")
    assert mark() == []
    # measured again
    assert f"Measured on {name()}, " in signed("# Runs\n")
    page.write_text(signed("# Runs\n"))
    assert OLDER not in page.read_text()
    assert mark() == []
