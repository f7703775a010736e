"""Show how far a run is, once it takes long enough to matter."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

Show = Callable[[float], None]
PATIENCE = 1.0  # seconds before a bar appears


@contextmanager
def showing(
    progress: bool | Show | None, what: str, stage: Callable[[], str] | None = None
) -> Iterator[Show]:
    """Callback that takes the fraction done.

    Args:
        progress: True: a bar on standard error; None: the same if that is a terminal; False:
            nothing; a function: called with the fraction.
        what: Stands before the bar.
        stage: Says how the work stands; its text follows.
    """
    if callable(progress):
        yield progress
    elif progress or (progress is None and sys.stderr.isatty()):
        bar = Bar(what, stage)
        try:
            yield bar.show
        finally:
            bar.close()
    else:
        yield lambda fraction: None


class Bar:
    """A bar of rich that appears when the run takes longer than a second."""

    def __init__(self, what: str, stage: Callable[[], str] | None = None) -> None:
        self._what, self._started, self._stage = what, time.perf_counter(), stage
        self._bar: Any = None
        self._task: Any = None

    @property
    def text(self) -> str:
        """What stands before the bar."""
        return self._what if self._stage is None else f"{self._what}: {self._stage()}"

    def show(self, fraction: float) -> None:
        """Move the bar to a fraction in 0 ... 1."""
        if self._bar is None:
            if time.perf_counter() - self._started < PATIENCE:
                return
            self._open()
        self._bar.update(self._task, completed=fraction, description=self.text)

    def _open(self) -> None:
        from rich.console import Console
        from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

        columns = (
            TextColumn("{task.description}", markup=False),
            BarColumn(),
            TextColumn("{task.percentage:>3.0f} %"),
            TimeRemainingColumn(),
        )
        # where nothing can move, such as in a log file, a bar is left out
        console = Console(stderr=True)
        quiet = not console.is_terminal
        self._bar = Progress(*columns, console=console, transient=True, disable=quiet)
        self._task = self._bar.add_task(self._what, total=1.0)
        self._bar.start()

    def close(self) -> None:
        """Take the bar away."""
        if self._bar is not None:
            self._bar.stop()
