"""Beams that move far, as compiled scenes, against published problems solved elsewhere."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import cardan as cd
from mechanisms.flexible import right_angle, rotating_blade, slider_crank, spaghetti, spin_up

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


def test_spun_up_blade_moves_steadily() -> None:
    known = reference("spin_up")[0]
    model = cd.compile(spin_up(8))
    # behind the ramp the hub turns at 6 rad/s: nothing is prescribed but that
    steady = model.equilibrium(u={}, t=20.0)
    assert steady.stable
    names = [row["name"] for row in model.manifest["outputs"]]
    found = dict(zip(names, model.outputs(steady.q, steady.u, t=20.0), strict=True))
    print("spun-up blade: stretch", found["along"], "linear theory", 5.14317e-4)
    assert abs(found["along"] - float(known["steady_u1"].split()[0])) < 2e-6
    assert abs(found["across"]) < 1e-9
    assert steady["hub.u.z"] == pytest.approx(6, rel=1e-12)


def blade_frequencies(elements: int, speed: float) -> Array:
    """Lag and flap (4, 2) of a blade whose section does not stretch or shear: EA = GA = 1e9."""
    model = cd.compile(rotating_blade(elements, stiff=1e9))
    steady = model.equilibrium(u={}, parameters={"Omega": speed}, check=True)
    # the axis across the blade stiffens lag less than flap
    return steady.model.modes(8, steady).angular.reshape(4, 2)


def blade_reference(speed: int) -> Array:
    """The same as published: flap, and lag from it."""
    flap = np.array(reference_of_blade()[str(speed)])
    return np.stack([np.sqrt(flap**2 - speed**2), flap], axis=1)


def reference_of_blade() -> dict[str, list[float]]:
    told = json.loads((HERE / "rotating_beam_freq_clamped.json").read_text(encoding="utf-8"))
    found: dict[str, list[float]] = told["reference"]
    return found


@pytest.mark.parametrize("speed", [12])
def test_rotating_blade(speed: int) -> None:
    """Frequencies of fourth order; two meshes give them to the tolerance of the source, 1e-6."""
    known = blade_reference(speed)
    found = [blade_frequencies(elements, speed) for elements in (8, 16, 32)]
    errors = [np.abs(f / known - 1) for f in found]
    orders = np.log2(errors[0] / errors[1])
    extrapolated = np.abs((16 * found[2] - found[1]) / 15 / known - 1)
    for k, name in enumerate(("lag", "flap")):
        print(f"blade at {speed}, {name}: errors of 8, 16, 32 elements",
              *(error[:, k] for error in errors), "orders", orders[:, k].round(2),
              "extrapolated", extrapolated[:, k])  # fmt: skip
    assert orders.min() > 3.8
    assert extrapolated.max() < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("speed", range(13))
def test_rotating_blade_at_all_speeds(speed: int) -> None:
    errors = np.abs(blade_frequencies(80, speed) / blade_reference(speed) - 1)
    print(f"blade at {speed}, 80 elements: errors of lag and flap", *errors.T)
    assert errors.max() < 1e-6


def test_flexible_slider_crank() -> None:
    """Adopted: geometry, masses, stiffness, speed, and the speeds of the start.

    Not adopted: two sines across and a parabola along the rod, whose masses along it the source
    takes 15 times too large. What the rod does to the mechanism is the same; how it bends is
    between what the source has without and with the stiffness of geometry.
    """
    known = json.loads((HERE / "flexible_slider_crank_ivp.json").read_text(encoding="utf-8"))
    v, source = known["initial_state"]["v"], known["reference"]
    model = cd.compile(slider_crank(4))
    start, length, speeds = model.initial(), 0.3, {}
    for name in (j for j in model.joints if f"{j}.px" in model.coordinates and "rod" in j):
        s = (start[model.coordinates.index(f"{name}.px")] - 0.15) / length
        turn = v[1] + v[3] * np.pi / length * np.cos(np.pi * s)
        speeds[name] = [0, 0, turn, 0, 22.5 * (1 - s) + v[3] * np.sin(np.pi * s), 0]
    motion = model.simulate(
        [0, 0.05, 0.1], u=speeds, method=cd.GeneralizedAlpha(0.9), step=2e-5
    )  # fmt: skip
    line = motion.line("rod")[1:]
    along = (line[:, -1] - line[:, 0]) / np.linalg.norm(line[:, -1] - line[:, 0], axis=1)[:, None]
    beside = line[:, 2] - line[:, 0]
    bow = along[:, 0] * beside[:, 1] - along[:, 1] * beside[:, 0]
    linear, nonlinear = (np.array(source[k]["y"]) for k in ("own_linear_true_pi", "own_nonlinear"))
    print("slider-crank: bow", bow, "sources", linear[:, 3], nonlinear[:, 3])
    np.testing.assert_allclose(np.arctan2(along[:, 1], along[:, 0]), nonlinear[:, 1], atol=1e-4)
    np.testing.assert_allclose(0.45 + motion["guide"][1:], nonlinear[:, 2], atol=1e-4)
    np.testing.assert_allclose(bow, (linear + nonlinear)[:, 3] / 2, atol=6e-4)
