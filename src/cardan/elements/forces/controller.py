"""A controller with states of its own."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import ClassVar

from ...errors import ModelError, brief
from ...ir.arithmetic import Scalar, select
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...records import dataclass
from ..internal_states import TICK, Change, EventSpec, Internal, Jumped, Mode
from ..quantity import JointName, LocalNames, Quantity, Rows, Value
from ..validation import number, vector
from .force import Action, ForceElement, JointLoad, Places


@dataclass(frozen=True)
class Controller(ForceElement):
    """Feedback: a force on a joint from what is measured and from states of the controller.

    Continuous (``sample`` left out): d(states)/dt = changes, and the force follows at once,
    ``force = expression in states, coordinates, speeds, inputs, t``.
    Sampled: every ``sample`` seconds the force is computed, then the states become ``changes``;
    both are held in between, as a digital controller does. Without a joint the states alone are
    computed, for other elements and outputs as ``scene.state("name.state")``.

    Args:
        joint: Name of a joint with one speed; "" for none.
        states: SymPy symbols or names of the states of the controller.
        changes: As many expressions: derivatives of the states, or their next values if sampled.
        force: On the joint [N m] or [N]: expression in coordinates, speeds, inputs, t and the
            states, which stand in it as their symbols.
        start: Values of the states at the start; () for zeros.
        sample: Time between samples [s]; the first is at t = 0.

    Raises:
        ModelError: not as many changes or start values as states, a force without a joint or the
            other way round, neither states nor force, a sample time that is not positive.

    Source: K. J. Astrom, R. M. Murray, Feedback Systems, 2008, chapters 5 and 10.
    """

    kind: ClassVar[str] = "controller"
    joint: JointName = ""
    states: LocalNames = ()
    changes: Rows = ()
    force: Rows | None = None
    start: Rows = ()
    sample: Value | None = None

    def __post_init__(self) -> None:
        named = not isinstance(self.joint, str) or bool(self.joint)
        who = f"controller of joint {brief(self.joint)}" if named else "controller"
        states = self.states if isinstance(self.states, Sequence) else (self.states,)
        states = (states,) if isinstance(states, str) else states
        names = tuple(getattr(s, "name", s) for s in states)
        if not all(isinstance(name, str) and name for name in names) or len(set(names)) < len(
            names
        ):
            raise ModelError(
                f"{who}: states are {brief(self.states)}; give different symbols or names"
            )
        object.__setattr__(self, "states", names)
        object.__setattr__(self, "changes", vector(who, "changes", _several(self.changes)))
        start = vector(who, "start", _several(self.start)) or (0.0,) * len(names)
        object.__setattr__(self, "start", start)
        if not len(names) == len(self.changes) == len(start):
            raise ModelError(
                f"{who}: {len(names)} states, {len(self.changes)} changes, {len(start)} start "
                "values; give one of each for every state"
            )
        if self.force is not None:
            object.__setattr__(self, "force", number(who, "force", self.force))
        if (self.force is None) == named:
            raise ModelError(f"{who}: a force and the joint it acts on go together; give both")
        if self.force is None and not names:
            raise ModelError(f"{who}: give a force with its joint, or states, or both")
        if self.sample is not None:
            object.__setattr__(self, "sample", self._period(who))

    def _period(self, who: str) -> float:
        period = number(who, "sample", self.sample)
        if not isinstance(period, float) or not 0 < period < math.inf:
            raise ModelError(f"{who}: sample is {self.sample}; give a time of more than 0 [s]")
        return period

    @classmethod
    def pid(
        cls,
        joint: str,
        measured: Value,
        rate: Value = 0,
        target: Value = 0,
        kp: Value = 0,
        ki: Value = 0,
        kd: Value = 0,
        limit: Value | None = None,
        sample: float | None = None,
    ) -> Controller:
        """kp error + ki (its integral) - kd rate on a joint, error = target - measured.

        Args:
            joint: Name of the joint.
            measured: What is controlled, such as ``scene.q("elbow")``.
            rate: Its rate, such as ``scene.u("elbow")``.
            target: Wanted value.
            kp, ki, kd: Gains.
            limit: Largest force; where it is reached the integral waits. None: none.
            sample: Time between samples [s]; None: continuous.

        Raises:
            ModelError: kd without rate, a negative limit.

        Source: K. J. Astrom, R. M. Murray, Feedback Systems, 2008, chapter 10.
        """
        import sympy

        who = f"controller of joint '{joint}'"
        if kd != 0 and isinstance(rate, int | float) and rate == 0:
            raise ModelError(f"{who}: kd acts on rate; give it, such as rate=scene.u('{joint}')")
        if isinstance(limit, int | float) and limit < 0:
            raise ModelError(f"{who}: limit is {limit:g}; give 0 or more")
        error, integral = target - measured, sympy.Symbol("integral")
        force = kp * error + ki * integral - kd * rate
        grows = error
        if limit is not None:
            # beyond the limit the integral grows only where that leads back
            wound = sympy.Or(
                sympy.And(force > limit, error > 0), sympy.And(force < -limit, error < 0)
            )
            grows = sympy.Piecewise((0, wound), (error, True))
            force = sympy.Max(-limit, sympy.Min(limit, force))
        if ki == 0:
            return cls(joint, force=force.subs(integral, 0), sample=sample)
        change = grows if sample is None else integral + grows * sample
        return cls(joint, (integral,), (change,), force, sample=sample)

    @classmethod
    def state_space(
        cls,
        joint: str,
        A: Rows,
        B: Rows,
        C: Rows,
        D: Rows,
        measured: Sequence[Value],
        start: Sequence[Value] = (),
        sample: float | None = None,
    ) -> Controller:
        """x' = A x + B y, force = C x + D y, y being what is measured.

        Args:
            joint: Name of the joint; "" without a force (C and D are then not read).
            A: (n, n). B: (n, m). C: (n,). D: (m,).
            measured: y, m expressions such as ``scene.q("elbow")``.
            start: x at the start, (n,).
            sample: Time between samples [s]: x' is then the next x. None: its derivative.

        Raises:
            ModelError: shapes that do not fit.
        """
        import sympy

        n, m = len(A), len(measured)
        shapes = [len(row) == n for row in A] + [len(B) == n] + [len(row) == m for row in B]
        if joint:
            shapes += [len(C) == n, len(D) == m]
        if not all(shapes):
            raise ModelError(
                f"controller: A must be {n} x {n}, B {n} x {m}, C {n}, D {m}, as there are {n} "
                f"rows of A and {m} measured values"
            )
        x = [sympy.Symbol(f"x{k + 1}") for k in range(n)]

        def combined(first: Rows, second: Rows) -> sympy.Expr:
            terms = [*zip(first, x, strict=True), *zip(second, measured, strict=True)]
            return sympy.Add(*(a * b for a, b in terms))

        changes = tuple(combined(a, b) for a, b in zip(A, B, strict=True))
        force = combined(C, D) if joint else None
        return cls(joint, tuple(x), changes, force, tuple(start), sample)

    def quantities(self) -> dict[str, Quantity]:
        quantities = {}
        if self.states:
            quantities["changes"] = Quantity(self.changes, labels=self.states, local=self.states)
        if self.force is not None:
            quantities["force"] = Quantity(self.force, "", local=self.states)
        return quantities

    def joints(self) -> dict[str, str]:
        return {"joint": self.joint} if self.joint else {}

    def _local_states(self, at: Places) -> Matrix:
        """Its states, wherever they are kept."""
        return at.z if self.sample is None else at.s.block(slice(0, len(self.states)))

    def _of(self, at: Places, name: str) -> Matrix:
        """A quantity at the present states."""
        graph, written = at.motion.graph, at.data[name]
        values = zip(self.states, self._local_states(at).nodes, strict=True)
        local = {graph.atom(state): node for state, node in values}
        return Matrix(graph, len(written), 1, rebuild(graph, written.nodes, local, into=graph)[1])

    def act(self, at: Places) -> tuple[Action, ...]:
        if self.force is None:
            return ()
        sampled_force = at.s.block(slice(len(self.states), len(at.s)))
        force = self._of(at, "force") if self.sample is None else sampled_force
        return (Action(joint_loads=(JointLoad(at.joints["joint"], force),)),)

    # states

    def internals(self) -> tuple[Internal, ...]:
        if self.sample is not None:
            return ()
        return tuple(Internal(n, "", v) for n, v in zip(self.states, self.start, strict=True))

    def rates(self, at: Places) -> Matrix:
        return self._of(at, "changes")

    def modes(self) -> tuple[Mode, ...]:
        if self.sample is None:
            return ()
        state_modes = tuple(Mode(n, v) for n, v in zip(self.states, self.start, strict=True))
        return state_modes if self.force is None else (*state_modes, Mode("force"))

    def events(self) -> tuple[EventSpec, ...]:
        if self.sample is None:
            return ()
        return (EventSpec("sample", TICK, "it samples", period=self.sample),)

    def signs(self, at: Places, solved: object) -> tuple[Scalar, ...]:
        return tuple(at.motion.time * 0 + 1 for _ in self.events())

    def change(self, at: Places, jumped: Jumped) -> Change:
        if self.sample is None:
            return Change()
        behind = list(self._of(at, "changes")) if self.states else []
        if self.force is not None:
            behind.append(self._of(at, "force")[0])
        pairs = zip(behind, at.s, strict=True)
        new = [select(jumped.fired(0), value, before) for value, before in pairs]
        return Change(s=Matrix.vector(at.motion.graph, new))


def _several(value: object) -> Rows:
    """Values in order, where a single one may be written bare."""
    return value if isinstance(value, Sequence) or hasattr(value, "tolist") else (value,)
