"""One model in many places: threads, forks, spawned processes, pickles; and Ctrl-C in C loops."""

from __future__ import annotations

import errno
import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.build import cache, kernels, object_file, prune
from cardan.codegen import layout
from cardan.runtime.trajectory import pickled
from spread import some

pytestmark = pytest.mark.usefixtures("cache_directory")

START = {"q": {"elbow": 0.4}}


def double_pendulum() -> cd.Scene:
    scene = cd.Scene("shared", gravity=(0, 0, -9.81))
    rod = cd.inertia.rod(1.0, 0.5, axis="z")
    upper = scene.body("upper", mass=1.0, com=(0, 0, -0.25), inertia=rod)
    lower = scene.body("lower", mass=1.0, com=(0, 0, -0.25), inertia=rod)
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -0.5), lower)
    torque = scene.input("torque")
    scene.force("motor", cd.JointForce("shoulder", torque))
    return scene


@pytest.fixture
def double() -> cd.CompiledModel:
    """A double pendulum, nothing of it compiled yet."""
    return cd.compile(double_pendulum())


def work(model: cd.CompiledModel) -> list[np.ndarray]:
    """Some of everything."""
    x = model.random_state(1, (500,))
    q, u = model.split(x)
    motion = model.simulate(0.3, **START)
    return [model.rhs(0.0, x), model.mass_matrix(q), model.pose("lower", q), motion.x,
            model.with_parameters({"upper.mass": 2.0}).forward_dynamics(q, u)]  # fmt: skip


def same(found: list[np.ndarray], known: list[np.ndarray]) -> bool:
    return all(np.array_equal(a, b) for a, b in zip(found, known, strict=True))


def test_threads_share_a_model_from_its_first_use(double):
    """Sixteen at once, nothing compiled before: every one gets the same bits."""
    ready = threading.Barrier(16)

    def run() -> list[np.ndarray]:
        ready.wait(60)
        return work(double)

    with ThreadPoolExecutor(16) as pool:
        found = [task.result(120) for task in [pool.submit(run) for _ in range(16)]]
    known = work(double)
    assert all(same(one, known) for one in found)


@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_a_forked_process_does_not_wait_for_threads_of_its_parent():
    with kernels._LOCK:
        child = os.fork()
        if child == 0:
            os._exit(0 if kernels._LOCK.acquire(blocking=False) else 1)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0


@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_forked_child_may_use_the_model(double, tmp_path):
    known = work(double)
    child = os.fork()
    if not child:
        # whatever happens, the child never returns into pytest
        try:
            found = work(double)
            double.pose("upper", [0.1, 0.2])  # compiled in the child
            (tmp_path / "told").write_text(str(same(found, known)))
        finally:
            os._exit(0)
    os.waitpid(child, 0)
    assert (tmp_path / "told").read_text() == "True"
    assert same(work(double), known)


def test_spawned_process_gets_model_and_motion(double):
    motion, known = double.simulate(0.3, **START), work(double)
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(1, mp_context=context) as pool:
        assert same(pool.submit(work, double).result(120), known)
        ends = pool.submit(ends_of, motion).result(120)
        again = pool.submit(double.simulate, 0.3, **START).result(120)
    np.testing.assert_array_equal(ends, [motion.at(0.123), motion.x[-1]])
    np.testing.assert_array_equal(again.x, motion.x)
    np.testing.assert_array_equal(again.energy_residual, motion.energy_residual)


def ends_of(motion: cd.Trajectory) -> list[np.ndarray]:
    return [motion.at(0.123), motion.x[-1]]


def test_motion_pickles_with_everything_it_shows(double):
    inputs = {"torque": lambda t, x: np.sin(t)}
    motion = double.simulate(0.5, **START, inputs=inputs)
    reaction = motion.reaction("elbow")
    content = pickle.dumps(motion)
    assert b"\x7fELF" not in content
    again = pickle.loads(content)
    for name in ("t", "x", "r", "work_done", "energy_residual"):
        np.testing.assert_array_equal(getattr(again, name), getattr(motion, name))
    assert again.solver_info == motion.solver_info
    np.testing.assert_array_equal(again.at(0.21), motion.at(0.21))
    np.testing.assert_array_equal(again.resample([0.1, 0.2]).r, motion.resample([0.1, 0.2]).r)
    np.testing.assert_array_equal(again.pose("lower"), motion.pose("lower"))
    np.testing.assert_array_equal(again.reaction("elbow"), reaction)
    assert repr(again) == repr(motion)


