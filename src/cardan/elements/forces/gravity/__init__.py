"""The gravity fields, in the order of their names in scenes."""

from .central_gravity import CentralGravity
from .gravitation import Gravitation
from .gravity_gradient import GravityGradient
from .j2 import J2

FIELDS: tuple[type[Gravitation], ...] = (CentralGravity, GravityGradient, J2)
