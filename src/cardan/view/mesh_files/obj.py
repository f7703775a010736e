"""Wavefront OBJ files: polygons, and the diffuse colors of the material file beside them.

Source: Wavefront Technologies, Advanced Visualizer manual (1995), appendix B.
"""

from __future__ import annotations

import re
from array import array
from io import BytesIO
from itertools import pairwise
from pathlib import Path

import numpy as np

from ... import regular_file
from ...errors import ModelError
from .part import MOST_TRIANGLES, Color, Part, merged, rgb

MATERIAL_FILE = 4 * 2**20  # bytes
LONGEST_LINE, LONGEST_NUMBER, LONGEST_NAME = 2**20, 40, 1000
MOST_FILES, MOST_MATERIALS = 16, 4096


def parts(content: bytes, path: Path) -> list[Part]:
    """The polygons of an OBJ file, cut into triangles around their first corner, by color.

    Raises:
        ModelError: a line that cannot be read, or too many triangles, materials or files.
    """
    points, files = array("d"), list[str]()
    groups: dict[str, array[int]] = {}
    name, count = "", 0
    # a backslash continues a line
    for number, line in enumerate(BytesIO(re.sub(rb"\\\r?\n", b" ", content)), 1):
        if len(line) > LONGEST_LINE:
            raise ModelError(f"line {number} of '{path.name}' is too long")
        tokens = line.split()
        try:
            match tokens[:1]:
                case [b"v"]:
                    points.extend(_numbers(tokens[1:4], 3))
                case [b"f"]:
                    corners = [_corner(word, len(points) // 3) for word in tokens[1:]]
                    count += len(corners) - 2
                    rows = groups.setdefault(name, array("q"))
                    for second, third in pairwise(corners[1:]):
                        rows.extend((corners[0], second, third))
                case [b"usemtl"]:
                    name = _name(tokens)
                case [b"mtllib"]:
                    files.append(_name(tokens))
        except ValueError:
            raise ModelError(f"line {number} of '{path.name}' cannot be read") from None
        if count > MOST_TRIANGLES or len(groups) > MOST_MATERIALS or len(files) > MOST_FILES:
            raise ModelError("it has too many triangles, materials or material files")
    positions = np.array(points).reshape(-1, 3)
    colors = _colors(files, path)
    by_color: dict[Color | None, array[int]] = {}
    for name, rows in groups.items():
        by_color.setdefault(colors.get(name), array("q")).extend(rows)
    return [merged(positions, np.array(rows), color) for color, rows in by_color.items() if rows]


def _numbers(tokens: list[bytes], count: int) -> list[float]:
    if len(tokens) != count or any(len(word) > LONGEST_NUMBER for word in tokens):
        raise ValueError("not so many numbers")
    return [float(word) for word in tokens]


def _corner(word: bytes, count: int) -> int:
    """Row of a corner such as ``7/2/3``; negative numbers count back from the last vertex."""
    text = word.partition(b"/")[0]
    if len(text) > LONGEST_NUMBER:
        raise ValueError("not a number")
    number = int(text)
    row = number - 1 if number > 0 else count + number
    if not 0 <= row < count or number == 0:
        raise ValueError("not a vertex above")
    return row


def _name(tokens: list[bytes]) -> str:
    return b" ".join(tokens[1:])[:LONGEST_NAME].decode("utf-8", "replace")


def _colors(files: list[str], path: Path) -> dict[str, Color | None]:
    """Colors of the materials in files that lie below the folder of the OBJ file."""
    home = path.resolve().parent
    colors: dict[str, Color | None] = {}
    for file in files:
        try:
            # links that lead in a circle are a RuntimeError before Python 3.13
            if "\0" in file or not (place := (home / file).resolve()).is_relative_to(home):
                continue
            content = regular_file.content(place, MATERIAL_FILE)
        except (OSError, RuntimeError):
            # pictures do without colors
            continue
        colors |= _materials(content)
    return colors


def _materials(content: bytes) -> dict[str, Color | None]:
    """Diffuse color of every material; None where it is not three numbers."""
    colors: dict[str, Color | None] = {}
    name = ""
    for line in BytesIO(content):
        tokens = line.split()
        match tokens[:1]:
            case [b"newmtl"]:
                name = _name(tokens)
                colors[name] = None
                if len(colors) > MOST_MATERIALS:
                    raise ModelError(f"more than {MOST_MATERIALS} materials")
            case [b"Kd"]:
                try:
                    colors[name] = rgb(_numbers(tokens[1:4], 3))
                except ValueError:
                    colors[name] = None
    return colors
