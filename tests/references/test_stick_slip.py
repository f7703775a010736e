"""A block on a belt: the limit cycle of stick and slip.

Reference: R. I. Leine, D. H. van Campen, A. de Kraker, L. van den Steen, Nonlinear Dynamics 16
(1998) 41-54; values computed independently with located events (30 digits agree to 1e-8).
"""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

import cardan as cd

BELT, STATIC, FALL = 0.2, 1.0, 3.0
SLIP, STICK, PERIOD = 4.295999526464542, 7.705031769318218, 12.00103129578276
HIGHEST, LOWEST, SLOWEST = 1.1339446764381613, -0.5554326900551189, -0.8399020492765663
END_OF_SLIP = -0.5410063538636437


def test_limit_cycle() -> None:
    scene = cd.Scene("stick_slip", gravity=(0, 0, 0))
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    scene.force("spring", cd.JointSpring("x", stiffness=1.0))
    law = STATIC / (1 + FALL * sp.Abs(scene.u("x") - BELT))
    scene.force("belt", cd.Friction("x", coulomb=law, static=STATIC, against=BELT))
    motion = cd.compile(scene).simulate(40.0, q={"x": 0.0}, u={"x": BELT}, rtol=1e-11, atol=1e-12)
    slips = np.array([event.t for event in motion.events if event.name == "belt.slip"])
    stops = np.array([event.t for event in motion.events if event.name == "belt.stop"])
    assert np.diff(slips) == pytest.approx(PERIOD, abs=1e-8)
    assert stops - slips[: len(stops)] == pytest.approx(SLIP, abs=1e-8)
    assert slips[1:] - stops[: len(slips) - 1] == pytest.approx(STICK, abs=1e-8)
    assert motion.at(stops[0])[0] == pytest.approx(END_OF_SLIP, abs=1e-8)
    # extremes between the steps
    fine = motion.at(np.linspace(slips[0], slips[1], 200_001))
    assert fine[:, 0].max() == pytest.approx(HIGHEST, abs=1e-8)
    assert fine[:, 0].min() == pytest.approx(LOWEST, abs=1e-8)
    assert fine[:, 1].min() == pytest.approx(SLOWEST, abs=1e-8)
    assert np.abs(motion.energy_residual).max() < 1e-10
