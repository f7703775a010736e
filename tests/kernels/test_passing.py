"""Places where branches meet, on a motion with known branches: y = x and y = -x."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cardan.errors import SolveWarning
from cardan.schema.integrators import INTEGRATORS
from kernels.problem import Problem

POSITION = """
    real g = q[1] * q[1] - q[0] * q[0], rr = 4 * (q[0] * q[0] + q[1] * q[1]);
    real share = rr > 0 ? g / rr : 0;
    out[0] = q[0] + 2 * q[0] * share; out[1] = q[1] - 2 * q[1] * share; out[2] = g;
"""
VELOCITY = """
    real rate = 2 * (q[1] * u[1] - q[0] * u[0]), rr = 4 * (q[0] * q[0] + q[1] * q[1]);
    real share = rr > 0 ? rate / rr : 0;
    out[0] = u[0] + 2 * q[0] * share; out[1] = u[1] - 2 * q[1] * share; out[2] = rate;
"""
# g = y^2 - x^2; what is off the branch grows with the inverse of the distance
SMOOTH = """
    real off = q[0] != 0 ? (u[0] - u[1]) / q[0] : 0;
    out[0] = u[0]; out[1] = u[1]; out[2] = cos(3 * t) - off; out[3] = cos(3 * t) + off;
"""
# behind x = 0 it goes on along the other branch: no motion is continuous there
BROKEN = "out[0] = u[0]; out[1] = q[0] < 0 ? u[0] : -u[0]; out[2] = out[3] = 0;"
ROW = ({"name": "cross.g", "unit": "N", "joint": "cross", "level": "position"},)
ADAPTIVE = ["DOP853", "RK45", "Radau", "Rosenbrock"]


def crossing(folder: Path, rhs: str) -> Problem:
    return Problem(
        folder,
        rhs=rhs,
        position=POSITION,
        velocity=VELOCITY,
        held="out[0] = -2 * q[0]; out[1] = 2 * q[1];",
        multipliers=ROW,
        nq=2,
        nu=2,
    )


@pytest.mark.parametrize("method", ADAPTIVE)
def test_the_branch_is_kept(method: str, tmp_path: Path) -> None:
    assert method in INTEGRATORS
    start = [-0.97, -0.97, 1.0, 1.0]
    end = -0.97 + 2 + (1 - np.cos(6)) / 9
    for rtol in (1e-6, 1e-8, 1e-10):
        options: dict[str, Any] = {"method": method, "rtol": rtol, "atol": 1e-2 * rtol}
        motion = crossing(tmp_path, SMOOTH).run((0.0, 2.0), start, **options)
        assert motion.success
        assert motion.statistics["passed"] == 1
        np.testing.assert_allclose(motion.q[-1], [end, end], rtol=0, atol=20 * rtol)


def test_a_motion_that_would_change_its_branch_is_stopped(tmp_path: Path) -> None:
    said = r"at t = (0\.9\d+|1) s of 2 s: motion is not defined here: joint 'cross' .*branch"
    with pytest.warns(SolveWarning, match=said):
        motion = crossing(tmp_path, BROKEN).run(2.0, [-1.0, -1.0, 1.0, 1.0], rtol=1e-8)
    assert motion.status == "not_closed"
    # never behind the place
    assert (motion.q[:, 0] < 0).all()
    assert motion.t[-1] > 0.9
