"""Lane builds of elements: their cost while they are not there, and what goes wrong."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import BuildError, BuildWarning
from cardan.runtime import object_file, verify
from cardan.runtime.absolute.elements import State
from cardan.runtime.absolute.mesh import LANE_THRESHOLD, Mesh

pytestmark = pytest.mark.usefixtures("cache_directory")


def bar(elements: int = LANE_THRESHOLD + 2) -> cd.Model:
    """A bar of enough elements to go side by side."""
    scene = cd.Model("bar")
    rubber = cd.material(E=5e6, nu=0.45, rho=1100)
    square = cd.section.rectangle(0.02, 0.02)
    scene.beam("bar", scene.ground, (1, 0, 0), square, rubber, elements=elements)
    return scene


@pytest.fixture
def several(monkeypatch: pytest.MonkeyPatch) -> None:
    """Lanes, whatever the processor."""
    monkeypatch.setenv("CARDAN_LANES", "4")


def loaded(model: cd.CompiledModel) -> tuple[Mesh, State]:
    """Its elements, which can give energies, and a state."""
    mesh: Mesh = model._source.results(model).mesh  # type: ignore[attr-defined]
    at = State(q=model.initial()[: model.nq], u=np.zeros(model.nu))
    mesh.total("energy", 2, at)
    assert mesh._alone
    return mesh, at


@pytest.mark.usefixtures("several")
def test_elements_are_asked_without_looking_at_files(monkeypatch: pytest.MonkeyPatch) -> None:
    mesh, at = loaded(cd.compile(bar()))
    read: list[Any] = []
    for way in ("read_text", "read_bytes"):
        monkeypatch.setattr(Path, way, lambda *given, **more: read.append(given))
    mesh.total("energy", 2, at)
    assert read == []


@pytest.mark.usefixtures("several")
def test_a_model_outlives_its_folder() -> None:
    model = cd.compile(bar())
    mesh, at = loaded(model)
    known = mesh.total("energy", 2, at)
    shutil.rmtree(model.directory)
    mesh.spend(1e3)
    np.testing.assert_array_equal(mesh.total("energy", 2, at), known)


@pytest.mark.usefixtures("several")
def test_builds_that_cannot_be_kept_leave_nothing(
    cache_directory: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mesh, at = loaded(cd.compile(bar()))
    known = mesh.total("energy", 2, at)

    def full(*_: Any) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(object_file.os, "replace", full)
    with pytest.warns(BuildWarning, match="one by one"):
        mesh.spend(1e3)
    assert list(cache_directory.glob(f"{object_file.NEW}*")) == []
    np.testing.assert_array_equal(mesh.total("energy", 2, at), known)


def test_elements_are_made_again_after_the_cache_was_removed(
    cache_directory: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    folder = cd.derive(bar(1)).export(tmp_path / "bar", functions=("energy",))
    model = cd.load_model(folder)

    def removed(*given: Any) -> None:
        shutil.rmtree(cache_directory)

    with monkeypatch.context() as patched:
        patched.setattr(verify, "verify_elements", removed)
        with pytest.raises(BuildError, match="do the same again"):
            model.initial()
    assert np.isfinite(model.initial()).all()


def test_what_is_discarded_twice_closes_no_file_of_others(tmp_path: Path) -> None:
    (made,) = object_file.begun([tmp_path / "object.so"])
    made.discard()
    with open(tmp_path / "other", "wb") as other:
        made.discard()
        os.fstat(other.fileno())
    assert not made.path.parent.exists()
