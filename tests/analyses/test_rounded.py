"""Over-constrained loops of rounded lengths: assembled, run and told alike."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import cardan as cd
from mechanisms.closed_spatial import AXES, CORNERS, G, bricard


def rounded(digits: int) -> cd.CompiledModel:
    """Bricard's mechanism with corners that are off by their last digit."""
    off = np.random.default_rng(2).uniform(-1, 1, CORNERS.shape) * 10.0**-digits
    corners, scene = CORNERS + off, cd.Scene("rounded", gravity=(0, -G, 0))
    place = scene.ground
    for k, body in enumerate(bricard().bodies.values()):
        rod = scene.body(
            body.name,
            mass=body.mass,
            com=body.com,
            inertia=body.inertia[::3][:2] + body.inertia[5:],
        )
        scene.joint(f"J{k}", cd.Revolute(AXES[k]), place, rod)
        place = rod.at(*(corners[k + 1] - corners[k]))
    scene.joint("J5", cd.Revolute(AXES[5]), place, scene.ground.at(*corners[5]))
    return cd.compile(scene)


@pytest.mark.parametrize("digits", [8, 10])
def test_rounded_lengths_move(digits: int) -> None:
    model, exact = rounded(digits), cd.compile(bricard())
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        found = model.assemble({"J0": 0.3}, u={"J0": 1.0})
        motion = model.simulate(1.0, q={"J0": 0.3}, rtol=1e-6)
    told = [str(w.message) for w in said]
    # what the eye can see is told, in assembly and in the run
    assert sum("disagree by that much, as rounded lengths" in one for one in told) == (
        2 if digits == 8 else 0
    )
    assert motion.success
    assert found["J2.u"] == pytest.approx(1.0, abs=1e-6)
    expected = exact.simulate(1.0, q={"J0": 0.3}, rtol=1e-6)
    np.testing.assert_allclose(motion.q[-1], expected.q[-1], rtol=0, atol=1e-4)
    residual = np.abs(model.constraints(motion.q)).max()
    between = np.abs(model.constraints(model.split(motion.at([0.31, 0.77]))[0])).max()
    assert max(residual, between) < 100 * 10.0**-digits
    assert model.redundancy(found.q).redundant == 1


def test_lengths_that_are_too_coarse_say_what_helps() -> None:
    model = rounded(3)
    with pytest.raises(cd.ModelError, match=r"least residual found .* up to 1e-07 of the size .*"):
        model.assemble({"J0": 0.3})


def test_exact_lengths_say_nothing() -> None:
    model = cd.compile(bricard())
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        motion = model.simulate(0.5, q={"J0": 0.3}, rtol=1e-8)
    assert np.abs(model.constraints(motion.q)).max() < 1e-11
