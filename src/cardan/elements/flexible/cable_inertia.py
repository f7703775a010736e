"""Consistent inertia of a piece of a cable."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ...ir.matrix import Matrix
from ..formulas import Lines
from .element_ends import Ends
from .formulas import CABLE_INERTIA
from .inertia import InertiaElement
from .section import GRAVITY


@dataclass(frozen=True)
class CableInertia(InertiaElement):
    """Mass of the straight line between the ends, whatever their axes do.

    ``kinetic = m (v_1·v_1 + v_1·v_2 + v_2·v_2) / 6``.

    Source: T. J. R. Hughes, The Finite Element Method, 1987, section 7.3.
    """

    kind: ClassVar[str] = "cable_inertia"
    geometric: ClassVar[tuple[str, ...]] = ("length",)
    formulas: ClassVar[Lines] = CABLE_INERTIA

    @property
    def common(self) -> tuple[str, ...]:
        return ("rhoA", *GRAVITY)

    def loads(self, ends: Ends) -> list[Matrix]:
        gravity, none = ends.vector(*GRAVITY), Matrix.zeros(ends.graph, 3)
        one, two = (ends.motion(k).acceleration - gravity for k in range(2))
        sixth = ends.number("rhoA") * ends.number("length") / 6.0
        return [none, (one * 2.0 + two) * sixth, none, (one + two * 2.0) * sixth]

    def energies(self, ends: Ends) -> tuple[Matrix, Matrix]:
        one, two = (ends.motion(k).velocity for k in range(2))
        mass = ends.number("rhoA") * ends.number("length")
        middle = ends.pose(0).position + ends.pose(1).position
        kinetic = (one.T @ (one + two) + two.T @ two) * (mass / 6.0)
        return kinetic, ends.vector(*GRAVITY).T @ middle * (mass * -0.5)

    def momentum(self, ends: Ends) -> Matrix:
        (p, v), (r, w) = ((ends.pose(k).position, ends.motion(k).velocity) for k in range(2))
        sixth = ends.number("rhoA") * ends.number("length") / 6.0
        angular = p.cross(v * 2.0 + w) + r.cross(v + w * 2.0)
        return Matrix.vstack(angular, (v + w) * 3.0) * sixth
