"""Limit cycles from Hopf points of closed loops, absolute coordinates and beams."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import cardan as cd

G = 9.81
Y = cd.Revolute("y")


def fed(scene: cd.Scene, joint: str) -> None:
    """A moment that feeds small swings of a joint, and damps large ones."""
    mu, angle, rate = scene.parameter("mu", -0.1), scene.q(joint), scene.u(joint)
    scene.force("feed", cd.JointForce(joint, (mu - 20 * angle**2) * rate))


def linkage() -> cd.CompiledModel:
    """A parallelogram whose bar does not turn."""
    scene = cd.Scene("linkage", gravity=(0, 0, -G))
    crank: Any = {"mass": 0.5, "com": (0, 0, -0.5), "inertia": (0.05, 0.05, 0.05)}
    left, right = scene.body("left", **crank), scene.body("right", **crank)
    bar = scene.body("bar", mass=2.0, com=(1, 0, 0), inertia=(0.3, 0.3, 0.3))
    scene.joint("left", Y, scene.ground, left)
    scene.joint("right", Y, scene.ground.at(2, 0, 0), right)
    scene.joint("top", Y, left.at(0, 0, -1), bar)
    scene.joint("end", Y, right.at(0, 0, -1), bar.at(2, 0, 0))
    fed(scene, "left")
    return cd.compile(scene)


def pendulum() -> cd.CompiledModel:
    """The same as one body: the bar is a mass at the end of a crank."""
    scene = cd.Scene("pendulum", gravity=(0, 0, -G))
    inertia = 2 * (0.05 + 0.5 * 0.25) + 2.0
    height = (2 * 0.5 * 0.5 + 2.0) / 3.0
    about = inertia - 3.0 * height**2
    body = scene.body("body", mass=3.0, com=(0, 0, -height), inertia=(about, about, about))
    scene.joint("left", Y, scene.ground, body)
    fed(scene, "left")
    return cd.compile(scene)


def from_rest(model: cd.CompiledModel, name: str, span: tuple[float, float], **more: Any) -> Any:
    """The path of cycles from the first Hopf point."""
    rest = model.continuation({name: span})
    start = rest.point("Hopf point 1")
    return model.continuation({name: span}, of="cycles", start=start, **more)


def test_closed_loop() -> None:
    loop, tree = (from_rest(model, "mu", (-0.1, 1.0)) for model in (linkage(), pendulum()))
    assert loop["mu"][-1] == pytest.approx(1.0, rel=1e-12)
    assert tree["left.max"][-1] > 0.4
    np.testing.assert_allclose(loop["left.max"][-1], tree["left.max"][-1], rtol=1e-9)
    np.testing.assert_allclose(loop["period"][-1], tree["period"][-1], rtol=1e-11)
    ours, theirs = loop[-1].multipliers, tree[-1].multipliers
    np.testing.assert_allclose(ours, theirs, atol=1e-8)


def ziegler(coordinates: str) -> cd.CompiledModel:
    """Two rods under a force that turns along with the upper one."""
    scene = cd.Scene("ziegler", gravity=(0, 0, 0))
    lower, upper = (
        scene.body(name, mass=mass, inertia=(0.01, 0.01, 0.01), com=(0, 0, 0.5))
        for name, mass in (("lower", 2.0), ("upper", 1.0))
    )
    scene.joint("a", Y, scene.ground, lower)
    scene.joint("b", Y, lower.at(0, 0, 1), upper)
    for name in "ab":
        angle, rate = scene.q(name), scene.u(name)
        scene.force(f"on_{name}", cd.JointForce(name, -angle - 0.3 * angle**3 - 0.1 * rate))
    push = (0, 0, -scene.parameter("P", 0.5))
    scene.force("push", cd.Force(upper.at(0, 0, 1), push, in_=upper))
    return cd.compile(scene, coordinates=coordinates)


@pytest.mark.slow
def test_absolute_coordinates() -> None:
    paths = [from_rest(ziegler(kind), "P", (0.5, 2.0)) for kind in ("relative", "absolute")]
    tree, absolute = (path[-1] for path in paths)
    assert paths[0]["a.max"][-1] > 0.3
    assert absolute.period == pytest.approx(tree.period, rel=1e-11)
    for name in ("a.max", "b.max"):
        assert paths[1][name][-1] == pytest.approx(paths[0][name][-1], rel=1e-6)
    assert absolute.derivatives == "exact"
    np.testing.assert_allclose(absolute.multipliers, tree.multipliers, atol=1e-9)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::cardan.errors.SolveWarning")
def test_column_of_beams() -> None:
    """Beck's column of rubber flutters about its thin side; another program runs one lap."""
    scene = cd.Scene("beck", gravity=(0, 0, 0))
    rubber = cd.material(E=1e6, nu=0.3, rho=1000, damping=0.002)
    section = cd.section.rectangle(0.2, 0.3)
    column = scene.beam("column", scene.ground, (0, 0, 1), section, rubber, elements=1)
    push = (0, 0, -scene.parameter("P", 0.0))
    scene.force("push", cd.Force(column.end, push, in_=column.end))
    model = cd.compile(scene)
    path = from_rest(model, "P", (0.0, 4000.0), points=4)
    cycle = path[-1]
    swing = max(path[f"column.end.{axis}.max"][-1] for axis in ("px", "py"))
    assert swing > 1e-3

    def rates(t: float, x: Any) -> Any:
        return cycle.model.rhs(t, x)

    end = solve_ivp(rates, (0, cycle.period), cycle.x, "DOP853", rtol=1e-10, atol=1e-13).y[:, -1]
    np.testing.assert_allclose(end, cycle.x, atol=1e-7 * swing)
