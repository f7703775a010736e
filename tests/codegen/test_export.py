"""Exported models: plain C that compiles alone, nobody's files touched."""

import ctypes
import errno
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.codegen import layout
from cardan.codegen.export import companions
from cardan.codegen.layout import HEADERS
from cardan.errors import CodegenError, DerivationError
from cardan.schema import kernel_files
from cardan.schema.functions import FUNCTIONS
from codegen.lanes import aligned
from codegen.models import arm
from codegen.running import SPEED, STRICT, Inputs, compilers, pointer
from mechanisms.closed_planar import four_bar
from spread import some

MAIN = """
#include "functions.h"
#include <stdio.h>

int main(void)
{
    static real p[64], q[16], u[16], tau[16], t[1];
    static wreal w[forward_dynamics_w_size + 1];
    static real out[forward_dynamics_out_size], work[forward_dynamics_work_size + 1];
    static const double values[] = {PARAMETERS};
    for (int i = 0; i < cardan_np; ++i) p[i] = values[i];
    q[q_float_qw] = 1.0;
    q[q_elbow] = 0.4;
    prepare_forward_dynamics(p, w);
    cardan_in in = {0};
    in.t = t;
    in.q = q;
    in.u = u;
    in.tau = tau;
    in.w = w;
    const int status = forward_dynamics(&in, out, work);
    for (int i = 0; i < forward_dynamics_out_size; ++i) printf("%.17g\\n", out[i]);
    return status;
}
"""


@pytest.mark.parametrize("compiler", sorted(compilers()))
def test_exported_files_compile_alone_and_compute(compiler: str, tmp_path: Path) -> None:
    equations = cd.derive(arm())
    folder = equations.export(tmp_path / "arm")
    values = [p.value for p in equations.system.parameters]
    main = MAIN.replace("PARAMETERS", ", ".join(map(repr, values)))
    (tmp_path / "main.c").write_text(main)
    program = tmp_path / "main"
    sources = sorted(map(str, folder.glob("*.c")))
    # gcc warns of more when it optimizes
    flags = (*STRICT, *(SPEED if compiler == "gcc" else ()))
    command = [*compilers()[compiler], *flags, f"-I{folder}", str(tmp_path / "main.c")]
    answer = subprocess.run(
        [*command, *sources, "-o", str(program), "-lm"], capture_output=True, text=True, check=False
    )
    assert answer.returncode == 0, answer.stderr
    run = subprocess.run([str(program)], capture_output=True, text=True, check=True)
    exported = [float(line) for line in run.stdout.split()]
    model = cd.compile(equations, functions=("forward_dynamics",))
    state = model.split(model.initial(q={"elbow": 0.4, "shoulder": 0.0}))
    assert exported == pytest.approx(model.forward_dynamics(*state).tolist(), rel=1e-11, abs=1e-11)


def test_files_are_those_of_the_manifest(tmp_path: Path) -> None:
    folder = cd.derive(arm()).export(tmp_path / "arm", ["bias", ("pose", "tool")])
    data = json.loads((folder / "manifest.json").read_text("utf-8"))
    assert {p.name for p in folder.iterdir()} == {"manifest.json", *data["sha256"]}
    assert set(data["functions"]) == {"bias", "pose__tool"}
    assert data["functions"]["pose__tool"]["of"] == "tool"


def test_an_earlier_export_is_replaced(tmp_path: Path) -> None:
    cd.derive(arm()).export(tmp_path / "arm", ["bias"])
    cd.derive(arm()).export(tmp_path / "arm", ["energy"])
    assert (tmp_path / "arm" / "energy.c").exists()
    assert not (tmp_path / "arm" / "bias.c").exists()
    assert [p.name for p in tmp_path.iterdir()] == ["arm"]


