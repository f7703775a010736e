"""A flexible hinge: soft about one axis, stiff in all other directions."""

from __future__ import annotations

from typing import ClassVar

from ...ir.arithmetic import norm
from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines, Shapes
from ..limits import Limit, not_negative
from ..quantity import RATIO, Direction, Place, Units, Value
from .force import Action, ForceElement, Places, constant
from .relative_springs import SHAPES, SpringLaw, spring_lines, springs

STIFFNESSES = ("turn", "tilt", "axial", "radial")


@dataclass(frozen=True)
class FlexibleHinge(ForceElement):
    """A solid hinge that turns about an axis of its ends and gives a little elsewhere.

    A bushing of four stiffnesses: about the axis, across it, along it, and across it. The strain
    is that of :class:`Bushing`.

    Args:
        frame_a, frame_b: Frames or bodies at its ends; they coincide without load.
        axis: About which it turns, in axes of both frames.
        turn, tilt: Stiffness against rotation about the axis, and about all lines across it
            [N m/rad].
        axial, radial: Stiffness against displacement along the axis, and across it [N/m].
        damping: Stress of a rate of the strain is the stiffness times this time [s].

    Raises:
        ModelError: a stiffness or damping below 0, or what is not a finite number or expression.

    Source: Howell, Compliant Mechanisms (2001), chapter 5; Masarati and Morandini, Multibody System
        Dynamics 24 (2010).
    """

    kind: ClassVar[str] = "flexible_hinge"
    symbol_shapes: ClassVar[Shapes] = SHAPES
    units: ClassVar[Units] = {
        **{"axis": RATIO, "turn": "N*m/rad", "tilt": "N*m/rad", "axial": "N/m", "radial": "N/m"},
        "damping": "s",
    }
    frame_a: Place
    frame_b: Place
    axis: Direction
    turn: Value
    tilt: Value
    axial: Value
    radial: Value
    damping: Value = 0.0

    def limits(self) -> tuple[Limit, ...]:
        return not_negative(*STIFFNESSES, "damping")

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        return springs(at, self._law(at))

    def _law(self, at: Places) -> SpringLaw:
        stiffness = self._stiffness(at)
        damping = stiffness * at.data["damping"][0]
        fixed = constant(*(at.data[name] for name in (*STIFFNESSES, "axis")))
        return SpringLaw(stiffness, damping, Matrix.zeros(stiffness.graph, 6), fixed)

    def _stiffness(self, at: Places) -> Matrix:
        """k (6, 6): t n nᵀ + s (1 - n nᵀ) of rotations and of displacements."""
        graph, axis = at.motion.graph, at.data["axis"]
        along = axis / norm(*axis)
        line, none = along.outer(along), Matrix.zeros(graph, 3, 3)
        turn, tilt, axial, radial = (at.data[name][0] for name in STIFFNESSES)
        one = Matrix.identity(graph, 3)
        rotations = one * tilt + line * (turn - tilt)
        moves = one * radial + line * (axial - radial)
        return Matrix.vstack(Matrix.hstack(rotations, none), Matrix.hstack(none, moves))

    def formulas(self, at: Places) -> Lines:
        damped = not at.data["damping"].is_zero
        stiffness: Lines = (
            ("axis of the hinge", "n = unit(axis)"),
            (
                "stiffness: t about n and s_0 across it, a_0 along n and r_0 across it",
                "k = block(s_0 * I + (t - s_0) * n * n.T, O, O, r_0 * I + (a_0 - r_0) * n * n.T)",
            ),
        )
        stress = "k @ (y + eta * ydot)" if damped else "k @ y"
        return (*stiffness, *spring_lines(self._law(at), (stress,)))
