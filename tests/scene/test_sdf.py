"""SDF models: poses, joints, loops, what acts and what is only said."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import cardan as cd
from cardan.scene.files.options import Options
from cardan.scene.files.sdf import from_text
from cardan.scene.files.urdf import from_text as from_urdf
from cardan.scene.summary import notes_of
from mechanisms.closed import four_bar
from mechanisms.closed_planar import four_bar_angles
from scene.sdf_texts import bars, joint, link, sdf
from table import each

FUNCTIONS = ("forward_dynamics", "mass_matrix", "pose")
HINGE = "<axis><xyz>0 1 0</xyz></axis>"

# the same arm four times: world poses, poses along the chain, poses of frames, nested models
ARM = {
    "1.6": sdf(
        link("base", "0 0 0.5 0 0 0")
        + link("upper", "0.2 0 1.0 0 0 0.7")
        + link("lower", "0.2 0 0.6 0 0.4 0.7")
        + joint("a", "base", "upper", axis=HINGE)
        + joint("b", "upper", "lower", axis="<axis><xyz>1 0 0</xyz></axis>"),
        "1.6",
    ),
    "1.7": sdf(
        link("base", "0 0 0.5 0 0 0")
        + link("upper", "0.2 0 0.5 0 0 0.7", relative_to="base")
        + link("lower", "0 0 -0.4 0 0.4 0", relative_to="a")
        + joint("a", "base", "upper", axis=HINGE)
        + joint("b", "upper", "lower", axis="<axis><xyz>1 0 0</xyz></axis>")
    ),
    "frames": sdf(
        link("base", "0 0 0.5 0 0 0")
        + '<frame name="shoulder" attached_to="base"><pose>0.2 0 0.5 0 0 0.7</pose></frame>'
        + link("upper", "0 0 0 0 0 0", relative_to="shoulder")
        + '<frame name="elbow" attached_to="upper"><pose degrees="true">0 0 -0.4 0 0 0</pose>'
        "</frame>"
        + link("lower", "0 0 0 0 0.4 0", relative_to="elbow")
        # the child may be a frame; axes are expressed where the file wants
        + joint("a", "shoulder", "upper", axis=HINGE)
        + joint(
            "b",
            "elbow",
            "lower",
            axis=f'<axis><xyz expressed_in="elbow">{math.cos(0.4)} 0 {-math.sin(0.4)}</xyz></axis>',
        ),
        "1.10",
    ),
    "nested": sdf(
        link("base", "0 0 0.5 0 0 0")
        + '<model name="arm"><pose>0.2 0 1 0 0 0.7</pose>'
        + link("upper")
        + link("lower", "0 0 -0.4 0 0.4 0")
        + joint("b", "upper", "lower", axis="<axis><xyz>1 0 0</xyz></axis>")
        + "</model>"
        + joint("a", "base", "arm::upper", axis=HINGE),
        "1.8",
    ),
    "placed": sdf(
        link("base", "0 0 0.5 0 0 0")
        + '<model name="arm" placement_frame="upper"><pose relative_to="base">0.2 0 0.5 0 0 0.7'
        "</pose>"
        + link("upper", "1 2 3 0 0.3 0")
        + link("lower", "0 0 -0.4 0 0.4 0", relative_to="upper")
        + joint("b", "upper", "lower", axis="<axis><xyz>1 0 0</xyz></axis>")
        + "</model>"
        + joint("a", "base", "arm::upper", axis=HINGE),
        "1.8",
    ),
}

URDF_LINK = """<link name="{0}"><inertial><origin xyz="0.1 0.2 -0.3" rpy="0 0 0.5"/>
<mass value="2"/><inertia ixx="0.2" iyy="0.3" izz="0.4" ixy="0.01" ixz="-0.02" iyz="0.03"/>
</inertial></link>"""
URDF = f"""<robot name="m">{"".join(URDF_LINK.format(n) for n in ("base", "upper", "lower"))}
<joint name="a" type="continuous"><parent link="base"/><child link="upper"/>
<origin xyz="0.2 0 0.5" rpy="0 0 0.7"/><axis xyz="0 1 0"/></joint>
<joint name="b" type="continuous"><parent link="upper"/><child link="lower"/>
<origin xyz="0 0 -0.4" rpy="0 0.4 0"/><axis xyz="1 0 0"/></joint></robot>"""


@pytest.mark.parametrize("case", ARM)
def test_an_arm_is_that_of_a_urdf(case: str) -> None:
    scene = from_text(ARM[case])
    assert len(scene.bodies) == 3
    model, other = (cd.compile(s, functions=FUNCTIONS) for s in (scene, from_urdf(URDF)))
    prefix = "arm." if len([n for n in scene.bodies if "." in n]) else ""
    order = [model.coordinates.index(f"{prefix}{n}" if n == "b" else n) for n in ("a", "b")]
    q, u = np.array([0.3, -0.8]), np.array([1.0, 2.0])
    ours = model.forward_dynamics(q[np.argsort(order)], u[np.argsort(order)])
    np.testing.assert_allclose(ours[order], other.forward_dynamics(q, u), rtol=1e-12)
    # the base of a URDF is at the origin
    shift = np.zeros((4, 4))
    shift[2, 3] = 0.5
    pose = model.pose(f"{prefix}lower", q[np.argsort(order)])
    np.testing.assert_allclose(pose, other.pose("lower", q) + shift, atol=1e-14)


@each(
    ("pose", "rotation"),
    [
        ("<pose>1 2 3 0.1 0.2 0.3</pose>", Rotation.from_euler("xyz", [0.1, 0.2, 0.3])),
        (
            '<pose degrees="true">1 2 3 10 20 90</pose>',
            Rotation.from_euler("xyz", [10, 20, 90], degrees=True),
        ),
        (
            '<pose rotation_format="quat_xyzw">1 2 3 0.1 0.2 0.3 0.9</pose>',
            Rotation.from_quat([0.1, 0.2, 0.3, 0.9]),
        ),
    ],
)
def test_forms_of_poses(pose: str, rotation: Rotation) -> None:
    scene = from_text(sdf(f'<link name="a">{pose}</link>'), Options(base="free"))
    model = cd.compile(scene, functions=("pose",))
    q, _ = model.split(model.initial())
    expected = np.eye(4)
    expected[:3, :3], expected[:3, 3] = rotation.as_matrix(), [1, 2, 3]
    np.testing.assert_allclose(model.pose("a", q), expected, atol=1e-15)


def test_a_free_base_has_its_place_as_coordinates() -> None:
    scene = from_text(sdf(link("a", "1 2 3 0 0 1.5708")), Options(base="free"))
    half = math.sqrt(0.5)
    assert scene.joints["base"].q0 == pytest.approx((half, 0, 0, half, 1, 2, 3), abs=1e-15)


def test_a_quarter_turn_leaves_exact_zeros() -> None:
    text = sdf(
        link("a", "0.1 0.2 0.7 0 1.5708 0")
        + link("b", "0.1 0.2 0.4 0 1.5708 0")
        + joint("j", "a", "b")
    )
    scene = from_text(text)
    frame = scene.joints["j"].parent
    assert [x == 0 for x in frame.coordinates] == [False, True, True]
    assert frame.orientation is None
    assert len(scene.snaps) == 2


@each(
    ("kind", "axis", "element"),
    [
        ("revolute", "<axis><xyz>0 0 2</xyz></axis>", cd.Revolute((0, 0, 1))),
        ("revolute", "", cd.Revolute((0, 0, 1))),
        ("continuous", HINGE, cd.Revolute((0, 1, 0))),
        ("prismatic", HINGE, cd.Prismatic((0, 1, 0))),
        ("ball", "", cd.Spherical()),
        ("fixed", "", cd.Fixed()),
        (
            "universal",
            HINGE + "<axis2><xyz>1 0 0</xyz></axis2>",
            cd.Universal((0, 1, 0), (1, 0, 0)),
        ),
        (
            "revolute2",
            HINGE + "<axis2><xyz>1 0 0</xyz></axis2>",
            cd.Universal((0, 1, 0), (1, 0, 0)),
        ),
        (
            "screw",
            HINGE + "<screw_thread_pitch>0.5</screw_thread_pitch>",
            cd.Screw((0, 1, 0), 0.5 / (2 * math.pi)),
        ),
    ],
)
def test_types(kind: str, axis: str, element: object) -> None:
    scene = from_text(sdf(link("a") + link("b") + joint("j", "a", "b", kind, axis)))
    assert scene.joints["j"].kind == element


def test_the_older_pitch_of_a_screw() -> None:
    """0.5 m per turn is -4 pi radians per meter there."""
    text = sdf(link("a") + link("b") + joint("j", "a", "b", "screw", HINGE)).replace(
        "</joint>", "<thread_pitch>-12.566370614359172</thread_pitch></joint>"
    )
    assert from_text(text).joints["j"].kind.pitch == pytest.approx(0.5 / (2 * math.pi), rel=1e-15)


@each(
    ("version", "more", "axis"),
    [
        ("1.4", "", (0, 0, 1)),
        ("1.6", "", (1, 0, 0)),
        ("1.6", "<use_parent_model_frame>1</use_parent_model_frame>", (0, 0, 1)),
    ],
)
def test_axes_of_older_versions(version: str, more: str, axis: tuple[int, ...]) -> None:
    """Before 1.5 in axes of the model; the child is turned by -90 degrees about y here."""
    inside = (
        link("a")
        + link("b", "0 0 1 0 -1.5708 0")
        + joint("j", "a", "b", axis=f"<axis><xyz>0 0 1</xyz>{more}</axis>")
    )
    kind = from_text(sdf(inside, version)).joints["j"].kind
    # z of the model is x of the joint
    expected = (1, 0, 0) if axis == (0, 0, 1) else (0, 0, 1)
    assert kind.axis == pytest.approx(expected)


def test_a_four_bar_is_that_of_the_mechanisms() -> None:
    """Drawn where it is closed: all angles of ours count from there."""
    angles = four_bar_angles(0.7)
    a, b, d = (angles[name] for name in ("A", "B", "D"))
    places = [(0.0, 0.0, a), (0.1 * math.cos(a), 0.1 * math.sin(a), a + b), (0.3, 0.0, d)]
    text = bars(places)
    written = four_bar()
    scene = from_text(text)
    scene.gravity = written.gravity
    functions = ("forward_dynamics", "constraints")
    ours, other = (cd.compile(one, functions=functions) for one in (scene, written))
    assert ours.nlam == other.nlam == 2
    np.testing.assert_allclose(ours.constraints(np.zeros(3)), 0, atol=1e-15)
    names = ("A", "B", "D")
    assert set(ours.coordinates) == set(names)
    order = [ours.coordinates.index(name) for name in names]
    udot = ours.forward_dynamics(np.zeros(3), np.zeros(3))[order]
    q = [angles[name] for name in other.coordinates]
    assert other.coordinates == names
    np.testing.assert_allclose(udot, other.forward_dynamics(q, np.zeros(3)), rtol=1e-11)


def test_loops_close_where_the_file_draws_them() -> None:
    """Whatever joint closes them: the frames coincide in the poses of the file."""
    for kind in ("revolute", "ball", "fixed", "prismatic"):
        scene = from_text(
            sdf(
                link("a", "0 0 1 0.1 0.2 0.3")
                + link("b", "1 0 1 0.5 -0.2 0.1")
                + link("c", "1 1 0 0 0.7 0")
                + joint("ab", "a", "b", "universal", HINGE + "<axis2><xyz>1 0 0</xyz></axis2>")
                + joint("bc", "b", "c", "ball", "")
                + joint("ca", "c", "a", kind, pose="<pose>0.3 0.2 0.1 1 2 3</pose>")
            )
        )
        model = cd.compile(scene)
        q = np.zeros(model.nq)
        # a ball of the tree is not turned
        q[[name.endswith(".qw") for name in model.coordinates]] = 1.0
        np.testing.assert_allclose(model.constraints(q), 0, atol=1e-15)
        assert model.nlam > 0


DYNAMICS = (
    "<axis><xyz>0 1 0</xyz><limit><lower>-1</lower><upper>2</upper><effort>5</effort>"
    "<velocity>-1</velocity></limit><dynamics><damping>0.5</damping><friction>0.1</friction>"
    "<spring_stiffness>30</spring_stiffness><spring_reference>0.2</spring_reference></dynamics>"
    "</axis>"
)
ONE = sdf(link("a") + link("b") + joint("j", "a", "b", axis=DYNAMICS))


def test_dynamics_and_limits(tmp_path: Path) -> None:
    scene = from_text(ONE)
    assert scene.forces["j.damping"].element == cd.JointDamper("j", 0.5)
    assert scene.forces["j.spring"].element == cd.JointSpring("j", 30.0, rest=0.2)
    assert scene.joints["j"].limits == (-1, 2, None, 5)
    assert scene.joints["j"].friction == 0.1
    said = " ".join(notes_of(scene))
    assert "limits are ignored" in said
    assert "friction is ignored" in said
    path = tmp_path / "a.sdf"
    path.write_text(ONE)
    acting = cd.load(path, limits="stop", friction=True)
    assert acting.forces["j.stop"].element == cd.Stop("j", -1.0, 2.0)
    assert acting.forces["j.friction"].element == cd.Friction("j", coulomb=0.1)
    (note,) = [n for n in notes_of(acting) if "ignored" in n]
    assert note == "joints j: limits of speed and effort are ignored"


def test_endless_joints_have_no_limits() -> None:
    wide = DYNAMICS.replace(">-1<", ">-1e16<").replace(">2<", ">1e16<")
    scene = from_text(sdf(link("a") + link("b") + joint("j", "a", "b", axis=wide)))
    assert scene.joints["j"].limits[:2] == (None, None)
    endless = ONE.replace('type="revolute"', 'type="continuous"')
    assert from_text(endless).joints["j"].limits[:2] == (None, None)


def test_what_does_not_act_is_said() -> None:
    ball = joint("j", "a", "b", "ball", DYNAMICS)
    sensor = '<sensor name="s" type="imu"/><collision name="c"/><gravity>0</gravity>'
    bare = '<link name="c"/>'
    text = sdf(link("a", more=sensor) + link("b") + ball + bare + '<plugin name="p" filename="f"/>')
    notes = from_text(text).notes
    assert "joints j (ball): limit, damping, friction, spring_stiffness does not act" in notes
    assert "links a: <gravity>false</gravity> does not act" in notes
    assert "links c: mass or inertia are missing and 1 kg, 1 kg m^2, as SDF has it" in notes
    assert any(note.startswith("no contacts are read") for note in notes)
    (unread,) = [note for note in notes if note.startswith("not read")]
    assert {"model plugin", "link sensor", "link collision"} <= set(unread[10:].split(", "))


def test_damping_of_a_universal_joint() -> None:
    axes = "<axis><xyz>0 1 0</xyz>{0}</axis><axis2><xyz>1 0 0</xyz>{1}</axis2>"
    rub = "<dynamics><damping>{0}</damping></dynamics>"
    for second, acts in ((2, True), (3, False)):
        axis = axes.format(rub.format(2), rub.format(second))
        scene = from_text(sdf(link("a") + link("b") + joint("j", "a", "b", "universal", axis)))
        assert ("j.damping" in scene.forces) is acts
        assert ("joints j (universal): damping does not act" in scene.notes) is not acts


MIMIC = (
    '<axis><xyz>0 1 0</xyz><mimic joint="j" axis="axis"><multiplier>2</multiplier>'
    "<offset>0.3</offset><reference>0.1</reference></mimic></axis>"
)
FOLLOWS = sdf(
    link("a") + link("b") + link("c") + joint("j", "a", "b") + joint("k", "b", "c", axis=MIMIC)
)


def test_mimic() -> None:
    couple = from_text(FOLLOWS).joints["k"].couple
    assert couple is not None
    # 2 (q_j - 0.1) + 0.3
    assert (couple.leader, couple.ratio, couple.offset) == ("j", 2.0, pytest.approx(0.1))
    free = from_text(FOLLOWS, Options(mimic="free"))
    assert free.joints["k"].couple is None
    assert "joints k: mimic is not followed" in free.notes[0]


def test_a_world_and_what_is_fixed_in_it() -> None:
    text = (
        '<sdf version="1.6"><world name="w"><gravity>0 0 -1.62</gravity>'
        f'<model name="one"><static>true</static>{link("a", "0 0 1 0 0 0")}{link("b")}'
        f"{joint('j', 'a', 'b')}</model>"
        f'<model name="two"><pose>1 0 0 0 0 0</pose>{link("a", "0 0 2 0 0 0")}</model>'
        "</world></sdf>"
    )
    scene = from_text(text, Options(base="free"))
    assert scene.gravity == (0, 0, -1.62)
    assert list(scene.bodies) == ["one.a", "one.b", "two.a"]
    kinds = {name: joint.kind.kind for name, joint in scene.joints.items()}
    assert kinds == {"one.a.base": "fixed", "one.b.base": "fixed", "two.a.base": "free"}
    assert scene.joints["two.a.base"].q0 == (1, 0, 0, 0, 1, 0, 2)


def test_joints_to_the_world_hold_a_model() -> None:
    text = sdf(link("a") + joint("j", "world", "a"))
    scene = from_text(text, Options(base="free"))
    assert list(scene.joints) == ["j"]
    assert "base='free' changes nothing" in scene.notes[0]


def test_pictures_and_frames(tmp_path: Path) -> None:
    (tmp_path / "m").mkdir()
    (tmp_path / "m" / "a.stl").write_text("solid")
    forms = {
        "box": "<size>1 2 3</size>",
        "cylinder": "<radius>1</radius><length>2</length>",
        "sphere": "<radius>1</radius>",
        "capsule": "<radius>1</radius><length>2</length>",
        "mesh": "<uri>model://m/a.stl</uri><scale>2 2 2</scale>",
    }
    visuals = "".join(
        f'<visual name="{k}"><pose>0 0 1 0 0 0</pose><geometry><{k}>{v}</{k}></geometry>'
        "<material><ambient>1 1 1 1</ambient><diffuse>1 0 0 0.5</diffuse></material></visual>"
        for k, v in forms.items()
    )
    frame = '<frame name="tip" attached_to="a"><pose>0 0 2 0 0 0</pose></frame>'
    text = sdf(f'<link name="a">{visuals}</link>{frame}')
    scene = from_text(text, Options(packages=(tmp_path,)))
    drawn = scene.bodies["a"].shapes
    assert [one.kind for one in drawn] == list(forms)
    assert {one.color for one in drawn} == {(1, 0, 0, 0.5)}
    assert {tuple(one.position) for one in drawn} == {(0, 0, 1)}
    assert dict(drawn[-1].size)["file"] == str(tmp_path / "m" / "a.stl")
    assert scene.frames["tip"].coordinates == (0, 0, 2)


def test_it_comes_back_from_a_scene_file(tmp_path: Path) -> None:
    scene = from_text(ARM["frames"])
    cd.Scene.save(scene, tmp_path / "arm.yaml")
    again = cd.load(tmp_path / "arm.yaml")
    models = [cd.compile(one, functions=("mass_matrix",)) for one in (scene, again)]
    matrices = [model.mass_matrix([0.3, -0.8]) for model in models]
    np.testing.assert_allclose(*matrices, rtol=1e-14)
