"""A spring and damper between two points."""

from __future__ import annotations

from typing import ClassVar

from ...ir.arithmetic import norm
from ...records import dataclass
from ..formulas import Lines
from ..quantity import Place, Units, Value
from .force import Action, ForceElement, Places, constant, potential
from .line import PULL, RATE, SPAN, along_line, direction


@dataclass(frozen=True)
class SpringDamper(ForceElement):
    """A straight spring with a damper in parallel between the origins of two frames.

    Along the line ``force = stiffness (distance - rest_length) + damping d(distance)/dt`` pulls the
    frames together where it is positive. Where the points meet, the force has no direction and is
    zero, unless the rest length is zero: then the spring is smooth there. A run that starts there
    with a force warns.

    Args:
        frame_a, frame_b: Frames or bodies at its ends.
        stiffness: [N/m].
        damping: [N s/m].
        rest_length: Length without load [m].

    Raises:
        ModelError: a value that is not a finite number or expression.

    Source: R. E. Roberson and R. Schwertassek, Dynamics of Multibody Systems, 1988, section 12.1.
    """

    kind: ClassVar[str] = "spring_damper"
    units: ClassVar[Units] = {"stiffness": "N/m", "damping": "N*s/m", "rest_length": "m"}
    frame_a: Place
    frame_b: Place
    stiffness: Value = 0.0
    damping: Value = 0.0
    rest_length: Value = 0.0

    def linear(self) -> tuple[str, ...]:
        return ("stiffness", "damping")

    def straight(self) -> bool:
        return True

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        motion, data, frames = at.motion, at.data, at.frames
        a, b = frames["a"], frames["b"]
        span = motion.position(b) - motion.position(a)
        stiffness, damping, free = (data[n][0] for n in ("stiffness", "damping", "rest_length"))
        actions = []
        if not data["stiffness"].is_zero:
            if data["rest_length"].is_zero:
                pull, energy = span * stiffness, span.dot(span) * stiffness * 0.5
            else:
                distance = norm(*span)
                stretch = distance - free
                pull = direction(span, distance) * (stiffness * stretch)
                energy = stiffness * stretch**2 * 0.5
            stored = potential(energy, data["stiffness"], data["rest_length"])
            actions.append(along_line(motion, a, b, pull, *stored))
        if not data["damping"].is_zero:
            along = direction(span, norm(*span))
            rate = along.dot(motion.velocity(b) - motion.velocity(a))
            actions.append(along_line(motion, a, b, along * (damping * rate), None))
        return tuple(actions)

    def formulas(self, at: Places) -> Lines:
        spring, damper = (not at.data[name].is_zero for name in ("stiffness", "damping"))
        stretch = "ell" if at.data["rest_length"].is_zero else "(ell - ell_0)"
        terms = [f"k * {stretch}"] * spring + ["c * elldot"] * damper
        if not terms:
            return ()
        about = "force, k the stiffness" * spring + ", " * (spring and damper)
        about = (about or "force, ") + "c the damping" * damper
        pull = (about + ", ell_0 the free length" * (stretch != "ell"), f"f = {' + '.join(terms)}")
        fixed = constant(at.data["stiffness"], at.data["rest_length"])
        energy: Lines = (("potential energy", f"V = k * {stretch} ** 2 / 2"),)
        return (*SPAN, *(RATE,) * damper, pull, *PULL, *energy * (spring and fixed))