def test_motion_of_a_file_pickles(double, tmp_path):
    stored = cd.load_motion(double.simulate(0.5, **START).save(tmp_path / "run.nc"))
    again = pickle.loads(pickle.dumps(stored))
    np.testing.assert_array_equal(again.pose("lower"), stored.pose("lower"))
    np.testing.assert_array_equal(again.at(0.21), stored.at(0.21))


def test_harmed_motion_is_refused(double):
    motion = double.simulate(0.5, **START)
    values, stated = pickled.parts(motion)
    x = values["x"].copy()
    x[0, 0] += 1
    with pytest.raises(cd.ModelError, match="not what it was made of"):
        pickled.restore({**values, "x": x}, stated)
    with pytest.raises(cd.ModelError, match="a part is missing"):
        pickled.restore({"t": values["t"]}, stated)
    short = {**values, "x": values["x"][:, 1:]}
    with pytest.raises(cd.ModelError, match=r"x has shape"):
        pickled.restore(short, pickled.digest(pickled.read(short)))
    lost = {**values, "dense": {**values["dense"], "spreads": motion.dense.spreads[1:]}}
    with pytest.raises(cd.ModelError, match="between its times"):
        pickled.restore(lost, pickled.digest(pickled.read(lost)))


TOGETHER = """\
import sys
import cardan as cd

scene = cd.Scene("together", gravity=(0, 0, -9.81))
rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
print("ready", flush=True)
sys.stdin.read()
motion = cd.compile(scene).simulate(1.0, q={"pivot": 1.0})
print(motion.x[-1][0].hex(), flush=True)
"""


