"""Kernels of the installation: which there are, when they serve, and what is compiled instead."""

from __future__ import annotations

import json
import os
import resource
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from analyses.conftest import double_scene
from cardan.api.compiled_model import CompiledModel
from cardan.build import cache, cpu_levels, kernels, prebuilt, toolchain
from cardan.errors import BuildError
from cardan.schema import kernel_files
from cardan.schema.integrators import INTEGRATORS, KERNELS
from laws.test_tunings import LEVELS, runs

pytestmark = [pytest.mark.optimized, pytest.mark.usefixtures("cache_directory")]

ROOT = Path(__file__).parents[2]
# what an installation may take [s on two cores]
AT_ONCE = 15.0
# systems of which there is no machine here: target of ziglang -> first bytes of its libraries
ELSEWHERE = {
    "x86_64-windows-gnu": b"MZ",
    "x86_64-macos": b"\xcf\xfa\xed\xfe",
    "aarch64-macos": b"\xcf\xfa\xed\xfe",
}


def processor_time() -> float:
    """Of all programs that were run so far [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


@pytest.fixture
def sources(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A copy of the kernels, of which three C files are left, used instead of the package's."""
    place = tmp_path / "kernels"
    kept = {"map.c", "batch.c", "level.c"}
    place.mkdir()
    for path in kernel_files.files("*.[ch]"):
        if path.suffix == ".h" or path.name in kept:
            shutil.copy(path, place)
    monkeypatch.setattr(kernel_files, "KERNELS", place)
    prebuilt.reread()
    kernels._library.cache_clear()
    yield place
    prebuilt.reread()
    kernels._library.cache_clear()


def installed(place: Path) -> list[str]:
    """Install kernels beside their sources; what was compiled."""
    lines: list[str] = []
    kernels.install(place / "built", (), cache.compiler(), lines.append)
    return [line.split()[2] for line in lines if " bytes," in line]


def test_level_of_the_processor_is_what_gcc_says() -> None:
    if not runs(LEVELS[0]):
        pytest.skip("no gcc, or no x86-64-v2")
    assert cache.level().name == [level for level in LEVELS if runs(level)][-1]


def test_usual_variants_are_there_and_serve(sources: Path) -> None:
    assert prebuilt.current() is None
    made = installed(sources)
    width = cache.level().lanes
    usual = ["scalar", f"lanes{width}", f"lanes{width}-own"] if width > 1 else ["scalar"]
    assert sorted(made) == sorted(["level", *usual, *(f"{name}-exact" for name in usual)])
    for variant in prebuilt.variants([width] if width > 1 else []):
        found = kernels.library(variant.reproducible, variant.lanes, variant.lane_parameters)
        assert Path(found._name).parent == sources / "built"
        assert hasattr(found, "cardan_batch" if variant.lanes > 1 else "cardan_map")
    # a rare one is compiled when it is wanted
    rare = next(lanes for lanes in prebuilt.WIDTHS if lanes != width)
    assert Path(kernels.library(lanes=rare)._name).parent != sources / "built"


def test_what_is_newer_is_compiled_again(sources: Path) -> None:
    installed(sources)
    assert installed(sources) == []
    before = kernels.library()._name
    with open(sources / "map.c", "a", encoding="utf-8") as file:
        file.write("int cardan_added(void);\nint cardan_added(void) { return 7; }\n")
    prebuilt.reread()
    kernels._library.cache_clear()
    # not installed again yet: the sources that are there are what runs
    assert prebuilt.current() is None
    assert kernels.library().cardan_added() == 7
    # lanes do not read that file
    assert sorted(installed(sources)) == ["scalar", "scalar-exact"]
    kernels._library.cache_clear()
    after = kernels.library()
    assert (after.cardan_added(), Path(after._name).parent) == (7, sources / "built")
    assert not Path(before).exists()


@pytest.mark.parametrize("harm", ["machine", "sources", "no JSON", "a list", "other keys", "gone"])
def test_an_index_that_is_not_of_here_is_left_alone(sources: Path, harm: str) -> None:
    installed(sources)
    path = sources / "built" / "index.json"
    known = json.loads(path.read_text("utf-8"))
    changed = {
        "machine": {**known, "machine": "linux pdp11"},
        "sources": {**known, "sources": "0" * 64},
        "a list": [1, 2],
        "other keys": {**known, "more": 1},
    }
    path.write_text(json.dumps(changed[harm]) if harm in changed else "{", "utf-8")
    if harm == "gone":
        path.unlink()
    prebuilt.reread()
    assert prebuilt.current() is None
    assert Path(kernels.library()._name).parent != sources / "built"


