"""What events do to gradients: jumps of the state at times that move along (saltation).

Where an event happens at tau with g(tau, x, p) = 0 and the state jumps to R(tau, x, p), changes of
the state before it, dx, and behind it, dx+, obey

    dx+ = R_x dx + R_p dp + (R_x f + R_t - f+) dtau,   dtau = -(g_x dx + g_p dp) / (g_x f + g_t)

with the rates f before it and f+ behind it. Gradients go through the transposed of this.

Source: P. C. Müller, Chaos, Solitons & Fractals 5 (1995) 1671-1681.
"""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import SolveError
from ...records import dataclass
from ...schema.cost import Cost
from ...schema.request import reads
from ..simulation import run_record as abi
from ..simulation.events import DIRECTIONS, Crossing, EventTable
from .adjoint import Slopes, Sweep

# growth of a change in an event, beyond which it happens by a touch
GRAZING = 1e7


@dataclass(frozen=True)
class EventInstant:
    """What happened at one time.

    Attributes:
        t: When [s].
        fired: Masks of the events, one after the other (k, ne).
        x, s: States (k, nx) and modes (k, ns) before each of them.
        x_after, s_after: State (nx,) and modes (ns,) behind all of them.
    """

    t: float
    fired: Array
    x: Array
    s: Array
    x_after: Array
    s_after: Array


def event_instants(log: Array, events: EventTable, nx: int, ns: int) -> list[EventInstant]:
    """What changed a run, in its order; marks change nothing.

    Args:
        log: Rows of the log: t, mask, [x, s] before and behind.
        events: What may happen.
        nx, ns: Sizes of x and s.
    """
    if not len(log):
        return []
    ne = len(events.rows)
    kinds = np.array(events.kinds, dtype=int)
    changing = (log[:, 1 : 1 + ne] != 0) & (kinds != abi.MARK)
    rows = log[changing.any(axis=1)]
    masks = changing[changing.any(axis=1)]
    first, result = 1 + ne, []
    ends = [*(np.flatnonzero(np.diff(rows[:, 0])) + 1), len(rows)] if len(rows) else []
    start = 0
    for end in ends:
        part = rows[start:end]
        behind = part[-1, first + nx + ns :]
        result.append(
            EventInstant(
                float(part[0, 0]),
                masks[start:end],
                part[:, first : first + nx],
                part[:, first + nx : first + nx + ns],
                behind[:nx],
                behind[nx:],
            )
        )
        start = end
    return result


def event_names(events: EventTable) -> list[str]:
    """Names of all events."""
    return [str(row["name"]) for row in events.rows]


def root_of(at: EventInstant, events: EventTable, start: float) -> int | None:
    """The event whose value decided when it happened; None where the time was given.

    Raises:
        SolveError: there are two.
    """
    if at.t == start:
        return None
    fired = np.flatnonzero(at.fired[0])
    roots = [int(k) for k in fired if events.kinds[k] != abi.TICK]
    if len(roots) > 1 or (roots and len(roots) < len(fired)):
        names = " and ".join(f"'{event_names(events)[int(k)]}'" for k in fired)
        raise SolveError(
            f"gradient: {names} happen at the same time, t = {at.t:.9g} s: which comes first is "
            "not decided, and there is no derivative. Change the start or the parameters a little"
        )
    return roots[0] if roots else None


def slope_of_watched(events: EventTable, root: int, nx: int) -> Array:
    """Derivative (nx,) of a value that the caller watches.

    Raises:
        SolveError: it is a function, whose derivative nobody knows.
    """
    signs = [(w, sign) for w in events.watches for sign in DIRECTIONS[w.direction]]
    watch, sign = signs[root - events.model]
    value = watch.value
    if not isinstance(value, Crossing):
        raise SolveError(
            f"gradient: the run ends by '{watch.name}', a function whose derivative is not known. "
            "Watch an entry of the state, such as ('elbow', 0.5), or end at a time"
        )
    slope = np.zeros(nx)
    slope[value.entry] = sign
    return slope


def check_touch(at: EventInstant, name: str, slope: Array, before: Array, other: float) -> float:
    """Rate of the value of an event when it happens.

    Args:
        at: What happened.
        name: Of the event.
        slope: Derivative of its value by the state (nx,).
        before: Rates of the state (nx,).
        other: Rate of the value besides, as time and inputs change it.

    Raises:
        SolveError: it happens by a touch.
    """
    rate = float(slope @ before) + other
    size = float(np.linalg.norm(slope) * np.linalg.norm(before))
    if rate == 0 or not size <= GRAZING * abs(rate):
        raise SolveError(
            f"gradient: '{name}' happens at t = {at.t:.9g} s by a touch: its value changes by "
            f"{rate:.1e} per second only, and its time has no derivative there. Change the start "
            "or the parameters a little"
        )
    return rate


