"""Interface of centerlines along which a beam may lie; each is one file."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from typing import ClassVar

from ...arrays import Array
from ...records import dataclass
from ..quantity import Quantity

# of numbers that a user types, against the length of the line
TOLERANCE = 1e-6


@dataclass(frozen=True)
class Curve:
    """A line in numbers.

    Attributes:
        length: Its arc length [m].
        at: Arc lengths (n,) -> positions (n, 3) and unit tangents (n, 3).
    """

    length: float
    at: Callable[[Array], tuple[Array, Array]]


class Centerline(ABC):
    """A line from the start of a beam to its end, in ground axes at the reference configuration."""

    kind: ClassVar[str]

    @abstractmethod
    def quantities(self) -> dict[str, Quantity]:
        """The user's values by name; evaluated at the values of the parameters."""

    @abstractmethod
    def curve(self, start: Array, end: Array, data: Mapping[str, Array]) -> Curve:
        """The line between two points.

        Args:
            start, end: The ends of the beam (3,).
            data: Its quantities, (3,) or (n, 3).

        Raises:
            ModelError: no such line leads from one to the other.
        """
