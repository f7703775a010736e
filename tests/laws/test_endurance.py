"""What goes wrong on long runs and busy machines: kills, full memory, odd clocks, lost caches."""

from __future__ import annotations

import os
import random
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import cardan as cd

pytestmark = pytest.mark.slow
SEED = 9
HEAD = """
import os, sys, hashlib, resource, warnings
import numpy as np
import cardan as cd

def arm(coordinates="relative", links=2):
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    last = scene.ground
    for k in range(links):
        rod = cd.inertia.rod(1.0, 0.5, axis="z")
        body = scene.body(f"b{k}", mass=1.0, com=(0, 0, -0.25), inertia=rod)
        scene.joint(f"j{k}", cd.Revolute("y"), last, body)
        last = body.at(0, 0, -0.5)
    return cd.compile(scene, coordinates=coordinates)

def told(*arrays):
    print(hashlib.sha256(b"".join(np.ascontiguousarray(a).tobytes() for a in arrays)).hexdigest())
"""


def _environment(cache: Path) -> dict[str, str]:
    return {**os.environ, "CARDAN_CACHE": str(cache), "OPENBLAS_NUM_THREADS": "1"}


def _process(code: str, cache: Path) -> subprocess.Popen[str]:
    """A process that runs some lines."""
    return subprocess.Popen(
        [sys.executable, "-c", HEAD + code],
        env=_environment(cache),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def _ended(process: subprocess.Popen[str], limit: float = 500.0) -> str:
    """What it printed; it must have ended well."""
    try:
        out, err = process.communicate(timeout=limit)
    finally:
        process.kill()
    assert process.returncode == 0, err[-4000:]
    return out


@pytest.fixture
def cache() -> Path:
    """The cache of this session."""
    from cardan.build import cache_folder

    return cache_folder.directory()


ENSEMBLE = """
model = arm({coordinates!r})
runs = model.ensemble(0.5, q={{"j1": np.linspace(-1, 1, {count})}}, threads=1,
    lanes=1, reduce=["states", "mean of " + model.coordinates[0]], checkpoint={path!r})
assert runs.success
told(runs.final, runs.numbers, *runs.results.values())
"""


@pytest.mark.parametrize(("coordinates", "count"), [("relative", 6000), ("absolute", 400)])
def test_ensembles_killed_again_and_again(
    coordinates: str, count: int, tmp_path: Path, cache: Path
) -> None:
    """Killed while its file grows until it is done: it gives what one gives that was left alone."""
    whole, path = tmp_path / "whole", tmp_path / "killed"
    wanted = _ended(
        _process(ENSEMBLE.format(coordinates=coordinates, count=count, path=str(whole)), cache)
    )
    code = ENSEMBLE.format(coordinates=coordinates, count=count, path=str(path))
    drawn, kills, sizes = random.Random(SEED), 0, [0]
    while True:
        # by what it has written: how long that takes depends on what else the machine does
        least = sizes[-1] + drawn.uniform(0.0, 0.2) * whole.stat().st_size
        process = _process(code, cache)
        while process.poll() is None and not (path.exists() and path.stat().st_size > least):
            time.sleep(1e-3)
        time.sleep(drawn.uniform(0, 5e-3))
        process.send_signal(signal.SIGKILL)
        out, err = process.communicate()
        if process.returncode != -signal.SIGKILL:
            assert process.returncode == 0, err[-4000:]
            break
        kills += 1
        sizes.append(path.stat().st_size)
    print(f"{coordinates}: {kills} kills, seed {SEED}, sizes of the file {sizes}")
    assert kills >= 3
    assert sizes == sorted(sizes)
    assert out == wanted


SHARED = """
for links in (1, 2):
    for coordinates in ("relative", "absolute"):
        model = arm(coordinates, links)
        motion = model.simulate(0.5, q={model.manifest["joints"][0]["name"]: 0.3})
        assert motion.success
        told(motion.t, motion.x, motion.energy.total)
runs = arm("relative", 2).ensemble(0.5, q={"j1": np.linspace(-1, 1, 100)}, threads=2)
told(runs.final)
"""


def test_eight_processes_on_one_empty_cache(tmp_path: Path) -> None:
    """All of them build at once, and all get the same bits; nothing half made stays."""
    place = tmp_path / "cache"
    place.mkdir(mode=0o700)
    processes = [_process(SHARED, place) for _ in range(8)]
    told = [_ended(process) for process in processes]
    assert len(set(told)) == 1
    assert len(told[0].split()) == 5
    left = [path.name for path in place.rglob("*") if path.name.startswith((".new-", ".cardan-"))]
    assert not left
    # and one that comes later
    assert _ended(_process(SHARED, place)) == told[0]


LIMITED = """
model = arm("relative", 2)
usual = model.simulate(0.5, q={"j1": 0.3})
many = np.linspace(0, 0.5, 3_000_000)
taken = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (taken + (160 << 20),) * 2)
warnings.simplefilter("ignore")
ends = []
for what in (
    lambda: model.simulate(2e5, q={"j1": 0.3}, rtol=1e-10),
    lambda: model.simulate(many, q={"j1": 0.3}),
    lambda: model.ensemble(
        np.linspace(0, 1, 2000), q={"j1": np.linspace(-1, 1, 20_000)}, threads=1
    ),
    lambda: usual.resample(many),
):
    try:
        made = what()
        ends.append(f"{made.status}: {made.message}, {len(made)} rows")
        made = None
    except cd.CardanError as error:
        ends.append(type(error).__name__ + ": " + str(error)[:300])
again = model.simulate(0.5, q={"j1": 0.3})
assert np.array_equal(again.x, usual.x)
print(repr(ends))
"""


def test_a_limit_of_memory(cache: Path) -> None:
    """What does not fit is refused, or ends as too large; the process goes on, and is right."""
    ends = eval(_ended(_process(LIMITED, cache)))  # a list of texts of our own
    print(ends)
    assert len(ends) == 4
    assert ends[0].startswith("too_large: stopped at t = ")
    assert int(ends[0].split()[-2]) > 10_000
    assert "fit" in ends[3] or "memory" in ends[3]
    assert all("memory" in end for end in ends)


def test_a_clock_that_goes_backwards(tmp_path: Path) -> None:
    """Everything in the cache comes from the future, and the time of day falls at every look."""
    place = tmp_path / "cache"
    place.mkdir(mode=0o700)
    before = _ended(_process(SHARED, place))
    names = sorted(str(path) for path in place.rglob("*") if path.suffix in (".so", ".c"))
    later = time.time() + 30 * 86400
    for path in place.rglob("*"):
        os.utime(path, (later, later), follow_symlinks=False)
    backwards = """
import time, itertools
falling = itertools.count(1e9, -1000.0)
time.time = lambda: next(falling)
time.time_ns = lambda: int(next(falling)) * 10**9
"""
    assert _ended(_process(backwards + SHARED, place)) == before
    again = sorted(str(path) for path in place.rglob("*") if path.suffix in (".so", ".c"))
    assert again == names
    # checkpoints by time, too
    code = backwards + (
        "motion = arm().simulate(5.0, q={'j1': 0.3}, checkpoint=%r, every=0.01, progress=True)\n"
        "assert motion.success\ntold(motion.x)"
    )
    first = _ended(_process(code % str(tmp_path / "run.part"), place))
    assert _ended(_process(code % str(tmp_path / "run.part"), place)) == first


def test_ten_million_steps() -> None:
    """A pendulum of small swings over 1e7 steps: counted, in time and in phase, memory constant."""
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    bob = scene.body("bob", mass=1.0, com=(0, 0, -1.0), inertia=(1e-9, 1e-9, 1e-9))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, bob)
    model = cd.compile(scene)
    steps, h = 10_000_000, 1e-3
    end, amplitude = steps * h, 1e-3
    times = np.linspace(0, end, 101)
    motion = model.simulate(times, q={"pivot": amplitude}, method="RK4", step=h)
    assert motion.success
    assert motion.t[-1] == end
    assert motion.statistics["steps"] == pytest.approx(steps, abs=101)
    # Source: L. D. Landau, E. M. Lifshitz, Mechanics, section 11: period with amplitude
    omega = np.sqrt(9.81 / (1 + 1e-9)) * (1 - amplitude**2 / 16)
    # RK4 turns too little by (h omega)^5 / 120 a step, and loses (h omega)^6 / 144 of the swing;
    # 5 times that, and rounding that grows like a random walk
    phase = steps * (h * omega) ** 5 / 120 + 1e-11 * np.sqrt(steps)
    damping = steps * (h * omega) ** 6 / 144
    # the next term of the period: 5/3072 amplitude^4
    phase += omega * end * amplitude**4 / 100
    error = np.abs(motion["pivot"] - amplitude * np.cos(omega * times)).max() / amplitude
    # cubic overtone of the swing: amplitude^2 / 192 of it
    bound = 5 * (phase + damping + amplitude**2 / 100)
    print(
        f"{motion.statistics['steps']:.0f} steps, error {error:.2e} of the swing, bound {bound:.2e}"
    )
    assert error < bound


