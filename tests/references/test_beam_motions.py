"""Beams that move far, as compiled scenes, against published problems solved elsewhere."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import cardan as cd
from mechanisms.flexible import right_angle, spaghetti, spin_up

HERE = Path(__file__).parent
Array = NDArray[np.float64]
METHOD = cd.GeneralizedAlpha(0.8)


def reference(name: str) -> tuple[dict[str, Any], Array]:
    """What is known, and the times of it with that of the start."""
    found = json.loads((HERE / f"{name}.json").read_text(encoding="utf-8"))["reference"]
    return found, np.array([0.0, *found["t"]])


def test_right_angle_cantilever() -> None:
    known, times = reference("right_angle_cantilever_dyn")
    worst = []
    for elements in (4, 8, 16):
        model = cd.compile(right_angle(elements))
        motion = model.simulate(times, method=METHOD, step=0.05)
        off = [motion[n][1:] - known[f"{n}_z_richardson"] for n in ("elbow", "tip")]
        worst.append(np.abs(off).max(axis=0))
    largest = [float(error[times[1:] <= 10].max()) for error in worst]
    print("right angle: errors to t = 10 of 4, 8, 16 elements:", np.round(largest, 4))
    assert largest[-1] < 1e-2
    assert worst[-1].max() < 3e-2
    # the mesh is of second order in motion
    assert np.log2(largest[0] / largest[-1]) / 2 > 1.8


def test_flying_rod() -> None:
    known, times = reference("flying_spaghetti_2d")
    model = cd.compile(spaghetti(32))
    on = ([0.0, 2.5, 2.5, 10.0], [1.0, 1.0, 0.0, 0.0])
    motion = model.simulate(times, method=METHOD, step=0.0125, inputs={"on": on})
    errors = []
    for node, name in (("start", "loaded_end_rich"), ("end", "free_end_rich")):
        ends = np.stack([motion[f"rod.{node}.{c}"] for c in ("px", "py", "pz")], axis=-1)
        errors.append(np.abs(ends[1:] - known[name]).max(axis=1))
    worst = np.max(errors, axis=0)
    print("flying rod: errors at", times[1:], "s:", np.round(worst, 4))
    assert worst[:2].max() < 2e-2
    assert worst[2:].max() < 5e-2
    # up to what steps of second order miss
    momentum = model.momentum(motion.q[-1], motion.u[-1])[3:]
    np.testing.assert_allclose(momentum, known["final_linear_momentum"], atol=2e-4)


def test_spin_up() -> None:
    known, times = reference("spin_up")
    worst = []
    for step in (0.02, 0.01):
        motion = cd.compile(spin_up(8)).simulate(times, method=METHOD, step=step)
        along, across = motion["along"][1:], motion["across"][1:]
        worst.append(float(np.abs(across - known["u2_rich"]).max()))
    print("spin-up: errors across with steps of 20 and 10 ms:", worst)
    assert worst[-1] < 2e-3
    # the method is of second order in the step
    assert np.log2(worst[0] / worst[1]) > 1.8
    # steady stretch by the centrifugal force
    assert abs(along[-1] - known["u1_rich"][-1]) < 2e-6
