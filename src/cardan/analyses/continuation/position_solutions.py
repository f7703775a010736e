"""Positions of a mechanism, as the solutions that a path consists of.

A fold is a dead point of what drives; branches meet where conditions lose rank.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import final

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, near
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ..mechanisms.assemble import assemble_by_constraints
from ..mechanisms.assembly import AssemblyRecord
from ..mechanisms.consistent_rates import speeds
from ..mechanisms.mechanism import Mechanism, refuse_nodes
from ..statics.load_path import column
from ..statics.stability_at_equilibrium import largest_of
from ..statics.statics import sweepable
from .configurations import COORDINATE, Configuration, ConfigurationFamily, Drivers
from .first_places import first_places
from .follow import Place, Step, ahead
from .solutions import PathRequest, PathStart, Quantity, Solutions
from .special_points import HOPF, Corner, Onset, Special, Test

CLOSED = 1e-8  # residuals without units of conditions that are met, where others were solved


@final
@dataclass(frozen=True, eq=False)
class PositionSolutions:
    """Positions of a mechanism as its drivers move.

    Attributes:
        model: The model.
        family: Its positions.
    """

    model: LoadedModel
    family: ConfigurationFamily

    def values(self, point: Configuration) -> Mapping[str, float]:
        """Same as :meth:`.Solutions.values`."""
        model, drivers = self.model, self.family.drivers
        driven = {name: model.coordinates.index(name) for name in drivers.named(COORDINATE)}
        return drivers.values(point.s) | {name: float(point.q[k]) for name, k in driven.items()}

    def quantity(self, name: str) -> Quantity:
        """Same as :meth:`.Solutions.quantity`: a coordinate, an output, or what is swept."""
        model, drivers = self.model, self.family.drivers
        if name in model.coordinates:
            k = model.coordinates.index(name)
            return lambda at: float(at.q[k])
        if name in drivers.ranges:
            return lambda at: drivers.values(at.s)[name]
        outputs = [str(row.name) for row in model.manifest.outputs]
        if name in outputs:
            k = outputs.index(name)
            return lambda at: self._output(at, k)
        names = [*model.coordinates, *drivers.ranges, *outputs]
        raise ModelError(f"continuation: there is no '{name}' to watch.{near(name, names)}")

    def _output(self, at: Configuration, k: int) -> float:
        """A declared output where nothing moves."""
        m = self.family.drivers.mechanism(at.s)
        values: Array = m.evaluate("outputs", at.q, np.zeros(m.model.nu))
        return float(values[k])

    def record(self, point: Configuration) -> AssemblyRecord:
        """Same as :meth:`.Solutions.record`."""
        drivers = self.family.drivers
        m = drivers.mechanism(point.s)
        return AssemblyRecord(
            m.model, m.t, m.inputs, point.q, _least_speeds(m, point.q), None,
            gaps=m.gaps(point.q), unreached={}, freedoms=0, solutions=None, starts=1,
        )  # fmt: skip

    @property
    def kind(self) -> str:
        """Same as :attr:`.Solutions.kind`."""
        return "positions"

    def independent_residual(self, point: Configuration) -> tuple[Array, Array]:
        """Same as :meth:`.Solutions.independent_residual`: of all conditions, dependent ones too.

        Loops count by the functions of the model as well, which the path does not call.
        """
        drivers = self.family.drivers
        conditions = drivers.residual(point.s, point.q)
        loops = drivers.mechanism(point.s).residuals(point.q)
        missed = np.abs(np.concatenate([conditions, loops]))
        return missed, np.ones(len(missed))

    @property
    def residual_description(self) -> str:
        """Same as :attr:`.Solutions.residual_description`."""
        return "what loops, drivers and locks miss, over the size of the mechanism or in radians"

    def coordinates(self, point: Configuration) -> Array:
        """Same as :meth:`.Solutions.coordinates`."""
        return point.q

    def multipliers(self, point: Configuration) -> Array:
        """Same as :meth:`.Solutions.multipliers`: no forces act."""
        return np.zeros(0)

    def stable(self, point: Configuration, prescribed: bool) -> bool | None:
        """Same as :meth:`.Solutions.stable`: no forces act."""
        return None

    def count(self, place: Place) -> int | None:
        """Same as :meth:`.Solutions.count`: no forces act."""
        return None

    def growth(self, place: Place) -> tuple[float, float]:
        """Same as :meth:`.Solutions.growth`."""
        raise SolveError("nothing oscillates where no forces act")

    def corner(self, step: Step, number: int) -> Corner | None:
        """Same as :meth:`.Solutions.corner`: closed loops stay as they are."""
        return None

    @property
    def oscillation(self) -> str:
        """Same as :meth:`.Solutions.oscillation`: there is none."""
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
        """Same as :meth:`.Solutions.beginning`: none begin."""
        return None

    def consistent(self, point: Configuration) -> bool:
        """Same as :meth:`.Solutions.consistent`: of loops that are closed too often."""
        left = self.family.drivers.residual(point.s, point.q)
        return float(np.abs(left).max(initial=0.0)) <= CLOSED

    def motion(self, dz: Array) -> Array:
        """Same as :meth:`.Solutions.motion`."""
        return dz[: self.family.positions]

    def moving(self, dz: Array) -> str:
        """Same as :meth:`.Solutions.moving`."""
        rows = self.model.manifest.speeds
        owners = [str(row.of or row.joint or row.name) for row in rows]
        return largest_of(owners, self.model.speeds, self.motion(dz))

    def description(self, special: Special) -> str:
        """Same as :meth:`.Solutions.description`."""
        who = " and ".join(f"'{name}'" for name in self.family.drivers.ranges)
        back = "turn" if len(self.family.drivers.ranges) > 1 else "turns"
        return f"a dead point: {who} {back} back as {self.moving(special.place.tangent)} moves on"


def _least_speeds(m: Mechanism, q: Array) -> Array:
    """The least speeds (nu,) that constraints allow; NaN at a dead point of the time: none are."""
    try:
        return speeds(m, q, {}, np.zeros(m.model.nu))
    except ModelError:
        return np.full(m.model.nu, np.nan)


def start(model: LoadedModel, request: PathRequest) -> PathStart:
    """The first position of a path.

    Raises:
        ModelError: unknown names, freedoms that nothing drives or locks. ArgumentError: values of
            a wrong shape. SolveError: no position is found next to the start.
    """
    refuse_nodes(model, "continuation of positions")
    if request.u or request.start is not None:
        raise ModelError(
            "continuation of positions: u= and start= are of equilibria and cycles; q= says where "
            "it starts"
        )
    if any(joint.solved for joint in model.manifest.joints):
        raise ModelError(
            f"continuation of positions: model '{model.name}' solves loops in closed form; compile "
            "its scene with constraints='multipliers'"
        )
    drivers = _drivers(model, request)
    m, first = drivers.m, drivers.values(0.0)
    driven = {name: first[name] for name in drivers.named(COORDINATE)}
    targets = {**drivers.locked, **driven}
    begin = assemble_by_constraints(m.model, targets, start=request.q, t=m.t, r=m.inputs)
    drivers.check(begin.q)
    family = ConfigurationFamily.of(drivers)
    point = family.start(begin.q)
    named = ", ".join(f"{name} = {value:.10g}" for name, value in drivers.values(1.0).items())
    return PathStart(
        PositionSolutions(model, family),
        *first_places(family, point, ahead(family, point)),
        Test.at(named, 1.0, family),
    )


def _drivers(model: LoadedModel, request: PathRequest) -> Drivers:
    """The swept quantities, checked."""
    swept = {n: v for n, v in request.locked.items() if np.shape(v) == (2,)}
    locked = {n: v for n, v in request.locked.items() if n not in swept}
    swept = {**request.swept, **swept}
    places = {n: p for n, p in model.manifest.slots("q").items() if p.stop - p.start == 1}
    kind_of = dict.fromkeys(places, COORDINATE)
    kind_of = kind_of | {n: kind for n, kind in sweepable(model).items() if n not in kind_of}
    if not swept:
        raise ModelError(
            "continuation: say what is swept, from where to where, such as "
            f"continuation(crank=(0, 6.28), of='positions'). {near('', kind_of).strip()}"
        )
    ranges, kinds = dict[str, Array](), dict[str, str]()
    for name, values in swept.items():
        if name not in kind_of:
            raise ModelError(
                f"continuation: there is no coordinate, parameter or input '{name}' to sweep."
                f"{near(name, kind_of)}"
            )
        ranges[name], kinds[name] = column(f"continuation: {name}", values), kind_of[name]
        if len(ranges[name]) != 2 or ranges[name][0] == ranges[name][1]:
            raise ArgumentError(f"continuation: {name}: give (start, end), two different numbers")
    m = Mechanism(model.with_parameters(dict(request.parameters or {})), request.t, request.inputs)
    return Drivers(Drivers(m, ranges, kinds, locked).mechanism(0.0), ranges, kinds, locked)
