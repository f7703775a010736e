"""The bars with many features at once against equations written by hand, by SciPy."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import cardan as cd

from .features import mechanism
from .mechanism import SPAN

Array = Any
FEATURES = (
    *("torsion spring", "spring-damper", "PID", "actuator lag", "motor current"),
    *("Maxwell", "time event", "moving base"),
)


def along(angle: float) -> Array:
    """The direction x, z of a bar that has turned about y."""
    return np.array([np.cos(angle), -np.sin(angle)])


def across(angle: float) -> Array:
    """Its derivative."""
    return np.array([-np.sin(angle), -np.cos(angle)])


def pull(place: Array, speed: Array, end: Array) -> tuple[float, float, Array]:
    """Distance to an end x, y, z of the base, its rate, and the direction x, z there."""
    way = np.array([end[0] - place[0], end[1], end[2] - place[1]])
    length = float(np.linalg.norm(way))
    toward = way[[0, 2]] / length
    return length, -float(toward @ speed), toward


def rates(t: float, y: Array, push: float) -> Array:
    """Of angles, speeds, the integral, the force of the valve, the current and the creep."""
    q, u, (integral, valve, current, creep) = y[:2], y[2:4], y[4:]
    a, w = np.array([q[0], q[0] + q[1]]), np.array([u[0], u[0] + u[1]])
    heave = np.array([0.0, -0.03 * 81 * np.sin(9 * t)])

    def point(s: float) -> tuple[Array, Array]:
        """Place and Jacobian (2, 2) of a point of the forearm, seen from the base."""
        J = np.stack([0.5 * across(a[0]) + s * across(a[1]), s * across(a[1])], axis=1)
        return 0.5 * along(a[0]) + s * along(a[1]), J

    arm = np.stack([0.25 * across(a[0]), np.zeros(2)], axis=1)
    forearm = point(0.2)[1]
    turns = np.array([[1.0, 0.0], [1.0, 1.0]])
    convective = (
        -0.25 * w[0] ** 2 * along(a[0]),
        -0.5 * w[0] ** 2 * along(a[0]) - 0.2 * w[1] ** 2 * along(a[1]),
    )
    M, force = np.zeros((2, 2)), np.zeros(2)
    bars = zip((1.0, 0.6), (0.5, 0.4), (arm, forearm), turns, convective, strict=True)
    for mass, length, J, turn, bias in bars:
        M += mass * J.T @ J + mass * length**2 / 12 * np.outer(turn, turn)
        force += mass * J.T @ (np.array([0.0, -9.81]) - bias - heave)
    # spring and damper, and the two in series
    place, J = point(0.2)
    distance, rate, toward = pull(place, J @ u, np.array([0.6, -0.2, 0.3]))
    force += J.T @ toward * (50.0 * (distance - 0.4) + rate)
    place, J = point(0.3)
    distance, rate, toward = pull(place, J @ u, np.array([0.4, 0.1, 0.5]))
    tension = 60.0 * (distance - 0.5 - creep)
    force += J.T @ toward * tension
    force += point(0.4)[1].T @ np.array([0.0, push])
    force[0] += 30.0 * (0.2 - q[0]) + 40.0 * integral - u[0]
    force[1] += valve + 0.3 * current - 4.0 * q[1] - 0.05 * u[1]
    states = (
        *(0.2 - q[0], (0.8 * np.sin(8 * t) - valve) / 0.05),
        *((2 - current - 0.3 * u[1]) / 0.02, tension / 5.0),
    )
    return np.concatenate([u, np.linalg.solve(M, force), states])


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_the_bars_move_as_written_by_hand(coordinates: str) -> None:
    model = cd.compile(mechanism(FEATURES).scene, coordinates=coordinates)
    motion = model.simulate(SPAN, method="DOP853", rtol=1e-10, atol=1e-12)
    y = np.array([0.3, 0.5, 0.0, 1.5, 0.0, 0.0, 0.0, 0.0])
    for span, push in (((0.0, 0.1), 0.0), ((0.1, SPAN), 2.0)):
        y = solve_ivp(rates, span, y, "DOP853", args=(push,), rtol=1e-11, atol=1e-12).y[:, -1]
    angles = [motion[name][-1] for name in ("shoulder", "elbow")]
    np.testing.assert_allclose(angles, y[:2], atol=1e-8)
    states = [motion[n][-1] for n in ("pid.integral", "valve.force", "winding.current")]
    np.testing.assert_allclose(states, y[4:7], atol=1e-8)
