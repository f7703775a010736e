"""Singular positions of a mechanism: dead points of a driver, and points where branches meet.

The mechanism is followed along its path by the length of the path, which passes through dead
points. A driver is dead where it stands still while the rest moves on; branches meet where the
Jacobian of the constraints alone loses rank.

Source: W. Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, chapter 3 (test
functions along a path, location by bisection).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import final

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import LockedValues, checked
from ...arrays import Array
from ...errors import ArgumentError, ModelError, near
from ...runtime.calls.evaluation import State
from ...runtime.models.loaded_model import LoadedModel
from .assemble import assemble_by_constraints
from .mechanism import Mechanism, refuse_nodes
from .position_solver import PositionSolver
from .redundancy import rank_of
from .targets import locked_values, read

STEP = 0.05  # of the path, without units
MOST = 20000
LOCATED = 1e-12
ZERO = 1e-6  # singular values below this at a located minimum are zero
GOLDEN = 0.5 * (5**0.5 - 1)


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
        step: Along the path, in radians and sizes of the mechanism.
        t, r: Time [s] and inputs, where something is prescribed.

    Raises:
        ModelError: unknown names, more than one freedom, no position at the start of the range.
        ArgumentError: no range, a step that is not positive.
    """
    low, high = _range(over)
    for name in (coordinate, driver or coordinate):
        if name not in model.coordinates:
            raise ModelError(
                f"singular_positions: there is no coordinate '{name}'."
                f"{near(name, model.coordinates)}"
            )
    if not step > 0:
        raise ArgumentError(f"step={step:g}: the path goes forward by positive steps")
    refuse_nodes(model, "singular_positions")
    m = Mechanism(model, t, r)
    locked_targets = locked_values(m, locked)
    if not m.closing.positions or any(joint.solved for joint in model.manifest.joints):
        raise ModelError(
            f"singular_positions: model '{model.name}' has no loop constraints, or solves them in "
            "closed form; compile a scene with loops with constraints='multipliers'"
        )
    begin = assemble_by_constraints(
        model, {coordinate: low} | locked_targets, start=start, branch=branch, t=t, r=r
    )
    path = Path(m, locked_targets, coordinate, driver or coordinate, 1.0 if high > low else -1.0)
    return path.follow(begin.q, low, high, step)


def _range(over: object) -> tuple[float, float]:
    ends = np.asarray(over, dtype=np.float64)
    if ends.shape != (2,) or not np.isfinite(ends).all() or ends[0] == ends[1]:
        raise ArgumentError(f"the range is {over!r}; give (first, last), two finite numbers")
    return float(ends[0]), float(ends[1])


