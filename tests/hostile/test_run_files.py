"""Mutants of files of runs: damage is found, and malice does no harm."""

from __future__ import annotations

from pathlib import Path

import pytest

from hostile.harness import campaign
from hostile.kinds import RUNS, run
from spread import some

SEED = 17


@pytest.mark.parametrize("name", some(RUNS, every=4))
def test_mutants_of_files_of_runs_do_no_harm(name: str, tmp_path: Path) -> None:
    tally = campaign(run(name, tmp_path / "good"), 50, SEED, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)


@pytest.mark.slow
@pytest.mark.parametrize("name", RUNS)
def test_two_thousand_mutants_of_files_of_runs(name: str, tmp_path: Path) -> None:
    tally = campaign(run(name, tmp_path / "good"), 2000, SEED + 1, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)
