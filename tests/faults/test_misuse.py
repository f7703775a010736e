"""Faults of messages, arguments and what is handed to others."""

from __future__ import annotations

import re
import shutil
import subprocess
import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.cli import main


def _pendulum(name: str, length: float) -> cd.Scene:
    scene = cd.Scene(name)
    rod = scene.body("rod", mass=1, com=(0, 0, -length / 2), inertia=(0.1, 0.1, 0.01))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    return scene


BOTH = """
#include "one/functions.h"
#include "two/functions.h"
#include <stdio.h>
int main(void)
{
    double q[1] = {0.5}, u[1] = {0.0}, out[2], w[64];
    cardan_in in = {0};
    in.q = q;
    in.u = u;
    one_prepare_rhs(one_cardan_default_p, w);
    in.w = w;
    one_rhs(&in, out, 0);
    printf("%.17g\\n", out[one_cardan_nq]);
    two_prepare_rhs(two_cardan_default_p, w);
    two_rhs(&in, out, 0);
    printf("%.17g\\n", out[two_cardan_nq]);
    return 0;
}
"""


@pytest.mark.parametrize("integrators", [(), ("rk4",)])
def test_b9_two_exports_are_linked_into_one_program(
    tmp_path: Path, integrators: tuple[str, ...]
) -> None:
    """``multiple definition of rhs``: exported names had no prefix."""
    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("no cc")
    wanted = []
    for name, length in (("one", 1.0), ("two", 2.0)):
        equations = cd.derive(_pendulum(name, length))
        equations.export(
            tmp_path / name,
            functions=["rhs"],
            language="c",
            integrators=integrators,
            prefix=f"{name}_",
        )
        model = cd.compile(equations)
        wanted.append(float(model.forward_dynamics([0.5], [0.0])[0]))
        # what an export is for stays as it was: cardan loads it
        loaded = cd.load_model(tmp_path / name)
        assert loaded.rhs(0.0, [0.5, 0.0])[1] == pytest.approx(wanted[-1], rel=1e-14)
    (tmp_path / "both.c").write_text(BOTH)
    files = [str(p) for p in tmp_path.rglob("*.c")]
    command = [compiler, "-std=c99", "-Wall", "-Wextra", "-Werror", "-o", str(tmp_path / "both")]
    command += [f"-I{tmp_path}", *files, "-lm"]
    made = subprocess.run(command, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
    # the example of either, which names its method
    sources = [*map(str, (tmp_path / "one").glob("*.c")), "-DCARDAN_EXAMPLE", "-lm"]
    alone = [*command[:6], str(tmp_path / "alone"), *sources]
    made = subprocess.run(alone, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
    said = subprocess.run([str(tmp_path / "both")], capture_output=True, text=True, check=True)
    found = [float(line) for line in said.stdout.split()]
    np.testing.assert_allclose(found, wanted, rtol=1e-14)


def test_b9_a_prefix_is_the_beginning_of_a_name(tmp_path: Path) -> None:
    """A prefix that no name in C may have is refused by name."""
    equations = cd.derive(_pendulum("one", 1.0))
    with pytest.raises(cd.CodegenError, match=r"prefix='2-'.*such as 'arm_'"):
        equations.export(tmp_path / "one", language="c", prefix="2-")


INERTIA = "[0.1, 0.1, 0.5]"
SCENE = """cardan: 2
bodies:
  rod:
    mass: 1
    inertia: {inertia}
joints:
  pivot: {{type: revolute, axis: y, parent: ground, child: rod}}
"""
ROBOT = """<robot name="arm"><link name="base"/><link name="rod"><inertial><mass value="1"/>
<inertia ixx="0.1" iyy="0.1" izz="0.5" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="pivot" type="revolute"><parent link="base"/><child link="rod"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>
"""


def _files(folder: Path) -> list[Path]:
    (folder / "arm.yaml").write_text(SCENE.format(inertia=INERTIA))
    (folder / "arm.urdf").write_text(ROBOT)
    return [folder / "arm.yaml", folder / "arm.urdf"]


def _told(words: list[str], capsys: pytest.CaptureFixture[str]) -> tuple[int, str, str]:
    status = main(words)
    out, err = capsys.readouterr()
    return status, out, err


@pytest.mark.parametrize("kind", [0, 1], ids=["yaml", "urdf"])
def test_a9_check_finds_an_impossible_inertia(
    kind: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """``cardan check`` suppressed the warnings of loading: "0 errors, 0 warnings", exit 0."""
    file = _files(tmp_path)[kind]
    status, out, _ = _told(["check", str(file)], capsys)
    assert status == 1
    assert "error: " in out
    assert "'rod'" in out
    assert "triangle inequality" in out
    if kind == 0:
        assert "arm.yaml:3:3: body 'rod'" in out or "arm.yaml:4" in out, out


@pytest.mark.parametrize("command", ["simulate", "report"])
@pytest.mark.parametrize("kind", [0, 1], ids=["yaml", "urdf"])
def test_a9_warnings_are_messages_without_a_line_of_ours(
    command: str, kind: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """``simulate`` showed raw Python warnings with a file of cardan."""
    file = _files(tmp_path)[kind]
    more = ["-o", str(tmp_path / "page.html"), "--methods", "RK4"] if command == "report" else []
    status, _, err = _told([command, str(file), "--time", "0.01", *more], capsys)
    assert f"cardan {command}: " in err
    assert "triangle inequality" in err
    assert "UserWarning" not in err
    assert "ImpossibleWarning" not in err
    assert "src/cardan" not in err
    assert status == (1 if command == "report" else 0)


def test_a9_a_warning_names_the_line_of_the_caller(tmp_path: Path) -> None:
    """Warnings named a file of cardan: their stack levels were counted by hand."""
    for file in _files(tmp_path):
        with pytest.warns(cd.ModelWarning, match="triangle inequality") as said:
            cd.load(file)
        assert [one.filename for one in said] == [__file__]
    with pytest.warns(cd.ModelWarning, match="triangle inequality") as said:
        cd.Scene("a").body("rod", mass=1, inertia=(0.1, 0.1, 0.5))
    assert [one.filename for one in said] == [__file__]


def test_e9_a_negative_principal_moment_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Negative principal inertias only warned."""
    scene = cd.Scene("a")
    for inertia in ((1, 1, -0.1), {"xx": 1, "yy": 1, "zz": 1, "xy": 1.5}):
        with pytest.raises(cd.ModelError, match="negative principal moment"):
            scene.body("rod", mass=1, inertia=inertia)
    # what rounding makes of a rod
    scene.body("rod", mass=1, inertia=(1, 1, -1e-9))
    file = tmp_path / "arm.yaml"
    file.write_text(SCENE.format(inertia="[1, 1, -0.1]"))
    for words in (["check", str(file)], ["report", str(file), "-o", str(tmp_path / "a.html")]):
        status, out, err = _told(words, capsys)
        assert status == 1
        assert "negative principal moment" in out + err
        assert "arm.yaml:" in out + err


def test_a10_one_folder_of_packages_is_a_folder(tmp_path: Path) -> None:
    """``packages="folder"`` was taken letter by letter: meshes stayed "not found"."""
    (tmp_path / "meshes" / "robot").mkdir(parents=True)
    (tmp_path / "meshes" / "robot" / "rod.stl").write_bytes(b"solid")
    text = ROBOT.replace(
        '<link name="rod">',
        '<link name="rod"><visual><geometry><mesh filename="package://robot/rod.stl"/>'
        "</geometry></visual>",
    )
    (tmp_path / "arm.urdf").write_text(text.replace('"0.5"', '"0.1"'))
    meshes = tmp_path / "meshes"
    for packages in (str(meshes), meshes, [meshes], (str(meshes),)):
        scene = cd.load(tmp_path / "arm.urdf", packages=packages)
        assert not [note for note in scene.notes if "mesh" in note]
        assert scene.bodies["rod"].shapes
    notes = cd.load(tmp_path / "arm.urdf").notes
    assert [note for note in notes if note.startswith("1 mesh file was not found")]


def test_a11_parameters_that_do_not_occur_are_refused() -> None:
    """``from_sympy(parameters=...)`` accepted symbols that do not occur."""
    x, (k, m) = sympy.Function("x")(cd.t), sympy.symbols("k m")
    v = x.diff(cd.t)
    told = ([x], [v], sympy.Matrix([m]), sympy.Matrix([-k * x]))
    cd.from_sympy(told, parameters={k: 1.0, "m": 2.0})
    with pytest.raises(cd.ModelError, match=r"'mm' does not occur.*Did you mean 'm'"):
        cd.from_sympy(told, parameters={k: 1.0, m: 2.0, "mm": 2.0})


MJCF = """<mujoco><worldbody><geom name="floor" type="plane" size="1 1 .1"/><light/>
<body name="hopper" pos="0 0 1"><freejoint/><geom type="sphere" size=".1" mass="1"/>
<body name="leg" pos="0 0 -.2"><joint type="hinge" axis="0 1 0"/>
<geom type="capsule" size=".02 .1" mass=".1" friction="1"/>
<body name="foot" pos="0 0 -.2"><joint type="hinge" axis="0 1 0"/>
<geom type="capsule" size=".02 .1" mass=".1"/></body></body></body></worldbody></mujoco>
"""


def test_a15_floors_and_contacts_head_the_list_of_what_was_not_read(tmp_path: Path) -> None:
    """A hopper fell through a floor that the list did not name."""
    file = tmp_path / "hopper.xml"
    file.write_text(MJCF)
    notes = cd.load(file).notes
    assert "floor" in notes[0]
    assert "contact" in notes[0]
    assert "cd.Contact" in notes[0]
    assert any("geom friction=" in note and "light" in note for note in notes)
    # nothing is there to be touched
    file.write_text('<mujoco><worldbody><body><joint type="hinge"/><geom size=".1"/></body>'
                    "</worldbody></mujoco>")  # fmt: skip
    assert not [note for note in cd.load(file).notes if "contact" in note]
    switched = MJCF.replace("<geom ", '<geom contype="0" conaffinity="0" ')
    file.write_text(switched)
    assert not [note for note in cd.load(file).notes if "cd.Contact" in note]


def test_a15_many_bodies_with_one_doubt_are_one_warning(tmp_path: Path) -> None:
    """MJCF chains gave 20 warnings with a path of ours."""
    inside = ""
    for k in range(20):
        inside = (
            f'<body name="b{k}"><joint type="hinge" axis="0 1 0"/>'
            f'<inertial pos="0 0 0" mass="1" diaginertia=".1 .1 .5"/>{inside}</body>'
        )
    file = tmp_path / "chain.xml"
    file.write_text(f"<mujoco><worldbody>{inside}</worldbody></mujoco>")
    with pytest.warns(cd.ModelWarning) as said:
        cd.load(file)
    assert len(said) == 1
    assert said[0].filename == __file__
    text = str(said[0].message)
    assert "chain.xml" in text
    assert "and 14 more" in text


@pytest.mark.parametrize("kind", ["Planar", "Spherical", "Free"])
def test_b4_names_go_to_python_control_without_dots(kind: str) -> None:
    """python-control refused names with dots: no system with such joints came through."""
    control = pytest.importorskip("control")
    scene = cd.Scene("flying.body", gravity=(0, 0, 0))
    push = scene.input("push")
    body = scene.body("body", mass=1, inertia=(1, 2, 2.5))
    scene.joint("base", getattr(cd, kind)(), scene.ground, body)
    scene.force("motor", cd.Torque(body, (0, 0, push), in_=body))
    linear = cd.compile(scene).linearize()
    system, names = linear.to_control()
    assert isinstance(system, control.StateSpace)
    assert set(names) == {*linear.states, *linear.inputs, *linear.outputs}
    assert [names[state] for state in linear.states] == list(system.state_labels)
    assert len(set(system.state_labels)) == len(linear.states)
    np.testing.assert_array_equal(system.A, linear.A)
    # names serve: a system can be put together by them
    closed = control.interconnect([system], inputs=["push"], outputs=[])
    assert closed.ninputs == 1


def test_b5_the_page_of_a_start_at_rest_says_that_nothing_moves(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """``cardan report FILE -o page.html``: matplotlib "Data cannot be log-scaled"."""
    pytest.importorskip("matplotlib")
    file = tmp_path / "rest.yaml"
    file.write_text(SCENE.format(inertia="[0.1, 0.1, 0.1]"))
    for name in ("page.html", "page.png"):
        words = ["report", str(file), "--time", "0.1", "-o", str(tmp_path / name)]
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            status, out, err = _told([*words, "--methods", "RK4", "DOP853"], capsys)
        assert (status, err.count("Data cannot")) == (0, 0)
        assert "nothing moves from this start" in out
    page = (tmp_path / "page.html").read_text()
    assert "nothing moves from this start" in page
    assert "<svg" not in page
    assert (tmp_path / "page.png").stat().st_size > 1000


def test_b8_rounding_of_the_largest_moment_is_no_asymmetry() -> None:
    """``R @ diag @ R.T`` was refused for xy -1.9e-19 against yx -3.1e-19 at moments of 4e-3."""
    scene, rng = cd.Scene("a"), np.random.default_rng(1)
    for k in range(200):
        a, b, c = rng.uniform(1, 2, 3) * 10.0 ** rng.uniform(-9, 9)
        R = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        # rotations by tiny angles leave products far below their rounding
        R = np.eye(3) + (R - np.eye(3)) * (k % 2)
        scene.body(f"b{k}", mass=1, inertia=R @ np.diag([a, b, c]) @ R.T)
    scene.body("given", mass=1, inertia=[[4e-3, -1.9e-19, 0], [-3.1e-19, 4e-3, 0], [0, 0, 4e-3]])
    with pytest.raises(cd.ModelError, match="not symmetric"):
        scene.body("wrong", mass=1, inertia=[[4e-3, 1e-12, 0], [0, 4e-3, 0], [0, 0, 4e-3]])


def test_e9_names_that_look_the_same_are_refused() -> None:
    """Two names that differ by a combining accent or a Cyrillic letter stood side by side."""
    for one, other in (("p\u00e9n", "pe\u0301n"), ("pen", "p\u0435n"), ("\u0391rm", "Arm")):
        scene = cd.Scene("a")
        a, b = (scene.body(name, mass=1, inertia=(1, 1, 1)) for name in (one, other))
        scene.joint("j", cd.Revolute("y"), scene.ground, a)
        scene.joint("k", cd.Revolute("y"), a, b)
        with pytest.raises(cd.ModelError, match="the eye cannot tell them apart") as said:
            cd.derive(scene)
        assert all(f"U+{ord(x):04X}" in str(said.value) for x in one + other if ord(x) > 127)
    # names of one language are fine, and a look-alike that does not exist is told from its like
    scene = cd.Scene("a")
    body = scene.body("\u0440\u0443\u043a\u0430", mass=1, inertia=(1, 1, 1))
    scene.joint("p\u00e9n", cd.Revolute("y"), scene.ground, body)
    model = cd.compile(scene)
    with pytest.raises(cd.ModelError, match=r"\(U\+00E9\)\? It only looks like .*\(U\+0301\)"):
        model.initial(q={"pe\u0301n": 1.0})


def test_e9_a_text_is_no_expression_where_it_is_said() -> None:
    """``scene.output('z', text)`` was accepted and refused only later; so were its siblings."""
    scene = _pendulum("a", 1.0)
    says: list[Callable[[], object]] = [
        lambda: scene.output("z", "pivot + 1"),
        lambda: scene.constraint("z", "pivot"),
        lambda: scene.body("b", mass="2"),
        lambda: scene.body("b", mass=1, com=("x", 0, 0)),
        lambda: scene.body("b", mass=1, inertia=("x", 1, 1)),
        lambda: scene.body("b", mass=1, pose=("x", 0, 0)),
        lambda: scene.joint("k", cd.Revolute("y"), "rod", scene.body("c", mass=1), prescribed="t"),
        lambda: cd.Scene("b", gravity=("x", 0, 0)),
    ]
    for say in says:
        with pytest.raises(cd.ModelError, match="an expression is wanted, not the text"):
            say()
    assert "z" not in scene.outputs


def test_d_one_of_a_thing_is_told_in_the_singular() -> None:
    """ "1 bodies", "1 modes"."""
    model = cd.compile(_pendulum("a", 1.0))
    scene = _pendulum("a", 1.0)
    told = [repr(model), repr(model.modes()), repr(model.linearize()), repr(scene), str(scene)]
    told += [repr(cd.derive(scene)), str(cd.derive(scene)), repr(model.equilibrium())]
    told.append(str(model.simulate(1.0, q={"pivot": 1.0})))
    text = "\n".join(told)
    assert "1 body" in text
    assert "1 mode" in text
    many = r"\b1 (bodies|modes|coordinates|speeds|parameters|joints|steps|iterations|equilibria)\b"
    assert re.findall(many, text) == []


def test_d_two_numbers_are_a_span_or_times_and_an_array_of_two_is_asked() -> None:
    """``simulate([0, 1])`` was a span, ``simulate(np.array([0., 1.]))`` two times: silently."""
    model = cd.compile(_pendulum("a", 1.0))
    assert len(model.simulate([0, 1], q={"pivot": 1.0}).t) > 2
    assert len(model.simulate((0, 1), q={"pivot": 1.0}).t) > 2
    for run in (model.simulate, model.ensemble):
        with pytest.raises(cd.ArgumentError, match=r"array of two times.*\(0, 1\).*t_eval="):
            run(np.array([0.0, 1.0]))
    two = np.array([0.0, 1.0])
    for motion in (
        model.simulate(t_eval=two),
        model.simulate(1.0, t_eval=[0.0, 1.0]),
        model.simulate((0, 1), t_eval=two),
    ):
        np.testing.assert_array_equal(motion.t, two)
    with pytest.raises(cd.ModelError, match="leave out t"):
        model.simulate(2.0, t_eval=two)
    with pytest.raises(cd.ArgumentError, match="t is None"):
        model.simulate()
