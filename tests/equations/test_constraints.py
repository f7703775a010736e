"""Constraints that users write, their powers, chosen speeds, massless bodies, derivatives."""

from __future__ import annotations

import dataclasses
from itertools import product

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.errors import DerivationError, ModelError
from mechanisms.closed import CLOSED, four_bar
from spread import some


def pendulum_in_coordinates() -> cd.Scene:
    """A point mass on two slides, held on a circle by a relation."""
    scene = cd.Scene("relation", gravity=(0, -9.81, 0))
    slider = scene.body("slider")
    bob = scene.body("bob", mass=2.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, slider)
    scene.joint("y", cd.Prismatic("y"), slider, bob)
    x, y = scene.q("x"), scene.q("y")
    scene.constraint("rod", (x**2 + y**2 - 1) / 2, unit="m^2")
    return scene


def test_a_relation_makes_a_pendulum() -> None:
    """The angle of a pendulum of length 1: phi'' = -g sin phi, tension m (g cos phi + phi'^2)."""
    model = cd.compile(pendulum_in_coordinates())
    phi, rate = 0.4, 1.3
    q = [np.sin(phi), -np.cos(phi)]
    u = [rate * np.cos(phi), rate * np.sin(phi)]
    tangent, inward = np.array([np.cos(phi), np.sin(phi)]), -np.array(q)
    udot = model.forward_dynamics(q, u)
    np.testing.assert_allclose(udot @ tangent, -9.81 * np.sin(phi), rtol=1e-13)
    np.testing.assert_allclose(udot @ inward, rate**2, rtol=1e-13)
    tension = 2.0 * (9.81 * np.cos(phi) + rate**2)
    np.testing.assert_allclose(model.multipliers(q, u), [-tension], rtol=1e-13)
    assert model.manifest["multipliers"][0]["name"] == "rod"


def test_an_input_in_a_relation_brings_its_rates() -> None:
    """A coordinate that follows an input moves as the same function of time would have it."""
    scene = pendulum_in_coordinates()
    scene.constraint("drive", scene.q("x") - scene.input("place"))
    model = cd.compile(scene)
    assert model.inputs == ("place", "place.rate", "place.acceleration")
    q, u, r = [0.6, -0.8], [0.8, 0.6], [0.6, 0.8, 2.0]
    np.testing.assert_allclose(model.constraint_rates(q, u, r=r), 0, atol=1e-15)
    assert model.forward_dynamics(q, u, r=r)[0] == pytest.approx(2.0)


def test_a_rheonomic_relation_does_work() -> None:
    """A bead on a rod that turns as prescribed: what the rod gives is the change of energy."""
    scene = cd.Scene("bead", gravity=(0, 0, 0))
    slider, bead = scene.body("slider"), scene.body("bead", mass=0.7)
    scene.joint("x", cd.Prismatic("x"), scene.ground, slider)
    scene.joint("y", cd.Prismatic("y"), slider, bead)
    angle = 0.9 * cd.t
    across = -scene.q("x") * sympy.sin(angle) + scene.q("y") * sympy.cos(angle)
    scene.constraint("turning", across, unit="m")
    motion = cd.compile(scene).simulate(2.0, q={"x": 1.0}, u={"x": 0.0, "y": 0.9}, rtol=1e-11)
    # r'' = w^2 r from r = 1 at rest
    radius = np.hypot(motion["x"][-1], motion["y"][-1])
    assert radius == pytest.approx(np.cosh(0.9 * 2.0), rel=1e-9)
    kinetic = motion.energy.kinetic
    given = motion.work["turning.motion"][-1]
    assert kinetic[-1] - kinetic[0] == pytest.approx(given, rel=1e-8)


def test_levels_are_found() -> None:
    scene = pendulum_in_coordinates()
    scene.constraint("skate", scene.u("x") * sympy.sin(scene.q("y")) - scene.u("y"))
    levels = [row["level"] for row in cd.compile(scene).manifest["multipliers"]]
    assert levels == ["position", "velocity"]


