"""Axes: those of the bodies chosen anew, so that rotations between them have the most zeros.

The frame of a body may be turned about the line of its joint. As in the notation of Denavit and
Hartenberg, an axis with three components becomes z, x lies along the common normal with the line
of the child that carries most, and of the rotation between two lines one angle is left; what a
turn about the joint's own line can do is added to its coordinate. Axes that have their zeros
already stay as they are.

Source: Denavit and Hartenberg, J. Applied Mechanics 22 (1955); Khalil and Kleinfinger, A New
Geometric Notation for Open and Closed-Loop Robots, IEEE ICRA 1986, for trees.
"""

from __future__ import annotations

from dataclasses import replace

from ...ir.arithmetic import atan2, select, sqrt
from ...ir.graph import ONE, ZERO, Graph
from ...ir.matrix import Matrix
from ...spatial.axis import complement, principal, unit
from ..frame_change import FrameChange, change_frames, new_joint_pose
from ..system import Joint, System

# lines whose sine is below this are parallel: any direction across is normal to both, to rounding
PARALLEL = 1e-12


def axes(system: System) -> System:
    """The system in axes of a better choice."""
    graph = system.graph.fork()
    work = _Work(system, graph)
    new_frames = [work.frame_change(i) for i in range(len(system.bodies))]
    joints = {}
    for i in range(len(system.joints)):
        with graph.made_by(system.joints[i].name, "place"):
            changed = work.joint(i, new_frames)
        if changed is not None:
            joints[i] = changed
    return change_frames(system, graph, new_frames, joints) if joints else system


class _Work:
    """Lines of the joints, and axes that suit them."""

    def __init__(self, system: System, graph: Graph) -> None:
        self.system = system
        self.graph = graph
        self.lines = [self._line(joint) for joint in system.joints]
        self.main = self._main_children()

    def _line(self, joint: Joint) -> Matrix | None:
        """Unit vector along which a joint moves, in axes of its body."""
        name = joint.element.line
        return unit(Matrix(self.graph, *joint.data[name])) if name else None

    def _main_children(self) -> dict[int, int]:
        """Main child of bodies that may be rotated: moved along a line, with most bodies outboard.

        Left out where the line of the child has its zeros in the axes of the body.
        """
        bodies = self.system.bodies
        outboard_count = [1] * len(bodies)
        best: dict[int, int] = {}
        for i in range(len(bodies) - 1, -1, -1):
            parent = bodies[i].parent
            if parent < 0:
                continue
            outboard_count[parent] += outboard_count[i]
            inner = self.system.joints[parent].element
            if self.lines[i] is not None and inner.angle is not None:
                before = best.get(parent)
                if before is None or outboard_count[i] > outboard_count[before]:
                    best[parent] = i
        return {parent: i for parent, i in best.items() if not self._aligned(parent, i)}

    def _aligned(self, parent: int, child: int) -> bool:
        line = self.lines[parent]
        assert line is not None
        return principal(line) is not None and ZERO in self.outer(child).nodes

    def outer(self, i: int) -> Matrix:
        """Line of joint i in axes of the parent."""
        line = self.lines[i]
        assert line is not None
        return Matrix(self.graph, 3, 3, self.system.joints[i].rotation) @ line

    def frame_change(self, i: int) -> FrameChange:
        """New axes of body i: z along its joint's line, x along a normal to it."""
        g, line = self.graph, self.lines[i]
        same = Matrix.identity(g, 3)
        if line is not None and (i in self.main or principal(line) is None):
            with g.made_by(self.system.bodies[i].name, "axes"):
                x = complement(line)[0]
                if i in self.main:
                    x = _normal(line, self.outer(self.main[i]), x)
                same = Matrix.hstack(x, line.cross(x), line)
        return FrameChange(same, Matrix.zeros(g, 3))

    def joint(self, i: int, new_frames: list[FrameChange]) -> Joint | None:
        """Joint i between new axes; None where it follows from them."""
        g, joint, line = self.graph, self.system.joints[i], self.lines[i]
        rotation_matrix, position = new_joint_pose(self.system, g, new_frames, i)
        if line is None:
            return None
        z = Matrix(g, 3, 1, (ZERO, ZERO, ONE))
        rotates = new_frames[i].rotates
        axis = z if rotates else line
        data = {**joint.data, joint.element.line: (3, 1, axis.nodes)}
        plain = replace(joint, rotation=rotation_matrix.nodes, position=position.nodes, data=data)
        principal_axis = principal(axis)
        simple = all(g.value(n) is not None for n in rotation_matrix.nodes)
        if principal_axis is None or joint.element.angle is None or simple:
            return plain if rotates else None
        # the parent side that leads the axis where it belongs, with the most zeros
        (k, sign), b = principal_axis, self._outward(i, new_frames, rotation_matrix)
        first = self._across(i, b)
        if _best(rotation_matrix, k, b):
            return plain if rotates else None
        column = b * sign
        columns = {k: column, (k + 1) % 3: first, (k + 2) % 3: column.cross(first)}
        fixed = Matrix.hstack(columns[0], columns[1], columns[2])
        # what is left turns about the axis
        remainder = fixed.T @ rotation_matrix
        x, y = (k + 1) % 3, (k + 2) % 3
        angle = atan2(remainder[y, x], remainder[x, x]) * sign
        return replace(plain, rotation=fixed.nodes, offset=angle.node)

    def _outward(self, i: int, new_frames: list[FrameChange], rotation_matrix: Matrix) -> Matrix:
        """Line of joint i in new axes of the parent, x component 0 where x is normal to it."""
        parent = self.system.bodies[i].parent
        b = self.outer(i)
        if parent < 0:
            return b
        b = new_frames[parent].rotated(b)
        if self.main.get(parent) == i:
            return Matrix(self.graph, 3, 1, (ZERO, *b.nodes[1:]))
        return b

    def _across(self, i: int, b: Matrix) -> Matrix:
        """A direction across the line b of joint i with as many zeros as there can be."""
        identity = Matrix.identity(self.graph, 3)
        if principal(b) is not None:
            return complement(b)[0]
        empty = [j for j in range(3) if b.nodes[j] == ZERO]
        if empty:
            return identity.column(empty[0])
        return _normal(identity.column(2), b, identity.column(0))


def _best(rotation_matrix: Matrix, k: int, b: Matrix) -> bool:
    """True when a rotation that leads axis k along b has its zeros already."""
    if principal(b) is not None:
        return False
    other_columns = [rotation_matrix.column(j) for j in range(3) if j != k]
    if ZERO in b.nodes:
        return any(principal(column) is not None for column in other_columns)
    return any(ZERO in column.nodes for column in other_columns)


def _normal(a: Matrix, b: Matrix, otherwise: Matrix) -> Matrix:
    """Unit vector along a x b, another one across a where the two are parallel."""
    across = a.cross(b)
    size = across.dot(across)
    parallel = size.apply("lt", PARALLEL**2)
    scale = 1 / sqrt(select(parallel, 1.0, size))
    for name, step in (("size", size), ("parallel", parallel), ("scale", scale)):
        a.graph.note(step.node, name)
    rows = [select(parallel, o, x * scale) for o, x in zip(otherwise, across, strict=True)]
    # rounding leaves a part along a where lines are nearly parallel: it must go
    direction = Matrix.vector(a.graph, rows).note("across")
    direction = (direction - a * a.dot(direction)).note("normal")
    length = sqrt(direction.dot(direction))
    a.graph.note(length.node, "length")
    return (direction / length).note("unit")
