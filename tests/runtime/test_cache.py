"""The compile cache: hits without a compiler, repairs, races, killed compiles, clear refusals."""

from __future__ import annotations

import ctypes
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from cardan.errors import BuildError
from cardan.runtime import cache, toolchain

BUILD = (
    "import sys, pathlib; from cardan.runtime import cache; "
    "print(cache.build([pathlib.Path(sys.argv[1])]).path)"
)


@pytest.fixture
def source(tmp_path: Path) -> Path:
    path = tmp_path / "answer.c"
    path.write_text("int answer(void);\nint answer(void) { return 42; }\n")
    return path


def answer(path: Path) -> int:
    return int(ctypes.CDLL(str(path)).answer())


def test_second_build_comes_from_the_cache_without_a_compiler(source, monkeypatch):
    first = cache.build([source])
    assert first.fresh
    assert answer(first.path) == 42
    started = []
    monkeypatch.setattr(subprocess, "run", lambda *a, **k: started.append(a))
    cache._compiler.cache_clear()
    second = cache.build([source])
    assert not second.fresh
    assert second.path == first.path
    assert started == []


def test_cache_is_private(source, cache_directory):
    cache.build([source])
    assert cache_directory.stat().st_mode & 0o777 == 0o700


def test_directory_others_may_write_to_is_refused(source, cache_directory):
    cache_directory.mkdir()
    cache_directory.chmod(0o777)
    cache._private.cache_clear()
    with pytest.raises(BuildError, match=r"not private.*chmod 700"):
        cache.build([source])


def test_text_header_flags_and_processor_are_in_the_key(source, tmp_path, monkeypatch):
    by = cache.compiler()
    header = tmp_path / "a.h"
    header.write_text("#define A 1\n")
    keys = {
        cache.key([source], [], by, False),
        cache.key([source], [], by, True),
        cache.key([source], [header], by, False),
    }
    header.write_text("#define A 2\n")
    keys.add(cache.key([source], [header], by, False))
    source.write_text(source.read_text().replace("42", "43"))
    keys.add(cache.key([source], [], by, False))
    monkeypatch.setattr(cache, "processor", lambda: "another machine")
    keys.add(cache.key([source], [], by, False))
    other = toolchain.Compiler(by.command, by.binary, by.identity + " newer")
    keys.add(cache.key([source], [], other, False))
    assert len(keys) == 7


@pytest.mark.parametrize("harm", ["flip", "cut", "empty"])
def test_corrupted_object_is_detected_and_rebuilt(source, harm):
    built = cache.build([source])
    content = bytearray(built.path.read_bytes())
    if harm == "flip":
        content[len(content) // 2] ^= 1
    harmed = {"flip": content, "cut": content[: len(content) // 2], "empty": b""}[harm]
    built.path.unlink()
    built.path.write_bytes(harmed)
    again = cache.build([source])
    assert again.fresh
    assert answer(again.path) == 42


def test_two_processes_compile_the_same_at_once(source):
    running = [
        subprocess.Popen([sys.executable, "-c", BUILD, str(source)], stdout=subprocess.PIPE)
        for _ in range(3)
    ]
    paths = {p.communicate(timeout=60)[0].decode().strip() for p in running}
    assert [p.returncode for p in running] == [0, 0, 0]
    assert len(paths) == 1
    assert answer(Path(paths.pop())) == 42


def test_killed_compile_leaves_no_corrupt_object(source, cache_directory, tmp_path, monkeypatch):
    # a compiler that writes half an object, tells us, and hangs
    real = cache.compiler().command[0]
    told = tmp_path / "half"
    slow = tmp_path / "slowcc"
    slow.write_text(
        f'#!/bin/sh\ncase "$*" in *--version*) exec {real} --version;; esac\n'
        'while [ "$1" != "-o" ]; do shift; done\n'
        f'echo half > "$2"; echo $$ > {told}.new; mv {told}.new {told}; exec sleep 60\n'
    )
    slow.chmod(0o755)
    monkeypatch.setenv("CC", str(slow))
    process = subprocess.Popen([sys.executable, "-c", BUILD, str(source)])
    deadline = time.monotonic() + 30
    while not told.exists() and time.monotonic() < deadline:
        time.sleep(0.01)
    process.send_signal(signal.SIGKILL)
    process.wait()
    os.kill(int(told.read_text()), signal.SIGKILL)
    assert [p for p in cache_directory.glob("*.so") if not p.name.startswith(".")] == []
    monkeypatch.delenv("CC")
    assert answer(cache.build([source]).path) == 42


def test_interrupted_compile_cleans_up(source, cache_directory, monkeypatch):
    def interrupt(*args: object, **options: object) -> None:
        raise KeyboardInterrupt

    cache.compiler()
    monkeypatch.setattr(cache, "compile_shared", interrupt)
    with pytest.raises(KeyboardInterrupt):
        cache.build([source])
    assert list(cache_directory.glob(".new-*")) == []


def test_leftovers_of_killed_compiles_are_swept(source, cache_directory):
    cache.directory()
    old, young = cache_directory / ".new-old.so", cache_directory / ".new-young.so"
    for path in (old, young):
        path.write_text("half")
    os.utime(old, (1.0, 1.0))
    cache.build([source])
    assert not old.exists()
    assert young.exists()


def test_missing_compiler_says_what_to_install(source, monkeypatch):
    monkeypatch.setenv("PATH", "/nonexistent")
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(toolchain, "ziglang", lambda: [])
    with pytest.raises(BuildError, match=r"no C compiler.*pip install 'cardan\[compiler\]'"):
        cache.build([source])


def test_failing_compile_shows_the_message_and_the_command(source):
    source.write_text("int answer(void) { return fourty_two; }\n")
    with pytest.raises(BuildError, match=r"answer\.c.*(?s:.*)fourty_two"):
        cache.build([source])


def test_version_of_a_compiler_is_remembered_until_it_changes(tmp_path, cache_directory):
    binary = tmp_path / "cc"
    binary.write_text("one")
    asked = []

    def ask() -> str:
        asked.append(binary.read_text())
        return asked[-1]

    cache.directory()
    assert [cache._remembered(cache_directory, binary, ask) for _ in range(3)] == ["one"] * 3
    binary.write_text("another")
    assert cache._remembered(cache_directory, binary, ask) == "another"
    assert asked == ["one", "another"]
