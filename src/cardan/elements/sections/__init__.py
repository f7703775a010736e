"""The cross-sections of beams, by kind: ``cardan.section``."""

from .circle import Circle
from .general import General
from .hollow_rectangle import HollowRectangle
from .i_beam import IBeam
from .rectangle import Rectangle
from .section import Section
from .tube import Tube

SECTIONS: dict[str, type[Section]] = {
    section.kind: section for section in (Circle, Tube, Rectangle, HollowRectangle, IBeam, General)
}

# as users say it: cd.section.tube(outer=0.05, inner=0.04)
circle = Circle
tube = Tube
rectangle = Rectangle
hollow_rectangle = HollowRectangle
i_beam = IBeam
general = General

__all__ = [
    "SECTIONS",
    "Section",
    "circle",
    "general",
    "hollow_rectangle",
    "i_beam",
    "rectangle",
    "tube",
]
