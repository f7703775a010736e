"""A straight piece of a cable or a bar between two points: a cable does not push."""

from __future__ import annotations

from typing import ClassVar

from ...ir.arithmetic import Scalar, norm, select
from ...records import dataclass
from ..formulas import Lines
from ..limits import Limit, not_negative, positive
from ..quantity import Place, Units, Value
from .force import LINE, Action, ForceElement, Places, constant, potential
from .line import PULL, RATE, SPAN, along_line, direction

# of its numbers
LIMITS = (*positive("EA", "length"), *not_negative("damping"))


@dataclass(frozen=True)
class Cable(ForceElement):
    """A straight elastic cable without mass between the origins of two frames.

    ``tension = EA (strain + damping d(strain)/dt)`` where it is taut, strain = distance / length -
    1 above 0; a slack cable has none, and damping never pushes. A bar has all of it, whatever the
    signs. ``scene.cable`` makes cables and bars with mass of such pieces.

    Args:
        frame_a, frame_b: Frames or bodies at its ends.
        EA: Stiffness of the section [N].
        length: Without load [m].
        damping: Tension of a rate of the strain is EA times this time [s].
        compression: True for a bar, which pushes too.

    Raises:
        ModelError: EA or length not above 0, damping below 0, or what is not a finite number or
            expression.

    Source: Irvine, Cable Structures (1981), chapter 1; Géradin and Cardona, Flexible Multibody
        Dynamics (2001), section 5.2.
    """

    kind: ClassVar[str] = "cable"
    units: ClassVar[Units] = {"EA": "N", "length": "m", "damping": "s"}
    frame_a: Place
    frame_b: Place
    EA: Value
    length: Value
    damping: Value = 0.0
    compression: bool = False

    def limits(self) -> tuple[Limit, ...]:
        return LIMITS

    def acts_on(self) -> tuple[str, str]:
        return LINE, "a"

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        motion, a, b = at.motion, at.frames["a"], at.frames["b"]
        stiffness, length, damping = (at.data[name][0] for name in self.units)
        span = motion.position(b) - motion.position(a)
        distance = norm(*span)
        along = direction(span, distance)
        strain = distance / length - 1.0
        strain = strain if self.compression else strain.apply("max", 0.0)
        elastic = stiffness * strain
        energy = elastic * strain * length * 0.5
        actions = [along_line(motion, a, b, along * elastic, *self._potential(at, energy))]
        if not at.data["damping"].is_zero:
            rate = along.dot(motion.velocity(b) - motion.velocity(a)) / length
            viscous = stiffness * damping * rate
            loss = viscous if self.compression else _loss(elastic, viscous)
            actions.append(along_line(motion, a, b, along * loss, None))
        return tuple(actions)

    def formulas(self, at: Places) -> Lines:
        damped = not at.data["damping"].is_zero
        strain = ("strain of a taut cable, a slack one has none", "gamma = max(ell / L - 1, 0)")
        tension = "EA * (gamma + eta * elldot / L)" if damped else "EA * gamma"
        pull = ("tension, eta the damping" if damped else "tension", f"f = {tension}")
        if self.compression:
            strain = ("strain", "gamma = ell / L - 1")
        elif damped:
            pull = (
                "tension of a taut cable, eta the damping; a slack one has none",
                f"f = max({tension}, 0)",
            )
        energy: Lines = (("potential energy", "V = EA * L * gamma ** 2 / 2"),)
        return (*SPAN, *(RATE,) * damped, strain, pull, *PULL, *energy * self._stores(at))

    def _stores(self, at: Places) -> bool:
        return constant(at.data["EA"], at.data["length"])

    def _potential(self, at: Places, energy: Scalar) -> tuple[Scalar | None, bool]:
        return potential(energy, at.data["EA"], at.data["length"])


def _loss(elastic: Scalar, viscous: Scalar) -> Scalar:
    """Viscous part of the tension: none of a slack cable, and never more than lets it go slack."""
    taut = (elastic * 0).apply("lt", elastic)
    return select(taut, viscous.apply("max", -elastic), 0.0)
