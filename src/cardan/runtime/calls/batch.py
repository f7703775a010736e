"""Many states: in lanes once they pay, in chunks, in threads where there is enough to do.

A chunk takes some hundredths of a second, so that Ctrl-C is heard. The lane build of a function is
compiled when the time that its batches took, with what is left of the present one, exceeds what the
compiler will take: no sequence of calls takes much more than twice the time of the best choice.
What is in the cache is used at once. Lanes give the bits of single states: nobody sees the change.
Floats are always done in lanes, so that the bits of a state do not depend on how many there are.
"""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from ...arrays import Array
from ...errors import BuildError, BuildWarning, warn
from ...schema.blocks import ORDER, SLOT
from .lanes import Answer, Direct, Lanes, Recipe, States, width

Single = Callable[[list[Array | None], Sequence[int], Array], tuple[int, int]]
Run = Callable[[int, int], Answer]

FIRST = 256  # states before the time of one is known
CHUNK_SECONDS = 0.03  # seconds between two looks at signals
FEW = 32  # states from which on lanes are worth a thought
THREADED = 4e-3  # seconds of work from which on threads pay
SHARES = 4  # of a thread
DIFFERENCE = 1e-6  # of the largest entry; builds of one text differ by rounding, if at all
MOST_LANES = 16  # all widths divide it
FLOAT_ERROR = 1e-3  # of the largest entry, from which on results in single precision deserve a word


