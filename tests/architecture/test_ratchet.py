"""``ratchet.json`` holds counts of what shall become less: a commit may only lower them.

``pytest tests/architecture/test_ratchet.py --accept`` lowers what has become less.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from architecture.counts import circles, counts

RATCHET = Path(__file__).with_name("ratchet.json")
ACCEPT = "pytest tests/architecture/test_ratchet.py --accept"


def compared(new: dict[str, int], old: dict[str, int]) -> tuple[list[str], list[str]]:
    """Counts that rose and counts that fell, in words."""
    told = {name: f"{name}: {old[name]} -> {new[name]}" for name in old}
    rose = [told[name] for name in old if new[name] > old[name]]
    return rose, [told[name] for name in old if new[name] < old[name]]


def test_counts_only_fall(pytestconfig: pytest.Config) -> None:
    new, old = counts(), json.loads(RATCHET.read_text("utf-8"))
    assert set(new) == set(old)
    rose, fell = compared(new, old)
    assert not rose, f"these may only fall: {'; '.join(rose)}"
    if pytestconfig.getoption("--accept"):
        RATCHET.write_text(json.dumps(new, indent=1) + "\n", "utf-8")
        return
    assert not fell, f"these fell, keep it with {ACCEPT}: {'; '.join(fell)}"


def test_a_rise_and_a_fall_are_told_apart() -> None:
    assert compared({"a": 2, "b": 0, "c": 1}, {"a": 1, "b": 1, "c": 1}) == (
        ["a: 1 -> 2"],
        ["b: 1 -> 0"],
    )


def test_circles() -> None:
    ahead = {"a": {"b"}, "b": {"c"}, "c": {"a", "d"}, "d": {"e"}, "e": {"d"}, "f": {"a"}}
    assert sorted(map(sorted, circles(ahead))) == [["a", "b", "c"], ["d", "e"], ["f"]]
