"""Motions that excite: within limits, and with more to tell than where they began."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd

ARM = Path(__file__).parents[2] / "examples" / "arm.urdf"


@cache
def arm() -> Any:
    return cd.compile(cd.load(ARM))


def test_excitation_keeps_limits_and_improves() -> None:
    model = arm()
    options: dict[str, Any] = {"position": {"waist": (-1.0, 0.5)}, "acceleration": {"elbow": 20.0}}
    found = model.excitation(5.0, harmonics=4, speed=2.5, steps=8, seed=2, **options)
    again = model.excitation(5.0, harmonics=4, speed=2.5, steps=8, seed=2, **options)
    assert np.array_equal(found.series.a, again.series.a)
    assert found.condition < 0.95 * found.before
    q, u, udot = found.at(np.linspace(0, 5, 20001))
    assert np.all(q > [-1.0, -2.5, -2.8])
    assert np.all(q < [0.5, 2.5, 2.8])
    assert np.abs(u).max() < 2.5
    assert np.abs(udot[:, 2]).max() < 20.0
    # rates are those of the motion
    assert np.allclose(np.gradient(q, 5 / 20000, axis=0)[5:-5], u[5:-5], atol=1e-5)
    assert np.allclose(np.gradient(u, 5 / 20000, axis=0)[5:-5], udot[5:-5], atol=1e-4)
    assert f"{found.before:.4g} -> {found.condition:.4g}" in repr(found)
    # the condition is that of the regressor of the base parameters with columns of length 1
    motion = found.motion(4 * 12 / 5)
    rows = found.base.regressor(model.regressor(motion["q"], motion["u"], motion["udot"]))
    efforts = np.array([1.0, 80.0, 40.0])
    flat = (rows / efforts[:, None]).reshape(-1, len(found.base))
    assert found.condition == pytest.approx(
        np.linalg.cond(flat / np.linalg.norm(flat, axis=0)), rel=1e-6
    )


def test_determinant_as_criterion() -> None:
    found = arm().excitation(5.0, speed=2.5, criterion="determinant", steps=5, starts=5)
    first = arm().excitation(5.0, speed=2.5, criterion="determinant", steps=0, starts=5)

    def information(one: Any) -> float:
        motion = one.motion(60 / 5)
        rows = one.base.regressor(arm().regressor(motion["q"], motion["u"], motion["udot"]))
        flat = (rows / np.array([1.0, 80.0, 40.0])[:, None]).reshape(-1, len(one.base))
        return float(np.linalg.slogdet(flat.T @ flat)[1])

    assert information(found) > information(first) + 0.1
