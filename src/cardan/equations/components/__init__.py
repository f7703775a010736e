"""Components: the matrices of a part of a scene by the elements that it has there."""

from .beams import from_beams, reduce

__all__ = ["from_beams", "reduce"]
