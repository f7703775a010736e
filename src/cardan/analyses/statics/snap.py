"""The record of a jump between two minima of the strain energy."""

from __future__ import annotations

from collections.abc import Mapping

from ...arrays import Array
from ...records import dataclass


@dataclass(frozen=True, eq=False)
class Snap:
    """A jump from the end of a path of minima to another minimum.

    Attributes:
        values: Of the drivers, by name.
        before, after: Coordinates (nq,) at the end of the one path and at the start of the other.
        released: Strain energy that is set free [J].
    """

    values: Mapping[str, float]
    before: Array
    after: Array
    released: float

    def __repr__(self) -> str:
        where = ", ".join(f"{name} = {value:.6g}" for name, value in self.values.items())
        return f"snap at {where}, which releases {self.released:.6g} J"
