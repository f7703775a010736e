"""Published beams at rest, from scenes through load paths; files name their sources."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

import cardan as cd
from mechanisms import flexible

HERE = Path(__file__).parent


def reference(name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((HERE / f"{name}.json").read_text("utf-8"))["reference"]
    return found


def test_bend_of_45_degrees() -> None:
    wanted = reference("bend45")["tip_position_own"]["J_1/6"]
    path = cd.compile(flexible.bend45(8)).statics(P=[0, 300, 450, 600])
    tips = path.pose("bend.end")[1:, :3, 3]
    errors = np.linalg.norm(tips - [wanted[load] for load in ("300", "450", "600")], axis=1)
    print(f"errors of the tip {errors}, iterations {path.iterations}")
    # the error of eight elements under the largest load; it stands in the notes of the method
    assert np.all(errors < 1.5e-3)
    assert all(path.stable)


def test_elastica() -> None:
    table = reference("elastica_tip_load")["table"]
    path = cd.compile(flexible.elastica(10)).statics(P=[0, 1, 2])
    tips = path.pose("beam.end")[:, :3, 3]
    for tip, load in zip(tips[1:], ("1", "2"), strict=True):
        # ten elements of order four, and a stretch of 1e-8
        np.testing.assert_allclose(1 - tip[0], table[load]["u"], atol=5e-6)
        np.testing.assert_allclose(tip[1], table[load]["w"], atol=5e-6)


def test_two_loads() -> None:
    wanted = reference("cantilever_two_loads")["two_loads_A=0.2,nu=.3"]["tip"]
    found = cd.compile(flexible.two_loads(16)).equilibrium()
    tip = found.pose("beam.end")[:3, 3]
    np.testing.assert_allclose([100 - tip[0], tip[1]], wanted[:2], rtol=1e-5)
