"""The joints, by kind."""

from .custom import Custom
from .cylindrical import Cylindrical
from .fixed import Fixed
from .free import Free
from .joint import Component, Joint
from .planar import Planar
from .prismatic import Prismatic
from .revolute import Revolute
from .screw import Screw
from .spherical import Spherical
from .universal import Universal

JOINTS: dict[str, type[Joint]] = {
    joint.kind: joint
    for joint in (
        Fixed,
        Revolute,
        Prismatic,
        Cylindrical,
        Screw,
        Universal,
        Spherical,
        Planar,
        Free,
        Custom,
    )
}

__all__ = ["JOINTS", "Component", "Joint", *(joint.__name__ for joint in JOINTS.values())]
