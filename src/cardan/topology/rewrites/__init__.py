"""Rewrites of the system graph: other frames and numbers of the bodies, the same motion.

Each takes a System and gives one with the same coordinates, speeds, parameters and forces whose
equations of motion take fewer operations. Frames of the user are told in the new axes.
"""

from __future__ import annotations

from collections.abc import Callable

from ..system import System
from .axes import axes
from .base_parameters import base_parameters
from .origins import origins
from .parallel import parallel

# in the order in which they are applied
REWRITES: dict[str, Callable[[System], System]] = {
    "axes": axes,
    "origins": origins,
    "parallel": parallel,
    "base_parameters": base_parameters,
}

__all__ = ["REWRITES"]
