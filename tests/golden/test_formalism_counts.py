"""The table of operations in docs/formalisms.md is that of the formalisms as they are.

``pytest tests/golden/test_formalism_counts.py --accept`` writes the rows that ran anew, and the
page; ``python tests/golden/formalism_counts.py`` writes all.
"""

from __future__ import annotations

import pytest

from cardan.equations.formalisms import FORMALISMS
from golden.formalism_counts import BEGIN, CASES, END, PAGE, counted, kept, shown, write
from spread import some

ACCEPT = "pytest tests/golden/test_formalism_counts.py --accept"


@pytest.mark.parametrize("name", some(CASES, 15))
def test_counts(name: str, pytestconfig: pytest.Config) -> None:
    row, table = counted(CASES[name]), kept()
    if pytestconfig.getoption("--accept"):
        write({**table, name: row})
        return
    assert name in table, f"{name} is new: {ACCEPT}"
    changed = {
        f"{method}: {key}": (table[name].get(method, {}).get(key), now)
        for method, counts in row.items()
        for key, now in counts.items()
        if table[name].get(method, {}).get(key) != now
    }
    assert not changed, f"{name}: (kept, now) {changed}; keep it with {ACCEPT}"


def test_the_page_shows_the_table() -> None:
    text, table = PAGE.read_text("utf-8"), kept()
    assert text.partition(BEGIN)[2].partition(END)[0] == shown(table)
    assert list(table) == list(CASES)
    assert all(f"## `{name}`" in text for name in FORMALISMS)


def test_no_formalism_explodes() -> None:
    """Differentiated energies take a few times the operations of the best recursion, not more."""
    for name, row in kept().items():
        counts = {m: row[m]["inverse_dynamics"] for m in FORMALISMS}
        assert max(counts.values()) <= 30 * min(counts.values()) + 200, (name, counts)
