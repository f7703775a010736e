"""Functions of a model where there is no compiler: their saved expressions, in NumPy.

The same results up to rounding, some hundred times slower.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.lib.stride_tricks import as_strided
from numpy.typing import NDArray

from ..errors import BuildWarning, SolveError, warn
from .slots import SLOT

if TYPE_CHECKING:
    from ..ir.function import Function

Array = NDArray[np.float64]
SINGULAR = 1  # CARDAN_SINGULAR of cardan.h
NUMBERS = 4_000_000  # held at once: every node has a value for every state of a piece
CURE = "pip install 'cardan[compiler]' makes it some hundred times faster"


@lru_cache(maxsize=1)
def announce() -> None:
    """Say once per process that there is no compiler, and what to do about it."""
    warn(
        f"no C compiler here: functions are evaluated in NumPy, with the same results. {CURE}",
        BuildWarning,
    )


class Interpreted:
    """A saved Function, called as generated C is: by blocks and distances between states."""

    def __init__(self, function: Function) -> None:
        self.function = function
        graph, live = function.graph, function.live()
        nodes = [graph.nodes[i] for i in live]
        read = {node[1] for node in nodes if node[0] == "var"}
        self.blocks = [(b.name, len(b)) for b in function.inputs if b.name in read]
        self.piece = max(1, NUMBERS // (len(live) + 1))

    def run(
        self, blocks: list[Array | None], strides: Sequence[int], out: Array
    ) -> tuple[int, int]:
        """As :func:`abi_ctypes.run`; the slot w holds the parameters p."""
        status, failed = 0, -1
        for start in range(0, len(out), self.piece):
            rows = out[start : start + self.piece]
            given = {}
            for name, size in self.blocks:
                slot = SLOT["w" if name == "p" else name]
                block, stride = blocks[slot], strides[slot]
                if block is None:
                    raise SolveError(f"{self.function.name} reads {name}, which is not given")
                given[name] = _states(block[start * stride :], stride, size, len(rows))
            answer, bad = self._rows(given, rows)
            if answer and not status:
                status, failed = answer, start + bad
        return status, failed

    def _rows(self, given: dict[str, Array], out: Array) -> tuple[int, int]:
        """Results of some states; NaN where a system of equations has no solution."""
        if len(out) > 1 and self._together(given, out):
            return 0, -1
        failed = -1
        for k in range(len(out)):
            one = {name: (x if x.ndim == 1 else x[k]).tolist() for name, x in given.items()}
            try:
                self._write(one, "float", out[k])
            except SolveError:
                out[k] = np.nan
                failed = k if failed < 0 else failed
        return SINGULAR if failed >= 0 else 0, failed

    def _together(self, given: dict[str, Array], out: Array) -> bool:
        """Results of all states at once; False if one of them has none."""
        try:
            self._write(given, "numpy", out)
        except SolveError:
            return False
        return True

    def _write(self, given: dict[str, Any], arithmetic: str, out: Array) -> None:
        """Results one after the other into (..., size)."""
        from ..ir.interpreter import evaluate

        found, place = evaluate(self.function, given, arithmetic), 0
        for output in self.function.outputs:
            values, size = np.asarray(found[output.name], dtype=np.float64), len(output.nodes)
            if arithmetic == "numpy":
                lead = values.shape[: values.ndim - len(output.shape)]
                values = values.reshape(*lead, size)
            out[..., place : place + size] = values
            place += size


def _states(flat: Array, stride: int, size: int, count: int) -> Array:
    """(count, size) out of numbers that stand ``stride`` apart; (size,) if all share them."""
    if not stride:
        return flat[:size]
    return as_strided(flat, (count, size), (8 * stride, 8), writeable=False)
