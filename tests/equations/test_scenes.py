"""Scenes small enough for a closed form: reactions, prescribed motion, chosen speeds, outputs."""

from __future__ import annotations

import math

import numpy as np
import pytest

import cardan as cd
from cardan.equations.formalisms import FORMALISMS
from table import each

G = 9.81
BALL = (0.1, 0.1, 0.1)


def console(reverse: bool = False) -> cd.Scene:
    """A horizontal arm of two welded bodies with a weight hanging from its tip."""
    scene = cd.Scene("console", gravity=(0, 0, -G))
    inner = scene.body("inner", mass=2, com=(0.1, 0, 0), inertia=BALL)
    outer = scene.body("outer", mass=3, com=(0.5, 0, 0), inertia=BALL)
    bob = scene.body("bob", mass=1, com=(0, 0, -1), inertia=BALL)
    scene.joint("base", cd.Revolute("y"), scene.ground, inner)
    ends = (outer, inner.at(1, 0, 0)) if reverse else (inner.at(1, 0, 0), outer)
    scene.joint("weld", cd.Fixed(), *ends)
    scene.joint("hook", cd.Revolute("y"), outer.at(1, 0, 0), bob)
    return scene


@pytest.mark.parametrize("reverse", [False, True])
def test_reaction_of_a_weld_at_rest(reverse: bool) -> None:
    """Both weights hang on the weld: 3 kg at 0.5 m and 1 kg at 1 m."""
    model = cd.compile(console(reverse), functions=["inverse_dynamics", "reaction"])
    rest = [0.0, 0.0]
    tau = model.inverse_dynamics(rest, rest, rest)
    expected = np.array([0, -(1.5 + 1.0) * G, 0, 0, 0, 4 * G]) * (-1 if reverse else 1)
    np.testing.assert_allclose(model.reaction("weld", rest, rest, tau=tau), expected, atol=1e-13)


def test_reaction_counts_wrenches_on_the_right_part() -> None:
    """A wrench on the outer body loads the weld, one on the inner body does not."""
    model = cd.compile(
        console(), functions=["inverse_dynamics", "reaction", "pose", "frame_jacobian"]
    )
    rest, up = [0.0, 0.0], np.array([0, 0, 0, 0, 0, 5.0])
    loads = {}
    for body in ("inner", "outer"):
        tau = model.inverse_dynamics(rest, rest, rest, wrenches={body: up})
        loads[body] = model.reaction("weld", rest, rest, tau=tau, wrenches={body: up})
    np.testing.assert_allclose(loads["inner"] - loads["outer"], up, atol=1e-13)


def test_force_of_a_prescribed_motion_is_the_rate_of_momentum() -> None:
    """A pendulum of 2 kg and 1 m on a cart of 1 kg that moves as 0.3 sin 2t."""
    import sympy

    scene = cd.Scene("crane", gravity=(0, 0, -G))
    cart = scene.body("cart", mass=1)
    bob = scene.body("bob", mass=2, com=(0, 0, -1))
    scene.joint("rail", cd.Prismatic("x"), scene.ground, cart, prescribed=0.3 * sympy.sin(2 * cd.t))
    scene.joint("rope", cd.Revolute("y"), cart, bob)
    model = cd.compile(scene, functions=["forward_dynamics", "outputs"])
    angle, rate, t = 0.3, 0.7, 0.5
    acceleration = -1.2 * math.sin(2 * t)
    # about the moving pivot: theta'' = x'' cos(theta) - g sin(theta)
    turning = acceleration * math.cos(angle) - G * math.sin(angle)
    got = model.forward_dynamics([angle], [rate], t=t)
    np.testing.assert_allclose(got, [turning], rtol=1e-14)
    swing = -turning * math.cos(angle) + rate**2 * math.sin(angle)
    force = model.outputs([angle], [rate], t=t)
    np.testing.assert_allclose(force, [3 * acceleration + 2 * swing], rtol=1e-14)


