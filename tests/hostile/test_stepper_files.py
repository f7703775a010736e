"""Mutants of checkpoints of steppers: damage is found, and malice does no harm."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from hostile.harness import campaign
from hostile.kinds import STEPPERS, stepper
from spread import some

SEED = 17
PARTS = 40  # of a memory


@pytest.mark.parametrize("name", some(STEPPERS, every=4))
def test_mutants_of_checkpoints_of_steppers_do_no_harm(name: str, tmp_path: Path) -> None:
    tally = campaign(stepper(name, tmp_path / "good"), 50, SEED, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)


def test_a_row_that_is_due_in_a_checkpoint(tmp_path: Path) -> None:
    """Its multipliers were read from an address that a run gets with its first step."""
    tally = campaign(stepper("alpha", tmp_path / "good"), 1, 17023, tmp_path, first=798)
    print(tally)
    assert not tally.failures, str(tally)
    kind = stepper("alpha", tmp_path / "due")
    good = kind.use(kind.read(kind.file))
    assert kind.unpack is not None
    assert kind.pack is not None
    for due in (1, 2):
        parts = kind.unpack(kind.file.read_bytes())
        parts["head"]["record"]["row_open"] = due
        kind.file.write_bytes(kind.pack(parts))
        assert kind.use(kind.read(kind.file)) == good


@pytest.mark.slow
@pytest.mark.parametrize("name", STEPPERS)
def test_two_thousand_mutants_of_checkpoints_of_steppers(name: str, tmp_path: Path) -> None:
    tally = campaign(stepper(name, tmp_path / "good"), 2000, SEED + 1, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)


@pytest.mark.parametrize("name", ["beam", "Radau beam", "conserving beam"])
def test_rows_of_sparse_factors_that_do_not_exist(name: str, tmp_path: Path) -> None:
    """Factors name rows by whole numbers, two in the room of a number of the memory."""
    kind = stepper(name, tmp_path / "good")
    assert kind.unpack is not None
    assert kind.pack is not None
    content, messages = kind.file.read_bytes(), list[str]()
    size = len(kind.unpack(content)["memory"])
    for some_numbers in np.array_split(np.arange(size), PARTS):
        parts = kind.unpack(content)
        memory = parts["memory"] = parts["memory"].copy()
        memory[some_numbers] = np.full(2, 1 << 30, dtype=np.int32).view(float)
        kind.file.write_bytes(kind.pack(parts))
        try:
            kind.read(kind.file)
        except cd.ModelError as error:
            messages.append(str(error))
    assert all("its memory is not that of a run" in message for message in messages)
    assert 1 <= len(messages) < PARTS
