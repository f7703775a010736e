"""Linear models against closed forms, published eigenvalues and finite differences."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm

import cardan as cd
from cardan.analyses.mechanisms.mechanism import Mechanism
from cardan.analyses.systems.saddle_point import split
from mechanisms import ZOO
from mechanisms.closed import CLOSED
from mechanisms.closed_planar import parallelogram_angles
from mechanisms.rolling import COIN, coin
from spread import some

HERE = Path(__file__).parent
G = 9.81
Array = np.ndarray


def trolley() -> cd.Scene:
    """A cart with a pendulum of a point mass, pushed and seen."""
    scene = cd.Scene("trolley", gravity=(0, 0, -G))
    cart = scene.body("cart", mass=2.0)
    bob = scene.body("bob", mass=1.0, com=(0, 0, -0.5))
    scene.joint("rail", cd.Prismatic("x"), scene.ground, cart)
    scene.joint("rope", cd.Revolute("y"), cart, bob)
    scene.force("engine", cd.JointForce("rail", scene.input("push")))
    scene.output("tip", bob.at(0, 0, -0.5).position()[0])
    return scene


@pytest.fixture(scope="module")
def bicycle() -> cd.CompiledModel:
    return cd.compile(cd.load(HERE.parents[1] / "src" / "cardan" / "scenes" / "bicycle.yaml"))


@pytest.fixture(scope="module")
def cart() -> cd.CompiledModel:
    return cd.compile(trolley())


def test_cart_and_pendulum(cart: cd.CompiledModel) -> None:
    found = cart.linearize()
    assert found.states == ("rail", "rope", "rail.u", "rope.u")
    assert found.inputs == ("push",)
    assert found.outputs == ("tip",)
    # swinging with the cart free: g (1 + m / M) / l
    swing = np.sqrt(G * 1.5 / 0.5)
    np.testing.assert_allclose(sorted(found.eigenvalues.imag), [-swing, 0, 0, swing], atol=1e-12)
    assert found.acceleration == 0
    # a positive angle about y swings the bob to -x
    np.testing.assert_allclose(found.M, [[3.0, -0.5], [-0.5, 0.25]], atol=1e-14)
    np.testing.assert_allclose(found.K, [[0, 0], [0, 0.5 * G]], atol=1e-12)
    np.testing.assert_allclose(found.damping, 0, atol=1e-12)
    np.testing.assert_allclose(found.forces, [[1], [0]], atol=1e-12)
    np.testing.assert_allclose(found.C, [[1, -0.5, 0, 0]], atol=1e-14)
    text = repr(found)
    assert "no small motion grows" in text
    assert "rope.u" in text


def test_the_upper_one_is_unstable(cart: cd.CompiledModel) -> None:
    found = cart.linearize(q={"rope": np.pi})
    growth = np.sqrt(G * 1.5 / 0.5)
    assert not found.stable
    np.testing.assert_allclose(found.eigenvalues.real.max(), growth, rtol=1e-12)


def test_chosen_inputs_and_outputs(cart: cd.CompiledModel) -> None:
    found = cart.linearize(inputs=["rope", "push", "rail.u"], outputs=["rope", "rope.u", "tip"])
    # the force along the rail is what the engine makes
    np.testing.assert_allclose(found.B[:, 1], found.B[:, 2], atol=1e-14)
    mass = np.array([[3.0, -0.5], [-0.5, 0.25]])
    np.testing.assert_allclose(found.B[2:, 0], np.linalg.solve(mass, [0, 1]), atol=1e-12)
    np.testing.assert_allclose(found.C[:2], [[0, 1, 0, 0], [0, 0, 0, 1]])
    assert found.D.shape == (3, 3)


def test_frequency_response(cart: cd.CompiledModel) -> None:
    found, omega = cart.linearize(), np.array([0.5, 2.0, 9.0])
    # X / F of the tip: the bob sees the push through the rope
    swing = G * 1.5 / 0.5
    expected = (G / 0.5) / 2.0 / (-(omega**2) * (swing - omega**2))
    response = found.frequency_response(omega)
    assert response.shape == (3, 1, 1)
    np.testing.assert_allclose(response[:, 0, 0], expected, rtol=1e-11)


def test_to_control(cart: cd.CompiledModel, monkeypatch: pytest.MonkeyPatch) -> None:
    found = cart.linearize()
    monkeypatch.setitem(sys.modules, "control", None)
    with pytest.raises(ModuleNotFoundError, match=r"pip install 'cardan\[control\]'"):
        found.to_control()
    given: dict[str, Any] = {}

    def system(*matrices: Array, **names: Any) -> dict[str, Any]:
        given.update(names, matrices=matrices)
        return given

    monkeypatch.setitem(sys.modules, "control", SimpleNamespace(StateSpace=system))
    made, names = found.to_control()
    assert made is given
    assert given["states"] == [names[state] for state in found.states]
    assert given["inputs"] == ["push"]
    assert all(a is b for a, b in zip(given["matrices"], (found.A, found.B, found.C, found.D),
                                      strict=True))  # fmt: skip


def test_python_control_agrees(cart: cd.CompiledModel) -> None:
    control = pytest.importorskip("control")
    found, omega = cart.linearize(), np.array([0.5, 2.0, 9.0])
    system, names = found.to_control()
    assert isinstance(system, control.StateSpace)
    assert list(system.state_labels) == [names[state] for state in found.states]
    expected = np.ravel(system(1j * omega))
    np.testing.assert_allclose(found.frequency_response(omega)[:, 0, 0], expected, rtol=1e-12)


def test_four_parts_of_second_order() -> None:
    # a mass on a turntable, with springs, dampers and a force that drives around
    scene = cd.Scene("turntable", gravity=(0, 0, 0))
    table = scene.body("table", mass=1.0, inertia=(0.1, 0.1, 0.1))
    slide, mass = scene.body("slide", mass=0, inertia=(0, 0, 0)), scene.body("mass", mass=2.0)
    scene.joint("spin", cd.Revolute("z"), scene.ground, table, prescribed=3.0 * cd.t)
    scene.joint("x", cd.Prismatic("x"), table, slide)
    scene.joint("y", cd.Prismatic("y"), slide, mass)
    x, y, vx, vy = scene.q("x"), scene.q("y"), scene.u("x"), scene.u("y")
    scene.force("fx", cd.JointForce("x", -100 * x - 0.5 * vx + 7 * y))
    scene.force("fy", cd.JointForce("y", -80 * y - 0.7 * vy - 7 * x))
    model = cd.compile(scene)
    found = model.linearize(model.equilibrium(u={}))
    m, W, skew = 2.0, 3.0, np.array([[0, -1], [1, 0]])
    np.testing.assert_allclose(found.M, m * np.eye(2), atol=1e-13)
    np.testing.assert_allclose(found.dissipative, np.diag([0.5, 0.7]), atol=1e-13)
    np.testing.assert_allclose(found.gyroscopic, 2 * m * W * skew, atol=1e-12)
    np.testing.assert_allclose(found.conservative, np.diag([100, 80]) - m * W**2 * np.eye(2),
                               atol=1e-12)  # fmt: skip
    np.testing.assert_allclose(found.circulatory, 7 * skew, atol=1e-12)
    assert "circulatory" in repr(found.second_order(["y", "x"]))
    # shares of states, and left against right vectors
    np.testing.assert_allclose(found.participation.sum(axis=0), 1, atol=1e-12)
    assert set(found.shape(0)) == set(found.adjoint(0)) == set(found.states)


def test_second_order_of_rolling_is_asked_for(bicycle: cd.CompiledModel) -> None:
    found = bicycle.trim({"rear_contact.lean": 0.0, "rear_hub.u": -15.0}).linear
    for names, said in (
        (["steer"], "'steer' depends on"),
        (["lean"], "Known: rear_contact.x"),
        (["steer", "rear_contact.lean", "rear_contact.yaw"], "depend on each other"),
        (None, "no equations of second order of all"),
    ):
        with pytest.raises(cd.ModelError, match=said):
            found.second_order(names)


# closed systems: the Jacobian of the minimal form, independent of everything that is linearized


@pytest.mark.parametrize(
    "name", some(["four_bar", "slider_crank", "parallelogram", "andrews", "bricard", "delta"], 4)
)
def test_closed_systems_in_motion(name: str) -> None:
    model = cd.compile(CLOSED[name].build())
    # parallelograms lie flat at first, where branches meet
    known = parallelogram_angles(0.8) if name == "parallelogram" else {}
    place = model.assemble({n: a for n, a in known.items() if n in model.coordinates}).q
    m, rng = Mechanism(model), np.random.default_rng(3)
    free = split(m.jacobian(place))[2]
    x = np.concatenate([place, m.columns * (free @ rng.normal(size=free.shape[1]))])
    found = model.linearize(x)
    part = model.partition(place)
    y, h = part.reduce(x), 1e-6
    columns = []
    for k in range(len(y)):
        sides = []
        for sign in (1, -1):
            beside = y.copy()
            beside[k] += sign * h
            sides.append(model.partition(place).rhs(0.0, beside))
        columns.append((sides[0] - sides[1]) / (2 * h))
    expected = np.stack(columns, axis=1)
    assert found.states == (*part.coordinates, *part.speeds)
    np.testing.assert_allclose(found.A, expected, atol=1e-7 * np.abs(expected).max())


def _alike(found: Array, expected: Array, atol: float) -> None:
    """Equal as sets."""
    left = list(expected)
    for value in found:
        nearest = int(np.argmin(np.abs(np.array(left) - value)))
        assert abs(left.pop(nearest) - value) < atol


@pytest.mark.parametrize(
    "name", some(["satellite", "spherical_quaternion", "free_ZYX", "branched"], 4, 1)
)
def test_trees_against_the_flow(name: str) -> None:
    # increments of the flow: difference(q(t), q(t) of a motion beside it), one short step on
    model = cd.compile(ZOO[name].build())
    x = model.random_state(4)
    found = model.linearize(x)
    nu, tau, h = model.nu, 1e-4, 1e-4

    def after(state: Array, sign: int) -> Array:
        end = model.simulate((0, sign * tau), x0=state, method="DOP853", rtol=1e-13, atol=1e-14)
        return end.x[-1]

    ends = {sign: after(x, sign) for sign in (1, -1)}
    columns = []
    for k in range(2 * nu):
        sides = {}
        for sign in (1, -1):
            q, u = model.split(x)
            e = np.eye(2 * nu)[k] * h * sign
            beside = np.concatenate([model.integrate(q, e[:nu]), u + e[nu:]])
            for way, base in ends.items():
                y = after(beside, way)
                step = model.difference(base[: model.nq], y[: model.nq])
                sides[sign, way] = np.concatenate([step, y[model.nq :] - base[model.nq :]])
        slope = {way: (sides[1, way] - sides[-1, way]) / (2 * h) for way in (1, -1)}
        columns.append((slope[1] - slope[-1]) / (2 * tau))
    expected = np.stack(columns, axis=1)
    # two central differences of 1e-4: 1e-8 of third derivatives, and 1e-14 / 1e-8 of the runs
    np.testing.assert_allclose(found.A, expected, atol=3e-5 * np.abs(expected).max())


# steady motions with published stability


def test_sleeping_top() -> None:
    I1, I3, m, length = 0.5, 0.1, 2.0, 0.4
    scene = cd.Scene("top", gravity=(0, 0, -G))
    center = I1 - m * length**2
    top = scene.body("top", mass=m, com=(0, 0, length), inertia=(center, center, I3))
    scene.joint("tip", cd.Spherical(), scene.ground, top)
    model = cd.compile(scene)
    limit = np.sqrt(4 * I1 * m * G * length) / I3
    for factor, stable in ((0.999, False), (1.001, True)):
        assert model.linearize(u={"tip.u.z": factor * limit}).stable is stable
    # both ways to precess: I1 s^2 - I3 w s + m g l = 0 in the ground, less the spin in the body
    w = 2 * limit
    roots = np.roots([I1, -I3 * w, m * G * length])
    found = model.linearize(u={"tip.u.z": w}).eigenvalues
    _alike(found[np.abs(found) > 1e-6], 1j * np.concatenate([roots - w, w - roots]), 1e-8 * w)


def test_rolling_coin() -> None:
    model = cd.compile(coin())
    limit = np.sqrt(COIN["g"] * COIN["r"] / 3)
    print(model.coordinates, model.speeds)
    for factor, stable in ((0.99, False), (1.01, True)):
        v = factor * limit
        found = model.equilibrium(u={"rolls.u.spin": v / COIN["r"], "rolls.u.lean": 0.0})
        assert found.stable is stable
        assert model.linearize(found).acceleration < 1e-12


@pytest.mark.parametrize("speed", [0, 6])
def test_bicycle(bicycle: cd.CompiledModel, speed: int) -> None:
    known = json.loads((HERE.parent / "references" / "bicycle_linear.json").read_text("utf-8"))
    expected = [complex(*pair) for pair in known["reference"]["eigenvalues_by_speed"][str(speed)]]
    straight = {"rear_contact.u.lean": 0.0, "rear_contact.u.yaw": 0.0, "steer": 0.0}
    found = bicycle.linearize(u={**straight, "rear_hub": -speed / 0.3})
    for value in expected:
        assert np.abs(found.eigenvalues - value).min() < 1e-11 * max(1.0, abs(value))
    # all others stand still
    assert np.sum(np.abs(found.eigenvalues) > 1e-5) == len(expected)
    with pytest.raises(cd.ModelError, match="rolling"):
        _ = found.M


# what else there is


def test_a_held_joint_stays(double: cd.CompiledModel) -> None:
    rest = double.equilibrium(locked={"shoulder": 1.0})
    found = double.linearize(rest)
    assert found.states == ("elbow", "elbow.u")
    # a rod of 0.5 m: 3 g / (2 l)
    np.testing.assert_allclose(np.abs(found.eigenvalues), np.sqrt(1.5 * G / 0.5), rtol=1e-10)


def test_controller_states() -> None:
    scene = cd.Scene("servo", gravity=(0, 0, 0))
    wheel = scene.body("wheel", mass=1.0, inertia=(1, 1, 0.5))
    scene.joint("axle", cd.Revolute("z"), scene.ground, wheel)
    target, angle, rate = scene.input("target"), scene.q("axle"), scene.u("axle")
    pid = cd.Controller.pid("axle", angle, rate, target=target, kp=3.0, ki=2.0, kd=1.0)
    scene.force("pid", pid)
    found = cd.compile(scene).linearize()
    assert found.states == ("axle", "axle.u", "pid.integral")
    # I s^3 + kd s^2 + kp s + ki
    _alike(found.eigenvalues, np.roots([0.5, 1.0, 3.0, 2.0]), 1e-12)
    np.testing.assert_allclose(found.B[:, 0], [0, 6.0, 1.0], atol=1e-14)
    # the integral leaves no error at rest
    np.testing.assert_allclose(found.frequency_response(0.0)[0, 0], 1.0, rtol=1e-12)


def test_about_a_state_that_accelerates(cart: cd.CompiledModel) -> None:
    found = cart.linearize(q={"rope": 1.0})
    assert found.acceleration > 1
    assert "accelerates" in repr(found)
    # entry by entry, from accelerations alone
    h = 1e-6
    for k, name in enumerate(("rail", "rope")):
        sides = [cart.forward_dynamics({"rope": 1.0, name: float(name == "rope") + s * h}, [0, 0])
                 for s in (1, -1)]  # fmt: skip
        np.testing.assert_allclose(found.A[2:, k], (sides[0] - sides[1]) / (2 * h), atol=1e-8)


def test_the_constant_part_leads_from_a_state_that_accelerates(cart: cd.CompiledModel) -> None:
    place, speed = {"rail": 0.2, "rope": 1.0}, {"rail": -0.4, "rope": 0.7}
    found = cart.linearize(q=place, u=speed, r={"push": 0.5})
    rates = cart.forward_dynamics([0.2, 1.0], [-0.4, 0.7], r=[0.5])
    np.testing.assert_allclose(found.xdot, [-0.4, 0.7, *rates], rtol=1e-13)
    equations = cd.derive(trolley())
    symbolic = equations.linearize(q=place, u=speed, r={"push": 0.5}, udot="free").at()
    np.testing.assert_allclose(symbolic["xdot"][:, 0], found.xdot, rtol=1e-13)
    # x' = xdot + A x from the state itself: what is left of speeds goes with the cube of time
    errors = []
    for h in (2e-3, 1e-3):
        run = cart.simulate(h, x0=found.x, inputs={"push": 0.5}, rtol=1e-13, atol=1e-14)
        block = np.zeros((5, 5))
        block[:4, :4], block[:4, 4] = found.A, found.xdot
        errors.append(np.abs(run.x[-1] - found.x - expm(block * h)[:4, 4]).max())
    assert errors[0] < 1e-6
    assert errors[0] / errors[1] == pytest.approx(8, rel=0.01)
    np.testing.assert_allclose(cart.linearize().xdot, 0, atol=1e-12)


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda m: m.linearize(inputs=["pash"]), "Did you mean 'push'"),
        (lambda m: m.linearize(outputs=["ropes"]), "Did you mean 'rope'"),
        (lambda m: m.linearize(outputs=3), "give a list of names"),
        (lambda m: m.linearize([1, 2]), "expected"),
        (lambda m: m.linearize(np.zeros(4), q={"rope": 1}), "given twice"),
        (lambda m: m.linearize(q={"rop": 1}), "rope"),
        (lambda m: m.linearize(r=[1, 2, 3]), "inputs have shape"),
        (lambda m: m.linearize(parameters={"bob.mas": 1}), "bob.mass"),
    ],
)
def test_nonsense_is_refused(cart: cd.CompiledModel, call: Callable[[Any], Any], said: str) -> None:
    with pytest.raises(cd.CardanError, match=said):
        call(cart)
