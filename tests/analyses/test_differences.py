"""Implicit methods on large models: derivatives by differences lead to the same motion."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.analyses.simulation import driving
from mechanisms.chain import chain
from mechanisms.closed import CLOSED


def pushed() -> cd.Scene:
    """A top on a stiff bush that inputs turn: one of time, one that feeds back."""
    scene = cd.Scene("pushed", gravity=(0, 0, -9.81))
    rider = scene.body("rider", mass=0.5, com=(0, 0, 0), inertia=(0.01, 0.01, 0.02))
    top = scene.body("top", mass=1.0, com=(0, 0, 0.3), inertia=(0.1, 0.1, 0.02))
    scene.joint("bush", cd.Prismatic("x"), scene.ground, rider)
    scene.joint("ball", cd.Spherical(), rider, top)
    scene.force("spring", cd.JointSpring("bush", stiffness=1e5, damping=50.0))
    scene.force("push", cd.JointForce("bush", scene.input("push")))
    scene.force("brake", cd.JointForce("bush", scene.input("brake")))
    return scene


SCENES: dict[str, Any] = {
    "pushed": (
        pushed,
        {
            "u": {"ball": [1.0, 0.3, 40.0]},
            "inputs": {
                "push": (np.linspace(0, 1, 5), np.array([0.0, 30.0, -20.0, 10.0, 0.0])),
                "brake": lambda t, x: -5.0 * x[5] * (1 + np.sin(3 * t)),
            },
        },
    ),
    "four_bar": (CLOSED["four_bar"].build, {"u": {"A": 2.0}}),
}
METHODS = [
    *((name, scene) for scene in SCENES for name in ("Rosenbrock", "Radau")),
    ("GeneralizedAlpha", "pushed"),
    ("HHT", "four_bar"),
]


@pytest.mark.parametrize(("method", "scene"), METHODS)
def test_same_motion(method: str, scene: str, monkeypatch: pytest.MonkeyPatch) -> None:
    build, start = SCENES[scene]
    how: dict[str, Any] = {"method": method, "rtol": 1e-7, "atol": 1e-9, **start}
    model = cd.compile(build())
    monkeypatch.setattr(driving, "LARGE", 0)
    found = model.simulate(0.5, **how)
    assert "by differences" in repr(found)
    monkeypatch.undo()
    known = model.simulate(0.5, **how)
    assert "by differences" not in repr(known)
    # both within the tolerance; with the same steps but for some
    assert found.statistics["steps"] == pytest.approx(known.statistics["steps"], rel=0.02)
    np.testing.assert_allclose(found.x[-1], known.x[-1], rtol=1e-5, atol=1e-6)


def test_what_counts_as_large() -> None:
    manifest = cd.compile(chain(10)).manifest
    assert driving.speed_pairs(manifest) == 10 * 10
    # a slide and a ball
    assert driving.speed_pairs(cd.compile(pushed()).manifest) == 4 * 4


@pytest.mark.parametrize("method", ["Radau", "HHT"])
def test_large_models_need_not_derive(method: str) -> None:
    model = cd.compile(chain(60))
    motion = model.simulate(0.05, method=method, rtol=1e-5)
    assert motion.success
    assert "by differences as the model is large" in repr(motion)
    known = model.simulate(0.05, rtol=1e-9)
    np.testing.assert_allclose(motion.q[-1], known.q[-1], rtol=0, atol=1e-3)
