"""The fast heavy top of Géradin and Cardona, as a tree and closed by a constraint."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd

KNOWN = json.loads((Path(__file__).parent / "heavy_top_bca.json").read_text(encoding="utf-8"))
ROWS = KNOWN["reference"]["own"]["rows"]
TIMES = np.array([0.0, *(row["t"] for row in ROWS)])
Array = np.ndarray


def top(tree: bool) -> tuple[cd.CompiledModel, Array]:
    """The model and its start: as a ball joint, or as a free body held at a point."""
    given, omega = KNOWN["parameters"], np.array(KNOWN["initial_state"]["Omega0_body"])
    scene = cd.Scene("heavy_top", gravity=tuple(given["g"]))
    body = scene.body("top", mass=given["m"], com=(0, 0, 0), inertia=tuple(given["J_cog"]))
    point = body.at(*(-x for x in given["X"]))
    if tree:
        scene.joint("pivot", cd.Spherical(), scene.ground, point)
        return cd.compile(scene), np.array([1, 0, 0, 0, *omega])
    scene.joint("free", cd.Free(), scene.ground, body)
    scene.joint("pivot", cd.Spherical(), scene.ground, point, cut=True)
    start = [1, 0, 0, 0, *given["X"], *omega, *np.cross(omega, given["X"])]
    return cd.compile(scene), np.array(start, dtype=float)


def missed(model: cd.CompiledModel, motion: cd.Trajectory) -> tuple[float, float]:
    """Largest error of the quaternion, of either sign, and of the angular velocity."""
    quaternions = np.array([row["quat"] for row in ROWS], dtype=float)
    speeds = np.array([row["Omega"] for row in ROWS], dtype=float)
    found = motion.q[1:, :4]
    found = found * np.sign((found * quaternions).sum(axis=1))[:, None]
    return np.abs(found - quaternions).max(), np.abs(motion.u[1:, :3] - speeds).max()


@pytest.mark.parametrize("tree", [True, False], ids=["ball", "closed"])
def test_by_a_method_of_high_order(tree: bool) -> None:
    model, start = top(tree)
    motion = model.simulate(TIMES, x0=start, rtol=1e-13, atol=1e-14)
    turn, speed = missed(model, motion)
    print(f"quaternion {turn:.1e}, angular velocity {speed:.1e}")
    # the tolerance of the reference; speeds count against 150 rad/s
    assert turn < float(KNOWN["tolerance"])
    assert speed < 150 * float(KNOWN["tolerance"])
    known = KNOWN["reference"]["published_EP_t02"]
    # published to five digits
    assert np.abs(np.abs(motion.q[2, :4]) - np.abs(known)).max() < 1e-5


@pytest.mark.parametrize("index", [None, 2, 3])
def test_by_generalized_alpha(index: int | None) -> None:
    """Of the second order here too; 150 rad/s are 0.015 rad in a step."""
    model, start = top(tree=index is None)
    options: dict[str, Any] = {"method": cd.GeneralizedAlpha(0.8, index=index or 2), "x0": start}
    coarse = model.simulate(TIMES, step=2e-4, **options)
    fine = model.simulate(TIMES, step=1e-4, **options)
    before, after = missed(model, coarse)[0], missed(model, fine)[0]
    print(f"index {index}: {before:.1e} at 0.2 ms, {after:.1e} at 0.1 ms")
    assert np.log2(before / after) == pytest.approx(2, abs=0.15)
    assert after < (2e-3 if index is None else 2e-4)
