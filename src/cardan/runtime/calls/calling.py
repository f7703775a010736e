"""From arrays of any batch shape to calls of one C function, with errors in the user's names."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field
from functools import cached_property
from math import prod
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, SolveWarning, near, warn
from ...records import dataclass
from ...schema.blocks import ORDER, SLOT
from . import abi
from .batch import Batch
from .interpreted import Interpreted

MAX_PRINTED = 12
ANY = -1
LITTLE = 200_000  # operations that take no longer than a look at all arguments
MOST = 4096  # states that are done without one
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
    ) -> None:
        self.name = name
        self.address = address
        self.arguments = tuple(arguments)
        self.shape = shape
        self.size = prod(shape)
        self.entries = tuple(entries)
        self.work_size = work_size
        self.w = w
        self.operations = operations
        self.few = min(MOST, LITTLE // max(1, operations))
        self.evaluator = evaluator
        self.batch = Batch(name, None) if batch is None else batch
        self.w_slot = SLOT["w"]

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
        values = [*values, *[None] * (len(self.arguments) - len(values))]
        arrays = [self._read(a, v) for a, v in zip(self.arguments, values, strict=True)]
        lead = self._lead(arrays, w)
        count = prod(lead)
        blocks: list[Array | None] = [None] * len(ORDER)
        strides = [0] * len(ORDER)
        argument_arrays: list[tuple[Argument, Array]] = []
        for argument, array in zip(self.arguments, arrays, strict=True):
            flat, stride = _rows(array, lead, argument.shape)
            argument_arrays.append((argument, flat))
            for slot, first in argument.blocks:
                blocks[slot], strides[slot] = flat[first:], stride
        prepared = self.w if w is None else w
        blocks[SLOT["w"]], strides[SLOT["w"]] = _rows(prepared, lead, prepared.shape[-1:])
        # lanes look at the numbers while they have them at hand
        watched = self.batch.watches(strides, count)
        later = [row for row in argument_arrays if all(watched[slot] for slot, _ in row[0].blocks)]
        for argument, flat in argument_arrays:
            if not all(watched[slot] for slot, _ in argument.blocks):
                self._check_finite(argument, flat)
        if count * max(1, self.size) > LARGEST:
            raise MemoryError(f"{count} states of {self.size} numbers")
        result = self._room(lead, count, blocks, out)
        if count:
            status, failed, finite = self.batch.run(self.call, blocks, strides, result)
            if not finite:
                for argument, flat in later:
                    self._check_finite(argument, flat)
                self.check_result(result, status, failed, single=not lead)
        return self._deliver(result.reshape(lead + self.shape), out)

    def _room(
        self, lead: tuple[int, ...], count: int, blocks: list[Array | None], out: object
    ) -> Array:
        """Array for the results, (count, size): for a batch ``out`` itself if it takes them so."""
        if (
            lead
            and isinstance(out, np.ndarray)
            and out.dtype == np.float64
            and out.shape == lead + self.shape
            and out.flags.carray
            and not any(b is not None and np.may_share_memory(b, out) for b in blocks)
        ):
            return out.reshape(count, self.size)
        return np.empty((count, self.size))

    def call(
        self, blocks: list[Array | None], strides: Sequence[int], rows: Array
    ) -> tuple[int, int]:
        """One loop over states, nothing checked; see :func:`.abi_ctypes.run`."""
        if self.evaluator is not None:
            return self.evaluator.run(blocks, strides, rows)
        return abi.run(self.address, blocks, strides, len(rows), rows, self.work_size)

    def _read(self, argument: Argument, value: object) -> Array:
        """The value as float64 with the trailing axes of the argument."""
        if value is None:
            if argument.default is None and argument.size:
                raise ArgumentError(f"{self.name} needs {argument}=")
            return np.zeros(argument.shape) if argument.default is None else argument.default
        if isinstance(value, Mapping) and argument.start is not None:
            return by_name(f"{self.name}, {argument}", argument, value)
        array = numbers(f"{self.name}: {argument}", value)
        n = len(argument.shape)
        if array.ndim < n or array.shape[array.ndim - n :] != argument.shape:
            raise ArgumentError(
                f"{self.name}: {argument} has shape {array.shape}, expected "
                f"{_shape_text(argument.shape)}{_listed(argument)}"
            )
        return array

    def _lead(self, arrays: Sequence[Array], w: Array | None) -> tuple[int, ...]:
        """Common leading axes of all values."""
        shapes = {
            str(a): x.shape[: x.ndim - len(a.shape)]
            for a, x in zip(self.arguments, arrays, strict=True)
        }
        if w is not None:
            shapes["parameters"] = w.shape[:-1]
        return common(self.name, shapes)

    def _check_finite(self, argument: Argument, flat: Array) -> None:
        bad = abi.first_bad(flat)
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
        if not status and abi.first_bad(result) < 0:
            return
        if failed >= 0:
            result[failed] = np.nan
        bad = ~np.isfinite(result)
        rows = np.flatnonzero(bad.any(axis=1))
        if not len(rows):
            return
        first = int(rows[0])
        names = [self.entries[j] for j in np.flatnonzero(bad[first])]
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

    def _deliver(self, result: Array, out: Array | None) -> Array:
        if out is None:
            return result
        if not isinstance(out, np.ndarray) or out.shape != result.shape or out.dtype != float:
            has = getattr(out, "shape", None)
            raise ArgumentError(
                f"{self.name}: out has shape {has}, expected float64 of shape {result.shape}"
            )
        if not np.may_share_memory(out, result):
            out[...] = result
        return out


def _rows(array: Array, lead: tuple[int, ...], trail: tuple[int, ...]) -> tuple[Array, int]:
    """The numbers of an array state by state, and how far apart the states are."""
    leading = array.shape[: array.ndim - len(trail)]
    if prod(leading) == 1:
        return np.ascontiguousarray(array).reshape(-1), 0
    if leading != lead:
        array = np.broadcast_to(array, lead + trail)
    return np.ascontiguousarray(array).reshape(-1), prod(trail)


def _shape_text(shape: tuple[int, ...]) -> str:
    return "(" + ", ".join(["...", *map(str, shape)]) + ")"


def _listed(argument: Argument) -> str:
    """The names behind a shape, for the end of an error message."""
    if not argument.shape or not argument.entries:
        return ""
    listing = ", ".join(argument.entries[:MAX_PRINTED])
    more = ", ..." if len(argument.entries) > MAX_PRINTED else ""
    return f": {argument.what} {listing}{more}"


def numbers(where: str, value: object) -> Array:
    """A value as an array of float64.

    Raises:
        ArgumentError: it holds other things than real numbers, or rows of different lengths.
    """
    try:
        array = np.asarray(value)
    except ValueError:
        raise ArgumentError(f"{where}: its rows have different lengths") from None
    if array.dtype.kind not in "fiub":
        raise ArgumentError(f"{where} must be real numbers, not {array.dtype}")
    return np.asarray(array, dtype=np.float64)


def common(where: str, shapes: Mapping[str, tuple[int, ...]]) -> tuple[int, ...]:
    """The leading axes that several arguments broadcast to.

    Raises:
        ArgumentError: there are none.
    """
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        text = ", ".join(f"{name} {shape}" for name, shape in shapes.items() if shape)
        raise ArgumentError(f"{where}: leading axes do not broadcast together: {text}") from None


def by_name(where: str, argument: Argument, values: Mapping[str, ArrayLike]) -> Array:
    """A vector from named values, the rest as it starts.

    Args:
        where: Function and argument, for errors.
        values: Name -> number (...), or the name of a joint -> all its numbers (..., n).

    Raises:
        ModelError: an unknown name, with near ones.
    """
    lead: tuple[int, ...] = ()
    read: dict[str, Array] = {}
    for name, entry_value in values.items():
        if name not in argument.places:
            raise ModelError(f"{where}: '{name}' does not exist.{near(name, argument.places)}")
        value, place = numbers(f"{where}: '{name}'", entry_value), argument.places[name]
        size = place.stop - place.start
        if size == 1:
            value = value[..., None]
        elif value.ndim == 0 or value.shape[-1] != size:
            raise ArgumentError(
                f"{where}: '{name}' has shape {value.shape}, expected (..., {size}): "
                f"{', '.join(argument.entries[place])}"
            )
        read[name] = value
        lead = common(where, {"the others": lead, f"'{name}'": value.shape[:-1]})
    result: Array = np.broadcast_to(
        np.zeros(argument.size) if argument.start is None else argument.start,
        (*lead, argument.size),
    ).copy()
    for name, value in read.items():
        result[..., argument.places[name]] = value
    return result
