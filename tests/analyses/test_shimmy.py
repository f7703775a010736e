"""Shimmy of a trailing wheel: speeds at which it begins, and the limit cycles that follow.

    I psi'' + c psi' + k psi + M(a) = 0,    sigma a' + V a = V psi + e psi'

with the slip angle a of a tire that relaxes over the length sigma, and its moment M about the steer
axis. Source: H. B. Pacejka, Tire and Vehicle Dynamics (2012), chapters 3 and 5.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd

WITHOUT_SPRING = {"I": 1.2, "e": 0.1, "C": 30000.0, "sigma": 0.3, "k": 0.0, "c": 0.0, "t": 0.0}
WITH_SPRING = {"I": 1.1, "e": 0.06, "C": 35000.0, "sigma": 0.3, "k": 1e4, "c": 10.0, "t": 0.03}
MOST = 0.8 * 4000.0  # friction coefficient and load [N]: the largest side force
Law = Callable[[dict[str, float], Any], Any]


def linear(of: dict[str, float], a: Any) -> Any:
    """C (e + t) a."""
    return of["C"] * (of["e"] + of["t"]) * a


def smooth(of: dict[str, float], a: Any) -> Any:
    """The same for small angles, with a smooth bound of the force."""
    return MOST * sp.tanh(of["C"] * a / MOST) * (of["e"] + of["t"])


def brush(of: dict[str, float], a: Any) -> Any:
    """F = mu Fz (3 z - 3 z^2 + z^3) at e + t (1 - z)^3 / (1 - z + z^2 / 3), z = C |a| / (3 mu Fz).

    The parabolic pressure of Pacejka (2012), section 3.2.1; up to full sliding, z = 1.
    """
    z = of["C"] * sp.Abs(a) / (3 * MOST)
    force = of["C"] * a * (1 - z + z**2 / 3)
    return of["e"] * force + of["t"] * of["C"] * a * (1 - z) ** 3


def trailing_wheel(of: dict[str, float], law: Law) -> cd.CompiledModel:
    """A caster with a tire, rolling at the speed V."""
    scene = cd.Scene("shimmy", gravity=(0, 0, 0))
    V = scene.parameter("V", 1.0)
    caster = scene.body("caster", mass=1.0, inertia=(1.0, 1.0, of["I"]))
    scene.joint("steer", cd.Revolute("z"), scene.ground, caster)
    psi, rate, a = scene.q("steer"), scene.u("steer"), scene.state("tire.slip")
    change = (V * (psi - sp.Symbol("slip")) + of["e"] * rate) / of["sigma"]
    scene.force("tire", cd.Controller(states=("slip",), changes=(change,)))
    moment = -of["k"] * psi - of["c"] * rate - law(of, a)
    scene.force("moment", cd.JointForce("steer", moment))
    return cd.compile(scene)


def shimmy_speeds(of: dict[str, float]) -> list[float]:
    """Zeros of a1 a2 - a0 of the characteristic polynomial s^3 + a2 s^2 + a1 s + a0."""
    I, C, s, k, c = (of[name] for name in ("I", "C", "sigma", "k", "c"))
    arm = C * (of["e"] + of["t"])
    # a2 = c/I + V/s, a1 = k/I + c V/(I s) + arm e/(I s), a0 = V (k + arm)/(s I)
    first = np.array([1 / s, c / I])
    second = np.array([c / (I * s), k / I + arm * of["e"] / (I * s)])
    rest = np.polysub(np.polymul(first, second), [(k + arm) / (s * I), 0.0])
    speeds = np.roots(rest)
    return sorted(v.real for v in speeds if abs(v.imag) < 1e-9 and v.real > 1e-9)


def kinds(path: Any) -> list[str]:
    return [point.kind for point in path.points]


def test_no_speed_is_stable_without_a_spring() -> None:
    """With c = k = 0 it is stable if and only if e > sigma."""
    assert shimmy_speeds(WITHOUT_SPRING) == []
    path = trailing_wheel(WITHOUT_SPRING, linear).continuation(V=(1.0, 100.0))
    assert "Hopf point" not in kinds(path)
    assert not any(path.main.stable)
    longer = trailing_wheel({**WITHOUT_SPRING, "e": 0.31}, linear).continuation(V=(1.0, 100.0))
    assert all(longer.main.stable)


def test_shimmy_speeds() -> None:
    path = trailing_wheel(WITH_SPRING, linear).continuation(V=(1.0, 100.0))
    points = [point for point in path.points if point.kind == "Hopf point"]
    speeds = [point.values["V"] for point in points]
    np.testing.assert_allclose(speeds, [15.03820197901445, 57.834525293712844], rtol=1e-9)
    np.testing.assert_allclose(speeds, shimmy_speeds(WITH_SPRING), rtol=1e-9)
    turns = [point.frequency for point in points]
    np.testing.assert_allclose(turns, [100.59492757544751, 106.84660844487821], rtol=1e-9)
    between = (path["V"] > speeds[0]) & (path["V"] < speeds[1])
    assert (np.array(path.main.stable) == ~between).all()


def limit_cycles(model: cd.CompiledModel, until: float, **options: Any) -> Any:
    """Those that begin at the lower shimmy speed."""
    rest = model.continuation(V=(1.0, 40.0))
    point = rest.point("Hopf point 1")
    assert point.values["V"] == pytest.approx(15.03820197901445, rel=1e-9)
    return model.continuation(
        V=(point.values["V"], until), of="cycles", start=point, check=True, **options
    )


def test_amplitudes_grow_like_a_square_root() -> None:
    """Of a smooth law: A^2 grows with V - V_Hopf (E. Hopf, 1942)."""
    path = limit_cycles(trailing_wheel(WITH_SPRING, smooth), 15.3, step=0.02)
    beyond, amplitude = path["V"] - 15.03820197901445, path["steer.max"]
    near = (beyond > 1e-4) & (beyond < 0.1)
    assert near.sum() >= 4
    exponent = np.polyfit(np.log(beyond[near]), np.log(amplitude[near]), 1)[0]
    assert exponent == pytest.approx(0.5, rel=0.02)
    assert all(path.main.stable)
    assert path["period"][0] == pytest.approx(2 * np.pi / 100.59492757544751, rel=1e-4)


def test_limit_cycles_of_a_brush_tire() -> None:
    """The moment has a term in |a| a: its first harmonic 8 A / (3 pi) a says how A grows."""
    path = limit_cycles(trailing_wheel(WITH_SPRING, brush), 16.0, step=0.1)
    C, e, t = (WITH_SPRING[name] for name in ("C", "e", "t"))
    lost = (e + 3 * t) * C / (3 * MOST) * 8 / (3 * np.pi)
    for k in (1, 2, 3):
        amplitude = path["tire.slip.max"][k]
        speed = shimmy_speeds({**WITH_SPRING, "t": t - lost * amplitude})[0]
        beyond = path["V"][k] - 15.03820197901445
        assert beyond == pytest.approx(speed - 15.03820197901445, rel=0.02)
    assert all(path.main.stable)


def test_a_limit_cycle_by_another_program() -> None:
    from scipy.integrate import solve_ivp

    path = limit_cycles(trailing_wheel(WITH_SPRING, brush), 25.0)
    cycle = path[-1]
    speed, of = path["V"][-1], WITH_SPRING
    assert speed == pytest.approx(25.0, rel=1e-9)

    def rates(t: float, y: Any) -> list[float]:
        psi, rate, a = y
        z = min(of["C"] * abs(a) / (3 * MOST), 1.0)
        force = MOST * (3 * z - 3 * z**2 + z**3) * np.sign(a)
        trail = of["t"] * (1 - z) ** 3 / (1 - z + z**2 / 3)
        moment = (of["e"] + trail) * force
        turned = -(of["k"] * psi + of["c"] * rate + moment) / of["I"]
        return [rate, turned, (speed * (psi - a) + of["e"] * rate) / of["sigma"]]

    times = np.linspace(0, cycle.period, 33)
    span = (0.0, cycle.period)
    run = solve_ivp(rates, span, cycle.x, "DOP853", times, rtol=1e-12, atol=1e-15)
    size = np.abs(run.y).max(axis=1)
    assert size[0] > 0.05
    np.testing.assert_allclose(run.y[:, -1] / size, cycle.x / size, atol=1e-6)
    np.testing.assert_allclose(run.y.T / size, cycle.motion.at(times) / size, atol=1e-6)
    # a start beside it comes nearer: the cycle attracts
    laps = 200 * cycle.period
    last = np.linspace(laps - cycle.period, laps, 401)
    beside = solve_ivp(rates, (0, laps), 1.1 * cycle.x, "DOP853", last, rtol=1e-9)
    assert np.abs(beside.y[0]).max() == pytest.approx(size[0], rel=1e-3)


def test_shimmy_ends_at_a_higher_speed() -> None:
    """Where the other Hopf point is, the cycle is at rest again."""
    rest = trailing_wheel(WITH_SPRING, smooth).continuation(V=(1.0, 80.0))
    path = rest.model.continuation(
        V=(15.0, 80.0), of="cycles", start=rest.point("Hopf point 1"), check=True
    )
    low, high = shimmy_speeds(WITH_SPRING)
    assert "reached a Hopf point: the cycle shrinks to rest" in path.main.message
    assert path["V"][0] == pytest.approx(low, rel=1e-2)
    assert path["V"][-1] == pytest.approx(high, rel=1e-7)
    assert path["steer.max"].max() > 100 * abs(path["steer.max"][-1])
