"""Legs: three freedoms that carry the center of a ball joint to where its loop closes.

The third joint of a leg, a motor or a slide, makes up the distance from the center of the other two
axes, or, where these are parallel, from the plane in which they move the ball. That is one equation
A cos + B sin = C for an angle, a quadratic one for a length. Then the pair follows as a dyad.

Source: C. H. Suh, C. W. Radcliffe, Kinematics and Mechanisms Design (1978); J.-P. Merlet, Parallel
Robots, chapter 3 (inverse kinematics of legs).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...ir.arithmetic import Scalar, sqrt
from ...ir.matrix import Matrix
from ...records import dataclass
from ...topology.system import Closure
from .dyads import (
    Branches,
    JointSolution,
    arms,
    branches,
    flattened,
    leaning,
    rotated,
    slide,
    turn,
    two_axes,
)

if TYPE_CHECKING:
    from ..kinematics.kinematics import Kinematics

INSIDE, OUTSIDE, OPPOSITE = "inside", "outside", "opposite"


@dataclass(frozen=True)
class Third:
    """The joint that makes up for what the pair cannot, and what it moves.

    Attributes:
        axis, seat: Its axis, a point on it.
        turns: Whether it is revolute.
        side: Which of its two solutions.
        place: ``"inside"``: it carries the pair, ``"outside"``: the pair carries it,
            ``"opposite"``: it is on the other branch of the loop.
    """

    axis: Matrix
    seat: Matrix
    turns: bool
    side: int
    place: str

    @classmethod
    def of(cls, k: Kinematics, closure: Closure, b: Branches) -> Third:
        """The third joint of a leg."""
        third, pair = closure.third, [i for i in closure.unknown if i != closure.third]
        place = INSIDE if third < pair[0] else OUTSIDE
        if b.side[third] != b.side[pair[0]]:
            place = OPPOSITE
        turns = k.system.joints[third].element.kind == "revolute"
        return cls(b.axis(k, third), b.seats[third][1], turns, closure.side, place)

    def reaching(self, x: Matrix, y: Matrix, reach: Matrix) -> JointSolution:
        """The coordinate at which point x is as far from y, which it does not move, as asked."""
        if not self.turns:
            return JointSolution(length=slide(self.axis, x - y, reach, self.side))
        start, goal = x - self.seat, y - self.seat
        value = (start.dot(start) + goal.dot(goal) - reach.dot(reach)) * 0.5
        return self.leaning(start, goal, value)

    def leaning(self, start: Matrix, goal: Matrix, value: Scalar) -> JointSolution:
        """The angle after which start·goal has a value, for a goal that is not turned."""
        flat = flattened(self.axis)
        offset = value - self.axis.dot(start) * self.axis.dot(goal)
        across = flat(start)
        return turn(self.axis, across, leaning(flat(goal), across, offset, self.axis, self.side))

    def direction(self, solved: JointSolution, x: Matrix) -> Matrix:
        """A direction as the joint moves it."""
        return rotated(self.axis, solved, x) if self.turns else x

    def point(self, solved: JointSolution, x: Matrix) -> Matrix:
        """A point as the joint moves it."""
        if solved.length is not None:
            return x + self.axis * solved.length
        return self.seat + rotated(self.axis, solved, x - self.seat)


def leg(k: Kinematics, closure: Closure) -> dict[int, tuple[JointSolution, ...]]:
    """Two axes that meet, and a third joint: the distance from where they meet, then directions."""
    b = branches(k, closure)
    third, pair = Third.of(k, closure, b), [i for i in closure.unknown if i != closure.third]
    side, center = b.side[pair[0]], b.seats[pair[-1]][1]
    near, other = b.ends[side][1], b.ends[-side][1]
    first, second = _axes(k, b, pair)
    if third.place == OUTSIDE:
        reach = other - center
        solved = third.reaching(near, center, reach)
        start, end = third.point(solved, near) - center, reach
    elif third.place == INSIDE:
        reach = near - center
        solved = third.reaching(center, other, reach)
        first, second, start = (third.direction(solved, x) for x in (first, second, reach))
        end = other - third.point(solved, center)
    else:
        start = reach = near - center
        solved = third.reaching(other, center, reach)
        end = third.point(solved, other) - center
    length = sqrt(reach.dot(reach))
    one, two = two_axes(
        first, second, start / length, end / length, (0, 1), closure.branch
    ).values()
    return {closure.third: (solved,), **_shared(k, pair, one[0], two[0])}


def _axes(k: Kinematics, b: Branches, pair: list[int]) -> tuple[Matrix, Matrix]:
    """The axes of the pair at its zero, the inner one first."""
    if len(pair) == 2:
        return b.axis(k, pair[0]), b.axis(k, pair[1])
    names = ("axis2", "axis1") if k.system.joints[pair[0]].reversed else ("axis1", "axis2")
    return b.axis(k, pair[0], names[0]), b.axis(k, pair[0], names[1])


def _shared(
    k: Kinematics, pair: list[int], one: JointSolution, two: JointSolution
) -> dict[int, tuple[JointSolution, ...]]:
    """Angles about the inner and the outer axis as coordinates of the joints that have them."""
    if len(pair) == 2:
        return {pair[0]: (one,), pair[1]: (two,)}
    if k.system.joints[pair[0]].reversed:
        return {pair[0]: (two.back, one.back)}
    return {pair[0]: (one, two)}


def arm(k: Kinematics, closure: Closure) -> dict[int, tuple[JointSolution, ...]]:
    """Two parallel axes and a third one: the ball comes into their plane, then a planar dyad."""
    b = branches(k, closure)
    third, pair = Third.of(k, closure, b), [i for i in closure.unknown if i != closure.third]
    side = b.side[pair[0]]
    near, other = b.ends[side][1], b.ends[-side][1]
    first, second = _axes(k, b, pair)
    inner, outer = b.seats[pair[0]][1], b.seats[pair[1]][1]
    # along the axes the pair moves nothing
    if third.place == OUTSIDE:
        solved = third.leaning(near - third.seat, first, first.dot(other - third.seat))
        near = third.point(solved, near)
    elif third.place == INSIDE:
        solved = third.leaning(first, other - third.seat, first.dot(near - third.seat))
        first, second = third.direction(solved, first), third.direction(solved, second)
        inner, outer, near = (third.point(solved, x) for x in (inner, outer, near))
    else:
        solved = third.leaning(other - third.seat, first, first.dot(near - third.seat))
        other = third.point(solved, other)
    flat = flattened(first)
    one, two = arms(
        (first, second),
        flat(outer - inner),
        flat(near - outer),
        flat(other - inner),
        closure.branch,
    )
    return {closure.third: (solved,), pair[0]: (one,), pair[1]: (two,)}
