"""Rigid stops of a joint."""

from __future__ import annotations

from typing import ClassVar

from ...errors import ModelError
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

LOWER, FREE, UPPER = -1, 0, 1
# speeds behind an impact that count as none, absolute and relative
NONE = 1e-12


@dataclass(frozen=True)
class Stop(ForceElement):
    """Rigid ends of the range of a joint: it bounces off them, or comes to lie against them.

    An impact turns the speed v of approach into -restitution v; below the speed ``settle`` into 0,
    and the joint then stays at the stop for as long as something presses it there. Impulses go
    through the whole system, closed loops included.

    Args:
        joint: Name of a joint with one speed.
        lower, upper: Ends of the range [rad] or [m]; None: no stop on that side.
        restitution: 0 (no bounce) to 1 (no loss).
        settle: Speed below which it no longer bounces, nor is torn off by impacts elsewhere
            [rad/s] or [m/s]; 0: it bounces for ever.

    Raises:
        ModelError: no stop at all, lower above upper, restitution outside 0 ... 1, a negative
            speed, or a value that is not a number or expression.

    Source: F. Pfeiffer and Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapter
        8.
    """

    kind: ClassVar[str] = "stop"
    _one_coordinate: ClassVar[bool] = True
    units: ClassVar[Units] = {
        **{"lower": "rad|m", "upper": "rad|m", "restitution": "", "settle": "rad/s|m/s"}
    }
    joint: JointName
    lower: Value | None = None
    upper: Value | None = None
    restitution: Value = 0.0
    settle: Value = 1e-4

    def __post_init__(self) -> None:
        if self.lower is None and self.upper is None:
            raise ModelError(f"{self.title}: give lower or upper, or both")
        super().__post_init__()

    def limits(self) -> tuple[Limit, ...]:
        ends = "lower={other} must be below upper={value}"
        return (
            Limit("upper", ends, open=True, other="lower"),
            Limit("restitution", "restitution is {value}; give 0 ... 1", 0.0, 1.0),
            *not_negative("settle", requirement="a speed of 0 or more"),
        )

    @property
    def _sides(self) -> tuple[tuple[str, int], ...]:
        """The stops there are: the name of its quantity, and the mode of lying against it."""
        ends = (("lower", LOWER), ("upper", UPPER))
        return tuple((name, side) for name, side in ends if getattr(self, name) is not None)

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        return ()

    def modes(self) -> tuple[Mode, ...]:
        labels = ((LOWER, "at the lower stop"), (FREE, "free"), (UPPER, "at the upper stop"))
        return (Mode("", FREE, labels),)

    def events(self) -> tuple[EventSpec, ...]:
        hits = (
            EventSpec(
                name,
                IMPACT,
                f"it hits the {name} stop",
                beyond=f"joint '{self.joint}' starts beyond its {name} stop",
                unit="rad|m",
            )
            for name, _ in self._sides
        )
        return (*hits, EventSpec("release", MODE, "it leaves the stop", unit="N*m|N"))

    def locked_velocities(self) -> tuple[tuple[str, str], ...]:
        return (("stop", "rad/s|m/s"),)

    def holds(self, at: Places) -> tuple[ModeConstraint, ...]:
        free = at.s[0].apply("eq", float(FREE))
        return (ModeConstraint(self._of_joint(at)[1], select(free, 0, 1)),)

    def signs(self, at: Places, solved: Solved) -> tuple[Scalar, ...]:
        free, q = at.s[0].apply("eq", float(FREE)), self._of_joint(at)[0]
        gaps = (select(free, (at.data[name][0] - q) * side, 1) for name, side in self._sides)
        contact_force = -(at.s[0] * solved.multipliers[0])
        return (*gaps, select(free, 1, contact_force))

    def impulses(self, at: Places, jumped: Jumped) -> tuple[Impulse, ...]:
        v, settle, impulses = self._of_joint(at)[1], at.data["settle"][0], []
        for event, (name, side) in enumerate(self._sides):
            # away from the stop
            leaving = v * -side
            bounce = -(leaving * at.data["restitution"][0])
            after = select((-leaving).apply("le", settle), 0, bounce)
            after = select(leaving.apply("lt", 0.0), after, leaving)
            lying = at.s[0].apply("eq", float(side))
            active = select(lying, 1, jumped.fired(event))
            after = select(lying, 0, after).note(f"{name}_after")
            impulses.append(Impulse(leaving, after, active, unilateral=True, release_speed=settle))
        return tuple(impulses)

    def change(self, at: Places, jumped: Jumped) -> Change:
        v, mode = self._of_joint(at)[1], at.s[0]
        behind = jumped.after(v)
        none = (behind.apply("abs") - v.apply("abs") * NONE).apply("le", NONE).note("at_rest")
        # what lies there is torn off by impacts elsewhere only
        changed = select(mode.apply("eq", float(FREE)), FREE, select(none, mode, FREE))
        for event, (_, side) in enumerate(self._sides):
            changed = select(jumped.fired(event), select(none, side, FREE), changed)
        changed = select(jumped.fired(len(self._sides)), FREE, changed)
        return Change(s=Matrix.vector(at.motion.graph, [changed]))

    def _of_joint(self, at: Places) -> tuple[Scalar, Scalar]:
        return one_coordinate(at.motion, at.joints["joint"], f"stop of joint '{self.joint}'")
