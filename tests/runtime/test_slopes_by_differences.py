"""Derivatives by differences of numbers far from 0: how well they are known."""

from __future__ import annotations

import numpy as np

from cardan.arrays import Array
from cardan.runtime.verification.constraints import EPS, TRUSTED, slope

ROWS, FAR = 20_000, 1e4


def test_what_far_places_round_by_is_known() -> None:
    rng = np.random.default_rng(1)
    place, speed = rng.uniform(-FAR, FAR, ROWS), rng.uniform(-1, 1, ROWS)

    def moved(times: Array) -> Array:
        return place + np.sin(times)[:, None] * speed

    derivative, doubt = slope(moved, EPS * FAR)
    assert (np.abs(derivative - speed) <= TRUSTED * doubt).all()
    # and no worse than places a step apart let it be known
    assert doubt.max() < 1e-7
    # two steps agree by chance in some rows of so many: their difference alone promises too much
    derivative, doubt = slope(moved)
    assert (np.abs(derivative - speed) > TRUSTED * doubt).any()
