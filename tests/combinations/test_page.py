"""The page of what goes with what is that of the features, integrators and uses there are."""

from __future__ import annotations

import pytest

from cardan.schema.integrators import INTEGRATORS

from . import cells, page
from .features import PRESENT


def test_rows_and_columns_are_those_there_are() -> None:
    text = page.PAGE.read_text("utf-8")
    for columns in (INTEGRATORS, cells.USES):
        assert text.count(f"| | {' | '.join(columns)} |") == 2, page.SCRIPT
    for name in PRESENT:
        assert text.count(f"\n| {name} |") == 4, page.SCRIPT
    # it can be read, so that some of its features can be tried anew
    assert page.page(*page.stated(text)) == text


def test_a_feature_of_the_page_is_up_to_date() -> None:
    said = {(n, asked): s for n, asked, s in cells.of_feature("PID", cells.RIGID)}
    letters, marks = page.Letters(), {}
    for (name, asked), message in said.items():
        marks[asked] = bool(letters.of((name,), asked, message) != "·")
    rows = [x for x in page.PAGE.read_text("utf-8").splitlines() if x.startswith("| PID |")]
    for row, columns in ((rows[0], INTEGRATORS), (rows[2], cells.USES)):
        there = [mark.strip() != "·" for mark in row.split("|")[2:-1]]
        assert there == [marks[name] for name in columns], page.SCRIPT


@pytest.mark.slow
def test_the_page_is_up_to_date() -> None:
    assert page.page(*page.measured()) == page.PAGE.read_text("utf-8"), page.SCRIPT