def test_relations_that_cannot_be() -> None:
    scene = pendulum_in_coordinates()
    scene.constraint("square", scene.u("x") ** 2 - 1)
    with pytest.raises(DerivationError, match="constraint 'square' is not linear in the speeds"):
        cd.compile(scene).constraint_jacobian([0.0, -1.0])
    with pytest.raises(ModelError, match="the name is taken"):
        scene.constraint("rod", 1)
    with pytest.raises(ModelError, match="a joint has this name"):
        scene.constraint("x", 1)
    still = pendulum_in_coordinates()
    still.constraint("still", still.parameter("k", 1.0) - 1)
    with pytest.raises(ModelError, match="constraint 'still' contains no coordinate"):
        cd.derive(still)
    with pytest.raises(ModelError, match="write left side - right side"):
        still.constraint("as equation", sympy.Eq(still.q("x"), 1))
    empty = pendulum_in_coordinates()
    empty.constraint("nothing", sympy.Integer(0))
    with pytest.raises(ModelError, match="constraint 'nothing' is 0 always"):
        cd.derive(empty)


def test_trees_have_no_multipliers() -> None:
    scene = cd.Scene("tree")
    scene.joint("j", cd.Revolute("y"), scene.ground, scene.body("b", mass=1.0, com=(0, 0, 1)))
    with pytest.raises(DerivationError, match="nothing binds the speeds"):
        cd.compile(scene, functions=("multipliers",))
    with pytest.raises(DerivationError, match="is not a way to treat them"):
        cd.derive(scene, constraints="lagrange")


def test_circuits_that_cannot_close_are_announced() -> None:
    scene = four_bar(ground=0.9)
    found = cd.derive(scene).feasibility()
    assert not found.closes
    # 0.9 m between the pivots, 0.55 m of links
    assert found.gaps["C"] == (pytest.approx(0.35, rel=0.15), "m")
    with pytest.warns(cd.SolveWarning, match="loop that 'C' closes stays open: .* 0.3"):
        cd.compile(scene)
    assert cd.derive(four_bar()).feasibility().closes


def test_conditions_that_follow_must_hold_too() -> None:
    """A planar loop whose links do not lie in one plane."""
    scene = four_bar()
    place = scene.ground.at(0.3, 0, 0.05)
    scene.joints["D"] = dataclasses.replace(scene.joints["D"], parent=place)
    found = cd.derive(scene).feasibility()
    assert found.gaps["C"] == (pytest.approx(0.05), "m")


def test_equations_to_read() -> None:
    equations = cd.derive(four_bar())
    g, G = equations.constraints, equations.constraint_jacobian
    q = [equations.symbols["q", k] for k in range(3)]
    assert sympy.simplify(g.jacobian(q) - G) == sympy.zeros(2, 3)
    assert "2 of 5 conditions close it" in str(equations)
    assert r"G(q)^T \lambda" in equations._repr_latex_()


def test_massless_links() -> None:
    """A rod without mass between two sliders: M is singular, the loop is not."""
    scene = cd.Scene("rod", gravity=(0, -9.81, 0))
    left = scene.body("left", mass=1.5)
    right = scene.body("right", mass=0.5)
    rod = scene.body("rod")
    scene.joint("x", cd.Prismatic("x"), scene.ground, left)
    scene.joint("y", cd.Prismatic("y"), scene.ground, right)
    scene.joint("a", cd.Revolute("z"), left, rod)
    scene.joint("b", cd.Revolute("z"), rod.at(1, 0, 0), right)
    model = cd.compile(scene)
    phi = 0.7
    # right slides down the y axis, left along x: x = -cos phi, y = sin phi
    q = model.split(model.initial({"x": -np.cos(phi), "a": phi, "y": np.sin(phi)}))[0]
    udot = model.forward_dynamics(q, np.zeros(model.nu))
    # at rest: (1.5 sin^2 + 0.5 cos^2) phi'' = -0.5 g cos
    wanted = -0.5 * 9.81 * np.cos(phi) / (1.5 * np.sin(phi) ** 2 + 0.5 * np.cos(phi) ** 2)
    assert udot[model.speeds.index("a.u")] == pytest.approx(wanted, rel=1e-12)


