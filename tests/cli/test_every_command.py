"""What holds for every command: exit status, streams, JSON, interrupts, completion."""

from __future__ import annotations

import json
import re
import shlex
import shutil
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

import cardan as cd
from cardan import cli
from cardan.cli import COMMANDS, build_parser, main
from cardan.cli import inspect as inspect_command
from cardan.runtime import formats
from table import each

ARM = str(Path(__file__).parents[2] / "examples" / "arm.urdf")

# a call that works and prints JSON, of every command that has --json
WORKING = {
    "check": (ARM,),
    "inspect": (ARM,),
    "simulate": (ARM, "--time", "0.1"),
    "equilibrium": (ARM,),
    "statics": (ARM, "--sweep", "gravity.z=-1,-9.81"),
    "continuation": (ARM, "--vary", "gravity.z=-1:-9.81"),
    "modes": (ARM,),
    "linearize": (ARM,),
    "identify": (ARM,),
    "fit": (ARM, "run.csv", "--unknown", "q0.waist"),
    "trim": (ARM, "--target", "elbow=0.5", "--free", "elbow.driving_force"),
    "ensemble": (ARM, "--time", "0.1", "--vary", "waist=0,1"),
    "report": (ARM, "--time", "0.1", "--methods", "DOP853", "RK4"),
    "bench": (ARM, "--peers", "casadi", "--functions", "mass_matrix"),
    "export": (ARM, "-o", "arm_c", "--functions", "bias"),
    "parts": (),
    "convert": (ARM, "-o", "arm.yaml"),
    "page": (ARM, "-o", "arm.html"),
    "doctor": (),
}
READING = [name for name in WORKING if name not in ("parts", "doctor")]
MODULES = [cli, *(import_module(f"cardan.cli.{name}") for name in COMMANDS)]
HELP = [cli.help_of(module.__doc__)[1] for module in MODULES]
# a comment stands behind two blanks or more, what the shell does with the output behind >
SHOWN = [
    line
    for text in HELP
    for line in re.findall(
        r"^  cardan ((?:\S| (?! ))+)", re.sub(r" +\\\n +", " ", text), re.MULTILINE
    )
]


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    # what was measured of an arm that does not turn
    rows = "".join(f"{0.01 * k},0.1\n" for k in range(20))
    (tmp_path / "run.csv").write_text(f"t [s],waist [rad]\n{rows}")


def status(*words: str) -> int:
    try:
        return main(words)
    except SystemExit as stop:
        return int(stop.code or 0)


def test_every_command_is_here() -> None:
    with_json = {
        name
        for name, parser in build_parser(*COMMANDS)._subparsers._group_actions[0].choices.items()
        if "--json" in parser._option_string_actions
    }
    assert with_json == set(WORKING)
    assert set(COMMANDS) - with_json == {"demo"}


@each("line", SHOWN)
def test_lines_of_the_help_are_understood(line: str) -> None:
    words = shlex.split(line.partition(" > ")[0])
    if "--help" not in words:
        assert build_parser(words[0]).parse_args(words).command == words[0]