class Jumps:
    """Gradients by states before events from those by states behind them."""

    def __init__(self, sweep: Sweep, cost: Cost, events: EventTable, start: float) -> None:
        """Args:
        sweep: Whose gradients change.
        cost: Whose gradients they are.
        events: What may happen.
        start: When the run began [s]: what happens there happens at that time.
        """
        self.sweep, self.cost, self.events, self.start = sweep, cost, events, start
        self.model = sweep.model

    def pull(self, at: EventInstant, final_rate: float | None = None) -> None:
        """Change the gradients of the sweep into those before what happened.

        Args:
            at: What happened.
            final_rate: Derivative of the final cost by the time, where the run ends here; None
                where it goes on.

        Raises:
            SolveError: two events at one time that are not one, or one that happens by a touch.
        """
        lam, ended = self.sweep.lam, final_rate is not None
        self.sweep.arrived()
        root = root_of(at, self.events, self.start)
        inputs, rates = self._inputs(at.t)
        by_time = final_rate or 0.0
        if not ended:
            # what is behind begins later
            behind = self._rates(at.t, at.x_after, at.s_after, inputs)
            by_time -= float(behind @ lam) + self._integrand(at.t, at.x_after, at.s_after, inputs)
        for k in range(len(at.fired) - 1, -1, -1):
            if not ended or any(kind <= abi.TICK for kind in self._kinds(at.fired[k])):
                by_time += self._pull_transition(at, k, inputs, rates)
        if root is None:
            return
        # the state before it moves on while the event is late, and costs grow by that
        before = self._rates(at.t, at.x[0], at.s[0], inputs)
        by_time += float(before @ lam) + self._integrand(at.t, at.x[0], at.s[0], inputs)
        self._pull_time(at, root, by_time, before, inputs, rates)

    def _pull_time(
        self,
        at: EventInstant,
        root: int,
        by_time: float,
        before: Array,
        inputs: Array,
        rates: Array,
    ) -> None:
        """Gradients through the time of an event, which its value decides."""
        slopes = self._slopes(at, root, inputs)
        besides = slopes.by_t + float(slopes.by_r @ rates)
        rate = check_touch(at, event_names(self.events)[root], slopes.by_x, before, besides)
        self._add(at.t, slopes, -by_time / rate)

    def _pull_transition(self, at: EventInstant, k: int, inputs: Array, rates: Array) -> float:
        """Gradients through the change of the state by events k; returns that by the time."""
        model, sweep = self.model, self.sweep
        nq, nu = model.nq, model.nu
        last = k + 1 == len(at.fired)
        x_after = at.x_after if last else at.x[k + 1]
        s_after = at.s_after if last else at.s[k + 1]
        by_time = 0.0
        if "close_velocity" in sweep.runner.closing.functions:
            # speeds behind the impact are brought onto the constraints of the new modes
            rows = np.zeros(sweep.runner.closing.rates)
            weights = np.concatenate([sweep.lam[nq : nq + nu], rows])
            sweep.lam[nq : nq + nu] = 0.0
            slopes = self._product("close_velocity", weights, at.t, x_after, s_after, inputs)
            self._add(at.t, slopes)
            by_time += slopes.by_t + float(slopes.by_r @ rates)
        # coordinates stay: speeds, internal states and modes are what a transition gives
        weights = np.concatenate([sweep.lam[nq:], sweep.by_s])
        sweep.lam[nq:] = sweep.by_s[:] = 0.0
        fired = at.fired[k][: len(model.manifest.events)].astype(float)
        slopes = self._product("transition", weights, at.t, at.x[k], at.s[k], inputs, fired)
        self._add(at.t, slopes)
        return by_time + slopes.by_t + float(slopes.by_r @ rates)

    def _slopes(self, at: EventInstant, root: int, inputs: Array) -> Slopes:
        """Derivatives of the value of an event."""
        if root >= self.events.model:
            by_x, model = slope_of_watched(self.events, root, self.model.nx), self.model
            nothing = np.zeros(model.ns), np.zeros(model.nr), np.zeros(len(self.sweep.by_p))
            return Slopes(0.0, by_x, *nothing)
        weights = np.zeros(len(self.model.manifest.events))
        weights[root] = 1.0
        return self._product("events", weights, at.t, at.x[0], at.s[0], inputs)

    # calls

    def _product(
        self,
        name: str,
        weights: Array,
        t: float,
        x: Array,
        s: Array,
        inputs: Array,
        fired: Array | None = None,
    ) -> Slopes:
        """Weights times the derivative of a function."""
        model = self.model
        request = self.sweep.request(name, time=True)
        q, u, z = model.parts_of(x)
        values = {"t": t, "q": q, "u": u, "z": z, "s": s, "r": inputs, "e": fired, "v": weights}
        listed = tuple(values[one] for one in reads("vjp", request))
        return Slopes.of(model, model._evaluate(("vjp", request), listed, None, None))

    def _add(self, t: float, slopes: Slopes, share: float = 1.0) -> None:
        """Add a product to the gradients."""
        self.sweep.lam += share * slopes.by_x
        self.sweep.by_s += share * slopes.by_s
        self.sweep.by_p += share * slopes.by_p
        self.sweep.add_inputs(t, share * slopes.by_r)

    def _inputs(self, t: float) -> tuple[Array, Array]:
        """Inputs and their rates (nr,) at a time, as they are before it."""
        return self.sweep.inputs_at(t)

    def _rates(self, t: float, x: Array, s: Array, inputs: Array) -> Array:
        return np.asarray(self.model.rhs(t, x, inputs, s=s))

    def _integrand(self, t: float, x: Array, s: Array, inputs: Array) -> float:
        """The running cost at a state."""
        if self.cost.running is None:
            return 0.0
        q, u, z = self.model.parts_of(x)
        function = self.model._function("expression", self.cost.running)
        return float(function.caller(None, t, q, u, inputs, z, s))

    def _rows(self, what: str) -> int:
        return int(getattr(self.sweep.runner.closing, what))

    def _kinds(self, mask: Array) -> list[int]:
        return [self.events.kinds[k] for k in np.flatnonzero(mask)]
