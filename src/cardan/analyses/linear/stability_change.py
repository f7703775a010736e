"""Places in a family of linear models where motions begin or cease to grow.

Their number is bisected. Where an eigenvalue passes the axis at a finite rate its real part is then
brought to 0. Those of conservative systems meet on the axis and part like a root: the square of
their distance passes 0 at a finite rate, and is brought there.

Source: H. Ziegler, Principles of Structural Stability (1968), chapter 3; A. P. Seyranian, A. A.
Mailybaev, Multiparameter Stability Theory with Mechanical Applications (2003), chapters 1 and 5.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from scipy.optimize import brentq, linear_sum_assignment

from ...arrays import Complex, Integers
from ...errors import SolveError
from ...records import dataclass
from .family import Family, Member

CLOSE = 1e-15  # of the family: two places that are one
NARROW = 1e-4  # of the family: places between which an eigenvalue is followed to the axis
REAL = 1e-6  # of the largest modulus: imaginary parts that are none


@dataclass(frozen=True, eq=False)
class StabilityChange:
    """A change of stability along a family.

    Attributes:
        values: What changes, there.
        eigenvalue: On the axis [1/s].
        lost: Whether more motions grow behind it.
        kind: ``"flutter"`` or ``"divergence"``.
    """

    values: Mapping[str, float]
    eigenvalue: complex
    lost: bool
    kind: str

    @property
    def frequency(self) -> float:
        """Frequency of the motion that begins to grow [rad/s]."""
        return abs(self.eigenvalue.imag)


def follow(before: Member, after: Member) -> tuple[Integers, float]:
    """Places in a member of the eigenvalues of another, and how doubtful the worst is."""
    if len(before.values) != len(after.values):
        raise SolveError("the number of independent coordinates changes")
    alike = np.abs(before.shapes.conj().T @ after.shapes) ** 2
    size = max(before.spectrum.size, after.spectrum.size, 1e-300)
    # of what stands still shapes say nothing
    still = before.still[:, None] & after.still
    distances = np.abs(before.values[:, None] - after.values) / size
    costs = np.where(still, 0.0, 1 - alike) + distances
    # what moves does not become what stands still where it comes near
    parted = before.still[:, None] != after.still
    rows, columns = linear_sum_assignment(costs + parted)
    places = np.empty(len(rows), dtype=np.intp)
    places[rows] = columns
    return places, float(costs[rows, columns].max(initial=0.0))


@dataclass(frozen=True, eq=False)
class Interval:
    """The search between members of a family.

    Attributes:
        members: The family.
        rate: Its largest eigenvalue [1/s].
    """

    members: Family
    rate: float

    def n_unstable(self, member: Member) -> int:
        """Number of growing motions."""
        off = member.spectrum.rounding * self.rate / max(member.spectrum.size, 1e-300)
        return int(np.sum(member.values.real > off))

    def changes(self, low: Member, high: Member) -> list[StabilityChange]:
        """Changes of stability between two members, in their order."""
        changes = list[StabilityChange]()
        while self.n_unstable(low) != self.n_unstable(high) and high.s - low.s > CLOSE:
            near = self._bisected(low, high, 0.01 * NARROW)
            # a little further apart, where real parts are more than what counts as growth
            wide = (self.members.at(max(0.0, near[0].s - NARROW), near[0]),
                    self.members.at(min(1.0, near[1].s + NARROW), near[1]))  # fmt: skip
            change = None
            if self.n_unstable(wide[0]) != self.n_unstable(wide[1]):
                change = self._crossing_of_axis(*wide) or self._coalescence(*wide)
            changes.append(change or self._somewhere(*self._bisected(*near, CLOSE)))
            low = near[1]
        return changes

    def _bisected(self, below: Member, above: Member, width: float) -> tuple[Member, Member]:
        """Members this close, of which the first is like the one below and the other is not."""
        like = self.n_unstable(below)
        while above.s - below.s > width:
            middle = self.members.at(0.5 * (below.s + above.s), below)
            if middle.s in (below.s, above.s):
                break
            same = self.n_unstable(middle) == like
            below, above = (middle, above) if same else (below, middle)
        return below, above

    def _sides(self, below: Member, above: Member) -> tuple[Member, Member, bool]:
        """The member in which more motions grow, the other one, and whether that is the former."""
        lost = self.n_unstable(above) > self.n_unstable(below)
        return (above, below, lost) if lost else (below, above, lost)

    def _crossing_of_axis(self, below: Member, above: Member) -> StabilityChange | None:
        """Locate an eigenvalue that passes the imaginary axis at a finite rate.

        None where eigenvalues meet on the axis first, as those of conservative systems do.
        """
        grown, shrunk, lost = self._sides(below, above)
        places, _ = follow(grown, shrunk)
        decays = shrunk.values.real < -shrunk.spectrum.rounding
        through = grown.spectrum.unstable & decays[places]
        if not through.any():
            return None
        k = int(np.flatnonzero(through)[0])

        def passed(s: float) -> complex:
            member = self.members.at(s, grown)
            return complex(member.values[follow(grown, member)[0][k]])

        # one of several that pass together may have been followed to another
        if passed(below.s).real * passed(above.s).real >= 0:
            return None
        s = _root(lambda s: passed(s).real, below.s, above.s)
        value = passed(s)
        return self._change(s, value, lost, abs(value.imag) > REAL * self.rate)

    def _coalescence(self, below: Member, above: Member) -> StabilityChange | None:
        """Locate two eigenvalues that meet on the axis; None where they do not."""
        grown, _, lost = self._sides(below, above)
        k = int(np.where(grown.spectrum.unstable, grown.values.real, -np.inf).argmax())
        center = complex(0.0, grown.values[k].imag)

        def nearest(s: float) -> Complex:
            member = self.members.at(s, grown)
            values = member.values[~member.still]
            return np.asarray(values[np.abs(values - center).argsort()[:2]])

        def parted(s: float) -> float:
            two = nearest(s)
            return float(((two[0] - two[1]) ** 2).real) if len(two) == 2 else 0.0

        if parted(grown.s) <= 0 or parted(below.s) * parted(above.s) >= 0:
            return None
        s = _root(parted, below.s, above.s)
        met = complex(nearest(s).mean()) if len(nearest(s)) else center
        return self._change(s, met, lost, abs(center.imag) > grown.spectrum.rounding[k])

    def _somewhere(self, below: Member, above: Member) -> StabilityChange:
        """The change between two members that are next to each other."""
        grown, shrunk, lost = self._sides(below, above)
        places, _ = follow(grown, shrunk)
        rise = grown.values.real - shrunk.values[places].real
        k = int(np.where(grown.values.real > 0, rise, -np.inf).argmax())
        value = complex(grown.values[k])
        return self._change(below.s, value, lost, abs(value.imag) > grown.spectrum.rounding[k])

    def _change(self, s: float, value: complex, lost: bool, flutter: bool) -> StabilityChange:
        axis = complex(0.0, abs(value.imag) if flutter else 0.0)
        kind = "flutter" if flutter else "divergence"
        return StabilityChange(self.members.values_at(s), axis, lost, kind)


def _root(f: Callable[[float], float], low: float, high: float) -> float:
    return float(brentq(f, low, high, xtol=CLOSE, rtol=4 * float(np.finfo(float).eps)))