@pytest.mark.parametrize("command", WORKING)
def test_json_alone_goes_to_standard_output(
    command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert status(command, *WORKING[command], "--json") in ((0, 1) if command == "doctor" else (0,))
    assert json.loads(capsys.readouterr().out)


@pytest.mark.parametrize("command", READING)
def test_a_faulty_scene_is_1_and_says_where(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene = tmp_path / "bad.yaml"
    scene.write_text("cardan: 2\nname: bad\nbodies:\n  bob: {mass: 1, con: [0, 0, 1]}\n")
    words = tuple(str(scene) if word == ARM else word for word in WORKING[command])
    assert status(command, *words) == 1
    found = capsys.readouterr()
    said = found.out if command == "check" else found.err
    assert "bad.yaml:4" in said
    assert "com" in said
    assert not list(tmp_path.glob("arm_c*"))


@pytest.mark.parametrize("command", WORKING)
def test_wrong_use_is_2(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert status(command, *WORKING[command], "--no-such-option") == 2
    assert "usage:" in capsys.readouterr().err


def test_an_interrupt_is_130(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(_: object) -> int:
        raise KeyboardInterrupt

    monkeypatch.setattr(inspect_command, "run", interrupted)
    assert status("inspect", ARM) == 130
    assert "interrupted" in capsys.readouterr().err


def test_a_reader_that_leaves_is_no_error() -> None:
    command = f"{sys.executable} -m cardan inspect {ARM} --json | head -c 10"
    answer = subprocess.run(command, shell=True, capture_output=True, text=True, check=True)
    assert "Traceback" not in answer.stderr
    assert "Exception" not in answer.stderr


def test_check_lists_the_worst_first(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot = tmp_path / "arm.urdf"
    text = Path(ARM).read_text("utf-8").replace('rpy="0 0 0"', 'rpy="0 0 1.5708"', 1)
    robot.write_text(text, "utf-8")
    assert status("check", str(robot), "--json") == 0
    levels = [row["level"] for row in json.loads(capsys.readouterr().out)]
    assert levels == sorted(levels, key=("error", "warning", "note").index)
    assert "warning" in levels


@pytest.mark.skipif(shutil.which("bash") is None, reason="needs bash")
@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("cardan si", {"simulate"}),
        ("cardan export --rep", {"--reproducible"}),
        ("cardan --vers", {"--version"}),
        ("cardan simulate arm", {"arm.urdf"}),
    ],
)
def test_bash_completes(
    words: str, expected: set[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "arm.urdf").touch()
    assert status("--completion", "bash") == 0
    program = (
        capsys.readouterr().out
        + f"\nCOMP_WORDS=({words}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); _cardan"
        + '\nprintf "%s\\n" "${COMPREPLY[@]}"'
    )
    answer = subprocess.run(
        ["bash", "-c", program], capture_output=True, text=True, check=True, timeout=60
    )
    assert set(answer.stdout.split()) == expected


@pytest.mark.parametrize("shell", ["zsh", "fish"])
def test_other_shells_get_all_words(shell: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert status("--completion", shell) == 0
    text = capsys.readouterr().out
    assert all(name in text for name in (*COMMANDS, "reproducible"))


@pytest.mark.parametrize(
    ("option", "file", "words"),
    [
        ("-o", "run.h5", "run.h5: runs are written to files that end in one of .nc (netCDF-3)"),
        ("-o", "run", "run: runs are written to files that end in"),
        ("-o", "run.mcpa", "Did you mean .mcap?"),
        ("--view", "run.txt", "'run.txt' does not end in"),
        ("--plot", "run.html", "'run.html' does not end in"),
    ],
)
def test_endings_are_looked_at_before_the_run(
    option: str, file: str, words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert status("simulate", ARM, option, file) == 2
    assert words in capsys.readouterr().err


def test_missing_packages_are_named_before_the_run(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(formats, "find_spec", lambda package: None)
    assert status("simulate", ARM, "-o", "run.mcap") == 2
    assert "pip install 'cardan[mcap]'" in capsys.readouterr().err


def test_check_tries_the_numbers(capsys: pytest.CaptureFixture[str]) -> None:
    assert status("check", ARM, "--base", "free") == 0
    assert "nothing resists a motion of base.u.z, waist.u" in capsys.readouterr().out


def test_check_refuses_a_relation_of_speeds_that_is_not_linear(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene = cd.Scene("bent")
    body = scene.body("body", mass=1.0)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, body)
    scene.constraint("square", scene.u("slide") ** 2 - 1.0, unit="m^2/s^2")
    scene.save(tmp_path / "bent.yaml")
    assert status("check", str(tmp_path / "bent.yaml")) == 1
    assert "error: constraint 'square' is not linear in the speeds" in capsys.readouterr().out


@pytest.mark.parametrize("command", ["check", "inspect", "simulate", "bench", "export", "ensemble"])
def test_scenes_with_states_and_modes(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    scene = cd.Scene("servo")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=2.0))
    scene.force("end", cd.Stop("x", upper=0.1, restitution=0.5))
    scene.force("motor", cd.Actuator("x", command=3.0, lag=0.1))
    scene.save("servo.yaml")
    more = {
        "simulate": ("--time", "1"),
        "bench": ("--peers", "casadi"),
        "export": ("-o", "servo_c"),
        "ensemble": ("--time", "1", "--vary", "x=0,0.05"),
    }
    assert status(command, "servo.yaml", *more.get(command, ()), "--json") == 0
    found = json.loads(capsys.readouterr().out)
    if command == "simulate":
        assert found["end"]["motor.force"] == pytest.approx(3.0, abs=1e-3)
        assert found["events"][0]["name"] == "end.upper"
    if command == "bench":
        assert all(row["error"] < 1e-15 for row in found["rows"])
    assert status(command, "servo.yaml", *more.get(command, ())) == 0


def test_scenes_with_beams_are_exported_as_c(capsys: pytest.CaptureFixture[str]) -> None:
    scene = cd.Scene("mast")
    pipe, steel = cd.section.tube(outer=0.03, inner=0.025), cd.material(E=2.1e11, nu=0.3, rho=7850)
    scene.beam("mast", scene.ground, (0, 1, 2), pipe, steel, elements=3)
    scene.save("mast.yaml")
    assert status("export", "mast.yaml", "-o", "c", "--integrators", "alpha", "--json") == 0
    files = json.loads(capsys.readouterr().out)["files"]
    assert {"tables.h", "elements.c", "alpha.c", "example.c"} <= set(files)
    assert not any(name.endswith(".pyx") for name in files)
    assert status("export", "mast.yaml", "-o", "c", "--language", "cython") == 1
    assert "--language c" in capsys.readouterr().err


def test_linear_models_are_saved(capsys: pytest.CaptureFixture[str]) -> None:
    assert status("linearize", ARM, "--save", "arm.npz") == 0
    assert cd.load_linear("arm.npz").name == cd.load(ARM).name
    assert status("linearize", ARM, "--save", "arm.csv") == 2
    assert "linear models are written to files that end in one of" in capsys.readouterr().err
    words = ("--vary", "gravity.z=-1,-9.81", "--save", "arm.npz")
    assert status("linearize", ARM, *words) == 1
    assert "--save goes with one linear model" in capsys.readouterr().err


def test_scenes_are_converted(capsys: pytest.CaptureFixture[str]) -> None:
    assert status("convert", "cart_pole", "-o", "cart.urdf", "--json") == 0
    assert "input 'push'" in json.loads(capsys.readouterr().out)["losses"]
    assert status("convert", "cart.urdf", "-o", "cart.yaml") == 0
    assert set(cd.load("cart.yaml").bodies) >= {"cart", "pole"}
    assert status("convert", "cart_pole", "-o", "strict.urdf", "--strict") == 1
    assert "URDF cannot say" in capsys.readouterr().err
    assert not Path("strict.urdf").exists()


def test_runs_are_written_by_their_endings() -> None:
    for ending, start in (("glb", b"glTF"), ("csv", b"t [s],"), ("mcap", b"\x89MCAP")):
        if ending == "mcap":
            pytest.importorskip("mcap")
        assert status("simulate", ARM, "--time", "0.1", "-o", f"run.{ending}") == 0
        assert Path(f"run.{ending}").read_bytes().startswith(start)
