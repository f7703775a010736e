"""URDF: what it means, and what is said where it is at fault."""

from __future__ import annotations

import math
import textwrap

import numpy as np
import pytest

from cardan.api.scene_file import load
from cardan.elements.forces.friction import Friction
from cardan.elements.forces.stop import Stop
from cardan.errors import ModelError, TopologyError
from cardan.scene.files.angles import snapped
from cardan.scene.files.urdf import Options, from_text
from cardan.scene.summary import summary
from cardan.topology import build
from topology.numbers_of import body_mass, body_poses, values

LINK = (
    '<link name="{0}"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/>'
    "</inertial></link>"
)


def robot(body, name="robot"):
    return f'<robot name="{name}">{textwrap.dedent(body)}</robot>'


def two_links(joint, more=""):
    return robot(LINK.format("base") + LINK.format("arm") + joint + more)


def hinge(inside="", kind="revolute", name="hinge", parent="base", child="arm"):
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f"{inside}</joint>"
    )


@pytest.mark.parametrize(
    ("kind", "expected", "nq"),
    [
        ("revolute", "revolute", 1),
        ("continuous", "revolute", 1),
        ("prismatic", "prismatic", 1),
        ("floating", "free", 7),
        ("planar", "planar", 3),
        ("fixed", None, 0),
    ],
)
def test_joint_types(kind, expected, nq):
    system = build(from_text(two_links(hinge('<axis xyz="0 0 2"/>', kind))))
    assert system.nq == nq
    if expected is None:
        assert system.fixed == ("base", "hinge")
    else:
        assert system.joints[0].element.kind == expected


def test_the_default_axis_is_x_and_lengths_along_axes_do_not_matter():
    system = build(from_text(two_links(hinge())))
    assert system.joints[0].data["axis"][2] == (1, 0, 0)
    system = build(from_text(two_links(hinge('<axis xyz="0 -3 0"/>'))))
    assert system.joints[0].data["axis"][2] == (0, 2, 0)


def test_base_fixed_or_free():
    text = two_links(hinge())
    assert build(from_text(text)).nq == 1
    free = build(from_text(text, Options(base="free")))
    assert free.nq == 8
    assert free.joints[0].name == "base"
    with pytest.raises(ModelError, match="'fixed' or 'free'"):
        Options(base="floating")


def test_rotated_inertial_origin():
    rpy = (0.3, -0.4, 0.5)
    inertial = (
        '<link name="arm"><inertial><origin xyz="0.1 0.2 0.3" rpy="0.3 -0.4 0.5"/>'
        '<mass value="2"/><inertia ixx="1" iyy="1.5" izz="2" ixy="0.1" ixz="0.2" iyz="0.3"/>'
        "</inertial></link>"
    )
    system = build(from_text(robot(LINK.format("base") + inertial + hinge())))
    cr, cp, cy = np.cos(rpy)
    sr, sp, sy = np.sin(rpy)
    turn = (
        np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
        @ np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
        @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    )
    c = np.array([0.1, 0.2, 0.3])
    tensor = turn @ [[1, 0.1, 0.2], [0.1, 1.5, 0.3], [0.2, 0.3, 2]] @ turn.T
    mass, first, moment = body_mass(system, 0)
    assert mass == 2
    np.testing.assert_allclose(first, 2 * c, rtol=1e-15)
    expected = tensor + 2 * (c @ c * np.eye(3) - np.outer(c, c))
    np.testing.assert_allclose(moment, expected, rtol=0, atol=2e-15)


@pytest.mark.parametrize(
    ("word", "value"),
    [
        ("1.5708", math.pi / 2),
        ("-1.57", -math.pi / 2),
        ("3.14159", math.pi),
        ("3.1415926535897931", math.pi),
        ("4.71239", 1.5 * math.pi),
        ("1.570796e0", math.pi / 2),
        ("157.08e-2", math.pi / 2),
        # none of these is a rounding of a quarter turn
        ("1.571", math.pi / 2),
        ("1.5707", 1.5707),
        ("1.5709", 1.5709),
        ("1.570", 1.57),
        ("1.6", 1.6),
        ("2", 2.0),
        ("0.0001", 0.0001),
        ("0.785398", 0.785398),
        ("1.5e300", 1.5e300),
        ("1.5e-300", 1.5e-300),
    ],
)
def test_snapping(word, value):
    assert snapped(word, float(word)) == value


