"""Equilibria against closed forms, and what is said where there are none."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import cardan as cd
from mechanisms.closed import CLOSED
from spread import some

G = 9.81


def pendulum() -> cd.Scene:
    """A rod of 1 kg and 1 m, with a torque."""
    scene = cd.Scene("pendulum", gravity=(0, 0, -G))
    rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5), inertia=cd.inertia.rod(1.0, 1.0, axis="z"))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod, q0=0.3)
    scene.force("motor", cd.JointForce("pivot", scene.input("torque")))
    return scene


@pytest.fixture(scope="module")
def rod() -> cd.CompiledModel:
    return cd.compile(pendulum())


def test_pendulum_hangs_and_stands(rod: cd.CompiledModel) -> None:
    hanging = rod.equilibrium()
    assert hanging["pivot"] == pytest.approx(0, abs=1e-12)
    assert hanging.stable is True
    upright = rod.equilibrium(q={"pivot": 3.0})
    assert upright["pivot"] == pytest.approx(np.pi, abs=1e-12)
    assert upright.stable is False
    assert upright.n_negative == 1
    # downhill, even from the top itself
    for start in (3.0, np.pi):
        low = rod.equilibrium(q={"pivot": start}, stable=True)
        assert np.sin(low["pivot"] / 2) == pytest.approx(0, abs=1e-9)
        assert low.stable is True


def test_torque_that_holds(rod: cd.CompiledModel) -> None:
    found = rod.equilibrium(inputs={"torque": 2.0})
    assert found["pivot"] == pytest.approx(np.arcsin(2.0 / (0.5 * G)), rel=1e-12)
    held = rod.equilibrium(locked={"pivot": 0.7})
    assert held["pivot"] == 0.7
    assert held.holding_forces["pivot"] == pytest.approx(0.5 * G * np.sin(0.7), rel=1e-12)
    # the wrench of the joint has the holding torque, and carries the weight
    wrench = held.reaction("pivot")
    assert wrench[1] == pytest.approx(held.holding_forces["pivot"], rel=1e-12)
    assert np.linalg.norm(wrench[3:]) == pytest.approx(G, rel=1e-12)


def test_too_much_torque_is_told(rod: cd.CompiledModel) -> None:
    with pytest.warns(cd.SolveWarning, match=r"no equilibrium.*'pivot'"):
        found = rod.equilibrium(inputs={"torque": 20.0})
    assert not found.converged
    with pytest.raises(cd.SolveError, match="no equilibrium"):
        rod.equilibrium(inputs={"torque": 20.0}, check=True)


def test_a_run_starts_there_and_stays(rod: cd.CompiledModel) -> None:
    found = rod.equilibrium(inputs={"torque": 2.0})
    motion = found.model.simulate(5.0, x0=found, inputs=found.inputs, rtol=1e-10)
    np.testing.assert_allclose(motion["pivot"], found["pivot"], atol=1e-8)


def test_springs_in_a_row() -> None:
    scene = cd.Scene("row", gravity=(0, 0, -G))
    last: Any = scene.ground
    masses, stiffness = (1.0, 2.0, 3.0), (100.0, 200.0, 50.0)
    for k, (m, c) in enumerate(zip(masses, stiffness, strict=True)):
        body = scene.body(f"b{k}", mass=m, inertia=(1, 1, 1))
        scene.joint(f"s{k}", cd.Prismatic("z"), last, body)
        scene.force(f"f{k}", cd.JointForce(f"s{k}", -c * scene.q(f"s{k}")))
        last = body
    found = cd.compile(scene).equilibrium()
    weights = np.cumsum(masses[::-1])[::-1] * G
    np.testing.assert_allclose(found.q, -weights / stiffness, rtol=1e-13)
    assert found.iterations <= 2


def hanging(n: int, span: float = 0.6) -> cd.Scene:
    """A chain of n rods, 1 m and 1 kg in all, between two points of equal height."""
    scene, last = cd.Scene("chain", gravity=(0, 0, -G)), None
    length = 1.0 / n
    for k in range(n):
        rod = cd.inertia.rod(1.0 / n, length, axis="x")
        link = scene.body(f"link{k}", mass=1.0 / n, com=(length / 2, 0, 0), inertia=rod)
        parent = scene.ground if last is None else last.at(length, 0, 0)
        # a start that sags
        turn = 0.9 if k == 0 else -1.8 / n
        scene.joint(f"j{k}", cd.Revolute("y"), parent, link, q0=turn)
        last = link
    assert last is not None
    scene.joint("end", cd.Revolute("y"), scene.ground.at(span, 0, 0), last.at(length, 0, 0))
    return scene


def slopes(n: int) -> np.ndarray:
    # from so far away a search may end in any equilibrium
    found = cd.compile(hanging(n)).equilibrium(stable=True)
    assert found.stable is True
    axes = np.array([found.pose(f"link{k}")[:3, 0] for k in range(n)])
    return -axes[:, 2] / axes[:, 0]


def sag(n: int) -> float:
    slope = slopes(n)
    return float(np.sum(np.sin(np.arctan(slope))[: n // 2]) / n)


@pytest.mark.slow
def test_chain_and_catenary() -> None:
    slope = slopes(10)
    # the vertical force falls by the weight of a link from link to link, the other one is constant
    np.testing.assert_allclose(np.diff(slope), np.diff(slope).mean(), rtol=1e-10)
    assert np.sum(np.cos(np.arctan(slope))) / 10 == pytest.approx(0.6, abs=1e-12)
    # a catenary of length 1: 2 a sinh(span / 2 a) = 1, sag a (cosh(span / 2 a) - 1)
    from scipy.optimize import brentq

    a = brentq(lambda a: 2 * a * np.sinh(0.3 / a) - 1, 0.05, 1.0, xtol=1e-15)
    limit = a * (np.cosh(0.3 / a) - 1)
    errors = [sag(n) - limit for n in (4, 8, 16)]
    orders = np.log2(np.abs(np.divide(errors[:-1], errors[1:])))
    print(f"errors {errors}, orders {orders}")
    np.testing.assert_allclose(orders, 2.0, atol=0.1)


@pytest.mark.parametrize(("damping", "stable"), [(0.3, True), (0.0, True), (-0.3, False)])
def test_dampers_may_feed(damping: float, stable: bool) -> None:
    """x'' = -d x' - 2 x: growth -d / 2, though the spring holds it."""
    scene = cd.Scene("fed", gravity=(0, 0, 0))
    body = scene.body("body", mass=1.0, inertia=(1, 1, 1))
    scene.joint("x", cd.Prismatic("x"), scene.ground, body)
    force = -damping * scene.u("x") - 2 * scene.q("x")
    scene.force("force", cd.JointForce("x", force))
    rest = cd.compile(scene).equilibrium()
    assert rest.stable is stable
    assert rest.n_negative == 0