def test_chosen_speeds_transform_the_equations() -> None:
    """w = Y u: the mass matrix becomes Y^-T M Y^-1 and udot follows from wdot."""
    scene = console()
    speeds = {"w1": scene.u("base"), "w2": scene.u("base") + scene.u("hook")}
    chosen = cd.compile(cd.derive(scene, speeds=speeds))
    usual = cd.compile(scene)
    q, u = np.array([0.3, -0.8]), np.array([0.4, 1.1])
    y = np.array([[1.0, 0.0], [1.0, 1.0]])
    back = np.linalg.inv(y)
    m = usual.mass_matrix(q)
    np.testing.assert_allclose(chosen.mass_matrix(q), back.T @ m @ back, rtol=1e-13)
    np.testing.assert_allclose(chosen.qdot(q, y @ u), u, rtol=1e-14)
    udot = usual.forward_dynamics(q, u)
    np.testing.assert_allclose(chosen.forward_dynamics(q, y @ u), y @ udot, rtol=1e-12)


def test_accelerations_stand_in_outputs_but_not_in_force_laws() -> None:
    scene = console()
    scene.output("fall", scene.bodies["bob"].acceleration()[2])
    udot = cd.compile(scene, functions=["outputs"]).outputs([0.0, 0.0], [0.0, 0.0])
    assert udot[0] < 0
    scene.force("jet", cd.Force(scene.bodies["bob"], (0, 0, scene.bodies["bob"].acceleration()[2])))
    with pytest.raises(cd.DerivationError, match="acceleration of frame 'bob' cannot stand"):
        cd.derive(scene).function("forward_dynamics")


@each("method", FORMALISMS)
def test_a_massless_tip_is_named(method: str) -> None:
    scene = cd.Scene("tip")
    arm = scene.body("arm", mass=1, com=(0.5, 0, 0), inertia=BALL)
    tip = scene.body("tip", mass=0)
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, arm)
    scene.joint("wrist", cd.Revolute("z"), arm.at(1, 0, 0), tip)
    equations = cd.derive(scene, method=method)
    with pytest.raises(cd.DerivationError, match="joint 'wrist'"):
        equations.function("forward_dynamics")
    assert equations.function("inverse_dynamics").operations()


def test_small_matrices_come_out_as_a_textbook_has_them() -> None:
    """A pole of mass m at distance d on a cart: sin² + cos² and what cancels are gone."""
    import sympy

    scene = cd.Scene("cart_pole", gravity=(0, 0, -G))
    m, d, c, moment = (scene.parameter(n, 1.0) for n in ("m", "d", "c", "moment"))
    cart = scene.body("cart", mass=c)
    pole = scene.body("pole", mass=m, com=(0, 0, d), inertia=(moment, moment, 0))
    scene.joint("track", cd.Prismatic("x"), scene.ground, cart)
    scene.joint("hinge", cd.Revolute("y"), cart, pole)
    angle, rate, g = sympy.symbols("hinge hinge.u gravity.z")
    for method in ("kane", "composite"):
        equations = cd.derive(scene, method=method)
        coupling = m * d * sympy.cos(angle)
        assert equations.mass_matrix == sympy.Matrix(
            [[c + m, coupling], [coupling, m * d**2 + moment]]
        )
        turning = -m * d * rate**2 * sympy.sin(angle)
        assert equations.bias == sympy.Matrix([turning, g * m * d * sympy.sin(angle)])


