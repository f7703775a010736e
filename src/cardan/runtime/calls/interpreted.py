"""Functions of a model where there is no compiler: their saved expressions, evaluated.

The same results up to rounding, some ten to hundred times slower. Kernels call them as they call
compiled functions, by an address; what is raised on the way is raised again behind the kernel.
"""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.lib.stride_tricks import as_strided

from ...arrays import Array
from ...errors import BuildWarning, SolveError, warn
from ...processes import on_interrupt
from ...schema.blocks import SLOT

if TYPE_CHECKING:
    from ...ir.function import Function

SINGULAR = 1  # CARDAN_SINGULAR of cardan.h
UNSOLVED = -8  # CARDAN_UNSOLVED of run.h
RAISED = 1 << 16  # status of a function that raised, beside those of cardan.h
NUMBERS = 4_000_000  # held at once: every node has a value for every state of a piece
CURE = "pip install 'cardan[compiler]' or 'cardan[wasm]' makes it some hundred times faster"
# cardan_function: an array of blocks, results, work
NUMBER = ctypes.POINTER(ctypes.c_double)
CALLBACK = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(NUMBER), ctypes.c_void_p, ctypes.c_void_p)


@lru_cache(maxsize=1)
def announce() -> None:
    """Say once per process that there is no compiler, and what to do about it."""
    warn(
        f"no C compiler here: functions are evaluated in Python, with the same results. {CURE}",
        BuildWarning,
    )


class _Raised(threading.local):
    """Errors raised by functions below a kernel that a thread calls.

    Attributes:
        error: The first of it.
        stop: Ends the kernel soon; None where no kernel is called.
    """

    error: BaseException | None = None
    stop: Callable[[], object] | None = None

    def store(self, error: BaseException) -> None:
        """Note what was raised, and end the kernel."""
        self.error = self.error or error
        if self.stop is not None:
            self.stop()


_RAISED = _Raised()


@contextmanager
def called_back(stop: Callable[[], object] = bool) -> Iterator[None]:
    """Around a kernel that calls interpreted functions.

    Nothing can be raised through its C frames: functions keep what they raise and have no results
    any more. Ctrl-C is noted too, instead of being raised wherever Python is just then.

    Args:
        stop: Ends the kernel soon.

    Raises:
        BaseException: what a function raised, or KeyboardInterrupt.
    """
    before = _RAISED.error, _RAISED.stop
    _RAISED.error, _RAISED.stop = None, stop
    try:
        with on_interrupt(lambda: _RAISED.store(KeyboardInterrupt())):
            yield
    finally:
        error = _RAISED.error
        _RAISED.error, _RAISED.stop = before
        if error is not None:
            raise error


class PythonFunction:
    """A function of Python that kernels call as they call compiled ones.

    Args:
        function: Lists of floats -> a list of floats or an array, one list for each block.
        blocks: (name of a block, how many numbers of it).
        size: Numbers of the result.
    """

    def __init__(
        self,
        function: Callable[..., list[float] | Array],
        blocks: Sequence[tuple[str, int]],
        size: int,
    ) -> None:
        self._function = function
        self._places = [(SLOT["w" if name == "p" else name], n) for name, n in blocks]
        self._row = ctypes.c_double * size
        self._callback = CALLBACK(self._called)

    @property
    def address(self) -> int:
        """Address of a function that kernels can call;

        inside :func:`called_back`, while this lives.
        """
        return ctypes.cast(self._callback, ctypes.c_void_p).value or 0

    def _called(self, blocks: Any, out: int, work: int) -> int:
        """The function with the interface of generated C; slot w holds the parameters p."""
        try:
            if _RAISED.error is not None:
                return RAISED
            row = self._row.from_address(out)
            try:
                values: Any = self._function(*[blocks[k][:size] for k, size in self._places])
                if isinstance(values, np.ndarray):
                    np.ctypeslib.as_array(row)[:] = values.reshape(-1)
                else:
                    row[:] = values
            except SolveError:
                row[:] = [np.nan] * len(row)
                return SINGULAR
        except BaseException as error:
            _RAISED.store(error)
            return RAISED
        return 0


class Interpreted:
    """A saved Function, called as generated C is: by blocks and distances between states."""

    def __init__(self, function: Function) -> None:
        self.function = function
        graph, live = function.graph, function.live()
        nodes = [graph.nodes[i] for i in live]
        read = {node[1] for node in nodes if node[0] == "var"}
        self.blocks = [(b.name, len(b)) for b in function.inputs if b.name in read]
        self.chunk = max(1, NUMBERS // (len(live) + 1))
        roots = len(function.roots)
        self._called_back = PythonFunction(lambda *given: self.floats(*given), self.blocks, roots)

    @property
    def address(self) -> int:
        """Same as :attr:`PythonFunction.address`."""
        return self._called_back.address

    @cached_property
    def floats(self) -> Callable[..., list[float]]:
        """Results at one state as a function of the blocks, lists of floats."""
        from ...ir.straight_line import straight_line

        return straight_line(self.function)

    def run(
        self, blocks: list[Array | None], strides: Sequence[int], out: Array
    ) -> tuple[int, int]:
        """Same as :func:`abi_ctypes.run`; the slot w holds the parameters p."""
        status, failed = 0, -1
        for start in range(0, len(out), self.chunk):
            rows = out[start : start + self.chunk]
            blocks_read = {}
            for name, size in self.blocks:
                slot = SLOT["w" if name == "p" else name]
                block, stride = blocks[slot], strides[slot]
                if block is None:
                    raise SolveError(f"{self.function.name} reads {name}, which is not given")
                blocks_read[name] = _states(block[start * stride :], stride, size, len(rows))
            answer, bad = self._rows(blocks_read, rows)
            if answer and not status:
                status, failed = answer, start + bad
        return status, failed

    def _rows(self, blocks_read: dict[str, Array], out: Array) -> tuple[int, int]:
        """Results of some states; NaN where a system of equations has no solution."""
        if len(out) > 1 and self._vectorized(blocks_read, out):
            return 0, -1
        failed = -1
        for k in range(len(out)):
            one = [(x if x.ndim == 1 else x[k]).tolist() for x in blocks_read.values()]
            try:
                out[k] = self.floats(*one)
            except SolveError:
                out[k] = np.nan
                failed = k if failed < 0 else failed
        return SINGULAR if failed >= 0 else 0, failed

    def _vectorized(self, blocks_read: dict[str, Array], out: Array) -> bool:
        """Results of all states at once; False if one of them has none."""
        try:
            self._write(blocks_read, out)
        except SolveError:
            return False
        return True

    def _write(self, blocks_read: dict[str, Any], out: Array) -> None:
        """Results of all states one after the other into (count, size)."""
        from ...ir.interpreter import evaluate

        values_by_output, place = evaluate(self.function, blocks_read, "numpy"), 0
        for output in self.function.outputs:
            values, size = (
                np.asarray(values_by_output[output.name], dtype=np.float64),
                len(output.nodes),
            )
            lead = values.shape[: values.ndim - len(output.shape)]
            out[:, place : place + size] = values.reshape(*lead, size)
            place += size


def _states(flat: Array, stride: int, size: int, count: int) -> Array:
    """(count, size) out of numbers that stand ``stride`` apart; (size,) if all share them."""
    if not stride:
        return flat[:size]
    return as_strided(flat, (count, size), (8 * stride, 8), writeable=False)
