"""What a method of reduction gives: shapes of a component, its matrices in them, frequencies."""

from __future__ import annotations

from ...arrays import Array
from ...records import dataclass


@dataclass(frozen=True)
class ReducedBasis:
    """Shapes of a component, motions of its interfaces first, then modal coordinates.

    Stiffness does not couple motions of interfaces with modal coordinates, and modal mass is 1.

    Attributes:
        shapes: In the unknowns of the component (n_b + n_i, n).
        M, K: Mass and stiffness in these shapes (n, n).
        frequencies: Of the modes that were chosen [rad/s].
        dropped: Of the first modes that were left out [rad/s].
        modes_of: What these are modes of, for messages.
        massless: Number of shapes without mass, whose frequency is infinite.
    """

    shapes: Array
    M: Array
    K: Array
    frequencies: Array
    dropped: Array
    modes_of: str
    massless: int = 0