@pytest.mark.parametrize(
    "name", some(["four_bar", "slider_crank", "parallelogram", "bricard", "delta"], 2)
)
def test_circuits_rest(name: str) -> None:
    model = cd.compile(CLOSED[name].build())
    found = model.equilibrium()
    size = np.abs(model.bias(found.q, found.u)).max() + 1.0
    np.testing.assert_allclose(model.constraints(found.q), 0, atol=1e-12)
    # accelerations come from another function than the balance
    assert np.abs(model.forward_dynamics(found.q, found.u)).max() < 1e-8 * size
    # multipliers where they are unique; forces of constraint always
    jacobian = model.constraint_jacobian(found.q)
    forces = jacobian.T @ model.multipliers(found.q, found.u)
    np.testing.assert_allclose(jacobian.T @ found.lam, forces, atol=1e-8 * size)


def governor(speed: float) -> cd.CompiledModel:
    """A point mass on an arm of 0.5 m that a vertical shaft turns."""
    scene = cd.Scene("governor", gravity=(0, 0, -G))
    shaft = scene.body("shaft", mass=1.0, inertia=(0.1, 0.1, 0.1))
    arm = scene.body("arm", mass=1.0, com=(0, 0, -0.5))
    scene.joint("spin", cd.Revolute("z"), scene.ground, shaft, u0=speed)
    scene.joint("arm", cd.Revolute("y"), shaft, arm)
    return cd.compile(scene)


def test_steady_motion() -> None:
    model, speed = governor(6.0), 6.0
    found = model.equilibrium(q={"arm": 1.0}, u={"spin": speed})
    assert np.cos(found["arm"]) == pytest.approx(G / (speed**2 * 0.5), rel=1e-12)
    assert found.stable is True
    assert found["spin.u"] == speed
    assert "steady motion" in found.message
    # below g / l the mass hangs, above that it is thrown out
    for speed, stable in ((4.3, True), (4.6, False)):
        assert model.equilibrium(q={"arm": 0.0}, u={"spin": speed}).stable is stable


def test_speeds_that_are_no_steady_motion() -> None:
    model = cd.compile(CLOSED["four_bar"].build())
    with pytest.warns(cd.SolveWarning, match="no steady motion with these speeds"):
        found = model.equilibrium(u={"A": 1.0})
    assert not found.converged


