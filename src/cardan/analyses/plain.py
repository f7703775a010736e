"""A run where there is no C compiler: the same loop, over SciPy's method of that name."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..errors import ModelError
from ..runtime.closing import Closing
from ..runtime.compiled import CompiledModel
from ..runtime.dense import Dense
from ..runtime.ledger import Ledger
from ..runtime.loaded import LoadedFunction
from ..runtime.slots import ORDER, SLOT
from . import record as abi
from .bounded import bounded
from .happenings import NOTHING, Happenings
from .jumps import FEW, FUNCTION, Segment, stops_of
from .plain_closing import PlainCloser
from .plain_events import PlainEvents
from .plain_methods import METHODS, Broken, Step
from .plain_passing import PlainPasser
from .plain_record import Progress
from .run import SLICE, Saved
from .settings import Settings
from .signals import Signals

Array = NDArray[np.float64]


def check_plain(settings: Settings) -> None:
    """Refuse what exists in C only.

    Raises:
        ModelError: the method does.
    """
    if settings.method.name not in METHODS:
        raise ModelError(
            f"method '{settings.method.name}' needs a C compiler: pip install "
            f"'cardan[compiler]'. Without one there are {', '.join(METHODS)}"
        )


class PlainRunner:
    """A run from a state over segments of time; used as :class:`.run.Runner` is."""

    def __init__(
        self,
        model: CompiledModel,
        settings: Settings,
        given: Signals,
        power: bool = True,
        may: Happenings = NOTHING,
    ) -> None:
        """Args: as of :class:`.run.Runner`.

        Raises:
            ModelError: the method exists in C only.
        """
        check_plain(settings)
        self.model, self.settings, self.signals, self.may = model, settings, given, may
        self.functions = [model._function("rhs"), *([model._function("power")] if power else [])]
        self.powered = power
        outputs = self.functions[-1].outputs if power else []
        self.sources: tuple[str, ...] = tuple(outputs[0]["entries"] or ()) if outputs else ()
        self.nx, self.n = model.nx, model.nx + len(self.sources)
        self.error: BaseException | None = None
        self.record = Progress(nr=model.nr, h=settings.step)
        self.views = {"y": np.zeros(self.n), "r": given.constants.copy()}
        self.views["s"] = model._layout.start("s")
        self._rest = np.zeros(max(model.nu, 6 * len(model.bodies)))
        self.quaternions = tuple(model.manifest["quaternions"])
        self.bounded = bounded(model.manifest)
        self.closer = PlainCloser(self)
        self.events = PlainEvents(self)
        self.happened = np.empty((0, 1 + len(may.rows) + 2 * (model.nx + model.ns)))
        self.passer = PlainPasser(self)
        self._kept: list[tuple[Array, Array]] = []
        self._times: Array | None = None
        self._where: dict[int, int] = {}
        self._span = Segment(FUNCTION in model.saved)

    # the derivative

    def derivative(self, t: float, y: Array) -> Array:
        """dy/dt (n,) at t, y.

        Raises:
            Broken: a function has no result.
        """
        self.at(t, y)
        self.record.evaluations += 1
        result = np.empty(self.n)
        self.call(self.functions[0], t, y, result[: self.nx])
        if self.sources:
            self.call(self.functions[1], t, y, result[self.nx :])
        return result

    def call(
        self, function: LoadedFunction, t: float, y: Array, out: Array, e: Array | None = None
    ) -> None:
        """Results of a function at t, y, and where it asks for them events that happen.

        Raises:
            Broken: it has none.
        """
        nq, caller = self.model.nq, function.caller
        speeds = nq + self.model.nu
        given = {
            "t": np.array([self._span.inside(t)]),
            "q": y[:nq],
            "u": y[nq:speeds],
            "z": y[speeds : self.nx],
        }
        given |= {"r": self.views["r"], "s": self.views["s"]}
        given |= {"tau": self._rest, "wrench": self._rest}
        if e is not None:
            given["e"] = e
        blocks: list[Array | None] = [given.get(name) for name in ORDER]
        blocks[SLOT["w"]] = function.w
        status, _ = caller.call(blocks, [0] * len(ORDER), out[None, :])
        if status:
            self.record.model_status = status
            raise Broken(abi.MODEL)

    def at(self, t: float, y: Array) -> None:
        """Fill the inputs at t, y."""
        self._inputs(t, y, self.signals.sample is None)

    def _inputs(self, t: float, y: Array, asked: bool) -> None:
        """Fill r at t: values at times, then functions of the user; constants stay."""
        r = self.views["r"]
        for k, piece in enumerate(self.signals.pieces):
            where = self._where[k]
            d, c = t - piece.breaks[where], piece.coefficients[where]
            r[piece.input] = ((c[3] * d + c[2]) * d + c[1]) * d + c[0]
        for k, function in self.signals.functions.items() if asked else ():
            r[k] = float(function(t, y[: self.nx].copy()))

    # running

    def start(self, t: float, x: Array, stops: Sequence[float]) -> int:
        """Set the state and evaluate there. Returns the answer the kernels would give."""
        self.record.t = self.record.t_start = t
        y = self.views["y"]
        y[: self.nx] = x
        self.normalize(y)
        self.aim(stops)
        if self._blamed(y):
            return abi.NOT_FINITE
        try:
            self._segment()
            self.closer.close(t, y, noted=True)
            if self._blamed(self.derivative(t, y)):
                return abi.NOT_FINITE
            self.events.start()
            self.jumped()
            if self.closing.rows:
                self.passer.hold.begin(self._until - t)
        except Broken as broken:
            return broken.answer
        self._next_time = 0
        if self._times is None:
            self._keep(t, y, self._flat)
        else:
            self._here()
        return abi.DONE

    @property
    def _flat(self) -> Array:
        """Dense output of no time."""
        return np.zeros((self.settings.method.dense_rows, self.n))

    def _here(self) -> None:
        """The row for the present time if it is wanted, and all that happens there has."""
        times = self._times
        if (
            times is None
            or self._next_time >= len(times)
            or times[self._next_time] != self.record.t
        ):
            return
        if not (self.events.happened or self.events.due()):
            self._keep(self.record.t, self.views["y"], self._flat)
            self._next_time += 1

    def aim(self, stops: Sequence[float]) -> None:
        """Set the times at which steps must end; the last one is the end."""
        self._stops, self._next, self.end = list(stops), 0, stops[-1]
        self._method: Iterator[Step] | None = None

    def want(self, times: Array | None, dense: bool) -> None:
        """Say which rows to write, as :meth:`.run.Runner.want`; dense output is always kept."""
        self._times, self._all = times, dense
        self._kept, self._next_time = [], 0

    def loosen(self, slack: float) -> None:
        """As :meth:`.run.Runner.loosen`."""
        self.closer.closing = self.closer.closing.loosened(slack)

    @property
    def closing(self) -> Closing:
        """The constraints."""
        return self.closer.closing

    @property
    def ledger(self) -> Ledger | None:
        """How well circuits stayed closed; None without constraints."""
        return self.closing.ledger(self.closer.numbers)

    @property
    def rows(self) -> Array:
        """Rows so far (count, 1 + n + nr)."""
        rows = [row for row, _ in self._kept]
        return (
            np.stack(rows) if rows else np.empty((0, 1 + self.n + self.record.nr + self.model.ns))
        )

    @property
    def spreads(self) -> Array:
        """Dense output so far (count, dense_rows, n)."""
        size = (0, self.settings.method.dense_rows, self.n)
        return np.stack([s for _, s in self._kept]) if self._kept else np.empty(size)

    def slices(self) -> Iterator[int]:
        """Run to the end; yields the answer about every 10 ms."""
        answer = abi.MORE
        while answer == abi.MORE:
            answer = self._drive(time.perf_counter() + SLICE)
            yield answer

    def advance(self, end: float) -> int:
        """Go on to a time, as :meth:`.run.Runner.advance`."""
        self.aim(stops_of(self.model, self.signals, self.record.t, end, FEW))
        self.record.t_start = self.record.t
        try:
            self._segment()
        except Broken as broken:
            return broken.answer
        answer = self._drive(math.inf)
        self.happened = self.drained()
        if answer == abi.STOPPED:
            raise KeyboardInterrupt
        return answer

    def _drive(self, deadline: float) -> int:
        """Step until the run is over or the time is up."""
        try:
            while time.perf_counter() < deadline:
                if self.events.happened:
                    self._happen()
                elif self.record.t != self._until:
                    self._step()
                elif self.events.tick():
                    continue
                elif self.record.t != self._stops[self._next]:
                    self.jumped()
                elif self._next + 1 == len(self._stops):
                    return abi.DONE
                else:
                    self._next += 1
                    self._segment()
        except Broken as broken:
            return broken.answer
        except KeyboardInterrupt:
            return abi.STOPPED
        return abi.MORE

    def _segment(self) -> None:
        """Begin the segment ahead of t: the pieces of its inputs, a method that starts there."""
        t, stop = self.record.t, self._stops[self._next]
        middle = 0.5 * (t + stop)
        for k, piece in enumerate(self.signals.pieces):
            where = int(np.searchsorted(piece.breaks, middle, side="right")) - 1
            self._where[k] = min(max(where, 0), len(piece.coefficients) - 1)
        self._inputs(t, self.views["y"], True)
        self.jumped()

    def jumped(self) -> None:
        """Start over at t, where something has changed."""
        self._method = None
        self.passer.cancel()
        self._until = self.events.until(self._stops[self._next])
        self._span = replace(self._span, start=self.record.t, end=self._until)

    def _happen(self) -> None:
        """What happens at t: transitions until nothing happens any more."""
        self.events.changed = over = False
        while self.events.happened and not over:
            over = self.events.apply()
        if self._times is None and self._all and self.events.changed:
            self._keep(self.record.t, self.views["y"], self._flat)
        self._here()
        if over:
            raise Broken(abi.EVENT)

    def drained(self) -> Array:
        """What has happened since the last call, as ``Happened.log``."""
        log, self.events.log = self.events.log, []
        return np.stack(log) if log else self.happened[:0]

    def _step(self) -> None:
        run, y = self.record, self.views["y"]
        before, old = run.t, y.copy()
        step = self.passer.next(self._until)
        if step is not None:
            self._method = None
        else:
            if self._method is None:
                self._method = METHODS[self.settings.method.name](self, self._until)
            step = next(self._method)
        if self._blamed(step.y):
            raise Broken(abi.NOT_FINITE)
        whole, step = step, self.events.seek(before, old, step)
        if step is not whole:
            self._method = None
            self.passer.cancel()
        run.t, y[:] = step.t, step.y
        run.steps += 1
        if self._times is not None:
            self._at_times(before, old, step)
        elif self._all:
            self._keep(step.t, y, step.spread())

    def _at_times(self, before: float, old: Array, step: Step) -> None:
        """Rows for the wanted times inside a step."""
        times, sign = self._times, 1.0 if step.t > before else -1.0
        assert times is not None
        first = self._next_time
        while self._next_time < len(times) and (times[self._next_time] - step.t) * sign < 0:
            self._next_time += 1
        inside = times[first : self._next_time]
        if len(inside):
            spread = step.spread()
            ends, values = np.array([before, step.t]), np.stack([old, step.y])
            for t, y in zip(
                inside, Dense(ends, values, spread[None], self.quaternions).at(inside), strict=True
            ):
                self.closer.between(float(t), y)
                self._keep(float(t), y, spread)
        self._here()

    def _keep(self, t: float, y: Array, spread: Array) -> None:
        self.at(t, y)
        self._kept.append((np.concatenate([[t], y, self.views["r"], self.views["s"]]), spread))
        self.record.count = len(self._kept)

    def normalize(self, y: Array) -> None:
        """Scale every quaternion to unit length."""
        for start in self.quaternions:
            y[start : start + 4] /= np.linalg.norm(y[start : start + 4])

    def _blamed(self, numbers: Array) -> bool:
        """Whether a number is not finite; the first one is to blame."""
        bad = np.flatnonzero(~np.isfinite(numbers))
        self.record.culprit = int(bad[0]) if len(bad) else -1
        return len(bad) > 0

    def check(self) -> None:
        """Nothing is left to raise: no C frames lie between the user's functions and us."""

    @contextmanager
    def interruptible(self) -> Iterator[None]:
        """Ctrl-C is heard everywhere here."""
        yield

    # checkpoints

    def save(self) -> Saved:
        """State, inputs and counters."""
        memory = np.concatenate(self._memory)
        return Saved(replace(self.record), memory.tobytes(), id(self))

    @property
    def _memory(self) -> list[Array]:
        """Everything that a checkpoint holds besides the record."""
        own = [self.views["y"], self.views["r"], self.views["s"], self.closer.numbers]
        return [*own, *self.passer.hold.memory, *self.events.memory]

    def restore(self, saved: Saved) -> None:
        """Go back to a checkpoint of this run.

        Raises:
            ModelError: it belongs to another one.
        """
        if saved.owner != id(self) or not isinstance(saved.record, Progress):
            raise ModelError("this checkpoint was made by another stepper")
        self.record = replace(saved.record)
        memory = np.frombuffer(saved.memory)
        start = 0
        for block in self._memory:
            block[:] = memory[start : start + len(block)]
            start += len(block)
