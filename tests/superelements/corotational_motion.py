"""Equations of motion of a component in large motion, and their simulation by SciPy."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from superelements.corotational import STEP, Corotational
from superelements.rotations import product

Array = Any


def forces(element: Corotational, q: Array, u: Array) -> tuple[Array, Array]:
    """M and f of M u' = f, along the speeds."""
    N, count, G = element.n_speeds, len(element.places), element.form
    steps = element.moved(q.astype(complex), 1j * STEP * np.eye(N))
    k = element.kinematics(steps)
    A, by = k.A[0].real, k.A.imag / STEP
    c, rate = A @ u, np.einsum("jab,j->ab", by, u)
    heavy = G @ c
    f = (by @ u) @ heavy - rate.T @ heavy - A.T @ (G @ (rate @ u))
    f -= element.potential(steps, k).imag / STEP
    impulse = A.T @ heavy
    for i in range(count):
        turn = slice(6 * i, 6 * i + 3)
        f[turn] -= np.cross(u[turn], impulse[turn])
    return A.T @ G @ A, f


def accelerations(
    element: Corotational,
    q: Array,
    u: Array,
    free: Array | None = None,
    driven: Array | None = None,
    added: Array | None = None,
) -> Array:
    """u' where some speeds are free and the others have given accelerations (0 by default).

    Args:
        free: Numbers of free speeds; all by default.
        driven: Accelerations of the others, at their places (speeds,).
        added: Forces along the speeds.
    """
    M, f = forces(element, q, u)
    f = f if added is None else f + added
    if free is None:
        return np.linalg.solve(M, f)
    result = np.zeros(len(u)) if driven is None else driven.copy()
    result[free] = 0.0
    f = f - M @ result
    result[free] = np.linalg.solve(M[np.ix_(free, free)], f[free])
    return result


def rates(element: Corotational, q: Array, u: Array) -> Array:
    """q' by the speeds."""
    count = len(element.places)
    p, _, _ = element.split(q)
    speeds = u[: 6 * count].reshape(count, 6)
    turn = np.concatenate([np.zeros((count, 1)), speeds[:, :3]], 1)
    poses = np.concatenate([0.5 * product(p, turn), speeds[:, 3:]], 1)
    return np.concatenate([poses.ravel(), u[6 * count :]])


def simulate(
    element: Corotational,
    q: Array,
    u: Array,
    times: Sequence[float],
    free: Array | None = None,
    driven: Callable[[float], Array] | None = None,
    rtol: float = 1e-11,
) -> tuple[Array, Array]:
    """q and u at times from 0 on, by an explicit method of order 8."""
    nq = len(q)

    def slope(t: float, y: Array) -> Array:
        given = None if driven is None else driven(t)
        state, speeds = y[:nq], y[nq:]
        return np.concatenate(
            [rates(element, state, speeds), accelerations(element, state, speeds, free, given)]
        )

    run = solve_ivp(
        slope,
        (0.0, times[-1]),
        np.concatenate([q, u]),
        method="DOP853",
        t_eval=times,
        rtol=rtol,
        atol=rtol * 1e-3,
    )
    if not run.success:
        raise RuntimeError(run.message)
    return run.y[:nq].T, run.y[nq:].T
