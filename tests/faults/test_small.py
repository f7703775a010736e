"""Small faults: what went on without a word, and words about what does not matter."""

from __future__ import annotations

import json
import math
import warnings
from pathlib import Path

import pytest

import cardan as cd
from cardan.cli import main


def _said(run: object) -> list[str]:
    """The warnings of a call."""
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        run()  # type: ignore[operator]
    return [str(one.message) for one in found if issubclass(one.category, cd.ModelWarning)]


def _limited(q0: float | None = None) -> cd.Scene:
    scene = cd.Scene("limited")
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("elbow", cd.Revolute("y"), scene.ground, rod, q0=q0, limits=(-1, 2))
    return scene


@pytest.mark.parametrize(
    ("value", "limit"), [(-1.5, "below the lower limit -1 rad"), (2.5, "above the upper limit 2")]
)
def test_e9_a_start_outside_the_limits_of_a_joint(value: float, limit: str) -> None:
    """``q0=`` and ``simulate(q=)`` past ``limits=`` went without a word."""
    (said,) = _said(lambda: _limited(value))
    assert f"joint 'elbow': q0: the start {value:g} rad is {limit}" in said
    model = cd.compile(_limited())
    (said,) = _said(lambda: model.simulate(0.01, q={"elbow": value}))
    assert f"joint 'elbow': q: the start {value:g} rad is {limit}" in said
    # at a limit, within, and where nobody named it
    for start in ({"elbow": -1.0}, {"elbow": 0.5}, {}):
        assert not _said(lambda start=start: model.simulate(0.01, q=start))  # type: ignore[misc]
    assert not _said(lambda: _limited(2.0))


def test_e9_a_start_outside_the_limits_of_a_file(tmp_path: Path) -> None:
    """The warning about a scene file says where."""
    file = tmp_path / "arm.yaml"
    file.write_text(
        "cardan: 2\nbodies:\n  rod: {mass: 1}\njoints:\n"
        "  slide: {type: prismatic, axis: x, parent: ground, child: rod, q0: 3, limits: [0, 2]}\n"
    )
    (said,) = _said(lambda: cd.load(file))
    assert "arm.yaml:5" in said
    assert "joint 'slide': q0: the start 3 m is above the upper limit 2 m" in said


def _wheel(kind: cd.Revolute | cd.Planar | cd.Universal, inertia: object = (0, 0, 0.2)) -> cd.Scene:
    scene = cd.Scene("wheel")
    arm = scene.body("arm", mass=1, com=(0.5, 0, 0), inertia=(0, 0.3, 0))
    # the arm's own y is the z of the ground
    quarter = arm.at(rotation=("XYZ", math.pi / 2, 0, 0))
    scene.joint("shoulder", cd.Revolute("z"), scene.ground, quarter)
    rim = scene.body("rim", mass=2, inertia=inertia)
    scene.joint("hub", kind, quarter, rim)
    return scene


def test_d_moments_that_no_motion_feels_are_no_fault(tmp_path: Path) -> None:
    """``inertia=(0, 0, J)`` of a body that turns about z alone was said to be impossible."""
    assert not _said(lambda: cd.derive(_wheel(cd.Revolute("z"))))
    assert not _said(lambda: cd.derive(_wheel(cd.Planar())))
    scene = _wheel(cd.Revolute("z"))
    file = tmp_path / "wheel.yaml"
    scene.save(file)
    assert main(["check", str(file)]) == 0


