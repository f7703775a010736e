"""Model -> System: numbering, slots, parameters, merged bodies, errors."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest
import sympy
from scipy.spatial.transform import Rotation

from cardan.api.scene import Scene
from cardan.elements.forces import Force, JointDamper, JointForce
from cardan.elements.joints import Fixed, Free, Prismatic, Revolute, Spherical
from cardan.errors import ModelError
from cardan.scene import inertia
from cardan.topology import build, named_speeds
from topology.numbers_of import body_mass, body_poses, frame_pose, values


def pendulum():
    scene = Scene("double_pendulum")
    m = scene.parameter("m", 1.0, unit="kg")
    l = scene.parameter("l", 500, unit="mm")
    rod = inertia.rod(m, l, axis="z")
    upper = scene.body("upper", mass=m, com=(0, 0, -l / 2), inertia=rod)
    lower = scene.body("lower", mass=2.0, com=(0, 0, -0.25), inertia=(0.1, 0.2, 0.15))
    scene.joint("shoulder", Revolute("y"), scene.ground, upper)
    scene.joint("elbow", Revolute("y"), upper.at(0, 0, -l), lower)
    return scene


def test_double_pendulum():
    system = build(pendulum())
    assert [b.name for b in system.bodies] == ["upper", "lower"]
    assert [b.parent for b in system.bodies] == [-1, 0]
    assert (system.nq, system.nu) == (2, 2)
    names = [p.name for p in system.parameters]
    # declared ones first, exact zeros nowhere
    assert names[:2] == ["m", "l"]
    assert names[2:] == [
        "gravity.z",
        "lower.mass",
        "lower.com.z",
        "lower.inertia.xx",
        "lower.inertia.yy",
        "lower.inertia.zz",
    ]
    assert system.parameters[1].value == 0.5
    assert system.parameters[1].unit == "m"
    assert system.structural["lower.com.x"] == 0
    poses = body_poses(system, [0.3, 0.4])
    np.testing.assert_allclose(poses[1][:3, 3], [-0.5 * np.sin(0.3), 0, -0.5 * np.cos(0.3)])
    mass, first, moment = body_mass(system, 0)
    np.testing.assert_allclose(first, [0, 0, -0.25], rtol=1e-15)
    np.testing.assert_allclose(moment, np.diag([1 / 12, 1 / 12, 0]), atol=1e-16)
    assert mass == 1.0


def test_regular_numbering_keeps_declaration_order_where_it_can():
    scene = Scene("m")
    a, b, c = (scene.body(name, mass=1.0) for name in "abc")
    scene.joint("j_c", Revolute("y"), b, c)
    scene.joint("j_b", Revolute("y"), a, b)
    scene.joint("j_a", Revolute("y"), scene.ground, a)
    system = build(scene)
    assert [j.name for j in system.joints] == ["j_a", "j_b", "j_c"]


def test_a_negative_unit_axis_and_zeros_are_structural_and_other_numbers_are_not():
    scene = Scene("m")
    body = scene.body("b", mass=1.0, com=(1.0, 0, 0))
    scene.joint("j", Revolute((0, 0.6, -0.8)), scene.ground, body)
    system = build(scene)
    named = {p.name: p.value for p in system.parameters}
    # 1 is structural in ratios only
    assert named["b.com.x"] == 1.0
    assert named["j.axis.y"] == 0.6
    assert "j.axis.x" in system.structural


def rotations():
    found = []
    rng = np.random.default_rng(7)
    for _ in range(20):
        found.append(Rotation.random(random_state=rng))
    for angles in ([90, 0, 0], [0, 90, 30], [0, -90, 0], [180, 0, 0], [45, 90, 45]):
        found.append(Rotation.from_euler("xyz", angles, degrees=True))
    return found


@pytest.mark.filterwarnings("ignore:Gimbal lock")
@pytest.mark.parametrize("r", rotations())
def test_rotations_given_as_matrix_scipy_or_sequence(r):
    scene = Scene("m")
    body = scene.body("b", mass=1.0)
    upper, lower = r.as_euler("ZYX"), r.as_euler("xyz")
    body.at(rotation=r.as_matrix(), name="matrix")
    body.at(rotation=r, name="scipy")
    body.at(rotation=("ZYX", *upper), name="body_fixed")
    body.at(rotation=("xyz", *lower), name="fixed")
    scene.joint("j", Revolute("y"), scene.ground, body)
    system = build(scene)
    for name in ("matrix", "scipy", "body_fixed", "fixed"):
        found = frame_pose(system, name)[:3, :3]
        np.testing.assert_allclose(found, r.as_matrix(), rtol=0, atol=2e-15)


def test_quarter_turns_are_structural():
    scene = Scene("m")
    body = scene.body("b", mass=1.0)
    body.at(rotation=("xyz", np.pi / 2, -np.pi, 1.5 * np.pi), name="f")
    scene.joint("j", Revolute("y"), scene.ground, body)
    system = build(scene)
    frame = next(f for f in system.frames if f.name == "f")
    assert set(frame.rotation) <= {0, 1, 2}
    expected = Rotation.from_euler("xyz", [90, -180, 270], degrees=True).as_matrix()
    np.testing.assert_array_equal(values(system, frame.rotation).reshape(3, 3), expected.round())


@pytest.mark.parametrize(
    ("rotation", "words"),
    [
        ([[1, 0, 0], [0, 1, 0], [0, 0, -1]], "reflection"),
        ([[1, 0, 0], [0, 1, 0], [0, 0.1, 1]], "not a rotation"),
        (("XYz", 1, 2, 3), "sequence"),
        ([[1, 0], [0, 1]], "3x3"),
    ],
)
def test_what_is_no_rotation(rotation, words):
    scene = Scene("m")
    body = scene.body("b", mass=1.0)
    scene.joint("j", Revolute("y"), scene.ground.at(rotation=rotation), body)
    with pytest.raises(ModelError, match=words):
        build(scene)


def test_child_frame_moves_the_axes_of_the_body():
    """The mass properties of a body in the axes of its joint, against plain NumPy."""
    rng = np.random.default_rng(11)
    r, place, com = Rotation.random(random_state=rng), rng.normal(size=3), rng.normal(size=3)
    tensor = np.diag([0.5, 0.6, 0.7])
    scene = Scene("m")
    body = scene.body("b", mass=2.0, com=com, inertia=tensor)
    scene.joint("j", Revolute("y"), scene.ground, body.at(*place, rotation=r))
    mass, first, moment = body_mass(build(scene), 0)
    turn = r.as_matrix().T
    c = turn @ (com - place)
    np.testing.assert_allclose(first, 2 * c, atol=1e-14)
    expected = turn @ tensor @ turn.T + 2 * (c @ c * np.eye(3) - np.outer(c, c))
    np.testing.assert_allclose(moment, expected, atol=1e-14)
    assert mass == 2.0


def test_fixed_joints_merge_bodies_and_keep_parts_and_frames():
    r = Rotation.from_euler("xyz", [0.3, -0.2, 0.5])
    scene = Scene("m")
    a = scene.body("a", mass=1.0, com=(0.1, 0, 0), inertia=(0.1, 0.1, 0.1))
    b = scene.body("b", mass=2.0, com=(0, 0.2, 0), inertia=(0.2, 0.3, 0.4))
    c = scene.body("c", mass=3.0)
    # the weld of c is declared from c to b
    scene.joint("hinge", Revolute("z"), scene.ground, a)
    scene.joint("weld", Fixed(), a.at(1, 2, 3, rotation=r), b)
    scene.joint("weld2", Fixed(), c.at(0, 0, 1), b.at(0, 1, 0))
    system = build(scene)
    assert len(system.bodies) == 1
    (body,) = system.bodies
    assert [(p.name, p.inboard, p.joint) for p in body.parts] == [
        ("a", -1, ""),
        ("b", 0, "weld"),
        ("c", 1, "weld2"),
    ]
    assert system.fixed == ("weld", "weld2")
    pose_b = frame_pose(system, "b")
    np.testing.assert_allclose(pose_b[:3, :3], r.as_matrix(), atol=1e-15)
    np.testing.assert_allclose(pose_b[:3, 3], [1, 2, 3], atol=1e-15)
    pose_c = frame_pose(system, "c")
    at = np.array([1, 2, 3])
    np.testing.assert_allclose(pose_c[:3, 3], at + r.apply([0, 1, -1]), atol=1e-15)
    mass, first, moment = body_mass(system, 0)
    points = [(1.0, np.array([0.1, 0, 0])), (2.0, at + r.apply([0, 0.2, 0]))]
    points.append((3.0, pose_c[:3, 3]))
    assert mass == 6
    np.testing.assert_allclose(first, sum(m * p for m, p in points), atol=1e-14)
    turned = r.as_matrix() @ np.diag([0.2, 0.3, 0.4]) @ r.as_matrix().T
    expected = 0.1 * np.eye(3) + turned
    expected += sum(m * (p @ p * np.eye(3) - np.outer(p, p)) for m, p in points)
    np.testing.assert_allclose(moment, expected, atol=1e-13)


def test_bodies_fixed_to_the_ground_are_its_parts():
    scene = Scene("m")
    base = scene.body("base", mass=5.0)
    arm = scene.body("arm", mass=1.0)
    scene.joint("bolt", Fixed(), scene.ground.at(0, 0, 1.5), base)
    scene.joint("hinge", Revolute("z"), base.at(0, 0, 0.5), arm)
    system = build(scene)
    assert [p.name for p in system.ground_parts] == ["ground", "base"]
    assert system.bodies[0].parent == -1
    np.testing.assert_allclose(body_poses(system)[0][:3, 3], [0, 0, 2])


def test_slots_of_joints_with_several_coordinates():
    scene = Scene("m")
    a, b, c = (scene.body(name, mass=1.0, inertia=(1, 1, 1)) for name in "abc")
    scene.joint("free", Free(), scene.ground, a)
    scene.joint("ball", Spherical(), a, b)
    scene.joint("slide", Prismatic("x"), b, c, q0=0.25, limits={"lower": -1, "effort": 3})
    system = build(scene)
    assert [j.q for j in system.joints] == [0, 7, 11]
    assert [j.u for j in system.joints] == [0, 6, 9]
    assert system.joints[2].q0 == (0.25,)
    assert system.joints[2].limits == (-1, None, None, 3)


def test_expressions_in_forces_and_outputs():
    scene = pendulum()
    k = scene.parameter("k", 3.0)
    torque = scene.input("torque", default=0.5)
    q, u = scene.q("elbow"), scene.u("shoulder")
    scene.force("motor", JointForce("elbow", torque - k * q))
    scene.force("drag", JointDamper("shoulder", 0.1))
    tip = scene.bodies["lower"].at(0, 0, -0.5, name="tip")
    scene.output("height", tip.position()[2], unit="m")
    scene.output("mixed", sympy.sin(q) * u + sympy.Symbol("t"))
    system = build(scene)
    motor = system.forces[0]
    assert motor.joints == {"joint": 1}
    ((_, _, (node,)),) = motor.data.values()
    assert values(system, [node], q=[0, 0.2])[0] == pytest.approx(0.5 - 3 * 0.2)
    assert system.atoms["tip.position.z"].component == 2
    mixed = system.outputs[1].node
    found = values(system, [mixed], q=[0, 0.2], u=[0.7, 0], t=[2.0])[0]
    assert found == pytest.approx(np.sin(0.2) * 0.7 + 2)
    assert [p.name for p in system.parameters if p.name.startswith("drag")] == ["drag.damping"]


def test_named_speeds():
    scene = pendulum()
    system = build(scene)
    expressions = {"one": scene.u("shoulder"), "two": scene.u("shoulder") + scene.u("elbow")}
    found = named_speeds(scene, system, expressions)
    assert [s.name for s in found] == ["one", "two"]
    np.testing.assert_allclose(values(system, [s.node for s in found], u=[1, 2]), [1, 3])
    with pytest.raises(ModelError, match="the system has 2"):
        named_speeds(scene, system, {"one": scene.u("elbow")})


def test_values_replace_numbers_by_dotted_name():
    scene = pendulum()
    scene.values.update({"lower.mass": 5.0, "lower.com.x": 0.1, "l": 0.7})
    named = {p.name: p.value for p in build(scene).parameters}
    assert (named["lower.mass"], named["lower.com.x"], named["l"]) == (5.0, 0.1, 0.7)
    scene.values["lowr.mass"] = 1.0
    with pytest.raises(ModelError, match=r"'lowr.mass'.*Did you mean 'lower.mass'"):
        build(scene)


def test_a_chain_of_numbers_needs_no_sympy():
    program = """
