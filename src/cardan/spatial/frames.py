"""Axes with names, and the rotations between them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from ..errors import ModelError
from ..ir.derivative import forward
from ..ir.graph import Graph
from ..ir.matrix import Matrix

Rates = Mapping[int, int]


@dataclass(frozen=True, eq=False)
class Frame:
    """Axes: the first ones stand alone, all others are turned from a parent.

    Two frames are the same only if they are one object; names are for people.

    Attributes:
        graph: Where expressions in these axes live.
        name: What messages call it.
        parent: The axes it is turned from, None for the first.
        rotation: R (3, 3), coordinates here to coordinates in the parent.
        angular_velocity: Against the parent in the axes here [rad/s], (3, 1), where it was given.
    """

    graph: Graph = field(repr=False)
    name: str
    parent: Frame | None = field(default=None, repr=False)
    rotation: Matrix | None = field(default=None, repr=False)
    angular_velocity: Matrix | None = field(default=None, repr=False)

    def turned(self, name: str, rotation: Matrix, angular_velocity: Matrix | None = None) -> Frame:
        """New axes, turned from these.

        Args:
            name: Other than those of the frames it descends from.
            rotation: R (3, 3), coordinates in the new axes to coordinates here.
            angular_velocity: Of the new axes against these, in the new axes [rad/s], (3, 1).
                Left out, it is derived from the rotation where it is needed.

        Raises:
            ModelError: a name that is taken, or wrong shapes.
        """
        if name in (frame.name for frame in self.line()):
            raise ModelError(f"frame '{name}': a frame it descends from has this name; choose one")
        if (rotation.rows, rotation.columns) != (3, 3):
            raise ModelError(
                f"frame '{name}': the rotation is {rotation.rows} x {rotation.columns}; "
                "give a 3 x 3 matrix"
            )
        if angular_velocity is not None and len(angular_velocity.nodes) != 3:
            raise ModelError(f"frame '{name}': the angular velocity must have 3 components")
        return Frame(self.graph, name, self, rotation, angular_velocity)

    def line(self) -> list[Frame]:
        """This frame, its parent, and so on to the first."""
        frame, found = self, [self]
        while frame.parent is not None:
            frame = frame.parent
            found.append(frame)
        return found

    def rotation_in(self, other: Frame) -> Matrix:
        """R (3, 3): coordinates in this frame to coordinates in the other.

        Raises:
            ModelError: no rotation connects the two.
        """
        up, down = self._paths(other)
        total = Matrix.identity(self.graph, 3)
        for frame in up:
            total = _rotation(frame) @ total
        for frame in reversed(down):
            total = _rotation(frame).T @ total
        return total

    def angular_velocity_in(self, other: Frame, rates: Rates | None = None) -> Matrix:
        """Angular velocity of this frame as seen from the other, in the axes here, (3, 1).

        Args:
            other: The observer.
            rates: Node of a variable -> node of its rate; for frames whose angular velocity was
                not given.

        Raises:
            ModelError: no rotation connects the two.
        """
        up, down = self._paths(other)
        total = Matrix.zeros(self.graph, 3)
        for frame in up:
            total = total + self._carried(frame, rates or {})
        for frame in down:
            total = total - self._carried(frame, rates or {})
        return total

    def _carried(self, frame: Frame, rates: Rates) -> Matrix:
        """Angular velocity of a frame against its parent, in the axes here."""
        omega = frame.angular_velocity
        if omega is None:
            omega = spin(_rotation(frame), rates)
        return frame.rotation_in(self) @ omega

    def _paths(self, other: Frame) -> tuple[list[Frame], list[Frame]]:
        """Frames below the nearest common one, from here and from the other."""
        mine, theirs = self.line(), other.line()
        if mine[-1] is not theirs[-1]:
            raise ModelError(
                f"frames '{self.name}' and '{other.name}' are not connected by rotations; make "
                "one with .turned() from a frame of the other's line"
            )
        while mine and theirs and mine[-1] is theirs[-1]:
            mine.pop()
            theirs.pop()
        return mine, theirs


def _rotation(frame: Frame) -> Matrix:
    """Rotation of a frame that has a parent."""
    assert frame.rotation is not None
    return frame.rotation


def spin(R: Matrix, rates: Rates) -> Matrix:
    """Angular velocity (3, 1) in turned axes, from Rᵀ Rdot.

    Args:
        R: Rotation, (3, 3).
        rates: Node of a variable -> node of its rate.
    """
    rate = Matrix(R.graph, 3, 3, forward(R.graph, R.nodes, rates))
    # only the three entries that are read are made
    columns = [R.column(k) for k in range(3)]
    entries = [columns[i].dot(rate.column(j)) for i, j in ((2, 1), (0, 2), (1, 0))]
    return Matrix.vector(R.graph, entries)