@pytest.mark.parametrize("kind", [cd.Revolute("x"), cd.Universal(), cd.Revolute((0, 1e-3, 1))])
def test_d_moments_that_a_motion_feels_are_wanted(
    kind: cd.Revolute | cd.Universal, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """What turns about another axis too needs its other moments, and ``check`` says so."""
    (said,) = _said(lambda: cd.derive(_wheel(kind)))
    assert "body 'rim': its inertia violates the triangle inequality" in said
    assert "turns about other axes than its own z too" in said
    scene = _wheel(kind)
    file = tmp_path / "wheel.yaml"
    scene.save(file)
    assert main(["check", str(file)]) == 1
    assert "wheel.yaml:" in capsys.readouterr().out


def test_d_a_lone_moment_of_parameters() -> None:
    """Moments given as expressions are judged at their defaults, in the same way."""
    for kind, count in ((cd.Revolute("z"), 0), (cd.Revolute("y"), 1)):
        scene = cd.Scene("one")
        J = scene.parameter("J", 0.2)
        scene.joint("hub", kind, scene.ground, scene.body("rim", mass=2, inertia=(0, 0, J)))
        assert len(_said(lambda scene=scene: cd.derive(scene))) == count  # type: ignore[misc]
    # written moments that contradict each other stay a fault about any axis
    (said,) = _said(lambda: _wheel(cd.Revolute("z"), (0.05, 0.05, 0.2)))
    assert "body 'rim'" in said


def _hung(force: cd.SpringDamper | cd.Maxwell, q0: float = 0.0) -> cd.Scene:
    scene = cd.Scene("hung")
    inner, mass = scene.body("inner", mass=1), scene.body("mass", mass=1)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, inner, q0=0.5)
    scene.joint("rail", cd.Prismatic("x"), inner.at(-0.3, 0, 0), mass.at(0.2, 0, 0), q0=q0)
    scene.force("spring", force)
    return scene


def test_e9_a_spring_that_pushes_where_its_ends_meet() -> None:
    """A spring between points that coincide at the start pushed along what rounding left."""
    # the mass starts at 0.5 - 0.3 + q0 - 0.2
    for kind in (
        cd.SpringDamper("ground", "mass", stiffness=10, rest_length=0.2),
        cd.Maxwell("ground", "mass", stiffness=10, damping=1, rest_length=0.2),
    ):
        (said,) = _said(lambda kind=kind: cd.derive(_hung(kind)))  # type: ignore[misc]
        assert f"force 'spring' ({kind.kind}): its ends meet where the motion starts" in said
        assert "2 N" in said
        assert not _said(lambda kind=kind: cd.derive(_hung(kind, 1e-3)))  # type: ignore[misc]
    for smooth in (
        cd.SpringDamper("ground", "mass", stiffness=10),
        cd.SpringDamper("ground", "mass", damping=1, rest_length=1),
    ):
        assert not _said(lambda smooth=smooth: cd.derive(_hung(smooth)))  # type: ignore[misc]


def _four_bar(two: object, joints: int = 4) -> cd.Scene:
    """A planar linkage around a loop of equal links; the first and a further joint driven."""
    scene = cd.Scene("linkage")
    links = [scene.body(f"l{k}", mass=1, com=(0.5, 0, 0)) for k in range(joints - 1)]
    for k, link in enumerate(links):
        before = links[k - 1].at(1, 0, 0) if k else scene.ground
        moved = {0: 0.1 * cd.t, 1: two}.get(k)
        scene.joint(f"J{k}", cd.Revolute("z"), before, link, prescribed=moved)
    scene.joint("last", cd.Revolute("z"), links[-1].at(1, 0, 0), scene.ground.at(1, 0, 0))
    return scene