@pytest.mark.parametrize("killed", some([2, 0], 2), ids=["two are killed", "all live"])
def test_processes_compile_one_model_at_once(killed, cache_directory):
    """Whatever happens to some of them, the others are right and the cache is whole."""
    running = [
        subprocess.Popen(
            [sys.executable, "-c", TOGETHER],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        for _ in range(3 + killed)
    ]
    for process in running:
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
    for process in running:
        assert process.stdin is not None
        process.stdin.close()
        process.stdin = None
    # in the middle of writing, compiling, checking: wherever they are
    for k, process in enumerate(running[:killed]):
        time.sleep(0.1 + 0.15 * k)
        process.send_signal(signal.SIGKILL)
    told = [process.communicate(timeout=120)[0].strip() for process in running]
    assert [process.returncode for process in running[killed:]] == [0, 0, 0]
    assert len(set(told[killed:])) == 1
    assert all(map(object_file.intact, cache_directory.glob("*.so")))
    for left in cache_directory.glob(".new-*"):
        os.utime(left, (1.0, 1.0))
    cache.sweep(cache_directory)
    assert list(cache_directory.glob(".new-*")) == []
    again = subprocess.run(
        [sys.executable, "-c", TOGETHER], input="", capture_output=True, text=True, timeout=120
    )
    assert again.stdout.split() == ["ready", told[-1]]


def pendulum() -> cd.Scene:
    scene = cd.Scene("full", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    return scene


def full(monkeypatch, place: Path) -> None:
    """Nothing more can be written below a folder by the writer of models."""
    real = layout._write

    def write(path: Path, text: str) -> str:
        if place in path.parents:
            raise OSError(errno.ENOSPC, "No space left on device")
        return real(path, text)

    monkeypatch.setattr(layout, "_write", write)


def test_no_space_left_for_the_model(cache_directory, monkeypatch):
    full(monkeypatch, cache_directory)
    with pytest.warns(cd.BuildWarning, match="No space left on device"):
        model = cd.compile(pendulum())
    assert cache_directory not in model.directory.parents
    assert model.simulate(1.0, q={"pivot": 1.0}).success


def test_no_space_left_anywhere(cache_directory, monkeypatch):
    full(monkeypatch, Path("/"))
    with (
        pytest.warns(cd.BuildWarning, match="cannot be used"),
        pytest.raises(cd.BuildError, match="the C of the model cannot be written"),
    ):
        cd.compile(pendulum())


def test_no_space_left_later(cache_directory, monkeypatch, tmp_path):
    model = cd.compile(pendulum())
    full(monkeypatch, cache_directory)
    with pytest.raises(cd.BuildError, match=r"No space left on device.*cardan doctor --prune"):
        model.rhs(0.0, [0.1, 0.2])
    full(monkeypatch, tmp_path)
    with pytest.raises(cd.BuildError, match="No space left on device"):
        cd.compile(pendulum(), directory=tmp_path / "named")
    monkeypatch.undo()
    monkeypatch.setenv("CARDAN_CACHE", str(cache_directory))
    assert np.isfinite(model.rhs(0.0, [0.1, 0.2])).all()


INTERRUPTED = """\
import sys, threading, time, warnings
import numpy as np
import cardan as cd

model = cd.load_model(sys.argv[1])
model.prepare()
x = np.zeros((10_000_000, model.nx)) if sys.argv[2] == "batch" else None
model.simulate(0.01)
warnings.simplefilter("ignore")
# an answer with the time it was given, so that the other side can send its signal then
print("ready", flush=True)
try:
    if x is None:
        motion = model.simulate(1e9, q={"elbow": 0.4}, rtol=1e-13)
        ended = time.time()
        print(ended, motion.status, len(motion), float(motion.t[-1]) > 0)
    else:
        while True:
            model.rhs(0.0, x)
except KeyboardInterrupt:
    print(time.time(), "KeyboardInterrupt")
"""


@pytest.mark.parametrize("what", ["batch", "simulate"])
def test_ctrl_c_stops_a_long_loop_in_c(double, what):
    """Wanted are 0.1 s; the bound leaves room for a busy machine, a deaf loop takes minutes."""
    double.prepare("rhs", "power", "energy")
    process = subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED, str(double.directory), what],
        stdout=subprocess.PIPE,
        text=True,
        cwd=Path(__file__).parent,
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "ready\n"
    time.sleep(0.5)
    sent = time.time()
    process.send_signal(signal.SIGINT)
    ended, *said = process.communicate(timeout=120)[0].split()
    assert process.returncode == 0
    assert float(ended) - sent < 5.0
    if what == "batch":
        assert said == ["KeyboardInterrupt"]
    else:
        assert said[0] == "interrupted"
        assert int(said[1]) > 100
        assert said[2] == "True"
    print(f"{what}: stopped {float(ended) - sent:.3f} s after the signal")


def test_threads_that_load_elements_do_not_wait_for_each_other() -> None:
    scene = cd.Scene("hung", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1.0, com=(0, 0, -0.25), inertia=(0.1, 0.1, 0.1))
    scene.joint("pin", cd.Revolute("y"), scene.ground, rod)
    model = cd.compile(scene, coordinates="absolute")
    model._source.results(model)
    other = threading.Thread(target=model._source.mesh, args=(model,), daemon=True)

    def prepare() -> None:
        with model._objects.lock:
            other.start()
            # it is on its way now
            time.sleep(0.2)
            model.prepare("rhs")

    first = threading.Thread(target=prepare, daemon=True)
    first.start()
    first.join(60)
    other.join(60)
    assert not first.is_alive()
    assert not other.is_alive()


def test_headers_count_where_they_are_included(tmp_path: Path) -> None:
    """Scenes share the code of elements that know no more than these do."""
    source, inner, other = (tmp_path / name for name in ("a.c", "inner.h", "other.h"))
    source.write_text('#include "outer.h"\nint a(void)\n{\n    return A;\n}\n')
    (tmp_path / "outer.h").write_text('#include "inner.h"\n')
    paths = []
    for number, header in enumerate((inner, other, inner)):
        header.write_text(f"#define A {number}\n")
        paths.append(cache.build([source], [tmp_path]).path)
    assert paths[0] == paths[1] != paths[2]


def test_one_file_under_two_names_takes_its_room_once(
    tmp_path: Path, cache_directory: Path
) -> None:
    source, second = tmp_path / "answer.c", cache_directory / f"{'0' * 64}.so"
    source.write_text("int answer(void);\nint answer(void) { return 42; }\n")
    object_file.linked(cache.build([source]).path, second)
    content = prune.content(cache_directory)
    assert content.objects == 2
    assert content.size < 2 * second.stat().st_size


def test_a_run_of_the_compiler_keeps_one_lock(
    tmp_path: Path, cache_directory: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Systems let a process open a few hundred files; models have as many functions."""
    texts = [tmp_path / f"f{k}.c" for k in range(4)]
    for text in texts:
        text.write_text(f"int {text.stem}(void);\nint {text.stem}(void)\n{{\n    return 1;\n}}\n")
    monkeypatch.setattr(os, "cpu_count", lambda: 1)
    made = cache.compiled_separately(texts, tmp_path, False, cache.compiler(), [()] * len(texts))
    (kept,) = cache_directory.glob(".new-*")
    made[0].published()
    made[1].discard()
    made[1].discard()
    os.utime(kept, (1.0, 1.0))
    assert cache.sweep(cache_directory) == [], "two of them wait"
    for one in made[2:]:
        assert object_file.intact(one.published().path)
    assert list(cache_directory.glob(".new-*")) == []
    assert len(list(cache_directory.glob("*.so"))) == 3
