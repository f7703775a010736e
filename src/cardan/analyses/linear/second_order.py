"""Small motions as equations of second order: M y'' + (D + G) y' + (K + N) y = forces.

Damping and stiffness fall apart into what takes energy, what turns, what stores and what drives
around: a symmetric and a skew part each.

Source: R. E. Roberson, R. Schwertassek, Dynamics of Multibody Systems (1988), chapter 13; H.
Ziegler, Principles of Structural Stability (1968), chapter 3 (names of the parts).
"""

from __future__ import annotations

from typing import final

import numpy as np

from ...arrays import Array
from ...records import dataclass

MAX_PRINTED = 6


@final
@dataclass(frozen=True, repr=False, eq=False)
class SecondOrder:
    """M y'' + damping y' + K y = forces r: small motions y of coordinates.

    Attributes:
        name: Of the model.
        coordinates: Names of y (n,).
        M: Mass matrix (n, n): forces along the coordinates belong to it.
        damping: What multiplies y' (n, n): :attr:`dissipative` + :attr:`gyroscopic`.
        K: What multiplies y (n, n): :attr:`conservative` + :attr:`circulatory`.
        forces: What multiplies the inputs (n, nr).
        inner: What multiplies internal states (n, nz), on the right side too.
    """

    name: str
    coordinates: tuple[str, ...]
    M: Array
    damping: Array
    K: Array
    forces: Array
    inner: Array

    @property
    def dissipative(self) -> Array:
        """The symmetric part of what multiplies y' (n, n): D of chapter 13."""
        return 0.5 * (self.damping + self.damping.T)

    @property
    def gyroscopic(self) -> Array:
        """The skew part of what multiplies y' (n, n), which does no work: G."""
        return 0.5 * (self.damping - self.damping.T)

    @property
    def conservative(self) -> Array:
        """The symmetric part of what multiplies y (n, n), that of a potential: K."""
        return 0.5 * (self.K + self.K.T)

    @property
    def circulatory(self) -> Array:
        """The skew part of what multiplies y (n, n), of follower forces and the like: N."""
        return 0.5 * (self.K - self.K.T)

    def __repr__(self) -> str:
        more = ", ..." if len(self.coordinates) > MAX_PRINTED else ""
        lines = [
            f"'{self.name}' of second order in {', '.join(self.coordinates[:MAX_PRINTED])}{more}"
        ]
        parts = ("M", "dissipative", "gyroscopic", "conservative", "circulatory")
        for part in parts:
            matrix = getattr(self, part)
            if part != "M" and not np.any(np.abs(matrix) > 0):
                continue
            lines.append(f"  {part}")
            lines += [
                "".join(f"{x:14.6g}" for x in row[:MAX_PRINTED]) for row in matrix[:MAX_PRINTED]
            ]
        return "\n".join(lines)


def reduced(rows: Array, A: Array, z: int) -> tuple[Array, Array, Array]:
    """y'' = first y + second y' + inner z of quantities y = rows x whose equations are closed.

    Args:
        rows: y by x (k, n).
        A: Of x' = A x (n, n).
        z: How many of x are internal states, at its end.

    Returns:
        (k, k), (k, k), and what is left over: y'' by x (k, n) that y and y' do not tell.
    """
    rate = rows @ A
    both, after = np.concatenate([rows, rate]), rate @ A
    inside = len(A) - z
    # columns count by their size in y and y', or units would choose what is small
    coefficients = np.linalg.lstsq(both[:, :inside].T, after[:, :inside].T)[0].T
    k = len(rows)
    return coefficients[:, :k], coefficients[:, k:], after - coefficients @ both
