"""Many superelements on one body: what one adds does not grow with their number."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import cardan as cd
from superelements.components import brick


@cache
def booms(count: int, frame: str = "root") -> Any:
    """A free hub with so many."""
    scene = cd.Scene("booms", gravity=(0, 0, 0))
    hub = scene.body("hub", 5.0, inertia=(1.0, 1.0, 1.0))
    scene.joint("free", cd.Free(), scene.ground, hub)
    for k in range(count):
        scene.superelement(f"boom{k}", brick(modes=4), {"root": hub}, frame=frame)
    return cd.compile(scene)


def test_factors_grow_with_their_number_alone() -> None:
    sizes = [booms(count)._source.results(booms(count)).mesh.plan.factors for count in (2, 4, 8)]
    assert sizes[2] - sizes[1] == 2 * (sizes[1] - sizes[0])


@pytest.mark.parametrize("frame", ["root", "mean"])
def test_frames_at_many_states_are_those_of_single_ones(frame: str) -> None:
    model, rng = booms(2, frame), np.random.default_rng(0)
    u = rng.standard_normal((3, model.nu))
    udot = rng.standard_normal((3, model.nu))
    q = np.array([model.integrate(model.simulate(1e-9).q[0], 0.1 * row) for row in u])
    for name in ("hub", "boom0.tip", "boom1.root"):
        together = model.pose(name, q), model.velocity(name, q, u)
        third = model.acceleration(name, q, u, udot)
        for k in range(3):
            np.testing.assert_array_equal(together[0][k], model.pose(name, q[k]))
            np.testing.assert_array_equal(together[1][k], model.velocity(name, q[k], u[k]))
            alone = model.acceleration(name, q[k], u[k], udot[k])
            np.testing.assert_array_equal(third[k], alone)
