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


@pytest.mark.parametrize("coordinates", ["auto", "absolute"])
def test_two_sided_stops_of_beams_verify(coordinates: str) -> None:
    """A joint is never at both its stops: impacts of both at once are none to be judged."""
    scene = cd.Scene("arm")
    dural = cd.material(E=7e10, nu=0.3, rho=2700)
    strip = cd.section.rectangle(0.03, 0.002)
    beam = scene.beam("beam", scene.ground, (0.8, 0, 0), strip, dural, elements=2)
    hand = scene.body("hand", mass=0.3, com=(0.05, 0, 0.02), inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("wrist", cd.Revolute("y"), beam.end, hand)
    scene.force("stop", cd.Stop("wrist", lower=-0.3, upper=0.3, restitution=0.4))
    model = cd.compile(scene, coordinates=coordinates)
    assert "transition" in str(model.verify())
    motion = model.simulate(0.2, u={"wrist": 5.0})
    struck = motion.events[0]
    q, before = model.split(struck.x)
    impulse = model.mass_matrix(q) @ (model.split(struck.x_after)[1] - before)
    if coordinates == "auto":
        others = np.delete(impulse, model.speeds.index("wrist.u"))
        assert np.abs(others).max() < 1e-9 * np.abs(impulse).max()