class Path:
    """A mechanism of one freedom along its path."""

    def __init__(
        self,
        m: Mechanism,
        locked_targets: Mapping[str, object],
        coordinate: str,
        driver: str,
        sign: float,
    ) -> None:
        """Args:
        m, hold: The mechanism and what keeps its value.
        coordinate, driver, sign: What is followed, what drives, which way.
        """
        self.m, self.sign = m, sign
        self.solver = PositionSolver(m, read(m, locked_targets))
        self.coordinate, self.driver = coordinate, driver
        self.place = m.model.coordinates.index(coordinate)
        self.drive = m.model.coordinates.index(driver)

    def tangent(self, q: Array, along: Array | None) -> tuple[Array, float]:
        """Unit tangent (nu,), next to an earlier one, and the smallest singular value.

        Raises:
            ModelError: more than one freedom.
        """
        K = self.solver.hard_jacobian(q)
        _, s, Vt = np.linalg.svd(K)
        nu = K.shape[1]
        if along is None:
            free = nu - rank_of(s)
            if free != 1:
                raise ModelError(
                    f"the mechanism has {free} degrees of freedom here; a path has one: give the "
                    "others by locked="
                )
            tangent = Vt[-1]
            rate = float((self.m.kinematics(q) @ tangent)[self.place])
            return tangent * (self.sign if rate >= 0 else -self.sign), float(s[nu - 2])
        # near a branch point two directions are almost free: take the part that goes straight on
        soft = Vt[nu - 1 :] if s[nu - 2] > ZERO else Vt[nu - 2 :]
        tangent = soft.T @ (soft @ along)
        return tangent / np.linalg.norm(tangent), float(s[nu - 2])

    def next(self, q: Array, tangent: Array, length: float) -> Array | None:
        """The position a length further, None where it is not near the tangent."""
        guess = self.m.advance(q, length * tangent)
        solution = self.solver.near(guess, abs(length))
        return None if solution is None else solution.q

    def rate(self, q: Array, tangent: Array) -> float:
        """Rate of the driver along the path, without units."""
        return float((self.m.kinematics(q) @ tangent)[self.drive])

    def follow(self, q: Array, low: float, high: float, step: float) -> Singular:
        """All singular positions until the range is left or the path closes."""
        positions, rows = list[Position](), [q]
        tangent, quality = self.tangent(q, None)
        qualities, tangents, first = [quality], [tangent], q
        ended = "the path is longer than was followed"
        for _ in range(MOST):
            # predictor along the tangent, then Newton back onto the singular set
            new, taken = self._forward(rows[-1], tangents[-1], step)
            if new is None:
                ended = "the path could not be followed further"
                break
            tangent, quality = self.tangent(new, tangents[-1])
            before = self.rate(rows[-1], tangents[-1])
            # the coordinate turns back between the two points: a dead point
            if before * self.rate(new, tangent) < 0:
                positions.append(self._dead(rows[-1], tangents[-1], taken))
            rows.append(new)
            tangents.append(tangent)
            qualities.append(quality)
            positions += self._branch(rows, tangents, qualities, step)
            value = float(new[self.place])
            if (value - high) * self.sign >= 0 or (value - low) * self.sign < -1e-9:
                ended = "the coordinate left its range"
                break
            if len(rows) > 3 and np.linalg.norm(self.m.difference(first, new)) < 0.6 * step:
                ended = "the path closed"
                break
        inside = [p for p in positions if min(low, high) - 1e-9 <= p.value <= max(low, high) + 1e-9]
        return Singular(
            self.m.model.name, self.coordinate, self.driver, tuple(inside), np.array(rows), ended
        )

    def _forward(self, q: Array, tangent: Array, step: float) -> tuple[Array | None, float]:
        """The next position by a step that is halved where needed."""
        length = step
        while length > 1e-8 * step:
            new = self.next(q, tangent, length)
            if new is not None:
                return new, length
            length *= 0.5
        return None, 0.0

    def _dead(self, q: Array, tangent: Array, length: float) -> Position:
        """Locate by bisection along the path the position at which the driver turns back."""
        low, high, here = 0.0, length, q
        before = self.rate(q, tangent)
        while high - low > LOCATED:
            middle = 0.5 * (low + high)
            if middle in (low, high):
                break
            new = self.next(q, tangent, middle)
            if new is None:
                break
            here = new
            same = before * self.rate(new, self.tangent(new, tangent)[0]) > 0
            low, high = (middle, high) if same else (low, middle)
        return self._position("dead point", here, tangent)

    def _branch(
        self, rows: list[Array], tangents: list[Array], qualities: list[float], step: float
    ) -> list[Position]:
        """A branch point between the last three positions, if the smallest value vanishes there."""
        if len(rows) < 3 or not qualities[-3] > qualities[-2] <= qualities[-1]:
            return []
        q, tangent = rows[-3], tangents[-3]

        def value(length: float) -> float:
            new = self.next(q, tangent, length)
            return np.inf if new is None else self.tangent(new, tangent)[1]

        ends = 0.0, 2 * step
        a, b = ends[1] - GOLDEN * ends[1], GOLDEN * ends[1]
        low, high = ends
        at_a, at_b = value(a), value(b)
        while high - low > 1e-10:
            if at_a <= at_b:
                high, b, at_b = b, a, at_a
                a = high - GOLDEN * (high - low)
                at_a = value(a)
            else:
                low, a, at_a = a, b, at_b
                b = low + GOLDEN * (high - low)
                at_b = value(b)
        new = self.next(q, tangent, 0.5 * (low + high))
        if new is None or self.tangent(new, tangent)[1] > ZERO:
            return []
        return [self._position("branch point", new, tangent)]

    def _position(self, kind: str, q: Array, tangent: Array) -> Position:
        return Position(kind, float(q[self.place]), q, self.tangent(q, tangent)[1])
