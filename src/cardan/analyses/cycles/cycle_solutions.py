"""Cycles of a model, as the solutions that a path consists of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import final

import numpy as np

from ...arrays import Array
from ...errors import SolveError
from ...runtime.models.loaded_model import LoadedModel
from ..continuation.follow import Place, Step
from ..continuation.path_request import PathRequest, PathStart
from ..continuation.solutions import Quantity, Solutions
from ..continuation.special_points import FOLD, Corner, Onset, Special
from .cycle_family import CycleFamily, CyclePoint
from .cycle_quantities import quantity
from .cycle_record import CycleRecord, record_of
from .cycle_starts import DOUBLING, doubled, family_and_place
from .multipliers import NEUTRAL, REAL, unstable

TORUS = "torus point"
EDGE = 1e-9  # moduli that much above 1 count on a path


@final
@dataclass(frozen=True, eq=False)
class CycleSolutions:
    """Cycles of a model as something is swept.

    Attributes:
        model: The model.
        family: Its cycles.
    """

    model: LoadedModel
    family: CycleFamily

    def values(self, point: CyclePoint) -> Mapping[str, float]:
        """Same as :meth:`.Solutions.values`."""
        return self.family.way.values(point.s)

    def quantity(self, name: str) -> Quantity:
        """Same as :meth:`.Solutions.quantity`."""
        return quantity(self.family, name)

    def record(self, point: CyclePoint) -> CycleRecord:
        """Same as :meth:`.Solutions.record`."""
        family = self.family
        left = float(np.abs(family.residual(point)).max(initial=0.0))
        at, values = family.finished(point), family.multipliers(point)
        return record_of(family.problem, at, values, (left,), True, "a cycle of a path")

    def coordinates(self, point: CyclePoint) -> Array:
        """Same as :meth:`.Solutions.coordinates`."""
        return point.at.x[: self.model.nq]

    def multipliers(self, point: CyclePoint) -> Array:
        """Same as :meth:`.Solutions.multipliers`: those of constraints, which change in a lap."""
        return np.zeros(0)

    def stable(self, point: CyclePoint, prescribed: bool) -> bool | None:
        """Same as :meth:`.Solutions.stable`."""
        return unstable(self.family.multipliers(point)) == 0

    def count(self, place: Place) -> int | None:
        """Same as :meth:`.Solutions.count`."""
        # where energy is kept all moduli are 1, up to the rounding of differences
        edge = EDGE if self.family.problem.level is None else NEUTRAL
        return int(np.sum(np.abs(self.family.multipliers(place.point)) > 1 + edge))

    def growth(self, place: Place) -> tuple[float, float]:
        """Same as :meth:`.Solutions.growth`: of a pair, from lap to lap.

        Raises:
            SolveError: there is no pair.
        """
        values = self.family.multipliers(place.point)
        pairs = values[values.imag > REAL * np.abs(values)]
        if not len(pairs):
            raise SolveError("cycle: no pair of multipliers is complex")
        nearest = pairs[np.abs(np.log(np.abs(pairs))).argmin()]
        return float(np.log(np.abs(nearest))), float(np.angle(nearest))

    def corner(self, step: Step, number: int) -> Corner | None:
        """Same as :meth:`.Solutions.corner`: laps pass events, and end behind them."""
        return None

    @property
    def oscillation(self) -> str:
        """Same as :meth:`.Solutions.oscillation`."""
        return TORUS

    @property
    def onsets(self) -> Sequence[Onset]:
        """Same as :meth:`.Solutions.onsets`: a multiplier that passes -1."""

        def value(place: Place) -> float:
            M = self.family.monodromy(place.point)
            return float(np.linalg.det(M + np.eye(len(M))))

        return (Onset(DOUBLING, value),)

    def beginning(self, special: Special) -> tuple[Solutions, Place] | None:
        """Same as :meth:`.Solutions.beginning`: cycles of twice the laps at a period doubling."""
        if special.kind != DOUBLING:
            return None
        try:
            family, first = doubled(self.family, special.place.point)
        except SolveError:
            return None
        return CycleSolutions(self.model, family), first

    def consistent(self, point: CyclePoint) -> bool:
        """Same as :meth:`.Solutions.consistent`: none were left out."""
        return True

    def motion(self, dz: Array) -> Array:
        """Same as :meth:`.Solutions.motion`."""
        return dz[: len(self.family.problem.units)]

    def moving(self, dz: Array) -> str:
        """Same as :meth:`.Solutions.moving`."""
        model = self.model
        names = [*self.family.problem.system.increments, *model.speeds, *model.internals]
        return f"'{names[int(np.abs(self.motion(dz)).argmax())]}'"

    def description(self, special: Special) -> str:
        """Same as :meth:`.Solutions.description`."""
        if special.kind == FOLD:
            return "where two cycles meet, and there are none behind: a multiplier is 1"
        if special.kind == DOUBLING:
            return "where cycles of twice the period begin: a multiplier is -1"
        angle = special.frequency
        return f"where a torus begins: disturbances turn by {angle:.6g} rad from lap to lap"


def start(model: LoadedModel, request: PathRequest) -> PathStart:
    """The first cycle of a path.

    Raises:
        ModelError: nothing to start from, unknown names. SolveError: no cycle at the start.
    """
    family, place, end = family_and_place(model, request)
    return PathStart(CycleSolutions(family.problem.model, family), place, end)
