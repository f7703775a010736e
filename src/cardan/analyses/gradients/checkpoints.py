"""Rows of a run whose steps do not all fit into memory: checkpoints, and steps taken again.

A run is divided into blocks of steps. Checkpoints are made while it goes on, at every block, then
at every second one, every fourth and so on as they get too many: how long the run will be is not
known. Backward, blocks between two of them are reversed by the binomial schedule, with the
checkpoints that are free. Steps taken again are the same to the bit, as they start from a copy of
all that they read.
"""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from typing import NamedTuple, final

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, SolveError, counted
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ..simulation import run_record as abi
from ..simulation.recorder import Recorder
from ..simulation.run import ROWS, Runner
from ..simulation.run_state import Saved
from .differentiable import rows_of
from .schedule import Action, schedule

MEMORY = 1e9  # bytes
# of rows while a motion is made of them and swept over
COPIES = 4
LEAST_ROWS, LEAST_CHECKPOINTS = 2, 3
SAME = 1e-9  # of a step over a singular position: how far its end may be from a stop


class Checkpoint(NamedTuple):
    """Where a run may go on from.

    Attributes:
        saved: The runner there.
        row: The last row before it (width,).
        log: What happened before it and belongs behind it, at the start of the run.
    """

    saved: Saved
    row: Array
    log: Array


class Block(NamedTuple):
    """Steps of a run.

    Attributes:
        rows: At the ends of the steps, the first one where they begin (count, width).
        log: What happened behind the first row.
        first, last: Whether the run begins and ends with it.
    """

    rows: Array
    log: Array
    first: bool
    last: bool


