"""Pairs of joints whose coordinates follow in closed form from where their loop closes.

All vectors are told in the axes of the body from which the two branches of the loop start. A
joint is first taken at its zero; what its two branches then miss is made up by its coordinate.

Source: VDI 2729, Modulare kinematische Analyse ebener Gelenkgetriebe mit Dreh- und Schubgelenken;
C. H. Suh, C. W. Radcliffe, Kinematics and Mechanisms Design (1978).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from ...ir.arithmetic import Scalar, atan2, select, sqrt
from ...ir.graph import Graph
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...records import dataclass
from ...spatial.axis import unit
from ...topology.system import Closure
from .cut_joint_frames import frame_pose

if TYPE_CHECKING:
    from ..kinematics.kinematics import Kinematics

Pose = tuple[Matrix, Matrix]
# of the square of the sine of the angle at the elbow: where a loop counts as dead
DEAD = 1e-6


@dataclass(frozen=True)
class JointSolution:
    """A coordinate: an angle by its cosine and sine, or a length."""

    cosine: Scalar | None = None
    sine: Scalar | None = None
    length: Scalar | None = None

    @property
    def back(self) -> JointSolution:
        """The angle in the opposite direction."""
        assert self.sine is not None
        return JointSolution(self.cosine, -self.sine)

    def coordinate(self, graph: Graph) -> int:
        """The coordinate as a node."""
        if self.length is not None:
            return self.length.node
        assert self.sine is not None
        assert self.cosine is not None
        return atan2(self.sine, self.cosine).node


@dataclass(frozen=True)
class Branches:
    """The two branches of a loop with the joints that are looked for at their zeros.

    Attributes:
        seats: Joint -> its frame on the inner body.
        ends: Sign of a branch -> its frame of the cut joint: 1 of the child, -1 of the parent.
        side: Joint -> the sign of its branch.
    """

    seats: dict[int, Pose]
    ends: dict[int, Pose]
    side: dict[int, int]

    def axis(self, k: Kinematics, i: int, name: str = "axis") -> Matrix:
        """Direction of an axis of a joint that is looked for."""
        return self.seats[i][0] @ unit(k.data[i][name])


def branches(k: Kinematics, closure: Closure) -> Branches:
    """Both branches from the body where they part."""
    cut, g = closure.cut, k.graph
    at: dict[int, Pose] = {cut.base: (Matrix.identity(g, 3), Matrix.zeros(g, 3))}
    seats = {}
    for i, _ in cut.path:
        inner, joint = at[k.system.bodies[i].parent], k.system.joints[i]
        if i in closure.unknown:
            rotation, position = k.matrix(3, 3, joint.rotation), k.vector(joint.position)
            at[i] = seats[i] = inner[0] @ rotation, inner[1] + inner[0] @ position
        else:
            pose = k.pose_of(i)
            at[i] = inner[0] @ pose.rotation, inner[1] + inner[0] @ pose.position
    frames = {-1: cut.parent_frame, 1: cut.child_frame}
    closing = {sign: frame_pose(k, f, at[k.system.frames[f].body]) for sign, f in frames.items()}
    return Branches(seats, closing, dict(cut.path))


def turn(axis: Matrix, start: Matrix, end: Matrix) -> JointSolution:
    """The angle about an axis from one vector across it to another of the same length."""
    square = start.dot(start)
    return JointSolution(start.dot(end) / square, axis.dot(start.cross(end)) / square)


def rotated(axis: Matrix, angle: JointSolution, x: Matrix) -> Matrix:
    """A vector after a rotation."""
    assert angle.cosine is not None
    assert angle.sine is not None
    along = axis * axis.dot(x)
    across = x - along
    return along + across * angle.cosine + axis.cross(across) * angle.sine


def planar(k: Kinematics, closure: Closure) -> dict[int, tuple[JointSolution, ...]]:
    """Two joints of a plane that meet in a revolute joint."""
    kinds = [k.system.joints[i].element.kind for i in closure.unknown]
    return _two_turns(k, closure) if kinds == ["revolute"] * 2 else _turn_and_slide(k, closure)


def flattened(axis: Matrix) -> Callable[[Matrix], Matrix]:
    return lambda x: x - axis * axis.dot(x)


def _two_turns(k: Kinematics, closure: Closure) -> dict[int, tuple[JointSolution, ...]]:
    """Two revolute joints: a triangle of two arms and the distance between their ends."""
    b, (i, j) = branches(k, closure), closure.unknown
    n, m = b.axis(k, i), b.axis(k, j)
    flat = flattened(n)
    chained = b.side[i] == b.side[j]
    first = b.seats[j][1] if chained else b.ends[b.side[i]][1]
    start = flat(first - b.seats[i][1])
    arm = flat(b.ends[b.side[j]][1] - b.seats[j][1])
    target = b.ends[-b.side[i]][1] if chained else b.seats[j][1]
    gap = flat(target - b.seats[i][1])
    if chained:
        one, two = arms((n, m), start, arm, gap, closure.branch)
        return {i: (one,), j: (two,)}
    end = elbow(gap, start, arm, n, closure.branch)
    return {i: (turn(n, start, end),), j: (turn(m, arm, end - gap),)}


def arms(
    axes: tuple[Matrix, Matrix], start: Matrix, arm: Matrix, gap: Matrix, branch: int
) -> tuple[JointSolution, JointSolution]:
    """Angles of two arms, one carried by the other, that together bridge a gap.

    Args:
        axes: Parallel; start, arm, gap: across them, the arms at the zeros of their joints.
        branch: To which side the elbow is bent.
    """
    n, m = axes
    end = elbow(gap, start, arm, n, branch)
    one = turn(n, start, end)
    return one, turn(m, rotated(n, one, arm), gap - end)


def root(square: Scalar, most: Scalar) -> Scalar:
    """Root of what is left of the square of an arm; not a number at a dead point."""
    return sqrt(_dead_point_guard(square, most))


def _dead_point_guard(square: Scalar, most: Scalar | float) -> Scalar:
    """A square, -1 where it vanishes: there both solutions meet, and rates do not exist.

    Without this a run could step from one solution to the other, which is not a motion.
    """
    return select(square.apply("lt", most * DEAD), -1.0, square)


def without_guard(g: Graph, node: int) -> int:
    """An expression away from dead points: the test for them is removed."""
    nodes = g.nodes

    def rule(target: Graph, i: int, copies: Mapping[int, int]) -> int | None:
        op, *read = nodes[i]
        if op != "select" or nodes[read[0]][0] != "lt" or g.value(read[1]) != -1.0:
            return None
        return copies[read[2]] if nodes[read[0]][1] == read[2] else None

    return rebuild(g, [node], rule, into=g)[1][0]


def elbow(gap: Matrix, start: Matrix, arm: Matrix, axis: Matrix, branch: int) -> Matrix:
    """The vector as long as ``start`` from whose end ``arm`` reaches the end of the gap."""
    reach = (start.dot(start) - arm.dot(arm) + gap.dot(gap)) * 0.5
    return leaning(gap, start, reach, axis, branch)


def leaning(goal: Matrix, start: Matrix, value: Scalar, axis: Matrix, branch: int) -> Matrix:
    """The vector as long as ``start`` whose product with a goal has a value, all across an axis."""
    square = goal.dot(goal)
    most = start.dot(start) * square
    height = root(most - value * value, most) * branch
    return (goal * value + axis.cross(goal) * height) / square


def _turn_and_slide(k: Kinematics, closure: Closure) -> dict[int, tuple[JointSolution, ...]]:
    """A revolute and a prismatic joint: an arm and the line on which its end slides."""
    b = branches(k, closure)
    i, j = sorted(closure.unknown, key=lambda x: k.system.joints[x].element.kind != "revolute")
    n, along = b.axis(k, i), b.axis(k, j)
    flat = flattened(n)
    along = flat(along)
    if b.side[i] == b.side[j] and j > i:
        # the slide turns with the arm
        arm = flat(b.ends[b.side[i]][1] - b.seats[i][1])
        gap = flat(b.ends[-b.side[i]][1] - b.seats[i][1])
        length = slide(along, arm, gap, closure.branch)
        return {i: (turn(n, arm + along * length, gap),), j: (JointSolution(length=length),)}
    arm = flat(b.ends[b.side[i]][1] - b.seats[i][1])
    gap = flat(b.ends[-b.side[i]][1] - b.seats[i][1])
    if b.side[i] == b.side[j]:
        along = -along
    length = slide(along, gap, arm, closure.branch)
    return {i: (turn(n, arm, gap + along * length),), j: (JointSolution(length=length),)}


def slide(along: Matrix, start: Matrix, reach: Matrix, branch: int) -> Scalar:
    """Distance along a line from a point to be as far away as another vector is long."""
    middle = along.dot(start)
    most = reach.dot(reach)
    height = root(middle * middle - start.dot(start) + most, most) * branch
    return height - middle


def spherical(k: Kinematics, closure: Closure) -> dict[int, tuple[JointSolution, ...]]:
    """Two revolute joints whose axes meet that of the joint which closes the loop."""
    b, (i, j) = branches(k, closure), closure.unknown
    axis = {
        sign: frame[0] @ unit(k.matrix(*closure.cut.data["axis"])) for sign, frame in b.ends.items()
    }
    n, m = b.axis(k, i), b.axis(k, j)
    if b.side[i] != b.side[j]:
        near, other = axis[b.side[i]], axis[b.side[j]]
        meet = _cones(n, n.dot(near), m, m.dot(other), closure.branch)
        return {i: (_about(n, near, meet),), j: (_about(m, other, meet),)}
    return two_axes(n, m, axis[b.side[i]], axis[-b.side[i]], (i, j), closure.branch)


def two_axes(
    n: Matrix, m: Matrix, start: Matrix, end: Matrix, joints: tuple[int, int], branch: int
) -> dict[int, tuple[JointSolution, ...]]:
    """Angles about n, then about m as n has turned it, that lead one direction to another."""
    direction = _cones(n, n.dot(m), end, m.dot(start), branch)
    first = _about(n, m, direction)
    second = _about(direction, rotated(n, first, start), end)
    return {joints[0]: (first,), joints[1]: (second,)}


def _cones(n: Matrix, a: Scalar, m: Matrix, b: Scalar, branch: int) -> Matrix:
    """The direction x with n·x = a and m·x = b."""
    cosine = n.dot(m)
    across = 1 - cosine * cosine
    one, other = (a - cosine * b) / across, (b - cosine * a) / across
    height = sqrt(_dead_point_guard(1 - one * a - other * b, 1.0) / across) * branch
    return n * one + m * other + n.cross(m) * height


def _about(axis: Matrix, start: Matrix, end: Matrix) -> JointSolution:
    """The angle about an axis from one direction to another on the same cone."""
    flat = flattened(axis)
    return turn(axis, flat(start), flat(end))


SOLUTIONS: dict[str, Callable[[Kinematics, Closure], dict[int, tuple[JointSolution, ...]]]] = {
    "planar": planar,
    "spherical": spherical,
}
