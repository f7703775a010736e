"""``cardan doctor``: says what works and what to do, and empties nothing but the cache."""

from __future__ import annotations

import json
import os
import time
from importlib.metadata import PackageNotFoundError
from pathlib import Path

import pytest

from cardan.cli import health, main
from cardan.runtime.build import cache, cache_folder, toolchain
from cardan.runtime.calls import abi

DAY = 86400


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache."""
    monkeypatch.setenv("CARDAN_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(cache_folder, "_SCRATCH", {})
    for remembered in (cache_folder._usable, cache_folder._temporary):
        remembered.cache_clear()
    return tmp_path / "cache"


def told(capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, dict[str, dict]]:
    status = main(["doctor", "--json", *words])
    rows = json.loads(capsys.readouterr().out)
    return status, {row["name"]: row for row in rows}


def test_all_is_well(capsys):
    status, rows = told(capsys)
    assert status == 0
    assert all(row["ok"] for row in rows.values())
    assert "works" in rows["compiler"]["says"]
    assert "-ffp-contract=" in rows["compiler"]["says"]
    assert "yours alone, 0 objects" in rows["cache"]["says"]
    assert "CARDAN_COMPILE_SECONDS" in rows["limits"]["says"]
    assert ("extension" in rows["calls"]["says"]) == (abi.NAME == "cython")
    assert {"numpy", "scipy", "sympy", "processor", *health.OPTIONAL} < set(rows)


def test_screen_has_a_line_for_each(capsys):
    assert main(["doctor"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len([line for line in lines if line.startswith("ok ")]) == len(health.findings())


def test_extra_that_is_missing_is_named_and_harmless(capsys, monkeypatch):
    real = health.version

    def version(name):
        if name == "matplotlib":
            raise PackageNotFoundError(name)
        return real(name)

    monkeypatch.setattr(health, "version", version)
    status, rows = told(capsys)
    assert status == 0
    assert "pip install 'cardan[plot]'" in rows["matplotlib"]["cure"]


def test_no_compiler(capsys, monkeypatch):
    monkeypatch.setenv("PATH", "/nonexistent")
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(toolchain, "ziglang", lambda: [])
    monkeypatch.setattr("cardan.runtime.calls.webassembly.available", lambda: False)
    status, rows = told(capsys)
    assert status == 1
    assert "no C compiler" in rows["compiler"]["says"]
    assert "pip install 'cardan[compiler]'" in rows["compiler"]["cure"]


def test_batches(capsys, monkeypatch):
    monkeypatch.setenv("CARDAN_THREADS", "3")
    monkeypatch.setenv("CARDAN_LANES", "4")
    _, rows = told(capsys)
    assert rows["batches"]["says"] == (
        "4 states side by side (CARDAN_LANES), 3 threads (CARDAN_THREADS)"
    )
    monkeypatch.setenv("CARDAN_LANES", "5")
    status, rows = told(capsys)
    assert (status, rows["batches"]["ok"]) == (1, False)
    assert "CARDAN_LANES='5'" in rows["batches"]["says"]


def test_compiler_that_fails(capsys, monkeypatch, tmp_path):
    broken = tmp_path / "cc"
    broken.write_text('#!/bin/sh\n[ "$1" = --version ] && echo broken 1.0 && exit\nexit 1\n')
    broken.chmod(0o755)
    monkeypatch.setenv("CC", str(broken))
    status, rows = told(capsys)
    assert status == 1
    assert "could not compile probe.c" in rows["compiler"]["says"]


def test_limit_that_is_none(capsys, monkeypatch):
    monkeypatch.setenv("CARDAN_COMPILE_MEMORY", "lots")
    status, rows = told(capsys)
    assert status == 1
    assert "CARDAN_COMPILE_MEMORY='lots'" in rows["limits"]["says"]


@pytest.mark.filterwarnings("ignore::cardan.errors.BuildWarning")
def test_cache_that_cannot_be_used(capsys, place):
    place.write_text("mine")
    status, rows = told(capsys)
    assert status == 1
    assert "it is a file" in rows["cache"]["cure"]
    assert main(["doctor", "--prune", "--all"]) == 1
    assert "left alone" in capsys.readouterr().err
    assert place.read_text() == "mine"


@pytest.mark.filterwarnings("ignore::cardan.errors.BuildWarning")
def test_folder_with_other_things_is_never_changed(capsys, place):
    place.mkdir(mode=0o755)
    (place / "thesis.tex").write_text("years")
    left = place / ".new-idea"
    left.write_text("mine")
    os.utime(left, (1, 1))
    status, rows = told(capsys)
    assert status == 1
    assert "it holds other things (" in rows["cache"]["cure"]
    assert main(["doctor", "--prune", "--all"]) == 1
    assert sorted(path.name for path in place.iterdir()) == [".new-idea", "thesis.tex"]
    assert place.stat().st_mode & 0o777 == 0o755


def filled(place: Path, tmp_path: Path) -> dict[str, Path]:
    """An old and a young object, an old and a young model, a damaged object, a leftover."""
    found = {}
    cache_folder.directory()
    for age in ("old", "young", "damaged"):
        source = tmp_path / f"{age}.c"
        source.write_text(f"int {age}(void);\nint {age}(void) {{ return 1; }}\n")
        found[age] = cache.build([source]).path
    found["damaged"].write_bytes(b"?")
    for age in ("old", "young"):
        found[f"{age} model"] = place / "models" / (f"{len(found):x}" * 32)
        found[f"{age} model"].mkdir(parents=True)
        (found[f"{age} model"] / "manifest.json").write_text("{}")
    found["left"] = place / ".new-left"
    found["left"].mkdir()
    (found["left"] / "object.so").write_text("half")
    long_ago = time.time() - 60 * DAY
    for name in ("old", "old model", "left"):
        os.utime(found[name], (long_ago, long_ago))
    return found


@pytest.mark.parametrize(
    ("words", "gone"),
    [
        ([], {"old", "old model", "damaged", "left"}),
        (["--older", "90"], {"damaged", "left"}),
        (["--all"], {"old", "young", "old model", "young model", "damaged", "left"}),
    ],
)
def test_prune(capsys, place, tmp_path, words, gone):
    found = filled(place, tmp_path)
    assert main(["doctor", "--prune", "--json", *words]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert {name for name, path in found.items() if not path.exists()} == gone
    assert answer["objects"] == len(gone & {"old", "young", "damaged"})
    assert answer["models"] == len(gone & {"old model", "young model"})
    assert answer["leftovers"] == 1
    assert answer["size"] > 0


def test_what_is_used_is_not_old(place, tmp_path):
    found = filled(place, tmp_path)
    cache.build([tmp_path / "old.c"])
    assert main(["doctor", "--prune"]) == 0
    assert found["old"].exists()


def test_wrong_use(capsys):
    assert main(["doctor", "--all"]) == 2
    assert "go with --prune" in capsys.readouterr().err
    with pytest.raises(SystemExit) as status:
        main(["doctor", "--prune", "--older", "-1"])
    assert status.value.code == 2
