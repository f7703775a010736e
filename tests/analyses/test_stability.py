"""Stability functions against published and exact values."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from cardan.errors import ArgumentError, ModelError
from table import each

RHO = (0.0, 0.5, 0.8, 0.9, 1.0)
# reference "time_integration_theory": Chung and Hulbert 1993; Hilber, Hughes and Taylor 1977;
# Géradin and Cardona, chapter 10; spectral radii from the amplification matrix
AT_1 = (0.906563, 0.989313, 0.999475, 0.999942, 1.0)
AT_1E7 = (2.2e-05, 0.500017, 0.800017, 0.900015, 1.0)


@pytest.mark.parametrize("k", range(len(RHO)))
def test_spectral_radius_as_published(k: int) -> None:
    alpha = cd.stability.Alpha.chung_hulbert(RHO[k])
    assert cd.stability.spectral_radius(alpha, 1.0) == pytest.approx(AT_1[k], abs=1e-6)
    # eigenvalues meet at infinity: those of a block of 3 round to the cube root of 1e-16
    assert cd.stability.spectral_radius(alpha, 1e7) == pytest.approx(AT_1E7[k], abs=2e-5)
    assert alpha.rho_inf == pytest.approx(RHO[k], abs=1e-12)


@pytest.mark.parametrize("k", range(len(RHO)))
def test_unconditionally_stable(k: int) -> None:
    omega = np.logspace(-3, 5, 200)
    radius = cd.stability.spectral_radius(cd.stability.Alpha.chung_hulbert(RHO[k]), omega)
    assert np.all(radius <= 1 + 1e-9)
    # damping grows with the frequency
    assert np.all(np.diff(radius) <= 1e-5)


def test_coefficients_of_named_methods() -> None:
    assert cd.stability.Alpha.newmark() == cd.stability.Alpha(0, 0, 0.25, 0.5)
    assert cd.stability.Alpha.hht(0.0) == cd.stability.Alpha.newmark()
    for alpha in (-1 / 3, -0.2, -0.05):
        found = cd.stability.Alpha.hht(alpha)
        assert found.rho_inf == pytest.approx((1 + alpha) / (1 - alpha), abs=1e-12)
        # two eigenvalues meet at alpha = -1/3: rounding of either by the root of 1e-16 x 1e6
        assert cd.stability.spectral_radius(found, 1e6) == pytest.approx(found.rho_inf, abs=1e-3)
    assert cd.stability.Alpha.chung_hulbert(0.5).order == cd.stability.Alpha.hht().order == 2
    assert cd.stability.Alpha.newmark(0.3025, 0.6).order == 1


@pytest.mark.parametrize("method", ["GeneralizedAlpha", "HHT", "Newmark"])
def test_period_error(method: str) -> None:
    omega = np.array([0.08, 0.04, 0.02, 0.01])
    error = cd.stability.period_error(method, omega)
    assert np.all(error > 0)
    assert np.polyfit(np.log(omega), np.log(error), 1)[0] == pytest.approx(2, abs=0.01)
    if method == "Newmark":
        # trapezoidal rule: tan(Omega' / 2) = Omega / 2
        exact = omega / (2 * np.arctan(omega / 2)) - 1
        # the angle of an eigenvalue rounds relative to 1, not to itself
        np.testing.assert_allclose(error, exact, rtol=0, atol=1e-15 / omega.min() ** 2)


@each("rho", RHO)
@each("omega", [0.0, 0.1, 10.0])
def test_constrained_oscillator(rho: float, omega: float) -> None:
    alpha, radius = cd.stability.Alpha.chung_hulbert(rho), cd.stability.spectral_radius
    # held by its position the oscillator is one of infinite frequency, whatever the step: errors
    # of it are damped by rho_inf; double eigenvalues round to the root of 1e-16
    assert radius(alpha, omega, index=3) == pytest.approx(rho, abs=1e-7 + 2e-5 * (rho < 1))
    # held by its speed a position error stays; by its acceleration it drifts: a double 1
    assert radius(alpha, omega, index=2) == pytest.approx(1, abs=1e-9)
    assert radius(alpha, omega, index=1) == pytest.approx(1, abs=1e-6)
    values = {}
    for index in (2, 1):
        matrix = cd.stability.amplification(alpha, omega, index=index)
        state = np.linalg.matrix_power(matrix, 100) @ [1.0, 1.0, 0.0, 0.0]
        values[index] = abs(state[0])
    assert values[2] < 10
    assert values[1] > 90


def test_matrix_is_the_method() -> None:
    """One step by hand."""
    alpha, omega, zeta = cd.stability.Alpha(0.2, 0.3, 0.4, 0.6), 0.7, 0.1
    matrix = cd.stability.amplification(alpha, omega, zeta)
    assert matrix.shape == (3, 3)
    x, v, a = 0.3, -0.2, 0.5
    x1, v1, a1 = matrix @ [x, v, a]
    force = -(omega**2) * x - 2 * zeta * omega * v
    force1 = -(omega**2) * x1 - 2 * zeta * omega * v1
    assert x1 == pytest.approx(x + v + 0.1 * a + 0.4 * a1, abs=1e-14)
    assert v1 == pytest.approx(v + 0.4 * a + 0.6 * a1, abs=1e-14)
    assert 0.8 * a1 + 0.2 * a == pytest.approx(0.7 * force1 + 0.3 * force, abs=1e-14)


def test_refusals() -> None:
    with pytest.raises(ModelError, match=r"rho_inf=1\.5 lies outside 0 \.\.\. 1"):
        cd.stability.Alpha.chung_hulbert(1.5)
    with pytest.raises(ModelError, match=r"alpha=0\.1 lies outside"):
        cd.stability.Alpha.hht(0.1)
    with pytest.raises(ModelError, match="beta and gamma positive"):
        cd.stability.Alpha.newmark(beta=0.0)
    with pytest.raises(ModelError, match="am and af lie below 1"):
        cd.stability.Alpha(1.0, 0.0, 0.25, 0.5)
    with pytest.raises(ModelError, match="'RK4' holds nothing"):
        cd.stability.amplification("RK4", 1.0, index=2)
    with pytest.raises(ArgumentError, match="index=4"):
        cd.stability.spectral_radius("HHT", 1.0, index=4)
    with pytest.raises(ArgumentError, match="damping=1"):
        cd.stability.period_error("HHT", 1.0, damping=1.0)
