"""Dry and viscous friction along a joint."""

from __future__ import annotations

from typing import ClassVar

from ...errors import ModelError, brief
from ...ir.arithmetic import Scalar, select
from ...ir.matrix import Matrix
from ...records import dataclass
from ..internal_states import END, MODE, Change, EventSpec, Jumped, Mode, ModeConstraint, Solved
from ..limits import Limit, not_negative, positive
from ..quantity import JointName, Quantity, Units, Value, quantities_of
from .force import Action, ForceElement, JointLoad, Places, one_coordinate

UNDECIDED, FORWARD, BACKWARD, STICKING = 0, 1, -1, 2
# of the speed behind an impact against that before it: what counts as a jump, or as rest
SPEED_TOL = 1e-12
# what must be left of the uniqueness of a friction force: it grows with the inverse of that
CERTAIN = 1e-3


@dataclass(frozen=True)
class Friction(ForceElement):
    """Coulomb friction along a joint, with true sticking: while it sticks the joint is held.

    Sliding at the speed v against the surface, the joint feels
    ``force = -sign(v) (coulomb + (static - coulomb) exp(-(v/stribeck)^2)) - viscous v``. At v = 0
    it sticks for as long as that takes no more than ``static``. Beginning and end of sticking are
    events.
    With ``smooth`` there are none: sign(v) becomes tanh(v/smooth), and nothing ever sticks.

    Args:
        joint: Name of a joint with one speed.
        coulomb: Of sliding [N m] or [N]: number, parameter or expression, such as mu times a
            normal force.
        static: The most that sticking bears [N m] or [N]; None: as much as ``coulomb``. With
            ``mu`` the coefficient of sticking.
        stribeck: Speed over which static falls to sliding friction [rad/s] or [m/s]; None: it
            falls at once.
        viscous: [N m s/rad] or [N s/m].
        against: Speed of the surface, such as that of a belt [rad/s] or [m/s].
        smooth: Speed over which sign(v) is smoothed [rad/s] or [m/s]; None: events.
        mu: In place of ``coulomb``: coefficient of friction of sliding. The normal force is that of
            the reaction of the joint across its axis, which friction changes in turn: both are
            solved for together. Where they have no unique solution the run ends.
        radius: Of the bearing of a joint that turns [m]: arm of the friction of ``mu``.

    Raises:
        ModelError: a value that is not a number or expression; a negative force or speed; stribeck
            without static; both or neither of coulomb and mu.

    Source: B. Armstrong-Helouvry, P. Dupont, C. Canudas de Wit, Automatica 30 (1994) 1083 (Stribeck
        curve); F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapter
        5 (sticking as a constraint).
    """

    kind: ClassVar[str] = "friction"
    _one_coordinate: ClassVar[bool] = True
    units: ClassVar[Units] = {
        **{"coulomb": "N*m|N", "mu": "", "radius": "m", "stribeck": "rad/s|m/s"},
        **{"smooth": "rad/s|m/s", "static": "N*m|N", "viscous": "N*m*s/rad|N*s/m"},
        "against": "rad/s|m/s",
    }
    joint: JointName
    coulomb: Value | None = None
    static: Value | None = None
    stribeck: Value | None = None
    viscous: Value = 0.0
    against: Value = 0.0
    smooth: Value | None = None
    mu: Value | None = None
    radius: Value | None = None

    def __post_init__(self) -> None:
        who = self.title
        super().__post_init__()
        if self.stribeck is not None and self.static is None:
            raise ModelError(f"{who}: stribeck is the speed over which static falls; give static")
        if (self.coulomb is None) == (self.mu is None):
            raise ModelError(f"{who}: give either coulomb, a force, or mu, a coefficient")
        if self.radius is not None and self.mu is None:
            raise ModelError(f"{who}: radius goes with mu; coulomb is the torque itself")
        if self.mu == 0:
            raise ModelError(f"{who}: mu is 0; leave the friction out")

    @property
    def title(self) -> str:
        return f"friction on joint {brief(self.joint)}"

    def limits(self) -> tuple[Limit, ...]:
        less = "static is {value}, less than the {other} of sliding; give as much or more"
        return (
            *not_negative("coulomb", "static", "viscous", "mu", "radius"),
            *positive("stribeck", "smooth"),
            Limit("static", less, other="coulomb" if self.mu is None else "mu"),
        )

    @property
    def _sticks(self) -> bool:
        return self.smooth is None

    def quantities(self) -> dict[str, Quantity]:
        # with mu, static is a coefficient too
        return quantities_of(self, {**self.units, **({} if self.mu is None else {"static": ""})})

    def linear(self) -> tuple[str, ...]:
        return ("coulomb", "static", "viscous")

    # sliding

    def _speed(self, at: Places) -> Scalar:
        """Speed of the joint relative to the surface."""
        who = f"friction on joint '{self.joint}'"
        return one_coordinate(at.motion, at.joints["joint"], who)[1] - at.data["against"][0]

    def _coulomb(self, at: Places) -> Scalar:
        """Friction of fast sliding."""
        return at.data["coulomb"][0] if at.reaction_force is None else at.reaction_force

    def _most(self, at: Places) -> Scalar:
        """The most that sticking bears."""
        coulomb = self._coulomb(at)
        if "static" not in at.data:
            return coulomb
        static = at.data["static"][0]
        return static if at.reaction_force is None else coulomb * (static / at.data["mu"][0])

    def misfit(self, sliding: bool) -> str:
        if self.mu is None or sliding or self.radius is not None:
            return ""
        return (
            f"joint '{self.joint}' turns, and mu times a force is not a torque; give radius=, "
            "that of the bearing [m]"
        )

    @property
    def by_reaction(self) -> bool:
        return self.mu is not None

    def reaction_force(self, at: Places) -> Scalar:
        arm = at.data["radius"][0] if "radius" in at.data else 1
        return at.data["mu"][0] * arm

    def _sliding(self, at: Places) -> Scalar:
        """Size of the dry friction of sliding."""
        coulomb = self._coulomb(at)
        if "stribeck" not in at.data:
            return coulomb
        ratio = self._speed(at) / at.data["stribeck"][0]
        return coulomb + (self._most(at) - coulomb) * (-(ratio * ratio)).apply("exp")

    def _direction(self, at: Places) -> Scalar:
        """Sign of the sliding speed; 0 where it sticks."""
        v = self._speed(at)
        if not self._sticks:
            return (v / at.data["smooth"][0]).apply("tanh")
        mode = at.s[0]
        sign = select((v * 0).apply("lt", v), 1, select(v.apply("lt", 0.0), -1, 0))
        sliding = select(mode.apply("eq", float(STICKING)), 0, mode)
        return select(mode.apply("eq", float(UNDECIDED)), sign, sliding).note("direction")

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        drag = self._sliding(at) * self._direction(at) + at.data["viscous"][0] * self._speed(at)
        force = Matrix.vector(at.motion.graph, [-drag])
        return (Action(joint_loads=(JointLoad(at.joints["joint"], force),)),)

    # sticking

    def modes(self) -> tuple[Mode, ...]:
        labels = (
            (UNDECIDED, "undecided"),
            (FORWARD, "sliding forward"),
            (BACKWARD, "sliding backward"),
            (STICKING, "sticking"),
        )
        return (Mode("", UNDECIDED, labels),) if self._sticks else ()

    def events(self) -> tuple[EventSpec, ...]:
        if not self._sticks:
            return self._jams()
        return (
            EventSpec("stop", MODE, "sliding comes to rest", decides=UNDECIDED, unit="rad/s|m/s"),
            EventSpec("slip", MODE, "sticking gives way", unit="N*m|N"),
            *self._jams(),
        )

    def _jams(self) -> tuple[EventSpec, ...]:
        about = "it jams: friction has no unique solution there (Painleve)"
        return (EventSpec("jam", END, about),) if self.by_reaction else ()

    def locked_velocities(self) -> tuple[tuple[str, str], ...]:
        return (("stick", "rad/s|m/s"),) if self._sticks else ()

    def holds(self, at: Places) -> tuple[ModeConstraint, ...]:
        active = select(at.s[0].apply("eq", float(STICKING)), 1, 0)
        return (ModeConstraint(self._speed(at), active),)

    def signs(self, at: Places, solved: Solved) -> tuple[Scalar, ...]:
        jams = () if solved.certainty is None else (solved.certainty - CERTAIN,)
        if not self._sticks:
            return jams
        mode, v = at.s[0], self._speed(at)
        sliding = select(mode.apply("eq", float(UNDECIDED)), -1, mode * v)
        left = self._most(at) - solved.multipliers[0].apply("abs")
        sticking = mode.apply("eq", float(STICKING))
        return select(sticking, 1, sliding), select(sticking, left, 1), *jams

    def change(self, at: Places, jumped: Jumped) -> Change:
        if not self._sticks:
            return Change()
        mode, v = at.s[0], self._speed(at)
        behind = jumped.after(v)
        along = select((behind * 0).apply("lt", behind), FORWARD, BACKWARD).note("along")
        # coming to rest: it sticks where friction can take all of what accelerates it
        response = jumped.response(v).note("response")
        rate = jumped.before.derivative(v) + response * self._sliding(at) * self._direction(at)
        rate.note("rate")
        bears = (rate.apply("abs") - response * self._most(at)).apply("le", 0.0)
        direction_after = select((rate * 0).apply("lt", rate), FORWARD, BACKWARD)
        # or found sliding at the start
        moves = (v * 0).apply("lt", v.apply("abs")).apply("and", mode.apply("eq", float(UNDECIDED)))
        stopped = select(moves, along, select(bears, STICKING, direction_after)).note("stopped")
        # sticking gives way to what pushes against it
        pushed = select(jumped.before.multipliers[0].apply("lt", 0.0), FORWARD, BACKWARD)
        changed = select(jumped.fired(0), stopped, select(jumped.fired(1), pushed, mode))
        changed.note("unless_struck")
        # impacts, elsewhere too, tear it loose, turn it round or bring it to rest
        struck = (SPEED_TOL * (1 + behind.apply("abs"))).apply("lt", (behind - v).apply("abs"))
        at_standstill = behind.apply("abs").apply("le", SPEED_TOL * (1 + v.apply("abs")))
        decided = mode.apply("eq", float(UNDECIDED)).apply("not")
        changed = select(
            struck.apply("and", decided), select(at_standstill, STICKING, along), changed
        )
        return Change(s=Matrix.vector(at.motion.graph, [changed]))
