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

from ...errors import ArgumentError, BuildError, CardanError, SolveError, shown
from ...processes import on_interrupt
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.models.saved_models import parts, restore
from ..simulation.files.append_log import build_key
from .job import Job, Piece, compute
from .lane_runner import suits, width_of

Block = tuple[int, int]
PATIENCE = 0.05  # seconds between two looks at signals
AHEAD = 2  # blocks per worker that wait at a client


class Threads:
    """Threads of this process, each with its own lanes."""

    def __init__(self, count: int) -> None:
        self.count = count

    def __repr__(self) -> str:
        return f"{self.count} thread{'s' * (self.count > 1)}"

    def pieces(self, job: Job, blocks: Sequence[Block], stop: threading.Event) -> Iterator[Piece]:
        """What became of the blocks, as they get ready; after ``stop`` what there is.

        Raises:
            CardanError: what a block raised.
        """
        left, lock = iter(blocks), threading.Lock()
        ready: queue.Queue[Piece | BaseException] = queue.Queue(2 * self.count)
        crews = [job.crew() for _ in range(min(self.count, len(blocks)))]
        over = threading.Event()

        def work(crew: Any) -> None:
            try:
                while not (over.is_set() or stop.is_set()):
                    with lock:
                        block = next(left, None)
                    if block is None:
                        return
                    ready.put(compute(job, crew, *block))
            except BaseException as problem:
                # the thread that waits raises it
                over.set()
                ready.put(problem)

        team = [threading.Thread(target=work, args=(crew,), daemon=True) for crew in crews]
        for one in team:
            one.start()
        try:
            while found := _next(ready, team, stop, crews):
                if isinstance(found, BaseException):
                    raise found
                yield found
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
        alive = any(one.is_alive() for one in team)
        if stop.is_set():
            for crew in crews:
                crew.stop()
        try:
            return ready.get(timeout=PATIENCE) if alive else ready.get_nowait()
        except queue.Empty:
            if not alive:
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
                f"client={shown(client)} has no submit: give a client of dask.distributed, or an "
                "executor of concurrent.futures"
            )
        self.client = client
        self.is_dask = callable(getattr(client, "scatter", None))

    def __repr__(self) -> str:
        return f"client {type(self.client).__name__}"

    def pieces(self, job: Job, blocks: Sequence[Block], stop: threading.Event) -> Iterator[Piece]:
        """What became of the blocks, as they get ready; after ``stop`` nothing more.

        Raises:
            CardanError: what a block raised there; another build on the other side.
        """
        rest = {f.name: getattr(job, f.name) for f in fields(job) if f.name != "model"}
        # source and manifest travel, never a binary; once to every worker
        model: object = type(job.model), parts(job.model)
        options = {"pure": False} if self.is_dask else {}
        if self.is_dask:
            model = self.client.scatter([model], broadcast=True, hash=False)[0]
        left = iter(blocks)
        waiting: dict[Any, Block] = {}
        try:
            while not stop.is_set():
                while len(waiting) < AHEAD * self._workers():
                    block = next(left, None)
                    if block is None:
                        break
                    own = rest | {"varied": job.varied.part(*block)}
                    waiting[self.client.submit(remote, model, own, *block, **options)] = block
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


def _answer(future: Any, block: Block) -> Piece:
    try:
        piece = future.result()
    except CardanError:
        raise
    except Exception as problem:
        raise SolveError(
            f"runs {block[0]} to {block[1] - 1} failed on the client: "
            f"{type(problem).__name__}: {problem}"
        ) from problem
    if not isinstance(piece, Piece) or (piece.first, piece.last) != block:
        raise SolveError(f"the client gave {piece!r} for runs {block[0]} to {block[1] - 1}")
    return piece


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


def remote(
    sent: tuple[type[LoadedModel], tuple[Any, ...]], rest: dict[str, Any], first: int, last: int
) -> Piece:
    """A block on another process.

    Args:
        sent: The class of the model, and what a pickle of it is made of.
        rest: The other fields of a job of these runs alone.
        first, last: Their numbers.

    Raises:
        BuildError: this machine builds other bits.
    """
    model = _model(*sent)
    job = Job(model=model, **rest)
    key = build_key(model)
    if key != job.build:
        raise BuildError(
            f"runs {first} to {last - 1} were sent to a machine whose build of model "
            f"'{model.name}' is {key}; that of the sender is {job.build}. Compilers, processors or "
            "versions differ, and so would the last digits. Use equal machines"
        )
    width = 1
    if job.width > 1 and suits(model, job.how, job.given, job.may):
        width = width_of(model, job.how, job.may, job.varied.own_parameters, np.inf)
    job = Job(**{f.name: getattr(job, f.name) for f in fields(job)} | {"width": width})
    piece = compute(job, job.crew(), 0, last - first)
    messages = {first + k: text for k, text in piece.messages.items()}
    return Piece(first, piece.x, piece.status, piece.numbers, messages, piece.parts)