def test_residues_of_angles_are_listed_and_can_be_refused():
    text = two_links(hinge('<origin xyz="0 0 1" rpy="-1.22e-16 0 1e-15"/>'))
    model = from_text(text)
    assert model.snaps == ["joint 'hinge' roll: -1.22e-16 -> 0"]
    assert [p.name for p in build(model).parameters if "rotation" in p.name] == [
        "hinge.rotation.yaw"
    ]
    assert from_text(text, Options(snap=False)).snaps == []


def test_residues_in_an_axis_are_listed_and_can_be_refused():
    text = two_links(hinge('<axis xyz="6.12323e-17 -1 0"/>'))
    model = from_text(text)
    assert model.snaps == ["joint 'hinge' axis x: 6.12323e-17 -> 0"]
    assert not [p.name for p in build(model).parameters if "axis" in p.name]
    printed = build(from_text(text, Options(snap=False)))
    assert [p.name for p in printed.parameters if "axis" in p.name] == ["hinge.axis.x"]


def test_snaps_are_listed_and_can_be_refused():
    text = two_links(hinge('<origin xyz="0 0 1" rpy="1.5708 0 0.1"/>'))
    model = from_text(text)
    assert model.snaps == ["joint 'hinge' roll: 1.5708 -> pi/2"]
    system = build(model)
    assert system.snaps == tuple(model.snaps)
    assert "hinge.rotation.roll" in system.structural
    assert [p.name for p in system.parameters if "rotation" in p.name] == ["hinge.rotation.yaw"]
    printed = build(from_text(text, Options(snap=False)))
    assert printed.snaps == ()
    assert values(printed, printed.joints[0].rotation)[8] == pytest.approx(math.cos(1.5708))


FOLLOW = '<axis xyz="0 1 0"/><mimic joint="hinge" multiplier="-0.5" offset="0.1"/>'
MIMIC = two_links(
    hinge('<axis xyz="0 0 1"/>')
    + LINK.format("finger")
    + hinge(FOLLOW, name="follow", child="finger")
)


def test_mimic_couples_or_moves_freely():
    system = build(from_text(MIMIC))
    assert system.nq == 1
    coupling = system.joints[1].coupling
    np.testing.assert_allclose(values(system, [coupling.ratio, coupling.offset]), [-0.5, 0.1])
    free = from_text(MIMIC, Options(mimic="free"))
    assert build(free).nq == 2
    assert any("follow" in note and "moves freely" in note for note in free.notes)


def test_mimic_of_nothing_moves_freely_with_a_warning():
    with pytest.warns(UserWarning, match=r"follow \(knee\)"):
        model = from_text(MIMIC.replace('mimic joint="hinge"', 'mimic joint="knee"'))
    assert build(model).nq == 2


def test_what_acts_and_what_does_not():
    inside = (
        '<axis xyz="0 0 1"/><limit lower="-1" upper="2" velocity="3" effort="1e400"/>'
        '<dynamics damping="0.7" friction="0.2"/>'
    )
    model = from_text(two_links(hinge(inside)))
    assert model.joints["hinge"].limits == (-1, 2, 3, None)
    assert model.joints["hinge"].friction == 0.2
    system = build(model)
    assert [(f.name, f.element.kind) for f in system.forces] == [("hinge.damping", "joint_damper")]
    ends = "joints hinge: limits are ignored; add a Stop, or load the file with limits='stop'"
    dry = "joints hinge: friction is ignored; add a Friction, or load the file with friction=True"
    assert system.notes == (dry, ends)
    assert all(note in summary(model) for note in (dry, ends))
    # who does what the notes say is not told again
    model.force("ends", Stop("hinge", lower=-1, upper=2))
    model.force("dry", Friction("hinge", coulomb=0.2))
    assert build(model).notes == ("joints hinge: limits of speed and effort are ignored",)


