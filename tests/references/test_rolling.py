"""Rolling without sliding: the steady circles of a coin, and the benchmark bicycle."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from table import each

HERE = Path(__file__).parent
BICYCLE = HERE.parents[1] / "src" / "cardan" / "scenes" / "bicycle.yaml"
EXACT = ("multipliers", "elimination", "null_space")


def reference(name: str) -> dict[str, Any]:
    return json.loads((HERE / f"{name}.json").read_text(encoding="utf-8"))


def coin(treatment: str) -> cd.CompiledModel:
    """A thin disk on the ground plane."""
    known = reference("coin_steady")["parameters"]
    m, r = known["m"], known["r"]
    scene = cd.Scene("coin", gravity=(0, 0, -known["g"]))
    disk = scene.body("disk", mass=m, inertia=(m * r**2 / 4, m * r**2 / 2, m * r**2 / 4))
    scene.joint("rolling", cd.RollingDisk(r), scene.ground, disk)
    return cd.compile(cd.derive(scene, constraints=treatment))


def steady(model: cd.CompiledModel, case: dict[str, float]) -> tuple[np.ndarray, np.ndarray]:
    """A state of steady rolling: yaw rate W, spin against the precessing axes, no lean rate."""
    q = np.array([0, 0, 0, math.pi / 2 - math.radians(case["axis_incl_deg"]), 0.3])
    u = np.array([0, 0, case["W"], 0, case["spin_rel"]])
    # x and y of the contact follow from rolling
    G = model.constraint_jacobian(q)
    u[:2] = np.linalg.solve(G[:, :2], -G[:, 2:] @ u[2:])
    return q, u


@each("treatment", EXACT)
@each("case", reference("coin_steady")["reference"]["cases"])
def test_coin_rolls_in_circles(case: dict[str, float], treatment: str) -> None:
    model = coin(treatment)
    q, u = steady(model, case)
    udot = model.forward_dynamics(q, u)
    # yaw rate, lean and spin rate stay what they are
    assert np.abs(udot[2:]).max() < 1e-10
    center = model.velocity("disk", q, u)[3:]
    assert np.linalg.norm(center) == pytest.approx(case["path_center_speed"], rel=1e-12)
    axle = u[4] + case["W"] * math.sin(q[3])
    assert abs(axle) == pytest.approx(abs(case["axial_abs"]), rel=1e-12)


@pytest.mark.parametrize("case", reference("coin_steady")["reference"]["cases"])
def test_coin_comes_back_after_a_turn(case: dict[str, float]) -> None:
    model = coin("multipliers")
    q, u = steady(model, case)
    turn = 2 * math.pi / abs(case["W"])
    motion = model.simulate([0, turn / 2, turn], q=q, u=u, rtol=1e-12, atol=1e-13)
    places = model.pose("disk", motion.q)[:, :3, 3]
    np.testing.assert_allclose(places[2], places[0], rtol=0, atol=1e-8)
    across = np.linalg.norm(places[1] - places[0])
    assert across == pytest.approx(2 * abs(case["path_radius_center"]), abs=1e-8)
    np.testing.assert_allclose(motion.q[:, 3], q[3], rtol=0, atol=1e-8)


@pytest.mark.parametrize("treatment", EXACT)
def test_bicycle(treatment: str) -> None:
    known = reference("bicycle_M1")["reference"]["rows"]
    scene = cd.load(BICYCLE)
    model = cd.compile(cd.derive(scene, constraints=treatment))
    start = scene.settings["u"]
    motion = model.simulate([row["t"] for row in known], u=start, rtol=1e-12, atol=1e-13)
    pose = model.pose("frame", motion.q)
    rates = model.velocity("frame", motion.q, motion.u, in_="frame")
    R = pose[:, :3, :3]
    computed = {
        "roll": np.arcsin(R[:, 2, 1]),
        "yaw": np.arctan2(-R[:, 0, 1], R[:, 1, 1]),
        "rollrate_bodyx": rates[:, 0],
        "forward_v": rates[:, 3],
        "steer": motion["steer"],
        "steerrate": motion["steer.u"],
        # the rear hub
        "xP": pose[:, 0, 3],
        "yP": pose[:, 1, 3],
    }
    for name, values in computed.items():
        expected = [row[name] for row in known]
        np.testing.assert_allclose(values, expected, rtol=0, atol=1e-8, err_msg=name)
    total = motion.energy.total
    assert np.ptp(total) < 1e-9 * motion.energy.kinetic[0]
