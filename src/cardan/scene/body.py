"""Rigid bodies as the user describes them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING

from ..elements.quantity import Value
from ..errors import ModelError, brief
from ..records import dataclass
from .checks import triple
from .frame import Located, rows_of
from .shape import Shape

if TYPE_CHECKING:
    from .scene import SceneRecord

INERTIA_ENTRIES = ("xx", "xy", "xz", "yy", "yz", "zz")


@dataclass(frozen=True, eq=False, repr=False)
class Body(Located):
    """A rigid body; made by :meth:`Model.body`. It stands for its own origin frame.

    Attributes:
        model: The model it belongs to.
        name: Its name.
        mass: Mass as written [kg].
        com: Center of mass in body axes (3) [m].
        inertia: Tensor entries xx xy xz yy yz zz about the center of mass, body axes [kg m^2].
        pose: Position and orientation in the reference configuration, or None.
        shapes: What to draw.
        base: Body in whose axes ``pose`` is given, None for the ground.
    """

    model: SceneRecord = field(repr=False)
    name: str
    mass: Value
    com: tuple[Value, Value, Value]
    inertia: tuple[Value, ...]
    pose: tuple[tuple[Value, Value, Value], Value] | None = None
    shapes: tuple[Shape, ...] = ()
    base: Body | None = None

    @property
    def body(self) -> Body:  # type: ignore[override]
        return self

    def __repr__(self) -> str:
        return f"Body({self.name!r})"


def tensor(value: object, name: str) -> tuple[Value, ...]:
    """Entries xx xy xz yy yz zz of an inertia as written: 3x3, three principal values or a dict.

    Raises:
        ModelError: another shape, an unknown entry or a tensor that is not symmetric.
    """
    if value is None:
        return (0, 0, 0, 0, 0, 0)
    if isinstance(value, Mapping):
        unknown = [key for key in value if key not in INERTIA_ENTRIES]
        if unknown:
            raise ModelError(
                f"body '{name}': inertia has no entry {brief(unknown[0])}. "
                f"Entries: {', '.join(INERTIA_ENTRIES)}"
            )
        return tuple(value.get(key, 0) for key in INERTIA_ENTRIES)
    rows = rows_of(value)
    if len(rows) == 3 and not any(rows_of(row) for row in rows):
        return rows[0], 0, 0, rows[1], 0, rows[2]
    if len(rows) != 3 or any(len(rows_of(row)) != 3 for row in rows):
        raise ModelError(
            f"body '{name}': inertia is 3x3, three principal values or dict(xx=, yy=, zz=, xy=, "
            f"yz=, xz=), not {brief(value)}"
        )
    return _symmetric(rows, name)


def _symmetric(rows: list[list[Value]], name: str) -> tuple[Value, ...]:
    # products of rotations round by parts of the largest moment, not of the entry
    numbers = [x for row in rows for x in row if isinstance(x, int | float)]
    rounding = 1e-12 * max((abs(x) for x in numbers), default=0.0)
    for i, j in ((0, 1), (0, 2), (1, 2)):
        a, b = rows[i][j], rows[j][i]
        close = a == b
        if not close and isinstance(a, int | float) and isinstance(b, int | float):
            close = abs(a - b) <= rounding
        if not close:
            raise ModelError(
                f"body '{name}': inertia is not symmetric: entry {'xyz'[i]}{'xyz'[j]} is {a}, "
                f"{'xyz'[j]}{'xyz'[i]} is {b}"
            )
    return rows[0][0], rows[0][1], rows[0][2], rows[1][1], rows[1][2], rows[2][2]


def read_pose(pose: object, name: str) -> tuple[tuple[Value, Value, Value], Value] | None:
    """Position and orientation of ``pose=``: (x, y, z), (position, rotation) or a 4x4 matrix.

    Raises:
        ModelError: another shape.
    """
    if pose is None:
        return None
    rows = rows_of(pose)
    if len(rows) == 4 and all(len(rows_of(row)) == 4 for row in rows):
        position = triple([row[3] for row in rows[:3]], f"body '{name}': pose")
        return position, tuple(tuple(row[:3]) for row in rows[:3])
    if len(rows) == 2:
        return triple(rows[0], f"body '{name}': pose"), rows[1]
    return triple(pose, f"body '{name}': pose"), None


def shapes_of(name: str, shape: object) -> tuple[Shape, ...]:
    """The shapes of a body.

    Raises:
        ModelError: what is given is neither a shape nor several.
    """
    if shape is None or isinstance(shape, Shape):
        return () if shape is None else (shape,)
    shapes = tuple(shape) if isinstance(shape, list | tuple) else (None,)
    if not all(isinstance(one, Shape) for one in shapes):
        raise ModelError(
            f"body '{name}': shape={brief(shape)}: give a shape such as cd.shape.sphere(0.1), or a "
            "list of some"
        )
    return shapes
