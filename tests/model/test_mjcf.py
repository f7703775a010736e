"""MJCF: what it means, and what is said where it is at fault."""

from __future__ import annotations

import math
import textwrap
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import cardan as cd
from cardan.model.files.mjcf import from_text
from cardan.model.files.pose import about, of_quaternion, to_quaternion, unit, upright_to
from cardan.topology import build
from model.fuzzing import FUZZ
from topology.numbers_of import body_mass, frame_pose

SOLID = '<geom type="box" size="0.1 0.2 0.3"/>'


def mujoco(body: str, more: str = "") -> str:
    """A file whose world has this inside."""
    return f"<mujoco>{more}<worldbody>{textwrap.dedent(body)}</worldbody></mujoco>"


def one(inside: str, more: str = "", place: str = "") -> str:
    return mujoco(f'<body name="a" {place}>{inside}</body>', more)


# masses


@pytest.mark.parametrize(
    ("geom", "mass", "moments"),
    [
        ('type="sphere" size="0.2" mass="3"', 3, [0.048] * 3),
        ('type="box" size="0.1 0.2 0.3" mass="3"', 3, [0.13, 0.10, 0.05]),
        ('type="cylinder" size="0.2 0.3" mass="4"', 4, [0.16, 0.16, 0.08]),
        ('type="ellipsoid" size="0.1 0.2 0.3" mass="5"', 5, [0.13, 0.10, 0.05]),
        ('size="0.1"', 1000 * 4 / 3 * math.pi * 1e-3, None),
        ('type="box" size="0.1 0.2 0.3" density="10"', 0.48, None),
        ('type="cylinder" size="0.1 0.2"', 1000 * 0.4 * math.pi * 0.01, None),
        ('type="capsule" size="0.1 0.2"', 1000 * math.pi * 0.01 * (0.4 + 0.4 / 3), None),
    ],
)
def test_geoms_have_mass(geom: str, mass: float, moments: list[float] | None) -> None:
    system = build(from_text(one(f"<freejoint/><geom {geom}/>")))
    found, first, inertia = body_mass(system, 0)
    np.testing.assert_allclose(found, mass, rtol=1e-15)
    np.testing.assert_allclose(first, 0, atol=1e-15)
    if moments is not None:
        np.testing.assert_allclose(inertia, np.diag(moments), atol=1e-15)


def test_a_capsule_is_what_is_found_by_integration() -> None:
    radius, half = 0.1, 0.2
    system = build(from_text(one(f'<freejoint/><geom type="capsule" size="{radius} {half}"/>')))
    inertia = body_mass(system, 0)[2]
    # slices of the upper half: discs of radius r(z), Gauss points of polynomials of degree 39
    x, w = np.polynomial.legendre.leggauss(20)
    across = along = 0.0
    for a, b, r2 in (
        (0, half, lambda z: radius**2 + 0 * z),
        (half, half + radius, lambda z: radius**2 - (z - half) ** 2),
    ):
        z, dz = (a + b) / 2 + (b - a) / 2 * x, (b - a) / 2 * w
        along += 2 * 1000 * math.pi * np.sum(dz * r2(z) ** 2 / 2)
        across += 2 * 1000 * math.pi * np.sum(dz * (r2(z) ** 2 / 4 + r2(z) * z**2))
    np.testing.assert_allclose(inertia, np.diag([across, across, along]), rtol=1e-14)


def test_masses_from_geoms_or_not() -> None:
    inside = f'<freejoint/><inertial pos="0 0 1" mass="2" diaginertia="1 1 1"/>{SOLID}'
    for word, mass in (("auto", 2.0), ("false", 2.0), ("true", 48.0)):
        settings = f'<compiler inertiafromgeom="{word}"/>'
        assert body_mass(build(from_text(one(inside, settings))), 0)[0] == pytest.approx(mass)
    group = one(
        f'<freejoint/>{SOLID}<geom size="1" group="3"/>', '<compiler inertiagrouprange="0 2"/>'
    )
    assert body_mass(build(from_text(group)), 0)[0] == pytest.approx(48)


# orientations