def test_weight_that_does_not_turn_along_is_told() -> None:
    scene = cd.Scene("wheel", gravity=(0, 0, -G))
    wheel = scene.body("wheel", mass=1.0, com=(0, 0, -0.1), inertia=(0.1, 0.1, 0.1))
    scene.joint("axle", cd.Revolute("y"), scene.ground, wheel)
    model = cd.compile(scene)
    # nothing changes the speed where the weight hangs below the axle: for an instant
    with pytest.warns(cd.SolveWarning, match="forces do not turn along"):
        assert not model.equilibrium(u={"axle": 3.0}).converged
    balanced = model.equilibrium(u={"axle": 3.0}, parameters={"wheel.com.z": 0.0})
    assert balanced.converged


def test_what_nothing_holds_is_named() -> None:
    scene = cd.Scene("trolley", gravity=(0, 0, -G))
    cart = scene.body("cart", mass=1.0)
    bob = scene.body("bob", mass=1.0, com=(0, 0, -1.0))
    scene.joint("rail", cd.Prismatic("x"), scene.ground, cart)
    scene.joint("rope", cd.Revolute("y"), cart, bob, q0=0.2)
    scene.force("wind", cd.Force(cart, (scene.parameter("wind", 0.0), 0, 0)))
    model = cd.compile(scene)
    level = model.equilibrium()
    assert level.free_motions == ("'rail'",)
    assert level.stable is None
    assert level["rope"] == pytest.approx(0, abs=1e-12)
    with pytest.warns(cd.SolveWarning, match=r"nothing holds 'rail'.*rigid-body mode.*locked="):
        model.equilibrium(parameters={"wind": 1.0})
    held = model.equilibrium(parameters={"wind": 1.0}, locked={"rail": 0.5})
    assert held.holding_forces["rail"] == pytest.approx(-1.0, rel=1e-12)
    assert held.model.parameters["wind"] == 1.0


def test_internal_states_come_to_rest() -> None:
    scene = cd.Scene("arm", gravity=(0, 0, -G))
    rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    angle, rate = scene.q("pivot"), scene.u("pivot")
    control = cd.Controller.pid("pivot", angle, rate, target=0.4, kp=20.0, ki=5.0, kd=2.0)
    scene.force("pid", control)
    found = cd.compile(scene).equilibrium()
    assert found["pivot"] == pytest.approx(0.4, abs=1e-12)
    # the integral carries the weight
    assert 5.0 * found["pid.integral"] == pytest.approx(0.5 * G * np.sin(0.4), rel=1e-10)
    assert found.stable is True


def test_prescribed_motion(crank: cd.CompiledModel) -> None:
    found = crank.equilibrium(q={"hinge": -0.3}, inputs={"angle": 0.5})
    # the wheel is turned, the rod hangs all the same
    assert found["hinge"] == pytest.approx(-0.5, abs=1e-12)


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_internal_states_come_to_rest_on_the_way_down(coordinates: str) -> None:
    """They crept away from rest: their rates fall as they rise, forces rise with positions."""
    scene = pendulum()
    scene.force("spring", cd.JointSpring("pivot", stiffness=2.0))
    rod = scene.bodies["rod"]
    scene.force("strut", cd.Maxwell(scene.ground.at(0.2, 0, -2), rod.at(0, 0, -1), 300.0, 10.0))
    found = cd.compile(scene, coordinates=coordinates).equilibrium(stable=True, q={"pivot": 2.0})
    assert found.converged
    # nothing is left of the strut
    assert found["strut.force"] == pytest.approx(0.0, abs=1e-6)
    assert found["pivot"] == pytest.approx(0.0, abs=1e-8)


@pytest.mark.parametrize(
    ("call", "kind", "said"),
    [
        (lambda m: m.equilibrium(q={"pivit": 1}), cd.ModelError, "pivot"),
        (lambda m: m.equilibrium(locked={"pivit": 1}), cd.ModelError, "Did you mean 'pivot'"),
        (lambda m: m.equilibrium(locked=["pivot"]), cd.ModelError, "with the values they keep"),
        (
            lambda m: m.equilibrium(locked={"pivot": np.nan}),
            cd.SolveError,
            "must be one finite number",
        ),
        (lambda m: m.equilibrium(inputs={"torqe": 1}), cd.CardanError, "torque"),
        (lambda m: m.equilibrium(inputs={"torque": np.inf}), cd.SolveError, "finite"),
        (lambda m: m.equilibrium(parameters={"rod.mas": 1}), cd.ModelError, "rod.mass"),
        (lambda m: m.equilibrium(u={"pivit": 1}), cd.ModelError, "pivot"),
        (lambda m: m.equilibrium(t=np.nan), cd.SolveError, "finite"),
        (lambda m: m.equilibrium()["pivit"], cd.ModelError, "Did you mean 'pivot'"),
    ],
)
def test_nonsense_is_refused(
    rod: cd.CompiledModel, call: Callable[[Any], Any], kind: type[Exception], said: str
) -> None:
    with pytest.raises(kind, match=said):
        call(rod)
