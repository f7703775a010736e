"""A loop through a prescribed joint and a relation in its coordinate."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd

from .driven_scenes import SCENES

TREATMENTS = (
    "multipliers", "closed_form", "elimination", "null_space", "baumgarte", "penalty", "augmented",
    "perturbed",
)  # fmt: skip
EXACT = TREATMENTS[:5]
TIMES = np.linspace(0.0, 0.2, 5)


@pytest.mark.parametrize("treatment", TREATMENTS)
@pytest.mark.parametrize("name", SCENES)
def test_every_treatment_of_a_driven_loop_is_approved(name: str, treatment: str) -> None:
    """Whatever states the judge draws, singular positions among them, it agrees."""
    scene = SCENES[name]
    model = cd.compile(scene.build("coordinates"), constraints=treatment)
    names = ("forward_dynamics", "energy", "power", "multipliers", "constraint_rates")
    model.prepare(*(n for n in names if n in model.manifest.available))
    for seed in range(1, 13):
        assert model.verify(seed=seed).worst < 1e-9
    if treatment not in EXACT:
        return
    motion = model.simulate(TIMES, rtol=1e-10, atol=1e-12)
    start, rate = scene.drive
    at = start + rate * TIMES
    assert motion["left"] == pytest.approx(-at, abs=1e-9)
    assert motion["knee_right"] == pytest.approx(-scene.leans(at), abs=1e-8)
    assert np.abs(motion.energy_residual).max() < 1e-9
    total = sum(motion.work[key] for key in motion.work)
    expected = scene.energy(TIMES) - scene.energy(0.0)
    assert total == pytest.approx(expected, abs=1e-8)
