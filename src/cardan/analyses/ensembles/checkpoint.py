"""Finished blocks of runs in a file that only grows.

Its records: whose it is, what was requested, a block each, and at last what the energy of the runs
showed. It holds all that :func:`.joining.join` needs to put parts together without a model.
"""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from ...version import ENSEMBLE_FILE
from ..simulation.files.append_log import AppendLog, packed, text, unpacked
from .energy_check import CRITERIA, EnergyCheck
from .job import BlockResult, Sizes
from .lane_runner import NUMBERS
from .reductions import FREE
from .share import Block

WORD = re.compile(r"[a-z_]{1,40}")  # of a status
CURES = {
    "model": "it was computed with another model",
    "build": (
        "it was computed with another compiler, processor or version of the integrators, whose "
        "last digits differ (compile with reproducible=True, --reproducible, where they should not)"
    ),
    "plan": "its runs start elsewhere or have other parameters or inputs",
    "settings": "it has another time, method or tolerance",
    "reductions": "it keeps other reductions",
    "part": "it is another part of the runs",
}
DAMAGE = (ValueError, KeyError, TypeError, IndexError, AttributeError, RecursionError)


class Checkpoint:
    """An open file of finished blocks; one process at a time.

    Attributes:
        path: The file.
        runs: How many runs are known to be in it.
        closed: Whether it has everything, up to the checks of energy.
    """

    def __init__(self, path: Path, whose: Mapping[str, str], request: bytes, locked: bool) -> None:
        """Open or begin a file.

        Args:
            path: The file.
            whose: Hashes of model, build, plan, settings and reductions, and the part.
            request: What is asked for, as its second record.
            locked: Against other processes.

        Raises:
            ModelError: it belongs to other runs or another process, or is no such file.
        """
        self.path, self.runs, self.closed = path, 0, False
        self._request = request
        self._file = AppendLog(path, ENSEMBLE_FILE, whose, CURES, locked)

    def close(self) -> None:
        """Let others have the file."""
        self._file.close()

    def block_results(self, sizes: Sizes, left: Collection[Block]) -> Iterator[BlockResult]:
        """The blocks that are in the file; what was cut off behind them is removed.

        Args:
            sizes: Of the answers.
            left: Blocks that are not computed yet; it shrinks meanwhile.

        Raises:
            ModelError: a block is not one of these runs.
        """
        contents = self._file.contents()
        request = next(contents, None)
        if request is None:
            self._file.add(self._request)
            return
        try:
            if request != self._request:
                raise ValueError("it has another request")
            for content in contents:
                arrays = unpacked(content)
                if "checks" in arrays:
                    self.closed = bool(checks_in(arrays, sizes.runs) is not None)
                    continue
                block_result = block_in(arrays, sizes)
                if (block_result.first, block_result.last) not in left:
                    raise ValueError(f"it has runs {block_result.first} to {block_result.last - 1}")
                self.runs += len(block_result.x)
                yield block_result
        except DAMAGE as error:
            raise ModelError(
                f"checkpoint {self.path} holds a block that is none of these runs: {error}. "
                "Name another file, or remove it to begin anew"
            ) from None

    def add(self, block_result: BlockResult) -> None:
        """Put a finished block on the disk.

        Raises:
            SolveError: there is no room for it.
        """
        self._file.add(packed(_arrays(block_result)))
        self.runs += len(block_result.x)

    def finish(self, checks: Sequence[EnergyCheck]) -> None:
        """Put on the disk that all runs are there, and what their energy showed.

        Raises:
            SolveError: there is no room for it.
        """
        if not self.closed:
            self._file.add(packed({"checks": text([list(one) for one in checks])}))
            self.closed = True


def _arrays(block_result: BlockResult) -> dict[str, object]:
    """A block as arrays by name."""
    arrays: dict[str, object] = {
        "first": np.array(block_result.first),
        "x": block_result.x,
        "status": block_result.status,
        "numbers": block_result.numbers,
        "messages": text(block_result.messages),
        "warnings": text(block_result.warnings),
        "names": text(list(block_result.parts)),
    }
    for k, parts in enumerate(block_result.parts.values()):
        arrays |= {f"part {k} {name}": value for name, value in parts.items()}
    return arrays


