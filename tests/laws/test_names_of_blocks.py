"""Parameters and inputs that are called like blocks: each verb means them, or refuses to guess."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.schema.blocks import DIRECTIONS

STARTS = ("x0", "q0", "u0", "z0", "q0.hinge", "u0.hinge")
NAMES = (*(name for name in DIRECTIONS if name != "t"), *STARTS, "plain")
START: dict[str, Any] = {"q": {"hinge": 0.5}}
COST = cd.cost(final="hinge + hinge.u^2")


def pendulum(name: str, kind: str = "parameter", coordinates: str = "relative") -> Any:
    """A pendulum whose length is a parameter, or whose torque an input, of that name."""
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    length: Any = scene.parameter(name, 0.7) if kind == "parameter" else 0.7
    body = scene.body("body", mass=1.3, com=(0, 0, -length), inertia=(0.1, 0.1, 0.1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, body)
    torque: Any = scene.input(name, 0.2) if kind == "input" else 0.2
    scene.force("motor", cd.JointForce("hinge", torque))
    return cd.compile(scene, coordinates=coordinates)


def by_derivative(model: Any, name: str) -> Any:
    return model.derivative("forward_dynamics", wrt=name)([0.5], [0.1])


def by_vjp(model: Any, name: str) -> Any:
    return model.vjp("forward_dynamics", wrt=name)([0.5], [0.1], [1.0])


def by_jvp(model: Any, name: str) -> Any:
    return model.jvp("forward_dynamics", wrt=name)([0.5], [0.1], 1.0)


def by_hessian(model: Any, name: str) -> Any:
    return model.hessian("forward_dynamics", wrt=name)([0.5], [0.1], [1.0])


def by_gradient(model: Any, name: str) -> Any:
    return model.gradient(0.4, COST, wrt=name, **START).slope[name]


def by_sensitivity(model: Any, name: str) -> Any:
    return model.simulate(0.4, rtol=1e-9, sensitivity=name, **START).sensitivity[name][-1]


def by_ensemble(model: Any, name: str) -> Any:
    runs = model.ensemble(
        np.array([0.0, 0.2, 0.4]), rtol=1e-9, u={"hinge": [0.0, 1.0]}, sensitivity=name, **START
    )
    return runs.sensitivity[name][0, -1]


def by_fit(model: Any, name: str) -> Any:
    motion = model.simulate(np.linspace(0, 1, 21), rtol=1e-11, parameters={name: 0.8}, **START)
    data = {"t": motion.t, "hinge": motion["hinge"]}
    return model.fit(data, unknown=name, **START).parameters[name]


VERBS: dict[str, Callable[[Any, str], Any]] = {
    "derivative": by_derivative,
    "vjp": by_vjp,
    "jvp": by_jvp,
    "hessian": by_hessian,
    "gradient": by_gradient,
    "sensitivity": by_sensitivity,
    "ensemble": by_ensemble,
    "fit": by_fit,
}


@pytest.mark.parametrize("kind", ["parameter", "input"])
def test_each_verb_means_the_name_or_refuses_to_guess(kind: str) -> None:
    """What is answered is what a plain name gives; what is not names the cure."""
    verbs = {n: v for n, v in VERBS.items() if kind == "parameter" or n != "fit"}
    plain = pendulum("plain", kind)
    expected = {verb: call(plain, "plain") for verb, call in verbs.items()}
    refused = dict[tuple[str, str], str]()
    for name in NAMES:
        model = pendulum(name, kind)
        for verb, call in verbs.items():
            try:
                found = call(model, name)
            except cd.ModelError as error:
                refused[name, verb] = str(error)
                continue
            np.testing.assert_allclose(
                found, expected[verb], rtol=1e-9, atol=1e-12, err_msg=f"{name} {verb}"
            )
    for (name, verb), text in refused.items():
        assert f"'{name}'" in text, (name, verb)
        assert "rename" in text, (name, verb, text)
    products = {"derivative", "vjp", "jvp", "hessian"}
    # blocks by the products of functions, and starts by those of motions, and nothing else
    ambiguous = {(n, v) for n in DIRECTIONS if n != "t" for v in products}
    ambiguous |= {(n, v) for n in (*STARTS, "p") for v in verbs if v not in products}
    forward = {"sensitivity", "ensemble", "fit"} & set(verbs)
    held = {(n, v) for n in DIRECTIONS if n != "t" for v in forward}
    assert ambiguous <= {*refused} <= ambiguous | held
    assert "plain" not in {name for name, _ in refused}


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_others_are_not_touched(coordinates: str) -> None:
    """Blocks by default, analyses and derivatives by other names work as they do."""
    plain = pendulum("plain", coordinates=coordinates)
    cost, names = COST, ("q0.hinge", "body.mass")
    expected = plain.gradient(0.4, cost, wrt=names, **START)
    slopes = plain.linearize(q={"hinge": 0.5}).A
    for name in ("p", "q", "u", "r", "x0", "coordinates"):
        model = pendulum(name, coordinates=coordinates)
        found = model.gradient(0.4, cost, wrt=names, **START)
        for one in names:
            np.testing.assert_allclose(found.slope[one], expected.slope[one], rtol=1e-12)
        np.testing.assert_allclose(model.linearize(q={"hinge": 0.5}).A, slopes, rtol=1e-12)
        q, u = model.split(model.initial(**START))
        assert len(model.derivative("forward_dynamics")(q, u)) >= 3
