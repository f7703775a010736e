"""Stiff mechanisms: what implicit methods save, on trees, loops, contacts and quaternions."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.errors import ModelError
from cardan.schema.integrators import INTEGRATORS
from laws import circuits

IMPLICIT = ("Radau", "Rosenbrock")
METHODS = pytest.mark.parametrize("method", IMPLICIT)
ANGLE, GRAVITY = 1.0, 9.81


@pytest.fixture(scope="module")
def spring() -> cd.CompiledModel:
    """A bob on a spring of natural length 1 m: a pendulum with a rod that is very stiff."""
    scene = cd.Scene("spring_pendulum", gravity=(0, 0, -GRAVITY))
    k = scene.parameter("k", 1e9, unit="N/m")
    hub = scene.body("hub", mass=1e-3, inertia=(1e-3, 1e-3, 1e-3))
    bob = scene.body("bob", mass=1.0)
    scene.joint("swing", cd.Revolute("y"), scene.ground, hub)
    scene.joint("stretch", cd.Prismatic("z"), hub.at(0, 0, -1), bob)
    scene.force("spring", cd.JointForce("stretch", -k * scene.q("stretch")))
    return cd.compile(scene)


def slow(k: float) -> dict[str, float]:
    """At rest where nothing vibrates: the spring carries the weight along it."""
    return {"swing": ANGLE, "stretch": -GRAVITY * np.cos(ANGLE) / k}


def test_implicit_steps_are_a_hundredth(spring: cd.CompiledModel) -> None:
    tolerance = {"rtol": 1e-5, "atol": 1e-8}
    exact = spring.simulate([0, 10.0], q=slow(1e9), method="Radau", rtol=1e-11, atol=1e-12)
    explicit = spring.simulate([0, 10.0], q=slow(1e9), method="DOP853", **tolerance)
    for method in IMPLICIT:
        motion = spring.simulate([0, 10.0], q=slow(1e9), method=method, **tolerance)
        assert motion.statistics["steps"] <= explicit.statistics["steps"] / 100
        assert motion.statistics["evaluations"] <= explicit.statistics["evaluations"] / 100
        # errors of a hundred steps
        assert abs(motion["swing"][-1] - exact["swing"][-1]) < 1e-3


@METHODS
def test_ten_times_stiffer_costs_nothing(spring: cd.CompiledModel, method: str) -> None:
    hard = spring.with_parameters(k=1e10)
    options: dict[str, Any] = {"method": method, "rtol": 1e-7, "atol": 1e-10}
    soft = spring.simulate(10.0, q=slow(1e9), **options)
    motion = hard.simulate(10.0, q=slow(1e10), **options)
    assert motion.success
    assert motion.statistics["steps"] <= 1.2 * soft.statistics["steps"]
    # the force of the spring: -k q = m (g cos + u^2)
    swing, rate = motion["swing"], motion["swing.u"]
    expected = -(GRAVITY * np.cos(swing) + rate**2) / 1e10
    np.testing.assert_allclose(motion["stretch"], expected, rtol=0, atol=1e-12)


def test_stiffness_is_measured(spring: cd.CompiledModel) -> None:
    start = slow(1e9)
    x = spring.initial(q=start)
    found = spring.stiffness(x)
    exact = np.abs(np.linalg.eigvals(spring.rhs_jacobian(0.0, x)[0])).max()
    assert found.fastest == pytest.approx(exact, rel=1e-3)
    # a pendulum of 1 m: some radians per second
    assert 1 < found.present < 10
    assert found.implicit_pays(10.0, 1e-5)
    assert "stability asks 10541 steps" in str(found)
    # where the spring vibrates its steps must be followed in any case
    wild = spring.stiffness(spring.initial(q={**start, "stretch": 1e-3}))
    assert wild.present == pytest.approx(exact, rel=1e-2)
    assert not wild.implicit_pays(10.0, 1e-5)
    # and soft springs are none of their business
    assert not spring.with_parameters(k=100.0).stiffness(x).implicit_pays(10.0, 1e-5)


def test_auto_sees_vibrations_that_rest(spring: cd.CompiledModel) -> None:
    motion = spring.simulate([0, 10.0], q=slow(1e9), rtol=1e-5)
    assert motion.statistics["steps"] < 300
    assert motion.statistics["factorizations"] > 0
    assert "stability limited the steps of DOP853" in str(motion)
    # a spring that vibrates is followed by explicit steps, as it takes the fewest
    excited = spring.with_parameters(k=1e7).simulate([0, 2.0], q={"swing": ANGLE}, rtol=1e-5)
    assert excited.statistics["steps"] > 1000
    assert excited.statistics["factorizations"] == 0


def test_nothing_moves() -> None:
    scene = cd.Scene("idle", gravity=(0, 0, 0))
    scene.joint("slide", cd.Prismatic("x"), scene.ground, scene.body("cart", mass=1.0))
    model = cd.compile(scene)
    found = model.stiffness(np.zeros(2))
    assert found.fastest == found.present == 0
    assert not found.implicit_pays(1e9, 1e-6)
    for method in IMPLICIT:
        motion = model.simulate(5.0, u={"slide": 2.0}, method=method)
        assert motion["slide"][-1] == pytest.approx(10.0, rel=1e-12)


def slope(steps: Any, errors: Any) -> float:
    return float(np.polyfit(np.log(steps), np.log(errors), 1)[0])


@METHODS
@pytest.mark.parametrize("treatment", ["multipliers", "elimination"])
def test_order_with_circuits(method: str, treatment: str) -> None:
    model = circuits.compiled("four_bar", None, treatment)
    q, u = circuits.start(model, "four_bar", 0.3)
    start = np.concatenate([q, u])
    end = model.simulate([0, 0.16], x0=start, rtol=1e-13, atol=1e-13).x[-1]
    steps, errors = (0.008, 0.004, 0.002), []
    for h in steps:
        options = {"step": h, "max_step": h, "rtol": 0, "atol": 1e9}
        motion = model.simulate([0, 0.16], x0=start, method=method, **options)
        assert motion.statistics["steps"] == round(0.16 / h)
        errors.append(np.abs(motion.x[-1] - end).max())
    assert slope(steps, errors) == pytest.approx(5, abs=0.15)


@METHODS
def test_turning_body(method: str) -> None:
    scene = cd.Scene("body", gravity=(0, 0, 0))
    brick = scene.body("brick", mass=1.0, inertia=(1.0, 2.0, 3.0))
    scene.joint("base", cd.Free(), scene.ground, brick)
    model = cd.compile(scene)
    spin = {"base": [0.1, 3.0, 0.1, 1.0, 0.0, 0.0]}
    exact = model.simulate([0, 5.0], u=spin, rtol=1e-13, atol=1e-13).x[-1]
    steps, errors = (0.04, 0.02, 0.01), []
    for h in steps:
        options = {"step": h, "max_step": h, "rtol": 0, "atol": 1e9}
        motion = model.simulate([0, 5.0], u=spin, method=method, **options)
        errors.append(np.abs(motion.x[-1] - exact).max())
    assert slope(steps, errors) == pytest.approx(5, abs=0.4)


@METHODS
def test_contact_that_is_hard(method: str) -> None:
    # a ball let fall on a plane comes back from where Hunt and Crossley's law lets it
    scene = cd.Scene("ball", gravity=(0, 0, -GRAVITY))
    ball = scene.body("ball", mass=1.0)
    scene.joint("fall", cd.Prismatic("z"), scene.ground, ball)
    scene.force("floor", cd.Contact(ball, scene.ground, radius=0.1, stiffness=1e8, damping=0.3))
    model = cd.compile(scene)
    options: dict[str, Any] = {"q": {"fall": 1.1}, "rtol": 1e-9, "atol": 1e-12}
    exact = model.simulate([0, 0.6, 0.8], method="DOP853", **options)
    motion = model.simulate([0, 0.6, 0.8], method=method, **options)
    np.testing.assert_allclose(motion.x, exact.x, rtol=0, atol=2e-6)


@METHODS
@pytest.mark.parametrize("rtol", [1e-4, 1e-7, 1e-10])
def test_events_are_found(method: str, rtol: float) -> None:
    scene = cd.Scene("oscillator", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("cart", mass=1.0))
    scene.force("spring", cd.JointForce("x", -scene.q("x")))
    model = cd.compile(scene)
    options: dict[str, Any] = {"q": {"x": 1.0}, "method": method, "rtol": rtol, "atol": rtol}
    motion = model.simulate(6.0, events={"half": (("x", 0.5), "mark")}, **options)
    times = [event.t for event in motion.events]
    np.testing.assert_allclose(times, [np.pi / 3, 5 * np.pi / 3], rtol=0, atol=10 * rtol)


@METHODS
def test_internal_states_and_dry_friction(method: str) -> None:
    scene = cd.Scene("slider", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("cart", mass=1.0))
    # a motor that follows within 0.1 ms, on a spring; friction holds where it can
    behind = 3 * sp.sin(2 * cd.t) - 4 * scene.q("x")
    scene.force("motor", cd.Actuator("x", command=behind, lag=1e-4))
    scene.force("rub", cd.Friction("x", 0.8, static=1.0, against=1.0))
    model = cd.compile(scene)
    times, options = np.linspace(0, 5, 26), {"rtol": 1e-8, "atol": 1e-10}
    exact = model.simulate(times, method="DOP853", rtol=1e-11, atol=1e-12)
    motion = model.simulate(times, method=method, **options)
    assert [e.name for e in motion.events] == [e.name for e in exact.events]
    assert len(motion.events) > 3
    np.testing.assert_allclose(motion.x, exact.x, rtol=0, atol=1e-6)
    assert motion.statistics["steps"] < exact.statistics["steps"] / 5


@pytest.mark.parametrize("method", IMPLICIT)
def test_a_model_without_the_jacobian_says_so(method: str) -> None:
    scene = cd.Scene("one", gravity=(0, 0, -GRAVITY))
    scene.joint("slide", cd.Prismatic("x"), scene.ground, scene.body("cart", mass=1.0))
    functions = ["rhs", "power", "energy"]
    model = cd.compile(scene, functions=functions)
    with pytest.raises(ModelError, match=r"'rhs_jacobian'.*lacks.*functions="):
        model.simulate(1.0, method=method)
    assert INTEGRATORS[method].needs == ("rhs_jacobian",)


def test_a_pickled_model_finds_it_again(spring: cd.CompiledModel) -> None:
    spring.prepare("rhs_jacobian")
    other = pickle.loads(pickle.dumps(spring))
    options: dict[str, Any] = {"q": slow(1e9), "method": "Rosenbrock"}
    ours, theirs = (model.simulate([0, 1.0], **options) for model in (spring, other))
    np.testing.assert_array_equal(ours.x, theirs.x)
