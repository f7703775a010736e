"""Inertia of a beam lumped at its ends."""

from __future__ import annotations

from typing import ClassVar

from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines, Shapes
from .element_ends import Ends
from .formulas import LUMPED, SPIN_SHAPES
from .inertia import DENSITY, InertiaElement, spin
from .section import GRAVITY


@dataclass(frozen=True)
class LumpedInertia(InertiaElement):
    """Half of the mass and of the moments of inertia at each end.

    The quickest, ``kinetic = sum of the ends of m v·v / 4 + omega·I omega / 4``; second order, and
    frequencies come out too low.

    Source: T. J. R. Hughes, The Finite Element Method, 1987, section 7.3.
    """

    kind: ClassVar[str] = "lumped_inertia"
    geometric: ClassVar[tuple[str, ...]] = ("length",)
    symbol_shapes: ClassVar[Shapes] = SPIN_SHAPES
    formulas: ClassVar[Lines] = LUMPED

    @property
    def common(self) -> tuple[str, ...]:
        return (*DENSITY, *GRAVITY)

    def loads(self, ends: Ends) -> list[Matrix]:
        half, gravity = ends.number("length") * 0.5, ends.vector(*GRAVITY)
        mass, inertia = half * ends.number("rhoA"), spin(ends, 0.5)
        loads: list[Matrix] = []
        for k in range(2):
            motion = ends.motion(k)
            gyroscopic = motion.omega.cross(inertia @ motion.omega)
            loads += [
                inertia @ motion.omega_rate + gyroscopic,
                (motion.acceleration - gravity) * mass,
            ]
        return loads

    def energies(self, ends: Ends) -> tuple[Matrix, Matrix]:
        mass, inertia = ends.number("length") * 0.5 * ends.number("rhoA"), spin(ends, 0.5)
        kinetic = potential = Matrix.zeros(ends.graph, 1)
        for k in range(2):
            motion = ends.motion(k)
            linear = motion.velocity.T @ motion.velocity
            kinetic = kinetic + linear * mass + motion.omega.T @ (inertia @ motion.omega)
            potential = potential - ends.vector(*GRAVITY).T @ ends.pose(k).position
        return kinetic * 0.5, potential * mass

    def momentum(self, ends: Ends) -> Matrix:
        mass, inertia = ends.number("length") * 0.5 * ends.number("rhoA"), spin(ends, 0.5)
        total = Matrix.zeros(ends.graph, 6)
        for k in range(2):
            pose, motion = ends.pose(k), ends.motion(k)
            linear = motion.velocity * mass
            spin_part = pose.rotation @ (inertia @ motion.omega)
            total = total + Matrix.vstack(pose.position.cross(linear) + spin_part, linear)
        return total