def test_e9_two_prescribed_joints_in_a_circuit_of_one_freedom() -> None:
    """Two ``prescribed=`` that fight ended the run at once with ``not_closed``, and compiling said
    nothing."""
    (said,) = _said(lambda: cd.derive(_four_bar(math.pi / 2 + 0.2 * cd.t)))
    assert "joints 'J0', 'J1' are prescribed" in said
    assert "has 1 freedom" in said
    assert all(f"'{name}'" in said for name in ("J0", "J1", "J2", "last"))
    assert not _said(lambda: cd.derive(_four_bar(None)))
    # a loop of five links has two freedoms
    assert not _said(lambda: cd.derive(_four_bar(math.pi / 2 + 0.2 * cd.t, 5)))
    # and joints that are prescribed apart from loops are not meant
    scene = _four_bar(None)
    arm = scene.body("arm", mass=1)
    scene.joint("beside", cd.Revolute("z"), "l0", arm, prescribed=cd.t)
    assert not _said(lambda: cd.derive(scene))


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_a_joint_that_closes_a_loop_is_not_taken_for_a_misspelled_one(coordinates: str) -> None:
    """In absolute coordinates it was unknown: "Did you mean 'c'?", a body."""
    scene = cd.Scene("four_bar")
    a, b, c = (scene.body(name, mass=1.0, inertia=(0.1, 0.1, 0.1)) for name in "abc")
    scene.joint("A", cd.Revolute("z"), scene.ground, a)
    scene.joint("B", cd.Revolute("z"), a.at(1, 0, 0), b)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(2, 0, 0), c)
    scene.joint("C", cd.Revolute("z"), b.at(2, 0, 0), c.at(1.5, 0, 0), cut=True)
    model = cd.compile(scene, coordinates=coordinates)
    for given in ({"q": {"C": 0.1}}, {"u": {"C": 0.1}}):
        with pytest.raises(cd.ModelError, match=r"'C' closes a kinematic loop") as error:
            model.simulate(0.1, **given)
        assert "Did you mean" not in str(error.value)
    with pytest.raises(cd.ModelError, match=r"there is no joint .* 'AA'.*Did you mean 'A'\?"):
        model.simulate(0.1, q={"AA": 0.1})


def test_values_are_counted_and_named() -> None:
    """ "1 values, expected 7"."""
    scene = cd.Scene("free")
    scene.joint("base", cd.Free(), scene.ground, scene.body("b", mass=1.0, inertia=(1, 1, 1)))
    model = cd.compile(scene)
    with pytest.raises(cd.ArgumentError, match=r"1 value, expected 7: base\.\w+, .*, base\.pz$"):
        model.simulate(0.1, q={"base": 1.0})
    with pytest.raises(cd.ArgumentError, match=r"2 values, expected 6: base\.u\.x, "):
        model.simulate(0.1, u={"base": [1.0, 2.0]})


def test_a_path_that_friction_ends_says_so() -> None:
    """ "the stiffness gives way there (lowest eigenvalue inf J)"."""
    scene = cd.Scene("block", gravity=(0, 0, -9.81))
    body = scene.body("b", mass=2.0, inertia=(1, 1, 1))
    scene.joint("x", cd.Prismatic("x"), scene.ground, body)
    scene.force("dry", cd.Friction("x", coulomb=9.0))
    scene.force("pull", cd.JointForce("x", scene.parameter("F", 0.0)))
    with pytest.warns(cd.SolveWarning, match=r"held there by 'dry' \(sticking\), which bear no m"):
        path = cd.compile(scene).statics(F=(0, 20.0))
    assert path["F"][-1] == pytest.approx(9.0, rel=1e-6)
    assert "inf" not in path.message


def test_check_names_the_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It named no file beside a complaint."""
    robot = tmp_path / "bad.urdf"
    robot.write_text(
        '<robot name="r"><link name="base"/><link name="a"><inertial><mass value="1"/><inertia '
        'ixx="0.1" iyy="0.1" izz="0.5" ixy="0" ixz="0" iyz="0"/></inertial></link><joint name="j" '
        'type="continuous"><parent link="base"/><child link="a"/></joint></robot>'
    )
    assert main(["check", str(robot)]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith(f"{robot}: error: body 'a': its inertia")
    assert main(["check", str(robot), "--json"]) == 1
    rows = json.loads(capsys.readouterr().out)
    assert {row["file"] for row in rows} == {str(robot)}
    # a message that says where does so once
    robot.write_text("<robot")
    assert main(["check", str(robot)]) == 1
    assert capsys.readouterr().out.count(robot.name) == 1
