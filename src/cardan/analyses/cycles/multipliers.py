"""Multipliers of a cycle: how small disturbances grow from lap to lap."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array

Complexes: TypeAlias = NDArray[np.complex128]
REAL = 1e-9  # imaginary parts, as parts of the modulus, that are rounding
NEUTRAL = 1e-6  # moduli that much above 1 are 1


def monodromy(DP: Array, along: Array | None, gradient: Array | None = None) -> Array:
    """The derivative of a lap across the flow.

    Args:
        DP: The derivative (n, n).
        along: Direction (n,) of the flow, which a lap leaves as it is; None where laps end at a
            section or at a time.
        gradient: That (n,) of what a lap keeps, such as an energy; None without.

    Returns:
        (n, n), or less across.
    """
    rows = [row for row in (along, gradient) if row is not None and np.any(row)]
    if not rows:
        return DP
    across = np.linalg.svd(np.array(rows))[2][len(rows) :].T
    return np.asarray(across.T @ DP @ across)


def multipliers_of(M: Array, lost: int) -> Complexes:
    """Eigenvalues of a monodromy matrix by their moduli, the largest first.

    Args:
        M: The matrix (n, n).
        lost: Smallest ones that are left out: 0 by what a lap begins at.
    """
    values = np.linalg.eigvals(M).astype(np.complex128)
    order = np.lexsort((-values.imag, -values.real, -np.round(np.abs(values), 12)))
    return np.asarray(values[order][: max(0, len(values) - lost)])


def unstable(multipliers: Complexes, edge: float = NEUTRAL) -> int:
    """Number of multipliers outside of the unit circle, by more than an edge."""
    return int(np.sum(np.abs(multipliers) > 1 + edge))
