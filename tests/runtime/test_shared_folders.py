"""Models that share one folder: who writes to it, what others read of it, and its lock."""

from __future__ import annotations

import json
import os
import pickle
import threading
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan import processes
from cardan.codegen import layout
from cardan.schema.manifest import Manifest
from runtime.test_sharing import START, double_pendulum

pytestmark = pytest.mark.usefixtures("cache_directory")


def test_models_of_one_folder_have_the_functions_they_were_compiled_with() -> None:
    scene = double_pendulum()
    few = cd.compile(scene, functions=("forward_dynamics",))
    many = cd.compile(scene)
    assert few.directory == many.directory
    assert "inverse_dynamics" in many.manifest.available
    many.prepare("inverse_dynamics", "energy")
    # what the other model wrote is in the folder when this one reads its manifest again
    few.prepare("forward_dynamics")
    assert [*few.manifest.available] == ["forward_dynamics"]
    assert few.verify().checked == ("forward_dynamics",)
    cd.compile(scene, functions=("qdot",))
    many.prepare("mass_matrix")
    assert "energy" in many.manifest.available
    assert "energy" in many.simulate(0.1, **START).manifest.available


def with_expressions(model: cd.CompiledModel) -> cd.CompiledModel:
    model._objects.function("rhs")
    return model


READERS: dict[str, Callable[[cd.CompiledModel], cd.CompiledModel]] = {
    "pickle": lambda model: pickle.loads(pickle.dumps(model)),
    "load": lambda model: cd.load_model(model.directory),
    "expressions": with_expressions,
}


@pytest.mark.parametrize("reader", READERS)
def test_what_is_being_written_is_read_whole(reader: str) -> None:
    """Others add functions to the folder of a model: expressions first, then the manifest."""
    model = cd.compile(double_pendulum())
    known = model.rhs(0.0, [0.1, 0.2, 0.3, 0.4])
    saved, inside = model.directory / layout.SAVED, threading.Event()

    def added(manifest: Manifest) -> Manifest:
        text = saved.read_text()
        row = "another", next(iter(json.loads(text).values()))
        digest = layout._write(saved, layout._appended(text, [row]))
        inside.set()
        time.sleep(0.5)
        return manifest.replaced(sha256={**manifest.sha256, saved.name: digest})

    other = threading.Thread(target=layout.change, args=(model.directory, added))
    other.start()
    assert inside.wait(60)
    again = READERS[reader](model)
    other.join()
    assert "another" in again._objects.saved()
    np.testing.assert_array_equal(again.rhs(0.0, [0.1, 0.2, 0.3, 0.4]), known)


def test_a_pickle_has_the_functions_of_its_model() -> None:
    few = cd.compile(double_pendulum(), functions=("forward_dynamics",))
    cd.compile(double_pendulum()).prepare("energy")
    assert [*pickle.loads(pickle.dumps(few)).manifest.available] == ["forward_dynamics"]


@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_a_forked_child_does_not_keep_the_lock_of_a_folder(tmp_path: Path) -> None:
    reading, writing = os.pipe()
    with processes.folder_lock(tmp_path):
        child = os.fork()
        if child == 0:
            os.read(reading, 1)
            os._exit(0)
    free = threading.Event()

    def wait() -> None:
        with processes.folder_lock(tmp_path):
            free.set()

    threading.Thread(target=wait, daemon=True).start()
    found = free.wait(10)
    os.write(writing, b"x")
    os.waitpid(child, 0)
    assert found
