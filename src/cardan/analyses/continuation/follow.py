"""Follow a curve of solutions by its length.

Each step goes along the tangent and is corrected by Newton's method across it. Its length keeps
corrections quick and the turn of the tangent small; it is halved where they are not.

Source: H. B. Keller, Applications of Bifurcation Theory (1977), 359-384 (pseudo arc length);
R. Seydel, Practical Bifurcation and Stability Analysis (2010), section 4.5 (step control);
P. Deuflhard, B. Fiedler, P. Kunkel, SIAM J. Numer. Anal. 24 (1987), 912-927 (contraction).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np
from scipy.linalg import eigvals
from scipy.optimize import brentq

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from .family import Bordered, DenseJacobian, Family, Jacobian, Point, length, row

NEWTON = 8
# residuals that are rounding; corrections, as a part of the reach, whose square would be
ROUNDING, TIGHT, NOISE, NEARLY = 1e-13, 1e-9, 1e-7, 1e-4
# contraction and turn [rad] that steps aim at, the turn that is refused, and growth of a step
CONTRACTION, TURN, SHARP, GROWTH = 0.05, 0.3, 0.6, 2.0
FIRST, LONGEST, SHORTEST = 0.02, 0.25, 1e-9
DIVERGED = 0.9  # contraction above which corrections lead nowhere
EXACT = 1e-13  # of a step: places of test functions
SAME = 1e-7  # of a step: places that are one
ASIDE = 0.7  # corrections, as a part of a step, that lead to another curve


@dataclass(frozen=True, eq=False)
class Reach:
    """Controls of the step.

    Attributes:
        first, longest: Length of the first step and of the longest one.
        shortest: Length below which a curve ends.
    """

    first: float = FIRST
    longest: float = LONGEST
    shortest: float = SHORTEST


@dataclass(frozen=True, eq=False)
class Place:
    """A point of a curve.

    Attributes:
        point: The point.
        tangent: Along the curve, of length 1 (N,).
        parameter_rate: Derivative of the parameter by the length of the curve: 0 at a fold.
        orientation: Sign of the determinant of J with the tangent as a row; it changes where an odd
            number of curves cross. 0 where it is not known.
        below: Eigenvalues below 0 of symmetric equations at a fixed parameter; None where the
            factors of J do not tell.
    """

    point: Point
    tangent: Array
    parameter_rate: float
    orientation: float
    below: int | None = None


def place(family: Family, point: Point, toward: Array) -> Place:
    """The place at a point of the curve; ``toward``: a direction that its tangent agrees with."""
    jacobian = family.jacobian(point)
    by = jacobian.bordered(row(family, toward), np.zeros((len(family.weights) - 1, 0)))
    tangent = by.solve(np.zeros(len(toward) - 1), np.ones(1))[0]
    tangent = tangent / length(family, tangent)
    # the row of the tangent itself gives the same sign: both have a positive product with it
    return Place(point, tangent, float(tangent[-1]), by.sign, by.below)


def ahead(family: Family, point: Point) -> Array:
    """The direction (N,) along the curve through a point in which the parameter grows."""
    tangent = family.jacobian(point).weakest(1)[2][:, -1]
    return tangent if tangent[-1] >= 0 else -tangent


def reversals(family: Family, before: Place, after: Place) -> int:
    """Directions in which J with the tangent as a row changes its sign between two places.

    Those are eigenvalues of the one matrix by the other that are negative, and as many curves are
    crossed on the way; 0 where there are no arrays.
    """
    matrices = list[Array]()
    for place in (before, after):
        jacobian = family.jacobian(place.point)
        if not isinstance(jacobian, DenseJacobian):
            return 0
        matrices.append(np.concatenate([jacobian.matrix, row(family, place.tangent)]))
    here, there = eigvals(matrices[1], matrices[0], homogeneous_eigvals=True)
    return int(np.sum((here * there.conj()).real < 0))


def corrected(
    family: Family,
    start: Place,
    ds: float,
    guess: Array | None = None,
    plane: tuple[Array, float] | None = None,
) -> tuple[Point, float, int]:
    """The point of the curve in the plane across the tangent at a distance from a place.

    Args:
        family, start, ds: Of what, from where, how far.
        guess: An increment to begin with, the tangent by default.
        plane: Another one: a row (1, N), and its product with the increment to there.

    Returns:
        The point, the contraction of the corrections as that of the first two in quadratic
        convergence, and their number.

    Raises:
        SolveError: there is none next to it.
    """
    across, distance = (row(family, start.tangent), ds) if plane is None else plane
    dz, theta, sizes = ds * start.tangent, 0.0, list[float]()
    point = family.moved(family.with_internal_unknowns(start.point), dz)
    if guess is not None:
        # in two steps: what elements keep themselves follows the tangent alone
        point, dz = family.moved(point, guess - dz), guess
    none, moved, off = np.zeros((len(across[0]) - 1, 0)), 0.0, distance - float(across[0] @ dz)
    near: bool | Jacobian = True
    for k in range(NEWTON):
        left = family.residual(point)
        try:
            near = family.jacobian(point, rough=near)
            by: Bordered = near.bordered(across, none)
            correction = by.solve(-left, np.array([off]))[0]
            size = length(family, correction)
            moved += size
            if not (np.isfinite(size) and moved <= ASIDE * max(abs(ds), NOISE)):
                raise SolveError("the corrections lead away from the curve")
        except SolveError:
            # at a branch point the system is singular, though the prediction may lie on the curve
            if not off and np.abs(left).max(initial=0.0) <= ROUNDING:
                return family.without_internal_unknowns(point), theta, k + 1
            raise
        if sizes:
            theta = _rate(theta, sizes, size)
        # in slender beams every other correction is one of their stretch, and may be larger
        if k > 1 and size > TIGHT and size > DIVERGED * sizes[-2]:
            raise SolveError("the corrections do not converge")
        point = family.moved(point, correction)
        if size <= TIGHT or (sizes and size <= NOISE and size >= 0.5 * sizes[-1]):
            return family.without_internal_unknowns(point), theta, k + 1
        sizes.append(size)
        off = 0.0
        if size <= NEARLY:
            # what is left may be rounding: the same factors tell
            more = by.solve(-family.residual(point), np.zeros(1))[0]
            if (last := length(family, more)) <= TIGHT:
                point = family.without_internal_unknowns(family.moved(point, more))
                return point, _rate(theta, sizes, last), k + 1
    raise SolveError("the corrections do not converge")


def _rate(theta: float, sizes: list[float], size: float) -> float:
    """The contraction of the first corrections that the latest one speaks of, or a smaller one."""
    rate = (size / sizes[-1]) ** 0.5 ** (len(sizes) - 1) if sizes[-1] > TIGHT else 0.0
    return rate if len(sizes) == 1 else min(theta, rate)


@dataclass(frozen=True, eq=False)
class Step:
    """A step that was accepted.

    Attributes:
        before, after: Its ends.
        ds: Its length along the tangent at its start.
        corrections: Linear systems solved, refused steps among them.
        refused: Steps that were halved.
        contraction: Of the corrections at its end.
    """

    before: Place
    after: Place
    ds: float
    corrections: int
    refused: int
    contraction: float = 0.0

    def shortened(self, after: Place, part: float) -> Step:
        """The step up to a place at a part of it."""
        return replace(self, after=after, ds=part * self.ds)

    def at(self, family: Family, part: float) -> Place:
        """The place at a part of the step, 0 to 1.

        Raises:
            SolveError: it is not found.
        """
        if part in (0.0, 1.0):
            return (self.before, self.after)[int(part)]
        return self._located(family, part, self._cubic(family)(part))

    def part(self, family: Family, point: Point) -> float:
        """The part at which a point lies."""
        way = family.step(self.before.point, point)
        return float(self.before.tangent @ (family.weights * way)) / self.ds

    def fold(self, family: Family, low: float, high: float) -> Place:
        """The place between two parts where the parameter turns back.

        Raises:
            SolveError: the curve is not singular in between.
        """

        def parameter_rate(part: float) -> float:
            return self.at(family, part).parameter_rate

        return self.at(family, float(brentq(parameter_rate, low, high, xtol=EXACT)))

    def _located(
        self, family: Family, part: float, guess: Array, plane: tuple[Array, float] | None = None
    ) -> Place:
        """The place near a guess, or near the tangent: from there stresses of beams are better.

        Raises:
            SolveError: it is not found.
        """
        try:
            point = corrected(family, self.before, part * self.ds, guess, plane)[0]
        except SolveError:
            point = corrected(family, self.before, part * self.ds, None, plane)[0]
        return place(family, point, self.before.tangent)

    def at_parameter(self, family: Family, value: float) -> tuple[Place, float] | None:
        """The place at a value of the parameter, and at which part of the step it lies.

        None where Newton's method does not lead there, or the value is rounding of an end.
        """
        start, cubic = family.parameter(self.before.point), self._cubic(family)

        def parameter(part: float) -> float:
            return start + float(cubic(part)[-1]) - value

        if not parameter(0.0) * parameter(1.0) <= 0:
            return None
        part = float(brentq(parameter, 0.0, 1.0))
        along = np.zeros((1, len(self.before.tangent)))
        along[0, -1] = 1.0
        plane = along, value - start
        try:
            there = self._located(family, part, cubic(part), plane)
        except SolveError:
            return None
        part = self.part(family, there.point)
        return (there, part) if 0 < part <= 1 else None

    def passes(self, family: Family, there: Place) -> tuple[float, int]:
        """The part at which a place of a curve lies; 1 in its direction, -1 against it, else 0."""
        change = family.parameter(there.point) - family.parameter(self.before.point)
        if abs(change) * float(np.sqrt(family.weights[-1])) > 2 * self.ds:
            return 0.0, 0
        to = family.step(self.before.point, there.point)
        along = float(self.before.tangent @ (family.weights * to))
        part = along / self.ds
        if not 0 < part <= 1 + 1e-9 or length(family, to) > 2 * self.ds:
            return part, 0
        try:
            here = self.at(family, part)
        except SolveError:
            return part, 0
        off = length(family, family.step(here.point, there.point))
        same = float(here.tangent @ (family.weights * there.tangent))
        return part, int(np.sign(same)) if off <= SAME * max(1.0, self.ds) else 0

    def _cubic(self, family: Family) -> Callable[[float], Array]:
        """Increments by the cubic with the tangents of both ends, in the chart of the start."""
        end = family.step(self.before.point, self.after.point)
        here = self.ds * self.before.tangent
        share = float(self.before.tangent @ (family.weights * self.after.tangent))
        there = self.after.tangent * (self.ds / max(share, 0.1))

        def at(h: float) -> Array:
            cubic = (3 * h**2 - 2 * h**3) * end + h * (1 - h) ** 2 * here
            return np.asarray(cubic - h**2 * (1 - h) * there)

        return at


class End(SolveError):
    """The curve is not followed any further."""


def steps(
    family: Family, start: Place, reach: Reach, accept: Callable[[Step], bool] = lambda _: True
) -> Iterator[Step]:
    """Steps along a curve, without end.

    Args:
        family, start, reach: Of what, from where, how far.
        accept: What a step must fulfill not to be halved.

    Raises:
        End: steps become too short.
    """
    here, ds = start, reach.first
    while True:
        spent = refused = 0
        reason = ""
        while True:
            try:
                point, theta, spent_now = corrected(family, here, ds)
                spent += spent_now + 1
                there = place(family, point, here.tangent)
                turn = _angle(family, here.tangent, there.tangent)
            except SolveError as error:
                spent += 1
                turn, reason = math.inf, f": {error}"
            if turn <= SHARP and accept(step := Step(here, there, ds, spent, refused, theta)):
                break
            refused += 1
            ds *= 0.5
            if ds < reach.shortest:
                raise End(f"ends, as steps become too short{reason}")
        yield step
        quick = math.sqrt(CONTRACTION / theta) if theta > 0 else GROWTH
        calm = TURN / turn if turn > 0 else GROWTH
        ds = min(reach.longest, ds * float(np.clip(min(quick, calm), 1 / GROWTH, GROWTH)))
        here = there


def _angle(family: Family, a: Array, b: Array) -> float:
    """Angle between tangents [rad]."""
    return 2 * math.asin(min(1.0, 0.5 * length(family, a - b)))