def cores() -> int:
    """Processor cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def threads(requested: int | None = None) -> int:
    """Threads of a large batch: as asked for, else ``$CARDAN_THREADS``, else the cores.

    Raises:
        BuildError: that is not a number of threads.
    """
    text = os.environ.get("CARDAN_THREADS", "").strip() if requested is None else str(requested)
    if not text:
        return cores()
    if not (text.isascii() and text.isdigit()) or int(text) < 1:
        where = "CARDAN_THREADS" if requested is None else "threads"
        raise BuildError(f"{where}={text} is not a number of threads: 1, 2, ...")
    return int(text)


def one_by_one(one: Single, states: States, sizes: Sequence[int] = ()) -> Run:
    """The call from one state to another that goes through them one by one, in doubles.

    Args:
        one: Runs through rows of states.
        states: Rows, or anything else where ``sizes`` tell the entries of the blocks.
    """

    def run(start: int, end: int) -> Answer:
        if states.plain:
            pairs = zip(states.blocks, states.strides, strict=True)
            here = [None if block is None else block[start * step :] for block, step in pairs]
            status, failed = one(here, states.strides, states.out[start:end])
        else:
            rows = states.rows(start, end, sizes)
            status, failed = one(rows.blocks, rows.strides, rows.out)
            with np.errstate(over="ignore"):
                states.out[start:end] = rows.out
        return status, failed + start if failed >= 0 else -1, False

    return run


class Batch:
    """One function over many states.

    Args:
        name: For messages.
        recipe: Of its lane builds; None where there are none, such as without a compiler.
        address: The function built for one state, 0 without a compiler.
        sizes: Entries of every block that it reads, by slot.
        work_size: Numbers of work memory it needs.
        asked: Threads; None for the default.
    """

    def __init__(
        self,
        name: str,
        recipe: Recipe | None,
        address: int = 0,
        sizes: Sequence[int] = (),
        work_size: int = 0,
        thread_count: int | None = None,
    ) -> None:
        self.name = name
        self.recipe = recipe
        self.address = address
        self.sizes = tuple(sizes) or (0,) * len(ORDER)
        self.work_size = work_size
        self.thread_count = thread_count
        self._lock = threading.RLock()
        # by whether every state has parameters of its own
        self._built: dict[bool, Lanes | None] = {}
        self._spent = {False: 0.0, True: 0.0}
        self._rates: dict[bool, float] = {}
        # the lane build for batches that one call is enough for, where all states share parameters
        self.direct: Direct | None = None

    @property
    def single(self) -> bool:
        """True if its lanes are of floats."""
        return self.recipe is not None and self.recipe.single

    @property
    def cost(self) -> float:
        """Expected compile time of a lane build [s]."""
        return np.inf if self.recipe is None else self.recipe.seconds

    def run(self, one: Single, states: States) -> Answer:
        """Results at all states.

        Args:
            one: Runs through rows of states one by one.
            states: Where they are, and where their results go.

        Returns:
            (first status that is not 0, index of that state or -1, whether all numbers that are
            read and all results are known to be finite).
        """
        lane_parameters = states.strides[SLOT["w"]] != 0
        count, single = len(states.out), one_by_one(one, states, self.sizes)
        lanes = self.lane_run(lane_parameters, states) if count >= FEW or self.single else None
        if self.single and lanes is None:
            lanes = self._better(lane_parameters, one, states)
        way = lanes or single
        answers: list[Answer] = []
        # seconds of a state in lanes are remembered: most batches are done by one call
        remembered = self._rates.get(lane_parameters)
        rate = remembered if way is lanes else None
        at = 0
        while at < count:
            chunk = FIRST
            if rate is not None:
                # whole vectors
                chunk = max(1, int(CHUNK_SECONDS / max(rate, 1e-9)) // MOST_LANES) * MOST_LANES
                if self._in_threads(rate * (count - at)):
                    answers.extend(self._threaded(way, at, count, chunk))
                    break
            end = min(count, at + chunk)
            before = time.perf_counter()
            answers.append(way(at, end))
            spent = time.perf_counter() - before
            rate = spent / (end - at)
            if way is lanes:
                # of a few states the call itself takes more, and others may have had the processor
                if end - at >= FIRST:
                    self._rates[lane_parameters] = min(rate, remembered or rate)
                    self._settle()
            elif count >= FEW:
                self._spent[lane_parameters] += spent
                if self._spent[lane_parameters] + rate * (count - end) > self.cost:
                    lanes = self._better(lane_parameters, one, states)
                    way = lanes or single
            at = end
        failed = next((answer for answer in answers if answer[0]), None)
        return failed or (0, -1, all(finite for _, _, finite in answers))

    def _in_threads(self, seconds: float) -> bool:
        """True if work of so many seconds is shared by threads."""
        return seconds > THREADED and bool(self.address) and threads(self.thread_count) > 1

    def watches(self, lane_parameters: bool, count: int) -> bool:
        """True if a run looks for numbers that are not finite, in all that is read."""
        return (count >= FEW or self.single) and self.ready(lane_parameters) is not None

    @property
    def lanes(self) -> int:
        """States side by side as things stand, with parameters that all states share."""
        built = self._built.get(False)
        return 1 if built is None else built.width

    def _threaded(self, way: Run, start: int, count: int, chunk: int) -> list[Answer]:
        """The states from ``start`` on, shared by threads."""
        from concurrent.futures import ThreadPoolExecutor

        many = threads(self.thread_count)
        # several shares each: a thread that was kept waiting leaves some to others
        share = -(-(count - start) // (SHARES * many * MOST_LANES)) * MOST_LANES
        step = min(chunk, share)
        with ThreadPoolExecutor(many, "cardan") as pool:
            futures = [
                pool.submit(way, at, min(count, at + step)) for at in range(start, count, step)
            ]
            try:
                return [task.result() for task in futures]
            finally:
                # Ctrl-C: what has not begun does not begin
                for task in futures:
                    task.cancel()

    def ready(self, lane_parameters: bool) -> Lanes | None:
        """The lane build, if it was made before, here or by another process."""
        with self._lock:
            if self.recipe is not None and lane_parameters not in self._built:
                lanes = width(self.single)
                self._built[lane_parameters] = (
                    self.recipe.there(lanes, lane_parameters) if lanes > 1 else None
                )
                self._settle()
            return self._built.get(lane_parameters)

    def lane_run(self, lane_parameters: bool, states: States) -> Run | None:
        """The call of the lane build, if it was made before."""
        built = self.ready(lane_parameters)
        if built is None:
            return None
        return built.call(self.address, states, self.sizes, self.work_size)

    def _better(self, lane_parameters: bool, one: Single, states: States) -> Run | None:
        """The call of the lane build, made now; None where there can be none."""
        if self.recipe is None or width() == 1 or np.isneginf(self._spent[lane_parameters]):
            self._spent[lane_parameters] = -np.inf
            return None
        try:
            self.build(lane_parameters, one, states)
        except BuildError as error:
            self._spent[lane_parameters] = -np.inf
            warn(
                f"{self.name}: no build for several states at once, they are done one by one. "
                f"{error}",
                BuildWarning,
            )
            return None
        return self.lane_run(lane_parameters, states)

    def build(self, lane_parameters: bool, one: Single, states: States) -> int:
        """Make the lane build now unless it is there.

        Args:
            lane_parameters: Whether every state has parameters of its own.
            one, states: What it is compared with before it is used.

        Returns:
            States side by side, 1 where the machine has no vectors.

        Raises:
            BuildError: the compiler failed, or results differ.
        """
        with self._lock:
            lanes_built = self._built.get(lane_parameters)
            lanes = 1 if self.recipe is None else width(self.single)
            if self.recipe is None or lanes == 1:
                return 1
            if lanes_built is None:
                lanes_built = self.recipe.built_now(lanes, lane_parameters)
                try:
                    # of floats the caller judges every build
                    if lanes_built.built.fresh and not self.single:
                        self._compare(lanes_built, one, states)
                except BaseException:
                    lanes_built.built.discard()
                    raise
                lanes_built = replace(lanes_built, built=lanes_built.built.published())
                self._built[lane_parameters] = lanes_built
                self._settle()
            return lanes_built.width

    def _settle(self) -> None:
        """Say which batches one call is enough for: those that threads do not share."""
        built, rate = self._built.get(False), self._rates.get(False)
        most = FIRST if rate is None else int(THREADED / max(rate, 1e-9))
        unit = np.dtype(np.float32 if self.single else np.float64).itemsize
        way = built.direct(self.address, self.sizes, unit, most) if built else None
        self.direct = way

    def _compare(self, lanes: Lanes, one: Single, states: States) -> None:
        """Both builds at the first states.

        Raises:
            BuildError: they differ.
        """
        count = min(len(states.out), 4 * MOST_LANES)
        shape = (count, states.out.shape[1])
        first, second = np.empty(shape, states.out.dtype), np.empty(shape, states.out.dtype)
        one_by_one(one, replace(states, out=first), self.sizes)(0, count)
        lanes.call(self.address, replace(states, out=second), self.sizes, self.work_size)(0, count)
        scale = np.abs(first[np.isfinite(first)]).max(initial=0.0)
        if not np.allclose(first, second, rtol=0, atol=DIFFERENCE * scale, equal_nan=True):
            raise BuildError(
                f"{self.name}: the compiler makes different code of one text for single states and "
                "for several at once. Try another one: CC"
            )

    def judge(self, exact: Array, single: Array) -> None:
        """Warn where single precision leaves few digits of results, or none."""
        scale = np.abs(exact[np.isfinite(exact)]).max(initial=0.0)
        with np.errstate(invalid="ignore"):
            error = float(np.abs(single - exact).max(initial=0.0)) / (float(scale) or 1.0)
        if not error <= FLOAT_ERROR and np.isfinite(exact).all():
            warn(
                f"{self.name}: float32 differs from doubles by {error:.0e} of the largest entry. "
                "Give arrays of float64 where that is too much",
                BuildWarning,
            )
