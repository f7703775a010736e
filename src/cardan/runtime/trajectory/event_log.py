"""Events of a run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import cached_property
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...records import dataclass


@final
@dataclass(frozen=True, eq=False)
class Event:
    """Something that happened.

    Attributes:
        t: When [s].
        name: Of the event.
        element: To which element; "" for what the caller watched.
        kind: ``"mode"``, ``"impact"``, ``"tick"``, ``"end"``, ``"halt"`` or ``"mark"``.
        x, s: State [q, u, z] (nx,) and discrete states (ns,) before it.
        x_after, s_after: The same behind it, and behind what happened at the same time.
    """

    t: float
    name: str
    element: str
    kind: str
    x: Array
    s: Array
    x_after: Array
    s_after: Array

    def __repr__(self) -> str:
        return f"{self.name} ({self.kind}) at {self.t:.10g} s"


@dataclass(frozen=True, eq=False)
class EventLog:
    """Everything that happened in a run, and the discrete states along it.

    Attributes:
        s: Discrete states (nt, ns).
        rows: name, element and kind of every event that could happen; with ``decides``, the place
            of a mode, counted from the end, and the value from which it is not an event but the
            first
            decision about that mode.
        log: When what happened, and [x, s] before and behind it (count, 1 + ne + 2 (nx + ns)).
    """

    s: Array = field(default_factory=lambda: np.zeros((0, 0)))
    rows: tuple[Mapping[str, Any], ...] = ()
    log: Array = field(default_factory=lambda: np.zeros((0, 1)))

    @property
    def times(self) -> Array:
        """When something happened (count,) [s]."""
        return self.log[:, 0]

    def states(self, nx: int) -> tuple[Array, Array]:
        """States x (count, nx) before what happened, and behind it."""
        start = 1 + len(self.rows)
        half = (self.log.shape[1] - start) // 2
        return self.log[:, start : start + nx], self.log[:, start + half : start + half + nx]

    @cached_property
    def _fired(self) -> NDArray[np.bool_]:
        """Mask of the events (count, ne)."""
        fired: NDArray[np.bool_] = self.log[:, 1 : 1 + len(self.rows)] != 0
        return fired

    @cached_property
    def _samples(self) -> NDArray[np.bool_]:
        """Samples among it (count, ne)."""
        ticks = np.array([row["kind"] == "tick" for row in self.rows], dtype=bool)
        samples: NDArray[np.bool_] = self._fired & ticks
        return samples

    @cached_property
    def _reported(self) -> NDArray[np.bool_]:
        """Events among it (count, ne): neither samples nor first decisions."""
        start = 1 + len(self.rows)
        before = self.log[:, : start + (self.log.shape[1] - start) // 2]
        reported = self._fired & ~self._samples
        for k, row in enumerate(self.rows):
            if "decides" in row:
                mode, value = row["decides"]
                reported[:, k] &= before[:, int(mode)] != value
        return reported

    @property
    def counts(self) -> dict[str, int]:
        """Number of events, and of samples."""
        if not len(self.log):
            return {"events": 0, "ticks": 0}
        return {"events": int(self._reported.sum()), "ticks": int(self._samples.sum())}

    @property
    def quiet(self) -> Array:
        """Times at which there was no event, but samples or first decisions."""
        loud = self._reported.any(axis=1)
        return np.setdiff1d(self.times[~loud], self.times[loud])

    def events(self, nx: int, ticks: bool = False) -> tuple[Event, ...]:
        """One record per event, or per sample, in the order of time."""
        start, events = 1 + len(self.rows), []
        half = (self.log.shape[1] - start) // 2
        for line, fired in zip(self.log, self._samples if ticks else self._reported, strict=True):
            before, after = line[start : start + half], line[start + half :]
            states = (before[:nx], before[nx:], after[:nx], after[nx:])
            for k in np.flatnonzero(fired):
                row = self.rows[k]
                labels = str(row["name"]), str(row["element"]), str(row["kind"])
                events.append(Event(float(line[0]), *labels, *states))
        return tuple(events)

    def modes(self, t: Array, times: Array) -> Array:
        """Discrete states (m, ns) at times (m,) of a run with rows at t (nt,): behind events."""
        if not self.s.size:
            return np.zeros((len(times), 0))
        sign = 1.0 if t[-1] >= t[0] else -1.0
        rows = np.searchsorted(sign * t, sign * times, side="right") - 1
        modes: Array = self.s[np.clip(rows, 0, len(t) - 1)]
        return modes


def one_line(events: Sequence[Event], most: int = 4) -> str:
    """When one event happened, in words: the first few times and how many more."""
    times = [f"{event.t:.6g}" for event in events[:most]]
    more = f" ... {events[-1].t:.6g}" if len(events) > most else ""
    return f"{', '.join(times)}{more} s"
