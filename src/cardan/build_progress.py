"""A line on a terminal that says what is being built, once that takes longer than a moment.

Stages are entered where the work is done, in whatever room: ``with stage("..."):``. The line shows
the innermost; the outermost says since when. Nothing is written where standard error is not a
terminal.
"""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

# seconds before the line appears, and between two updates
DELAY, PERIOD = 3.0, 0.25
MAX_WIDTH, MAX_NAMES = 100, 3
CLEAR = "\r\x1b[2K"

_stages: list[str] = []


@contextmanager
def stage(text: str) -> Iterator[None]:
    """Name what is being done until the block ends.

    Args:
        text: Such as ``"model 'arm': compiling rhs, energy"``.
    """
    line = _Line() if not _stages and _is_terminal() else None
    _stages.append(text)
    try:
        yield
    finally:
        # of several threads each takes back its own
        _stages.remove(text)
        if line is not None:
            line.close()


def listed(names: Sequence[str]) -> str:
    """The first names of many."""
    more = len(names) - MAX_NAMES
    return ", ".join(names[:MAX_NAMES]) + (f" and {more} more" if more > 0 else "")


def _is_terminal() -> bool:
    try:
        return sys.stderr.isatty()
    except (AttributeError, ValueError):
        return False


class _Line:
    """A thread that draws the line, as the work itself never pauses."""

    def __init__(self) -> None:
        self._since = time.perf_counter()
        self._done, self._drawn = threading.Event(), False
        self._thread = threading.Thread(target=self._draw, daemon=True)
        self._thread.start()

    def _draw(self) -> None:
        if self._done.wait(DELAY):
            return
        while not self._done.wait(PERIOD if self._drawn else 0):
            texts = _stages[-1:]
            if texts:
                self._write(f"{CLEAR}{self._text(texts[0])}")

    def _text(self, text: str) -> str:
        seconds = f" ({time.perf_counter() - self._since:.0f} s)"
        plain = "".join(c if c.isprintable() else "?" for c in text)
        most = MAX_WIDTH - len(seconds)
        return (plain if len(plain) <= most else plain[: most - 3] + "...") + seconds

    def _write(self, text: str) -> None:
        try:
            sys.stderr.write(text)
            sys.stderr.flush()
            self._drawn = True
        except (OSError, ValueError):
            self._done.set()

    def close(self) -> None:
        """Take the line away."""
        self._done.set()
        self._thread.join()
        if self._drawn:
            self._write(CLEAR)
