"""The line that names what is built, and Ctrl-C while that goes on."""

from __future__ import annotations

import os
import pty
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from spread import some

SCENE = """
import sys, time
import cardan as cd
from cardan import build_progress

build_progress.DELAY = float(sys.argv[1])
scene = cd.Scene("chain")
place = scene.ground
for k in range(9):
    body = scene.body(f"b{k}", mass=1, com=(0.1, 0, 0.2), inertia=(1, 2, 2.5))
    scene.joint(f"j{k}", cd.Revolute((1, k, 2)), place, body)
    place = body.at(0.3, 0.1, 0)
beam = len(sys.argv) > 2
if beam:
    section = cd.section.general(EA=1e5, GA=1e5, GJ=10, EI=10, rhoA=1, rhoI=1e-3)
    scene.beam("boom", scene.ground, (1, 0, 0), section, elements=2)
print("start", flush=True)
model = cd.compile(scene)
model.prepare("energy") if beam else model.prepare("rhs", "energy")
q, u = model.split(model.initial())
model.energy(q, u)
print("done", flush=True)
"""
HAS_TERMINALS = hasattr(os, "openpty") and sys.platform != "win32"


def environment(folder: Path) -> dict[str, str]:
    return dict(os.environ) | {"CARDAN_CACHE": str(folder / "cache")}


def on_terminal(folder: Path, *arguments: str) -> str:
    """What a build writes to a terminal as standard error."""
    ours, theirs = pty.openpty()
    command = [sys.executable, "-c", SCENE, *arguments]
    with subprocess.Popen(
        command, stderr=theirs, stdout=subprocess.DEVNULL, env=environment(folder)
    ) as process:
        os.close(theirs)
        text = b""
        while True:
            try:
                part = os.read(ours, 4096)
            except OSError:
                break
            if not part:
                break
            text += part
        process.wait()
    os.close(ours)
    assert process.returncode == 0
    return text.decode()


@pytest.mark.skipif(not HAS_TERMINALS, reason="no terminals here")
@pytest.mark.parametrize("beam", some([True, False], 2))
def test_a_long_build_says_what_is_built(tmp_path: Path, beam: bool) -> None:
    text = on_terminal(tmp_path, "0.0", *["beam"] * beam)
    lines = text.split("\r\x1b[2K")
    assert any(line.startswith("model 'chain': deriving equations (") for line in lines)
    assert any(line.startswith("model 'chain': compiling ") for line in lines)
    # nothing is left of it
    assert lines[-1] == ""


@pytest.mark.skipif(not HAS_TERMINALS, reason="no terminals here")
def test_a_short_build_is_silent(tmp_path: Path) -> None:
    assert on_terminal(tmp_path, "600.0") == ""


def test_nothing_is_written_to_files(tmp_path: Path) -> None:
    command = [sys.executable, "-c", SCENE, "0.0"]
    ended = subprocess.run(command, env=environment(tmp_path), capture_output=True, check=True)
    assert ended.stderr == b""


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_ctrl_c_leaves_a_cache_that_goes_on(tmp_path: Path) -> None:
    """Interrupted at several moments, a build ends at once, and the next one is complete."""
    for pause in (0.05, 0.3, 0.8, 1.6):
        process = subprocess.Popen(
            [sys.executable, "-c", SCENE, "600"],
            env=environment(tmp_path),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        assert process.stdout is not None
        assert process.stdout.readline() == b"start\n"
        time.sleep(pause)
        process.send_signal(signal.SIGINT)
        _, message = process.communicate(timeout=60)
        assert process.returncode == 0 or b"KeyboardInterrupt" in message
    cache = tmp_path / "cache"
    left = [path.name for path in cache.rglob("*") if path.suffix in (".tmp", ".part", ".o")]
    assert not left
    ended = subprocess.run(
        [sys.executable, "-W", "error", "-c", SCENE, "600"],
        env=environment(tmp_path),
        capture_output=True,
        check=False,
    )
    assert (ended.returncode, ended.stdout) == (0, b"start\ndone\n"), ended.stderr.decode()
