"""Mutants of entries of the compile cache: what is damaged is made anew."""

from __future__ import annotations

from pathlib import Path

import pytest

from hostile.harness import campaign
from hostile.kinds import ENTRIES, entry

SEED = 29


@pytest.mark.parametrize("name", ENTRIES)
def test_mutants_of_entries_of_a_cache_do_no_harm(name: str, tmp_path: Path) -> None:
    tally = campaign(entry(name, tmp_path / "good"), 50, SEED, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)


@pytest.mark.slow
@pytest.mark.parametrize("name", ENTRIES)
def test_two_thousand_mutants_of_entries_of_a_cache(name: str, tmp_path: Path) -> None:
    tally = campaign(entry(name, tmp_path / "good"), 2000, SEED + 1, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)