import sys
from cardan.elements.joints import Revolute
from cardan import Scene
from cardan.topology import build
scene = Scene("chain")
inner = scene.ground
for k in range(100):
    body = scene.body(f"b{k}", mass=1.0, com=(0.5, 0, 0), inertia=(0.1, 0.1, 0.1))
    scene.joint(f"j{k}", Revolute("y"), inner.at(1, 0, 0), body)
    inner = body
print(build(scene).nq, scene.graph.mass_pattern.shape, "sympy" in sys.modules)
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.stdout.strip() == "100 (100, 100) False", done.stderr


def test_symbols_of_joints_whose_names_begin_alike():
    scene = Scene("m")
    a, b = scene.body("a", mass=1.0), scene.body("b", mass=1.0)
    scene.joint("z", Free(), scene.ground, a)
    scene.joint("z.w", Revolute("y"), a, b)
    assert scene.q("z.px") == sympy.Symbol("z.px")
    assert scene.atoms["z.px"].place == "z"
    scene.u("z.w")
    assert scene.atoms["z.w.u"].place == "z.w"


def test_build_changes_nothing_and_repeats_itself():
    scene = pendulum()
    one, two = build(scene), build(scene)
    assert one.graph.nodes == two.graph.nodes
    assert one.bodies == two.bodies


