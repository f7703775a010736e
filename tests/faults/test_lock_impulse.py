"""A lock alone had no impulse in its transition; the projection behind it took the speed."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from laws.event_scenes import latch


def test_the_transition_of_a_lock_takes_the_speed_by_an_impulse() -> None:
    model = cd.compile(latch()[0])
    q, u = np.array([0.3, 0.2]), np.array([0.5, -0.8])
    fired = np.array([float(name == "latch.lock") for name in model.event_names])
    behind = model.transition(q, u, fired)[:2]
    M = model.mass_matrix(q)
    impulse = -u[1] / np.linalg.inv(M)[1, 1]
    assert behind == pytest.approx(u + np.linalg.solve(M, [0.0, impulse]), abs=1e-13)
    assert abs(behind[1]) < 1e-13
