"""Models that the tests of simulations share."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import pytest

import cardan as cd
from analyses.interpreted import without_compiler


def double_scene() -> cd.Scene:
    """A planar double pendulum of rods, damped at the elbow, with a torque at the shoulder."""
    scene = cd.Scene("double", gravity=(0, 0, -9.81))
    rod = cd.inertia.rod(1.0, 0.5, axis="z")
    upper = scene.body("upper", mass=1.0, com=(0, 0, -0.25), inertia=rod)
    lower = scene.body("lower", mass=1.0, com=(0, 0, -0.25), inertia=rod)
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper, q0=0.1)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -0.5), lower)
    torque = scene.input("torque")
    scene.force("motor", cd.JointForce("shoulder", torque))
    scene.output("height", lower.position()[2])
    return scene


@pytest.fixture(scope="module")
def double() -> cd.CompiledModel:
    return cd.compile(double_scene())


@pytest.fixture(scope="module")
def ball() -> cd.CompiledModel:
    """A spinning body on a floating base: quaternion and position."""
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=2.0, com=(0, 0, 0), inertia=(0.1, 0.2, 0.25))
    scene.joint("base", cd.Free(), scene.ground, body)
    return cd.compile(scene)


@pytest.fixture(scope="module")
def crank() -> cd.CompiledModel:
    """A hinge moved by an input, with a free pendulum on it."""
    scene = cd.Scene("crank", gravity=(0, 0, -9.81))
    wheel = scene.body("wheel", mass=1.0, com=(0, 0, 0), inertia=(0.1, 0.1, 0.1))
    rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("drive", cd.Revolute("y"), scene.ground, wheel, prescribed=scene.input("angle"))
    scene.joint("hinge", cd.Revolute("y"), wheel.at(0.3, 0, 0), rod)
    return cd.compile(scene)


@pytest.fixture
def bare(monkeypatch: pytest.MonkeyPatch) -> Callable[[cd.CompiledModel], cd.CompiledModel]:
    """A model as it is opened on a machine without any compiler."""
    return partial(without_compiler, monkeypatch=monkeypatch)
