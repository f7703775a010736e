"""Events of a run: those of the model, and those that the caller watches for."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, brief, named, near
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ...schema.entries import EventRow, TickRow
from . import run_record as abi
from .signals import checked

Value = Callable[[float, Array], float]
KINDS = {"mode": abi.MODE, "impact": abi.IMPACT, "tick": abi.TICK}
KINDS |= {"end": abi.END, "halt": abi.HALT, "mark": abi.MARK}
# a start so little beyond a stop is at it
LIMIT_TOL = 1e-9
ACTIONS = {"end": abi.HALT, "mark": abi.MARK}
# the value falls, it rises, both
DIRECTIONS = {"down": (1.0,), "up": (-1.0,), "both": (1.0, -1.0)}


@dataclass(frozen=True)
class Watch:
    """A value that the caller watches.

    Attributes:
        name: Of its events.
        value: f(t, x).
        kind: ``"end"``: the run is over where it passes zero; ``"mark"``: that is noted.
        direction: Which way it passes: ``"down"``, ``"up"`` or ``"both"``.
    """

    name: str
    value: Value
    kind: str
    direction: str


@dataclass(frozen=True)
class Crossing:
    """Distance of an entry of the state above a value."""

    entry: int
    value: float

    def __call__(self, t: float, x: Array) -> float:
        """The difference."""
        return float(x[self.entry]) - self.value


@dataclass(frozen=True)
class EventTable:
    """Everything that may happen in a run.

    Attributes:
        rows: name, element and kind of every event: those of the model, then those watched; some
            with ``decides``, see :class:`.Happened`.
        kinds: The same as numbers of the kernels (ne,).
        model: How many of them are the model's.
        ticks: Rows event, period, phase of the manifest.
        watches: What the caller watches.
    """

    rows: tuple[dict[str, Any], ...]
    kinds: tuple[int, ...]
    model: int
    ticks: tuple[TickRow, ...]
    watches: tuple[Watch, ...]

    @property
    def changing(self) -> tuple[str, ...]:
        """Names of the events that change something, which no run can go back over."""
        pairs = zip(self.rows, self.kinds, strict=True)
        return tuple(row["name"] for row, kind in pairs if kind <= abi.TICK)

    @property
    def descriptions(self) -> list[Any]:
        """Descriptions of the events, the same in every process."""
        return [self.rows, [(w.name, w.kind, w.direction) for w in self.watches]]

    @property
    def functions(self) -> tuple[str, ...]:
        """Functions of the model that are called for them."""
        return ("events", "transition") if self.model else ()

    @property
    def watched(self) -> int:
        """Number of values that the caller watches; one that passes both ways counts twice."""
        return len(self.rows) - self.model

    def watch(self, t: float, x: Array) -> list[float]:
        """Values (watched,) of what the caller watches."""
        values: list[float] = []
        for watch in self.watches:
            value = float(watch.value(t, x))
            values += [sign * value for sign in DIRECTIONS[watch.direction]]
        return values

    def distinguish_ticks(self, farthest: float) -> None:
        """Refuse events so frequent that their times are not different numbers.

        Args:
            farthest: The largest size that time has in the run [s].

        Raises:
            ModelError: such an event.
        """
        for tick in self.ticks:
            resolved = 4 * sys.float_info.epsilon * max(farthest, abs(tick.phase))
            if tick.period < resolved:
                raise ModelError(
                    f"'{self.rows[tick.event]['name']}' happens every {tick.period:g} s; in "
                    f"a run to {farthest:g} s such times cannot be told from each other. Give it a "
                    f"period above {resolved:.2g} s"
                )

    def forward(self, start: float, end: float) -> None:
        """Refuse to go backward over what changes something.

        Raises:
            ModelError: the run goes backward and the model has such events.
        """
        if end < start and self.changing:
            raise ModelError(
                f"t=({start:g}, {end:g}): '{self.changing[0]}' changes the state where it happens, "
                "which cannot be undone: runs of this model go forward only"
            )


def check_start(model: LoadedModel, x: Array, t: float, r: Array) -> None:
    """Check that a run may begin at a state.

    Raises:
        ModelError: it lies where it could not have come to, such as behind a stop.
    """
    rows = model.manifest.events
    if not any(row.beyond for row in rows):
        return
    q, u, z = model.parts_of(x)
    values = model.events(q, u, z=z, t=t, r=r)
    for row, value in zip(rows, values.tolist(), strict=True):
        if row.beyond and value < -LIMIT_TOL:
            raise ModelError(
                f"{row.beyond} ('{row.element}'), by {-value:.6g}: start within its range"
            )


NOTHING = EventTable((), (), 0, (), ())


def event_table_of(model: LoadedModel, events: Mapping[str, object] | None) -> EventTable:
    """Table of the events of a run of a model.

    Args:
        model: Its events come first.
        events: Name -> what to watch: ``f(t, x)`` or ``("elbow", value)``; alone the run is over
            where it passes zero, or the value; with more as a tuple
            ``(what, "end" or "mark", "down", "up" or "both")``.

    Raises:
        ModelError: an unknown name, kind or direction. ArgumentError: nothing to watch.
        SolveError: a value that is not finite.
    """
    rows = [_row(model, row) for row in model.manifest.events]
    kinds = [KINDS[row["kind"]] for row in rows]
    count = len(rows)
    taken = [row["name"] for row in rows]
    watched = named("events", events, "'up': ('elbow', 0.5)")
    watches = [_watch(model, name, what) for name, what in watched.items()]
    for watch in watches:
        if watch.name in taken:
            raise ModelError(f"events: the model has an event '{watch.name}': name yours otherwise")
        for _ in DIRECTIONS[watch.direction]:
            rows.append({"name": watch.name, "element": "", "kind": watch.kind})
            kinds.append(ACTIONS[watch.kind])
    ticks = tuple(model.manifest.ticks)
    for tick in ticks:
        if not (math.isfinite(tick.period) and tick.period > 0):
            name = rows[tick.event]["name"]
            raise ModelError(f"'{name}' has a period of {tick.period:g} s: it must be positive")
    return EventTable(tuple(rows), tuple(kinds), count, ticks, tuple(watches))


def _row(model: LoadedModel, stated: EventRow) -> dict[str, Any]:
    """An event of the model, as runs keep it."""
    row: dict[str, Any] = {"name": stated.name, "element": stated.element, "kind": stated.kind}
    for mode, value in stated.decides.items():
        # counted from the end, as the length of what lies before the modes differs
        row["decides"] = [model.mode_names.index(mode) - model.ns, value]
    return row


def _watch(model: LoadedModel, name: str, spec: object) -> Watch:
    """One entry of ``events=``."""
    what: Any = spec
    options: tuple[Any, ...] = ()
    if isinstance(spec, tuple | list) and spec and not _is_crossing(spec):
        what, options = spec[0], tuple(spec[1:])
    kind, direction = "end", "both"
    for word in options:
        if word in ACTIONS:
            kind = word
        elif word in DIRECTIONS:
            direction = word
        else:
            choices = [*ACTIONS, *DIRECTIONS]
            hint = near(word, choices)
            raise ModelError(
                f"events: '{name}': {brief(word)} is none of {', '.join(choices)}.{hint}"
            )
    return Watch(name, _value(model, name, what), kind, direction)


def _is_crossing(spec: Sequence[object]) -> bool:
    return (
        len(spec) == 2 and isinstance(spec[0], str) and isinstance(spec[1], int | float | np.number)
    )


def _value(model: LoadedModel, name: str, what: object) -> Value:
    """f(t, x) of a function, or of a coordinate and the value it passes."""
    if callable(what):
        return checked(f"events: the function of '{name}'", what)
    if isinstance(what, tuple | list) and _is_crossing(what):
        entry, value = str(what[0]), float(what[1])
        names = (*model.coordinates, *model.speeds, *model.internals)
        if entry not in names:
            raise ModelError(
                f"events: '{name}': there is no coordinate, speed or internal state '{entry}'."
                f"{near(entry, names)}"
            )
        if not math.isfinite(value):
            raise SolveError(f"events: '{name}': '{entry}' cannot pass {value}")
        k = names.index(entry)
        return Crossing(k, value)
    raise ArgumentError(
        f"events: '{name}' is {brief(what)}; give f(t, x), or a name and the value it "
        "passes such as "
        "('elbow', 0.5)"
    )
