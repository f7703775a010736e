"""Four-bar, slider-crank and parallelogram against their closed forms."""

from __future__ import annotations

import json
import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from mechanisms.closed_planar import four_bar, parallelogram, slider_crank

HERE = Path(__file__).parent


def reference(name: str) -> dict[str, Any]:
    return json.loads((HERE / f"{name}.json").read_text(encoding="utf-8"))


def test_four_bar_kinematics() -> None:
    known = reference("fourbar_kinematics")
    p, rows = known["parameters"], known["reference"]
    model = cd.compile(four_bar(p["ground"], p["crank"], p["coupler"], p["rocker"]))
    angles = np.radians([row["theta2_deg"] for row in rows])
    rate = float(known["initial_state"]["omega2"])
    found = model.sweep("A", angles, rate=rate, branch={"D": "+"})

    def column(name: str) -> np.ndarray:
        return np.array([row[name] for row in rows])

    # angles of the coupler count from the crank here, from the ground there
    coupler = {end: found[f"A{end}"] + found[f"B{end}"] for end in ("", ".u", ".udot")}
    tolerance = float(known["tolerance"])
    np.testing.assert_allclose(coupler[""], column("theta3"), rtol=0, atol=tolerance)
    np.testing.assert_allclose(found["D"], column("theta4"), rtol=0, atol=tolerance)
    np.testing.assert_allclose(coupler[".u"], column("w3"), rtol=0, atol=rate * tolerance)
    np.testing.assert_allclose(found["D.u"], column("w4"), rtol=0, atol=rate * tolerance)
    square = rate**2 * tolerance
    np.testing.assert_allclose(coupler[".udot"], column("a3"), rtol=0, atol=square)
    np.testing.assert_allclose(found["D.udot"], column("a4"), rtol=0, atol=square)


def start(a: float, b: float, theta: float, joints: tuple[str, ...]) -> dict[str, float]:
    """Coordinates of an in-line slider-crank."""
    rod = math.asin(-a * math.sin(theta) / b)
    place = a * math.cos(theta) + b * math.cos(rod)
    every = {"A": theta, "B": rod - theta, "guide": place, "C": -rod}
    return {name: value for name, value in every.items() if name in joints}


def test_slider_crank_dead_points() -> None:
    a, b, theta = 0.1, 0.3, -0.5
    model = cd.compile(slider_crank(a, b))
    near = start(a, b, theta, model.coordinates)
    over = (theta, theta + 2 * math.pi)
    found = model.singular_positions("A", over, driver="guide", start=near)
    # driven at the slider: dead where crank and rod are in line; no other singular position
    assert [p.kind for p in found.positions] == ["dead point"] * 2
    np.testing.assert_allclose(found.values(), [0, math.pi], rtol=0, atol=1e-9)
    for one, place in zip(found.positions, (a + b, b - a), strict=True):
        guide = one.q[model.coordinates.index("guide")]
        assert guide == pytest.approx(place, abs=1e-12)


def test_slider_crank_of_equal_links_branches_over_its_pivot() -> None:
    a = b = 0.2
    model = cd.compile(slider_crank(a, b))
    near = start(a, b, -1.2, model.coordinates)
    found = model.singular_positions("A", (-1.2, 2.0), driver="guide", start=near)
    # the slider sits on the pivot at +- 90 degrees: only there do the constraints lose rank
    branch = [p for p in found.positions if p.kind == "branch point"]
    np.testing.assert_allclose([p.value for p in branch], [math.pi / 2], rtol=0, atol=1e-6)
    assert branch[0].q[model.coordinates.index("guide")] == pytest.approx(0, abs=1e-6)
    np.testing.assert_allclose(found.values(), [0], rtol=0, atol=1e-9)


@pytest.mark.parametrize("treatment", ["multipliers", "elimination", "null_space"])
def test_parallelogram_through_its_singular_positions(treatment: str) -> None:
    """20 s, 20 times through positions at which any crank could turn either way.

    The error must become smaller with the tolerance, however tight that is.
    """
    known = reference("iftomm_A02_fourbar_N2")["reference"]["B0"]
    model = cd.compile(cd.derive(parallelogram(), constraints=treatment))
    up = {"A0": 1, "A1": 1, "A2": 1, "B0": -1, "B1": -1, "C0": 1, "C1": 1}
    q = {name: up[name] * math.pi / 2 for name in model.coordinates}
    errors = []
    for rtol in (1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12):
        times = np.array([0.0, *known["t"]])
        motion = model.simulate(times, q=q, u={"A0": -1.0}, rtol=rtol, atol=1e-2 * rtol, check=True)
        tip = np.stack([np.cos(motion["A0"]), np.sin(motion["A0"])], axis=1)[1:]
        errors.append(np.abs(tip - np.stack([known["x"], known["y"]], axis=1)).max())
        assert motion.statistics["passed"] == 20
        # all cranks stay parallel: no other branch was taken
        assert np.abs(motion["A2"] - motion["A0"]).max() < 1e-8
        assert motion.ledger is not None
        worst = [w.after for w in motion.drift.position.values()]
        assert max(worst) < 1e-10
    print(f"{treatment}: errors {errors}")
    assert all(fine < coarse for coarse, fine in pairwise(errors))
    # magnified by the motion a thousandfold in 20 s
    assert errors[0] < 1e-2
    assert errors[4] < 1e-7
    assert errors[6] < 1e-9


def test_slider_crank_runs_through_its_branch_points() -> None:
    """Links of one length: at +- 90 degrees the slider could as well stay on the pivot."""
    a = 0.2
    model = cd.compile(slider_crank(a, a))
    near, drifts = start(a, a, 0.3, model.coordinates), []
    for rtol in (1e-6, 1e-8, 1e-10, 1e-12):
        motion = model.simulate(5.0, q=near, u={"A": 8.0}, rtol=rtol, atol=1e-2 * rtol, check=True)
        assert motion["A"][-1] > 20
        np.testing.assert_allclose(motion["guide"], 2 * a * np.cos(motion["A"]), rtol=0, atol=1e-9)
        drifts.append(np.abs(motion.energy_residual).max() / motion.energy.kinetic.max())
    # a hundredth of the tolerance: a hundredth of the error, give or take a factor of ten
    assert all(fine < 0.1 * coarse for coarse, fine in pairwise(drifts))
