"""Forces along the line between the origins of two frames."""

from __future__ import annotations

from ...ir.arithmetic import Scalar, select
from ...ir.matrix import Matrix
from ..formulas import Lines
from .force import Action, Load, Motion

SPAN: Lines = (("from a to b", "d = p_b - p_a"), ("distance", "ell = sqrt(dot(d, d))"))
PULL: Lines = (("force on a and on b", "F_a = f / ell * d"), ("", "F_b = -(f / ell * d)"))
RATE = ("its rate", "elldot = dot(d, v_b - v_a) / ell")


def direction(span: Matrix, distance: Scalar) -> Matrix:
    """Unit vector along a span, zero where it has no direction."""
    separated = (distance * 0).apply("lt", distance)
    inverse = select(separated, 1, 0) / select(separated, distance, 1)
    for name, step in (("distance", distance), ("apart", separated), ("inverse_distance", inverse)):
        span.graph.note(step.node, name)
    return (span.note("span") * inverse).note("direction")


def along_line(
    motion: Motion, a: int, b: int, pull: Matrix, energy: Scalar | None, constant: bool = True
) -> Action:
    """A force that pulls a towards b and b towards a."""
    none = Matrix.zeros(motion.graph, 3)
    return Action((Load(a, none, pull), Load(b, none, -pull)), (), energy, constant)