@pytest.mark.parametrize("name", ["notes.txt", "energy.h"])
def test_other_peoples_files_are_left_alone(name: str, tmp_path: Path) -> None:
    folder = tmp_path / "arm"
    cd.derive(arm()).export(folder, ["bias"])
    before = (folder / "manifest.json").read_bytes()
    (folder / name).write_text("mine")
    with pytest.raises(CodegenError, match=name):
        cd.derive(arm()).export(folder, ["energy"])
    assert (folder / name).read_text() == "mine"
    assert (folder / "manifest.json").read_bytes() == before


def test_a_failure_leaves_nothing_behind(tmp_path: Path) -> None:
    with pytest.raises(DerivationError, match="Did you mean 'energy'"):
        cd.derive(arm()).export(tmp_path / "arm", ["enrgy"])
    with pytest.raises(DerivationError):
        cd.derive(arm()).export(tmp_path / "arm", ["bias", ("pose", "nowhere")])
    assert list(tmp_path.iterdir()) == []
    (tmp_path / "file").write_text("x")
    with pytest.raises(CodegenError, match="is a file"):
        cd.derive(arm()).export(tmp_path / "file")


def example_of(folder: Path, quick: bool = True) -> list[str]:
    """What the example prints when it is compiled as its first line says; quick without -O2."""
    first = (folder / "example.c").read_text("utf-8").splitlines()[0]
    command = first.removeprefix("/* Try it:  ").removesuffix(" */")
    assert " -O2 " in command
    if quick:
        command = command.replace(" -O2 ", " -O0 ")
    answer = subprocess.run(["sh", "-c", command], cwd=folder, capture_output=True, text=True)
    assert answer.returncode == 0, answer.stderr
    return answer.stdout.splitlines()


def numbers(lines: list[str], name: str) -> list[float]:
    return [float(line.split(" = ")[1]) for line in lines if line.startswith(f"{name}[")]


def test_no_room_for_an_export_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    equations = cd.derive(arm())
    for name in ("_write", "add_files"):
        with monkeypatch.context() as patched:
            patched.setattr(layout, name, full)
            with pytest.raises(CodegenError, match="No space left"):
                equations.export(tmp_path / "c", functions=["energy"], language="c")
    assert list(tmp_path.iterdir()) == []


# Radau runs over events
@pytest.mark.parametrize("method", some(companions.INTEGRATORS, 2))
def test_the_example_simulates(method: str, tmp_path: Path) -> None:
    scene = arm()
    equations = cd.derive(scene)
    folder = equations.export(
        tmp_path / "arm", ["forward_dynamics"], language="c", integrators=(method,)
    )
    lines = example_of(folder, quick=method != "dop853")
    model = cd.compile(equations)
    start = model.initial()
    udot = model.forward_dynamics(*model.split(start))
    assert numbers(lines, "forward_dynamics") == pytest.approx(udot.tolist(), abs=1e-12)
    end = model.simulate(1.0, x0=start, rtol=1e-11, atol=1e-13).x[-1]
    assert numbers(lines, "x") == pytest.approx(end.tolist(), abs=1e-6)


def test_a_closed_scene_simulates_without_python(tmp_path: Path) -> None:
    equations = cd.derive(four_bar())
    plain = equations.export(tmp_path / "plain", language="c")
    # a four-bar whose angles are all 0 is open: model.c has the start that a run in Python has
    folder = equations.export(tmp_path / "bars", language="c", integrators=("dop853",))
    for where in (plain, folder):
        assert {"close_position.c", "close_velocity.c"} <= {p.name for p in where.iterdir()}
    found = numbers(example_of(folder), "x")
    model = cd.compile(equations)
    end = model.simulate(1.0, rtol=1e-11, atol=1e-13)
    assert np.abs(model.constraints(found[: model.nq])).max() < 1e-12
    assert found == pytest.approx(end.x[-1].tolist(), abs=1e-6)


