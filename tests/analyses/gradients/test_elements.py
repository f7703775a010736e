"""Gradients of motions of beams: closed forms, and differences of whole motions."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import cardan as cd
from laws.absolute_scenes import cantilever, rubber
from table import each

SPAN, STEPS = 0.02, 100
HOW: dict[str, Any] = {"method": "RK4", "step": SPAN / STEPS}
START: dict[str, Any] = {
    "q": {"hinge": 0.3, "wrist": 0.2, "elbow": (0.8, 0.6, 0.0, 0.0)},
    "u": {"hinge": 1.0, "wrist": -0.5, "elbow": (0.3, 0.0, -0.4)},
}
COST = cd.cost(final="z*z", running="hinge.u^2 + acceleration/100")
PARAMETERS = ("E", "rho", "width", "height", "m", "l", "a", "gravity.z")


@functools.cache
def model_of(coordinates: str) -> cd.CompiledModel:
    return cd.compile(rubber(), coordinates=coordinates)


def richardson(f: Callable[[float], float], h: float) -> float:
    """Slope of f at 0 to fourth order."""
    wide, narrow = ((f(step) - f(-step)) / (2 * step) for step in (2 * h, h))
    return (4 * narrow - wide) / 3


def cost(model: cd.CompiledModel, start: dict[str, Any] = START, torque: Any = 0.1) -> float:
    # a start that is given as a whole needs no derivatives by names
    x0, inputs = model.initial(**start), {"torque": torque}
    return model.gradient(SPAN, COST, wrt="m", x0=x0, inputs=inputs, **HOW).value


@each("coordinates", ["auto", "absolute"])
def test_by_parameters(coordinates: str) -> None:
    model = model_of(coordinates)
    names = ("p", *PARAMETERS)
    found = model.gradient(SPAN, COST, wrt=names, inputs={"torque": 0.1}, **START, **HOW)
    for name in PARAMETERS:
        value = model.parameters[name]

        def at(h: float, name: str = name, value: float = value) -> float:
            return cost(model.with_parameters({name: value * (1 + h)}))

        expected = richardson(at, 1e-3) / value
        assert found.slope[name] == pytest.approx(expected, rel=1e-7), name
        assert found.slope["p"][list(model.parameters).index(name)] == found.slope[name]


def test_by_start_and_input() -> None:
    """What is named at the start carries nodes and beams along; an input counts by its values."""
    model, times = model_of("absolute"), np.array([0.0, SPAN])
    table = (times, np.array([0.1, 0.3]))
    names = ("q0.hinge", "q0.wrist", "u0.hinge", "u0.wrist", "q0.elbow", "u0.elbow", "torque")
    found = model.gradient(SPAN, COST, wrt=names, inputs={"torque": table}, **START, **HOW)
    for letter, joint in (("q", "hinge"), ("q", "wrist"), ("u", "hinge"), ("u", "wrist")):

        def at(h: float, letter: str = letter, joint: str = joint) -> float:
            block = {**START[letter], joint: START[letter][joint] + h}
            return cost(model, {**START, letter: block}, table)

        assert found.slope[f"{letter}0.{joint}"] == pytest.approx(richardson(at, 1e-3), rel=1e-7)
    for k in range(3):

        def turned(h: float, k: int = k) -> float:
            a, b = np.array(START["q"]["elbow"]), np.cos(h / 2)
            d = np.array([b, *(np.sin(h / 2) * np.eye(3)[k])])
            w = a[0] * d[0] - a[1:] @ d[1:]
            v = a[0] * d[1:] + d[0] * a[1:] + np.cross(a[1:], d[1:])
            return cost(model, {**START, "q": {**START["q"], "elbow": (w, *v)}}, table)

        def faster(h: float, k: int = k) -> float:
            u = np.array(START["u"]["elbow"]) + h * np.eye(3)[k]
            return cost(model, {**START, "u": {**START["u"], "elbow": u}}, table)

        for name, f in (("q0.elbow", turned), ("u0.elbow", faster)):
            expected = richardson(f, 1e-3)
            assert found.slope[name][k] == pytest.approx(expected, rel=1e-7, abs=1e-9), (name, k)
    for k in range(2):

        def driven(h: float, k: int = k) -> float:
            return cost(model, torque=(times, table[1] + h * np.eye(2)[k]))

        assert found.slope["torque"][k] == pytest.approx(richardson(driven, 1e-2), rel=1e-7)


def test_coordinates_agree() -> None:
    """The same motion in both kinds of coordinates has the same gradient."""
    names = ("p", "q0.hinge", "q0.elbow", "u0.wrist", "torque")
    slopes = [
        model_of(one).gradient(SPAN, COST, wrt=names, inputs={"torque": 0.1}, **START, **HOW).slope
        for one in ("auto", "absolute")
    ]
    for name in names:
        a, b = (np.asarray(slope[name]) for slope in slopes)
        assert np.abs(a - b).max() <= 1e-9 * np.abs(a).max(), name


@each("plane", [None, "y"])
def test_time_is_scaled(plane: str | None) -> None:
    """From rest, without gravity and losses, x is a function of t sqrt(E / rho)."""
    model = cd.compile(cantilever(), coordinates="absolute", plane=plane)
    q, u, z = model.parts_of(model.initial())
    rng = np.random.default_rng(0)
    x0 = np.concatenate([model.integrate(q, 0.02 * rng.uniform(-1, 1, model.nu)), u, z])
    end = 0.01
    how = {"method": "DOP853", "rtol": 1e-11, "atol": 1e-12}
    found = model.gradient(end, cd.cost(final="deflection"), x0=x0, wrt=("E", "rho"), **how)
    q, u, _ = model.parts_of(found.motion.x[-1])
    (speed,) = model.jvp("outputs", wrt="q")(q, u, u)
    assert 5e6 * found.slope["E"] == pytest.approx(end / 2 * speed, rel=1e-8)
    assert 1100 * found.slope["rho"] == pytest.approx(-end / 2 * speed, rel=1e-8)


def test_forward_is_backward() -> None:
    """Sensitivities along the motion give the same slopes."""
    model, names = model_of("auto"), ("E", "l", "q0.hinge", "u0.wrist")
    how = {"method": "RK4", "step": SPAN / 50}
    inputs = {"torque": 0.1}
    motion = model.simulate(SPAN, sensitivity=names, inputs=inputs, **START, **how)
    found = model.gradient(
        SPAN, cd.cost(final="hinge"), wrt=names, inputs=inputs, **START, **how
    ).slope
    at = model.coordinates.index("hinge")
    for name in names:
        assert motion.sensitivity[name][-1, at] == pytest.approx(found[name], rel=1e-9)
