"""Frequencies and frequency response of reduced matrices at their interfaces."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Array, Complex, Integers
from ..errors import ArgumentError, SolveError, counted
from ..records import dataclass
from .eigenproblem import dense_modes

MASSLESS = 1e-12  # of the largest mass: what rounding leaves of none
FASTEST = 1e30  # so that squares of frequencies do not overflow [rad/s]
MAX_PRINTED = 12  # of frequencies
RESONANT = 1e13  # condition of a dynamic stiffness beyond which there is no response


@dataclass(frozen=True, eq=False)
class ReducedModes:
    """Modes of a reduced component, rigid motions left out.

    Attributes:
        frequencies: omega (modes,) [rad/s].
        shapes: In the reduced coordinates, of unit modal mass (n, modes).
        displacements: In the rows of the nodes (rows, modes).
        bounds: An exact frequency lies within this relative distance (modes,).
        estimates: Of the relative errors, which use the distances of the frequencies (modes,).
        n_rigid: Number of rigid motions that are left out.
        locked: Motions of interfaces that were fixed.
    """

    frequencies: Array
    shapes: Array
    displacements: Array
    bounds: Array
    estimates: Array
    n_rigid: int
    locked: tuple[str, ...]

    def __repr__(self) -> str:
        where = f", {', '.join(self.locked)} fixed" if self.locked else ", all interfaces free"
        lines = [
            f"{counted(len(self.frequencies), 'mode')}{where}, {self.n_rigid} rigid",
            "        frequency [rad/s]    error, bound  error, estimate",
        ]
        for k in range(min(len(self.frequencies), MAX_PRINTED)):
            lines.append(
                f"  {k + 1:>3} {self.frequencies[k]:>18.9g} {self.bounds[k]:>14.1e} "
                f"{self.estimates[k]:>15.1e}"
            )
        more = len(self.frequencies) - MAX_PRINTED
        return "\n".join([*lines, *([f"  ... {more} more"] if more > 0 else [])])


def free_motions(rigid: Array, locked: Integers) -> Array:
    """Rigid motions (n, r') that leave locked coordinates where they are.

    Args:
        rigid: All rigid motions (n, r).
        locked: Coordinates.
    """
    if not rigid.shape[1] or not len(locked):
        return rigid
    _, values, directions = np.linalg.svd(rigid[locked], full_matrices=True)
    rank = int((values > 1e-9 * max(values.max(initial=0.0), 1e-300)).sum())
    motions: Array = rigid @ directions[rank:].T
    return motions


def reduced_modes(
    M: Array, K: Array, rigid: Array, locked: Integers, massless: int
) -> tuple[Array, Array]:
    """Frequencies [rad/s] and shapes (n, modes) of unit modal mass, without rigid motions.

    Args:
        M, K: Reduced matrices (n, n).
        rigid: Rigid motions in the coordinates (n, r).
        locked: Coordinates that are 0.
        massless: Shapes without mass: their infinite frequencies are dropped by their number.
    """
    from scipy.linalg import null_space

    n = len(M)
    free = np.setdiff1d(np.arange(n), locked)
    mobile = free_motions(rigid, locked)[free]
    within = np.eye(n)[:, free]
    if mobile.shape[1]:
        # shapes that balance the rigid motions, compared in units of their masses: motions
        # of interfaces have other units than modal coordinates
        masses, moved = M.diagonal()[free].copy(), mobile.any(axis=1)
        for group in (moved, ~moved):
            masses[group] = np.maximum(masses[group], MASSLESS * masses[group].max(initial=0.0))
        scale = 1 / np.sqrt(np.maximum(masses, 1e-300))
        balance = (mobile.T @ M[np.ix_(free, free)]) * scale
        balance /= np.linalg.norm(balance, axis=1, keepdims=True)
        within = within @ (scale[:, None] * null_space(balance))
    stiff, mass = within.T @ K @ within, within.T @ M @ within
    count = len(stiff) - max(0, massless - len(locked)) if massless else None
    omega, shapes = dense_modes((stiff + stiff.T) / 2, (mass + mass.T) / 2, count)
    return omega, within @ shapes


def frequencies_of(values: ArrayLike, who: str) -> Array:
    """Angular frequencies of a response.

    Raises:
        ArgumentError: not a row of finite numbers.
    """
    omega = np.atleast_1d(np.asarray(values, dtype=float))
    if omega.ndim != 1 or not (abs(omega) < FASTEST).all():
        raise ArgumentError(
            f"{who}: give frequencies as a row of finite numbers below {FASTEST:g} rad/s"
        )
    return omega


def impedance(M: Array, C: Array, K: Array, n_boundary: int, omega: Array) -> Complex:
    """Dynamic stiffness of the interfaces (frequencies, n_b, n_b) [N/m, N, N m].

    Raises:
        SolveError: at a frequency of the component with all interfaces fixed, without damping.
    """
    n = n_boundary
    result = np.empty((len(omega), n, n), dtype=complex)
    for k, one in enumerate(omega):
        Z = K - one**2 * M + 1j * one * C
        inner = Z[n:, n:]
        _solvable(inner, one, "all interfaces fixed")
        result[k] = Z[:n, :n] - Z[:n, n:] @ np.linalg.solve(inner, Z[n:, :n])
    return result


def admittance(M: Array, C: Array, K: Array, n_boundary: int, omega: Array) -> Complex:
    """Motions of the interfaces by forces there (frequencies, n_b, n_b) [m/N, rad/(N m)].

    Raises:
        SolveError: at a frequency of the component with all interfaces free, without damping.
    """
    n = n_boundary
    result = np.empty((len(omega), n, n), dtype=complex)
    for k, one in enumerate(omega):
        Z = K - one**2 * M + 1j * one * C
        _solvable(Z, one, "all interfaces free")
        result[k] = np.linalg.solve(Z, np.eye(len(M), n))[:n]
    return result


def _solvable(Z: Complex, omega: float, how: str) -> None:
    """Refuse a dynamic stiffness at a resonance."""
    if not len(Z):
        return
    scale = 1 / np.sqrt(np.maximum(abs(Z).max(axis=1), 1e-300))
    if np.linalg.cond(scale[:, None] * Z * scale) > RESONANT:
        raise SolveError(
            f"{omega:.9g} rad/s is a frequency of the component with {how}: the response has no "
            "bound there. Give it damping=, or another frequency"
        )


def modal_damping(modes: tuple[Array, Array], M: Array, ratios: Array) -> Array:
    """C (n, n) with a damping ratio for every mode; rigid motions are not damped.

    Args:
        modes: Frequencies [rad/s] and shapes of unit modal mass of the free component.
        M: Reduced mass (n, n).
        ratios: Of the lowest modes; the last one is for those above too.
    """
    omega, shapes = modes
    every = np.concatenate([ratios, np.full(max(0, len(omega) - len(ratios)), ratios[-1])])
    momentum = M @ shapes
    C = (momentum * (2 * every[: len(omega)] * omega)) @ momentum.T
    return (C + C.T) / 2