def test_files_of_integrators_are_there_and_records_know_them() -> None:
    from cardan.schema.integrators import KERNELS as METHODS

    assert set(companions.INTEGRATORS) <= set(METHODS)
    for method in companions.INTEGRATORS:
        for elements in (False, True):
            files = companions.kernels((method,), elements)
            assert all(kernel_files.file(name).is_file() for name in files)
            # a header comes along with every file that asks for it
            for name in files:
                text = kernel_files.text(name)
                asked = set(re.findall(r'^#include "(\w+\.h)"', text, re.MULTILINE))
                assert asked <= {*files, *HEADERS}, name


def test_the_package_runs_without_cardan(tmp_path: Path) -> None:
    equations = cd.derive(arm())
    functions = ["rhs", "forward_dynamics", ("pose", "tool"), "balance"]
    folder = equations.export(tmp_path / "arm", functions)
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    setup = folder / "setup.py"
    text = setup.read_text("utf-8")
    assert '"-O2"' in text
    # what is called and how does not depend on it
    setup.write_text(text.replace('"-O2"', '"-O0"'), "utf-8")
    build = [sys.executable, "setup.py", "-q", "build_ext", "--inplace"]
    subprocess.run(build, cwd=folder, check=True, env=environment, capture_output=True, timeout=300)
    program = """
import json, sys
sys.modules["cardan"] = None
import numpy as np
import arm_of_9 as m
q, u = np.linspace(-0.4, 0.4, 18).reshape(2, 9), np.linspace(-1, 1, 8)
q[:, :4] = [0.8, 0.0, 0.6, 0.0]
heavy = {m.PARAMETERS[-1]: 2.0}
failures = []
for call in (lambda: m.forward_dynamics(q[:, :5], u), lambda: m.forward_dynamics({"no": 1}, u)):
    try:
        call()
    except (ValueError, KeyError) as error:
        failures.append(str(error))
print(json.dumps([
    m.forward_dynamics(q, u, tau=u).tolist(),
    m.forward_dynamics(q, u, parameters=heavy).tolist(),
    m.rhs(0.0, np.concatenate([q[0], u])).tolist(),
    m.pose__tool(q).tolist(),
    m.balance(q, u, u, []).tolist(),
    failures,
]))
"""
    answer = subprocess.run(
        [sys.executable, "-c", program], cwd=folder, env=environment,
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert answer.returncode == 0, answer.stderr
    found = json.loads(answer.stdout)
    model = cd.compile(equations)
    q, u = np.linspace(-0.4, 0.4, 18).reshape(2, 9), np.linspace(-1, 1, 8)
    q[:, :4] = [0.8, 0.0, 0.6, 0.0]
    heavy = {[*model.parameters][-1]: 2.0}
    expected = [
        model.forward_dynamics(q, u, tau=u),
        model.with_parameters(heavy).forward_dynamics(q, u),
        model.rhs(0.0, np.concatenate([q[0], u])),
        model.pose("tool", q),
        model.inverse_dynamics(q, u, u),
    ]
    for ours, theirs in zip(expected, found, strict=False):
        np.testing.assert_allclose(theirs, ours, rtol=1e-11, atol=1e-12)
    assert "q must have shape (..., 9), not (2, 5)" in found[-1][0]
    assert "there is no 'no'" in found[-1][1]


@pytest.mark.parametrize("compiler", sorted(compilers()))
def test_exported_files_are_compiled_for_lanes(compiler: str, tmp_path: Path) -> None:
    folder = cd.derive(arm()).export(tmp_path / "arm", ["forward_dynamics", "bias"])
    assert "-DCARDAN_LANES=8" in (folder / "README.md").read_text("utf-8")
    command = [*compilers()[compiler], *STRICT, "-O2", "-shared", "-fPIC", "-DCARDAN_LANES=8"]
    both = ["-Dforward_dynamics=wide", "-Dprepare_forward_dynamics=prepare_wide"]
    for name, words in (("one", command[:-1]), ("wide", [*command, *both])):
        sources = ["forward_dynamics.c", *(["bias.c", "model.c"] if name == "one" else [])]
        done = subprocess.run(
            [*words, "-ffp-contract=off", "-I.", "-o", f"{name}.o.so", *sources, "-lm"],
            cwd=folder, capture_output=True, text=True, check=False,
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
    single, wide = (ctypes.CDLL(str(folder / f"{name}.o.so")) for name in ("one", "wide"))
    entry = json.loads((folder / "manifest.json").read_text())["functions"]["forward_dynamics"]
    rng = np.random.default_rng(1)
    given = {name: aligned((9, 8)) for name in entry["inputs"] if name != "p"}
    for array in given.values():
        array[:] = rng.uniform(-1, 1, array.shape)
    w = np.zeros(entry["prepared_size"])
    p = (ctypes.c_double * 100).in_dll(single, "cardan_default_p")
    wide.prepare_wide(p, pointer(w))
    out, work = aligned((8, 8)), aligned((entry["work_size"] + 1, 8))
    blocks = Inputs(**{name: pointer(array) for name, array in given.items()}, w=pointer(w))
    assert wide.wide(ctypes.byref(blocks), pointer(out), pointer(work)) == 0
    for lane in range(8):
        own = {name: array[:, lane].copy() for name, array in given.items()}
        alone, scratch = np.zeros(8), np.zeros(entry["work_size"] + 1)
        blocks = Inputs(**{name: pointer(array) for name, array in own.items()}, w=pointer(w))
        single.forward_dynamics(ctypes.byref(blocks), pointer(alone), pointer(scratch))
        assert out[:, lane].tobytes() == alone.tobytes()


def test_unknown_words_are_refused(tmp_path: Path) -> None:
    equations = cd.derive(arm())
    with pytest.raises(CodegenError, match=r"language 'cyton' .* Did you mean 'cython'"):
        equations.export(tmp_path / "arm", language="cyton")
    with pytest.raises(CodegenError, match=r"integrators: 'dop835' .* Did you mean 'dop853'"):
        equations.export(tmp_path / "arm", integrators=("dop835",))
    assert list(tmp_path.iterdir()) == []


def test_a_link_leads_to_its_directory_and_here_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    equations = cd.derive(arm())
    (tmp_path / "real").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / "real")
    equations.export(tmp_path / "link", ["bias"])
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real" / "bias.c").exists()
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    with pytest.raises(CodegenError, match="where you are"):
        equations.export(".", ["bias"])


@pytest.mark.parametrize("name", ["numpy", "class", "json"])
def test_packages_can_be_imported_and_hide_nothing(name: str, tmp_path: Path) -> None:
    scene = cd.Scene(name)
    body = scene.body("body", mass=1.0)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, body)
    folder = cd.derive(scene).export(tmp_path / "out", ["bias"])
    assert (folder / f"{name}_model.pyx").exists()


