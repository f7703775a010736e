"""Singular positions of a mechanism: dead points of a driver, and points where branches meet.

The mechanism is followed by the length of its path, as ``model.continuation(of="positions")`` does.
A driver is dead where it stands still while the rest moves on; branches meet where the Jacobian of
the constraints alone loses rank.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import final

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import LockedValues, checked
from ...arrays import Array
from ...errors import ArgumentError, ModelError, near
from ...records import dataclass
from ...runtime.calls.evaluation import State
from ...runtime.models.loaded_model import LoadedModel
from ..continuation.configurations import COORDINATE, ConfigurationFamily, Drivers
from ..continuation.curve import Curve
from ..continuation.follow import SHORTEST, Place, Reach, ahead, place
from ..continuation.interval import FLAT
from ..continuation.special_points import BRANCH, FOLD, Test, Watch
from ..continuation.tracing import trace
from .assemble import assemble_by_constraints
from .mechanism import Mechanism, refuse_nodes
from .position_solver import PositionSolver
from .targets import locked_values, read

STEP = 0.05  # of the path, without units
MOST = 20000
DEAD, OUTSIDE = "dead point", "range"
INSIDE = 1e-9  # beyond a range: inside of it
ENDED = {
    "finished": "the coordinate left its range",
    "closed": "the path closed",
    "singular": "the path could not be followed further",
    "budget": "the path is longer than was followed",
}


@dataclass(frozen=True, eq=False)
class Position:
    """One singular position.

    Attributes:
        kind: ``"dead point"`` of the driver, or ``"branch point"`` of the mechanism.
        value: Of the coordinate that was followed.
        q: Coordinates (nq,).
        quality: Smallest singular value of the constraints, without units.
    """

    kind: str
    value: float
    q: Array
    quality: float


@final
@dataclass(frozen=True, repr=False, eq=False)
class Singular:
    """Singular positions along the path of a mechanism.

    Attributes:
        name: Of the model.
        coordinate, driver: What was followed, and what drives.
        positions: In the order of the path.
        path: Positions passed (n, nq).
        ended: Why the path ended, in words.
    """

    name: str
    coordinate: str
    driver: str
    positions: tuple[Position, ...]
    path: Array
    ended: str

    def __len__(self) -> int:
        return len(self.positions)

    @checked
    def values(self, kind: str = "dead point") -> Array:
        """The coordinate at all positions of a kind."""
        return np.array([p.value for p in self.positions if p.kind == kind])

    def __repr__(self) -> str:
        lines = [
            f"'{self.name}' along '{self.coordinate}', driven by '{self.driver}': "
            f"{len(self)} singular positions; {self.ended}"
        ]
        for p in self.positions:
            what = f"dead point of '{self.driver}'" if p.kind == "dead point" else "branches meet"
            lines.append(f"  {self.coordinate} = {p.value:.9g}: {what}")
        return "\n".join(lines)


@checked
def singular_positions(
    model: LoadedModel,
    coordinate: str,
    over: tuple[float, float],
    *,
    driver: str | None = None,
    locked: LockedValues | None = None,
    start: Mapping[str, ArrayLike] | ArrayLike | None = None,
    branch: Mapping[str, object] | None = None,
    step: float = STEP,
    t: float = 0.0,
    r: State | None = None,
) -> Singular:
    """Find positions at which a driver is dead or branches meet, over a range of a coordinate.

    Args:
        model: The compiled model, with one freedom but for ``locked``.
        coordinate: Followed from the first to the second end of the range, or until it returns.
        over: Its range.
        driver: Coordinate that drives; the same if left out.
        locked: Coordinates and frames that keep their values.
        start, branch: As ``assemble`` takes them.
        step: Along the path, in radians and sizes of the mechanism, up to pi.
        t, r: Time [s] and inputs, where something is prescribed.

    Raises:
        ModelError: unknown names, more than one freedom, no position at the start of the range.
        ArgumentError: no range, a step that no path can have.
    """
    low, high = _range(over)
    driver = coordinate if driver is None else driver
    for argument, name in (("coordinate", coordinate), ("driver", driver)):
        if name not in model.coordinates:
            raise ModelError(
                f"singular_positions: {argument}: there is no coordinate '{name}'."
                f"{near(name, model.coordinates)}"
            )
    # half a turn farther on angles say the same, and a step may lead anywhere
    if not SHORTEST <= step <= math.pi:
        raise ArgumentError(
            f"step={step:g}: the path goes forward by positive steps; give a length from "
            f"{SHORTEST:g} to pi, such as {STEP:g}"
        )
    refuse_nodes(model, "singular_positions")
    m = Mechanism(model, t, r)
    targets = locked_values(m, locked)
    if not m.closing.positions or any(joint.solved for joint in model.manifest.joints):
        raise ModelError(
            f"singular_positions: model '{model.name}' has no loop constraints, or solves them in "
            "closed form; compile a scene with loops with constraints='multipliers'"
        )
    begin = assemble_by_constraints(
        model, {coordinate: low} | targets, start=start, branch=branch, t=t, r=r
    )
    ends = {coordinate: np.array([low, high])}
    drivers = Drivers(m, ends, {coordinate: COORDINATE}, targets)
    drivers.check(begin.q)
    family = ConfigurationFamily.of(drivers)
    first = family.start(begin.q)
    curve = Curve(family, [place(family, first, ahead(family, first))])
    watch = Watch(lambda _: None, tests=_tests(m, coordinate, driver), most=MOST, switches=False)
    trace(curve, watch, Reach(first=step, longest=step))
    return _record(m, targets, curve, coordinate, driver, (low, high))


def _range(over: object) -> tuple[float, float]:
    ends = np.asarray(over, dtype=np.float64)
    if ends.shape != (2,) or not np.isfinite(ends).all() or ends[0] == ends[1]:
        raise ArgumentError(f"the range is {over!r}; give (first, last), two finite numbers")
    return float(ends[0]), float(ends[1])


def _tests(m: Mechanism, coordinate: str, driver: str) -> list[Test]:
    """Ends of the range, and where a driver other than the coordinate turns back."""
    tests = [
        Test(OUTSIDE, lambda at: at.point.s - 1.0, ends=True),
        Test(OUTSIDE, lambda at: at.point.s, ends=True),
    ]
    if driver == coordinate:
        return tests
    k = m.model.coordinates.index(driver)

    def rate(at: Place) -> float:
        value = float(m.kinematics(at.point.q)[k] @ at.tangent[:-1])
        return value if abs(value) > FLAT else 0.0

    return [*tests, Test(DEAD, rate)]


def _record(
    m: Mechanism,
    targets: Mapping[str, object],
    curve: Curve,
    coordinate: str,
    driver: str,
    over: tuple[float, float],
) -> Singular:
    """The singular positions of a curve within the range of its coordinate."""
    k, solver = m.model.coordinates.index(coordinate), PositionSolver(m, read(m, targets))
    positions = list[Position]()
    for special in curve.special:
        dead = special.kind == FOLD if driver == coordinate else special.label == DEAD
        if not dead and special.kind != BRANCH:
            continue
        q: Array = special.place.point.q
        values = np.linalg.svd(solver.hard_jacobian(q), compute_uv=False)
        if min(over) - INSIDE <= q[k] <= max(over) + INSIDE:
            kind = DEAD if dead else BRANCH
            positions.append(Position(kind, float(q[k]), q, float(values[m.nu - 2])))
    path = np.array([at.point.q for at in curve.places])
    return Singular(m.model.name, coordinate, driver, tuple(positions), path, ENDED[curve.status])