def test_limits_of_a_continuous_joint_are_those_of_speed_and_effort():
    model = from_text(two_links(hinge('<limit lower="0" upper="0" velocity="3"/>', "continuous")))
    assert model.joints["hinge"].limits == (None, None, 3, None)


def test_massless_tips_are_warned_of_by_name():
    text = robot(LINK.format("base") + '<link name="arm"/>' + hinge())
    with pytest.warns(UserWarning, match="bodies arm"):
        model = from_text(text)
    assert any("massless tip" in note for note in build(model).notes)


@pytest.mark.filterwarnings("error")
def test_a_massless_link_with_a_heavy_one_behind_it_is_fine():
    text = robot(
        '<link name="base"/><link name="arm"/>'
        + LINK.format("hand")
        + hinge()
        + hinge(name="weld", kind="fixed", parent="arm", child="hand")
    )
    assert build(from_text(text)).bodies[0].parts[1].name == "hand"


def test_joints_in_any_order_and_a_link_called_ground():
    text = robot(
        LINK.format("hand")
        + LINK.format("arm")
        + LINK.format("ground")
        + hinge('<origin xyz="0 0 1"/>', name="wrist", parent="arm", child="hand")
        + hinge('<origin xyz="0 0 2"/>', parent="ground")
    )
    model = from_text(text)
    assert "ground_link" in model.bodies
    assert any("ground_link" in note for note in model.notes)
    system = build(model)
    np.testing.assert_allclose(body_poses(system)[1][:3, 3], [0, 0, 3])


def test_parameters_replace_numbers(tmp_path):
    path = tmp_path / "two.urdf"
    path.write_text(two_links(hinge()))
    system = build(load(path, parameters={"arm.mass": 7.0}))
    assert body_mass(system, 0)[0] == 7
    with pytest.raises(ModelError, match=r"Did you mean 'arm.mass'"):
        build(load(path, parameters={"arm.mas": 7.0}))


def test_parameters_replace_angles_that_were_made_exact(tmp_path):
    path = tmp_path / "two.urdf"
    path.write_text(two_links(hinge('<origin rpy="1.5707963 0 0"/>')))
    system = build(load(path, parameters={"hinge.rotation.roll": 0.3}))
    c, s = math.cos(0.3), math.sin(0.3)
    expected = [[1, 0, 0], [0, c, -s], [0, s, c]]
    np.testing.assert_allclose(body_poses(system)[0][:3, :3], expected, atol=1e-15)


# files at fault


@pytest.mark.parametrize(
    ("text", "error", "words"),
    [
        ("<robot", ModelError, "not XML"),
        ("", ModelError, "not XML"),
        ("<sdf/>", ModelError, "not <robot>"),
        (robot(""), ModelError, "no links"),
        (robot(LINK.format("a") * 2), ModelError, "link 'a' is defined twice"),
        (two_links(hinge() + hinge()), ModelError, "joint 'hinge' is defined twice"),
        (two_links(hinge(child="amr")), ModelError, "Did you mean 'arm'"),
        (two_links('<joint name="j" type="fixed"/>'), ModelError, "<parent link=.../> is missing"),
        (two_links(hinge(kind="hinge")), ModelError, "type 'hinge' is unknown"),
        (two_links(hinge('<axis xyz="0 0 0"/>')), ModelError, "'hinge': its axis is zero"),
        (two_links(hinge('<axis xyz="0 0"/>')), ModelError, "has 2 numbers, expected 3"),
        (two_links(hinge('<origin xyz="0 nan 0"/>')), ModelError, "'nan'"),
        (two_links(hinge('<origin xyz="0 1_0 0"/>')), ModelError, "'1_0'"),
        (two_links(hinge('<origin xyz="0 1e200 0"/>')), ModelError, "not a number up to"),
        (two_links(hinge('<limit lower="2" upper="1"/>')), ModelError, "above"),
        (two_links(""), TopologyError, "2 root links, which .*: 'base', 'arm'. A robot has one"),
        (
            two_links(hinge() + hinge(name="back", parent="arm", child="base")),
            TopologyError,
            "every link is the child",
        ),
        (
            two_links(hinge() + hinge(name="other")),
            TopologyError,
            "child of two joints, 'hinge' and 'other'",
        ),
        (
            robot(
                LINK.format("root")
                + LINK.format("base")
                + LINK.format("arm")
                + hinge()
                + hinge(name="back", parent="arm", child="base")
            ),
            TopologyError,
            "from the root link 'root' to the links 'arm', 'base'.* Change the <parent>",
        ),
        (two_links(hinge()).replace('mass value="1"', 'mass value="-1"'), ModelError, "negative"),
        (two_links(hinge()).replace('mass value="1"', "mass"), ModelError, "lacks the attribute"),
    ],
)
def test_files_at_fault(text, error, words):
    with pytest.raises(error, match=words):
        build(from_text(text))


