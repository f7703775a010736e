"""Gradients of motions against references, closed forms and differences of whole motions."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.errors import ModelError, SolveError
from table import each

REFERENCES = Path(__file__).parents[2] / "references"
TIGHT = {"rtol": 1e-12, "atol": 1e-13}
METHODS = ["DOP853", "Radau"]


def reference(name: str) -> dict[str, Any]:
    return json.loads((REFERENCES / f"{name}.json").read_text("utf-8"))


def double_pendulum() -> cd.CompiledModel:
    scene = cd.Scene("double pendulum", gravity=(0, 0, -9.81))
    m1, m2, l1, l2 = (scene.parameter(name, 1.0) for name in ("m1", "m2", "l1", "l2"))
    upper = scene.body("A", mass=m1, com=(0, 0, -l1 / 2), inertia=cd.inertia.rod(m1, l1, axis="z"))
    lower = scene.body("B", mass=m2, com=(0, 0, -l2 / 2), inertia=cd.inertia.rod(m2, l2, axis="z"))
    scene.joint("a", cd.Revolute("y"), scene.ground, upper)
    scene.joint("b", cd.Revolute("y"), upper.at(0, 0, -l1), lower)
    return cd.compile(scene)


@each("method", ["DOP853", "RK45", "RK4", "Radau"])
def test_double_pendulum(method: str) -> None:
    known = reference("sens_double_pendulum")["reference"]
    cost = cd.cost(final="(a^2 + 1.1*b^2 + 1.2*a.u^2 + 1.3*b.u^2)/2")
    names = ("x0", "m1", "m2", "l1", "l2", "gravity.z")
    how = {"step": 2e-4} if method == "RK4" else TIGHT
    found = double_pendulum().gradient(
        2.0, cost, wrt=names, method=method, q={"a": 1.0, "b": 0.5}, u={"a": 0.2, "b": -0.1}, **how
    )
    slope = [*found.slope["x0"], *(found.slope[name] for name in names[1:])]
    slope[-1] *= -1.0
    assert found.value == pytest.approx(known["cost"], rel=1e-11)
    error = np.abs(np.array(slope) - known["gradient"]).max() / np.abs(known["gradient"]).max()
    assert error <= 1e-10


def ball(**stop: Any) -> cd.CompiledModel:
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    restitution = scene.parameter("e", 0.8)
    scene.joint("z", cd.Prismatic("z"), scene.ground, scene.body("ball", mass=1.0))
    scene.force("floor", cd.Stop("z", lower=0.0, restitution=restitution, **stop))
    return cd.compile(scene)


@each("entry", [0, 1])
def test_impacts_move_with_what_they_depend_on(entry: int) -> None:
    known = reference("sens_bouncing_ball")["reference"]
    found = ball().gradient(
        2.0,
        cd.cost(final=["z", "z.u"][entry]),
        wrt=("q0.z", "e", "gravity.z"),
        q={"z": 1.0},
        rtol=1e-13,
        atol=1e-14,
    )
    expected = [known["derivatives"][name][entry] for name in "heg"]
    ours = [found.slope["q0.z"], found.slope["e"], -found.slope["gravity.z"]]
    assert found.value == pytest.approx(known["state"][entry], abs=1e-12)
    np.testing.assert_allclose(ours, expected, rtol=1e-11, atol=1e-11)
    wrong = known["without_saltation_WRONG"][entry]
    assert np.abs(np.array(ours) - wrong).max() > 0.5


def test_twenty_impacts() -> None:
    """Height of a ball that bounces with e = 0.95, closed form: derivatives by its first height."""
    height, e, g, t = 1.0, 0.95, 9.81, 12.0
    found = ball().gradient(
        t, cd.cost(final="z"), wrt=("q0.z", "e"), q={"z": height}, parameters={"e": e},
        rtol=1e-13, atol=1e-14,
    )  # fmt: skip
    assert len([one for one in found.motion.events if one.kind == "impact"]) >= 20

    def z(h: complex, e: complex) -> complex:
        start = np.sqrt(2 * h / g)
        speed, at = g * start, start
        while (at + 2 * e * speed / g).real < t:
            speed, at = e * speed, at + 2 * e * speed / g
        return e * speed * (t - at) - g * (t - at) ** 2 / 2

    step = 1e-30
    assert found.value == pytest.approx(z(height, e).real, abs=1e-10)
    assert found.slope["q0.z"] == pytest.approx(z(height + 1j * step, e).imag / step, rel=1e-10)
    assert found.slope["e"] == pytest.approx(z(height, e + 1j * step).imag / step, rel=1e-10)


# against differences of whole motions


def difference(cost_at: Callable[[float], float], step: float) -> float:
    """Slope to eighth order."""
    weights = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
    return sum(
        w * (cost_at(k * step) - cost_at(-k * step)) for k, w in enumerate(weights, 1)
    ) / step  # fmt: skip


def judge(
    model: cd.CompiledModel, t: float, cost: Any, names: tuple[str, ...], **given: Any
) -> Any:
    """Gradients by scalar names against differences of the values of the cost."""
    given = {**TIGHT, **given}
    found = model.gradient(t, cost, wrt=names, **given)
    for name in names:

        def value(by: float, name: str = name) -> float:
            changed = dict(given)
            block, _, entry = name.partition(".")
            if block in ("q0", "u0", "z0"):
                block = block[0]
                changed[block] = {**given.get(block, {}), entry: given[block][entry] + by}
            elif name in model.parameters:
                own = {"parameters": {}, **given}["parameters"]
                present = own.get(name, model.parameters[name])
                changed["parameters"] = {**own, name: present + by}
            else:
                present = given["inputs"][name]
                changed["inputs"] = {**given["inputs"], name: present + by}
            return model.gradient(t, cost, wrt="x0", **changed).value

        expected = difference(value, 1e-3)
        assert found.slope[name] == pytest.approx(expected, rel=1e-7, abs=1e-9), name
    if "events" not in given:
        both(model, t, model.coordinates[0], names, **given)
    return found


def test_inputs_by_their_values() -> None:
    scene = cd.Scene("driven", gravity=(0, 0, -9.81))
    bar = scene.body("bar", mass=1.0, com=(0, 0, -0.5), inertia=cd.inertia.rod(1.0, 1.0, axis="z"))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, bar)
    tau, bias = scene.input("tau", unit="N*m"), scene.input("bias", unit="N*m")
    scene.force("motor", cd.JointForce("hinge", tau + bias - 0.1 * scene.u("hinge")))
    model = cd.compile(scene)
    times, values = np.linspace(0, 1.5, 6), np.array([1.0, -0.5, 2.0, 0.3, 0.0, -1.0])
    cost = cd.cost(final="hinge^2 + t*hinge.u", running="1e-2*tau^2 + hinge^2 + tau*hinge.u")

    def run(values: Any, wrt: Any = "x0") -> Any:
        inputs = {"tau": (times, values), "bias": 0.2}
        return model.gradient(1.5, cost, wrt=wrt, q={"hinge": 0.4}, inputs=inputs, **TIGHT)

    found = run(values, ("tau", "bias"))
    for k, unit in enumerate(np.eye(6)):
        expected = difference(lambda by, unit=unit: run(values + by * unit).value, 1e-2)
        assert found.slope["tau"][k] == pytest.approx(expected, rel=1e-8, abs=1e-10)
    table = {"tau": (times, values), "bias": 0.2}
    both(model, 1.5, "hinge", ("tau", "bias", "u0.hinge"), q={"hinge": 0.4}, inputs=table)
    given = {"q": {"hinge": 0.4}, "inputs": {"tau": 0.3, "bias": 0.2}}
    judge(model, 1.5, cost, ("tau", "bias", "q0.hinge"), **given)


@each("method", METHODS)
def test_rotations(method: str) -> None:
    scene = cd.Scene("top", gravity=(0, 0, -9.81))
    m = scene.parameter("m", 2.0)
    body = scene.body("top", mass=m, com=(0.1, 0.05, 0.3), inertia=(0.1, 0.2, 0.25))
    scene.joint("tip", cd.Spherical(), scene.ground, body)
    slider = scene.body("slider", mass=0.5, inertia=(0.01, 0.02, 0.03))
    scene.joint("rod", cd.Prismatic("x"), body, slider)
    scene.force("spring", cd.JointSpring("rod", stiffness=40.0))
    scene.output("height", body.at(0, 0, 0.3).position()[2])
    model = cd.compile(scene)
    cost = cd.cost(final="height", running="rod^2")
    given = {"q": {"rod": 0.1}, "u": {"tip": (0.3, -0.2, 4.0), "rod": 0.1}, "method": method}
    found = judge(model, 1.0, cost, ("m", "q0.rod", "u0.rod"), **given)
    assert found.slope.keys() == {"m", "q0.rod", "u0.rod"}
    start = model.gradient(1.0, cost, wrt=("q0", "q0.tip"), **TIGHT, **given)
    x0 = model.initial(q=given["q"], u=given["u"])
    place, speeds = model.split(x0)

    def value(by: float, k: int) -> float:
        q = model.integrate(place, by * np.eye(model.nu)[k])
        return model.gradient(1.0, cost, wrt="p", x0=np.concatenate([q, speeds]), **TIGHT).value

    for k in range(3):
        expected = difference(lambda by, k=k: value(by, k), 1e-3)
        assert start.slope["q0"][k] == pytest.approx(expected, rel=1e-8, abs=1e-10)
    np.testing.assert_array_equal(start.slope["q0"][:3], start.slope["q0.tip"])


@each("method", METHODS)
def test_parameters_of_loops_move_the_start_too(method: str) -> None:
    scene = cd.Scene("four-bar", gravity=(0, -9.81, 0))
    length = scene.parameter("length", 0.8)
    crank, coupler, rocker = (
        scene.body(name, mass=1.0, com=(size / 2, 0, 0), inertia=cd.inertia.rod(1.0, 0.5))
        for name, size in (("crank", 0.3), ("coupler", length), ("rocker", 0.6))
    )
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("B", cd.Revolute("z"), crank.at(0.3, 0, 0), coupler)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(0.9, 0, 0), rocker)
    scene.joint("C", cd.Revolute("z"), coupler.at(length, 0, 0), rocker.at(0.6, 0, 0), cut=True)
    scene.output("x", coupler.at(length, 0, 0).position()[0])
    model = cd.compile(scene)
    cost = cd.cost(final="x", running="B^2")
    given = {"q": {"A": 0.8}, "u": {"A": 2.0}, "method": method}
    judge(model, 0.7, cost, ("length", "crank.mass", "q0.A", "u0.A"), **given)


def test_sampled_controllers() -> None:
    scene = cd.Scene("servo")
    cart = scene.body("cart", mass=2.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, cart)
    gain = scene.parameter("gain", 30.0)
    off, total = scene.q("x") - 0.5, sp.Symbol("total")
    force = -gain * off - 8.0 * scene.u("x") - 5.0 * total
    pid = cd.Controller("x", states=[total], changes=[total + 0.02 * off], force=force, sample=0.02)
    scene.force("pid", pid)
    judge(
        cd.compile(scene), 0.55, cd.cost(final="x^2", running="x.u^2"),
        ("gain", "q0.x", "cart.mass"), q={"x": 0.1},
    )  # fmt: skip


def test_friction_that_sticks_and_slips() -> None:
    scene = cd.Scene("belt")
    block = scene.body("block", mass=1.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, block)
    k = scene.parameter("k", 20.0)
    scene.force("spring", cd.JointSpring("x", stiffness=k))
    scene.force("rail", cd.Friction("x", coulomb=1.5))
    model = cd.compile(scene)
    given = {"q": {"x": 1.0}}
    found = judge(
        model, 2.5, cd.cost(final="x", running="x^2"), ("k", "q0.x", "rail.coulomb"), **given
    )
    assert len(found.motion.events) >= 2


def test_runs_that_end_at_an_event() -> None:
    """The time of the end moves along: t itself is a cost."""
    model = double_pendulum()
    given = {"q": {"a": 1.0, "b": 0.5}, "u": {"a": 0.2}, "events": {"low": ("a", 0.2)}}
    judge(model, 5.0, cd.cost(final="t"), ("m2", "l1", "q0.a", "u0.a"), **given)
    judge(model, 5.0, cd.cost(final="a.u^2 + b", running="b^2"), ("m2", "q0.b"), **given)


def test_a_touch_has_no_derivative() -> None:
    """Thrown so that it just reaches a ceiling."""
    scene = cd.Scene("ceiling", gravity=(0, 0, -10.0))
    scene.joint("z", cd.Prismatic("z"), scene.ground, scene.body("ball", mass=1.0))
    scene.force("ceiling", cd.Stop("z", upper=5.0 * (1 - 1e-15), restitution=0.5))
    model = cd.compile(scene)
    with pytest.raises(SolveError, match="by a touch"):
        model.gradient(2.0, cd.cost(final="z"), wrt="x0", u={"z": 10.0}, **TIGHT)


def test_two_events_at_one_time_have_no_derivative() -> None:
    scene = cd.Scene("feet", gravity=(0, 0, -9.81))
    for name in ("left", "right"):
        scene.joint(name, cd.Prismatic("z"), scene.ground, scene.body(f"{name} foot", mass=1.0))
        scene.force(f"floor of {name}", cd.Stop(name, lower=0.0, restitution=0.5))
    model = cd.compile(scene)
    with pytest.raises(SolveError, match=r"floor of left.*floor of right.*at the same time"):
        model.gradient(1.0, cd.cost(final="left"), wrt="x0", q={"left": 0.5, "right": 0.5})


def test_what_has_no_gradient_is_refused_with_the_cure() -> None:
    model = double_pendulum()
    cost = cd.cost(final="a")
    with pytest.raises(ModelError, match=r"Rosenbrock.*Take Radau"):
        model.gradient(1.0, cost, method="Rosenbrock")
    with pytest.raises(ModelError, match=r"'c' is not a start.*parameter or input"):
        model.gradient(1.0, cost, wrt=("x0", "c"))
    with pytest.raises(ModelError, match="not known"):
        cd.compile(_with_input()).gradient(1.0, cd.cost(final="x"), inputs={"f": lambda t: t})
    with pytest.raises(SolveError, match=r"'low'.*function"):
        model.gradient(5.0, cost, q={"a": 1.0}, events={"low": lambda t, x: x[0] - 0.2}, wrt="x0")
    for wrong in ({}, {"final": ""}, {"running": 3j}):
        with pytest.raises(cd.ArgumentError):
            cd.cost(**wrong)


def both(
    model: cd.CompiledModel, t: float, output: str, names: tuple[str, ...], **given: Any
) -> Any:
    """Forward and backward: the same numbers."""
    given = {**TIGHT, "method": "DOP853", **given}
    motion = model.simulate(t, sensitivity=names, **given)
    found = model.gradient(t, cd.cost(final=output), wrt=names, **given)
    entries = (*model.coordinates, *model.speeds, *model.internals)
    for name in names:
        forward = motion.sensitivity[name][-1, entries.index(output)]
        backward = np.asarray(found.slope[name])
        scale = max(1.0, float(np.abs(backward).max(initial=0.0)))
        assert np.abs(forward - backward).max(initial=0.0) <= 1e-12 * scale, name
    return motion


def test_forward_and_backward_are_the_same() -> None:
    model = double_pendulum()
    names = ("x0", "m1", "p", "q0.b")
    given = {"q": {"a": 1.0, "b": 0.5}, "u": {"a": 0.2}}
    for method in ("DOP853", "RK45", "Radau", "RKMK853", "GeneralizedAlpha", "EnergyMidpoint"):
        both(model, 2.0, "b", names, method=method, **given)
    both(ball(), 2.0, "z", ("q0.z", "e", "gravity.z"), q={"z": 1.0})


def _with_input() -> cd.Scene:
    scene = cd.Scene("pushed")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("cart", mass=1.0))
    scene.force("push", cd.JointForce("x", scene.input("f")))
    return scene


def test_times_of_jumps_are_held_or_refused() -> None:
    """A push that begins at t = 0.3 s, or when a parameter says."""
    scene = cd.Scene("pushed")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("cart", mass=2.0))
    begin, size = scene.parameter("begin", 0.3), scene.parameter("size", 5.0)
    push = sp.Piecewise((0, cd.t < begin), (size, True))
    scene.force("push", cd.JointForce("x", push))
    model = cd.compile(scene)
    # x = size (t - begin)^2 / 2 m
    found = model.gradient(1.0, cd.cost(final="x"), wrt=("size", "cart.mass"), **TIGHT)
    assert found.slope["size"] == pytest.approx(0.7**2 / 4, rel=1e-10)
    assert found.slope["cart.mass"] == pytest.approx(-5.0 * 0.7**2 / 8, rel=1e-10)
    for names in ("begin", "p"):
        with pytest.raises(ModelError, match=r"'begin' decides when the model jumps"):
            model.gradient(1.0, cd.cost(final="x"), wrt=names)
        with pytest.raises(ModelError, match=r"'begin' decides when the model jumps"):
            model.simulate(1.0, sensitivity=names)
