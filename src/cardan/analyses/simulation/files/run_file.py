"""Runs of ``simulate`` in a file that only grows: the same call goes on from there, to the bit.

Every record holds the rows since the last one, and the record and memory of the run behind them.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from ....errors import ModelError, brief
from ....number_file import packed, plain, unpacked
from ....runtime.models.loaded_model import LoadedModel
from ....schema.integrators import INTEGRATORS
from ....version import RUN_FILE
from .. import run_record as abi
from ..events import EventTable
from ..recorder import Recorder
from ..run import Runner
from ..settings import Settings, Start
from ..signals import Signals
from ..times import Span
from .append_log import AppendLog, build_key, digest, model_key, text
from .saved_record import checked, impossible, record_of, saved_of, sound, ticks_of

# of the record, beside what steppers keep: where it is among its stops and output times
PLACES = ("next_stop", "next_time")
PARTS = ("head", "memory", "rows", "spreads", "log")
HEAD = {"record", "ticks", "where", "answer", "method", "reason", *PLACES}
CURES = {
    "model": "it was computed with another model",
    "build": "it was computed with another compiler, processor or version of the integrators",
    "start": "it starts elsewhere or has other inputs",
    "settings": "it has another time, method, tolerance or other events",
}
OVER = (abi.DONE, abi.EVENT)


class RunFile:
    """The file of one run.

    Attributes:
        method, reason: The integrator that ``method="auto"`` has taken, and why; "" if the file is
            new.
    """

    def __init__(self, path: Path, every: float, whose: dict[str, str]) -> None:
        """Open or begin a file.

        Args:
            path: The file.
            every: Time between two records [s] of computing.
            whose: Hashes of model, build, start and settings.

        Raises:
            ModelError: it belongs to another run or another process, or is no such file.
        """
        self.path, self.every = path, every
        self._file = AppendLog(path, RUN_FILE, whose, CURES)
        try:
            self._records = [_parts(content, path) for content in self._file.contents()]
        except BaseException:
            self.close()
            raise
        self._clock = time.monotonic()
        self.method = self.reason = ""
        if self._records:
            head = self._records[-1]["head"]
            self.method, self.reason = head["method"], head["reason"]

    def close(self) -> None:
        """Let others have the file."""
        self._file.close()

    def begin(self) -> None:
        """Throw away what is there: the run begins anew by another method."""
        self._file.begin()
        self._records, self.method, self.reason = [], "", ""

    def go_on(self, runner: Runner, recorder: Recorder) -> int | None:
        """Bring a run to where the file ends. Returns the answer there; None for a new file."""
        if not self._records:
            return None
        for one in self._records:
            recorder.rows.append(self._like(one["rows"], runner.rows))
            recorder.spreads.append(self._like(one["spreads"], runner.spreads))
            recorder.logs.append(self._like(one["log"], runner.log))
            if not all(np.isfinite(one[part]).all() for part in ("rows", "log")):
                raise impossible(self.path, "its rows or events are not finite")
            if not len(one["rows"]) >= len(one["spreads"]):
                raise impossible(self.path, "it has more dense output than rows")
        recorder.fresh()
        last, run = self._records[-1], runner.record
        head = last["head"]
        saved = saved_of(
            runner, head["record"], last["memory"], head["ticks"], self.path, self._file.writer
        )
        self._check(head, runner)
        # the stops are those of this run again, of which some lie behind it
        stops = run.stops, run.stop_count
        runner.restore(saved)
        sound(runner, self.path)
        run.stops, run.stop_count = stops
        run.next_stop, run.next_time = (head[name] for name in PLACES)
        self._ahead(runner)
        # what the start has written is in the file
        run.count = 0
        runner.drained()
        for row, where in zip(runner.tabulated, head["where"], strict=True):
            row.where = where
        self._records = []
        return int(head["answer"])

    def _like(self, array: Any, room: Any) -> Any:
        """Rows of the length that the rows of the run have."""
        if array.dtype != room.dtype or array.shape[1:] != room.shape[1:] or not array.ndim:
            raise impossible(self.path, "its rows are not those of this run")
        return array

    def _check(self, head: dict[str, Any], runner: Runner) -> None:
        """Places among stops, output times and pieces of inputs, which the kernels go on from."""
        run, where = runner.record, head["where"]
        if not isinstance(where, list) or len(where) != len(runner.tabulated):
            raise impossible(self.path, "its inputs are not those of this run")
        numbers = {name: head[name] for name in (*PLACES, "answer")}
        last = {"next_stop": run.stop_count - 1, "next_time": run.time_count, "answer": abi.EVENT}
        checked(numbers, {name: (0, most) for name, most in last.items()}, self.path)
        if head["answer"] not in (abi.MORE, *OVER):
            raise impossible(self.path, f"its answer is {head['answer']}")
        for k, (segment, row) in enumerate(zip(where, runner.tabulated, strict=True)):
            checked({f"where {k}": segment}, {f"where {k}": (0, row.pieces - 1)}, self.path)

    def _ahead(self, runner: Runner) -> None:
        """The next stop and where steps must end lie where the run has not been yet."""
        run, stops = runner.record, runner.stops
        way = 1.0 if stops[-1] >= run.t_start else -1.0
        if way * run.t > way * stops[run.next_stop]:
            raise impossible(self.path, "its next stop lies behind it")
        ticks = list(runner.ticks)[: run.tick_count]
        ends = {stops[run.next_stop], min([stops[run.next_stop], *(row.next for row in ticks)])}
        # a sample that has come, and has not changed anything yet, is still where steps end
        if run.event_pending and any(runner.views["e"][row.event] for row in ticks):
            ends.add(run.t)
        if run.until not in ends:
            raise impossible(self.path, f"its steps end at {run.until:g} s")
        if way * run.segment > way * run.t or run.h * way < 0:
            raise impossible(self.path, "its steps lead back")

    def note(self, runner: Runner, recorder: Recorder, answer: int) -> None:
        """Write what is new, if it is time to or the run is over.

        Raises:
            SolveError: there is no room for it.
        """
        over = answer in (*OVER, abi.STOPPED)
        if not over and (answer < 0 or time.monotonic() - self._clock < self.every):
            return
        recorder.take()
        run, saved = runner.record, runner.save()
        head = {
            "record": record_of(runner),
            "ticks": ticks_of(runner),
            **{name: getattr(run, name) for name in PLACES},
            "where": [row.where for row in runner.tabulated],
            "answer": answer if answer in OVER else abi.MORE,
            "method": runner.settings.method.name,
            "reason": runner.settings.reason,
        }
        rows, spreads, log = recorder.fresh()
        self._file.add(
            packed(
                {
                    "head": text(head),
                    "memory": np.frombuffer(saved.memory),
                    "rows": rows,
                    "spreads": spreads,
                    "log": log,
                }
            )
        )
        self._clock = time.monotonic()


def _parts(content: bytes, path: Path) -> dict[str, Any]:
    """The parts of a record, each of its type.

    Raises:
        ModelError: they are not those of a record.
    """
    try:
        parts = {name: array for name, array in unpacked(content).items() if name in PARTS}
        head = plain(parts["head"].tobytes())
    except (ValueError, KeyError) as error:
        raise impossible(path, f"a record cannot be read: {error}") from error
    if len(parts) < len(PARTS) or not isinstance(head, dict) or not set(head) >= HEAD:
        raise impossible(path, "a record is not whole")
    if head["method"] not in [*INTEGRATORS] or not isinstance(head["reason"], str):
        raise impossible(path, "a record has no method")
    return {**parts, "head": head}


@contextmanager
def run_file(
    path: object,
    every: float,
    model: LoadedModel,
    how: Settings,
    input_signals: Signals,
    event_table: EventTable,
    over: Span,
    begin: Start,
) -> Iterator[RunFile | None]:
    """The file of a run, closed at the end; None without a path.

    Raises:
        ModelError: no path or time, no compiler, or a file of something else.
    """
    if path is None:
        yield None
        return
    if not isinstance(path, str | Path):
        raise ModelError(f"checkpoint={brief(path)}: name a file, such as 'run.part'")
    if not (isinstance(every, int | float) and math.isfinite(every) and every >= 0):
        raise ModelError(f"every={brief(every)}: the time between two checkpoints [s], 0 or more")
    tables = [x for p in input_signals.tabulated for x in (p.input, p.breaks, p.coefficients)]
    times = np.empty(0) if over.times is None else over.times
    functions = sorted(input_signals.functions), input_signals.sample
    # a file is continued only by the call that wrote it
    whose = {
        "model": model_key(model),
        "build": build_key(model),
        "start": digest(begin.x, begin.closure_tol, input_signals.constants, *tables, functions),
        "settings": digest(how, over.start, over.end, times, event_table.descriptions),
    }
    file = RunFile(Path(path), every, whose)
    try:
        yield file
    finally:
        file.close()
