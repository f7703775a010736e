"""What parts have in common: declared parameters, and bodies as they are drawn."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from ..api.scene import Scene
from ..elements.quantity import Value
from ..errors import ModelError
from ..scene import inertia, shape
from ..scene.body import Body

if TYPE_CHECKING:
    import sympy

PLANE = "-y"  # about which links in the plane of x and z turn, from x towards z
STEEL = (0.55, 0.58, 0.62)
BLUE = (0.2, 0.45, 0.75)
ORANGE = (0.9, 0.5, 0.15)
GREEN = (0.3, 0.6, 0.35)
DARK = (0.25, 0.25, 0.28)
Color = tuple[float, float, float]
# last words of parameters that are above 0, and that are not below it, as masses are
ABOVE, NOT_BELOW = ("teeth", "module"), ("radius", "length", "thickness", "mass")


def declared(
    scene: Scene, units: Mapping[str, str], values: Mapping[str, float]
) -> dict[str, sympy.Symbol]:
    """Parameters of a part as symbols by their names.

    Args:
        scene: Gets them.
        units: Unit -> names, with blanks between them.
        values: By name; others are ignored.

    Raises:
        ModelError: a mass or a size that cannot be.
    """
    for name in " ".join(units.values()).split():
        word, value = name.rpartition("_")[2], values[name]
        if (word in NOT_BELOW and value < 0) or (word in ABOVE and value <= 0):
            least = "above 0" if word in ABOVE else "that is not negative"
            raise ModelError(f"{scene.name}: {name}={value:g}: give a number {least}")
    return {
        name: scene.parameter(name, values[name], unit)
        for unit, names in units.items()
        for name in names.split()
    }


def link(
    scene: Scene,
    name: str,
    mass: Value,
    length: Value,
    color: Color,
    width: float,
    more: Sequence[shape.Shape] = (),
) -> Body:
    """A slender link from its origin along x, with more that is drawn on it."""
    middle = (length / 2, 0, 0)
    drawn = [shape.box(length, width, width, position=middle, color=color), *more]
    return scene.body(
        name, mass=mass, com=middle, inertia=inertia.rod(mass, length, axis="x"), shape=drawn
    )


def disk(
    scene: Scene, name: str, mass: Value, radius: Value, thickness: Value, axis: str, color: Color
) -> Body:
    """A solid disk about its origin."""
    drawn = shape.cylinder(radius, thickness, axis=axis, color=color)
    moments = inertia.cylinder(mass, radius, thickness, axis=axis)
    return scene.body(name, mass=mass, inertia=moments, shape=drawn)


def elbow(reach: float, first: float, second: float, what: str) -> tuple[float, float]:
    """Angles of two links over a distance, the first of which turns to the positive side.

    Returns:
        That of the first from the line, and of the second from the first [rad].

    Raises:
        ModelError: they do not reach so far, or cannot fold so much.
    """
    cosine = (first**2 + reach**2 - second**2) / (2 * first * reach) if reach else math.inf
    if not abs(cosine) <= 1:
        raise ModelError(
            f"{what}: lengths {first:g} m and {second:g} m do not meet over {reach:g} m, where it "
            "starts; give other lengths"
        )
    bend = (reach**2 - first**2 - second**2) / (2 * first * second)
    return math.acos(cosine), -math.acos(max(-1.0, min(1.0, bend)))
