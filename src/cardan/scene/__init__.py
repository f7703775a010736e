"""The user's scene: bodies, frames, joints, forces, parameters, inputs, outputs; and files."""

from __future__ import annotations

from typing import Any

from . import inertia, shape
from .body import Body
from .files import read
from .frame import Frame
from .scene import SceneRecord

__all__ = ["Body", "Frame", "SceneRecord", "inertia", "read", "shape", "t"]


def __getattr__(name: str) -> Any:
    """``t``, the symbol of time, is made on demand: it needs SymPy."""
    if name == "t":
        from sympy import Symbol

        return Symbol("t")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
