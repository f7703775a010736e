"""Compilers: order of search, flags, the clang that comes from PyPI."""

from __future__ import annotations

import ctypes
import shutil
import sys
from pathlib import Path

import pytest

from cardan.build import cache, toolchain
from cardan.errors import BuildError
from codegen.running import CONTRACT

pytestmark = pytest.mark.usefixtures("cache_directory")


def test_contraction_is_always_given():
    gcc = toolchain.Compiler(("gcc",), Path("gcc"), "gcc (Debian) 12.2.0")
    clang = toolchain.Compiler(("clang",), Path("clang"), "Debian clang version 14.0.6")
    old = toolchain.Compiler(("gcc",), Path("gcc"), "gcc (GCC) 7.5.0")
    assert gcc.contraction() == CONTRACT["gcc"]
    assert old.contraction() == ("-ffp-contract=fast",)
    assert clang.contraction() == CONTRACT["clang"]
    assert set(gcc.contraction()) < set(gcc.flags())
    assert "-ffp-contract=off" in gcc.flags(reproducible=True)
    assert not any("fast-math" in flag for flag in (*gcc.flags(), *clang.flags()))


def test_optimization_is_that_of_the_environment(monkeypatch):
    monkeypatch.delenv("CARDAN_OPTIMIZATION", raising=False)
    plain = cache.compiler()
    assert plain.for_models() == plain
    assert "-O2" in plain.flags()
    monkeypatch.setenv("CARDAN_OPTIMIZATION", "0")
    assert [flag for flag in plain.for_models().flags() if "-O" in flag][-1] == "-O0"
    # kernels keep theirs
    assert cache.compiler() == plain
    monkeypatch.setenv("CARDAN_OPTIMIZATION", "fast")
    with pytest.raises(BuildError, match=r"CARDAN_OPTIMIZATION='fast'.*0, 1, 2, 3"):
        plain.for_models()


def test_cc_of_the_environment_comes_first(monkeypatch):
    monkeypatch.setenv("CC", f"{shutil.which('cc')} -pipe")
    (found,) = toolchain.candidates()
    assert found.name == "$CC"
    assert found.command[1:] == ("-pipe",)
    assert found.binary == Path(shutil.which("cc") or "").resolve()


def test_cc_that_does_not_exist_is_an_error(monkeypatch):
    monkeypatch.setenv("CC", "no-such-cc -m64")
    with pytest.raises(BuildError, match=r"CC='no-such-cc -m64'.*unset it"):
        next(toolchain.candidates())


def test_order_of_the_search(tmp_path, monkeypatch):
    for name in ("clang", "gcc", "cc"):
        (tmp_path / name).write_text("#!/bin/sh\necho one of them\n")
        (tmp_path / name).chmod(0o755)
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    names = [found.name for found in toolchain.candidates()]
    assert names[:3] == ["cc", "gcc", "clang"]
    assert names[3:] == [found.name for found in toolchain.ziglang()]
    # one that does not answer makes room for the next
    (tmp_path / "cc").write_text("#!/bin/sh\nexit 1\n")
    found = toolchain.find_compiler(lambda mark, ask: ask())
    assert found.command == (str(tmp_path / "gcc"),)


def test_compiler_that_does_not_answer(tmp_path):
    silent = tmp_path / "cc"
    silent.write_text("#!/bin/sh\nexit 3\n")
    silent.chmod(0o755)
    with pytest.raises(BuildError, match="does not answer"):
        toolchain.ask_version([str(silent)])


@pytest.mark.slow
def test_ziglang_compiles_where_nothing_else_is_there(tmp_path, monkeypatch):
    pytest.importorskip("ziglang")
    source = tmp_path / "answer.c"
    declared = "double f(double x)"
    source.write_text(f"#include <math.h>\n{declared};\n{declared} {{ return sin(x); }}\n")
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setenv("PATH", "/nonexistent")
    assert cache.compiler().command[:3] == (sys.executable, "-m", "ziglang")
    assert cache.compiler().family == "clang"
    function = ctypes.CDLL(str(cache.build([source]).path)).f
    function.restype, function.argtypes = ctypes.c_double, [ctypes.c_double]
    assert abs(function(0.5) - 0.479425538604203) < 1e-15