def test_kernels_need_no_compiler(sources: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    installed(sources)
    monkeypatch.setenv("CC", "no-such-compiler")
    assert Path(kernels.library()._name).parent == sources / "built"
    with pytest.raises(BuildError, match="no-such-compiler"):
        cache.compiler()


def test_level_that_the_processor_has_not_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CARDAN_LEVEL", "x86-64-v9")
    with pytest.raises(BuildError, match=r"CARDAN_LEVEL='x86-64-v9'.*has: "):
        cache.compiler()


def test_first_run_compiles_no_kernel(tmp_path: Path) -> None:
    """In an empty cache: what the compiler is given are files of the model alone."""
    if prebuilt.current() is None:
        pytest.skip("cardan was installed without kernels of these sources")
    code = (
        "from cardan.build import toolchain, cache\n"
        "whole = toolchain.compile_shared\n"
        "def told(by, sources, *more):\n"
        "    print(*sources, sep='\\n')\n"
        "    whole(by, sources, *more)\n"
        "cache.compile_shared = told\n"
        "import cardan as cd\n"
        "from analyses.conftest import double_scene\n"
        "model = cd.compile(double_scene())\n"
        "model.simulate(1.0, q={'elbow': 0.3})\n"
        "model.prepare('rhs', batch=True)\n"
        "model.ensemble(1.0, q={'elbow': [0.1, 0.2, 0.3]})\n"
    )
    paths = os.pathsep.join([str(ROOT / "src"), str(ROOT / "tests")])
    environment = {**os.environ, "PYTHONPATH": paths, "CARDAN_CACHE": str(tmp_path)}
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "rhs.c" in done.stdout
    assert "kernels" not in done.stdout, done.stdout


@pytest.mark.slow
def test_levels_agree_to_the_bit_without_contraction(monkeypatch: pytest.MonkeyPatch) -> None:
    found, highest = {}, cache.level()
    for level in cpu_levels.family():
        if level.number <= highest.number:
            monkeypatch.setenv("CARDAN_LEVEL", level.name)
            compiled = cd.compile(double_scene(), functions=("rhs", "energy"))
            compiled.prepare("rhs")
            model = CompiledModel(compiled.directory, reproducible=True)
            found[level.name] = model.simulate(3.0, q={"elbow": 0.4}).x.tobytes()
    print(", ".join(found))
    assert len(set(found.values())) == 1


@pytest.mark.slow
def test_an_installation_compiles_one_level_soon(tmp_path: Path) -> None:
    """That of the processor, in the usual variants; what they weigh and take is printed."""
    before, lines = processor_time(), []
    kernels.install(tmp_path / "built", (), cache.compiler(), lines.append)
    spent = (processor_time() - before) / 2
    print("\n".join(lines), f"of the processor: {spent:.1f} s on each of two cores", sep="\n")
    assert {line.split()[1] for line in lines[1:-1]} == {cache.level().name}
    assert spent < AT_ONCE


@pytest.mark.slow
@pytest.mark.parametrize("target", ELSEWHERE)
def test_kernels_are_linked_for_other_systems(
    target: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Linked, not run: every name that is called is there, and those that Python asks for."""
    # libraries of the system are made as well
    monkeypatch.setenv("CARDAN_COMPILE_SECONDS", "3000")
    if not toolchain.ziglang():
        pytest.skip("needs the package ziglang")
    (zig,) = toolchain.ziglang()
    level = cpu_levels.FAMILIES[target.partition("-")[0]][-1]
    command = (*zig.command, "-target", target)
    # names are the same however fast the code is
    options = tuple("-O0" if flag == "-O2" else flag for flag in toolchain.COMMON_FLAGS)
    identity = toolchain.ask_version(command)
    by = toolchain.Compiler(command, zig.binary, identity, options, level)
    names = {f"cardan_{kernel}_method" for kernel in KERNELS} | {"cardan_run_drive", "cardan_map"}
    wide = {f"cardan_{m.kernel}_lane_method" for m in INTEGRATORS.values() if m.lanes}
    for lanes, wanted in ((1, names), (level.lanes, wide)):
        variant = prebuilt.Variant(lanes=lanes)
        library = tmp_path / variant.name
        given = False, tmp_path / "zig", variant.macros
        toolchain.compile_shared(by, variant.sources(), kernel_files.includes(), library, *given)
        content = library.read_bytes()
        assert content.startswith(ELSEWHERE[target])
        assert not {name for name in wanted if name.encode() not in content}
        print(f"{target}, {variant.name}: {len(content)} bytes, linked, not run")


@pytest.mark.slow
def test_models_and_kernels_use_one_level(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a model is compiled with says so, and no more than the level allows."""
    by = cache.compiler()
    assert "native" not in " ".join(by.flags())
    assert set(by.level.flags) <= set(by.flags()) or "zig" in " ".join(by.command)
    least = cpu_levels.family()[0]
    monkeypatch.setenv("CARDAN_LEVEL", least.name)
    assert cache.compiler().level == least
    model = cd.compile(double_scene())
    assert np.isfinite(model.simulate(0.1).x).all()
