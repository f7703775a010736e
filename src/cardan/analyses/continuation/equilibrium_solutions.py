"""Equilibria under loads, as the solutions that a path consists of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import final

import numpy as np

from ...arrays import Array
from ...errors import ModelError, SolveError
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ..statics.equilibrium import WAYS, EquilibriumRecord, missed, read
from ..statics.equilibrium import record as equilibrium_record
from ..statics.force_balance import UNITS, balance
from ..statics.load_path import loading
from ..statics.newton import Search
from ..statics.settling import settled
from ..statics.stability_at_equilibrium import largest_motions
from ..statics.static_problem import Problem
from ..statics.statics import sweepable
from ..systems import dynamic_system_of
from .equilibria import EquilibriumFamily, Loaded
from .family import along_parameter
from .first_places import first_places
from .follow import Place, Step
from .mode_changes import corner_within
from .quantities import quantity
from .solutions import PathRequest, PathStart, Quantity, Solutions
from .special_points import FOLD, HOPF, Corner, Onset, Special, Test
from .stability_cache import StabilityCache


@final
@dataclass(frozen=True, eq=False)
class EquilibriumSolutions:
    """Equilibria of a model under loads.

    Attributes:
        model: The model.
        family: Its equilibria.
        stabilities: Their stability.
    """

    model: LoadedModel
    family: EquilibriumFamily
    stabilities: StabilityCache

    @classmethod
    def of(cls, model: LoadedModel, family: EquilibriumFamily) -> EquilibriumSolutions:
        """The equilibria of a family."""
        return cls(model, family, StabilityCache(family.problem))

    def values(self, point: Loaded) -> Mapping[str, float]:
        """Same as :meth:`.Solutions.values`."""
        return self.family.way.values(point.s)

    def quantity(self, name: str) -> Quantity:
        """Same as :meth:`.Solutions.quantity`."""
        return quantity(self.model, self.family, name)

    def record(self, point: Loaded) -> EquilibriumRecord:
        """Same as :meth:`.Solutions.record`."""
        search = Search(point.point, 0, True, np.zeros(0))
        stability = self.stabilities.stability(point)
        return equilibrium_record(self.model, self.family.problem, search, point.load, stability)

    @property
    def kind(self) -> str:
        """Same as :attr:`.Solutions.kind`."""
        return "equilibria" if self.family.way.base.u is None else "steady motions"

    def independent_residual(self, point: Loaded) -> tuple[Array, Array]:
        """Same as :meth:`.Solutions.independent_residual`: by a system with these parameters."""
        parameters = point.load.parameters
        model = self.model.with_parameters(dict(parameters)) if parameters else self.model
        problem, load = Problem(dynamic_system_of(model)), replace(point.load, parameters=None)
        at = problem.under(point.point, load)
        tangent = problem.tangent(at, load)
        forces = balance(problem, at, load, tangent)
        # where forces are 0 by symmetry, those of a motion of the size of the mechanism
        moved = abs(tangent[0]) @ np.ones(len(forces.left))
        sizes = np.maximum(forces.rounding / UNITS, moved)
        gaps = np.abs(problem.residual(at, load)[1])
        return np.append(forces.left, gaps), np.append(sizes, np.ones(len(gaps)))

    @property
    def residual_description(self) -> str:
        """Same as :attr:`.Solutions.residual_description`."""
        return (
            "forces that are left, over the largest that meet in their row on the branch or that a "
            "radian or the size of the mechanism makes; what loops miss, over that size"
        )

    def coordinates(self, point: Loaded) -> Array:
        """Same as :meth:`.Solutions.coordinates`."""
        return point.point.at.q

    def multipliers(self, point: Loaded) -> Array:
        """Same as :meth:`.Solutions.multipliers`."""
        return point.point.at.lam

    def stable(self, point: Loaded, prescribed: bool) -> bool | None:
        """Same as :meth:`.Solutions.stable`."""
        stability = self.stabilities.stability(point)
        return (stability if prescribed else stability.under_dead_load).stable

    def count(self, place: Place) -> int | None:
        """Same as :meth:`.Solutions.count`."""
        return self.stabilities.count(place)

    def growth(self, place: Place) -> tuple[float, float]:
        """Same as :meth:`.Solutions.growth`."""
        return self.stabilities.growth(place)

    def corner(self, step: Step, number: int) -> Corner | None:
        """Same as :meth:`.Solutions.corner`: where stops, latches and friction change."""
        names = [row.name for row in self.model.manifest.events]
        return corner_within(self.family, names, step, number)

    @property
    def oscillation(self) -> str:
        """Same as :meth:`.Solutions.oscillation`."""
        return HOPF

    @property
    def onsets(self) -> Sequence[Onset]:
        """Same as :meth:`.Solutions.onsets`: there are none."""
        return ()

    @property
    def ends(self) -> Sequence[Test]:
        """Same as :meth:`.Solutions.ends`: nowhere."""
        return ()

    def beginning(self, special: Special) -> tuple[Solutions, Place] | None:
        """Same as :meth:`.Solutions.beginning`: limit cycles have paths of their own."""
        return None

    def consistent(self, point: Loaded) -> bool:
        """Same as :meth:`.Solutions.consistent`: none were left out."""
        return True

    def motion(self, dz: Array) -> Array:
        """Same as :meth:`.Solutions.motion`."""
        return dz[: self.family.positions]

    def moving(self, dz: Array) -> str:
        """Same as :meth:`.Solutions.moving`."""
        return largest_motions(self.family.problem.system, self.motion(dz))

    def description(self, special: Special) -> str:
        """Same as :meth:`.Solutions.description`."""
        if special.kind == FOLD:
            return f"where the load turns back as {self.moving(special.place.tangent)} moves on"
        return f"where an oscillation of {special.frequency:.6g} rad/s begins"


def start(model: LoadedModel, request: PathRequest) -> PathStart:
    """The first equilibrium of a path.

    Raises:
        ModelError: unknown names, values within a range, an empty range. SolveError: no
            equilibrium.
    """
    if request.start is not None:
        raise ModelError(
            "continuation of equilibria: start= is of cycles, of='cycles'; q= says where "
            "equilibria start"
        )
    moved = {n: v for n, v in request.locked.items() if np.ndim(v) > 0}
    still = {n: v for n, v in request.locked.items() if n not in moved}
    system = dynamic_system_of(model)
    speeds = {n: v for n, v in (request.u or {}).items() if np.ndim(np.asarray(v)) > 0}
    steady = {n: v for n, v in (request.u or {}).items() if n not in speeds}
    u = None if request.u is None else {**steady, **dict.fromkeys(speeds, 0.0)}
    base = read(system, still, request.inputs, request.parameters, request.t, u)
    kinds = sweepable(model)
    way = loading(system, kinds, base, request.swept, moved, "continuation", speeds)
    if way.stations is not None:
        raise ModelError("continuation: give (start, end) of what is swept, and no values within")
    if all(column[0] == column[-1] for column in way.swept.values()):
        raise ModelError(
            f"continuation: {', '.join(way.swept)} ends where it starts: give another end"
        )
    problem, load = Problem(system), way.at(0.0)
    first = settled(problem, problem.begin(load, request.q), load, WAYS)
    if not first.converged:
        raise SolveError(f"continuation, at the start: {missed(system, first, load)}")
    family = EquilibriumFamily.of(problem, way, first.point)
    named = ", ".join(f"{name} = {value:.10g}" for name, value in way.values(1.0).items())
    return PathStart(
        EquilibriumSolutions.of(model, family),
        *first_places(family, family.start(first.point), along_parameter(family)),
        Test.at(named, 1.0, family),
    )