@pytest.mark.parametrize(
    ("written", "settings", "turn"),
    [
        ('quat="2 0 0 2"', "", about((0, 0, 1), math.pi / 2)),
        ('axisangle="0 3 0 90"', "", about((0, 1, 0), math.pi / 2)),
        ('axisangle="1 1 0 0.3"', 'angle="radian"', about(unit((1, 1, 0)), 0.3)),
        ('zaxis="1 0 0"', "", about((0, 1, 0), math.pi / 2)),
        ('zaxis="0 0 -2"', "", about((1, 0, 0), math.pi)),
        ('xyaxes="0 2 0 -3 1 0"', "", about((0, 0, 1), math.pi / 2)),
    ],
)
def test_orientations(written: str, settings: str, turn: list[list[float]]) -> None:
    text = one(SOLID + "<joint/>", f"<compiler {settings}/>", written)
    np.testing.assert_allclose(pose(text, "a")[:3, :3], turn, atol=1e-15)


def pose(text: str, body: str) -> np.ndarray:
    """Of a body where all coordinates are as drawn."""
    system = build(from_text(text))
    return frame_pose(system, body, np.zeros(system.nq))


def test_small_letters_of_euler_angles_turn_with_the_body() -> None:
    x, y, z = (about(a, s) for a, s in zip(np.eye(3), (0.1, 0.2, 0.3), strict=True))
    x, y, z = np.array(x), np.array(y), np.array(z)
    for sequence, turn in (("xyz", x @ y @ z), ("XYZ", z @ y @ x), ("xYz", y @ x @ z)):
        settings = f'<compiler angle="radian" eulerseq="{sequence}"/>'
        found = pose(one(SOLID + "<joint/>", settings, 'euler="0.1 0.2 0.3"'), "a")
        np.testing.assert_allclose(found[:3, :3], turn, atol=1e-15)


@given(st.lists(st.floats(-1, 1), min_size=4, max_size=4))
def test_quaternions_come_back(entries: list[float]) -> None:
    size = math.hypot(*entries)
    if size < 1e-3:
        return
    sign = -1 if entries[0] < 0 else 1
    found = np.array(to_quaternion(of_quaternion(*entries)))
    wanted = np.array([sign * x / size for x in entries])
    # at half a turn the sign is free
    off = min(np.abs(found - wanted).max(), np.abs(found + wanted).max())
    assert off <= 4e-15


@given(st.lists(st.floats(-1, 1), min_size=3, max_size=3))
def test_the_smallest_turn_takes_z_there(entries: list[float]) -> None:
    if math.hypot(*entries) > 1e-3:
        turn = np.array(upright_to(entries))
        np.testing.assert_allclose(turn[:, 2], unit(entries), atol=1e-15)
        np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-15)


# joints


def test_several_joints_are_a_chain_of_massless_bodies() -> None:
    joints = '<joint name="x" type="slide" axis="1 0 0"/><joint name="turn" axis="0 0 1"/>'
    model = from_text(one(joints + SOLID, place='pos="0 0 1"'))
    assert list(model.bodies) == ["a", "a.x"]
    assert [(j.parent.body.name, j.child.body.name) for j in model.joints.values()] == [
        ("ground", "a.x"),
        ("a.x", "a"),
    ]
    assert model.bodies["a.x"].mass == 0


def test_names_that_are_missing_are_made() -> None:
    model = from_text(one("<joint/>" + SOLID).replace('name="a"', ""))
    assert (list(model.bodies), list(model.joints)) == (["body1"], ["body1.joint"])
    fixed = from_text(mujoco(f"<body>{SOLID}<body>{SOLID}<joint/></body></body>"))
    assert list(fixed.joints) == ["body1.weld", "body2.joint"]


def test_a_reference_is_where_the_body_is_drawn() -> None:
    text = one('<joint axis="0 1 0" ref="30" pos="0 0 0.5" range="-10 50"/>' + SOLID)
    model = from_text(text)
    joint = model.joints["a.joint"]
    assert joint.q0 == (math.radians(30),)
    np.testing.assert_allclose(joint.limits[:2], np.radians([-10, 50]))
    system = build(model)
    drawn = frame_pose(system, "a", [math.radians(30)])
    np.testing.assert_allclose(drawn, np.eye(4), atol=1e-15)
    turned = frame_pose(system, "a", [math.radians(120)])
    np.testing.assert_allclose(turned[:3, :3], about((0, 1, 0), math.pi / 2), atol=1e-15)
    np.testing.assert_allclose(turned[:3, 3], [-0.5, 0, 0.5], atol=1e-15)


def test_limits_ask_for_a_word_where_the_file_says_so() -> None:
    off = '<compiler autolimits="false"/>'
    joint = '<joint range="0 1" {}/>'
    for word, settings, limited in (
        ("", "", True), ("", off, False), ('limited="true"', off, True),
        ('limited="false"', "", False), ('limited="auto"', "", True),
    ):  # fmt: skip
        model = from_text(one(joint.format(word) + SOLID, settings))
        assert (model.joints["a.joint"].limits[0] is not None) is limited


