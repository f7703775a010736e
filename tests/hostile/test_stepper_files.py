"""Mutants of checkpoints of steppers: damage is found, and malice does no harm."""

from __future__ import annotations

from pathlib import Path

import pytest

from hostile.harness import campaign
from hostile.kinds import STEPPERS, stepper
from spread import some

SEED = 17


@pytest.mark.parametrize("name", some(STEPPERS, every=4))
def test_mutants_of_checkpoints_of_steppers_do_no_harm(name: str, tmp_path: Path) -> None:
    tally = campaign(stepper(name, tmp_path / "good"), 50, SEED, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)


@pytest.mark.slow
@pytest.mark.parametrize("name", STEPPERS)
def test_two_thousand_mutants_of_checkpoints_of_steppers(name: str, tmp_path: Path) -> None:
    tally = campaign(stepper(name, tmp_path / "good"), 2000, SEED + 1, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)
