"""Chains that come to rest against several stops at once: impacts take energy, and they end."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from spread import some


def chain(seed: int) -> cd.Scene:
    """Four links that hang on each other, with stops at every joint."""
    rng = np.random.default_rng(seed)
    scene = cd.Scene(f"chain {seed}", gravity=(0, 0, -9.81))
    parent: cd.Body | cd.Frame = scene.ground
    for k in range(4):
        inertia = np.diag(rng.uniform(0.05, 0.3, 3))
        com = (*rng.uniform(-0.2, 0.2, 2), -0.3)
        link = scene.body(f"link{k}", mass=rng.uniform(0.5, 2), com=com, inertia=inertia)
        scene.joint(f"joint{k}", cd.Revolute(tuple(rng.normal(size=3))), parent, link)
        scene.force(f"damper{k}", cd.JointSpring(f"joint{k}", damping=0.3))
        lower, upper = -rng.uniform(0.1, 0.6), rng.uniform(0.1, 0.6)
        scene.force(f"stop{k}", cd.Stop(f"joint{k}", lower=lower, upper=upper))
        parent = link.at(*rng.uniform(-0.2, 0.2, 2), -0.6)
    return scene


# in 0, 6 and 8 two joints struck each other off their stops without end
SLOW = [k for k in range(12) if k not in (0, 6, 8)]


@pytest.mark.parametrize("seed", [0, 6, 8, *some(SLOW, len(SLOW))])
def test_impacts_on_several_stops_come_to_an_end(seed: int) -> None:
    scene = chain(seed)
    motion = cd.compile(scene).simulate(10.0)
    assert motion.success
    total = motion.energy.total
    assert np.diff(total).max() < 1e-9 * np.ptp(total)
    assert np.abs(motion.energy_residual).max() < 1e-5
    for k in range(4):
        stop, values = scene.forces[f"stop{k}"].element, motion[f"joint{k}"]
        assert values.min() > stop.lower - 1e-6
        assert values.max() < stop.upper + 1e-6
