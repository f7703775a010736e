"""Shapes for pictures. They have no mass and touch nothing."""

from __future__ import annotations

from collections.abc import Sequence

from ..arguments import checked
from ..elements.quantity import Value
from ..errors import ModelError
from ..records import dataclass
from .checks import triple


@dataclass(frozen=True)
class Shape:
    """Something to draw on a body.

    Attributes:
        kind: cylinder, box, sphere, capsule or mesh.
        size: Its measures by name [m]; for a mesh ``file`` and ``scale``.
        position: Its center in body axes (3) [m].
        rotation: its orientation as ``at`` of a body takes it.
        color: Red, green, blue, opacity in 0 ... 1, or None.
    """

    kind: str
    size: tuple[tuple[str, Value], ...]
    position: tuple[Value, Value, Value] = (0, 0, 0)
    rotation: Value | None = None
    color: tuple[float, float, float, float] | None = None


@checked
def cylinder(
    radius: Value,
    length: Value,
    *,
    axis: str = "z",
    position: Sequence[Value] = (0, 0, 0),
    rotation: Value | None = None,
    color: Sequence[float] | None = None,
) -> Shape:
    """A cylinder along an axis, its center at ``position``."""
    size = (("radius", radius), ("length", length), ("axis", axis))
    return _shape("cylinder", size, position, rotation, color)


@checked
def capsule(
    radius: Value,
    length: Value,
    *,
    axis: str = "z",
    position: Sequence[Value] = (0, 0, 0),
    rotation: Value | None = None,
    color: Sequence[float] | None = None,
) -> Shape:
    """A cylinder with half spheres on its ends; ``length`` is that of the cylinder."""
    size = (("radius", radius), ("length", length), ("axis", axis))
    return _shape("capsule", size, position, rotation, color)


@checked
def box(
    x: Value,
    y: Value,
    z: Value,
    *,
    position: Sequence[Value] = (0, 0, 0),
    rotation: Value | None = None,
    color: Sequence[float] | None = None,
) -> Shape:
    """A box with edges x, y, z, its center at ``position``."""
    return _shape("box", (("x", x), ("y", y), ("z", z)), position, rotation, color)


@checked
def sphere(
    radius: Value, *, position: Sequence[Value] = (0, 0, 0), color: Sequence[float] | None = None
) -> Shape:
    """A sphere with its center at ``position``."""
    return _shape("sphere", (("radius", radius),), position, None, color)


@checked
def mesh(
    file: str,
    *,
    scale: Sequence[float] = (1.0, 1.0, 1.0),
    position: Sequence[Value] = (0, 0, 0),
    rotation: Value | None = None,
    color: Sequence[float] | None = None,
) -> Shape:
    """A mesh file (STL, OBJ, DAE), scaled along its own axes."""
    return _shape("mesh", (("file", file), ("scale", tuple(scale))), position, rotation, color)


def _shape(
    kind: str,
    size: tuple[tuple[str, Value], ...],
    position: Sequence[Value],
    rotation: Value | None,
    color: Sequence[float] | None,
) -> Shape:
    x, y, z = triple(position, f"shape.{kind}: position")
    paint = None
    if color is not None:
        if len(color) not in (3, 4):
            raise ModelError(
                f"shape.{kind}: color has {len(color)} entries; give red, green, blue, 0 to 1, and "
                "the opacity behind them if you like"
            )
        red, green, blue, *alpha = (float(c) for c in color)
        paint = (red, green, blue, alpha[0] if alpha else 1.0)
    return Shape(kind, size, (x, y, z), rotation, paint)
