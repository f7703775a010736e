"""Lane builds: the C of a function compiled for several states side by side, and what calls it."""

from __future__ import annotations

import ctypes
import math
import os
import threading
from collections.abc import Callable, Sequence
from dataclasses import field
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from ...arrays import Array, on_lines
from ...build_progress import stage
from ...errors import BuildError, CompilerMissing
from ...records import dataclass
from ...schema.blocks import ORDER
from ..build import cache, kernels, prebuilt
from ..build.object_file import Object
from ..build.toolchain import Compiler

Answer = tuple[int, int, bool]
WIDTHS = (1, 2, 4, 8)
# what the compiler takes, measured: seconds for a file, and for a statement of it
FILE, STATEMENT = 0.08, 150e-6
Pointers = ctypes.c_void_p * len(ORDER)
Sizes = ctypes.c_size_t * len(ORDER)


def width() -> int:
    """States side by side in a batch: ``$CARDAN_LANES``, else what vectors of the level hold.

    One where there is no compiler: what was compiled before goes on one by one.

    Raises:
        BuildError: CARDAN_LANES is not a width, or CC names a compiler that does not work.
    """
    text = os.environ.get("CARDAN_LANES", "").strip()
    if not text:
        try:
            return cache.compiler().level.lanes
        except CompilerMissing:
            return 1
    if text not in map(str, WIDTHS):
        raise BuildError(f"CARDAN_LANES={text!r} is not a number of lanes: 1, 2, 4 or 8")
    return int(text)


@dataclass(frozen=True)
class States:
    """Arguments of a function over many states, and the array for its results.

    Attributes:
        blocks: Arrays in the order of cardan_in; only where they start matters.
        strides: Numbers from one state to the next, 0 for a block that all states share.
        out: (count, output size), C-contiguous.
    """

    blocks: list[Array | None]
    strides: Sequence[int]
    out: Array


@dataclass(frozen=True)
class Lanes:
    """The lane build of a function.

    Attributes:
        width: States side by side.
        built: Its shared object.
        address: The function in it.
        driver: ``cardan_batch`` of the same width.
        libraries: What keeps them loaded.
    """

    width: int
    built: Object
    address: int
    driver: Any = field(repr=False)
    libraries: tuple[ctypes.CDLL, ...] = field(repr=False)

    def discard(self) -> None:
        """Nobody finds its object in the cache."""
        self.built.discard()

    def call(
        self, single: int, states: States, sizes: Sequence[int], work_size: int
    ) -> Callable[[int, int], Answer]:
        """The call from one state to another.

        It gives the status, the state that failed or -1, and whether all numbers are known to be
        finite: those that are read and the results.

        Args:
            single: Address of the function built for one state.
            states: What it is called with.
            sizes: Entries of every block that is read.
            work_size: Numbers of work memory it needs.
        """
        size = states.out.shape[1]
        padded = [-(-n // self.width) * self.width for n in (*sizes, size)]
        numbers = (sum(padded) + work_size + 1) * self.width
        strides, lengths = Sizes(*states.strides), Sizes(*sizes)
        # where the blocks that are read begin, and how far one state is from the next [bytes]
        read = (b if n else None for b, n in zip(states.blocks, sizes, strict=True))
        starts = [None if block is None else block.ctypes.data for block in read]
        steps = [8 * stride for stride in states.strides]
        out = states.out.ctypes.data
        # every thread has memory of its own
        thread_memory = threading.local()

        def run(start: int, end: int) -> Answer:
            try:
                begin: int = thread_memory.begin
            except AttributeError:
                thread_memory.memory = np.empty(numbers)
                begin = thread_memory.memory.ctypes.data
                # vectors begin at multiples of their length
                thread_memory.begin = begin = begin + -begin % (8 * self.width)
            here = [s and s + start * d for s, d in zip(starts, steps, strict=True)]
            failed, finite = ctypes.c_ssize_t(-1), ctypes.c_int(0)
            status = self.driver(
                self.address,
                single,
                Pointers(*here),
                strides,
                lengths,
                end - start,
                out + 8 * size * start,
                size,
                begin,
                failed,
                finite,
            )
            return status, failed.value + start if failed.value >= 0 else -1, bool(finite.value)

        return run


@dataclass(frozen=True)
class Recipe:
    """Ingredients of the lane build of a function.

    Attributes:
        symbol: Its C name.
        text: Its C file.
        directory: Where its headers are.
        reproducible: Equal bits from every compiler.
        by: What compiled it for single states: lanes get the same bits.
        check: Raises where the text or a header was changed.
    """

    symbol: str
    text: Path
    directory: Path
    reproducible: bool
    by: Compiler
    check: Callable[[], None]

    @cached_property
    def seconds(self) -> float:
        """Expected compile time; infinite for a text that was removed."""
        try:
            return FILE + STATEMENT * self.text.read_bytes().count(b";")
        except OSError:
            return math.inf

    def there(self, lanes: int, lane_parameters: bool) -> Lanes | None:
        """The build if it is in the cache; none where a text was removed, which names it there."""
        extra = prebuilt.macros(lanes, lane_parameters)
        try:
            built = cache.cached([self.text], [self.directory], self.reproducible, self.by, extra)
        except BuildError:
            return None
        return None if built is None else self.loaded(built, lanes, lane_parameters)

    def built_now(self, lanes: int, lane_parameters: bool) -> Lanes:
        """The build, compiled where it is not there; not yet published.

        Args:
            lanes: States side by side.
            lane_parameters: Whether every state has parameters of its own.

        Raises:
            BuildError: the compiler failed, or a text was changed.
        """
        self.check()
        extra = prebuilt.macros(lanes, lane_parameters)
        with stage(f"compiling {self.text.stem} for {lanes} states side by side"):
            built = cache.compiled([self.text], [self.directory], self.reproducible, self.by, extra)
        try:
            return self.loaded(built, lanes, lane_parameters)
        except BaseException:
            built.discard()
            raise

    def loaded(self, built: Object, lanes: int, lane_parameters: bool) -> Lanes:
        library = built.load()
        driver = _driver(self.reproducible, lanes, lane_parameters)
        address = ctypes.cast(library[self.symbol], ctypes.c_void_p).value or 0
        return Lanes(lanes, built, address, driver.cardan_batch, (library, driver))


def packed(rows: Array, lanes: int) -> Array:
    """Rows (n, k) as lanes take them, (ceil(n / lanes), k * lanes): the last repeats the last."""
    n, k = rows.shape
    count = -(-n // lanes)
    which = np.minimum(np.arange(count * lanes), n - 1)
    blocks = on_lines(count, k, lanes)
    blocks[...] = rows[which].reshape(count, lanes, k).transpose(0, 2, 1)
    return blocks.reshape(count, k * lanes)


def unpacked(blocks: Array, lanes: int) -> Array:
    """Rows of what lanes gave."""
    count, size = len(blocks), blocks.shape[1] // lanes
    return blocks.reshape(count, size, lanes).transpose(0, 2, 1).reshape(count * lanes, size)


@lru_cache(maxsize=16)
def _driver(reproducible: bool, lanes: int, lane_parameters: bool) -> ctypes.CDLL:
    library = kernels.library(reproducible, lanes, lane_parameters)
    at, count = ctypes.c_void_p, ctypes.c_size_t
    library.cardan_batch.argtypes = [
        *(at, at, Pointers, Sizes, Sizes, count, at, count, at),
        *(ctypes.POINTER(ctypes.c_ssize_t), ctypes.POINTER(ctypes.c_int)),
    ]
    return library
