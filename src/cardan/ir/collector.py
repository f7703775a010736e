"""Python's cyclic garbage collector, paused while large graphs are made."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def collector_paused() -> Iterator[None]:
    """No cyclic collection in this block.

    Expressions are tuples of numbers without cycles, made by the ten thousand and kept: the
    collector would scan them again and again and free nothing. Measured on an arm and on a chain
    of 100 bodies, pausing it saves 6 to 12 % of a derivation.
    """
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()
