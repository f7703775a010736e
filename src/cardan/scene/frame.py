"""Frames fixed to bodies, and named placeholders for their motion."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Union

from ..arguments import checked
from ..elements.quantity import Rows, Value
from ..records import dataclass
from .checks import triple

if TYPE_CHECKING:
    import sympy

    from .body import Body
    from .scene import SceneRecord

Place = Union["Frame", "Body"]


class Located:
    """Something with a position and axes whose motion may be used in expressions.

    The methods return SymPy objects whose symbols are placeholders: the equations replace them by
    the motion of the frame. They may stand wherever a number may: in force laws, outputs, joints.
    """

    __slots__ = ()

    body: Body
    name: str

    def _atoms(self, quantity: str, rows: int, columns: int, *others: object) -> sympy.Matrix:
        import sympy

        symbols = self.body.model.placeholders(self, quantity, rows * columns, others)
        return sympy.ImmutableMatrix(rows, columns, symbols)

    @checked
    def at(
        self,
        x: Value = 0,
        y: Value = 0,
        z: Value = 0,
        *,
        rotation: Rows | None = None,
        name: str | None = None,
    ) -> Frame:
        """A frame fixed to the same body, placed from here.

        Args:
            x, y, z: Its origin in these axes, from this origin [m].
            rotation: Orientation: R from its axes to these axes (3, 3), a SciPy ``Rotation`` or a
                sequence and three angles such as ``("XYZ", a, b, c)``.
            name: Under which it is known to ``pose``, ``velocity`` and the like.

        Raises:
            ModelError: the name is taken.
        """
        return self.body.model.add_frame(self, (x, y, z), rotation, name)

    @checked
    def position(self, wrt: Place | None = None, in_: Place | None = None) -> sympy.Matrix:
        """Position of the origin (3, 1) [m], against ``wrt``, in the axes of ``in_``.

        Args:
            wrt: Frame or body from whose origin it is measured; the ground by default.
            in_: Frame or body whose axes it is given in; the ground by default.
        """
        return self._atoms("position", 3, 1, wrt, in_)

    @checked
    def velocity(self, wrt: Place | None = None, in_: Place | None = None) -> sympy.Matrix:
        """Velocity of the origin (3, 1) [m/s] as seen from ``wrt``, in the axes of ``in_``."""
        return self._atoms("velocity", 3, 1, wrt, in_)

    @checked
    def acceleration(self, wrt: Place | None = None, in_: Place | None = None) -> sympy.Matrix:
        """Acceleration of the origin (3, 1) [m/s^2] as seen from ``wrt``, in axes of ``in_``."""
        return self._atoms("acceleration", 3, 1, wrt, in_)

    @checked
    def angular_velocity(self, wrt: Place | None = None, in_: Place | None = None) -> sympy.Matrix:
        """Angular velocity (3, 1) [rad/s] against ``wrt``, in the axes of ``in_``."""
        return self._atoms("angular_velocity", 3, 1, wrt, in_)

    @checked
    def rotation(self, wrt: Place | None = None) -> sympy.Matrix:
        """R (3, 3): coordinates in these axes to coordinates in those of ``wrt`` (the ground)."""
        return self._atoms("rotation", 3, 3, wrt, None)


@dataclass(frozen=True, eq=False, repr=False)
class Frame(Located):
    """A frame fixed to a body; made by :meth:`Located.at`.

    Attributes:
        body: The body it is fixed to.
        coordinates: Origin in axes of the body, or of ``base`` (3) [m].
        orientation: Orientation against these axes as written, None for the same axes.
        name: Its own name, or a made one such as ``upper.at1``.
        named: True where the user gave the name.
        base: The frame of the body from which it is placed, None for the body's own.
    """

    body: Body
    coordinates: tuple[Value, Value, Value]
    orientation: Value
    name: str
    named: bool
    base: Frame | None = None

    def __repr__(self) -> str:
        return f"Frame({self.name!r} on {self.body.name!r})"


def rows_of(value: object) -> Rows:
    """Rows of a matrix, array or sequence; [] for anything else, which no shape check passes."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    return list(value) if isinstance(value, Sequence) and not isinstance(value, str) else []


def new_frame_of(
    model: SceneRecord,
    base: Located,
    position: Sequence[Value],
    orientation: Rows | None,
    name: str | None,
) -> Frame:
    """A new frame of a model; without a name it gets one after its body."""
    named, body = name is not None, base.body
    if name is None:
        count = 1
        while f"{body.name}.at{count}" in model.frames:
            count += 1
        name = f"{body.name}.at{count}"
    model.new_place("frame", name)
    outer = base if isinstance(base, Frame) else None
    frame = Frame(body, triple(position, f"frame '{name}'"), orientation, name, named, outer)
    model.frames[name] = frame
    return frame