def test_springs_dampers_and_rotors_act() -> None:
    joint = '<joint stiffness="2" springref="90" damping="0.5" armature="0.1" axis="0 1 0"/>'
    model = from_text(one(joint + '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'))
    compiled = cd.compile(model, functions=("forward_dynamics",))
    udot = compiled.forward_dynamics([0.0], [1.0])
    np.testing.assert_allclose(udot, [(2 * math.pi / 2 - 0.5) / 1.1], rtol=1e-15)


def test_a_motor_is_an_input() -> None:
    motor = '<actuator><motor name="m" joint="a.joint" gear="5"/><velocity joint="j"/></actuator>'
    text = one('<joint name="a.joint"/>' + '<inertial pos="0 0 0" mass="1" diaginertia="1 1 2"/>')
    model = from_text(text.replace("</mujoco>", motor + "</mujoco>"))
    compiled = cd.compile(model, functions=("forward_dynamics",))
    np.testing.assert_allclose(compiled.forward_dynamics([0.0], [0.0], r=[3.0]), [7.5])
    assert "not read: actuator velocity" in model.notes


def test_classes_hand_on_what_they_say() -> None:
    more = """
    <default><joint damping="1"/><default class="b"><joint axis="1 0 0"/>
    <default class="c"><joint damping="3"/></default></default></default>"""
    joints = '<joint name="i"/><joint name="j" class="b"/><joint name="k" class="c" damping="4"/>'
    model = from_text(
        one(joints + '<body childclass="c"><joint name="l"/>' + SOLID + "</body>" + SOLID, more)
    )
    assert model.joints["i"].kind == cd.Revolute((0, 0, 1))
    assert all(model.joints[name].kind == cd.Revolute((1, 0, 0)) for name in "jkl")
    damping = [model.forces[f"{name}.damping"].element.damping for name in "ijkl"]
    assert damping == [1, 1, 4, 3]


def test_sites_are_frames() -> None:
    model = from_text(mujoco(f'<site name="home" pos="1 0 0"/><body name="a"><joint/>{SOLID}'
                             '<site name="tip" pos="0 0 1" euler="0 0 90"/></body>'))  # fmt: skip
    assert model.frames["home"].body is model.ground
    assert model.frames["tip"].body is model.bodies["a"]
    assert model.frames["tip"].coordinates == (0, 0, 1)


def test_frames_around_bodies_move_what_is_inside() -> None:
    inside = (
        f'<body name="a" pos="1 0 0"><frame pos="0 0 2"><joint pos="1 0 0"/>{SOLID}</frame></body>'
    )
    text = mujoco(f'<frame pos="0 1 0" euler="0 0 90">{inside}</frame>')
    np.testing.assert_allclose(pose(text, "a")[:3, 3], [0, 2, 0], atol=1e-15)
    system = build(from_text(text))
    # of the box at (0, 0, 2) about the hinge at (1, 0, 2)
    np.testing.assert_allclose(body_mass(system, 0)[1], [-48, 0, 0], atol=1e-12)


# circuits and couplings


def linkage(constraint: str, body: str = "") -> str:
    """Two hinged rods side by side, 0.5 m apart."""
    rods = "".join(
        f'<body name="{name}" pos="{x} 0 0"><joint name="j{name}" axis="0 1 0"/>'
        f'<geom type="capsule" size="0.02" fromto="0 0 0 0 0 1"/><site name="s{name}" pos="0 0 1"/>'
        f"</body>"
        for name, x in (("a", 0), ("b", 0.5))
    )
    text = mujoco(rods + body)
    return text.replace("</mujoco>", f"<equality>{constraint}</equality></mujoco>")


def test_bodies_that_are_connected_as_drawn() -> None:
    text = linkage('<connect name="pin" body1="a" body2="b" anchor="0.5 0 1"/>')
    model = from_text(text)
    pin = model.joints["pin"]
    assert pin.cut
    assert pin.kind == cd.Spherical()
    assert pin.parent.coordinates == (0.5, 0, 1)
    assert pin.child.coordinates == (0, 0, 1)


def test_sites_that_are_connected_or_welded() -> None:
    model = from_text(
        linkage('<connect name="pin" site1="sa" site2="sb"/><weld name="w" site1="sa" site2="sb"/>')
    )
    assert model.joints["pin"].parent.coordinates == (0, 0, 1)
    assert model.joints["w"].kind == cd.Fixed()