@pytest.mark.parametrize("treatment", ["multipliers", "elimination", "null_space"])
@pytest.mark.parametrize("element", ["stop", "lock", "friction"])
def test_massless_links_with_modes(treatment: str, element: str) -> None:
    """A hoop without mass, bound to a rod that falls onto a stop of the hoop, or is held by it."""
    scene = cd.Scene("hoop", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1.0, com=(-0.15, 0, 0), inertia=(0.01, 0.01, 0.01))
    scene.joint("h", cd.Revolute("y"), scene.ground, rod)
    hoop = scene.body("hoop")
    scene.joint("gap", cd.Prismatic("x"), scene.ground, hoop)
    scene.constraint("rope", scene.q("gap") - 0.2 * scene.q("h"), unit="m")
    elements = {
        "stop": lambda: cd.Stop("gap", lower=0.0),
        "lock": lambda: cd.Lock("gap", when=scene.q("gap")),
        "friction": lambda: cd.Friction("gap", coulomb=8.0),
    }
    scene.force("hold", elements[element]())
    start = 0.0 if element == "friction" else 0.05
    model = cd.compile(scene, constraints=treatment)
    motion = model.simulate(0.5, q={"h": start}, rtol=1e-9, max_step=0.01)
    assert motion.success
    assert motion["h"][-1] == pytest.approx(0.0, abs=1e-9)
    # torque of the weight over the arm of the hoop; friction sticks below 8 N
    force = abs(model.multipliers(*model.split(motion.x[-1])[:2], s=motion.s[-1])).max()
    assert force == pytest.approx(9.81 * 0.15 / 0.2, rel=1e-9)
    if start:
        # until then the rod falls alone: J h'' = -m g c cos h
        alone = cd.Scene("alone", gravity=(0, 0, -9.81))
        body = alone.body("rod", mass=1.0, com=(-0.15, 0, 0), inertia=(0.01, 0.01, 0.01))
        alone.joint("h", cd.Revolute("y"), alone.ground, body)
        at = {"down": lambda t, x: x[0]}
        free = cd.compile(alone).simulate(1.0, q={"h": start}, rtol=1e-11, events=at)
        assert motion.events[0].t == pytest.approx(free.events[0].t, abs=1e-8)


@pytest.mark.parametrize("mass", [1e-3, 1e-6, 1e-9, 1e-13])
def test_light_links(mass: float) -> None:
    """Forces of a rope and a stop nearly cancel on a hoop of hardly any mass, and move an arm.

    With sin h = t^2 / 4 the arm has h'' = 1 / (2 cos h) + h'^2 tan h. Accelerations are as good
    as numbers allow, whatever the mass, and so few steps follow them as a heavy hoop would take.
    """
    scene = cd.Scene("light", gravity=(0, 0, -9.81))
    scene.joint("h", cd.Revolute("y"), scene.ground, scene.body("arm", mass=2.0, com=(-0.3, 0, 0)))
    scene.joint("gap", cd.Prismatic("x"), scene.ground, scene.body("hoop", mass=mass))
    scene.constraint("rope", scene.q("gap") + 0.05 * cd.t**2 - 0.2 * sympy.sin(scene.q("h")))
    scene.force("taut", cd.Stop("gap", lower=0.0))
    model = cd.compile(scene)
    for t in (0.3, 0.30001, 0.30002):
        h = np.arcsin(t**2 / 4)
        rate = t / 2 / np.cos(h)
        wanted = 0.5 / np.cos(h) + rate**2 * np.tan(h)
        udot = model.forward_dynamics([h, 0.0], [rate, 0.0], t=t, s=[1.0])
        np.testing.assert_allclose(udot, [wanted, 0.0], atol=1e-12)
    motion = model.simulate(1.0, q={"h": 0.0}, rtol=1e-10)
    assert motion.success
    assert motion["h"][-1] == pytest.approx(np.arcsin(0.25), abs=1e-9)
    assert motion.statistics["steps"] < 50


