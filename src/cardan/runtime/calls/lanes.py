"""Lane builds: the C of a function compiled for several states side by side, and what calls it."""

from __future__ import annotations

import ctypes
import math
import os
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import field
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any, cast

import numpy as np
from numpy.lib.stride_tricks import as_strided

from ...arrays import Array, on_lines
from ...build_progress import stage
from ...errors import BuildError, CompilerMissing
from ...records import dataclass
from ...schema.blocks import ORDER
from ..build import cache, kernels, prebuilt, single_sources
from ..build.object_file import Object
from ..build.toolchain import Compiler

Answer = tuple[int, int, bool]
WIDTHS = (1, 2, 4, 8)
GROUP = 4  # blocks of lanes that are read at once, as in batch.c
BYTES = 8  # of a double; a vector holds twice as many floats
# what the compiler takes, measured: seconds for a file, and for a statement of it
FILE, STATEMENT = 0.08, 150e-6
Pointers = ctypes.c_void_p * len(ORDER)
_BYTE = ctypes.c_char.from_buffer
# of the blocks and of the result
Sizes = ctypes.c_size_t * (len(ORDER) + 1)


def width(single: bool = False) -> int:
    """States side by side in a batch: ``$CARDAN_LANES``, else what vectors of the level hold.

    One where there is no compiler: what was compiled before goes on one by one.

    Args:
        single: In single precision vectors hold twice as many.

    Raises:
        BuildError: CARDAN_LANES is not a width, or CC names a compiler that does not work.
    """
    text = os.environ.get("CARDAN_LANES", "").strip()
    if text and text not in map(str, WIDTHS):
        raise BuildError(f"CARDAN_LANES={text!r} is not a number of lanes: 1, 2, 4 or 8")
    try:
        lanes = int(text) if text else cache.compiler().level.lanes
    except CompilerMissing:
        return 1
    return 2 * lanes if single and lanes > 1 else lanes


@dataclass(frozen=True)
class States:
    """Arguments of a function over many states, and the array for its results.

    Attributes:
        blocks: Arrays in the order of cardan_in, of the type of ``out``; only where they start
            matters.
        strides: Numbers from one state to the next, 0 for a block that all states share.
        out: (count, output size), float64 or float32: rows one behind the other, or columns.
        spacings: Numbers from one entry of a state to the next; 1 of a block that all states share.
    """

    blocks: list[Array | None]
    strides: Sequence[int]
    out: Array
    spacings: Sequence[int] = (1,) * len(ORDER)

    @cached_property
    def plain(self) -> bool:
        """True if they are rows of doubles, as loops over single states take them."""
        rows = self.out.dtype == np.float64 and self.out.flags.c_contiguous
        return rows and all(spacing == 1 for spacing in self.spacings)

    def rows(self, start: int, end: int, sizes: Sequence[int]) -> States:
        """Some of them as rows of doubles.

        Args:
            start, end: The first one, and the one behind the last.
            sizes: Entries of every block that is read.
        """
        blocks: list[Array | None] = []
        strides: list[int] = []
        sources = zip(self.blocks, self.strides, self.spacings, sizes, strict=True)
        for block, stride, spacing, size in sources:
            if block is None or (spacing == 1 and block.dtype == np.float64):
                rows = None if block is None else block[start * stride :]
            elif stride:
                steps = (stride * block.itemsize, spacing * block.itemsize)
                view = as_strided(block[start * stride :], (end - start, size), steps)
                rows, stride = np.ascontiguousarray(view, np.float64).reshape(-1), size
            else:
                rows = block.astype(np.float64)
            blocks.append(rows)
            strides.append(stride)
        return States(blocks, strides, np.empty((end - start, self.out.shape[1])))