def block_in(arrays: Mapping[str, Any], sizes: Sizes) -> BlockResult:
    """The block of a record, which fits the sizes of an ensemble.

    Raises:
        ValueError, or another of ``DAMAGE``: it does not.
    """
    names = json.loads(arrays["names"].tobytes())
    # a damaged key raises one of the errors that mean damage
    parts: dict[str, dict[str, Array]] = {name: {} for name in names}
    for key, value in arrays.items():
        word, _, label = key.partition(" ")
        if word == "part":
            k, _, name = label.partition(" ")
            parts[names[int(k)]][name] = value
    first = arrays["first"]
    if first.dtype.kind != "i" or first.size != 1:
        raise ValueError("it has no place")
    block_result = BlockResult(
        int(first),
        arrays["x"],
        arrays["status"],
        arrays["numbers"],
        _by_run(arrays["messages"]),
        parts,
        _by_run(arrays["warnings"]),
    )
    _check(block_result, sizes)
    return block_result


def _by_run(letters: Array) -> dict[int, Any]:
    by_run = json.loads(letters.tobytes())
    if not isinstance(by_run, dict):
        raise ValueError("it has no messages")
    return {int(k): one for k, one in by_run.items()}


def checks_in(arrays: Mapping[str, Array], runs: int) -> tuple[EnergyCheck, ...]:
    """The checks of energy of a record.

    Raises:
        ValueError, or another of ``DAMAGE``: they are none.
    """
    rows = json.loads(arrays["checks"].tobytes())
    if not isinstance(rows, list) or len(rows) > sum(CRITERIA.values()):
        raise ValueError("it holds no checks of energy")
    checks = tuple(EnergyCheck(*row) for row in rows)
    for one in checks:
        number = type(one.score) in (int, float) and type(one.run) is int
        if not number or one.criterion not in CRITERIA or not 0 <= one.run < runs:
            raise ValueError("a check of energy is of none of its runs")
        one.text.encode()
    return checks


def _check(block_result: BlockResult, sizes: Sizes) -> None:
    """Refuse what no block of an ensemble is.

    Raises:
        ValueError: it has arrays of another size or kind.
    """
    count = len(block_result.x)
    if not count or not 0 <= block_result.first <= block_result.last <= sizes.runs:
        raise ValueError(f"it has runs {block_result.first} to {block_result.last - 1}")
    _array("x", block_result.x, (count, sizes.nx))
    _array("numbers", block_result.numbers, (count, len(NUMBERS)))
    status = block_result.status
    statuses = status.tolist() if status.dtype.kind == "U" and status.shape == (count,) else [""]
    if not all(isinstance(word, str) and WORD.fullmatch(word) for word in statuses):
        raise ValueError("its status is none")
    said = [(k, [one]) for k, one in block_result.messages.items()]
    for k, texts in [*said, *block_result.warnings.items()]:
        if not block_result.first <= k < block_result.last or not isinstance(texts, list):
            raise ValueError("a message is of none of its runs")
        for one in texts:
            one.encode()
    if list(block_result.parts) != list(sizes.reductions):
        raise ValueError("it keeps other reductions")
    for name, reduction in sizes.reductions.items():
        parts = block_result.parts[name]
        shapes = reduction.shapes(count, sizes.times, sizes.nx)
        if set(parts) != set(shapes):
            raise ValueError(f"'{name}' has other parts")
        for part, shape in shapes.items():
            _array(f"'{name}'", parts[part], shape)


def _array(name: str, array: Any, shape: tuple[int, ...]) -> None:
    """Refuse what is not numbers of a shape, which may go on where it ends in ``FREE``."""
    actual = array.shape
    fixed = actual[: len(shape) - 1] + shape[-1:] if shape[-1:] == (FREE,) else actual
    if array.dtype != np.float64 or fixed != shape:
        raise ValueError(f"{name} has shape {actual}")
