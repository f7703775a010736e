"""A geared scene: joints without slots in the state, wrenches on the ground, masses set later."""

from __future__ import annotations

import numpy as np
import pytest
import sympy

import cardan as cd


def geared() -> cd.Scene:
    scene = cd.Scene("geared", gravity=(0, 0, -9.81))
    inertia = (0.1, 0.1, 0.1)
    base = scene.body("base", mass=3, inertia=inertia)
    slide = scene.body("slide", mass=1, inertia=inertia)
    arm = scene.body("arm", mass=1, com=(0.3, 0, 0), inertia=inertia)
    hand = scene.body("hand", mass=0.5, com=(0.2, 0, 0), inertia=inertia)
    scene.joint("bolt", cd.Fixed(), scene.ground, base)
    scene.joint("rail", cd.Prismatic("x"), base, slide, prescribed=0.2 * sympy.sin(3 * cd.t))
    scene.joint("elbow", cd.Revolute("y"), slide, arm)
    scene.joint("wrist", cd.Revolute("y"), arm.at(0.6, 0, 0), hand, couple=("elbow", -2.0, 0.3))
    return scene


def test_coupled_and_prescribed_joints_have_histories() -> None:
    motion = cd.compile(geared()).simulate(1.0, q={"elbow": 0.4})
    np.testing.assert_allclose(motion["wrist"], -2 * motion["elbow"] + 0.3, rtol=1e-15)
    np.testing.assert_allclose(motion["wrist.u"], -2 * motion["elbow.u"], rtol=1e-15)
    np.testing.assert_allclose(motion["rail"], 0.2 * np.sin(3 * motion.t), rtol=1e-14)
    np.testing.assert_allclose(motion["rail.u"], 0.6 * np.cos(3 * motion.t), rtol=1e-14)


def test_a_wrench_on_the_ground_is_not_lost_in_silence() -> None:
    model = cd.compile(geared())
    push = {"base": [0, 0, 0, 0, 0, 10.0]}
    # it moves nothing, so the reaction of a moving joint does not know it
    assert np.isfinite(model.reaction("elbow", [0.1], [0.0], wrenches=push)).all()
    with pytest.raises(cd.ModelError, match=r"reaction\('bolt'\).*'base'.*fixed to the ground"):
        model.reaction("bolt", [0.1], [0.0], wrenches=push)


def test_a_negative_mass_is_refused_later_too() -> None:
    model = cd.compile(geared())
    with pytest.raises(cd.ModelError, match=r"'arm.mass' is a mass and cannot be -1 kg"):
        model.with_parameters({"arm.mass": -1.0})
