"""Options of FMUs: kept, or refused with a cure; files appear whole or not at all."""

from __future__ import annotations

import errno
import json
import zipfile
from pathlib import Path
from typing import Any

import pytest

import cardan as cd
from cardan.cli import main
from cardan.codegen.export.companions import INTEGRATORS
from cardan.codegen.export.finite_elements import METHODS
from cardan.codegen.fmu import archive
from cardan.errors import CodegenError, CompilerMissing, ModelError
from cardan.runtime.build import cache_folder, toolchain
from codegen.fmu.importing import Instance, description, equations_of, problems
from codegen.running import compilers

pytestmark = pytest.mark.skipif(not compilers(), reason="needs a C compiler")


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"fmi": "1.0"}, r"versions are '2.0', '3.0'"),
        ({"kinds": "cs"}, r"give a tuple such as \('cs',\)"),
        ({"kinds": ()}, "give a tuple"),
        ({"kinds": ("cs", "xx")}, "'xx' does not exist"),
        ({"platforms": ("widows",)}, "Did you mean 'windows'"),
        ({"platforms": "linux"}, r"give a tuple such as \('linux'"),
        ({"platforms": ("macos",), "fmi": "2.0"}, "macos-x86_64; fmi='3.0' has all"),
        ({"integrators": ("dopri",)}, "'dopri' does not exist"),
        ({"functions": ["rhs"]}, "Leave functions= out"),
        ({"language": "c"}, "Leave language= out"),
        ({"prefix": "arm_"}, "Leave prefix= out"),
        ({"loops": True}, "Leave loops= out"),
        ({"precision": "single"}, "Leave precision= out"),
    ],
)
def test_options_that_do_not_fit_are_refused(
    options: dict[str, Any], message: str, tmp_path: Path
) -> None:
    with pytest.raises(CodegenError, match=message):
        equations_of("pendulum").export(tmp_path / "x.fmu", **options)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("option", ["fmi", "kinds", "platforms", "q", "u"])
def test_options_of_units_do_not_go_with_directories(option: str, tmp_path: Path) -> None:
    value = {"fmi": "3.0", "kinds": ("cs",), "platforms": ()}.get(option, {"shoulder": 1.0})
    with pytest.raises(CodegenError, match=rf"ends with \.fmu instead of .*{tmp_path.name}"):
        equations_of("pendulum").export(tmp_path / "x", **{option: value})


def test_a_start_that_does_not_exist_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ModelError, match="sholder"):
        equations_of("pendulum").export(tmp_path / "x.fmu", q={"sholder": 1.0})
    with pytest.raises(ModelError):
        equations_of("four_bar").export(tmp_path / "x.fmu", q={"A": 0.5, "D": 0.5})
    assert list(tmp_path.iterdir()) == []


def test_beams_go_with_co_simulation_alone(tmp_path: Path) -> None:
    with pytest.raises(CodegenError, match=r"kinds=\('cs',\) integrates it inside"):
        equations_of("rubber").export(tmp_path / "x.fmu", kinds=("me", "cs"))
    for method in {*INTEGRATORS} - {*METHODS}:
        with pytest.raises(CodegenError, match="goes with"):
            equations_of("rubber").export(tmp_path / "x.fmu", integrators=(method,))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_one_kind_alone(tmp_path: Path) -> None:
    path = equations_of("pendulum").export(tmp_path / "x.fmu", kinds=("cs",))
    assert problems(path) == []
    about = description(path)
    assert about.modelExchange is None
    assert not [v for v in about.modelVariables if v.name.startswith("der(")]
    path = equations_of("bouncing").export(tmp_path / "y.fmu", kinds=("me",), fmi="2.0")
    assert problems(path) == []
    assert description(path).coSimulation is None


@pytest.mark.slow
def test_another_method(tmp_path: Path) -> None:
    path = equations_of("pendulum").export(tmp_path / "x.fmu", integrators=("radau", "rk4"))
    assert problems(path) == []
    with Instance(path) as one, Instance(equations_path(tmp_path)) as usual:
        for each in (one, usual):
            each.set({"shoulder": 1.0})
            each.begin(1e-9, 1.0)
            each.step(0.0, 1.0)
        assert one.get("elbow") == pytest.approx(usual.get("elbow"), abs=1e-7)
        assert one.get("elbow") != usual.get("elbow")


