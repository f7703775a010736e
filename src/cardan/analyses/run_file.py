"""Runs of ``simulate`` in a file that only grows: the same call goes on from there, to the bit.

Every record holds the rows since the last one, and the record and memory of the run behind them.
"""

from __future__ import annotations

import json
import math
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import ModelError
from ..runtime.compiled import CompiledModel
from ..runtime.interpreted import CURE
from . import record as abi
from .growing import Growing, build_key, digest, model_key, packed, text, unpacked
from .happenings import Happenings
from .kept import Kept
from .run import Runner
from .saved_record import record_of, saved_of
from .settings import Settings, Start
from .signals import Signals
from .times import Span

MAGIC = b"cardan run 1\n"
CURES = {
    "model": "it was computed with another model",
    "build": "it was computed with another compiler, processor or version of the integrators",
    "start": "it starts elsewhere or has other inputs",
    "settings": "it has another time, method, tolerance or other events",
}
# of the record, beside what steppers keep: where it is among its stops and output times
PLACES = ("next_stop", "next_time")
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
        self._file = Growing(path, MAGIC, whose, CURES)
        self._records = [unpacked(content) for content in self._file.contents()]
        self._clock = time.monotonic()
        self.method = self.reason = ""
        if self._records:
            head = self._head
            self.method, self.reason = str(head["method"]), str(head["reason"])

    def close(self) -> None:
        """Let others have the file."""
        self._file.close()

    @property
    def _head(self) -> dict[str, Any]:
        found: dict[str, Any] = json.loads(self._records[-1]["head"].tobytes())
        return found

    def begin(self) -> None:
        """Throw away what is there: the run begins anew by another method."""
        self._file.begin()
        self._records, self.method, self.reason = [], "", ""

    def go_on(self, runner: Runner, kept: Kept) -> int | None:
        """Bring a run to where the file ends. Returns the answer there; None for a new file."""
        if not self._records:
            return None
        for one in self._records:
            kept.rows.append(one["rows"])
            kept.spreads.append(one["spreads"])
            kept.logs.append(one["log"])
        kept.fresh()
        head, last, run = self._head, self._records[-1], runner.record
        places = [head["record"].pop(name) for name in PLACES]
        saved = saved_of(runner, head["record"], last["memory"], last["ticks"].tobytes(), self.path)
        # the stops are those of this run again, of which some lie behind it
        stops = run.stops, run.stop_count
        runner.restore(saved)
        run.stops, run.stop_count = stops
        run.next_stop, run.next_time = places
        # what the start has written is in the file
        run.count = 0
        runner.drained()
        for row, where in zip(runner.pieces, head["where"], strict=True):
            row.where = where
        self._records = []
        return int(head["answer"])

    def note(self, runner: Runner, kept: Kept, answer: int) -> None:
        """Write what is new, if it is time to or the run is over.

        Raises:
            SolveError: there is no room for it.
        """
        over = answer in (*OVER, abi.STOPPED)
        if not over and (answer < 0 or time.monotonic() - self._clock < self.every):
            return
        kept.take()
        run, whole = runner.record, runner.save()
        head = {
            "record": {**record_of(runner), **{name: getattr(run, name) for name in PLACES}},
            "where": [row.where for row in runner.pieces],
            "answer": answer if answer in OVER else abi.MORE,
            "method": runner.settings.method.name,
            "reason": runner.settings.reason,
        }
        rows, spreads, log = kept.fresh()
        self._file.add(
            packed(
                {
                    "head": text(head),
                    "memory": np.frombuffer(whole.memory),
                    "ticks": np.frombuffer(whole.ticks, dtype=np.uint8),
                    "rows": rows,
                    "spreads": spreads,
                    "log": log,
                }
            )
        )
        self._clock = time.monotonic()


@contextmanager
def run_file(
    path: Any,
    every: float,
    model: CompiledModel,
    how: Settings,
    given: Signals,
    may: Happenings,
    over: Span,
    begin: Start,
) -> Iterator[RunFile | None]:
    """The file of a run, closed at the end; None without a path.

    Raises:
        ModelError: no path or time, no compiler, absolute coordinates, or a file of something
            else.
    """
    if path is None:
        yield None
        return
    if not isinstance(path, str | Path):
        raise ModelError(f"checkpoint={path!r}: name a file, such as 'run.part'")
    if not (isinstance(every, int | float) and math.isfinite(every) and every >= 0):
        raise ModelError(f"every={every!r}: the time between two checkpoints [s], 0 or more")
    if "mesh" in model.manifest:
        raise ModelError(
            f"checkpoint= of simulate: model '{model.name}' is in absolute coordinates, whose runs "
            "are kept in no file; leave it out, and save the motion by motion.save(path)"
        )
    build = build_key(model)
    if build == "NumPy":
        raise ModelError(f"checkpoint= of simulate needs a C compiler: {CURE}")
    pieces = [x for p in given.pieces for x in (p.input, p.breaks, p.coefficients)]
    times = np.empty(0) if over.times is None else over.times
    functions = sorted(given.functions), given.sample
    whose = {
        "model": model_key(model),
        "build": build,
        "start": digest(begin.x, begin.slack, given.constants, *pieces, functions),
        "settings": digest(how, over.start, over.end, times, may.described),
    }
    file = RunFile(Path(path), every, whose)
    try:
        yield file
    finally:
        file.close()
