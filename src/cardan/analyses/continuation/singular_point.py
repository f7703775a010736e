"""Points of a curve at which J loses rank: where they are, and which curves meet there.

A point is located as the solution of equations that are regular there: F + B beta = 0 with
unfolding parameters beta, and g = 0 for the part g (k, k + 1) of J between its null spaces.
Around it the solutions of F + B beta = 0 form a surface over the null space; those with beta =
0 on a small sphere of it are where curves leave. That needs no second derivatives, and holds
where they vanish.

Source: W. Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria (2000), chapters 3
and 5 (minimally extended systems); M. Golubitsky, D. Schaeffer, Singularities and Groups in
Bifurcation Theory 1 (1985), chapter 7 (Liapunov-Schmidt reduction).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import field
from functools import cached_property
from itertools import pairwise

import numpy as np
from scipy.optimize import brentq

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from .family import Bordered, Family, Point, length

NEWTON, TIGHT, NOISE = 14, 1e-11, 1e-5
FAR = 0.5  # increments that lead away from where the search began
DEPENDENT = 1e-8  # slopes of the part of J that follow from others
DIFFERENCE = 1e-4  # increments over which J is differentiated: it only steers Newton's method
# of the smallest singular value that is not 0: those that are, and unfolding parameters above which
# curves pass each other; and what rounding leaves of either
SINGULAR, UNFOLDED = 1e-4, 1e-9
ROUNDING, DISTINCT = 1e-14, 0.01
RADIUS, RADII = 0.02, 6  # of the sphere; how many, each a tenth of that before
CROSSING, STRAIGHT = 4, 0.03  # half-branches of two curves, and their turn [rad] from 0
CHORD, CLOSED, SLOW = 30, 1e-14, 0.3  # iterations on the surface, what may be left, contraction
SAMPLES, STARTS = 36, 120  # on a circle, on spheres of more dimensions
SAME = 1e-3  # directions nearer than this are one
LEVELS = 3  # radii that are halved, for extrapolation


@dataclass(frozen=True, eq=False)
class SingularPoint:
    """A point at which J has lost k of its rank.

    Attributes:
        family: Of what.
        point: The point.
        V: Its null space (N, k + 1), orthonormal in lengths of increments.
        B: The left null space (n, k).
        by: The bordered system with these.
        uncertainty: Length of an increment within which rounding leaves the point.
    """

    family: Family
    point: Point
    V: Array
    B: Array
    by: Bordered = field(repr=False)
    uncertainty: float

    @property
    def k(self) -> int:
        """Rank that is lost."""
        return int(self.B.shape[1])

    @cached_property
    def _rows(self) -> Array:
        return (self.family.weights[:, None] * self.V).T

    def surface(self, a: Array) -> tuple[Array, Array]:
        """The increment (N,) from the point over a (k + 1,) of the null space, and beta (k,).

        Raises:
            SolveError: the surface does not reach so far.
        """
        dz, beta, last, by = self.V @ a, np.zeros(self.k), np.inf, self.by
        for _ in range(CHORD):
            point = self.family.moved(self.point, dz)
            left = self.family.residual(point) + self.B @ beta
            more, change = by.solve(-left, a - self._rows @ dz)
            size = max(length(self.family, more), float(np.abs(change).max(initial=0.0)))
            if size > SLOW * last and size > CLOSED:
                # factors of the singular point lead no further
                by = self.family.jacobian(point).bordered(self._rows, self.B)
                more, change = by.solve(-left, a - self._rows @ dz)
                size = max(length(self.family, more), float(np.abs(change).max(initial=0.0)))
            dz, beta = dz + more, beta + change
            if size <= CLOSED or (size <= 1e3 * CLOSED and size >= 0.5 * last):
                return dz, beta
            if not size <= FAR:
                break
            last = size
        raise SolveError("the surface of solutions does not reach so far")


def singular_point(family: Family, start: Point, k: int) -> SingularPoint:
    """The point next to a start at which J has lost k of its rank.

    Raises:
        SolveError: there is none.
    """
    if k >= len(family.weights):
        raise SolveError("J has not so much rank to lose")
    point, jacobian = start, family.jacobian(start)
    _, B, C = jacobian.weakest(k)
    rows, gone, last = C.T, 0.0, np.inf
    for _ in range(NEWTON):
        by = jacobian.bordered(rows, B)
        zeros = np.zeros((len(B), k + 1))
        V, g = by.solve(zeros, np.eye(k + 1))
        psi = by.solve_transposed(np.eye(k))[0]
        dz, beta = by.solve(-family.residual(point), np.zeros(k + 1))

        def curved(w: Array, at: Point = point, V: Array = V, psi: Array = psi) -> Array:
            """Change of g along an increment."""
            size = float(np.abs(w).max(initial=0.0))
            if size == 0:
                return np.zeros((k, k + 1))
            h = DIFFERENCE / size
            ends = (family.jacobian(family.moved(at, h * sign * w)).apply(V) for sign in (1, -1))
            return np.asarray(-psi.T @ np.subtract(*ends) / (2 * h))

        slopes = np.stack([curved(v).ravel() for v in V.T], axis=1)
        c = _least(slopes, -(g + curved(dz)).ravel())
        dz = dz + V @ c
        size = length(family, dz)
        gone += size
        if not (np.isfinite(size) and gone <= FAR):
            break
        point = family.moved(point, dz)
        jacobian = family.jacobian(point)
        if size <= TIGHT or (size <= NOISE and size >= 0.5 * last):
            return _orthonormal(family, point, k, float(np.abs(beta).max(initial=0.0)), size)
        last = size
        B = np.linalg.qr(psi)[0]
        rows = V.T / np.linalg.norm(V, axis=0)[:, None]
    raise SolveError("no singular point next to the start")


def _least(A: Array, b: Array) -> Array:
    """The least solution of A x = b next to it, with rows and columns of A made equal in size."""
    rows = np.abs(A).max(axis=1)
    rows[rows == 0] = 1.0
    A = A / rows[:, None]
    columns = np.abs(A).max(axis=0)
    columns[columns == 0] = 1.0
    x: Array = np.linalg.lstsq(A / columns, b / rows, DEPENDENT)[0] / columns
    return x


def _orthonormal(
    family: Family, point: Point, k: int, unfolded: float, uncertainty: float
) -> SingularPoint:
    """The point with its null spaces.

    Raises:
        SolveError: J has lost another number of its rank, or curves pass each other.
    """
    jacobian = family.jacobian(point)
    values, B, V = jacobian.weakest(k)
    more = jacobian.weakest(k + 1)[0]
    next_value = float(more.max()) if len(more) > k else 1.0
    # in slender beams all that is left is rounding of J, which the next value must stand out from
    zero = max(SINGULAR * next_value, min(ROUNDING, DISTINCT * next_value))
    if (
        next_value <= ROUNDING
        or values.max() > zero
        or unfolded > max(UNFOLDED * next_value, ROUNDING)
    ):
        raise SolveError("no singular point next to the start")
    gram = V.T @ (family.weights[:, None] * V)
    V = np.linalg.solve(np.linalg.cholesky(gram), V.T).T
    by = jacobian.bordered((family.weights[:, None] * V).T, B)
    return SingularPoint(family, point, V, B, by, uncertainty)


@dataclass(frozen=True, eq=False)
class HalfBranch:
    """A curve that leaves a singular point in one direction.

    Attributes:
        tangent: Its direction at the point, of length 1 (N,).
        curvature: Change of the direction by length (N,); 0 where it could not be told.
        point: A point of it next to the singular point.
        direction: From the one to the other, of length 1 (N,).
    """

    tangent: Array
    curvature: Array
    point: Point
    direction: Array


def half_branches(at: SingularPoint) -> list[HalfBranch]:
    """All curves that leave a singular point, each direction once.

    The sphere becomes smaller until two curves cross it, and nearly straight.

    Raises:
        SolveError: they could not be told apart.
    """
    most, radius = list[list[Array]](), RADIUS
    for _ in range(RADII):
        try:
            levels = _levels(at, radius)
        except SolveError:
            levels = []
        radius *= 0.1
        if not levels:
            continue
        if len(levels[0]) >= CROSSING and _turn(levels) <= STRAIGHT:
            most = levels
            break
        if not most or len(levels[0]) > len(most[0]):
            most = levels
    if not most:
        raise SolveError("the curves that meet at a singular point could not be told apart")
    return [_half_branch(at, most, i) for i in range(len(most[0]))]


def other_curves(
    at: SingularPoint, before: Array, switches: bool
) -> tuple[Sequence[HalfBranch], Array]:
    """Curves that leave a singular point other than one that leads there, and the tangent of that.

    Args:
        at: The point.
        before: Tangent (N,) of the one in front of it.
        switches: Whether the others are looked for.
    """
    family = at.family
    tangent = at.V @ (at.V.T @ (family.weights * before))
    tangent = tangent / length(family, tangent)
    try:
        halves = half_branches(at) if switches else []
    except SolveError:
        halves = []
    if len(halves) < 2:
        return (), tangent
    along = [float(before @ (family.weights * half.tangent)) for half in halves]
    forward, backward = int(np.argmax(along)), int(np.argmin(along))
    remaining = [half for i, half in enumerate(halves) if i not in (forward, backward)]
    return tuple(remaining), halves[forward].tangent


def _levels(at: SingularPoint, radius: float) -> list[list[Array]]:
    """Where curves cross a sphere, and those of halved radii.

    Raises:
        SolveError: they could not be told apart.
    """
    levels = [list(_directions(at, radius))]
    for _ in range(LEVELS - 1):
        radius *= 0.5
        levels.append([_near(at, radius, d) for d in levels[-1]])
    return levels


def _turn(levels: list[list[Array]]) -> float:
    """By how much curves turn between the first two spheres [rad]."""
    pairs = zip(*levels[:2], strict=True)
    units = [(a / np.linalg.norm(a), b / np.linalg.norm(b)) for a, b in pairs]
    return max((float(np.linalg.norm(a - b)) for a, b in units), default=0.0)


def _half_branch(at: SingularPoint, levels: list[list[Array]], i: int) -> HalfBranch:
    """The half-branch of directions at halved radii, with the opposite one where there is one."""
    last = levels[-1]
    dots = np.array([d @ last[i] for d in last])
    opposite = int(dots.argmin())
    radii = np.array([float(np.linalg.norm(level[i])) for level in levels])
    mine = [at.surface(level[i])[0] / r for level, r in zip(levels, radii, strict=True)]
    if dots[opposite] < -0.9 * (last[i] @ last[i]):
        other = [at.surface(level[opposite])[0] / r for level, r in zip(levels, radii, strict=True)]
        tangent = _limit([0.5 * (a - b) for a, b in zip(mine, other, strict=True)], 4)
        sums = zip(mine, other, radii, strict=True)
        curvature = _limit([(a + b) / r for a, b, r in sums], 4)
    else:
        tangent, curvature = _limit(mine, 2), np.zeros_like(mine[0])
    family, dz = at.family, at.surface(levels[0][i])[0]
    return HalfBranch(
        tangent / length(family, tangent),
        curvature,
        family.moved(at.point, dz),
        dz / length(family, dz),
    )


def _limit(values: list[Array], ratio: float) -> Array:
    """The limit of values at halved radii, whose errors fall by powers of a ratio."""
    power = ratio
    while len(values) > 1:
        values = [b + (b - a) / (power - 1) for a, b in pairwise(values)]
        power *= ratio
    return values[0]


def _directions(at: SingularPoint, radius: float) -> Iterator[Array]:
    """Places of the null space (k + 1,) at a radius over which curves pass."""
    if at.k == 1:
        yield from _on_circle(at, radius)
        return
    directions = list[Array]()
    for start in np.random.default_rng(0).normal(size=(STARTS, at.k + 1)):
        try:
            a = _near(at, radius, radius * start / np.linalg.norm(start))
        except SolveError:
            continue
        if all(np.linalg.norm(a - b) > SAME * radius for b in directions):
            directions.append(a)
    yield from directions


def _on_circle(at: SingularPoint, radius: float) -> Iterator[Array]:
    """The same on a circle: where the one unfolding parameter passes 0."""

    def over(angle: float) -> float:
        return float(at.surface(radius * np.array([np.cos(angle), np.sin(angle)]))[1][0])

    angles = np.linspace(0, 2 * np.pi, SAMPLES, endpoint=False) + 0.01
    values = np.array([over(angle) for angle in angles])
    halfway = _halfway(angles, values)
    angles = np.concatenate([angles, halfway])
    values = np.concatenate([values, [over(angle) for angle in halfway]])
    order = np.argsort(angles)
    angles, values = np.append(angles[order], angles[order[0]] + 2 * np.pi), values[order]
    for k, (low, high) in enumerate(pairwise(angles)):
        if values[k] * values[(k + 1) % len(values)] < 0:
            angle = brentq(over, low, high, xtol=1e-15)
            yield radius * np.array([np.cos(angle), np.sin(angle)])


def _halfway(angles: Array, values: Array) -> Array:
    """Angles halfway between those at which the quadratic form of values on a circle is 0.

    Curves whose directions differ by less than the samples do cross on either side of one of them.
    """
    harmonics = np.stack([np.ones_like(angles), np.cos(2 * angles), np.sin(2 * angles)], axis=1)
    _, c, s = np.linalg.lstsq(harmonics, values)[0]
    # a constant and a second harmonic, which is largest or smallest halfway between zeros
    first = 0.5 * np.arctan2(s, c)
    return np.asarray(np.mod(first + 0.5 * np.pi * np.arange(4) - 0.01, 2 * np.pi) + 0.01)


def _near(at: SingularPoint, radius: float, start: Array) -> Array:
    """The place on a sphere over which a curve passes, next to one; on another sphere or this one.

    Raises:
        SolveError: Newton's method does not find it.
    """
    a: Array = radius * start / np.linalg.norm(start)
    last = np.inf
    for _ in range(NEWTON):
        # directions along the sphere
        across = np.linalg.svd(a[None, :])[2][1:].T
        beta, h = at.surface(a)[1], DIFFERENCE * radius
        slopes = [(at.surface(a + h * d)[1] - at.surface(a - h * d)[1]) / (2 * h) for d in across.T]
        change = np.linalg.lstsq(np.stack(slopes, axis=1), -beta, 1e-6)[0]
        size = float(np.linalg.norm(change))
        if not size <= radius:
            break
        a = a + across @ change
        a = radius * a / np.linalg.norm(a)
        if size <= 1e-13 * radius or (size <= 1e-7 * radius and size >= 0.5 * last):
            return a
        last = size
    raise SolveError("no curve passes next to the start")