def test_scenes_with_states_and_events(tmp_path: Path) -> None:
    scene = cd.Scene("stopped", gravity=(0, 0, -9.81))
    scene.joint("z", cd.Prismatic("z"), scene.ground, scene.body("b", mass=2.0))
    scene.force("floor", cd.Stop("z", lower=0.0, restitution=0.5))
    scene.force("motor", cd.Actuator("z", 1.0, lag=0.1, start=0.3))
    directory = cd.derive(scene).export(tmp_path / "c", integrators=("dop853",))
    assert {"events.c", "transition.c", "stopped.pyx"} <= {p.name for p in directory.iterdir()}
    # files of integrators and of functions lie side by side
    assert not {path.stem for path in kernel_files.files("*.c")} & (set(FUNCTIONS) - {"derivative"})
    assert "int events(" in (directory / "events.c").read_text("utf-8")
    assert "This model has events" in (directory / "README.md").read_text("utf-8")
    sources = sorted(map(str, directory.glob("*.c")))
    flags = ["-std=c99", "-O0", "-ffp-contract=on", "-DCARDAN_EXAMPLE"]
    subprocess.run(["cc", *flags, "-o", "example", *sources, "-lm"], cwd=directory, check=True)
    done = subprocess.run(["./example"], cwd=directory, capture_output=True, text=True, check=True)
    # a fall of one second, over the stop, with the force of the motor
    motion = cd.compile(scene).simulate(1.0, rtol=1e-9, atol=1e-12)
    happens(done.stdout, motion)