def test_welds_keep_the_pose_that_is_drawn_or_given() -> None:
    drawn = from_text(linkage('<weld name="w" body1="a" body2="b"/>')).joints["w"]
    assert drawn.parent.coordinates == (0.5, 0, 0)
    given = '<weld name="w" body1="a" body2="b" relpose="0 1 0 1 0 0 1"/>'
    w = from_text(linkage(given)).joints["w"]
    assert w.parent.coordinates == (0, 1, 0)
    assert w.parent.orientation == ("xyz", 0, 0, math.pi / 2)


def test_joints_that_follow_each_other() -> None:
    linear = '<joint joint1="jb" joint2="ja" polycoef="0.1 2"/>'
    model = from_text(linkage(linear))
    couple = model.joints["jb"].couple
    assert couple is not None
    assert (couple.leader, couple.ratio, couple.offset) == ("ja", 2, 0.1)
    assert not model.constraints
    square = from_text(linkage('<joint name="c" joint1="jb" joint2="ja" polycoef="0 0 3"/>'))
    q = {name: square.q(name) for name in ("ja", "jb")}
    assert square.constraints["c"].expression == q["jb"] - 3.0 * q["ja"] ** 2
    stays = from_text(linkage('<joint name="c" joint1="jb" polycoef="0.3"/>'))
    assert stays.constraints["c"].expression == stays.q("jb") - 0.3


def test_what_does_not_act_is_named() -> None:
    more = '<asset><mesh file="a.stl"/></asset><keyframe/><option timestep="0.01" wind="1 0 0"/>'
    text = linkage('<connect site1="sa" site2="sb" active="false"/><tendon/>')
    model = from_text(text.replace("<worldbody>", more + "<worldbody>"))
    assert model.notes == [
        "not read: asset, keyframe, option timestep=, option wind=, equality connect, "
        "equality tendon"
    ]


# errors

