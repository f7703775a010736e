"""Prescribed and coupled joints, relations, feedback and outputs in absolute coordinates."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from equations.finite_elements.cases import State, both

ROUNDING = 100
INERTIA = ((0.3, 0.02, -0.01), (0.02, 0.4, 0.03), (-0.01, 0.03, 0.2))
t = sp.Symbol("t")


def arm(name: str, **more: object) -> cd.Scene:
    """Two links with a slider on the second."""
    scene = cd.Scene(name, gravity=(0.4, -0.2, -9.81))
    upper = scene.body("upper", mass=2.0, com=(0.02, 0, -0.3), inertia=INERTIA)
    lower = scene.body("lower", mass=1.0, com=(0, 0.01, -0.2), inertia=INERTIA)
    puck = scene.body("puck", mass=0.5, com=(0.03, 0, 0), inertia=INERTIA)
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper, **more)
    scene.joint("elbow", cd.Revolute((0, 3, 4)), upper.at(0, 0.1, -0.6), lower)
    scene.joint("slide", cd.Prismatic("z"), lower.at(0.1, 0, -0.1), puck)
    return scene


def prescribed() -> cd.Scene:
    """A driven joint with a spring, a damper and a motor on it."""
    scene = arm("prescribed", prescribed=0.3 * sp.sin(2 * t) + 0.1)
    scene.force("spring", cd.JointSpring("shoulder", stiffness=4.0, rest=0.2))
    scene.force("damper", cd.JointDamper("shoulder", 0.7))
    scene.force("motor", cd.JointForce("shoulder", 3 * sp.cos(t)))
    scene.force("rotor", cd.Drive("shoulder", inertia=0.02, ratio=5.0, friction=0.1))
    return scene


def followed() -> cd.Scene:
    """A joint that follows a prescribed one, with friction, and one that follows a free one."""
    scene = arm("followed")
    wheel = scene.body("wheel", mass=1.0, com=(0.05, 0, 0.1), inertia=INERTIA)
    disc = scene.body("disc", mass=0.4, inertia=INERTIA)
    scene.joint("gear", cd.Gear("elbow", -1.5, "x", 0.1), scene.ground.at(1, 0, 0), wheel)
    scene.joint("belt", cd.Gear("gear", 0.5, "y"), wheel.at(0, 0.3, 0), disc)
    scene.force("brake", cd.JointDamper("gear", 0.3))
    scene.force("rotor", cd.Drive("belt", inertia=0.01, ratio=3.0, torque=0.2))
    return scene


def by_input() -> cd.Scene:
    """An input prescribes a joint, another one pushes."""
    scene = arm("by_input")
    length, push = scene.input("length", 0.1, unit="m"), scene.input("push", 2.5, unit="N")
    scene.joints["slide"] = dataclasses.replace(scene.joints["slide"], prescribed=length)
    scene.force("hand", cd.Force(scene.bodies["lower"].at(0, 0, -0.3), (push, 0, push * t)))
    return scene


def related() -> cd.Scene:
    """A relation of coordinates, one of frames that moves with time, one of speeds."""
    scene = arm("related")
    other = scene.body("other", mass=0.7, com=(0.1, 0, 0), inertia=INERTIA)
    scene.joint("table", cd.Planar("z"), scene.ground.at(0, 0, -1.5), other)
    tip = scene.bodies["lower"].at(0, 0, -0.4)
    scene.constraint("belt", scene.q("slide") - 0.2 * scene.q("elbow") ** 2)
    scene.constraint("height", tip.position()[2] + 0.9 + 0.05 * sp.sin(t))
    scene.constraint("skate", other.velocity(in_=other)[1], unit="m/s")
    return scene


def belted() -> cd.Scene:
    """A relation between coordinates: its force goes through the joints."""
    scene = arm("belted")
    scene.constraint("belt", scene.q("slide") - 0.2 * scene.q("elbow") ** 2)
    return scene


def measured() -> cd.Scene:
    """Feedback with a state, forces by expressions, outputs with accelerations and constants."""
    scene = arm("measured")
    gain = scene.parameter("gain", 4.0)
    lag = sp.Symbol("lag")
    feedback = cd.Controller(
        "elbow", states=(lag,), changes=(scene.q("elbow") - gain * lag,), force=-gain * lag
    )
    scene.force("feedback", feedback)
    tip = scene.bodies["puck"].at(0.1, 0, 0)
    drag = [-0.3 * v * sp.sqrt(1 + v**2) for v in tip.velocity()]
    scene.force("drag", cd.Force(tip, drag))
    scene.force("wind", cd.Torque(scene.bodies["upper"], (0, scene.u("elbow"), gain)))
    scene.output("height", tip.position()[2], unit="m")
    scene.output("felt", tip.acceleration()[0], unit="m/s^2")
    scene.output("state", scene.state("feedback.lag") * gain)
    scene.output("nothing", sp.Integer(0))
    return scene


SCENES: dict[str, Callable[[], cd.Scene]] = {
    scene.__name__: scene for scene in (prescribed, followed, by_input, belted, related, measured)
}
# forces of relations act on the bodies here, not along the joints
GUIDED = {"related"}


@pytest.fixture(scope="module", params=SCENES)
def state(request: pytest.FixtureRequest) -> State:
    """A scene at a state that its relations allow."""
    equations = cd.derive(SCENES[request.param]())
    own, system = both(equations), equations.system
    rng = np.random.default_rng(11)
    q, u = (rng.uniform(0.1, 0.6, n) for n in (system.nq, system.nu))
    if system.closed:
        for _ in range(20):
            q = own.call("close_position", q=q, u=u)["q"]
        u = own.call("close_velocity", q=q, u=u)["u"]
    return own.at(q, u)


def test_accelerations_and_reactions(state: State) -> None:
    mine, other = state.accelerations()
    bound = ROUNDING * state.solved[2]
    assert np.abs(mine - other).max() < bound * (1 + np.abs(other).max())
    if state.both.relative.system.name in GUIDED:
        return
    wrenches, expected = state.reactions()
    for joint, wrench in wrenches.items():
        size = 1 + np.abs(expected[joint]).max()
        assert np.abs(wrench - expected[joint]).max() < bound * size, joint


def test_multipliers_of_relations(state: State) -> None:
    relations = [entry.name for entry in state.both.relative.system.constraints]
    if not relations:
        assert not state.both.relative.multipliers
        return
    lam = state.both.call("multipliers", q=state.q, u=state.u)["lam"]
    for name in relations:
        expected = lam[state.both.relative.multipliers.index(name)]
        found = state.solved[1][state.both.absolute.multipliers.index(name)]
        assert abs(found - expected) < ROUNDING * state.solved[2] * (1 + np.abs(lam).max())


@pytest.mark.parametrize("function", ["outputs", "power"])
def test_outputs_and_powers(state: State, function: str) -> None:
    """By name: the driving forces too."""
    relative, scene = state.both.relative, state.both.absolute
    expected = state.both.call(function, q=state.q, u=state.u)[function]
    entries = relative.function(function).outputs[0].entries
    named = dict(zip(entries, expected, strict=True))
    names = scene.outputs if function == "outputs" else scene.powers
    found = dict(zip(names, state.reference.listed(function, *state.solved[:2]), strict=True))
    if function == "outputs":
        assert set(found) == set(named)
    size = 1 + max(map(abs, named.values()), default=0)
    for name, value in named.items():
        assert abs(found.get(name, 0.0) - value) < ROUNDING * state.solved[2] * size, name
