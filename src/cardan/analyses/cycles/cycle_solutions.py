"""Cycles of a model, as the solutions that a path consists of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import final

import numpy as np

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ...schema.integrators import INTEGRATORS
from ..continuation.follow import Place, Step
from ..continuation.solutions import PathRequest, PathStart, Quantity, Solutions
from ..continuation.special_points import FOLD, HOPF, Corner, Onset, Special, Test
from .cycle_family import CycleFamily, CyclePoint
from .cycle_problem import CycleProblem
from .cycle_quantities import quantity
from .cycle_record import CycleRecord, record_of
from .cycle_starts import DOUBLING, doubled, family_and_place
from .multipliers import NEUTRAL, REAL, unstable

TORUS, STILL = "torus point", "state of rest"
CHECKED_BY = (("DOP853", "RK45"), ("RK45", "DOP853"))  # methods that check each other
LOOSER = 10.0  # tolerance of these runs, of that of the path
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

    @property
    def kind(self) -> str:
        """Same as :attr:`.Solutions.kind`."""
        return "cycles"

    @cached_property
    def _other_runs(self) -> CycleProblem:
        """The problem with runs by another method, explicit or implicit as that of the path."""
        problem, how = self.family.problem, self.family.problem.how
        other = next((new for old, new in CHECKED_BY if old == how.method.name), how.method.name)
        how = replace(how, method=INTEGRATORS[other], rtol=LOOSER * how.rtol)
        return replace(problem, how=how, _flows={})

    def independent_residual(self, point: CyclePoint) -> tuple[Array, Array]:
        """Same as :meth:`.Solutions.independent_residual`: of a lap by another method."""
        problem, at = self._other_runs, self.family.finished(point)
        missed = np.abs(problem.step(at.x, problem.lap(at).x))
        return missed, np.ones(len(missed))

    @property
    def residual_description(self) -> str:
        """Same as :attr:`.Solutions.residual_description`."""
        how = self._other_runs.how
        return (
            f"what a lap by {how.method.name} at rtol={how.rtol:.0e} misses its start by, over the "
            "ranges of the motion"
        )

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
        return unstable(self.family.multipliers(place.point), edge)

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

    @property
    def ends(self) -> Sequence[Test]:
        """Same as :meth:`.Solutions.ends`: at rest, behind which cycles are the same mirrored.

        There what turns back at the phase stands still.
        """
        phase, problem = self.family.shooting.phase, self.family.problem
        if phase is None:
            return ()

        def value(place: Place) -> float:
            rate = problem.rate(place.point.at)
            return float(np.copysign(np.linalg.norm(rate), phase.normal @ rate))

        kind = HOPF if problem.level is None else STILL
        name = f"a {kind}: the cycle shrinks to rest"
        return (Test(name, value, ends=True, kind=kind),)

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
        if special.kind in (HOPF, STILL):
            frequency = 2 * np.pi / special.place.point.at.period
            return f"where the cycle shrinks to rest, at {frequency:.6g} rad/s"
        angle = special.frequency
        return f"where a torus begins: disturbances turn by {angle:.6g} rad from lap to lap"


def start(model: LoadedModel, request: PathRequest) -> PathStart:
    """The first cycle of a path.

    Raises:
        ModelError: nothing to start from, unknown names. SolveError: no cycle at the start.
    """
    family, place, end = family_and_place(model, request)
    return PathStart(CycleSolutions(family.problem.model, family), [place], [], end)