@pytest.mark.parametrize(
    ("treatment", "function"),
    some(product(("multipliers", "elimination"), ("forward_dynamics", "multipliers")), 3),
)
def test_derivatives(treatment: str, function: str) -> None:
    mechanism = CLOSED["slider_crank"]
    model = cd.compile(mechanism.build(), constraints=treatment)
    names = [j["name"] for j in model.manifest["joints"]]
    state = mechanism.state(0.3, 1.0, names)
    q, u = model.split(model.initial(state.q, state.u))
    call = getattr(model, function)
    by_q, by_u, by_tau = (model.derivative(function, wrt=(w,)) for w in ("q", "u", "tau"))
    step = 1e-6
    for k in range(model.nu):
        e = np.eye(model.nu)[k] * step
        for found, plus, minus in (
            (by_q(q, u), call(q + e, u), call(q - e, u)),
            (by_u(q, u), call(q, u + e), call(q, u - e)),
            (by_tau(q, u), call(q, u, tau=e), call(q, u, tau=-e)),
        ):
            slope = (plus - minus) / (2 * step)
            size = max(1.0, np.abs(slope).max())
            # h^2 of the difference and eps/h of the values
            np.testing.assert_allclose(found[0][:, k], slope, rtol=0, atol=2e-7 * size)


def test_chosen_speeds_of_a_closed_system() -> None:
    mechanism = CLOSED["four_bar"]
    scene = mechanism.build()
    speeds = {"one": scene.u("A") + scene.u("B"), "two": scene.u("B"), "three": 2 * scene.u("D")}
    chosen, plain = cd.compile(scene, speeds=speeds), cd.compile(scene)
    state = mechanism.state(0.3)
    q = [state.q[n] for n in ("A", "B", "D")]
    u = plain.close_velocity(q, [1.0, 0.0, 0.0])[:3]
    own = [u[0] + u[1], u[1], 2 * u[2]]
    a, wanted = chosen.forward_dynamics(q, own), plain.forward_dynamics(q, u)
    np.testing.assert_allclose([a[0] - a[1], a[1], a[2] / 2], wanted, rtol=1e-11)
    np.testing.assert_allclose(chosen.multipliers(q, own), plain.multipliers(q, u), rtol=1e-11)
    q_off = [q[0] + 1e-3, *q[1:]]
    np.testing.assert_allclose(
        chosen.close_position(q_off), plain.close_position(q_off), rtol=0, atol=1e-13
    )


@pytest.mark.parametrize("treatment", some(["closed_form", "multipliers"], 2))
def test_bodies_and_joints_do_not_ask_how_speeds_were_chosen(treatment: str) -> None:
    """Accelerations of frames, reactions and outputs with chosen speeds."""
    scene = four_bar()
    tip = scene.bodies["coupler"].at(0.1, 0.02, 0)
    scene.output("ax", tip.acceleration()[0])
    own = cd.compile(scene, constraints=treatment)
    names = own.speeds
    rates = [scene.u(name.removesuffix(".u")) for name in names]
    angle = scene.q(names[0].removesuffix(".u"))
    chosen = {f"w{k}": 2 * rate + angle * rates[0] for k, rate in enumerate(rates)}
    model = cd.compile(scene, constraints=treatment, speeds=chosen)
    q, u = own.split(own.assemble({"A": 0.5}, u={"A": 2.0}).x if own.nlam else np.array([0.5, 2.0]))
    w = 2 * u + q[0] * u[0]
    udot, wdot = own.forward_dynamics(q, u), model.forward_dynamics(q, w)
    for body in own.bodies:
        wanted = own.acceleration(body, q, u, udot)
        np.testing.assert_allclose(model.acceleration(body, q, w, wdot), wanted, atol=1e-10)
    for joint in own.joints:
        wanted = own.reaction(joint, q, u)
        np.testing.assert_allclose(model.reaction(joint, q, w), wanted, atol=1e-10)
    np.testing.assert_allclose(model.outputs(q, w), own.outputs(q, u), atol=1e-10)


@pytest.mark.filterwarnings("error")
def test_circuits_are_swept_whatever_speeds_are_chosen() -> None:
    """Searches move coordinates along the speeds of the joints."""
    scene = four_bar()
    a, b, d = (scene.u(name) for name in "ABD")
    chosen = {"v": a + b, "w": 2 * b + sympy.sin(scene.q("A")), "z": d}
    with pytest.warns(cd.SolveWarning, match="the speeds are chosen by the user"):
        own, model = cd.compile(scene), cd.compile(scene, speeds=chosen)
    angles = np.linspace(0.5, 1.0, 3)
    one, two = (m.sweep("A", angles) for m in (own, model))
    np.testing.assert_allclose(two["D"], one["D"], atol=1e-9)
