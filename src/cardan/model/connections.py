"""Joints and forces as the user describes them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ..elements.forces.force import ForceElement
from ..elements.joints.joint import Joint as JointElement
from .frame import Place

Limits = tuple[float | None, float | None, float | None, float | None]


@dataclass(frozen=True)
class Couple:
    """q = ratio q_leader + offset."""

    leader: str
    ratio: Any
    offset: Any


@dataclass(frozen=True, eq=False)
class Joint:
    """A joint between two frames; made by :meth:`Model.joint`.

    Attributes:
        name: Its name.
        kind: The joint element.
        parent, child: The frames (or bodies) it joins.
        motion: Prescribed coordinate as an expression in t or an input, or None.
        q0, u0: Initial values, None where not named.
        limits: Lower, upper, speed, effort, as far as given.
        at: Its place in ground axes at the reference configuration, or None.
        couple: What it follows, or None.
        friction: Dry friction of a file [N m or N]; it does not act yet.
    """

    name: str
    kind: JointElement
    parent: Place
    child: Place
    motion: Any = None
    q0: tuple[float, ...] | None = None
    u0: tuple[float, ...] | None = None
    limits: Limits = (None, None, None, None)
    at: tuple[Any, Any, Any] | None = None
    couple: Couple | None = None
    friction: float = 0.0

    def __repr__(self) -> str:
        ends = f"{self.parent.name!r} -> {self.child.name!r}"
        return f"Joint({self.name!r}, {self.kind.kind}, {ends})"


@dataclass(frozen=True, eq=False)
class Force:
    """A named force element; made by :meth:`Model.force`."""

    name: str
    element: ForceElement
