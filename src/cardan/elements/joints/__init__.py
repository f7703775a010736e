"""The joints, by kind."""

from .fixed import Fixed
from .free import Free
from .joint import Component, Joint
from .prismatic import Prismatic
from .revolute import Revolute
from .spherical import Spherical

JOINTS: dict[str, type[Joint]] = {
    joint.kind: joint for joint in (Fixed, Revolute, Prismatic, Spherical, Free)
}
