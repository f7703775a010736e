"""Nonlinear normal modes: families of cycles of systems that keep their energy, by that energy.

Source: R. M. Rosenberg, Advances in Applied Mechanics 9 (1966), 155-242; A. F. Vakakis, Mechanical
Systems and Signal Processing 11 (1997), 3-22 (localized modes).
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from scipy.special import ellipj, ellipk

import cardan as cd
from cardan.errors import ModelError
from cycle_scenes import POINT, oscillator

G, COUPLING, CUBIC = 9.81, 0.05, 0.5


def pendulum() -> cd.CompiledModel:
    scene = cd.Scene("pendulum", gravity=(0, 0, -G))
    bob = scene.body("bob", mass=1.0, inertia=(0, 0, 0), com=(0, 0, -1))
    scene.joint("angle", cd.Revolute("y"), scene.ground, bob)
    return cd.compile(scene)


@pytest.fixture(scope="module")
def pair() -> cd.CompiledModel:
    """Two masses on springs x + b x^3, coupled by a spring k."""
    scene = cd.Scene("pair", gravity=(0, 0, 0))
    k = scene.parameter("k", COUPLING)
    for name in "xy":
        body = scene.body(f"body_{name}", **POINT)
        scene.joint(name, cd.Prismatic("x"), scene.ground, body)
    x, y = scene.q("x"), scene.q("y")
    scene.force("first", cd.JointForce("x", -x - CUBIC * x**3 - k * (x - y)))
    scene.force("second", cd.JointForce("y", -y - CUBIC * y**3 - k * (y - x)))
    return cd.compile(scene)


def kinds(path: Any) -> list[str]:
    return [point.kind for point in path.points]


def test_pendulum() -> None:
    """T = 4 sqrt(l / g) K(sin^2(a / 2))."""
    model = pendulum()
    path = model.continuation(energy=(0.0, 1.95 * G), of="cycles", start=model.modes()[0])
    angle = np.abs(path["angle"])
    assert angle.max() > 2.5
    period = 4 * np.sqrt(1 / G) * ellipk(np.sin(angle / 2) ** 2)
    np.testing.assert_allclose(path["period"], period, rtol=1e-12)
    np.testing.assert_allclose(path["energy"], G * (1 - np.cos(angle)), atol=1e-12)
    assert kinds(path) == ["event"]
    assert path["energy"][-1] == pytest.approx(1.95 * G, rel=1e-12)
    assert all(path.main.stable)
    # on from a cycle of the path
    back = model.continuation(energy=(12.0, 2.0), of="cycles", start=path[-1])
    period = 4 * np.sqrt(1 / G) * ellipk(np.sin(back["angle.max"] / 2) ** 2)
    np.testing.assert_allclose(back["period"], period, rtol=1e-6)
    assert back["energy"][[0, -1]] == pytest.approx([12.0, 2.0], rel=1e-10)


def jacobi(stiffness: float, amplitude: float) -> tuple[float, float, float]:
    """Frequency W and parameter m of x = A cn(W t, m), x'' = -s x - b x^3, and its period."""
    W = np.sqrt(stiffness + CUBIC * amplitude**2)
    m = CUBIC * amplitude**2 / (2 * W**2)
    return W, m, 4 * ellipk(m) / W


@pytest.mark.parametrize(("mode", "stiffness", "sign"), [(0, 1.0, 1), (1, 1 + 2 * COUPLING, -1)])
def test_pair_in_and_out_of_phase(
    pair: cd.CompiledModel, mode: int, stiffness: float, sign: int
) -> None:
    """Each is one oscillator x'' = -s x - b x^3."""
    path = pair.continuation(energy=(0.0, 2.0), of="cycles", start=pair.modes()[mode])
    np.testing.assert_allclose(path["y"], sign * path["x"], atol=1e-10)
    for k in range(len(path)):
        amplitude = abs(path["x"][k])
        energy = stiffness * amplitude**2 + CUBIC * amplitude**4 / 2
        assert path["energy"][k] == pytest.approx(energy, rel=1e-10)
        W, m, period = jacobi(stiffness, amplitude)
        assert path["period"][k] == pytest.approx(period, rel=1e-11)
    cycle, times = path[-1], np.linspace(0, period, 21)
    expected = path["x"][-1] * ellipj(W * times, m)[1]
    np.testing.assert_allclose(cycle.motion.at(times)[:, 0], expected, atol=1e-10)


@pytest.mark.parametrize("mode", [0, 1])
def test_double_pendulum(mode: int) -> None:
    """Its energy is that of the model; a run by itself comes back."""
    scene = cd.Scene("double", gravity=(0, 0, -G))
    upper, lower = (
        scene.body(name, mass=mass, inertia=(0.1, 0.1, 0.1), com=(0, 0, -0.5))
        for name, mass in (("upper", 1.0), ("lower", 0.7))
    )
    scene.joint("first", cd.Revolute("y"), scene.ground, upper)
    scene.joint("second", cd.Revolute("y"), upper.at(0, 0, -1), lower)
    model = cd.compile(scene)
    modes = model.modes()
    path = model.continuation(energy=(0.0, 6.0), of="cycles", start=modes[mode])
    hanging = model.energy(np.zeros(2), np.zeros(2))
    assert path["period"][0] == pytest.approx(1 / modes.frequencies[mode], rel=1e-2)
    for k in (0, len(path) // 2, -1):
        cycle = path[k]
        q, u = cycle.x[:2], cycle.x[2:]
        energy = model.energy(q, u)
        over = energy.kinetic + energy.potential - hanging.kinetic - hanging.potential
        assert over == pytest.approx(path["energy"][k], rel=1e-11)
        options: Any = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-14}
        end = model.simulate((0, cycle.period), x0=cycle.x, **options).x[-1]
        np.testing.assert_allclose(end, cycle.x, atol=1e-9)
        # areas are kept
        assert abs(np.prod(cycle.multipliers)) == pytest.approx(1.0, abs=1e-7)


def trace(amplitude: float) -> float:
    """Sum of the multipliers of in-phase disturbances of the out-of-phase mode (Hill)."""
    W, m, period = jacobi(1 + 2 * COUPLING, amplitude)

    def rates(t: float, y: Any) -> list[float]:
        x = amplitude * ellipj(W * t, m)[1]
        s = 1 + 3 * CUBIC * x**2
        return [y[1], -s * y[0], y[3], -s * y[2]]

    end = solve_ivp(rates, (0, period), [1, 0, 0, 1], "DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
    return float(end[0] + end[3])


def test_localized_modes(pair: cd.CompiledModel) -> None:
    """The out-of-phase mode loses its stability where one mass begins to move alone."""
    path = pair.continuation(
        energy=(0.0, 1.0), of="cycles", start=pair.modes()[1], branches=1, points=60
    )
    point = path.point("branch point 1")
    amplitude = float(brentq(lambda a: trace(a) - 2, 0.2, 0.6, xtol=1e-10))
    # a first approximation: b A^2 = 4 k / 3
    assert CUBIC * amplitude**2 == pytest.approx(4 * COUPLING / 3, rel=0.1)
    energy = (1 + 2 * COUPLING) * amplitude**2 + CUBIC * amplitude**4 / 2
    assert point.values["energy"] == pytest.approx(energy, rel=1e-7)
    before = path.main["energy"] < energy
    assert (np.array(path.main.stable) == before).all()
    sides = [path.branches[name] for name in point.branches]
    assert len(sides) == 2
    for side in sides:
        larger = np.maximum(side["x.max"], side["y.max"])
        smaller = np.minimum(side["x.max"], side["y.max"])
        assert smaller[-1] < 0.5 * larger[-1]
        assert all(side.stable)
    row = path.main[-1]
    assert sum(row.multipliers).real == pytest.approx(trace(abs(row["x"])), abs=1e-6)


def test_a_parameter_changes_at_the_same_energy(pair: cd.CompiledModel) -> None:
    path = pair.continuation(energy=(0.0, 0.5), of="cycles", start=pair.modes()[1])
    stiffer = pair.continuation(k=(COUPLING, 0.5), of="cycles", start=path[-1])
    assert stiffer["k"][-1] == pytest.approx(0.5, rel=1e-12)
    amplitude = stiffer["x.max"][-1]
    assert 2.0 * amplitude**2 + CUBIC * amplitude**4 / 2 == pytest.approx(0.5, rel=1e-6)
    assert stiffer["period"][-1] == pytest.approx(jacobi(2.0, amplitude)[2], rel=1e-6)


def test_what_is_no_family_of_cycles(pair: cd.CompiledModel) -> None:
    mode = pair.modes()[0]
    assert "mode 0 of 'pair'" in repr(mode)
    assert set(mode.shape) == {"x", "y"}
    with pytest.raises(ModelError, match=r"go by their energy"):
        pair.continuation(k=(0.1, 0.2), of="cycles", start=mode)
    with pytest.raises(ModelError, match=r"it is positive"):
        pair.continuation(energy=(-1.0, 0.0), of="cycles", start=mode)
    damped = oscillator(lambda scene, x, v: -x - 0.1 * v)
    with pytest.raises(ModelError, match=r"keep their energy"):
        damped.continuation(energy=(0.0, 1.0), of="cycles", start=damped.modes()[0])
    drag = oscillator(lambda scene, x, v: -x - 0.1 * v**3)
    with pytest.raises(ModelError, match=r"does not keep its energy: over a lap it changes"):
        drag.continuation(energy=(0.0, 1.0), of="cycles", start=drag.modes()[0])
    limit = oscillator(lambda scene, x, v: (1 - x**2) * v - x)
    cycle = limit.cycle({"x": 2.0}, check=True)
    with pytest.raises(ModelError, match=r"energy= is swept from a mode"):
        limit.continuation(energy=(1.0, 2.0), of="cycles", start=cycle)
