"""Colors of URDF materials."""

from __future__ import annotations

from collections.abc import Callable
from xml.etree.ElementTree import Element as XmlElement

from ..document import Element
from ..meshes import Color


def material_colors(root: XmlElement) -> Callable[[Element], Color | None]:
    """The function from a ``<visual>`` to its red, green, blue, opacity in 0 ... 1.

    A material with a color of its own has that one. Others name a material of the robot, or one
    that another link defines; the first of a name counts. Textures have no color.

    Args:
        root: The robot.

    Raises:
        ModelError: a color is not four numbers.
    """
    by_name: dict[str, Color] = {}
    # those of the robot before those of links
    for raw in (*root.findall("material"), *root.iter("material")):
        color = _color(Element(raw, f"material '{raw.get('name', '')[:80]}'"))
        if color is not None:
            by_name.setdefault(raw.get("name", ""), color)

    def color_of(visual: Element) -> Color | None:
        """Color of a visual, None if it has none."""
        material = visual.child("material")
        if material is None:
            return None
        return _color(material) or by_name.get(material.raw.get("name", ""))

    return color_of


def _color(material: Element) -> Color | None:
    color = material.child("color")
    if color is None:
        return None
    return tuple(min(max(x, 0.0), 1.0) for x in color.numbers("rgba", 4))