def test_entity_bombs_and_external_entities():
    bomb = '<!DOCTYPE r [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]><robot name="&b;"/>'
    with pytest.raises(ModelError, match="declares entities"):
        from_text(bomb)
    outside = '<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/passwd">]><robot name="&x;"/>'
    with pytest.raises(ModelError, match="declares entities"):
        from_text(outside)


def test_absurd_depth():
    deep = "<a>" * 100_000 + "</a>" * 100_000
    with pytest.raises(ModelError, match="nested more than"):
        from_text(robot(deep))


def test_a_chain_of_a_thousand_links():
    count = 1000
    links = "".join(LINK.format(f"l{k}") for k in range(count + 1))
    joints = "".join(hinge(name=f"j{k}", parent=f"l{k}", child=f"l{k + 1}") for k in range(count))
    assert build(from_text(robot(links + joints))).nq == count


def test_absurd_size(tmp_path, monkeypatch):
    monkeypatch.setattr("cardan.scene.files.document.LARGEST_FILE", 100)
    path = tmp_path / "big.urdf"
    path.write_text(two_links(hinge()))
    with pytest.raises(ModelError, match="MiB"):
        load(path)


def test_files_that_are_not_there_or_not_urdf(tmp_path):
    with pytest.raises(ModelError, match=r"'none.urdf' cannot be read: No such file"):
        load(tmp_path / "none.urdf")
    with pytest.raises(ModelError, match=r"cannot read '.step' files"):
        load(tmp_path / "part.step")


# meshes


def visual(file):
    geometry = f'<visual><geometry><mesh filename="{file}"/></geometry></visual>'
    return two_links(hinge()).replace('<link name="arm">', f'<link name="arm">{geometry}')


def test_meshes_are_found_below_declared_folders(tmp_path):
    package = tmp_path / "roots" / "my_robot"
    package.mkdir(parents=True)
    mesh = package / "arm.stl"
    mesh.write_text("solid")
    path = tmp_path / "robot.urdf"
    for reference in ("package://my_robot/arm.stl", "package:///my_robot/arm.stl"):
        path.write_text(visual(reference))
        # the folder of packages, or the package itself
        for root in (tmp_path / "roots", package):
            model = load(path, packages=[root])
            assert dict(model.bodies["arm"].shapes[0].size)["file"] == str(mesh)
    assert any("packages=" in note for note in load(path).notes)


@pytest.mark.parametrize(
    "file",
    [
        "package://../../../etc/passwd",
        "package://robot/../../etc/passwd",
        "../secret.stl",
        "http://example.org/a.stl",
    ],
)
def test_meshes_outside_are_refused(file):
    with pytest.raises(ModelError, match="mesh"):
        from_text(visual(file))


def test_links_in_the_file_system_do_not_lead_out(tmp_path):
    secret = tmp_path / "secret.stl"
    secret.write_text("solid")
    package = tmp_path / "roots" / "pkg"
    package.mkdir(parents=True)
    (package / "arm.stl").symlink_to(secret)
    path = tmp_path / "robot.urdf"
    for file in ("package://pkg/arm.stl", f"file://{secret}", str(secret)):
        path.write_text(visual(file))
        sub = tmp_path / "roots" / "robot.urdf"
        sub.write_text(path.read_text())
        model = load(sub, packages=[tmp_path / "roots"])
        assert dict(model.bodies["arm"].shapes[0].size)["file"] == file
