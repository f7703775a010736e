"""What is drawn of a geom."""

from __future__ import annotations

from ... import shape
from ...shape import Shape
from ..document import Element
from ..pose import Pose, written
from .compiler import Compiler
from .masses import SIZES, solid


def of_geom(geom: Element, kind: str, compiler: Compiler, around: Pose) -> list[Shape]:
    """The shape of a geom; none for planes, meshes and what is fitted to meshes.

    Args:
        around: Pose of the frames around it, in axes of the body.
    """
    if kind not in SIZES or geom.raw.get("mesh") is not None:
        return []
    form = solid(geom, kind, compiler)
    pose = around.then(form.pose)
    color = geom.numbers("rgba", 4) if geom.raw.get("rgba") is not None else None
    a, b, c = (*form.size, 0.0, 0.0)[:3]
    if kind in ("sphere", "ellipsoid"):
        # an ellipsoid is drawn as the ball of its longest half axis
        return [shape.sphere(max(form.size), position=pose.position, color=color)]
    turn = written(pose.rotation)
    if kind == "box":
        return [shape.box(2 * a, 2 * b, 2 * c, position=pose.position, rotation=turn, color=color)]
    drawn = shape.capsule if kind == "capsule" else shape.cylinder
    return [drawn(a, 2 * b, position=pose.position, rotation=turn, color=color)]
