"""What users install: the source archive, the wheel, and what runs of it without a compiler."""

from __future__ import annotations

import email
import json
import os
import platform
import re
import resource
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

from cardan.build import cpu_levels, prebuilt, toolchain

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
# what the kernels may weigh in a wheel and it may take to build, what the README may take
# [bytes, s on two cores, s]
WEIGHT, PATIENCE, SOON = 3e6, 180.0, 15.0
BACKEND = "import sys; sys.path.insert(0, '.'); import setup; "
# no compiler, neither on the path nor as a package
BARE = "import os, sys; sys.modules['ziglang'] = None; os.environ['PATH'] = '/nonexistent'; "
SHIPPED = ("pyproject.toml", "setup.py", "MANIFEST.in", "README.md", "LICENSE", "CHANGELOG.md")


def processor_time() -> float:
    """Of all programs that were run so far [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def python(code: str, folder: Path, **more: str) -> str:
    """What a program prints in a folder; variables of the environment besides or, empty, not."""
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", **more}
    environment = {name: value for name, value in environment.items() if value}
    command = [sys.executable, "-c", code]
    done = subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def sources() -> set[str]:
    """Files of the package as they are kept, below ``src``."""
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", "src"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    if listed.returncode or not listed.stdout:
        pytest.skip("what belongs to the package is what git lists")
    return {name.removeprefix("src/") for name in listed.stdout.split("\n") if name}


@pytest.fixture(scope="module")
def archive(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The source archive of this tree, unpacked."""
    place = tmp_path_factory.mktemp("archive")
    tree = place / "tree"
    hidden = shutil.ignore_patterns("*.so", "built", "*.egg-info", "__pycache__", ".*")
    shutil.copytree(ROOT / "src", tree / "src", ignore=hidden)
    for name in SHIPPED:
        shutil.copy(ROOT / name, tree)
    python(BACKEND + f"setup.build_sdist({str(place)!r})", tree)
    (packed,) = place.glob("*.tar.gz")
    with tarfile.open(packed) as opened:
        opened.extractall(place / "unpacked", filter="data")
    print(f"{packed.name}: {packed.stat().st_size} bytes")
    (unpacked,) = (place / "unpacked").iterdir()
    return unpacked


@pytest.fixture(scope="module")
def wheel(archive: Path) -> Path:
    """The wheel that is built from the archive; what it weighs and takes is printed."""
    before, place = processor_time(), archive.parents[1] / "wheel"
    printed = python(BACKEND + f"setup.build_wheel({str(place)!r})", archive, CARDAN_GLIBC="")
    # libraries are compiled side by side
    spent = (processor_time() - before) / 2
    print("\n".join(line for line in printed.splitlines() if line.startswith("kernels:")))
    (found,) = place.glob("*.whl")
    print(f"{found.name}: {found.stat().st_size} bytes; {spent:.0f} s")
    assert spent < PATIENCE
    return found


def test_archive_holds_all_that_a_build_reads(archive: Path) -> None:
    there = {path.relative_to(archive).as_posix() for path in archive.rglob("*") if path.is_file()}
    assert {*SHIPPED, "PKG-INFO", *(f"src/{name}" for name in sources())} <= there
    # and nothing that was compiled
    assert not {name for name in there if name.endswith((".so", ".pyd"))}


def test_wheel_holds_the_package(wheel: Path) -> None:
    """Modules, stubs, kernels, pages, scenes: whatever lies beside the modules."""
    with zipfile.ZipFile(wheel) as opened:
        inside = {name for name in opened.namelist() if ".dist-info/" not in name}
    built = {name for name in inside if name.startswith("cardan/kernels/built/")}
    compiled = {name for name in inside - built if name.endswith((".so", ".pyd"))}
    assert {Path(name).name for name in compiled} == {"_abi.abi3.so"}
    assert inside - built - compiled == sources() - {"cardan/runtime/calls/_abi.pyx"}


def test_wheel_holds_all_levels(wheel: Path) -> None:
    """Every variant by level."""
    with zipfile.ZipFile(wheel) as opened:
        inside = [info for info in opened.infolist() if "kernels/built/" in info.filename]
        index = json.loads(opened.read("cardan/kernels/built/index.json"))
    packed = sum(info.compress_size for info in inside)
    print(f"{packed} bytes of kernels, compressed")
    assert packed < WEIGHT
    wanted = {variant.name for variant in prebuilt.variants()}
    assert {level.name for level in cpu_levels.of_wheels()} == set(index["objects"])
    assert all(set(made) == wanted for made in index["objects"].values())
    files = {name for made in index["objects"].values() for name in made.values()}
    assert {Path(info.filename).name for info in inside} == {*files, index["level"], "index.json"}


