"""Operations and time of the functions of flexible elements, one by one and in lanes.

Times are reported, never asserted.

usage: flexible.py [kind ...]
"""

from __future__ import annotations

import ctypes
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

# the states of the tests stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.table import Table

from cardan.codegen import generate
from cardan.ir.function import Function
from cardan.runtime.build import cache
from cardan.runtime.calls import lanes
from cardan.schema import kernel_files
from elements.flexible.states import ELEMENTS, State, state

DRIVER = Path(__file__).with_name("flexible.c")
FUNCTIONS = ("balance", "balance_tangent", "mixed", "mixed_step")
COUNT, ROUNDS, LEAST = 256, 25, 64
Array = NDArray[np.float64]


class At(Protocol):
    """Data, coordinates, speeds and accelerations of an element."""

    @property
    def p(self) -> Sequence[float]: ...
    @property
    def q(self) -> Array: ...
    @property
    def u(self) -> Array: ...
    @property
    def udot(self) -> Array: ...


@dataclass(frozen=True)
class Row:
    """A function of a kind.

    Attributes:
        kind, function: Which.
        operations: Of a call.
        alone, simd: Time of an element by itself, and of one of several in lanes [ns].
    """

    kind: str
    function: str
    operations: int
    alone: float
    simd: float


def measured(names: list[str], count: int = COUNT, rounds: int = ROUNDS) -> Iterator[Row]:
    """Rows of the kinds that are asked for."""
    with tempfile.TemporaryDirectory(prefix="cardan-elements-") as folder:
        for name in names:
            at = state(ELEMENTS[name])
            for function in FUNCTIONS:
                if function in at.functions:
                    yield _row(Path(folder), name, at, function, count, rounds)


def _row(folder: Path, name: str, at: State, function: str, count: int, rounds: int) -> Row:
    made = generate(at.functions[function])
    text = folder / f"{made.name}.c"
    text.write_text(made.text, encoding="utf-8")
    times = [
        timed(text, at, at.functions[function], made.entry, width, count, rounds)
        for width in (1, lanes.width())
    ]
    return Row(name, function, sum(made.entry["operations"].values()), *times)


def timed(
    text: Path,
    at: At,
    function: Function,
    entry: dict[str, int],
    width: int,
    count: int,
    rounds: int,
) -> float:
    """Nanoseconds of an element, the best of several rounds.

    Args:
        text: The C of the function.
        at: Where its elements are.
        function, entry: The function, and what the manifest says of it.
        width: How many go side by side.
        count, rounds: Elements of a round, and how often.
    """
    words = (f"-DCARDAN_LANES={width}", "-DCARDAN_LANE_PARAMETERS") if width > 1 else ()
    library = cache.build([text, DRIVER], kernel_files.includes(), False, extra=words).load()
    calls = count // width
    prepared = _filled(np.zeros(entry["prepared_size"]), calls, width)
    data = _filled(np.array(at.p), 1, width)
    prepare = library[f"prepare_{function.name}"]
    for k in range(calls):
        prepare(_at(data), ctypes.c_void_p(prepared.ctypes.data + k * prepared[0].nbytes))
    blocks = [_filled(x, calls, width) for x in (at.q, at.u, at.udot, np.ones(6))]
    out = _filled(np.zeros(entry["output_size"]), 1, width)
    work = _filled(np.zeros(entry["work_size"] + 1), 1, width)
    # few elements several times: a call from Python is not what is timed
    times = max(1, LEAST // calls)
    sizes = (len(at.q), len(at.u), entry["prepared_size"], calls, times)
    arguments = [*(_at(x) for x in (*blocks, prepared)), *map(ctypes.c_int, sizes)]
    address = ctypes.cast(library[function.name], ctypes.c_void_p)
    best = np.inf
    for _ in range(rounds):
        start = time.perf_counter()
        status = library.elements(address, *arguments, _at(out), _at(work))
        best = min(best, time.perf_counter() - start)
        assert status == 0
    assert np.all(np.isfinite(out))
    return float(best) / (times * calls * width) * 1e9


def _filled(numbers: Array, calls: int, width: int) -> Array:
    """The same numbers for all elements, those of lanes side by side, aligned as vectors are."""
    memory = np.empty(calls * len(numbers) * width + 8)
    skip = -memory.ctypes.data // 8 % 8
    aligned = memory[skip : skip + calls * len(numbers) * width].reshape(calls, -1, width)
    aligned[:] = numbers[:, None]
    return aligned


def _at(array: Array) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)


def table(rows: list[Row]) -> Table:
    """For the screen."""
    found = Table("element", "function", "operations", "ns", "ns in lanes", box=None)
    for row in rows:
        found.add_row(
            row.kind, row.function, str(row.operations), f"{row.alone:.1f}", f"{row.simd:.1f}"
        )
    return found


if __name__ == "__main__":
    Console(width=100).print(table(list(measured(sys.argv[1:] or list(ELEMENTS)))))
