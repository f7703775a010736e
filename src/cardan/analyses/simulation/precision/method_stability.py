"""Stability of methods on linear oscillators, free and constrained.

A linear system falls apart into oscillators x'' + 2 zeta omega x' + omega^2 x = 0; one with
constraints into some that are free and some that are held at x = 0 by a multiplier. What a method
does to each in a step of size h depends on Omega = omega h alone.

Source: M. Géradin, A. Cardona, Flexible Multibody Dynamics (2001), chapter 10; J. Chung, G. M.
Hulbert, J. Appl. Mech. 60 (1993), 371-375; M. Arnold, O. Brüls, Multibody Syst. Dyn. 18 (2007).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....arguments import Complexes, checked
from ....arrays import Array, Booleans
from ....errors import ArgumentError, ModelError, brief
from ....schema.integrators import Integrator
from ..alpha_methods import Alpha, GeneralizedAlpha
from ..settings import integrator
from .runge_kutta import response as response_of

ROUNDED = 1e-12  # of |R| = 1, to which methods without damping round


@checked
def amplification(
    method: str | Alpha | GeneralizedAlpha,
    omega: ArrayLike,
    damping: float = 0.0,
    index: int | None = None,
) -> Array:
    """The matrix by which a step multiplies the state of an oscillator.

    Args:
        method: Name of an integrator, or coefficients of the generalized-alpha family.
        omega: Omega = omega h, angle that passes in a step (...) [rad].
        damping: zeta, share of the critical damping.
        index: None: the oscillator is free. 3, 2 or 1: it is held by its position, speed or
            acceleration.

    Returns:
        (..., 3, 3) for the state [x, h x', h^2 a] of a free one, a the accelerations of the
        method; (..., 4, 4) for [x, h x', h^2 a, h^2 lam] of a held one with
        x'' + 2 zeta omega x' + omega^2 x = lam. (..., 2, 2) for [x, h x'] of methods that keep no
        accelerations: Runge-Kutta and Rosenbrock, which do not hold anything by themselves.

    Raises:
        ModelError: the method has none. ArgumentError: another index.
    """
    alpha, angle = _coefficients(method), np.asarray(omega, dtype=np.float64)
    if isinstance(alpha, Integrator):
        return _one_step(alpha, angle, damping, index)
    if index not in (None, 1, 2, 3):
        raise ArgumentError(f"index={brief(index)}: None (free), 3 (position), 2 (speed) or 1")
    size = 3 if index is None else 4
    after, before = np.zeros((2, *angle.shape, size, size))
    # increments: x' and h x' after the step by everything before it and a after it
    for row, entries, last in (
        (0, (1.0, 1.0, 0.5 - alpha.beta), alpha.beta),
        (1, (0.0, 1.0, 1.0 - alpha.gamma), alpha.gamma),
    ):
        after[..., row, row], after[..., row, 2] = 1.0, -last
        before[..., row, :3] = entries
    # (1 - am) a' + am a = (1 - af) udot' + af udot, udot = lam - Omega^2 x - 2 zeta Omega h x'
    for matrix, a, f in ((after, 1 - alpha.am, 1 - alpha.af), (before, -alpha.am, -alpha.af)):
        matrix[..., 2, 0], matrix[..., 2, 1] = f * angle**2, f * 2 * damping * angle
        matrix[..., 2, 2] = a
        if index is not None:
            matrix[..., 2, 3] = -f
    # what holds it after the step
    if index in (2, 3):
        after[..., 3, 3 - index] = 1.0
    # index 1: the acceleration is constrained, so the force cancels spring and damper
    elif index == 1:
        after[..., 3, 0], after[..., 3, 1] = angle**2, 2 * damping * angle
        after[..., 3, 3] = -1.0
    return np.asarray(np.linalg.solve(after, before))


def _one_step(method: Integrator, angle: Array, damping: float, index: int | None) -> Array:
    """The matrix of a method that keeps nothing but the state."""
    if index is not None:
        raise ModelError(f"'{method.name}' holds nothing: its states are projected")
    system = np.zeros((*angle.shape, 2, 2), dtype=np.complex128)
    system[..., 0, 1] = 1.0
    system[..., 1, 0], system[..., 1, 1] = -(angle**2), -2 * damping * angle
    return np.asarray(response_of(method, system).real)


@checked
def response(method: str, z: Complexes) -> NDArray[np.complexfloating[Any, Any]]:
    """R(z) (...), by which a step multiplies y of y' = lambda y, at z = lambda h.

    Args:
        method: Name of a Runge-Kutta or Rosenbrock method.
        z: Complex numbers (...), those of a grid to see where abs(R) <= 1: the region of stability.

    Raises:
        ModelError: nothing of the kind is known of the method.
    """
    numbers = np.asarray(z, dtype=np.complex128)[..., None, None]
    return response_of(integrator(method), numbers)[..., 0, 0]


@checked
def stable_along(method: str, direction: complex) -> float:
    """Stability limit of a method along a ray: the largest r with ``|R| <= 1`` up to it.

    Args:
        method: As :func:`response` takes it.
        direction: ``-1`` for decay, ``1j`` for oscillations without damping.

    Returns:
        r, in steps times rates; inf where all of the ray is stable.

    Raises:
        ModelError: as :func:`response`.
    """
    ray = complex(direction) / abs(direction)

    def grows(r: Array) -> Booleans:
        return np.asarray(np.abs(response(method, ray * r)) > 1 + ROUNDED)

    grid = np.concatenate([np.linspace(0, 20, 20001)[1:], np.logspace(np.log10(20), 8, 500)])
    bad = np.flatnonzero(grows(grid))
    if not len(bad):
        return math.inf
    low, high = (float(grid[bad[0] - 1]) if bad[0] else 0.0), float(grid[bad[0]])
    while high - low > 1e-13 * high:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if grows(np.array(middle)) else (middle, high)
    return low


@checked
def spectral_radius(
    method: str | Alpha | GeneralizedAlpha,
    omega: ArrayLike,
    damping: float = 0.0,
    index: int | None = None,
) -> Array:
    """Largest factor (...) by which a step multiplies a part of the state: above 1 it grows.

    Args:
        method, omega, damping, index: As :func:`amplification` takes them. Of index 1 it is 1, a
            double one: positions drift along with a speed that is left.

    Raises:
        ModelError, ArgumentError: as :func:`amplification`.
    """
    values = np.linalg.eigvals(amplification(method, omega, damping, index))
    return np.asarray(np.abs(values).max(axis=-1))


@checked
def period_error(
    method: str | Alpha | GeneralizedAlpha, omega: ArrayLike, damping: float = 0.0
) -> Array:
    """By how much the period of an oscillation comes out too long (...), relative to it.

    Args:
        method, omega, damping: As :func:`amplification` takes them; damping below 1.

    Raises:
        ModelError: as :func:`amplification`. ArgumentError: nothing oscillates.
    """
    if not 0 <= damping < 1:
        raise ArgumentError(f"damping={damping:g}: oscillations have one below 1")
    angle = np.asarray(omega, dtype=np.float64) * np.sqrt(1 - damping**2)
    values = np.linalg.eigvals(amplification(method, omega, damping))
    # the pair that oscillates is the one next to the exact solution
    exact = np.exp(-damping * np.asarray(omega, dtype=np.float64) + 1j * angle)
    nearest = np.abs(values - exact[..., None]).argmin(axis=-1)
    pair = np.take_along_axis(values, nearest[..., None], axis=-1)[..., 0]
    return np.asarray(angle / np.abs(np.angle(pair)) - 1)


def _coefficients(method: str | Alpha | GeneralizedAlpha) -> Alpha | Integrator:
    """Coefficients of a method of the generalized-alpha family; of others the record."""
    if isinstance(method, Alpha):
        return method
    if isinstance(method, GeneralizedAlpha):
        return method.alpha
    chosen = integrator(method)
    if chosen.kernel != "alpha":
        return chosen
    return Alpha(*chosen.options[:4])