@pytest.mark.skipif(sys.platform != "linux", reason="the names of wheels for Linux")
def test_name_says_which_pythons_and_systems(wheel: Path, tmp_path: Path) -> None:
    """CPython from 3.11 on, and a glibc: the newest that readelf finds in any shared object."""
    *_, python_tag, abi, system = wheel.stem.split("-")
    assert (python_tag, abi) == ("cp311", "abi3")
    with zipfile.ZipFile(wheel) as opened:
        opened.extractall(tmp_path)
    (statement,) = tmp_path.glob("*.dist-info/WHEEL")
    assert email.message_from_string(statement.read_text("utf-8"))["Tag"] == f"cp311-abi3-{system}"
    if platform.libc_ver()[0] != "glibc" or shutil.which("readelf") is None:
        pytest.skip("needs glibc and readelf")
    objects = [str(path) for path in tmp_path.rglob("*.so")]
    versions = subprocess.check_output(["readelf", "--version-info", "--wide", *objects], text=True)
    needed = {(int(a), int(b)) for a, b in re.findall(r"Name: GLIBC_(\d+)\.(\d+)", versions)}
    first, second = max(needed | {(2, 17)})
    assert system == f"manylinux_{first}_{second}_{platform.machine()}"
    here = tuple(int(part) for part in platform.libc_ver()[1].split(".")[:2])
    assert (first, second) <= here


@pytest.mark.parametrize("program", [["auditwheel", "show"], ["abi3audit", "--strict"]])
def test_wheel_passes_the_programs_of_package_indexes(wheel: Path, program: list[str]) -> None:
    if shutil.which(program[0]) is None:
        pytest.skip(f"needs {program[0]}: make wheel")
    done = subprocess.run([*program, str(wheel)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    if program[0] == "auditwheel":
        # it breaks lines
        said = " ".join(done.stdout.split())
        assert f'following platform tag: "{wheel.stem.split("-")[-1]}"' in said


def test_readme_and_demo_run_from_the_wheel_without_a_compiler(wheel: Path, tmp_path: Path) -> None:
    """With prebuilt kernels, from an empty cache; the dependencies are those of this Python."""
    with zipfile.ZipFile(wheel) as opened:
        opened.extractall(tmp_path / "site")
    here = {"PYTHONPATH": str(tmp_path / "site"), "CARDAN_CACHE": str(tmp_path / "cache"), "CC": ""}
    readme = (ROOT / "README.md").read_text("utf-8")
    program = readme.split("```python\n")[1].split("```")[0]
    told = (
        "\nfrom pathlib import Path; from cardan.build import kernels"
        "\nprint(Path(cd.__file__).parent, Path(kernels.library()._name).parent, sep='\\n')"
    )
    before = processor_time()
    package, built = python(BARE + "\n" + program + told, tmp_path, **here).splitlines()[-2:]
    spent = processor_time() - before
    print(f"README without a compiler: {spent:.1f} s")
    assert Path(package) == tmp_path / "site" / "cardan"
    assert Path(built) == Path(package) / "kernels" / "built"
    assert (tmp_path / "pendulum.html").is_file()
    assert spent < SOON
    screen = python(BARE + "from cardan.cli import main; main(['demo'])", tmp_path, **here)
    assert "no compiler: Python evaluates them" in screen
    assert (tmp_path / "out/demo/motion.html").is_file()


def test_archive_is_built_with_ziglang_alone(archive: Path, tmp_path: Path) -> None:
    """As an editable installation: its kernels are those of one level."""
    if not toolchain.ziglang():
        pytest.skip("needs the package ziglang")
    tree = shutil.copytree(archive, tmp_path / "tree")
    python(BACKEND + f"setup.build_editable({str(tmp_path)!r})", tree, PATH="/nonexistent", CC="")
    package = tree / "src" / "cardan"
    index = json.loads((package / "kernels/built/index.json").read_text("utf-8"))
    assert "clang" in index["compiler"]
    assert (package / "runtime/calls/_abi.abi3.so").is_file()


@pytest.mark.parametrize("glibc", ["", "2.17"])
def test_compiler_is_asked_for_where_there_is_none(archive: Path, glibc: str) -> None:
    """Also for a glibc that is named: only ziglang has it."""
    ask = "print(setup.get_requires_for_build_wheel())"
    found = python(BARE + BACKEND + ask, archive, CARDAN_GLIBC=glibc, CC="").splitlines()[-1]
    assert "ziglang" in found
    if glibc and toolchain.ziglang():
        # it is there by now
        assert "ziglang" not in python(BACKEND + ask, archive, CARDAN_GLIBC=glibc).splitlines()[-1]
