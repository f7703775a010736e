"""Who computes the blocks of an ensemble: threads of this process, or a client elsewhere.

Blocks are handed out in order and come back in any. Ctrl-C ends the handing out; runs under way in
this process end between two steps, and everything computed so far is kept.
"""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import fields
from typing import Any

import numpy as np

from ...errors import ArgumentError, BuildError, CardanError, SolveError, brief
from ...processes import on_interrupt
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.models.saved_models import parts, restore
from ..simulation.files.append_log import build_key
from .job import BlockResult, Job, compute
from .lane_runner import width_of
from .share import Block

PATIENCE = 0.05  # seconds between two looks at signals
AHEAD = 2  # blocks per worker that wait at a client


class Threads:
    """Threads of this process, each with its own lanes."""

    def __init__(self, count: int) -> None:
        self.count = count

    def __repr__(self) -> str:
        return f"{self.count} thread{'s' * (self.count > 1)}"

    def block_results(
        self, job: Job, blocks: Sequence[Block], stop: threading.Event
    ) -> Iterator[BlockResult]:
        """Results of the blocks as they become ready; after ``stop`` those that are ready already.

        Raises:
            CardanError: what a block raised.
        """
        left, lock = iter(blocks), threading.Lock()
        ready: queue.Queue[BlockResult | BaseException] = queue.Queue(2 * self.count)
        crews = [job.runner() for _ in range(min(self.count, len(blocks)))]
        over = threading.Event()

        def work(runner: Any) -> None:
            try:
                while not (over.is_set() or stop.is_set()):
                    with lock:
                        block = next(left, None)
                    if block is None:
                        return
                    ready.put(compute(job, runner, *block))
            except BaseException as problem:
                # the thread that waits raises it
                over.set()
                ready.put(problem)

        team = [threading.Thread(target=work, args=(runner,), daemon=True) for runner in crews]
        for one in team:
            one.start()
        try:
            while answer := _next(ready, team, stop, crews):
                if isinstance(answer, BaseException):
                    raise answer
                yield answer
        finally:
            # nobody listens any more: the threads end, and nothing they wait for is missing
            over.set()
            stop.set()
            while _next(ready, team, stop, crews):
                continue


def _next(
    ready: queue.Queue[Any],
    team: Sequence[threading.Thread],
    stop: threading.Event,
    crews: Sequence[Any],
) -> Any:
    """The next thing that comes; None once all threads have ended."""
    while True:
        any_thread = any(one.is_alive() for one in team)
        if stop.is_set():
            for runner in crews:
                runner.stop()
        try:
            return ready.get(timeout=PATIENCE) if any_thread else ready.get_nowait()
        except queue.Empty:
            if not any_thread:
                return None


@contextmanager
def interruptible() -> Iterator[threading.Event]:
    """An event that Ctrl-C sets instead of raising; the second one raises."""
    stop = threading.Event()

    def heard() -> None:
        if stop.is_set():
            raise KeyboardInterrupt
        stop.set()

    with on_interrupt(heard):
        yield stop