DELETED = """
import shutil, threading
place, stop = os.environ["CARDAN_CACHE"], threading.Event()
wanted, met = {}, []
def remove():
    while not stop.is_set():
        shutil.rmtree(place, ignore_errors=True)
        stop.wait(0.3)
first = arm("relative", 2)
going = first.stepper(q={"j1": 0.3})
thread = threading.Thread(target=remove)
thread.start()
try:
    warnings.simplefilter("ignore")
    for k in range(3):
        for coordinates in ("relative", "absolute"):
            try:
                model = arm(coordinates, 1 + k)
                motion = model.simulate(0.3, q={model.manifest["joints"][0]["name"]: 0.3})
                model.reaction("j0", motion.q, motion.u)
                assert first.ensemble(0.2, q={"j1": np.linspace(-1, 1, 50)}, threads=2).success
            except cd.CardanError as error:
                met.append(str(error)[:200])
        # what is loaded already goes on
        going.step(0.1)
        assert np.isfinite(first.simulate(0.1, q={"j1": 0.3}).x).all()
finally:
    stop.set()
    thread.join()
print(len(met), met[:3], file=sys.stderr)
for coordinates in ("relative", "absolute"):
    model = arm(coordinates, 2)
    assert model.simulate(0.3).success
"""


def test_a_cache_that_is_deleted_while_it_is_used(tmp_path: Path) -> None:
    """What is loaded goes on, what is built meanwhile is built or refused by an error of cardan."""
    place = tmp_path / "cache"
    place.mkdir(mode=0o700)
    process = _process(DELETED, place)
    out, err = process.communicate(timeout=500)
    print(out, err[-2000:])
    assert process.returncode == 0, err[-4000:]
    shutil.rmtree(place, ignore_errors=True)
