"""Locks, fork hooks and the cache on systems that lack what POSIX has; interrupted builds."""

from __future__ import annotations

import gc
import os
import subprocess
import sys
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from cardan import processes
from cardan.errors import BuildError
from cardan.runtime.build import limited_subprocess
from cardan.runtime.build.parallel_build import in_parallel

pytestmark = pytest.mark.usefixtures("cache_directory")

# what each kind of system lacks or has; locks of Windows belong to a handle, as those of flock do
POSIX = ""
NEITHER = "import os, random, sys; sys.modules['fcntl'] = None; del os.register_at_fork"
WINDOWS = """
import fcntl, os, random, subprocess, sys, types

def locking(handle, mode, count):
    fcntl.flock(handle, fcntl.LOCK_EX | (0 if mode == 1 else fcntl.LOCK_NB))

sys.modules["msvcrt"] = types.SimpleNamespace(LK_LOCK=1, LK_NBLCK=2, locking=locking)
sys.modules["fcntl"] = None
missing = "register_at_fork geteuid getuid O_NOFOLLOW O_NONBLOCK O_CLOEXEC O_NOCTTY"
for name in missing.split():
    delattr(os, name)
from cardan.runtime.build import limited_subprocess
limited_subprocess.SHELL = "no such shell"
"""
SYSTEMS = pytest.mark.parametrize(
    "system", [POSIX, NEITHER, WINDOWS], ids=["posix", "neither", "windows"]
)
SCENE = Path(__file__).parents[2] / "src" / "cardan" / "scenes" / "double_pendulum.yaml"

HOLD = """
import os, sys
from cardan import processes
handle = os.open(sys.argv[1], os.O_RDWR | os.O_CREAT)
processes.lock(handle)
print("locked", flush=True)
sys.stdin.read()
"""
TRY = """
import os, sys
from cardan import processes
handle = os.open(sys.argv[1], os.O_RDWR)
try:
    processes.lock(handle, wait=False)
except BlockingIOError:
    print("in use", os.lseek(handle, 0, os.SEEK_CUR))
else:
    print("free", os.lseek(handle, 0, os.SEEK_CUR))
"""
COMPILE = """
import os, subprocess, sys

import cardan as cd
from cardan.runtime.build import cache

real, swept = cache.compile_shared, []

def compile_beside_another(by, sources, include, path, *rest):
    # another process sweeps while this one compiles, long after it began
    os.utime(path.parent, (0, 0))
    subprocess.run([*sys.argv[3:], str(path.parent.parent)], check=True)
    swept.append(not path.parent.exists())
    real(by, sources, include, path, *rest)

cache.compile_shared = compile_beside_another
scene = cd.load(sys.argv[1])
model = cd.compile(scene, directory=sys.argv[2])
motion = model.simulate(1.0)
print(motion.success, len(swept), sum(swept))
"""
SWEEP = """
import sys
from pathlib import Path
from cardan.runtime.build import cache
cache.sweep(Path(sys.argv[1]))
"""


def child(system: str, text: str, *arguments: object) -> list[str]:
    """Command of a process on a system."""
    return [sys.executable, "-c", system + "\n" + text, *map(str, arguments)]


@SYSTEMS
def test_a_lock_lasts_as_long_as_its_process(system: str, tmp_path: Path) -> None:
    place = tmp_path / "file"
    ask = child(system, TRY, place)
    with subprocess.Popen(
        child(system, HOLD, place), stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == "locked\n"
        assert subprocess.check_output(ask, text=True) == "in use 0\n"
        holder.kill()
    assert subprocess.check_output(ask, text=True) == "free 0\n"


@SYSTEMS
def test_a_scene_compiles_and_runs_and_its_cache_is_locked(
    system: str, tmp_path: Path, cache_directory: Path
) -> None:
    if system == WINDOWS:
        # what modes say there
        cache_directory.mkdir()
        cache_directory.chmod(0o777)
    command = child(system, COMPILE, SCENE, tmp_path / "model", *child(system, SWEEP))
    answer = subprocess.check_output(command, text=True).split()
    # compiles, and none of their folders was swept away
    assert answer[0] == "True"
    assert int(answer[1]) > 0
    assert answer[2] == "0"
    assert list(cache_directory.glob("*.so"))


def test_ctrl_c_while_programs_are_started_ends_those_that_run(monkeypatch):
    submit, begun = ThreadPoolExecutor.submit, time.monotonic()

    def interrupted(pool: ThreadPoolExecutor, task: Callable[[], object]) -> object:
        if not pool._threads:
            return submit(pool, task)
        while not limited_subprocess.LIFELINES:
            time.sleep(0.01)
        raise KeyboardInterrupt

    def sleep() -> Any:
        limits = limited_subprocess.Limits()
        raise BuildError(str(limited_subprocess.run(["sleep", "60"], limits, os.environ)))

    monkeypatch.setattr(ThreadPoolExecutor, "submit", interrupted)
    with pytest.raises(KeyboardInterrupt):
        in_parallel([sleep, sleep])
    assert time.monotonic() - begun < 30


def test_time_is_limited_where_there_is_no_shell(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limited_subprocess, "SHELL", "no such shell")
    begun, limits = time.monotonic(), limited_subprocess.Limits(seconds=1)
    assert limited_subprocess.run(["sleep", "60"], limits, os.environ).late
    assert time.monotonic() - begun < 30
    answer = limited_subprocess.run(["sh", "-c", "echo a; echo b >&2; exit 3"], limits, os.environ)
    assert answer == limited_subprocess.Answer(3, "a\n", "b\n")
    with pytest.raises(FileNotFoundError):
        limited_subprocess.run(["no such compiler"], limits, os.environ)


def test_threads_that_pause_the_collector_let_it_go_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """A second one looks while the first has paused it, which goes on before it does more."""
    first, is_enabled = processes.collector_paused(), gc.isenabled
    first.__enter__()

    def looked() -> bool:
        answer = is_enabled()
        first.__exit__(None, None, None)
        return answer

    with monkeypatch.context() as patched:
        patched.setattr(processes.gc, "isenabled", looked)
        second = processes.collector_paused()
        second.__enter__()
    second.__exit__(None, None, None)
    assert gc.isenabled()
