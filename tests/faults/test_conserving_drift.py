"""The energy-momentum method about a point where a body is held by its own frame."""

from __future__ import annotations

import functools

import numpy as np
import pytest

import cardan as cd
from table import each

DURATION, ROWS = 5.0, 50
# roundings of 1e4 steps, each of some eps, as a random walk: 1e-14; with a margin
DRIFT = 1e-13
MASS, ARM, GRAVITY = 1.5, np.array([0.05, 0.02, 0.3]), 9.81


@functools.cache
def top() -> cd.CompiledModel:
    """A top whose frame stands at the pivot and whose center of mass does not."""
    scene = cd.Scene("offset_top", gravity=(0, 0, -GRAVITY))
    body = scene.body("top", mass=MASS, com=tuple(ARM), inertia=(0.02, 0.025, 0.012))
    scene.joint("ball", cd.Spherical(), scene.ground, body)
    return cd.compile(scene, coordinates="absolute")


@each("step", [5e-4, 1e-3, 2e-3, 4e-3])
@each("spin", [(0.1, 0.2, 5.0), (1.0, 2.0, 60.0)])
def test_b11_energy_is_kept_at_any_step(step: float, spin: tuple[float, float, float]) -> None:
    """Multipliers that move nothing grew with the angle since the last tangent, over all bounds."""
    model = top()
    t = (np.linspace(0, DURATION, ROWS + 1) / 4e-3).round() * 4e-3
    motion = model.simulate(t, u={"ball": spin}, step=step, method="EnergyMomentum")
    assert motion.success, motion.message
    energies = np.array([model.energy(q, u) for q, u in zip(motion.q, motion.u, strict=True)])
    drift = np.abs(energies[:, 2] - energies[0, 2]).max() / energies[:, 0].max()
    print(f"step {step:g}: energy {drift:.1e}")
    assert drift < DRIFT
    assert motion.statistics["rejections"] == 0


@pytest.mark.parametrize("step", [2.5e-4, 1e-3])
def test_b11_generalized_alpha_finds_the_same_forces(step: float) -> None:
    """The same there: a matrix served while the body turned on, and the run ended unsolved."""
    model, t, begin = top(), np.linspace(0, 2, 11), {"ball": (0.1, 0.2, 5.0)}
    names = ("ball.px", "ball.py", "ball.pz")
    forces = []
    for method, how in (("DOP853", {"rtol": 1e-11}), ("GeneralizedAlpha", {"step": step})):
        motion = model.simulate(t, u=begin, method=method, **how)
        assert motion.success, motion.message
        forces.append(np.array([motion.multipliers[name] for name in names]))
    missed = np.abs(forces[1] - forces[0]).max() / np.abs(forces[0]).max()
    print(f"step {step:g}: forces missed by {missed:.1e}")
    # of what the last correction leaves: the forces turn by 5e-3 in a step of 1 ms
    assert missed < 2e-3
