"""State of elements: internal states, modes, events, and constraints active in some modes."""

from __future__ import annotations

from typing import Protocol

from ..ir.arithmetic import Scalar
from ..ir.matrix import Matrix
from ..records import dataclass

# kinds of events: what happens when one does
MODE, IMPACT, TICK, END, MARK, HALT = "mode", "impact", "tick", "end", "mark", "halt"


@dataclass(frozen=True)
class Internal:
    """A continuous internal state, an entry of z.

    Attributes:
        name: Part of its name after that of the element; "" for the bare one.
        unit: Of its value.
        default: Value at the start of a run.
    """

    name: str
    unit: str = ""
    default: float = 0.0


@dataclass(frozen=True)
class Mode:
    """A discrete state, an entry of s: constant between events.

    Attributes:
        name: Part of its name after that of the element; "" for the bare one.
        default: Value at the start of a run.
        labels: What its values mean, by value; none for a sampled number.
    """

    name: str
    default: float = 0.0
    labels: tuple[tuple[int, str], ...] = ()


@dataclass(frozen=True)
class EventSpec:
    """Something that happens where its sign function falls through zero.

    Attributes:
        name: Part of its name after that of the element; "" for the bare one.
        kind: ``"mode"`` (a mode changes), ``"impact"`` (speeds jump), ``"tick"`` (at known
            times), ``"end"`` (the run is over, also if it starts with a negative value),
            ``"halt"`` (the run is over where the value falls) or ``"mark"`` (it is recorded).
        about: What happens, in words.
        period, phase: Of a tick: it happens at phase + k period [s].
        beyond: What a start with a negative value means, in words, where no run may begin so.
        decides: Value of its element's mode from which it is not an event but the first decision.
        unit: Of its sign function; ``"a|b"``: of joints that turn, and of those that slide; ""
            where it is the user's, or a number.
    """

    name: str
    kind: str
    about: str
    period: float = 0.0
    phase: float = 0.0
    beyond: str = ""
    decides: float | None = None
    unit: str = ""


@dataclass(frozen=True)
class ModeConstraint:
    """A velocity that is kept at 0 while a mode holds it.

    Attributes:
        velocity: Linear in the speeds.
        active: 1 where it is held, else 0.
    """

    velocity: Scalar
    active: Scalar


@dataclass(frozen=True)
class Impulse:
    """A jump of a velocity by an impulse along it.

    Attributes:
        velocity: Linear in the speeds.
        after: Its value behind the jump.
        active: 1 where the impulse acts, else 0.
        unilateral: It can only push the velocity up; where it would pull it is left out.
        release_speed: Below this speed a unilateral one holds the velocity back after all.
    """

    velocity: Scalar
    after: Scalar
    active: Scalar
    unilateral: bool = False
    release_speed: Scalar | None = None


@dataclass(frozen=True)
class Change:
    """New states of an element after an event.

    Attributes:
        z: New internal states, None where they stay.
        s: New modes, None where they stay.
    """

    z: Matrix | None = None
    s: Matrix | None = None


class Solved(Protocol):
    """The part of the solution of the equations of motion that an element may read.

    Attributes:
        multipliers: Multipliers of its holds (their number, 1): the forces along their velocities.
        certainty: Positive where the force that follows from the reaction of its joint is the
            only one possible; None where it has no such force.
    """

    multipliers: Matrix
    certainty: Scalar | None

    def derivative(self, x: Scalar) -> Scalar:
        """Time derivative of an expression along the motion."""


class Jumped(Protocol):
    """Data of an event that an element may read."""

    def fired(self, event: int) -> Scalar:
        """1 where this event of the element happened, else 0."""

    @property
    def before(self) -> Solved:
        """The solution of the equations of motion before the event."""

    def after(self, x: Scalar) -> Scalar:
        """Value of an expression with the speeds behind the event."""

    def response(self, velocity: Scalar) -> Scalar:
        """Acceleration of a velocity per force along it, loops and what others hold included."""