def equations_path(folder: Path) -> Path:
    path: Path = equations_of("pendulum").export(folder / "usual.fmu")
    return path


def test_sources_alone(tmp_path: Path) -> None:
    path = equations_of("pendulum").export(tmp_path / "x.fmu", platforms=())
    with zipfile.ZipFile(path) as content:
        names = content.namelist()
        assert not [n for n in names if n.startswith("binaries/")]
        assert "sources/fmu_model.c" in names
        assert "documentation/licenses/FMI_headers.txt" in names
        assert "Sources only" in content.read("documentation/index.html").decode()


@pytest.mark.slow
@pytest.mark.skipif("clang" not in compilers(), reason="needs ziglang")
def test_other_platforms_are_linked(tmp_path: Path) -> None:
    where = ("linux", "linux-aarch64", "windows", "macos", "macos-x86_64")
    path = equations_of("pendulum").export(tmp_path / "x.fmu", platforms=where)
    assert problems(path) == []
    # what zig leaves lies where the cache expects it
    assert cache_folder.refusal(cache_folder.directory()) == ""
    magic = {
        "x86_64-linux": b"\x7fELF",
        "aarch64-linux": b"\x7fELF",
        "x86_64-windows": b"MZ",
        "aarch64-darwin": b"\xcf\xfa\xed\xfe",
        "x86_64-darwin": b"\xcf\xfa\xed\xfe",
    }
    with zipfile.ZipFile(path) as content:
        binaries = {n.split("/")[1]: n for n in content.namelist() if n.startswith("binaries/")}
        assert {*binaries} == {*magic}
        for folder, start in magic.items():
            binary = content.read(binaries[folder])
            assert binary.startswith(start)
            assert b"fmi3DoStep" in binary
        page = content.read("documentation/index.html").decode()
        assert "not run there: linux-aarch64, windows, macos, macos-x86_64" in page


def test_no_ziglang_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(toolchain, "ziglang", list)
    monkeypatch.setattr("cardan.runtime.calls.webassembly.available", lambda: False)
    with pytest.raises(CompilerMissing, match=r"pip install 'cardan\[compiler\]'"):
        equations_of("pendulum").export(tmp_path / "x.fmu", platforms=("windows",))
    assert list(tmp_path.iterdir()) == []


def test_a_full_disk_leaves_the_old_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = equations_of("pendulum").export(tmp_path / "x.fmu", platforms=())
    before = path.read_bytes()

    def full(self: Path, content: bytes) -> int:
        with open(self, "wb") as file:
            file.write(content[:100])
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(archive.Path, "write_bytes", full)
    with pytest.raises(CodegenError, match="No space left on device"):
        equations_of("pendulum").export(path, platforms=(), fmi="2.0")
    monkeypatch.undo()
    assert path.read_bytes() == before
    assert [p.name for p in tmp_path.iterdir()] == ["x.fmu"]


def test_a_directory_is_not_replaced(tmp_path: Path) -> None:
    (tmp_path / "x.fmu").mkdir()
    with pytest.raises(CodegenError, match="is a directory"):
        equations_of("pendulum").export(tmp_path / "x.fmu")


def test_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = Path(cd.__file__).parent / "scenes" / "double_pendulum.yaml"
    target = tmp_path / "deep" / "arm.fmu"
    options = ["--fmi", "2.0", "--kind", "cs", "--q", "shoulder=pi/3", "--json"]
    assert main(["export", str(scene), "-o", str(target), *options]) == 0
    said = json.loads(capsys.readouterr().out)
    assert said["fmi"] == "2.0"
    assert said["kinds"] == ["CoSimulation"]
    starts = {v.name: v.start for v in description(target).modelVariables}
    assert float(starts["shoulder"]) == pytest.approx(1.0471975511965976)
    assert main(["export", str(scene), "-o", str(target)]) == 0
    assert "fmpy simulate" in capsys.readouterr().out
