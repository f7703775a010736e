"""Shapes in plain numbers, for viewers: pictures have no parameters."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...scene.checks import is_number
from ...scene.scene import SceneRecord
from ...scene.shape import Shape
from ...spatial.numbers import Rows, of_sequence


def pictures(
    model: SceneRecord, frames: Mapping[Any, int]
) -> tuple[tuple[int, dict[str, object]], ...]:
    """Number of a body's frame and its shape; expressions at the defaults of the parameters.

    Args:
        model: The scene.
        frames: Body -> number of its frame.
    """
    return tuple(
        (frames[body], _record(shape, model))
        for body in (model.ground, *model.bodies.values())
        for shape in body.shapes
    )


def _record(shape: Shape, model: SceneRecord) -> dict[str, object]:
    """``kind``, its measures, ``position`` (3), ``rotation`` (3, 3) or None, ``color``."""
    row: dict[str, object] = {"kind": shape.kind}
    for key, size in shape.size:
        row[key] = size if isinstance(size, (str, tuple)) else _number(size, model)
    row["position"] = tuple(_number(x, model) for x in shape.position)
    row["rotation"] = None if shape.rotation is None else _rotation(shape.rotation, model)
    row["color"] = shape.color
    return row


def _number(value: Any, model: SceneRecord) -> float:
    if is_number(value):
        return float(value)
    defaults = {p.name: p.value for p in model.parameters.values()}
    return float(value.subs({s: defaults.get(s.name, 0.0) for s in value.free_symbols}))


def _rotation(value: Any, model: SceneRecord) -> Rows:
    if hasattr(value, "as_matrix"):
        value = value.as_matrix()
    value = value.tolist() if hasattr(value, "tolist") else value
    if len(value) == 4 and isinstance(value[0], str):
        return of_sequence(value[0], [_number(angle, model) for angle in value[1:]])
    return [[_number(x, model) for x in row] for row in value]
