"""The joints, by kind."""

from .constant_velocity import ConstantVelocity
from .custom import Custom
from .cylindrical import Cylindrical
from .distance import Distance
from .fixed import Fixed
from .free import Free
from .gear import Gear
from .joint import Component, Joint
from .planar import Planar
from .point_on_curve import PointOnCurve
from .point_on_plane import PointOnPlane
from .prismatic import Prismatic
from .revolute import Revolute
from .rolling_disk import RollingDisk
from .screw import Screw
from .spherical import Spherical
from .translation import Translation
from .universal import Universal
from .wheel import Wheel

JOINTS: dict[str, type[Joint]] = {
    joint.kind: joint
    for joint in (
        Fixed,
        Revolute,
        Prismatic,
        Cylindrical,
        Screw,
        Universal,
        ConstantVelocity,
        Spherical,
        Planar,
        Translation,
        Free,
        PointOnPlane,
        PointOnCurve,
        Distance,
        Gear,
        Wheel,
        RollingDisk,
        Custom,
    )
}

__all__ = ["JOINTS", "Component", "Joint", *(joint.__name__ for joint in JOINTS.values())]
