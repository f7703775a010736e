"""What one-step methods make of linear systems: the kernels against their functions."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.schema.integrators import INTEGRATORS, Integrator
from kernels.problem import METHODS, Problem
from kernels.test_order import fixed

# those that work with masses have functions of their own
MASSES = ("alpha", "conserving")
ONE_STEP = [
    name
    for name, m in INTEGRATORS.items()
    if m.kernel not in MASSES and not (m.charted or m.elements)
]
# x'' + 0.3 x' + x = 0
DAMPED = "out[0] = u[0]; out[1] = -q[0] - 0.3 * u[0];"
EXACT = "out[0] = 0; out[1] = 1; out[2] = -1; out[3] = -0.3; out[4] = out[5] = 0;"


@pytest.mark.parametrize("method", METHODS.values(), ids=METHODS)
@pytest.mark.parametrize("h", [0.3, 1.0])
def test_a_step_is_the_matrix(method: Integrator, h: float, tmp_path: Path) -> None:
    start = np.array([0.7, -0.4])
    motion = Problem(tmp_path, DAMPED, jacobian=EXACT).run(h, start, **fixed(method, h))
    assert len(motion) == 2
    scale = np.array([1, h])
    expected = cd.stability.amplification(method.name, h, damping=0.15) @ (start * scale) / scale
    # coefficients of Rosenbrock are of the size of 100 and have 16 digits
    np.testing.assert_allclose(motion.x[-1], expected, rtol=0, atol=2e-13)


@pytest.mark.parametrize("name", ONE_STEP)
def test_order(name: str) -> None:
    size = 0.4 if INTEGRATORS[name].order > 5 else 0.1
    z = size * np.array([1.0, 0.5]) * np.exp(0.7j * np.pi)
    missed = np.abs(cd.stability.response(name, z) - np.exp(z))
    order = np.log2(missed[0] / missed[1]) - 1
    # on linear systems a method may be better than on others
    assert order >= INTEGRATORS[name].order - 0.15


# along decay and along oscillations. Hairer, Wanner, II, section IV.2 and figures IV.2.1, IV.2.2;
# the polynomial of RK4 meets the unit circle at 2 sqrt 2
EXTENTS = {
    "RK4": (2.785293563405282, math.sqrt(8)),
    "RK45": (3.3066, 0.9972),
    "DOP853": (6.3937, 5.9604),
    "Radau": (math.inf, math.inf),
    "Rosenbrock": (math.inf, math.inf),
    "EnergyMidpoint": (math.inf, math.inf),
}


@pytest.mark.parametrize("name", EXTENTS)
def test_extent_of_stability(name: str) -> None:
    found = [cd.stability.stable_along(name, ray) for ray in (-1, 1j)]
    assert found == pytest.approx(EXTENTS[name], abs=1e-4)
    for ray, r in zip((-1, 1j), found, strict=True):
        if math.isfinite(r):
            inside, outside = np.abs(cd.stability.response(name, ray * r * np.array([0.9, 1.02])))
            assert inside <= 1 + 1e-12 < outside


@pytest.mark.parametrize("name", ["Radau", "Rosenbrock"])
def test_what_is_infinitely_stiff_is_gone_after_a_step(name: str) -> None:
    assert abs(cd.stability.response(name, -1e8)) < 1e-6


def test_midpoint_keeps_oscillations() -> None:
    omega = np.array([0.1, 0.5, 2.0, 10.0])
    radius = cd.stability.spectral_radius("EnergyMidpoint", omega)
    np.testing.assert_allclose(radius, 1, rtol=0, atol=1e-14)
    # tan(Omega' / 2) = Omega / 2
    exact = omega / (2 * np.arctan(omega / 2)) - 1
    np.testing.assert_allclose(
        cd.stability.period_error("EnergyMidpoint", omega), exact, rtol=0, atol=1e-13
    )


@pytest.mark.parametrize("name", ["RK4", "RK45", "DOP853", "Radau", "Rosenbrock"])
def test_period_error_is_of_the_order(name: str) -> None:
    omega = {8: np.array([1.6, 1.2, 0.9])}.get(INTEGRATORS[name].order, np.array([0.4, 0.2, 0.1]))
    error = np.abs(cd.stability.period_error(name, omega))
    # phases are of even order
    order = 2 * ((INTEGRATORS[name].order + 1) // 2)
    assert np.polyfit(np.log(omega), np.log(error), 1)[0] == pytest.approx(order, abs=0.3)


def test_mistakes() -> None:
    with pytest.raises(cd.ModelError, match="holds nothing: its states are projected"):
        cd.stability.amplification("RK4", 0.1, index=3)
    with pytest.raises(cd.ModelError, match=r"a response is known of the kernels .*rk4,"):
        cd.stability.response("HHT", 0.1)