def test_made_names_give_way_to_those_of_the_user():
    scene = pendulum()
    upper, lower = scene.bodies["upper"], scene.bodies["lower"]
    upper.at(9, 0, 0, name="elbow.parent")
    lower.at(8, 0, 0, name="push.frame")
    scene.force("push", Force(lower.at(), (1, 0, 0)))
    system = build(scene)
    names = [frame.name for frame in system.frames]
    assert len(set(names)) == len(names)
    assert frame_pose(system, "elbow.parent", [0, 0])[0, 3] == 9
    assert frame_pose(system, "push.frame", [0, 0])[0, 3] == 8
    assert system.frames[system.forces[0].frames["frame"]].name == "push.frame_"


def test_a_parameter_keeps_its_name_beside_a_zero_of_the_same_name() -> None:
    scene = pendulum()
    fall = scene.parameter("gravity.z", -3.0, unit="N")
    scene.gravity = (0, 0, 0)
    scene.force("fall", Force(scene.bodies["lower"].at(), (0, 0, fall)))
    upper, lower = scene.bodies["upper"], scene.bodies["lower"]
    scene.joint("post", Revolute("y"), scene.ground.at(0.3, 0, 0), scene.body("arm", mass=1.0))
    lower.at(8, 0, 0, name="push.frame")
    scene.force("push", Force(upper.at(), (1, 0, 0)))
    system = build(scene)
    names = {parameter.name for parameter in system.parameters}
    assert {"gravity.z", "post.position.x", "push.frame.position.x"} <= names
    assert not names & set(system.structural)


def test_a_parameter_keeps_its_name_beside_an_angle_of_the_same_name() -> None:
    scene = pendulum()
    push = scene.parameter("tip.rotation.roll", 2.0, unit="N")
    lower = scene.bodies["lower"]
    tip = lower.at(0.1, 0, 0, rotation=("xyz", 0, 0.3, 0), name="tip")
    scene.joint("wrist", Revolute("y"), tip, scene.body("arm", mass=1.0))
    scene.force("push", Force(lower.at(), (0, 0, push)))
    system = build(scene)
    names = {parameter.name for parameter in system.parameters}
    assert {"tip.rotation.roll", "tip.rotation.pitch"} <= names
    assert not names & set(system.structural)


def test_plain_lengths_fit_beside_parameters_with_units() -> None:
    scene = Scene("cylinder")
    m = scene.parameter("m", 2.0, unit="kg")
    body = scene.body("body", mass=m, inertia=inertia.cylinder(m, 0.3, 0.5))
    scene.joint("hinge", Revolute("y"), scene.ground, body)
    assert build(scene).parameters