@final
class StepStore:
    """The rows of a run, all of them or those since the last checkpoint.

    Attributes:
        runner: What takes the steps.
        complete: Whether all rows are there.
        capacity: Rows that the runner writes until they are taken.
    """

    def __init__(self, runner: Runner, memory: float) -> None:
        """Args:
        runner: What takes the steps.
        memory: Bytes for rows and checkpoints.

        Raises:
            ArgumentError: that is too little.
        """
        run, model = runner.record, runner.model
        width = 1 + runner.n + model.nr + model.ns + run.nlam
        event = 1 + len(runner.event_table.rows) + 2 * (model.nx + model.ns)
        row = 8 * width + (8 * event if runner.event_table.rows else 0)
        checkpoint = ctypes.sizeof(run) + runner.memory.nbytes + row
        least = 2 * max(COPIES * LEAST_ROWS * row, LEAST_CHECKPOINTS * checkpoint)
        if not memory >= least:
            raise ArgumentError(
                f"gradient: memory={memory:g} bytes: rows and checkpoints of this model take at "
                f"least {least}"
            )
        self.runner, self.complete = runner, True
        # half of the memory each
        self._most_rows = int(memory / (2 * COPIES * row))
        self._most_checkpoints = int(memory / (2 * checkpoint))
        self.capacity = min(ROWS, self._most_rows)
        self._checkpoints: dict[int, Checkpoint] = {}
        self._sizes, self._count, self._total = list[int](), 0, 0
        self._spacing = 1  # blocks from one checkpoint to the next
        # rows at the start of the run and of the present block, and how many parts lie before it
        self._begin = self._ahead = np.zeros(0)
        self._parts = 0
        self._repeated = 0

    def begin(self, recorder: Recorder) -> None:
        """Make the first checkpoint, where the run has just begun."""
        recorder.take()
        self._begin = recorder.rows[-1][-1]
        self._checkpoints[0] = Checkpoint(self.runner.save(), self._begin, recorder.logs[-1])

    def look(self, recorder: Recorder, answer: int) -> None:
        """Count the rows that were taken, and make a checkpoint where a block ends.

        Rows before the present block are thrown away once all of them are too many.
        """
        rows, run = recorder.rows[-1], self.runner.record
        self._count += len(rows)
        self._total += len(rows)
        self.complete = self.complete and self._total <= 2 * self._most_rows
        run.capacity = self._room(self._most_rows - self._count)
        if answer == abi.FULL and self._count >= self._most_rows and self._block_ends(recorder):
            row = next(part[-1] for part in reversed(recorder.rows) if len(part)).copy()
            self._sizes.append(self._count)
            self._count, run.capacity = 0, self.capacity
            self._ahead, self._parts = row, len(recorder.rows)
            self._add(len(self._sizes), row, recorder.logs[-1][:0])
        if not self.complete and self._parts:
            for parts in (recorder.rows, recorder.logs, recorder.spreads):
                parts[: self._parts] = [parts[0][:0]]
            recorder.rows[0], self._parts = self._ahead[None], 0

    def _room(self, left: int) -> int:
        """Rows to write before they are looked at: one by one where a block might end."""
        return max(1, min(self.capacity, left))

    def _add(self, number: int, row: Array, log: Array) -> None:
        """Make a checkpoint before a block, if it is one of those that have one."""
        if number % self._spacing:
            return
        if len(self._checkpoints) >= self._most_checkpoints:
            self._spacing *= 2
            for other in [k for k in self._checkpoints if k % self._spacing]:
                del self._checkpoints[other]
            if number % self._spacing:
                return
        self._checkpoints[number] = Checkpoint(self.runner.save(), row, log)

    def _block_ends(self, recorder: Recorder) -> bool:
        """True if a block may end with the last row: nothing else happens at its time."""
        run, t = self.runner.record, next(p[-1, 0] for p in reversed(recorder.rows) if len(p))
        if not run.row_open or run.t == t:
            return False
        # one step over a singular position has several rows
        return all(
            not 0 < (t - start) / length < 1 - SAME
            for start, length, _ in self.runner.passes[: run.pass_count]
        )

    # backward

    @property
    def start(self) -> Array:
        """The first row (width,)."""
        return self._begin

    @property
    def note(self) -> str:
        """Times that steps were repeated, in words; "" where all of them fitted into memory."""
        if self.complete:
            return ""
        steps, blocks = self._total, len(self._sizes) + 1
        return (
            f"{steps} steps in {counted(blocks, 'block')} with at most "
            f"{counted(self._most_checkpoints, 'checkpoint')}: memory= does not hold the rows of "
            f"all, and every step was taken again {self._repeated / max(steps, 1):.2f} times"
        )

    def backward(self, motion: TrajectoryRecord) -> Iterator[Block]:
        """The blocks, the last one first; each is to be swept before the next one is asked for.

        Args:
            motion: The rows that are there.
        """
        rows, log = rows_of(motion, self.runner), motion.event_log.log
        if self.complete:
            yield Block(rows, log, True, True)
            return
        end = len(self._sizes)
        yield Block(rows, log, False, True)
        behind = rows[0]
        while end > 0:
            begin = max(k for k in self._checkpoints if k < end)
            for block in self._interval(begin, end, behind):
                yield block
                behind = block.rows[0]
            del self._checkpoints[begin]
            end = begin

    def _interval(self, begin: int, end: int, behind: Array) -> Iterator[Block]:
        """The blocks between a checkpoint and another one, the last one first."""
        free = self._most_checkpoints - len(self._checkpoints) + 1
        stored, at = [(begin, self._checkpoints[begin])], self._checkpoints[begin]
        self.runner.resume(at.saved)
        number = begin
        for action, step in schedule(end - begin, max(1, free)):
            if action is Action.RESUME:
                stored = [one for one in stored if one[0] <= begin + step]
                number, at = stored[-1]
                self.runner.resume(at.saved)
            elif action is Action.ADVANCE:
                for k in range(number, begin + step):
                    rows, log = self._again(self._sizes[k], at, False)
                    at = Checkpoint(at.saved, rows[-1], log[:0])
                number = begin + step
            elif action is Action.STORE:
                at = Checkpoint(self.runner.save(), at.row, at.log)
                stored.append((number, at))
            else:
                rows, log = self._again(self._sizes[number], at, True)
                # multipliers are no part of the state
                size = rows.shape[1] - self.runner.record.nlam
                if rows[-1, :size].tobytes() != behind[:size].tobytes():
                    raise SolveError(
                        f"gradient: steps until t = {behind[0]:.6g} s came out differently when "
                        "they were repeated. What the run watches must depend on t and x alone; "
                        "or take a larger memory="
                    )
                yield Block(rows, log, number == 0, False)
                behind = rows[0]

    def _again(self, size: int, begin: Checkpoint, with_rows: bool) -> tuple[Array, Array]:
        """Take the steps of a block again, from where the runner stands.

        Args:
            size: Number of rows.
            begin: What lies before them.
            with_rows: Whether all rows are wanted; else the last one alone.

        Returns:
            Rows with that before them, and what happened.

        Raises:
            KeyboardInterrupt: by Ctrl-C.
        """
        runner, run = self.runner, self.runner.record
        parts, logs, left = [begin.row[None]], [begin.log], size
        run.count, run.capacity = 0, self._room(left)
        with runner.interruptible():
            for answer in runner.slices():
                if answer == abi.MORE:
                    continue
                rows = runner.rows[: run.count]
                left -= len(rows)
                parts.append(rows.copy() if with_rows else rows[-1:].copy())
                logs.append(runner.drained())
                run.count, run.capacity = 0, self._room(left)
                if answer != abi.FULL or left <= 0:
                    break
        runner.check_interrupt()
        # Ctrl-C, whether or not it left a step undone
        if run.stop:
            raise KeyboardInterrupt
        self._repeated += size
        return np.concatenate(parts), np.concatenate(logs)
