"""A mechanism that locks a joint."""

from __future__ import annotations

from typing import ClassVar

from ...ir.arithmetic import Scalar, select
from ...ir.matrix import Matrix
from ...records import dataclass
from ..internal_states import (
    IMPACT,
    MODE,
    Change,
    EventSpec,
    Impulse,
    Jumped,
    Mode,
    ModeConstraint,
    Solved,
)
from ..limits import Limit, not_negative
from ..quantity import JointName, Units, Value
from .force import Action, ForceElement, Places, one_coordinate

OPEN, LOCKED = 0, 1


@dataclass(frozen=True)
class Lock(ForceElement):
    """A latch that catches a joint: from then on it is held, until it is released or gives way.

    Locking takes the speed by an impulse that goes through the whole system: momentum that the
    joint does not bear is kept.

    Args:
        joint: Name of a joint with one speed.
        when: It locks where this expression falls through 0, such as ``1.57 - scene.q("hinge")``.
        release: It opens where this falls through 0; None: it does not.
        strength: The most it bears [N m] or [N]; None: anything.
        locked: Whether it is locked at the start.

    Raises:
        ModelError: a value that is not a number or expression, or a negative strength.

    Source: R. E. Roberson and R. Schwertassek, Dynamics of Multibody Systems, 1988, section 5.3
        (constraints that are added); F. Pfeiffer, Ch. Glocker, chapter 8 (impulses).
    """

    kind: ClassVar[str] = "lock"
    _one_coordinate: ClassVar[bool] = True
    units: ClassVar[Units] = {"when": "", "release": "", "strength": "N*m|N"}
    joint: JointName
    when: Value
    release: Value | None = None
    strength: Value | None = None
    locked: bool = False

    def limits(self) -> tuple[Limit, ...]:
        return not_negative("strength")

    @property
    def _opens(self) -> tuple[tuple[str, str], ...]:
        """EventSpec that opens the lock: its name and that of its quantity."""
        ways = (("release", "release"), ("break", "strength"))
        return tuple((event, name) for event, name in ways if getattr(self, name) is not None)

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        return ()

    def modes(self) -> tuple[Mode, ...]:
        start = LOCKED if self.locked else OPEN
        return (Mode("", start, ((OPEN, "open"), (LOCKED, "locked"))),)

    def events(self) -> tuple[EventSpec, ...]:
        about = {"release": "it is released", "break": "it gives way"}
        units = {"release": "", "break": "N*m|N"}
        opening = (EventSpec(e, MODE, about[e], unit=units[e]) for e, _ in self._opens)
        return (EventSpec("lock", IMPACT, "it locks"), *opening)

    def locked_velocities(self) -> tuple[tuple[str, str], ...]:
        return (("lock", "rad/s|m/s"),)

    def holds(self, at: Places) -> tuple[ModeConstraint, ...]:
        return (ModeConstraint(self._speed(at), select(self._locked(at), 1, 0)),)

    def signs(self, at: Places, solved: Solved) -> tuple[Scalar, ...]:
        locked = self._locked(at)
        left = {"release": at.data.get("release"), "break": at.data.get("strength")}
        signs = [select(locked, 1, at.data["when"][0])]
        for event, _ in self._opens:
            value = left[event]
            assert value is not None
            load = solved.multipliers[0].apply("abs") if event == "break" else 0
            signs.append(select(locked, value[0] - load, 1))
        return tuple(signs)

    def impulses(self, at: Places, jumped: Jumped) -> tuple[Impulse, ...]:
        speed = self._speed(at)
        return (Impulse(speed, speed * 0, select(self._locked(at), 1, jumped.fired(0))),)

    def change(self, at: Places, jumped: Jumped) -> Change:
        changed = select(jumped.fired(0), LOCKED, at.s[0])
        for event in range(1, 1 + len(self._opens)):
            changed = select(jumped.fired(event), OPEN, changed)
        return Change(s=Matrix.vector(at.motion.graph, [changed]))

    def _locked(self, at: Places) -> Scalar:
        return at.s[0].apply("eq", float(LOCKED))

    def _speed(self, at: Places) -> Scalar:
        return one_coordinate(at.motion, at.joints["joint"], f"lock of joint '{self.joint}'")[1]
