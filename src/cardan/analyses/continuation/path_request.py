"""The arguments that say where a path starts, and the start that they lead to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from numpy.typing import ArrayLike

from ...arguments import LockedValues
from .follow import Place
from .solutions import Solutions
from .special_points import Special, Test


@dataclass(frozen=True)
class PathRequest:
    """Arguments of ``model.continuation`` that concern its solutions.

    Attributes:
        swept: Name -> (start, end).
        q: Coordinates to start from, by name or (nq,).
        locked: Coordinate -> value it keeps, or (start, end).
        u: Speed of a steady motion -> value it keeps, or (start, end).
        inputs, parameters: Values by name that stay, else those of the model.
        t: Time [s].
        start: A solution or special point to start from.
    """

    swept: Mapping[str, object]
    q: Mapping[str, ArrayLike] | ArrayLike | None
    locked: LockedValues
    u: Mapping[str, object] | None
    inputs: Mapping[str, float] | None
    parameters: Mapping[str, float] | None
    t: float
    start: object = None


@dataclass(frozen=True)
class PathStart:
    """Where a path starts.

    Attributes:
        solutions: What it consists of.
        places: Its first places.
        special: The first one, where curves cross there.
        end: Where it ends.
    """

    solutions: Solutions
    places: Sequence[Place]
    special: Sequence[Special]
    end: Test
