"""A console for results and a progress line for long work, shared by the commands."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

Show = Callable[..., None]


def console() -> Console:
    """Results on standard output; no markup, so that users' names print as they are."""
    return Console(markup=False, highlight=False)


@contextmanager
def progress() -> Iterator[Show]:
    """A line on standard error while something takes its time.

    Yields:
        ``show(what, fraction=None)``.
    """
    columns = (
        SpinnerColumn(),
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        TimeElapsedColumn(),
    )
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("", total=None)

        def show(what: str, fraction: float | None = None) -> None:
            total = None if fraction is None else 1.0
            bar.update(task, description=what, total=total, completed=fraction or 0.0)

        yield show
