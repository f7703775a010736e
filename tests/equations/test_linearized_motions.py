"""Linear models about steady motions, along others, with controllers and prescribed motions."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

import cardan as cd
from mechanisms.closed import CLOSED

TOP = {"m": 1.3, "g": 9.81, "l": 0.2, "I1": 0.08, "I3": 0.02}


def top() -> cd.Scene:
    """A symmetric top on a ball joint, upright at first."""
    scene = cd.Scene("top", gravity=(0, 0, -sp.Symbol("g")))
    p = {name: scene.parameter(name, value) for name, value in TOP.items()}
    # I1 and I3 belong to the tip
    across = p["I1"] - p["m"] * p["l"] ** 2
    body = scene.body("top", mass=p["m"], com=(0, 0, p["l"]), inertia=(across, across, p["I3"]))
    scene.joint("tip", cd.Spherical(), scene.ground, body)
    return scene


@pytest.mark.parametrize("route", ["from_start", "differentiated"])
def test_a_sleeping_top(route: str) -> None:
    spin = sp.Symbol("Omega")
    found = cd.derive(top()).linearize(u={"tip.z": spin}, route=route)
    assert found.needed == {}
    m, g, ell, I1, I3 = (sp.Symbol(name) for name in ("m", "g", "l", "I1", "I3"))
    # in axes that spin with the top
    second = found.second_order(["along tip.u.x", "along tip.u.y"])
    assert sp.simplify(second.M - I1 * sp.eye(2)) == sp.zeros(2)
    turning = (I3 - 2 * I1) * spin * sp.Matrix([[0, 1], [-1, 0]])
    assert sp.simplify(second.gyroscopic - turning) == sp.zeros(2)
    stiff = ((I3 - I1) * spin**2 - m * g * ell) * sp.eye(2)
    assert sp.simplify(second.conservative - stiff) == sp.zeros(2)
    assert second.dissipative == second.circulatory == sp.zeros(2)
    # seen from the ground: stable where I3² spin² > 4 I1 m g l
    limit = np.sqrt(4 * TOP["I1"] * TOP["m"] * TOP["g"] * TOP["l"]) / TOP["I3"]
    growth = np.linalg.eigvals(found.at(Omega=[0.99 * limit, 1.01 * limit])["A"]).real.max(axis=-1)
    assert growth[0] > 0.1
    assert growth[1] < 1e-6


def test_the_two_forms_have_the_same_eigenvalues() -> None:
    # turned about an axis that is none of the body, the ball keeps no steady motion: it is held
    found = cd.derive(top()).linearize(q={"tip": (0.8, 0, 0.6, 0)}, u={"tip": (0.4, 0.1, 3.0)})
    assert set(found.needed) == {"tip.u.x", "tip.u.y"}
    numbers = found.second_order().at()
    M, C, K = (numbers[name] for name in ("M", "damping", "K"))
    zero, one = np.zeros((3, 3)), np.eye(3)
    other = np.block([[zero, one], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    ours = np.poly(found.at()["A"])
    np.testing.assert_allclose(ours, np.poly(other), atol=1e-10 * np.abs(ours).max())


def test_states_of_a_controller_are_states() -> None:
    m, kp, ki, kd = 2.0, 8.0, 3.0, 5.0
    scene = cd.Scene("analog", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=m))
    wanted = scene.input("wanted")
    place, speed = scene.q("x"), scene.u("x")
    law = cd.Controller.pid("x", place, speed, target=wanted, kp=kp, ki=ki, kd=kd)
    scene.force("pid", law)
    scene.output("sum", scene.state("pid.integral"))
    found = cd.derive(scene).linearize(outputs=["sum", "x", "pid.integral"])
    assert found.states == ("x", "x.u", "pid.integral")
    numbers = found.at()
    A = [[0, 1, 0], [-kp / m, -kd / m, ki / m], [-1, 0, 0]]
    np.testing.assert_allclose(numbers["A"], A, atol=1e-15)
    np.testing.assert_allclose(numbers["B"], [[0], [kp / m], [1]], atol=1e-15)
    np.testing.assert_allclose(numbers["C"], [[0, 0, 1], [1, 0, 0], [0, 0, 1]], atol=1e-15)


def swing() -> cd.Scene:
    """A damped pendulum whose hook goes up and down."""
    scene = cd.Scene("swing", gravity=(0, 0, -9.81))
    hook, bob = scene.body("hook", mass=1.0), scene.body("bob", mass=1.0, com=(0, 0, -0.5))
    lift = 0.1 * sp.cos(7 * cd.t)
    scene.joint("lift", cd.Prismatic("z"), scene.ground, hook, prescribed=lift)
    scene.joint("rope", cd.Revolute("y"), hook, bob)
    scene.force("air", cd.JointForce("rope", -0.05 * scene.u("rope")))
    return scene


def test_floquet_multipliers_of_a_lifted_pendulum() -> None:
    period = 2 * np.pi / 7
    found = cd.derive(swing()).linearize().along(np.linspace(0, period, 5))

    def rates(t: float, x: np.ndarray) -> np.ndarray:
        stiff = (9.81 - 4.9 * np.cos(7 * t)) / 0.5
        return (np.array([[0, 1], [-stiff, -0.2]]) @ x.reshape(2, 2)).ravel()

    flow = solve_ivp(rates, (0, period), np.eye(2).ravel(), rtol=1e-12, atol=1e-12).y[:, -1]
    np.testing.assert_allclose(found.transition()[-1], flow.reshape(2, 2), atol=1e-9)
    # Liouville: their product is what damping takes
    product = np.prod(found.multipliers)
    np.testing.assert_allclose(product, np.exp(-0.2 * period), rtol=1e-9)
    held = cd.derive(swing()).linearize(t=0.0)
    assert "t" not in {s.name for s in held.K.free_symbols}


def test_a_motion_given_in_time_says_what_it_takes() -> None:
    scene = cd.Scene("arm", gravity=(0, 0, 0))
    m, ell = scene.parameter("m", 2.0), scene.parameter("l", 0.5)
    scene.joint("hub", cd.Revolute("z"), scene.ground, scene.body("tip", mass=m, com=(ell, 0, 0)))
    omega = sp.Symbol("omega")
    found = cd.derive(scene).linearize(q={"hub": sp.sin(omega * cd.t)}, values={"omega": 3.0})
    expected = -m * ell**2 * omega**2 * sp.sin(omega * cd.t)
    assert sp.simplify(found.needed["hub.u"] - expected) == 0
    assert "it takes" in str(found)


def test_small_motions_of_a_linkage_along_its_motion() -> None:
    scene = CLOSED["four_bar"].build()
    equations = cd.derive(scene)
    model = cd.compile(equations)
    start = model.assemble({}).q
    run = {"rtol": 1e-11, "atol": 1e-12}
    k, n = equations.coordinates.index("B"), equations.speeds.index("B.u")

    def end(angle: float, speed: float) -> np.ndarray:
        motion = model.simulate(0.15, q={"B": angle}, u={"B": speed}, **run)
        return np.array([motion.q[-1, k], motion.u[-1, n]])

    motion = model.simulate(0.15, q={"B": start[k]}, u={"B": 1.0}, **run)
    found = equations.linearize_along(motion, independent=["B"])
    assert found.A.shape == (len(motion.t), 2, 2)
    h, grown = 1e-5, found.transition()[-1]
    by_angle = (end(start[k] + h, 1.0) - end(start[k] - h, 1.0)) / (2 * h)
    by_speed = (end(start[k], 1.0 + h) - end(start[k], 1.0 - h)) / (2 * h)
    np.testing.assert_allclose(grown, np.stack([by_angle, by_speed], 1), rtol=1e-5, atol=1e-5)
    with pytest.raises(cd.DerivationError, match="the motion has 3 coordinates"):
        cd.derive(swing()).linearize_along(motion)


def test_assembled_positions_follow_the_parameters() -> None:
    equations = cd.derive(CLOSED["slider_crank"].build())
    q = {equations.coordinates[0]: 0.6}
    # both about the motion that starts there by itself
    found = equations.linearize(q=q, udot="free", independent=[equations.coordinates[1]])
    name = next(p.name for p in equations.system.parameters if p.unit == "m" and p.value > 0.1)
    value = next(p.value for p in equations.system.parameters if p.name == name)
    numbers = found.at({name: 1.02 * value})["A"]
    other = cd.compile(equations).with_parameters({name: 1.02 * value})
    place = other.assemble(q).q
    expected = other.linearize(q=dict(zip(equations.coordinates, place.tolist(), strict=True)))
    assert found.states == expected.states
    np.testing.assert_allclose(numbers, expected.A, atol=1e-9 * np.abs(expected.A).max())
