"""The compile cache: hits without a compiler, repairs, races, killed compiles, clear refusals."""

from __future__ import annotations

import ctypes
import errno
import os
import signal
import subprocess
import sys
import tempfile
import time
import warnings
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from cardan.errors import BuildError, BuildWarning, CompilerMissing
from cardan.runtime.build import cache, cache_folder, cpu_levels, object_file, toolchain

pytestmark = pytest.mark.usefixtures("cache_directory")
BUILD = (
    "import sys, pathlib; from cardan.runtime.build import cache; "
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
    monkeypatch.setattr(subprocess, "Popen", lambda *a, **k: started.append(a))
    cache._compiler.cache_clear()
    second = cache.build([source])
    assert not second.fresh
    assert second.path == first.path
    assert started == []


def test_cache_is_private(source, cache_directory):
    cache.build([source])
    assert cache_directory.stat().st_mode & 0o777 == 0o700


def test_readable_cache_of_ours_is_made_private(source, cache_directory):
    cache_directory.mkdir(mode=0o755)
    assert cache.build([source]).path.parent == cache_directory
    assert cache_directory.stat().st_mode & 0o777 == 0o700


def writable_by_all(path: Path) -> None:
    path.mkdir()
    path.chmod(0o777)


def belongs_to_another(path: Path) -> None:
    path.mkdir(mode=0o700)
    if os.geteuid():
        pytest.skip("only the superuser can give a folder away")
    os.chown(path, 12345, 12345)


def below_a_file(path: Path) -> None:
    path.parent.joinpath("cache").write_text("mine")


UNUSABLE = {
    writable_by_all: "not private",
    belongs_to_another: "belongs to another user",
    below_a_file: "it is a file",
}


@pytest.mark.parametrize("harm", UNUSABLE)
def test_unusable_folder_is_left_alone_and_said_once(source, cache_directory, harm):
    harm(cache_directory)
    before = sorted(cache_directory.glob("*")) if cache_directory.is_dir() else "mine"
    with pytest.warns(BuildWarning, match=UNUSABLE[harm]):
        first = cache.build([source])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        second = cache.build([source])
    assert answer(first.path) == 42
    assert (first.fresh, second.fresh) == (True, False)
    assert first.path.parent.stat().st_mode & 0o777 == 0o700
    after = sorted(cache_directory.glob("*")) if cache_directory.is_dir() else "mine"
    assert before == after


def test_text_header_flags_and_level_are_in_the_key(source, tmp_path):
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
    keys.add(cache.key([source], [], replace(by, level=cpu_levels.OTHER), False))
    other = replace(by, identity=by.identity + " newer")
    keys.add(cache.key([source], [], other, False))
    other = replace(by, command=(*by.command, "-O0"))
    keys.add(cache.key([source], [], other, False))
    assert len(keys) == 8


@pytest.mark.parametrize("harm", ["flip", "cut", "empty", "sparse"])
def test_corrupted_object_is_detected_and_rebuilt(source, harm):
    built = cache.build([source])
    content = bytearray(built.path.read_bytes())
    if harm == "flip":
        content[len(content) // 2] ^= 1
    harmed = {"cut": content[: len(content) // 2], "empty": b""}.get(harm, content)
    built.path.unlink()
    built.path.write_bytes(harmed)
    if harm == "sparse":
        # larger than any memory, and no more of the disk
        os.truncate(built.path, 1 << 40)
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


@pytest.fixture
def hanging(tmp_path, monkeypatch) -> Path:
    """A compiler that writes half an object, tells its process id here, and hangs."""
    real, told, slow = cache.compiler().command[0], tmp_path / "half", tmp_path / "slowcc"
    slow.write_text(
        f'#!/bin/sh\ncase "$*" in *--version*) exec {real} --version;; esac\n'
        'while [ "$1" != "-o" ]; do shift; done\n'
        f'echo half > "$2"; sleep 60 & echo $$ $! > {told}.new; mv {told}.new {told}; wait\n'
    )
    slow.chmod(0o755)
    monkeypatch.setenv("CC", str(slow))
    return told


def patient(what: Callable[[], object]) -> None:
    """Wait until something is so; half a minute is beyond doubt."""
    deadline = time.monotonic() + 30
    while not what():
        assert time.monotonic() < deadline
        time.sleep(0.01)


def alive(process: int) -> bool:
    """Whether a process runs; one that only waits to be buried does not."""
    try:
        state = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
    except (FileNotFoundError, ProcessLookupError):
        return False
    return state not in "ZX"


def aged(path: Path) -> None:
    os.utime(path, (1.0, 1.0))


def test_killed_process_takes_its_compiler_along(source, cache_directory, hanging, monkeypatch):
    process = subprocess.Popen([sys.executable, "-c", BUILD, str(source)])
    patient(hanging.exists)
    process.send_signal(signal.SIGKILL)
    process.wait()
    family = list(map(int, hanging.read_text().split()))
    patient(lambda: not any(map(alive, family)))
    assert list(cache_directory.glob("*.so")) == []
    left = list(cache_directory.glob(".new-*"))
    assert len(left) == 1
    aged(left[0])
    monkeypatch.delenv("CC")
    assert answer(cache.build([source]).path) == 42
    assert list(cache_directory.glob(".new-*")) == []


def test_killed_compiler_is_an_error_and_leaves_nothing(source, cache_directory, hanging):
    process = subprocess.Popen(
        [sys.executable, "-c", BUILD, str(source)], stderr=subprocess.PIPE, text=True
    )
    patient(hanging.exists)
    for number in map(int, hanging.read_text().split()):
        os.kill(number, signal.SIGKILL)
    assert "BuildError: slowcc could not compile answer.c" in process.communicate(timeout=60)[1]
    assert list(cache_directory.glob("*.so")) == list(cache_directory.glob(".new-*")) == []


def test_ctrl_c_stops_the_compiler_and_cleans_up(source, cache_directory, hanging):
    process = subprocess.Popen(
        [sys.executable, "-c", BUILD, str(source)], stderr=subprocess.PIPE, text=True
    )
    patient(hanging.exists)
    process.send_signal(signal.SIGINT)
    assert "KeyboardInterrupt" in process.communicate(timeout=60)[1]
    assert not any(map(alive, map(int, hanging.read_text().split())))
    assert list(cache_directory.glob(".new-*")) == []


MODEL = (
    "import sys; import cardan as cd; "
    "cd.load_model(sys.argv[1]).prepare('rhs', 'energy', 'mass_matrix')"
)


def test_ctrl_c_stops_compilers_that_run_side_by_side(directory, cache_directory, hanging):
    process = subprocess.Popen(
        [sys.executable, "-c", MODEL, str(directory)], stderr=subprocess.PIPE, text=True
    )
    patient(hanging.exists)
    process.send_signal(signal.SIGINT)
    assert "KeyboardInterrupt" in process.communicate(timeout=30)[1]
    patient(lambda: not any(map(alive, map(int, hanging.read_text().split()))))
    assert list(cache_directory.glob("*.so")) == list(cache_directory.glob(".new-*")) == []


def test_compiler_that_takes_too_long_is_stopped(source, cache_directory, hanging, monkeypatch):
    monkeypatch.setenv("CARDAN_COMPILE_SECONDS", "1")
    with pytest.raises(BuildError, match=r"answer\.c took it longer than 1 s.*COMPILE_SECONDS"):
        cache.build([source])
    assert not any(map(alive, map(int, hanging.read_text().split())))
    assert list(cache_directory.glob(".new-*")) == []


def test_compiler_that_takes_too_much_memory_is_stopped(source, monkeypatch):
    monkeypatch.setenv("CARDAN_COMPILE_MEMORY", "16")
    with pytest.raises(BuildError):
        cache.build([source])


@pytest.mark.parametrize("text", ["-1", "many", "0", "1e3"])
def test_limits_must_be_numbers(source, monkeypatch, text):
    monkeypatch.setenv("CARDAN_COMPILE_SECONDS", text)
    with pytest.raises(BuildError, match=r"CARDAN_COMPILE_SECONDS=.*positive whole number"):
        cache.build([source])


# the version of a compiler is remembered if there is room for it
REMEMBERING = ("mkstemp", "fdopen")
WRITES = (*REMEMBERING, "mkdtemp", "compiler", "open", "replace")


@pytest.mark.parametrize("point", WRITES)
def test_no_space_left_wherever_something_is_written(source, cache_directory, point, monkeypatch):
    full = OSError(errno.ENOSPC, "No space left on device")
    owner = {"mkdtemp": tempfile, "mkstemp": tempfile, "compiler": cache, "open": object_file}
    name = {"compiler": "compile_shared"}.get(point, point)
    place = owner.get(point, os)
    real = open if point == "open" else getattr(place, name)

    def fails(*given: Any, **named: Any) -> Any:
        # only the cache is full, not the temporary folder
        inside = str(cache_directory) in f"{given} {named}"
        if inside or point == "fdopen":
            raise full
        return real(*given, **named)

    if point not in REMEMBERING:
        cache.compiler()
    monkeypatch.setattr(place, name, fails, raising=False)
    if point == "replace":
        with pytest.raises(BuildError, match=r"No space left.*cardan doctor --prune"):
            cache.build([source])
    elif point in REMEMBERING:
        assert answer(cache.build([source]).path) == 42
    else:
        with pytest.warns(BuildWarning, match=r"No space left on device.*cardan doctor --prune"):
            assert answer(cache.build([source]).path) == 42
    monkeypatch.undo()
    objects = list(cache_directory.glob("*.so"))
    assert len(objects) == (point in REMEMBERING)
    assert all(map(object_file.intact, objects))
    assert list(cache_directory.glob(".new-*")) == []


SMALL = (
    "import resource, signal, sys, pathlib; from cardan.runtime.build import cache; "
    "cache.compiler(); signal.signal(signal.SIGXFSZ, signal.SIG_IGN); "
    "resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000)); "
    "cache.build([pathlib.Path(sys.argv[1])])"
)


def test_file_limit_of_the_process_is_a_clear_error(source, cache_directory):
    done = subprocess.run(
        # bytecode would be cut short too, and kept
        [sys.executable, "-B", "-c", SMALL, str(source)],
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 1
    assert "cardan.errors.BuildError" in done.stderr
    assert list(cache_directory.glob("*.so")) == list(cache_directory.glob(".new-*")) == []


def test_code_that_cannot_be_loaded_names_the_folder(source):
    built = cache.compiled([source])
    built.path.write_bytes(b"no object")
    with pytest.raises(BuildError, match=r"cannot be loaded.*CARDAN_CACHE"):
        built.load()
    built.discard()
    assert not built.path.parent.exists()


def test_nothing_is_found_before_it_is_published(source, cache_directory):
    built = cache.compiled([source])
    assert answer(built.path) == 42
    assert list(cache_directory.glob("*.so")) == []
    assert cache.sweep(cache_directory) == []
    aged(built.path.parent)
    assert cache.sweep(cache_directory) == [], "its process lives"
    assert built.published().path.parent == cache_directory
    assert list(cache_directory.glob(".new-*")) == []


def test_interrupted_compile_cleans_up(source, cache_directory, monkeypatch):
    def interrupt(*args: object, **options: object) -> None:
        raise KeyboardInterrupt

    cache.compiler()
    monkeypatch.setattr(cache, "compile_shared", interrupt)
    with pytest.raises(KeyboardInterrupt):
        cache.build([source])
    assert list(cache_directory.glob(".new-*")) == []


def test_leftovers_of_killed_compiles_are_swept(source, cache_directory):
    cache_folder.directory()
    old, young = cache_directory / ".new-old", cache_directory / ".new-young"
    for path in (old, young):
        path.mkdir()
        (path / "object.so").write_text("half")
    aged(old)
    cache.build([source])
    assert not old.exists()
    assert young.exists()


def test_missing_compiler_says_what_to_install(source, monkeypatch):
    monkeypatch.setenv("PATH", "/nonexistent")
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(toolchain, "ziglang", lambda: [])
    with pytest.raises(BuildError, match=r"no C compiler.*pip install 'cardan\[compiler\]'"):
        cache.build([source])
    with pytest.raises(CompilerMissing):
        cache.compiler()


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

    cache_folder.directory()

    def mark() -> str:
        return toolchain.Candidate((str(binary),), binary, "cc").mark()

    assert [cache._remembered(cache_directory, mark(), ask) for _ in range(3)] == ["one"] * 3
    binary.write_text("another")
    assert cache._remembered(cache_directory, mark(), ask) == "another"
    assert asked == ["one", "another"]
