"""Without a compiler functions run as WebAssembly: the same numbers, also under kernels."""

from __future__ import annotations

import gc
import pickle
import threading
import warnings

import numpy as np
import pytest

import cardan as cd
from cardan.runtime.build import kernels, toolchain
from mechanisms import ZOO
from runtime.test_interpreted import calls
from spread import some

wasmtime = pytest.importorskip("wasmtime", reason="wasmtime is not installed")
pytestmark = pytest.mark.usefixtures("cache_directory")

MEMBERS = ("double_pendulum", "satellite", "drives", "spherical_ZYX", "crane", "driven", "springs")


@pytest.fixture
def bare(monkeypatch):
    """Take every compiler away; kernels that were compiled before stay."""

    def remove() -> None:
        kernels.library()
        monkeypatch.setenv("PATH", "/nonexistent")
        monkeypatch.delenv("CC", raising=False)
        monkeypatch.setattr(toolchain, "ziglang", lambda: [])

    return remove


def runs_in_wasmtime(model: cd.CompiledModel, name: str) -> bool:
    function = model._function(name)
    return function.code.wasm is not None and not function.interpreted


@pytest.mark.parametrize("name", some(MEMBERS, 2))
def test_every_function_gives_the_same_numbers(name, bare):
    model = cd.compile(ZOO[name].build())
    known = {n: calls(model, n) for n in (0, 5)}
    condition = np.linalg.cond(known[5]["M"]).max()
    content = pickle.dumps(model)
    bare()
    with warnings.catch_warnings():
        # nothing to say: it is not slow
        warnings.simplefilter("error", cd.BuildWarning)
        other = pickle.loads(content)
        for n, expected in known.items():
            for key, value in calls(other, n).items():
                # a reaction is a sum with h, whose terms may cancel
                terms = (key, "h") if key == "reaction" else (key,)
                scale = max(np.abs(known[5][term]).max() for term in terms) or 1.0
                bound = 1e-12 * scale * (condition if key in ("rhs", "udot", "reaction") else 1)
                assert np.abs(value - expected[key]).max() <= bound, key
    assert runs_in_wasmtime(other, "rhs")


MOVING = ("double_pendulum", "cart_pole", "four_bar", "bouncing_ball", "flexible_arm", "bicycle")


@pytest.mark.filterwarnings("ignore::cardan.errors.SolveWarning")
@pytest.mark.parametrize("name", MOVING)
def test_runs_are_those_of_compiled_c(name, bare):
    scene = cd.load(cd.examples.path(name))
    model = cd.compile(scene)
    start = {block: scene.settings[block] for block in "qu" if block in scene.settings}
    if name == "double_pendulum":
        start = {"q": {"shoulder": 1.0}}
    expected = model.simulate(0.5, **start)
    content = pickle.dumps(model)
    bare()
    motion = pickle.loads(content).simulate(0.5, **start)
    size = np.ptp(expected.x, axis=0).max()
    assert size > 0.1
    # rounding; iterations onto loops and of implicit steps end within their tolerances
    bound = 1e-5 if name in ("four_bar", "flexible_arm") else 1e-11
    assert np.abs(motion.x[-1] - expected.x[-1]).max() <= bound * size
    assert [event.name for event in motion.events] == [event.name for event in expected.events]


def test_threads_and_batches_share_a_function(bare):
    model = cd.compile(ZOO["crane"].build())
    content = pickle.dumps(model)
    x = model.random_state(3, (200,))
    expected = model.rhs(0.0, x)
    bare()
    other = pickle.loads(content)
    found: list[np.ndarray] = []
    threads = [threading.Thread(target=lambda: found.append(other.rhs(0.0, x))) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 4
    for rows in found:
        np.testing.assert_allclose(rows, expected, rtol=1e-9, atol=1e-9)


def test_functions_are_compiled_while_others_run(bare):
    """Threads stay inside one function while others are used for the first time."""
    model = cd.compile(ZOO["double_pendulum"].build())
    content = pickle.dumps(model)
    x = model.random_state(3, (500,))
    bare()
    other = pickle.loads(content)
    expected = other.rhs(0.0, x)
    objects, done = other._objects, threading.Event()
    wrong: list[int] = []

    def run() -> None:
        while not done.is_set():
            wrong.append(int((other.rhs(0.0, x) != expected).sum()))

    threads = [threading.Thread(target=run) for _ in range(2)]
    for thread in threads:
        thread.start()
    try:
        function = objects.function("rhs")
        for _ in range(100):
            objects._evaluated("rhs", function)
    finally:
        done.set()
        for thread in threads:
            thread.join()
    assert len(wrong) > 10
    assert not any(wrong)


def test_memories_do_not_change_once_they_are_called(bare, monkeypatch):
    """A store serves one thread at a time, and a memory that grows may move: each grows once."""
    content = pickle.dumps(cd.compile(ZOO["double_pendulum"].build()))
    bare()
    grow, stores = wasmtime.Memory.grow, []

    def noted(memory, store, pages):
        stores.append(store)
        return grow(memory, store, pages)

    monkeypatch.setattr(wasmtime.Memory, "grow", noted)
    model = pickle.loads(content)
    for name in ("rhs", "energy", "momentum", "mass_matrix", "bias", "gravity"):
        model.prepare(name)
    assert len(stores) >= 6
    assert len({id(store) for store in stores}) == len(stores)


def test_places_are_given_back(bare):
    content = pickle.dumps(cd.compile(ZOO["double_pendulum"].build()))
    bare()
    # more functions than there are places
    for _ in range(600):
        model = pickle.loads(content)
        model.energy([0.1, 0.2], [0.0, 0.0])
        del model
        gc.collect(0)
    assert runs_in_wasmtime(pickle.loads(content), "energy")