class Client:
    """Anything with ``submit(function, *arguments) -> future``, such as a client of dask."""

    def __init__(self, client: Any) -> None:
        if not callable(getattr(client, "submit", None)):
            raise ArgumentError(
                f"client={brief(client)} has no submit: give a client of dask.distributed, or an "
                "executor of concurrent.futures"
            )
        self.client = client
        self.is_dask = callable(getattr(client, "scatter", None))

    def __repr__(self) -> str:
        return f"client {type(self.client).__name__}"

    def block_results(
        self, job: Job, blocks: Sequence[Block], stop: threading.Event
    ) -> Iterator[BlockResult]:
        """Results of the blocks as they become ready; after ``stop`` nothing more.

        Raises:
            CardanError: what a block raised there; another build on the other side.
        """
        job_fields = {f.name: getattr(job, f.name) for f in fields(job) if f.name != "model"}
        # source and manifest travel, never a binary; once to every worker
        model: object = type(job.model), parts(job.model)
        options = {"pure": False} if self.is_dask else {}
        if self.is_dask:
            model = self.client.scatter([model], broadcast=True, hash=False)[0]
        left = iter(blocks)
        waiting: dict[Any, Block] = {}
        try:
            while not stop.is_set():
                # a few blocks ahead keep all workers busy without queuing everything at once
                while len(waiting) < AHEAD * self._workers():
                    block = next(left, None)
                    if block is None:
                        break
                    block_fields = job_fields | {"varied": job.varied.part(*block)}
                    waiting[self.client.submit(remote, model, block_fields, *block, **options)] = (
                        block
                    )
                if not waiting:
                    return
                done = [future for future in waiting if future.done()]
                for future in done:
                    yield _answer(future, waiting.pop(future))
                if not done:
                    time.sleep(PATIENCE)
        finally:
            for future in waiting:
                future.cancel()

    def _workers(self) -> int:
        """Blocks that can be under way at once."""
        if self.is_dask:
            return max(1, int(sum(self.client.ncores().values())))
        return max(1, int(getattr(self.client, "_max_workers", 1)))


def _answer(future: Any, block: Block) -> BlockResult:
    try:
        block_result = future.result()
    except CardanError:
        raise
    except Exception as problem:
        raise SolveError(
            f"runs {block[0]} to {block[1] - 1} failed on the client: "
            f"{type(problem).__name__}: {problem}"
        ) from problem
    if (
        not isinstance(block_result, BlockResult)
        or (block_result.first, block_result.last) != block
    ):
        raise SolveError(f"the client gave {block_result!r} for runs {block[0]} to {block[1] - 1}")
    return block_result


# the last models that this process was sent, by their content
_MODELS: dict[Any, LoadedModel] = {}
MOST_MODELS = 4


def _model(kind: type[LoadedModel], parts: tuple[Any, ...]) -> LoadedModel:
    """A model that was sent, opened once per process."""
    _, values, reproducible, stated = parts
    key = stated, tuple(values), reproducible
    model = _MODELS.get(key)
    if model is None:
        while len(_MODELS) >= MOST_MODELS:
            _MODELS.pop(next(iter(_MODELS)), None)
        _MODELS[key] = model = restore(kind, *parts)
    return model


def _why(model: LoadedModel) -> str:
    """Why builds differ, and the cure."""
    if model._objects.reproducible:
        return (
            "Versions of cardan or of the mathematical library differ, and so would the last "
            "digits. Use equal ones"
        )
    return (
        "Compilers, processors or versions differ, and so would the last digits. Use equal "
        "machines, or compile with reproducible=True, which has equal bits on all of them"
    )


def remote(
    sent: tuple[type[LoadedModel], tuple[Any, ...]],
    job_fields: dict[str, Any],
    first: int,
    last: int,
) -> BlockResult:
    """A block on another process.

    Args:
        sent: The class of the model, and what a pickle of it is made of.
        job_fields: The other fields of a job of these runs alone.
        first, last: Their numbers.

    Raises:
        BuildError: this machine builds other bits.
    """
    model = _model(*sent)
    job = Job(model=model, **job_fields)
    key = build_key(model)
    if key != job.build:
        raise BuildError(
            f"runs {first} to {last - 1} were sent to a machine whose build of model "
            f"'{model.name}' is {key}; that of the sender is {job.build}. {_why(model)}"
        )
    width = 1
    if job.width > 1 and job.in_lanes:
        width = width_of(model, job.how, job.event_table, job.varied.varies_parameters, np.inf)
    job = Job(**{f.name: getattr(job, f.name) for f in fields(job)} | {"width": width})
    block_result = compute(job, job.runner(), 0, last - first)
    messages = {first + k: text for k, text in block_result.messages.items()}
    warnings = {first + k: texts for k, texts in block_result.warnings.items()}
    return BlockResult(
        first,
        block_result.x,
        block_result.status,
        block_result.numbers,
        messages,
        block_result.parts,
        warnings,
    )
