"""Laps of cycles: closed loops, sticking, rotations, impacts, exchanged names; what is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.errors import ModelError, SolveError, SolveWarning
from cycle_scenes import POINT, duffing, oscillator


def linkage(coordinates: str) -> cd.CompiledModel:
    """A four-bar linkage under a torque."""
    scene = cd.Scene("linkage", gravity=(0, 0, -9.81))
    bodies = {name: scene.body(name, mass=1.0, inertia=(0.1, 0.1, 0.1)) for name in "abc"}
    a, b, c = bodies.values()
    scene.joint("crank", cd.Revolute("y"), scene.ground, a)
    scene.joint("elbow", cd.Revolute("y"), a.at(1, 0, 0), b)
    scene.joint("rocker", cd.Revolute("y"), scene.ground.at(2.5, 0, 0), c)
    scene.joint("pin", cd.Revolute("y"), b.at(2.2, 0, 0), c.at(0, 0, 2))
    scene.force("push", cd.JointForce("crank", 3 * sp.cos(2 * cd.t)))
    scene.force("spring", cd.JointSpring("crank", stiffness=60.0))
    scene.force("damper", cd.JointDamper("crank", damping=4.0))
    return cd.compile(scene, coordinates=coordinates)


def inertia_of_crank(model: cd.CompiledModel, x: Any) -> float:
    """Inertia of the linkage against its crank."""
    q, _ = model.split(x)
    G = model.constraint_jacobian(q)
    motion = np.linalg.svd(G)[2][-1]
    motion /= motion[model.speeds.index("crank.u")]
    return float(motion @ model.mass_matrix(q) @ motion)


@pytest.mark.parametrize(
    "coordinates", ["relative", pytest.param("absolute", marks=pytest.mark.slow)]
)
def test_closed_loops(coordinates: str) -> None:
    model = linkage(coordinates)
    cycle = model.cycle({"crank": 0.1}, period=np.pi, settle=6, check=True)
    # one degree of freedom: what constraints take away is left out
    assert len(cycle.multipliers) == 2
    assert cycle.stable
    after = model.simulate(
        (0, np.pi), x0=cycle.x, rtol=1e-12, atol=1e-14, method="DOP853", check=True
    ).x[-1]
    np.testing.assert_allclose(after, cycle.x, atol=1e-9)
    # with p = M(crank) crank' volumes shrink at the rate c / M
    states = cycle.motion.at(np.linspace(0, np.pi, 65)[:-1])
    decay = [4.0 / inertia_of_crank(model, x) for x in states]
    product = np.prod(cycle.multipliers)
    assert cycle.derivatives == "exact"
    assert product == pytest.approx(np.exp(-np.pi * np.mean(decay)), rel=1e-10)


def belt(speed: float) -> cd.CompiledModel:
    """A mass on a belt, with a spring of 1: sliding friction 1, sticking 3/2."""
    scene = cd.Scene("belt", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("mass", **POINT))
    surface = scene.parameter("speed", speed)
    scene.force("friction", cd.Friction("x", coulomb=1.0, static=1.5, against=surface))
    scene.force("spring", cd.JointSpring("x", stiffness=1.0))
    return cd.compile(scene)


def test_stick_and_slip() -> None:
    """With A = 1/2 between both: 2 A / v of sticking, 2 (pi - atan(A / v)) of sliding.

    Where it sticks all disturbances end.
    """
    cycle = belt(0.5).cycle({"x": 1.0, "x.u": -0.65}, check=True)
    assert cycle.period == pytest.approx(2 + 1.5 * np.pi, abs=1e-11)
    assert cycle["x.u"] == pytest.approx(-np.sqrt(0.5), abs=1e-11)
    assert [event.name for event in cycle.motion.events] == ["friction.stop", "friction.slip"]
    assert cycle.motion.events[1].t - cycle.motion.events[0].t == pytest.approx(2.0, abs=1e-11)
    assert cycle.multipliers == pytest.approx([0.0], abs=1e-12)
    assert cycle.modes == [-1.0]
    path = cycle.model.continuation(speed=(0.5, 1.0), of="cycles", start=cycle)
    v = path["speed"]
    expected = 1 / v + 2 * np.pi - 2 * np.arctan(0.5 / v)
    np.testing.assert_allclose(path["period"], expected, atol=1e-10)


def swung(rotation: str) -> Any:
    """A body on a ball joint that a force swings around, tied to the ground."""
    scene = cd.Scene("swung", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=1.0, com=(0, 0, -1), inertia=(0.1, 0.1, 0.05))
    scene.joint("ball", cd.Spherical(rotation=rotation), scene.ground, body)
    push = (sp.cos(2 * cd.t), 0.5 * sp.sin(2 * cd.t), 0)
    scene.force("push", cd.Force(body.at(0, 0, -1), push))
    scene.force("drag", cd.JointDamper("ball", damping=0.5))
    tie = cd.SpringDamper(
        scene.ground.at(1, 0, -1), body.at(0.5, 0, -1), stiffness=3.0, rest_length=0.2
    )
    scene.force("tie", tie)
    return cd.compile(scene).cycle({}, period=np.pi, settle=10, check=True)


def test_rotations_are_moved_by_increments() -> None:
    quaternion, angles = swung("quaternion"), swung("xyz")
    np.testing.assert_allclose(quaternion.u, angles.u, atol=1e-11)
    assert len(quaternion.multipliers) == 6
    np.testing.assert_allclose(quaternion.multipliers, angles.multipliers, atol=1e-11)
    assert quaternion.stable


def test_impact_at_a_section() -> None:
    """The same cycle with and without a section at its impact, where the state jumps."""
    scene = cd.Scene("stopped", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("body", **POINT))
    x, v = scene.q("x"), scene.u("x")
    scene.force("force", cd.JointForce("x", (1 - x**2) * v - x))
    scene.force("stop", cd.Stop("x", lower=-1.0, restitution=0.8))
    model = cd.compile(scene)
    free = model.cycle({"x": 1.5}, check=True)
    start = {"x": -1.0, "x.u": 1.5}
    by_section = model.cycle(start, section="stop.lower", check=True)
    (impact,) = free.motion.events
    np.testing.assert_allclose(by_section.x, impact.x_after, atol=1e-11)
    assert by_section.period == pytest.approx(free.period, abs=1e-11)
    assert by_section.multipliers == pytest.approx(free.multipliers, abs=1e-11)
    assert len(free.multipliers) == len(by_section.multipliers) == 1


def test_names_that_are_exchanged() -> None:
    """Two limit cycles in opposition: half of the period with the names exchanged is a lap."""
    scene = cd.Scene("pair", gravity=(0, 0, 0))
    for name in ("left", "right"):
        body = scene.body(f"body_{name}", **POINT)
        scene.joint(name, cd.Prismatic("x"), scene.ground, body)
    for name, other in (("left", "right"), ("right", "left")):
        x, v = scene.q(name), scene.u(name)
        force = (1 - x**2) * v - x - 0.3 * (x + scene.q(other))
        scene.force(f"force_{name}", cd.JointForce(name, force))
    model = cd.compile(scene)
    start = {"left": 2.0, "right": -2.0}
    full = model.cycle(start, check=True)
    half = model.cycle(start, symmetry={"left": "right"}, check=True)
    assert half.period == pytest.approx(full.period / 2, abs=1e-11)
    np.testing.assert_allclose(half.x, full.x, atol=1e-10)
    np.testing.assert_allclose(
        sorted(abs(half.multipliers) ** 2), sorted(abs(full.multipliers)), atol=1e-11
    )
    assert half["left"] == pytest.approx(-half["right"], abs=1e-10)


def test_families_without_damping() -> None:
    """A pendulum swings with every amplitude: T = 4 K(sin(a / 2)) / w, and a multiplier of 1."""
    from scipy.special import ellipk

    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=1.0, com=(0, 0, -1), inertia=(0, 0, 0))
    scene.joint("angle", cd.Revolute("y"), scene.ground, body)
    cycle = cd.compile(scene).cycle({"angle": 1.0}, check=True)
    expected = 4 * np.sqrt(1 / 9.81) * ellipk(np.sin(cycle["angle"] / 2) ** 2)
    assert cycle.period == pytest.approx(expected, abs=1e-11)
    assert cycle.multipliers == pytest.approx([1.0], abs=1e-11)
    assert cycle.stable


def test_messages() -> None:
    model = oscillator(lambda scene, x, v: (1 - x**2) * v - x)
    with pytest.raises(ModelError, match=r"there is no 'y'"):
        model.cycle({"y": 1.0})
    with pytest.raises(ModelError, match=r"there is no event 'strike'"):
        model.cycle({"x": 1.0}, section="strike")
    with pytest.raises(ModelError, match=r"leave one out"):
        model.cycle({"x": 1.0}, section="strike", period=1.0)
    with pytest.raises(ModelError, match=r"symmetry: there is no 'y'"):
        model.cycle({"x": 1.0}, symmetry={"x": "y"})
    with pytest.raises(SolveError, match=r"does not come back to 'section' within 20 s"):
        model.cycle({"x": 1.0}, section=("x", 5.0), longest=20.0)
    with pytest.raises(SolveError, match=r"at rest"):
        model.cycle({"x": 0.0})
    forced, _ = duffing()
    with pytest.raises(ModelError, match=r"give period="):
        forced.cycle({"x": 1.0})
    with pytest.raises(SolveError, match=r"period=-1: it is a positive time"):
        forced.cycle({"x": 1.0}, period=-1.0)
    with pytest.raises(SolveError, match=r"period=nan"):
        forced.cycle({"x": 1.0}, period=lambda p: 1 / (p["omega"] - 1.4))
    with pytest.raises(ModelError, match=r"there is no parameter or input 'Omega'"):
        forced.cycle({"x": 1.0}, period=1 / sp.Symbol("Omega"))
    with pytest.raises(ModelError, match=r"period=1.234: what forces 'duffing'"):
        forced.cycle({"x": 1.0}, period=1.234)
    drifting = oscillator(lambda scene, x, v: 1 + sp.cos(cd.t))
    with pytest.warns(SolveWarning, match=r"laps miss their starts by"):
        lost = drifting.cycle({"x": 1.0}, period=2 * np.pi)
    assert not lost.converged
    by_section = model.cycle({"x": 2.0, "x.u": -0.1}, section=(("x.u", 0.0), "down"))
    assert by_section["x"] == pytest.approx(2.008619860874844, abs=1e-11)
    assert by_section.multipliers == pytest.approx([0.000859695063603616], abs=1e-11)
    assert "multipliers 0.00085969" in repr(by_section)
