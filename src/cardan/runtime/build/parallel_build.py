"""Compilations side by side: all of them or none."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from threading import get_ident
from typing import TYPE_CHECKING, Protocol, TypeVar

from . import limited_subprocess

if TYPE_CHECKING:
    from concurrent.futures import Future

# seconds between two looks at compilers that are to end
PATIENCE = 0.02


class Removable(Protocol):
    """Result of a compilation."""

    def discard(self) -> None:
        """Throw it away, unless others have it."""


T = TypeVar("T", bound=Removable)


def in_parallel(tasks: Sequence[Callable[[], T]]) -> list[T]:
    """Results of all tasks, in their order; the first error of one ends all."""
    if len(tasks) < 2:
        return [task() for task in tasks]
    from concurrent.futures import ThreadPoolExecutor, wait

    threads: set[int] = set()
    workers = min(len(tasks), os.cpu_count() or 1)
    with ThreadPoolExecutor(workers, "", lambda: threads.add(get_ident())) as pool:
        futures: list[Future[T]] = []
        try:
            for each in tasks:
                futures.append(pool.submit(each))
            done = [task.exception() for task in futures]
        except BaseException:
            # Ctrl-C reaches this thread alone: the compilers of the others end now, those too
            # that a thread is just about to start
            pool.shutdown(wait=False, cancel_futures=True)
            begun = [task for task in futures if not task.cancelled()]
            while wait(begun, timeout=PATIENCE).not_done:
                limited_subprocess.stop(threads)
            _discard(futures)
            raise
    failed = [error for error in done if error]
    if failed:
        _discard(futures)
        raise failed[0]
    return [task.result() for task in futures]


def _discard(tasks: Sequence[Future[T]]) -> None:
    """Throw away what tasks that have ended made."""
    for task in tasks:
        if not task.cancelled() and not task.exception():
            task.result().discard()
