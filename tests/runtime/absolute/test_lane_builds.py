"""Elements side by side: what is compiled for them, and what goes wrong."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.build import cache, object_file
from cardan.build.toolchain import compile_shared
from cardan.errors import BuildError
from cardan.runtime.models.finite_elements.elements import State
from cardan.runtime.models.finite_elements.mesh import Mesh
from cardan.runtime.models.finite_elements.table_loading import LANE_THRESHOLD

pytestmark = pytest.mark.usefixtures("cache_directory")


def bar(elements: int = LANE_THRESHOLD + 2) -> cd.Scene:
    """A bar of enough elements to go side by side."""
    scene = cd.Scene("bar")
    rubber = cd.material(E=5e6, nu=0.45, rho=1100)
    square = cd.section.rectangle(0.02, 0.02)
    scene.beam("bar", scene.ground, (1, 0, 0), square, rubber, elements=elements)
    return scene


@pytest.fixture
def several(monkeypatch: pytest.MonkeyPatch) -> None:
    """Lanes, whatever the processor."""
    monkeypatch.setenv("CARDAN_LANES", "4")


@pytest.mark.usefixtures("several")
def test_functions_of_many_elements_are_compiled_once_for_lanes(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    compiled: list[str] = []

    def noted(by: Any, sources: Any, include: Any, output: Any, *given: Any) -> None:
        *_, extra, texts = given
        compiled.extend(f"{text.stem} {'-DCARDAN_LANES=4' in extra}" for text in texts)
        compile_shared(by, sources, include, output, *given)

    monkeypatch.setattr(cache, "compile_shared", noted)
    model = cd.compile(bar())
    mesh: Mesh = model._source.results(model).mesh  # type: ignore[attr-defined]
    at = State(q=model.initial()[: model.nq], u=np.zeros(model.nu))
    compiled.clear()
    mesh.total("energy", 2, at)
    assert sorted(compiled) == [
        # the first element is the only one of its kind: it stands on the ground
        "hellinger_reissner__energy True",
        "hellinger_reissner_ground_node__energy False",
        "linked_inertia__energy True",
        "linked_inertia_ground_node__energy False",
    ]


@pytest.mark.usefixtures("several")
def test_a_model_outlives_its_folder() -> None:
    model = cd.compile(bar())
    q, u = model.initial()[: model.nq], np.zeros(model.nu)
    known = model.energy(q, u)
    shutil.rmtree(model.directory)
    np.testing.assert_array_equal(model.energy(q, u), known)


def test_elements_are_made_again_after_the_cache_was_removed(
    cache_directory: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    folder = cd.derive(bar(1)).export(tmp_path / "bar", functions=("energy",))
    model = cd.load_model(folder)

    def removed(*given: Any) -> None:
        shutil.rmtree(cache_directory)

    with monkeypatch.context() as patched:
        patched.setattr(cd.CompiledModel, "_verify_elements", removed)
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
