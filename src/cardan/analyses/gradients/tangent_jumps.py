"""What events do to changes of a motion: the formulas of ``jumps``, the other way round."""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...schema.blocks import Blocks
from ..simulation import run_record as abi
from ..simulation.events import EventTable
from .jumps import EventInstant, check_touch, event_names, root_of, slope_of_watched
from .tangent import Tangents


class TangentJumps:
    """Changes behind events from those before them."""

    def __init__(self, tangents: Tangents, events: EventTable, start: float) -> None:
        """Args:
        tangents: Whose changes.
        events: What may happen.
        start: When the run began [s].
        """
        self.tangents, self.events, self.start = tangents, events, start
        self.model = tangents.model

    def push(self, at: EventInstant, x: Array) -> Array:
        """Changes of the state (k, nx) behind what happened; those of modes change too.

        Args:
            at: What happened.
            x: Changes before it, at its time.

        Raises:
            SolveError: two events at one time that are not one, or one that happens by a touch.
        """
        x, delay = self.arrive(at, x)
        inputs = self.tangents.inputs_at(at.t)[0]
        # what is behind begins later: changes are told at the time that stays
        behind = np.asarray(self.model.rhs(at.t, at.x_after, inputs, s=at.s_after))
        return np.asarray(x - np.outer(delay, behind))

    def arrive(self, at: EventInstant, x: Array) -> tuple[Array, Array]:
        """Changes (k, nx) behind what happened at its own time, and by how much later it is (k,).

        Args:
            at: What happened; events that change nothing may be in it.
            x: Changes before it, at its time.

        Raises:
            SolveError: as :meth:`push`.
        """
        tangents, model = self.tangents, self.model
        inputs, rates = tangents.inputs_at(at.t)
        by_r = tangents.input_changes(at.t)
        root = root_of(at, self.events, self.start)
        delay = np.zeros(len(x))
        if root is not None:
            before = np.asarray(model.rhs(at.t, at.x[0], inputs, s=at.s[0]))
            delay = self._delay(at, root, x, by_r, before, inputs, rates)
            x = x + np.outer(delay, before)
        by_r = by_r + np.outer(delay, rates)
        # several at one time follow from each other, the first one decides about the time
        for k in range(len(at.fired)):
            if self._changing(at.fired[k]):
                x = self._transition(at, k, x, delay, by_r, inputs)
        return x, delay

    def _changing(self, fired: Array) -> bool:
        """True if any of some events changes the state."""
        return any(self.events.kinds[k] <= abi.TICK for k in np.flatnonzero(fired))

    def _delay(
        self,
        at: EventInstant,
        root: int,
        x: Array,
        by_r: Array,
        before: Array,
        inputs: Array,
        rates: Array,
    ) -> Array:
        """By how much later an event happens (k,)."""
        tangents, model, none = self.tangents, self.model, np.zeros(len(x))
        if root >= self.events.model:
            slope = slope_of_watched(self.events, root, model.nx)
            return -(x @ slope) / check_touch(at, event_names(self.events)[root], slope, before, 0)
        q, u, z = model.parts_of(at.x[0])
        values = {"t": at.t, "q": q, "u": u, "z": z, "s": at.s[0], "r": inputs}
        changes = tangents.along("events", values, none, x, tangents.by_s, by_r)[:, root]
        # along the motion itself
        one = np.ones(len(x))
        moving = tangents.along(
            "events", values, one, np.tile(before, (len(x), 1)), 0 * tangents.by_s,
            np.tile(rates, (len(x), 1)),
        )[:, root]  # fmt: skip
        # parameters change in both: their share is no rate
        fixed = tangents.along(
            "events", values, none, 0 * x, 0 * tangents.by_s, 0 * by_r
        )[:, root]  # fmt: skip
        rate = float((moving - fixed)[0]) if len(x) else 1.0
        weights = np.zeros(len(model.manifest.events))
        weights[root] = 1.0
        slope = np.concatenate(
            model.vjp("events", wrt=self._blocks())(q, u, weights, z=z, s=at.s[0], t=at.t, r=inputs)
        )
        name = event_names(self.events)[root]
        check_touch(at, name, slope, before, rate - float(slope @ before[: len(slope)]))
        return -changes / rate

    def _blocks(self) -> Blocks:
        return Blocks(name for name in self.tangents.sizes() if name not in ("s", "r"))

    def _transition(
        self, at: EventInstant, k: int, x: Array, delay: Array, by_r: Array, inputs: Array
    ) -> Array:
        """Changes behind events k."""
        tangents, model = self.tangents, self.model
        nq, nu = model.nq, model.nu
        last = k + 1 == len(at.fired)
        q, u, z = model.parts_of(at.x[k])
        fired = at.fired[k][: len(model.manifest.events)].astype(float)
        values = {"t": at.t, "q": q, "u": u, "z": z, "s": at.s[k], "r": inputs, "e": fired}
        result = tangents.along("transition", values, delay, x, tangents.by_s, by_r)
        x = np.hstack([x[:, :nq], result[:, : nu + model.nz]])
        tangents.by_s[:] = result[:, nu + model.nz :]
        if "close_velocity" in tangents.runner.closing.functions:
            x_after = at.x_after if last else at.x[k + 1]
            q, u, z = model.parts_of(x_after)
            s_after = at.s_after if last else at.s[k + 1]
            values = {"t": at.t, "q": q, "u": u, "z": z, "s": s_after, "r": inputs}
            closed = tangents.along("close_velocity", values, delay, x, tangents.by_s, by_r)
            x[:, nq : nq + nu] = closed[:, :nu]
        return x
