"""Redundant rows of loops over elements: zero ones, and those whose numbers cancel on the way."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from combinations.features import mechanism


@pytest.mark.parametrize("pair", [("loop", "second loop"), ("loop", "redundant loop")])
def test_several_loops_forgive_gaps_of_a_step(pair: tuple[str, str]) -> None:
    """Accelerations beside the constraints are off in proportion to what is open."""
    model = cd.compile(mechanism(pair).scene, coordinates="absolute")
    joints = cd.compile(mechanism(pair).scene, coordinates="relative")
    q, u = model.split(model.initial())
    closed = model.forward_dynamics(q, u)
    theirs = joints.forward_dynamics(*joints.split(joints.initial()))
    for k, speed in enumerate(joints.speeds):
        assert closed[model.speeds.index(speed)] == pytest.approx(theirs[k], abs=1e-6)
    rng = np.random.default_rng(3)
    for gap in (1e-10, 1e-8, 1e-6):
        for _ in range(4):
            moved = model.integrate(q, gap * rng.normal(size=model.nu))
            off = model.forward_dynamics(moved, u + gap * rng.normal(size=model.nu)) - closed
            assert np.abs(off).max() < 1e4 * gap


def test_rows_across_the_plane_of_a_loop_hold_nothing() -> None:
    """A loop between joints of a rigid tree beside a beam has rows of zeros."""
    accelerations = []
    for coordinates in ("auto", "absolute"):
        model = cd.compile(mechanism(("beam", "loop")).scene, coordinates=coordinates)
        q, u = model.split(model.initial())
        udot = model.forward_dynamics(q, u)
        accelerations.append([udot[model.speeds.index(f"{n}.u")] for n in ("shoulder", "A")])
    np.testing.assert_allclose(*accelerations, rtol=1e-9)


def test_a_named_start_of_a_beam_with_internal_states() -> None:
    """Beams are carried along from named joints, whatever states elements keep."""
    starts = []
    for coordinates in ("auto", "absolute"):
        model = cd.compile(mechanism(("beam", "Maxwell")).scene, coordinates=coordinates)
        motion = model.simulate(0.01, q={"shoulder": 0.5, "elbow": -0.2})
        starts.append([motion[name][0] for name in ("shoulder", "elbow", "tip_x", "tip_z")])
    np.testing.assert_allclose(*starts, atol=1e-8)
