"""The command line as a user meets it: words, results, exit status."""

from __future__ import annotations

import inspect
import json
import math
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import cardan as cd
from cardan.analyses.simulation.settings import LARGEST_ATOL, RATIO, default_rtol
from cardan.analyses.simulation.simulate import simulate
from cardan.cli import COMMANDS, main
from cardan.runtime.build import prebuilt, toolchain

ARM = Path(__file__).parents[2] / "examples" / "arm.urdf"


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def status(*words: str) -> int:
    """Exit status, whether returned or raised."""
    try:
        return main(words)
    except SystemExit as stop:
        return int(stop.code or 0)


@pytest.mark.parametrize("command", COMMANDS)
def test_help_teaches(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert status(command, "--help") == 0
    text = capsys.readouterr().out
    assert "examples:" in text
    assert f"cardan {command}" in text


def test_help_lists_every_command(capsys: pytest.CaptureFixture[str]) -> None:
    assert status("--help") == 0
    text = capsys.readouterr().out
    words = " ".join(text.split())
    assert all(name in words and summary in words for name, (_, summary) in COMMANDS.items())


@pytest.mark.parametrize(
    "words",
    [
        (),
        ("simulat",),
        ("simulate",),
        ("simulate", "arm.urdf", "--time", "-1"),
        ("simulate", "arm.urdf", "--q", "elbow"),
        ("simulate", "arm.urdf", "--q", "elbow=nan"),
        ("demo", "pandas"),
        ("simulate", "arm.urdf", "--set", "elbow=1"),
    ],
)
def test_wrong_use(words: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    assert status(*words) == 2
    found = capsys.readouterr()
    command = words[0] if words and words[0] in COMMANDS else ""
    assert f"usage: cardan {command}".rstrip() in found.err
    assert found.out == ""


@pytest.mark.parametrize(
    ("words", "named"),
    [
        (("missing.urdf",), "missing.urdf"),
        (("arm.yml",), "arm.yml"),
        (("double_pendulm",), "Did you mean 'double_pendulum'"),
        ((str(ARM), "--q", "elbo=0.3"), "elbow"),
    ],
)
def test_fault_of_the_scene(
    words: tuple[str, ...], named: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert status("simulate", *words) == 1
    found = capsys.readouterr()
    assert named in found.err
    assert "Traceback" not in found.err
    assert found.out == ""


def test_a_file_without_an_ending_is_told_of_examples() -> None:
    with pytest.raises(cd.ModelError, match=r"no ending that tells .*cardan\.examples\["):
        cd.load("double_pendulum")


def test_simulate_as_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ("--time", "0.5", "--q", "elbow=0.3", "--json", "-o", "run.nc", "--view", "run.html")
    assert status("simulate", str(ARM), *words) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["success"] is True
    assert found["time"] == 0.5
    assert found["start"]["elbow"] == 0.3
    assert found["start"]["waist"] == 0.0
    # the ledger counts what damping took: the rest is the integrator's
    assert abs(found["energy_residual"]) < 1e-6
    assert found["files"] == ["run.nc", "run.html"]
    assert (tmp_path / "run.nc").stat().st_size > 0
    assert "<html" in (tmp_path / "run.html").read_text(encoding="utf-8").lower()


ACTUATED = """\
cardan: 2
name: actuated
gravity: [0, 0, 0]
bodies: {cart: {mass: 1.0}}
joints: {slide: {type: prismatic, parent: ground, child: cart, axis: x}}
forces: {motor: {type: actuator, joint: slide, command: 0.0, lag: 0.5}}
"""


def test_simulate_by_a_method_from_internal_states(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene = tmp_path / "scene.yaml"
    scene.write_text(ACTUATED)
    words = (str(scene), "--time", "1", "--z", "motor.force=2", "--json")
    assert status("simulate", *words, "--method", "RK4", "--step", "0.01") == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["method"], found["steps"]) == ("RK4", 100)
    assert found["start"]["motor.force"] == 2.0
    assert found["end"]["motor.force"] == pytest.approx(2 * math.exp(-2), rel=1e-6)
    assert status("simulate", *words, "--method", "RK54") == 1
    assert "Did you mean 'RK4'" in capsys.readouterr().err
    assert status("simulate", *words[:-3], "--z", "motor.forc=2") == 1
    assert "Did you mean 'motor.force'" in capsys.readouterr().err
    # the file may say so too, and typed words come first
    scene.write_text(ACTUATED + "simulate: {time: 1, z: {motor.force: 3}, method: RK45}\n")
    assert status("simulate", str(scene), "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["method"], found["start"]["motor.force"]) == ("RK45", 3.0)
    many = (str(scene), "--vary", "slide.u=0,1", "--z", "motor.force=1", "--method", "DOP853")
    assert status("ensemble", *many) == 0
    assert "DOP853, rtol 1e-06, atol 1e-09" in capsys.readouterr().out


def test_simulate_goes_on_from_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = (str(ARM), "--time", "2", "--q", "elbow=0.3", "--checkpoint", str(tmp_path / "run"))
    assert status("simulate", *words, "--json") == 0
    first = capsys.readouterr().out
    assert status("simulate", *words, "--json") == 0
    assert capsys.readouterr().out == first
    assert status("simulate", *words, "--rtol", "1e-3") == 1
    assert "belongs to another run" in capsys.readouterr().err


def test_defaults_are_those_of_python(capsys: pytest.CaptureFixture[str]) -> None:
    assert status("simulate", str(ARM), "--q", "elbow=0.3", "--json") == 0
    end = json.loads(capsys.readouterr().out)["end"]
    model = cd.compile(cd.load(ARM))
    motion = model.simulate(10.0, q={"elbow": 0.3})
    assert list(end.values()) == motion.x[-1].tolist()
    with pytest.raises(SystemExit):
        main(("simulate", "--help"))
    text = " ".join(capsys.readouterr().out.split())
    usual = inspect.signature(simulate).parameters
    assert usual["rtol"].default is None
    default = f"{default_rtol(None, ()):.0e}".replace("e-0", "e-")
    assert f"relative tolerance per step (default {default})" in text
    ratio, most = (f"{x:.0e}".replace("e-0", "e-") for x in (RATIO, LARGEST_ATOL))
    assert usual["atol"].default is None
    assert f"absolute one (default {ratio} rtol, at most {most})" in text


def test_simulate_says_how_well_constraints_are_kept(capsys: pytest.CaptureFixture[str]) -> None:
    bicycle = "bicycle"
    assert status("simulate", bicycle, "--time", "0.1", "--json") == 0
    residuals = json.loads(capsys.readouterr().out)["residuals"]
    assert set(residuals) == {"position", "velocity"}
    assert max(residuals.values()) < 1e-11
    assert status("simulate", bicycle, "--time", "0.1") == 0
    assert "largest velocity residual of the constraints" in capsys.readouterr().out


def test_simulate_prints_a_table(capsys: pytest.CaptureFixture[str]) -> None:
    assert status("simulate", str(ARM), "--time", "0.1") == 0
    text = capsys.readouterr().out
    assert all(name in text for name in ("waist", "shoulder", "elbow", "energy residual"))


@pytest.mark.parametrize(
    ("words", "folder", "named"),
    [
        (("demo",), "demo", ("grip", "hip", "knee", "trunk", "thigh", "shin")),
        (("demo", "panda"), "demo-panda", ("panda_joint", "panda_link")),
    ],
)
def test_demo(
    words: tuple[str, ...],
    folder: str,
    named: tuple[str, ...],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert status(*words) == 0
    lines = capsys.readouterr().out.splitlines()
    text = "\n".join(lines)
    for said in (
        "derived ",
        "compiled and checked",
        "ns per call",
        "against 40 digits",
        "Pinocchio agrees to",
        "residual",
    ):
        assert said in text
    out = tmp_path / "out" / folder
    assert {path.name for path in out.iterdir()} >= {"motion.png", "motion.html", "motion.nc", "c"}
    # the six lines shown are lines of the file, and name joints and bodies
    source = (out / "c" / "forward_dynamics.c").read_text(encoding="utf-8")
    shown = [line for line in lines if line.startswith("    const real")]
    assert len(shown) == 6
    assert all(line.strip() in source for line in shown)
    assert all(any(name in line for name in named) for line in shown)
    # the five lines of Python do what they say
    program = "\n".join(line.strip() for line in lines[-7:-2])
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "motion.html").is_file()


def test_demo_without_a_compiler(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    if prebuilt.current() is None:
        pytest.skip("cardan was installed without kernels of these sources")
    monkeypatch.setenv("PATH", "/nonexistent")
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(toolchain, "ziglang", lambda: [])
    monkeypatch.setattr("cardan.runtime.calls.webassembly.available", lambda: False)
    assert status("demo") == 0
    text = capsys.readouterr().out
    for said in ("no compiler: Python evaluates them", "ns per call", "against 40 digits"):
        assert said in text
    assert (tmp_path / "out/demo/motion.html").is_file()


def test_demo_of_a_robot_that_is_not_installed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("importlib.metadata.files", lambda name: [])
    assert status("demo", "panda") == 1
    assert "cardan[demo]" in capsys.readouterr().err


def test_folders_of_packages_are_read(capsys: pytest.CaptureFixture[str]) -> None:
    mesh = Path("meshes/arm_description/link.stl")
    mesh.parent.mkdir(parents=True)
    mesh.write_text("solid link\nendsolid link\n")
    Path("robot").mkdir()
    visual = "<visual><geometry><mesh filename='package://arm_description/link.stl'/></geometry></visual>"
    Path("robot/arm.urdf").write_text(
        f"<robot name='arm'><link name='base'>{visual}</link></robot>"
    )
    assert status("check", "robot/arm.urdf") == 0
    assert "not found" in capsys.readouterr().out
    assert status("check", "robot/arm.urdf", "--packages", "meshes") == 0
    assert "not found" not in capsys.readouterr().out


def test_the_command_that_compiles_an_export_stands_on_one_line(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert status("export", str(ARM), "-o", "arm_c", "--language", "c") == 0
    (line,) = (x for x in capsys.readouterr().out.splitlines() if "-DCARDAN_EXAMPLE" in x)
    command = line.partition(":")[2].split("&&")[0]
    subprocess.run(command, shell=True, cwd="arm_c", check=True)
    done = subprocess.run(["./example"], cwd="arm_c", capture_output=True, text=True, check=True)
    assert "[0] = " in done.stdout


def test_an_export_as_webassembly_says_how_to_try_it(capsys: pytest.CaptureFixture[str]) -> None:
    options = ("export", str(ARM), "-o", "arm_wasm", "--language", "wasm")
    assert status(*options, "--integrators", "dop853") == 1
    assert "cardan page" in capsys.readouterr().err
    assert status(*options) == 0
    (line,) = (x for x in capsys.readouterr().out.splitlines() if x.startswith("try it there"))
    command = line.partition(":")[2].split()
    assert command == ["node", "example.mjs"]
    if shutil.which("node"):
        done = subprocess.run(command, cwd="arm_wasm", capture_output=True, text=True, check=True)
        assert done.stdout.startswith("Float64Array(")


def test_messages_quote_options_of_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    """They quoted arguments of Python: ``packages=``, ``limits='stop'``, ``friction=True``."""
    mesh = "<visual><geometry><mesh filename='package://arm/rod.stl'/></geometry></visual>"
    inertial = "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial>"
    Path("arm.urdf").write_text(
        f"<robot name='arm'><link name='base'/><link name='rod'>{inertial}{mesh}</link>"
        "<joint name='a' type='revolute'><parent link='base'/><child link='rod'/>"
        "<axis xyz='0 0 1'/><limit lower='-1' upper='1'/><dynamics friction='1'/></joint></robot>"
    )
    options = ("load the file with --limits stop", "with --friction", "--packages names the")
    for command in ("check", "inspect"):
        assert status(command, "arm.urdf") == 0
        text = "".join(capsys.readouterr())
        assert all(option in text for option in options), text
        assert not [word for word in ("limits='", "friction=", "packages=") if word in text]
    Path("arm.yaml").write_text("cardan: 1\nbodies: {rod: {mass: 1}}\n")
    assert status("inspect", "arm.yaml", "--base", "free") == 1
    assert "--base and --mimic are for robots" in capsys.readouterr().err


def test_a_warning_that_is_a_note_is_printed_once(capsys: pytest.CaptureFixture[str]) -> None:
    Path("arm.urdf").write_text("<robot name='arm'><link name='base'><intertial/></link></robot>")
    assert status("inspect", "arm.urdf") == 0
    assert capsys.readouterr().err.count("Did you mean 'inertial'?") == 1
