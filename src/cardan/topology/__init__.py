"""From a model to the system graph: spanning tree, coordinate slots, expressions."""

from .build import build
from .prescribed_motion import named_speeds
from .system import System

__all__ = ["System", "build", "named_speeds"]
