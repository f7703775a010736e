"""The lines along which beams lie, by kind."""

from .arc import Arc
from .centerline import Centerline, Curve
from .spline import Spline
from .straight import Straight

CENTERLINES: dict[str, type[Centerline]] = {line.kind: line for line in (Straight, Arc, Spline)}

# as users say it: line=cd.arc(center=(0, 0, 1))
arc = Arc
spline = Spline

__all__ = ["CENTERLINES", "Centerline", "Curve", "Straight", "arc", "spline"]