REFUSED = {
    "root": ("<robot/>", "the root is <robot>, not <mujoco>"),
    "no world": ("<mujoco/>", "there is no <worldbody>"),
    "entities": ('<!DOCTYPE a [<!ENTITY x "y">]><mujoco>&x;</mujoco>', "declares entities"),
    "deep": (mujoco("<body>" * 300 + "</body>" * 300), "nested more than"),
    "free inside": (
        mujoco(f"<body>{SOLID}<joint/><body>{SOLID}<freejoint/></body></body>"),
        "text:1: <freejoint>: a free joint is the only one",
    ),
    "free and more": (one(f"{SOLID}<freejoint/><joint/>"), "is the only one"),
    "world joint": (mujoco("<joint/>"), "the world has no joints"),
    "axis": (one(f'{SOLID}<joint axis="0 0 0"/>'), "its axis has no direction"),
    "type": (one(f'{SOLID}<joint type="screw"/>'), "type='screw' of <joint> is none of hinge"),
    "twice": (one(SOLID, place='euler="0 0 1" quat="1 0 0 0"'), "given by quat and euler"),
    "quaternion": (one(SOLID, place='quat="0 0 0 0"'), "quat has no direction"),
    "global": (one(SOLID, '<compiler coordinate="global"/>'), "coordinate='global' is not read"),
    "sequence": (one(SOLID, '<compiler eulerseq="xyzz"/>'), "not three letters"),
    "size": (one('<geom type="box" size="1 2"/>'), "has 2 numbers, but 3 to 3 are wanted"),
    "negative": (one('<geom size="-1"/>'), "must be positive"),
    "density": (one('<geom size="1" density="-1"/>'), "density is negative"),
    "ends": (one('<geom type="capsule" size="1" fromto="0 0 0 0 0 0"/>'), "both ends at one point"),
    "mesh": (one('<geom mesh="m"/>'), "whose volume is not read"),
    "inertia": (
        one('<inertial pos="0 0 0" mass="1" fullinertia="1 1 1 0 0 0" quat="1 1 0 0"/>'),
        "fullinertia stands alone",
    ),
    "class": (one(f'{SOLID}<joint class="clas"/>', '<default class="class"/>'), "mean 'class'"),
    "class twice": (
        one(SOLID, '<default><default class="a"/><default class="a"/></default>'), "defined twice",
    ),
    "class unnamed": (one(SOLID, "<default><default/></default>"), "needs a class"),
    "replicate": (mujoco("<replicate count='3'/>"), "bodies would be missing"),
    "body": (linkage('<connect body1="c" anchor="0 0 0"/>'), "body1 'c' is no body. Bodies: world"),
    "site": (linkage('<weld site1="sa" site2="sd"/>'), "site2 'sd' is no site"),
    "joint": (linkage('<joint joint1="jc"/>'), "joint1 'jc' is no joint"),
    "same": (linkage('<weld body1="a" body2="a"/>'), "same body"),
    "nan": (one(f'{SOLID}<joint pos="nan 0 0"/>'), "no number"),
    "include": (mujoco('<include file="../x.xml"/>'), "leads out of the declared folders"),
    "include nothing": (mujoco('<include file="x.xml"/>'), "there is no file 'x.xml'"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_refused(case: str, tmp_path: Path) -> None:
    text, words = REFUSED[case]
    with pytest.raises(cd.CardanError) as caught:
        from_text(text, folder=tmp_path)
    assert words in str(caught.value)
    assert len(str(caught.value)) < 700


def test_errors_have_file_and_line(tmp_path: Path) -> None:
    path = tmp_path / "arm.xml"
    path.write_text(mujoco('\n<body name="a">\n<joint name="j" axis="0 0"/>\n</body>'))
    with pytest.raises(cd.ModelError, match=r"^arm.xml:3: <joint> 'j': axis='0 0'"):
        cd.load(path)


def test_the_root_tells_files_apart(tmp_path: Path) -> None:
    for name, text in (("a.xml", one(f"<joint/>{SOLID}")), ("b.mjcf", one(SOLID))):
        (tmp_path / name).write_text(text)
        assert list(cd.load(tmp_path / name).bodies) == ["a"]
    (tmp_path / "c.xml").write_text('<robot name="r"><link name="l"/></robot>')
    assert list(cd.load(tmp_path / "c.xml").bodies) == ["l"]
    (tmp_path / "d.xml").write_text("<sdf/>")
    with pytest.raises(cd.ModelError, match="the root is <sdf>; read are <robot> and <mujoco>"):
        cd.load(tmp_path / "d.xml")


def test_included_files_stand_in_place(tmp_path: Path) -> None:
    (tmp_path / "part.xml").write_text(
        f"<mujoco>\n<body name='b'>{SOLID}<joint axis='0 0 0'/></body></mujoco>"
    )
    path = tmp_path / "whole.xml"
    path.write_text(one(f'{SOLID}<joint/><include file="part.xml"/>'))
    with pytest.raises(cd.ModelError, match=r"^part.xml:2: <joint>: its axis has no direction"):
        cd.load(path)
    (tmp_path / "part.xml").write_text(f"<mujoco><body name='b'>{SOLID}<joint/></body></mujoco>")
    assert list(cd.load(path).bodies) == ["a", "b"]
    path.write_text(one(f'{SOLID}<joint/><include file="part.xml"/><include file="part.xml"/>'))
    with pytest.raises(cd.ModelError, match="included twice"):
        cd.load(path)
    (tmp_path / "part.xml").write_text('<mujoco><include file="whole.xml"/></mujoco>')
    with pytest.raises(cd.ModelError, match="included twice"):
        cd.load(path)


WORDS = st.sampled_from(
    ["0", "1", "-1", "nan", "1e309", "", "0 0 1", "1 2 3 4", "a", "hinge", "1e-320"]
)
NAMES = (
    "pos",
    "quat",
    "axis",
    "type",
    "size",
    "fromto",
    "mass",
    "name",
    "joint1",
    "body1",
    "euler",
)
TAGS = ("body", "joint", "geom", "inertial", "site", "freejoint", "frame", "connect", "equality")


def written(tag: str, given: dict[str, str], inside: list[str]) -> str:
    pairs = " ".join(f'{name}="{word}"' for name, word in given.items())
    return f"<{tag} {pairs}>{''.join(inside)}</{tag}>"


ELEMENTS = st.recursive(
    st.builds(
        written, st.sampled_from(TAGS), st.dictionaries(st.sampled_from(NAMES), WORDS), st.just([])
    ),
    lambda inner: st.builds(
        written,
        st.sampled_from(TAGS),
        st.dictionaries(st.sampled_from(NAMES), WORDS),
        st.lists(inner, max_size=4),
    ),
    max_leaves=12,
)


@FUZZ
@given(st.lists(ELEMENTS, max_size=4).map("".join))
def test_any_file_is_a_model_or_one_of_our_errors(inside: str) -> None:
    found = []
    for _ in range(2):
        try:
            found.append(str(from_text(mujoco(inside))))
        except cd.CardanError as problem:
            found.append(str(problem))
    assert found[0] == found[1]
