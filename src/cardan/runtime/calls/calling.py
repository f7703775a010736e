"""From arrays of any batch shape to calls of one C function, with errors in the user's names."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from math import prod
from typing import NamedTuple, cast

import numpy as np

from ...arrays import Array, Numbers
from ...errors import ArgumentError, SolveError, SolveWarning, warn
from ...records import dataclass
from ...schema.blocks import ORDER, SLOT
from . import abi
from .argument_values import Sources, by_name, common, converted, numbers, prepared
from .batch import Batch
from .interpreted import Interpreted
from .lanes import States
from .memory_order import first_bad, into, laid_out, room

MAX_PRINTED = 12
ANY = -1
LITTLE = 200_000  # operations that take no longer than a look at all arguments
MOST = 4096  # states that are done without one
COMPARED = 64  # states at which single precision is compared with doubles
LARGEST = np.iinfo(np.intp).max // 8  # numbers that can be addressed


@dataclass(frozen=True)
class Argument:
    """An argument of a compiled function as Python sees it.

    Attributes:
        name: Of its block: ``q``, ``x``, ...
        shape: Trailing axes: () for t, (nq,) for q, (parts, 6) for wrench.
        entries: Name of every number of it.
        blocks: (slot in cardan_in, first number) of every input block it fills.
        default: What stands in for None; None where it must be given.
        what: What the entries are called in errors.
        places: Where named entries lie, for values given by name.
        start: The entries that are not named then.
        label: What the signature calls it, for errors; as the block if empty.
    """

    name: str
    shape: tuple[int, ...]
    entries: tuple[str, ...]
    blocks: tuple[tuple[int, int], ...]
    default: Array | None = None
    what: str = "entries"
    places: Mapping[str, slice] = field(default_factory=dict, repr=False)
    start: Array | None = None
    label: str = ""

    @cached_property
    def size(self) -> int:
        return prod(self.shape)

    @cached_property
    def finite(self) -> bool:
        """True if its default is."""
        return self.default is None or bool(np.isfinite(self.default).all())

    @cached_property
    def block_sizes(self) -> tuple[tuple[int, int], ...]:
        """(slot in cardan_in, numbers) of every input block it fills."""
        ends = [*[first for _, first in self.blocks[1:]], self.size]
        pairs = zip(self.blocks, ends, strict=True)
        return tuple((slot, end - first) for (slot, first), end in pairs)

    def __str__(self) -> str:
        return self.label or self.name


# takes all arguments as one tuple and gives the results of a plain call, None of all others
Attempt = Callable[[tuple[object, ...]], Array | tuple[Array, ...] | None]


class Arrangement(NamedTuple):
    """How a function is called whose arguments and results are arranged in another way.

    Attributes:
        handed: Number of arguments that the caller hands over.
        places: Of every argument of the C among these; -1 where it is left out.
        shapes: By the index of an argument of the C: its shape, where the caller has another;
            :data:`ANY` for an axis of any length, if it is as many numbers in all.
        joined: Index of the argument of the C that is handed over as several, -1 if none is.
        components: First number and size of each of them, and whether it is a number without axes.
        parts: First number, size and shape of every result; none if they come as one array.
    """

    handed: int
    places: tuple[int, ...]
    shapes: Mapping[int, tuple[int, ...]]
    joined: int
    components: tuple[tuple[int, int, bool], ...]
    parts: tuple[tuple[int, int, tuple[int, ...]], ...]


class Caller:
    """One function of a model, ready to be called.

    Called as ``caller(out, *values, w=None)`` with one value per argument.

    Attributes:
        name: For errors.
        address: The C function.
        arguments: What it takes.
        shape: Shape of its result for one state.
        entries: Names of the numbers of the result.
        work_size: Numbers of work memory it needs.
        w: Prepared parameters.
        operations: How many it does: long ones release the GIL for one state too.
        few: States that are done one by one, with nothing prepared for many.
        evaluator: What stands in for the C function where there is no compiler.
        batch: What goes through many states.
        single: The same in single precision, for models that have it.
        sources: Parameters that a prepared one comes from, for errors.
        w_slot: Where w stands in cardan_in.
    """

    def __init__(
        self,
        name: str,
        address: int,
        arguments: Sequence[Argument],
        shape: tuple[int, ...],
        entries: Sequence[str],
        work_size: int,
        w: Array,
        operations: int = 0,
        evaluator: Interpreted | None = None,
        batch: Batch | None = None,
        single: Batch | None = None,
        sources: Sources | None = None,
    ) -> None:
        self.name = name
        self.address = address
        self.arguments = tuple(arguments)
        self.shape = shape
        self.size = prod(shape)
        self.entries = entries
        self.work_size = work_size
        self.w = w
        self.operations = operations
        self.few = min(MOST, LITTLE // max(1, operations))
        self.evaluator = evaluator
        self.batch = Batch(name, None, sizes=sizes(arguments)) if batch is None else batch
        self.single = single
        self.sources = sources
        # by whether states have parameters of their own: single precision was compared with doubles
        self._compared: set[bool] = set()
        self.w_slot = SLOT["w"]
        self._constant_blocks: dict[Numbers, list[Array | None]] = {}

    def __call__(self, out: Array | None, *values: object, w: Array | None = None) -> Array:
        """The results for states of any leading shape.

        Args:
            out: Array to write to and return; made if None.
            values: One per argument, None for its default, as for those at the end that are
                left out; leading axes broadcast.
            w: Prepared parameters with leading axes of their own, (..., nw).

        Raises:
            ArgumentError: missing, wrong kind or shape.
            SolveError: a number given is NaN or infinite, or the result for one state is.
        """
        try:
            return self._results(out, values, w)
        except MemoryError as error:
            raise ArgumentError(
                f"{self.name}: so many states do not fit into memory ({error}). Give fewer at once"
            ) from None

    def arranged(self, arrangement: Arrangement) -> Attempt:
        """A quick way into the function as arranged; here there is none."""
        return lambda values: None

    def _results(self, out: Array | None, values: Sequence[object], w: Array | None) -> Array:
        batch, dtype = self._precision(values)
        arrays = self._read_all(values, dtype)
        lead = self._lead(arrays, w)
        count = prod(lead)
        blocks, strides, spacings = [*self.constants(dtype)], [0] * len(ORDER), [1] * len(ORDER)
        rows = columns = False
        for argument, array in arrays:
            flat, stride, spacing = laid_out(array, lead, len(argument.shape))
            if stride and argument.size > 1:
                rows, columns = rows or spacing == 1, columns or spacing > 1
            for slot, first in argument.blocks:
                blocks[slot] = flat[first * spacing :] if first else flat
                strides[slot], spacings[slot] = stride, spacing
        if w is not None:
            numbers_of_states = self._prepared(w, dtype)
            flat, strides[self.w_slot], _ = laid_out(numbers_of_states, lead, 1)
            blocks[self.w_slot] = flat
        # lanes look at the numbers while they have them at hand
        watched = batch.watches(strides[self.w_slot] != 0, count)
        later: list[tuple[Argument, Array]] = []
        for argument, array in arrays:
            if watched and all(batch.sizes[slot] for slot, _ in argument.blocks):
                later.append((argument, array))
            else:
                self._check_finite(argument, array)
        if count * max(1, self.size) > LARGEST:
            raise MemoryError(f"{count} states of {self.size} numbers")
        in_columns = columns and not rows
        result = room(out if lead else None, lead, self.shape, dtype, in_columns, blocks)
        if count:
            states = States(blocks, strides, result, spacings)
            status, failed, finite = batch.run(self.call, states)
            if batch is self.single:
                self.judge(replace(states, out=result[:COMPARED]), w)
            if not finite:
                for argument, array in later:
                    self._check_finite(argument, array)
                self.check_result(result, status, failed, single=not lead)
        return into(result.reshape(lead + self.shape), out, f"{self.name}: ")

    def constants(self, dtype: Numbers) -> list[Array | None]:
        """The blocks of arguments that are left out, and the parameters."""
        blocks = self._constant_blocks.get(dtype)
        if blocks is None:
            blocks = [None] * len(ORDER)
            for argument in self.arguments:
                default = np.zeros(argument.size) if argument.default is None else argument.default
                where = f"{self.name}: {argument}"
                flat = np.ascontiguousarray(converted(where, default, dtype)).reshape(-1)
                for slot, first in argument.blocks:
                    blocks[slot] = flat[first:]
            blocks[self.w_slot] = self._prepared(self.w, dtype)
            self._constant_blocks[dtype] = blocks
        return blocks

    def _prepared(self, w: Array, dtype: Numbers) -> Array:
        """Prepared parameters (..., nw) in the type of a batch."""
        if dtype == np.float64:
            return np.ascontiguousarray(w, dtype)
        return prepared(self.name, w, self.sources)

    @property
    def compared(self) -> bool:
        """True if single precision was compared with doubles, with the parameters of the model."""
        return False in self._compared

    def judge(self, states: States, w: Array | None = None) -> None:
        """Warn where single precision leaves few digits: once for these parameters, whoever made
        the build.

        Args:
            states: In single precision, with results.
            w: Prepared parameters of the states, (..., nw), where they have their own.
        """
        lanes = states.strides[self.w_slot] != 0
        if self.single is None or lanes in self._compared or not self.single.ready(lanes):
            return
        self._compared.add(lanes)
        blocks = [*states.blocks]
        if w is None:
            # what the parameters lose counts too
            blocks[self.w_slot] = self.w
        exact = replace(states, blocks=blocks).rows(0, len(states.out), self.single.sizes)
        self.call(exact.blocks, exact.strides, exact.out)
        self.single.judge(exact.out, states.out)

    def _read_all(self, values: Sequence[object], dtype: Numbers) -> list[tuple[Argument, Array]]:
        """The arguments that are not left out, and those whose default is not finite."""
        arrays = []
        for k, argument in enumerate(self.arguments):
            value = values[k] if k < len(values) else None
            if value is not None:
                arrays.append((argument, self._read(argument, value, dtype)))
            elif argument.default is None and argument.size:
                raise ArgumentError(f"{self.name} needs {argument}=")
            elif not argument.finite and argument.default is not None:
                where = f"{self.name}: {argument}"
                arrays.append((argument, converted(where, argument.default, dtype)))
        return arrays

    def _precision(self, values: Sequence[object]) -> tuple[Batch, Numbers]:
        """The batch that goes through the states of a call, and the type of its numbers.

        Floats where the model has them and all arrays of several states are such.
        """
        if self.single is not None:
            pairs = zip(self.arguments, values, strict=False)
            batches = [
                value.dtype
                for argument, value in pairs
                if isinstance(value, np.ndarray) and value.ndim > len(argument.shape)
            ]
            if batches and all(dtype == np.float32 for dtype in batches):
                return self.single, cast(Numbers, np.float32)
        return self.batch, np.float64

    def call(
        self, blocks: list[Array | None], strides: Sequence[int], rows: Array
    ) -> tuple[int, int]:
        """One loop over states, nothing checked; see :func:`.abi_ctypes.run`."""
        if self.evaluator is not None:
            return self.evaluator.run(blocks, strides, rows)
        return abi.run(self.address, blocks, strides, len(rows), rows, self.work_size)

    def _read(self, argument: Argument, value: object, dtype: Numbers) -> Array:
        """The value as float64, or float32, with the trailing axes of the argument."""
        if isinstance(value, Mapping) and argument.start is not None:
            where = f"{self.name}, {argument}"
            return converted(where, by_name(where, argument, value), dtype)
        n = len(argument.shape)
        if type(value) is np.ndarray and value.dtype == dtype:
            array = value
        else:
            array = numbers(f"{self.name}: {argument}", value, dtype)
        if array.ndim < n or array.shape[array.ndim - n :] != argument.shape:
            raise ArgumentError(
                f"{self.name}: {argument} has shape {array.shape}, expected "
                f"{_shape_text(argument.shape)}{_listed(argument)}"
            )
        return array

    def _lead(self, arrays: Sequence[tuple[Argument, Array]], w: Array | None) -> tuple[int, ...]:
        """Common leading axes of all values."""
        shapes = [x.shape[: x.ndim - len(a.shape)] for a, x in arrays]
        distinct = {shape for shape in shapes if shape}
        if w is None and len(distinct) < 2:
            return distinct.pop() if distinct else ()
        named = {str(a): shape for (a, _), shape in zip(arrays, shapes, strict=True)}
        if w is not None:
            named["parameters"] = w.shape[:-1]
        return common(self.name, named)

    def _check_finite(self, argument: Argument, array: Array) -> None:
        flat = np.ascontiguousarray(array).reshape(-1)
        bad = first_bad(flat)
        if bad < 0:
            return
        state, entry = divmod(bad, argument.size)
        at = f" at state {state}" if flat.size > argument.size else ""
        named = f" of {argument.entries[entry]}" if argument.shape else ""
        raise SolveError(
            f"{self.name}: {argument}{named} is {flat[bad]}{at}. Every number given must be finite"
        )

    def check_result(self, result: Array, status: int, failed: int, single: bool) -> None:
        """Complain about states without a result: raise for one state, warn for a batch.

        Args:
            result: (count, size); rows of states that failed become NaN.
            status, failed: What the C loop returned.
        """
        if not status and first_bad(result) < 0:
            return
        if failed >= 0:
            result[failed] = np.nan
        bad = ~np.isfinite(result)
        rows = np.flatnonzero(bad.any(axis=1))
        if not len(rows):
            return
        first = int(rows[0])
        names = [self.entries[int(j)] for j in np.flatnonzero(bad[first])]
        more = ", ..." if len(names) > MAX_PRINTED else ""
        what = f"{self.name} has no finite result for {', '.join(names[:MAX_PRINTED])}{more}"
        why = (
            "the mass matrix is singular there (a massless body?) or a coordinate is outside its "
            "domain"
        )
        code = f" (status {status})" if status else ""
        if single:
            raise SolveError(f"{what}{code}: {why}")
        warn(
            f"{what}{code} at state {first}; {len(rows)} of {len(result)} states failed: {why}",
            SolveWarning,
        )


def sizes(arguments: Sequence[Argument]) -> list[int]:
    """Numbers of every block in the order of cardan_in that arguments fill."""
    counts = [0] * len(ORDER)
    for argument in arguments:
        for slot, size in argument.block_sizes:
            counts[slot] = size
    return counts


def _shape_text(shape: tuple[int, ...]) -> str:
    return "(" + ", ".join(["...", *map(str, shape)]) + ")"


def _listed(argument: Argument) -> str:
    """The names behind a shape, for the end of an error message."""
    if not argument.shape or not argument.entries:
        return ""
    listing = ", ".join(argument.entries[:MAX_PRINTED])
    more = ", ..." if len(argument.entries) > MAX_PRINTED else ""
    return f": {argument.what} {listing}{more}"
