"""Mutants of what a model's folder holds: manifest, saved expressions, tables of elements."""

from __future__ import annotations

from pathlib import Path

import pytest

from hostile.harness import campaign
from hostile.kinds import folder
from spread import some

SEED = 17
NAMES = [
    "manifest.json of servo",
    "manifest.json of double",
    "manifest.json of linkage",
    "manifest.json of shaft",
    "functions.json of double",
    "mesh.npz of shaft",
]


@pytest.mark.parametrize("name", some(NAMES, every=4))
def test_mutants_of_folders_of_models_do_no_harm(name: str, tmp_path: Path) -> None:
    tally = campaign(folder(name, tmp_path / "good"), 50, SEED, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)


def test_a_manifest_without_the_functions_that_there_are(tmp_path: Path) -> None:
    """It was read, and a KeyError came from the run."""
    name = "manifest.json of double"
    tally = campaign(folder(name, tmp_path / "good"), 1, 17023, tmp_path, first=1940)
    print(tally)
    assert tally.counts == {"refused": 1}


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_two_thousand_mutants_of_folders_of_models(name: str, tmp_path: Path) -> None:
    tally = campaign(folder(name, tmp_path / "good"), 2000, SEED + 1, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)