def test_states_simulate_by_generalized_alpha(tmp_path: Path) -> None:
    scene = arm()
    scene.force("motor", cd.Actuator("elbow", 1.0, lag=0.1, start=0.3))
    equations = cd.derive(scene)
    folder = equations.export(tmp_path / "c", ["energy"], language="c", integrators=("alpha",))
    model = cd.compile(equations)
    end = model.simulate(1.0, method="DOP853", rtol=1e-11, atol=1e-13).x[-1]
    lines = example_of(folder, quick=True)
    # of order 2: what 1e-6 of a step leaves
    assert numbers(lines, "x") == pytest.approx(end.tolist(), abs=5e-5)


def happens(text: str, motion: cd.Trajectory) -> None:
    """A program in C has printed the motion: its events, state and modes."""
    found = re.findall(r"^event at (\S+): (\S+)$", text, re.MULTILINE)
    assert [name for _, name in found] == [event.name for event in motion.events]
    times = [event.t for event in motion.events]
    assert [float(t) for t, _ in found] == pytest.approx(times, rel=0, abs=1e-9)
    lines = text.splitlines()
    assert numbers(lines, "x") == pytest.approx(motion.x[-1].tolist(), rel=0, abs=1e-8)
    assert numbers(lines, "s") == pytest.approx(motion.s[-1].tolist(), rel=0, abs=1e-8)


def machine() -> cd.Scene:
    """Stops, sticking, a contact, samples and an end of the run."""
    scene = cd.Scene("machine", gravity=(0, 0, -9.81))
    ball = scene.body("ball", mass=2.0)
    scene.joint("z", cd.Prismatic("z"), scene.ground, ball, q0=0.6, u0=0.5)
    scene.joint("x", cd.Prismatic("x"), ball, scene.body("slider", mass=0.5), u0=2.0)
    scene.force("floor", cd.Stop("z", lower=0.0, restitution=0.6))
    scene.force("rail", cd.Friction("x", coulomb=2.0, static=2.5))
    x, v = scene.q("x"), scene.u("x")
    pid = cd.Controller.pid("x", x, v, target=0.4, kp=30.0, ki=1.0, kd=1.0, sample=0.02)
    scene.force("pid", pid)
    scene.force('a"bell"?', cd.Event(scene.q("z") - 0.3))
    return scene


# with DOP853 it ends where an event ends it
@pytest.mark.parametrize("method", some(["radau", "dop853"], 2))
def test_the_example_runs_over_events(method: str, tmp_path: Path) -> None:
    scene = machine()
    folder = cd.derive(scene).export(tmp_path / "c", language="c", integrators=(method,))
    assert "`cardan_simulate` finds them" in (folder / "README.md").read_text("utf-8")
    known = {"dop853": "DOP853", "radau": "Radau"}
    motion = cd.compile(scene).simulate(1.0, method=known[method], rtol=1e-9, atol=1e-12)
    names = {event.name for event in motion.events}
    assert {"floor.lower", "rail.stop", 'a"bell"?'} <= names
    assert len(motion.ticks) == 51
    happens("\n".join(example_of(folder)), motion)


def test_the_example_ends_where_an_event_ends_it(tmp_path: Path) -> None:
    scene = machine()
    scene.force("top", cd.Event(scene.u("z"), terminal=True, direction="down"))
    folder = cd.derive(scene).export(tmp_path / "c", language="c", integrators=("dop853",))
    motion = cd.compile(scene).simulate(1.0, rtol=1e-9, atol=1e-12)
    assert motion.status == "event"
    happens("\n".join(example_of(folder)), motion)
