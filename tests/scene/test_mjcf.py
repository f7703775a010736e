"""MJCF: what it means, and what is said where it is at fault."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import cardan as cd
from cardan.scene.files.mjcf import from_text
from cardan.spatial.numbers import about, of_quaternion, to_quaternion, unit, upright_to
from cardan.topology import build
from scene.fuzzing import FUZZ
from scene.mjcf_texts import SOLID, linkage, mujoco, one
from table import each
from topology.numbers_of import body_mass, frame_pose

# masses


@each(
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


@FUZZ
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


@FUZZ
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
    motor = '<actuator><motor name="m" joint="a.joint" gear="5"/><muscle joint="j"/></actuator>'
    text = one('<joint name="a.joint"/>' + '<inertial pos="0 0 0" mass="1" diaginertia="1 1 2"/>')
    model = from_text(text.replace("</mujoco>", motor + "</mujoco>"))
    compiled = cd.compile(model, functions=("forward_dynamics",))
    np.testing.assert_allclose(compiled.forward_dynamics([0.0], [0.0], r=[3.0]), [7.5])
    assert "actuators muscle1: muscle actuator is not read, so it does nothing" in model.notes


ACTUATED = one('<joint name="h"/><inertial pos="0 0 0" mass="1" diaginertia="1 1 2"/>')


def actuated(actuator: str, default: str = "") -> cd.Scene:
    """A body of 2 kg m^2 on a hinge."""
    classes = f"<mujoco><default>{default}</default>"
    text = ACTUATED.replace("<mujoco>", classes)
    return from_text(text.replace("</mujoco>", f"<actuator>{actuator}</actuator></mujoco>"))


@each(
    ("actuator", "torque"),
    [
        # q = 0.3, u = -0.7, ctrl = 2
        ('<motor name="m" joint="h" gear="3"/>', 3 * 2),
        ('<motor name="m" jointinparent="h"/>', 2),
        ('<position name="m" joint="h"/>', 2 - 0.3),
        ('<position name="m" joint="h" kp="5" kv="0.4"/>', 5 * (2 - 0.3) + 0.4 * 0.7),
        ('<position name="m" joint="h" kp="5" gear="-2"/>', -2 * 5 * (2 - -2 * 0.3)),
        ('<velocity name="m" joint="h" kv="3"/>', 3 * (2 + 0.7)),
        ('<velocity name="m" joint="h" kv="3" gear="2"/>', 2 * 3 * (2 + 2 * 0.7)),
        ('<general name="m" joint="h"/>', 2),
        ('<general name="m" joint="h" gainprm="4" biasprm="1 2 3"/>', 8),
        (
            '<general name="m" joint="h" gainprm="4" biastype="affine" biasprm="1 2 3"/>',
            8 + 1 + 2 * 0.3 - 3 * 0.7,
        ),
        (
            '<general name="m" joint="h" gaintype="affine" gainprm="4 2 1" gear="2"/>',
            2 * (4 + 2 * 2 * 0.3 - 2 * 0.7) * 2,
        ),
    ],
)
def test_actuators(actuator: str, torque: float) -> None:
    scene = actuated(actuator)
    model = cd.compile(scene, functions=("forward_dynamics",))
    assert list(scene.inputs) == ["m"]
    np.testing.assert_allclose(
        model.forward_dynamics([0.3], [-0.7], r=[2.0]), [torque / 2], rtol=1e-14
    )
    assert not scene.notes


@each(
    ("actuator", "note"),
    [
        ('<position name="m" joint="h" timeconst="1"/>', "position with dyntype filterexact is"),
        ('<position name="m" joint="h" dampratio="1"/>', "position with dampratio (give kv) is"),
        ('<general name="m" joint="h" dyntype="filter"/>', "general with dyntype filter is not"),
        ('<general name="m" joint="h" gaintype="muscle"/>', "general with gaintype muscle is not"),
        ('<general name="m" joint="h" biastype="user"/>', "general with biastype user is not read"),
        ('<motor name="m" tendon="t"/>', "motor on a tendon is not read"),
        ('<intvelocity name="m" joint="h"/>', "intvelocity actuator is not read, so it does noth"),
    ],
)
def test_actuators_that_do_nothing_are_named(actuator: str, note: str) -> None:
    scene = actuated(actuator)
    assert not scene.inputs
    (said,) = scene.notes
    assert said.startswith(f"actuators m: {note}")


def test_ranges_of_actuators_do_not_act() -> None:
    scene = actuated(
        '<motor name="m" joint="h" ctrlrange="-1 1"/>'
        '<motor name="n" joint="h" ctrlrange="-1 2" ctrllimited="false"/>'
        '<motor name="o" joint="h" ctrlrange="-1 2" forcerange="0 3"/>'
    )
    ctrl = "actuators m (-1, 1), o (-1, 2): ctrlrange does not act; keep the input inside"
    force = "actuators o (0, 3): forcerange does not act; the force has no bounds"
    assert [n for n in scene.notes if "actuators" in n] == [ctrl, force]


def test_actuators_share_their_defaults() -> None:
    scene = actuated('<motor name="m" joint="h"/>', '<position gear="2" kp="7"/>')
    model = cd.compile(scene, functions=("forward_dynamics",))
    np.testing.assert_allclose(model.forward_dynamics([0.3], [0.0], r=[1.0]), [2 / 2])


def test_a_motor_with_the_name_of_its_joint() -> None:
    motor = '<actuator><motor name="hip" joint="hip"/></actuator></mujoco>'
    model = from_text(one('<joint name="hip"/>' + SOLID).replace("</mujoco>", motor))
    assert list(model.inputs) == list(model.forces) == ["hip.motor"]
    assert cd.compile(model, functions=("forward_dynamics",)).nr == 1


def test_masses_are_scaled_to_their_total() -> None:
    bodies = f'<body name="a"><joint/>{SOLID}<body><joint/>{SOLID}</body></body>'
    system = build(from_text(mujoco(bodies, '<compiler settotalmass="6"/>')))
    for body in range(2):
        mass, _, inertia = body_mass(system, body)
        np.testing.assert_allclose(mass, 3, rtol=1e-15)
        np.testing.assert_allclose(inertia, np.diag([0.13, 0.10, 0.05]), atol=1e-15)


def test_a_weld_is_not_assembled_with_axes_exchanged() -> None:
    """Turned by 120 degrees about the diagonal its conditions hold too, to rounding."""
    loose = (
        '<body name="c" pos="0.1 0 1.2"><freejoint/>'
        '<inertial pos="0.1 0 0" mass="0.5" diaginertia="0.01 0.02 0.015"/></body>'
    )
    text = linkage('<weld body1="b" body2="c" relpose="0 0.2 1 1 0.3 0 0.1"/>', loose)
    model = cd.compile(from_text(text.replace('name="b" pos', 'name="b" euler="10 0 40" pos')))
    q = model.assemble({"ja": 0.3}).q
    turn = model.pose("b", q)[:3, :3].T @ model.pose("c", q)[:3, :3]
    expected = Rotation.from_quat([1, 0.3, 0, 0.1], scalar_first=True).as_matrix()
    np.testing.assert_allclose(turn, expected, atol=1e-12)


def test_names_do_not_clash() -> None:
    inside = (
        f'<site name="b"/><joint name="x"/><joint name="y"/>{SOLID}<body name="a.x">{SOLID}</body>'
    )
    model = from_text(mujoco(f'<body name="a">{inside}</body><body name="b">{SOLID}</body>'))
    assert set(model.bodies) == {"a", "a.x", "a.x_", "b"}
    assert "b_" in model.frames


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


# loops and couplings


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
        "no contacts are read: bodies pass through each other; add cd.Contact where something "
        "touches",
        "not read: asset, keyframe, option timestep=, option wind=, equality connect, "
        "equality tendon",
    ]