@each("method", FORMALISMS)
def test_motion_as_an_expression_of_an_input(method: str) -> None:
    """A table that turns by twice an input carries a point mass on a pin.

    The pin at P has the axis a and holds the mass at c; the table turns at W with the acceleration
    A. Along n = a x c, in which the pin lets the mass go, it feels no force:
    n . (A x (P + c) + W x (W x (P + c))) + n . n udot = 0 at u = 0.
    """
    scene = cd.Scene("table", gravity=(0, 0, 0))
    turn = scene.input("turn")
    table, arm = scene.body("table"), scene.body("arm", mass=2, com=(0.3, 0.2, 0.1))
    scene.joint("axle", cd.Revolute("z"), scene.ground, table, prescribed=2 * turn)
    scene.joint("pin", cd.Revolute((0, 1, 1)), table.at(1, 0, 0), arm)
    value, rate, acceleration = 0.1, 0.5, 0.9
    model = cd.compile(scene, functions=["forward_dynamics"], method=method)
    found = model.forward_dynamics([0.0], [0.0], r=[value, rate, acceleration])
    spin, turning = np.array([0, 0, 2 * rate]), np.array([0, 0, 2 * acceleration])
    arm_of, axis = np.array([0.3, 0.2, 0.1]), np.array([0, 1, 1]) / math.sqrt(2)
    place = np.array([1, 0, 0]) + arm_of
    carried = np.cross(turning, place) + np.cross(spin, np.cross(spin, place))
    lever = np.cross(axis, arm_of)
    np.testing.assert_allclose(found, [-lever @ carried / (lever @ lever)], rtol=1e-13)


@pytest.mark.parametrize("method", ["kane", "newton_euler"])
def test_a_custom_joint_moved_by_an_expression_of_an_input(method: str) -> None:
    """A slide on y = x^2 with x = 2 r: what hangs on it feels y'' = 2 (x'^2 + x x'')."""
    import sympy

    x = sympy.Symbol("x")
    scene = cd.Scene("slide", gravity=(0, 0, 0))
    r = scene.input("r")
    shoe, rider = scene.body("shoe"), scene.body("rider", mass=1)
    scene.joint("rail", cd.Custom([x], position=(x, x**2, 0)), scene.ground, shoe, prescribed=2 * r)
    scene.joint("post", cd.Prismatic("y"), shoe, rider)
    model = cd.compile(scene, functions=["forward_dynamics"], method=method)
    found = model.forward_dynamics([0.0], [0.0], r=[0.1, 0.5, 0.9])
    np.testing.assert_allclose(found, [-2 * (1.0**2 + 0.2 * 1.8)], rtol=1e-14)


def test_reaction_of_a_bracket_fixed_to_the_ground_carries_what_acts_on_it() -> None:
    scene = cd.Scene("wall", gravity=(0, 0, -G))
    bracket = scene.body("bracket", mass=2, com=(0.1, 0, 0))
    scene.joint("bolt", cd.Fixed(), scene.ground.at(0, 0, 1), bracket)
    scene.force("pull", cd.Force(bracket.at(1, 0, 0), (3, 5, 0)))
    model = cd.compile(scene, functions=["reaction"])
    expected = [0, -0.2 * G, -5, -3, -5, 2 * G]
    np.testing.assert_allclose(model.reaction("bolt", [], []), expected, rtol=1e-15, atol=1e-15)


def test_a_scene_that_carries_no_mass_prints_and_has_no_center_of_mass() -> None:
    scene = cd.Scene("hollow")
    scene.joint("pin", cd.Revolute("z"), scene.ground, scene.body("hand"))
    equations = cd.derive(scene)
    assert "inverse_dynamics" in str(equations)
    assert "forward_dynamics" not in str(equations)
    with pytest.raises(cd.DerivationError, match="com: nothing that moves has a mass"):
        equations.function("com")


def test_options_do_not_go_with_derived_equations() -> None:
    with pytest.raises(cd.DerivationError, match="method: the equations are derived already"):
        cd.compile(cd.derive(console()), method="kane")


@pytest.mark.parametrize("function", ["reciprocal", "log"])
def test_what_is_always_zero_has_no_reciprocal(function: str) -> None:
    """The console moves in the plane of x and z."""
    import sympy

    scene = console()
    y = scene.bodies["bob"].position()[1]
    scene.output("o", 1 / y if function == "reciprocal" else sympy.log(y))
    with pytest.raises(cd.DerivationError, match=r"in this scene 'bob.position.y' is 0 at all"):
        cd.derive(scene).function("outputs")
