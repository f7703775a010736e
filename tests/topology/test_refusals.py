"""Model -> System: what a scene is refused for, and what is announced."""

from __future__ import annotations

import pytest
import sympy

from cardan.api.scene import Scene
from cardan.elements.forces import JointForce
from cardan.elements.joints import Fixed, Revolute
from cardan.errors import ModelError, TopologyError
from cardan.scene import inertia
from cardan.topology import build


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


def test_a_circuit_knows_the_joints_of_its_loop():
    scene = Scene("m")
    bodies = [scene.body(f"b{k}", mass=1.0) for k in range(4)]
    scene.joint("stem", Revolute("y"), scene.ground, bodies[0])
    scene.joint("left", Revolute("y"), bodies[0], bodies[1])
    scene.joint("right", Revolute("y"), bodies[0], bodies[2])
    scene.joint("close", Revolute("y"), bodies[1], bodies[2])
    scene.joint("tail", Revolute("y"), bodies[2], bodies[3])
    system = build(scene)
    (cut,) = system.cuts
    assert cut.name == "close"
    assert {system.joints[i].name for i, _ in cut.path} == {"left", "right"}


def test_loose_bodies():
    scene = Scene("m")
    a, b = scene.body("a", mass=1.0), scene.body("b", mass=1.0)
    scene.joint("j", Revolute("y"), a, b)
    with pytest.raises(TopologyError, match=r"bodies 'a', 'b' to the ground.*Free"):
        build(scene)
    # a joint whose child is nearer to the ground is told the other way round
    scene.joint("k", Revolute("y"), scene.ground, b)
    system = build(scene)
    assert [(joint.name, joint.reversed) for joint in system.joints] == [("k", False), ("j", True)]


def test_unknown_symbol_and_wrong_units():
    scene = pendulum()
    scene.output("x", sympy.Symbol("mm") * 2)
    with pytest.raises(ModelError, match="mm"):
        build(scene)
    scene = Scene("m")
    length = scene.parameter("length", 1.0, unit="m")
    mass = scene.parameter("mass", 1.0, unit="kg")
    body = scene.body("b", mass=length)
    scene.joint("j", Revolute("y"), scene.ground, body)
    with pytest.raises(ModelError, match=r"'b.mass'.*measured in m, but kg"):
        build(scene)
    other = Scene("n")
    other.parameter("length", 1.0, unit="m")
    other.parameter("mass", 1.0, unit="kg")
    body = other.body("b", mass=1.0, com=(length + mass, 0, 0))
    other.joint("j", Revolute("y"), other.ground, body)
    with pytest.raises(ModelError, match="adds"):
        build(other)


def test_masses_given_as_expressions_are_checked_at_their_defaults():
    scene = Scene("m")
    m = scene.parameter("m", -1.0)
    body = scene.body("b", mass=2 * m)
    scene.joint("j", Revolute("y"), scene.ground, body)
    with pytest.raises(ModelError, match="body 'b': mass is -2"):
        build(scene)
    scene = Scene("m")
    moment = scene.parameter("moment", 1.0)
    body = scene.body("flat", mass=1.0, inertia=(moment, moment, 3 * moment))
    scene.joint("j", Revolute("y"), scene.ground, body)
    with pytest.warns(UserWarning, match="'flat': its inertia violates"):
        build(scene)


def test_what_a_body_is_depends_on_parameters_only():
    scene = Scene("m")
    body = scene.body("b", mass=2 + sympy.Symbol("t"))
    scene.joint("j", Revolute("y"), scene.ground, body)
    with pytest.raises(ModelError, match=r"'b.mass' may depend on parameters only; it has 't'"):
        build(scene)
    scene = pendulum()
    scene.bodies["lower"].at(scene.q("shoulder"), 0, 0, name="f")
    with pytest.raises(ModelError, match=r"'f.position.x' may depend.*'shoulder'"):
        build(scene)


def test_forces_on_joints_that_do_not_move():
    scene = pendulum()
    scene.force("f", JointForce("elbw", 1.0))
    with pytest.raises(ModelError, match=r"'elbw' does not exist.*Did you mean 'elbow'"):
        build(scene)
    scene = pendulum()
    tool = scene.body("tool", mass=1.0)
    scene.joint("weld", Fixed(), scene.bodies["lower"], tool)
    scene.force("f", JointForce("weld", 1.0))
    with pytest.raises(ModelError, match="'weld' is fixed"):
        build(scene)


def test_notes_name_what_is_unused_and_massless_tips():
    scene = pendulum()
    scene.parameter("spare", 1.0)
    scene.input("unused")
    sensor = scene.body("sensor")
    scene.joint("pan", Revolute("z"), scene.bodies["lower"], sensor)
    notes = "\n".join(build(scene).notes)
    assert "parameter 'spare' is declared but used nowhere" in notes
    assert "input 'unused'" in notes
    assert "body 'sensor' is a massless tip" in notes
    assert "'m'" not in notes


def test_coordinate_and_parameter_of_one_name():
    scene = pendulum()
    scene.parameter("elbow", 1.0)
    with pytest.raises(ModelError, match="taken by a parameter"):
        build(scene)


def test_a_parameter_with_the_name_of_a_placeholder():
    scene = pendulum()
    scene.parameter("lower.position.x", 3.0)
    scene.output("x", scene.bodies["lower"].position()[0])
    with pytest.raises(ModelError, match=r"'lower.position.x' stands for the motion of a frame"):
        build(scene)


def test_a_matrix_is_no_output():
    scene = pendulum()
    scene.output("place", scene.bodies["lower"].position())
    with pytest.raises(ModelError, match=r"'output.place': one expression.*shape \(3, 1\)"):
        build(scene)


def test_expressions_nested_beyond_reading_are_refused() -> None:
    scene = Scene("deep")
    body = scene.body("body", mass=1.0)
    scene.joint("hinge", Revolute("y"), scene.ground, body)
    law = scene.q("hinge")
    for _ in range(300):
        law = sympy.Add(sympy.Mul(law, 2, evaluate=False), 1, evaluate=False)

    def made() -> None:
        scene.force("law", JointForce("hinge", law))
        build(scene)

    with pytest.raises(ModelError, match="nested too deeply"):
        made()
