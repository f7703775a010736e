"""What signs at both ends of a part of a step tell of what lies within."""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...records import dataclass
from .family import Family
from .follow import Place, reversals

FLAT = 1e-10  # rates of a parameter that stays where it is


@dataclass(frozen=True, eq=False)
class Interval:
    """A part of a step.

    Attributes:
        low, high: Its ends, 0 to 1.
        before, after: The places there.
        counts: Unstable directions there.
        onsets: Signs of other changes of stability there.
        reversed: Directions in which J changes its sign in between, where counts are not known.
    """

    low: float
    high: float
    before: Place
    after: Place
    counts: tuple[int | None, int | None]
    onsets: tuple[Array, Array]
    reversed: int

    @classmethod
    def of(
        cls, family: Family, ends: tuple[float, float], before: Place, after: Place,
        counts: tuple[int | None, int | None], onsets: tuple[Array, Array],
    ) -> Interval:  # fmt: skip
        """The part between two places."""
        signs = reversals(family, before, after) if None in counts else 0
        return cls(*ends, before, after, counts, onsets, signs)

    def chord(self, family: Family) -> Array:
        """The increment between its ends (N,)."""
        return family.step(self.before.point, self.after.point)

    @property
    def folds(self) -> bool:
        """True when the parameter turns back an odd number of times."""
        rates = self.before.parameter_rate, self.after.parameter_rate
        return rates[0] * rates[1] < 0 and max(map(abs, rates)) > FLAT

    @property
    def crosses(self) -> bool:
        """True when an odd number of curves crosses."""
        return self.before.orientation * self.after.orientation < 0

    @property
    def change(self) -> int:
        """Change of the number of unstable directions; 0 where it is not known."""
        before, after = self.counts
        return self.reversed if before is None or after is None else after - before

    @property
    def unexplained(self) -> int:
        """The part of it that folds, simple crossings and onsets do not explain."""
        if None in self.counts:
            return max(self.reversed - int(self.crosses), 0)
        explained = int(self.folds) + int(self.crosses) + len(self.begins)
        surplus = abs(self.change) - explained
        # a fold and a crossing may also undo one another
        return 0 if surplus == -2 and self.change == 0 else max(surplus, 0)

    @property
    def begins(self) -> list[int]:
        """Onsets that lie within."""
        return np.flatnonzero(self.onsets[0] * self.onsets[1] < 0).tolist()

    @property
    def quiet(self) -> bool:
        """True when nothing lies within, as far as the ends tell."""
        return not (self.folds or self.crosses or self.unexplained or self.begins)