@dataclass(frozen=True)
class Lanes:
    """The lane build of a function.

    Attributes:
        width: States side by side.
        built: Its shared object.
        address: The function in it.
        driver: ``cardan_batch`` of the same width.
        libraries: What keeps them loaded.
        memory: Where it works.
    """

    width: int
    built: Object
    address: int
    driver: Any = field(repr=False)
    libraries: tuple[ctypes.CDLL, ...] = field(repr=False)
    memory: ThreadMemory = field(default_factory=lambda: ThreadMemory(), repr=False)

    def discard(self) -> None:
        """Nobody finds its object in the cache."""
        self.built.discard()

    def direct(self, single: int, sizes: Sequence[int], unit: int, most: int) -> Direct:
        """The call for up to so many states at once."""
        driver = ctypes.cast(self.driver, ctypes.c_void_p).value or 0
        return Direct(driver, self.address, single, tuple(sizes), self.width, unit, most)

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
        out, unit = states.out, states.out.itemsize
        size, strides_out = out.shape[1], out.strides
        shape, room = _shape(
            (*states.strides, strides_out[0] // unit),
            (*states.spacings, strides_out[1] // unit),
            (*sizes, size),
            work_size,
            self.width,
            unit,
        )
        # where the blocks that are read begin, and how far their states are apart [bytes]
        starts = [
            (slot, _address(block), unit * stride)
            for slot, (block, stride, n) in enumerate(
                zip(states.blocks, states.strides, sizes, strict=True)
            )
            if n and block is not None
        ]
        result, step = _address(out if out.flags.c_contiguous else out.T), strides_out[0]

        def run(start: int, end: int) -> Answer:
            begin = self.memory.of(room, unit * self.width)
            here = Pointers()
            for slot, first, distance in starts:
                here[slot] = first + start * distance
            failed, finite = ctypes.c_ssize_t(-1), ctypes.c_int(0)
            status = self.driver(
                self.address,
                single,
                here,
                *shape,
                end - start,
                result + step * start,
                work_size,
                begin,
                failed,
                finite,
            )
            return status, failed.value + start if failed.value >= 0 else -1, bool(finite.value)

        return run


@dataclass(frozen=True)
class Direct:
    """A call of ``cardan_batch`` without anything around it.

    Attributes:
        driver, address, single: Addresses of it, of the lane build and of the build for one state.
        sizes: Entries of every block that is read.
        lanes, unit: States side by side, bytes of a number.
        most: States that one call is for; of more, threads have a share.
    """

    driver: int
    address: int
    single: int
    sizes: tuple[int, ...]
    lanes: int
    unit: int
    most: int

    @property
    def vector(self) -> int:
        """Bytes of a vector."""
        return self.lanes * self.unit

    def room(self, out_size: int, work_size: int) -> int:
        """Bytes of memory that a call needs, at a multiple of a vector."""
        return _room((*self.sizes, out_size), work_size, self.lanes, self.unit)


class ThreadMemory(threading.local):
    """Memory of each thread, which grows to what was asked of it."""

    def __init__(self) -> None:
        self.numbers = np.empty(0, np.uint8)
        self.begin = 0

    def of(self, size: int, vector: int) -> int:
        """Address of so many bytes, at a multiple of the length of a vector."""
        if len(self.numbers) < size + vector:
            self.numbers = np.empty(size + vector, np.uint8)
            self.begin = self.numbers.ctypes.data + -self.numbers.ctypes.data % vector
        return self.begin


def _address(array: Array) -> int:
    """Address of an array that is contiguous."""
    try:
        return ctypes.addressof(_BYTE(cast(bytearray, array)))
    except (TypeError, ValueError):
        # slower, for what is empty or must not be written to
        return int(array.ctypes.data)


@lru_cache(maxsize=1024)
def _shape(
    strides: tuple[int, ...],
    spacings: tuple[int, ...],
    sizes: tuple[int, ...],
    work_size: int,
    lanes: int,
    unit: int,
) -> tuple[tuple[ctypes.Array[ctypes.c_size_t], ...], int]:
    """Arguments of ``cardan_batch`` about blocks and result, which nobody changes, and the bytes of
    memory that it works in.
    """
    room = _room(sizes, work_size, lanes, unit)
    return (Sizes(*strides), Sizes(*spacings), Sizes(*sizes)), room


def _room(sizes: Sequence[int], work_size: int, lanes: int, unit: int) -> int:
    """Bytes that ``cardan_batch`` works in."""
    *blocks, result = (-(-n // lanes) * lanes for n in sizes)
    vectors = GROUP * sum(blocks) + result + work_size
    return unit * lanes * vectors + BYTES * (sum(sizes) + work_size)


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
        single: Its numbers are float.
    """

    symbol: str
    text: Path
    directory: Path
    reproducible: bool
    by: Compiler
    check: Callable[[], None]
    single: bool = False

    @cached_property
    def seconds(self) -> float:
        """Expected compile time; infinite for a text that was removed."""
        try:
            return FILE + STATEMENT * self.text.read_bytes().count(b";")
        except OSError:
            return math.inf

    def there(self, lanes: int, lane_parameters: bool) -> Lanes | None:
        """The build if it is in the cache; none where a text was removed, which names it there."""
        variant = prebuilt.Variant(self.reproducible, lanes, lane_parameters, self.single)
        try:
            with self.sources() as sources:
                built = cache.cached(*sources, self.reproducible, self.by, variant.macros)
        except BuildError:
            return None
        return None if built is None else self.loaded(built, variant)

    @contextmanager
    def sources(self) -> Iterator[tuple[list[Path], list[Path]]]:
        """The C file and the folder of its headers, in single precision where it is asked for."""
        if self.single:
            with single_sources.written([self.text], [self.directory]) as sources:
                yield sources
        else:
            yield [self.text], [self.directory]

    def built_now(self, lanes: int, lane_parameters: bool) -> Lanes:
        """The build, compiled where it is not there; not yet published.

        Args:
            lanes: States side by side.
            lane_parameters: Whether every state has parameters of its own.

        Raises:
            BuildError: the compiler failed, or a text was changed.
        """
        self.check()
        variant = prebuilt.Variant(self.reproducible, lanes, lane_parameters, self.single)
        with (
            stage(f"compiling {self.text.stem} for {lanes} states side by side"),
            self.sources() as sources,
        ):
            built = cache.compiled(*sources, self.reproducible, self.by, variant.macros)
        try:
            return self.loaded(built, variant)
        except BaseException:
            built.discard()
            raise

    def loaded(self, built: Object, variant: prebuilt.Variant) -> Lanes:
        library = built.load()
        driver = _driver(variant)
        address = ctypes.cast(library[self.symbol], ctypes.c_void_p).value or 0
        return Lanes(variant.lanes, built, address, driver.cardan_batch, (library, driver))


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
def _driver(variant: prebuilt.Variant) -> ctypes.CDLL:
    library = kernels.variant(variant)
    at, count = ctypes.c_void_p, ctypes.c_size_t
    library.cardan_batch.argtypes = [
        *(at, at, Pointers, Sizes, Sizes, Sizes, count, at, count, at),
        *(ctypes.POINTER(ctypes.c_ssize_t), ctypes.POINTER(ctypes.c_int)),
    ]
    return library
