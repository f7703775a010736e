"""Shapes of a scene as <visual>s of URDF."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from xml.etree import ElementTree as xml

import numpy as np

from ...arrays import Array
from .numeric_scene import roll_pitch_yaw

# measures by name, as system graphs have them
ShapeNumbers = Mapping[str, object]
# rotations that turn z to an axis: cylinders of URDF are along z
ALONG = {
    "x": ((0, 0, 1), (0, 1, 0), (-1, 0, 0)),
    "y": ((1, 0, 0), (0, 0, 1), (0, -1, 0)),
    "z": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
}


def visual(link: xml.Element, shape: ShapeNumbers, folder: Path) -> None:
    """Draw a shape on a link; of a capsule its three parts.

    Args:
        link: The <link>.
        shape: In plain numbers, as a system graph has it.
        folder: Meshes below it are named from there.
    """
    pose = np.eye(4)
    pose[:3, 3] = np.asarray(shape["position"])
    if shape["rotation"] is not None:
        pose[:3, :3] = np.asarray(shape["rotation"])
    for tag, sizes, place in _geometries(shape, folder):
        visual, at = xml.SubElement(link, "visual"), pose @ place
        origin(visual, at[:3, 3], roll_pitch_yaw(at[:3, :3]))
        xml.SubElement(xml.SubElement(visual, "geometry"), tag, sizes)
        if shape["color"] is not None:
            color = text(np.asarray(shape["color"]))
            material = xml.SubElement(visual, "material", name=f"rgba {color}")
            xml.SubElement(material, "color", rgba=color)


def _geometries(shape: ShapeNumbers, folder: Path) -> Iterator[tuple[str, dict[str, str], Array]]:
    """Tag, measures, and place in axes of the shape (4, 4)."""
    kind, here = shape["kind"], np.eye(4)
    if kind == "box":
        yield "box", {"size": text([_measure(shape, x) for x in "xyz"])}, here
    elif kind == "sphere":
        yield "sphere", {"radius": repr(_measure(shape, "radius"))}, here
    elif kind == "mesh":
        sizes = {
            "filename": _file(str(shape["file"]), folder),
            "scale": text(np.asarray(shape["scale"])),
        }
        yield "mesh", sizes, here
    else:
        here[:3, :3] = ALONG[str(shape["axis"])]
        radius, length = _measure(shape, "radius"), _measure(shape, "length")
        yield "cylinder", {"radius": repr(radius), "length": repr(length)}, here
        for side in (-0.5, 0.5) if kind == "capsule" else ():
            end = np.eye(4)
            end[:3, 3] = here[:3, 2] * side * length
            yield "sphere", {"radius": repr(radius)}, end


def _measure(shape: ShapeNumbers, name: str) -> float:
    value = shape[name]
    assert isinstance(value, int | float)
    return float(value)


def _file(file: str, folder: Path) -> str:
    """A mesh below the folder of the robot is named from there."""
    path = Path(file)
    inside = path.is_absolute() and path.is_relative_to(folder)
    return path.relative_to(folder).as_posix() if inside else file


def origin(
    element: xml.Element, xyz: Sequence[float] | Array, rpy: Sequence[float] | Array
) -> None:
    """Add an <origin>: position, and angles about the fixed axes x, y, z."""
    xml.SubElement(element, "origin", xyz=text(xyz), rpy=text(rpy))


def text(numbers: Sequence[float] | Array) -> str:
    """Numbers with all their digits; a negative zero is none."""
    return " ".join(repr(float(x) + 0.0) for x in numbers)
