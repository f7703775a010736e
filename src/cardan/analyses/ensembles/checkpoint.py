"""Finished blocks of runs in a file that only grows."""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import ModelError
from ...version import ENSEMBLE_FILE
from ..simulation.files.append_log import AppendLog, packed, text, unpacked
from .executors import Block
from .job import BlockResult, Job
from .lane_runner import NUMBERS
from .reductions import FREE

WORD = re.compile(r"[a-z_]{1,40}")  # of a status
CURES = {
    "model": "it was computed with another model",
    "build": "it was computed with another compiler, processor or version of the integrators",
    "plan": "its runs start elsewhere or have other parameters or inputs",
    "settings": "it has another time, method or tolerance",
    "reductions": "it keeps other reductions",
}


class Checkpoint:
    """An open file of finished blocks; one process at a time.

    Attributes:
        path: The file.
        runs: How many runs are known to be in it.
    """

    def __init__(self, path: Path, whose: dict[str, str]) -> None:
        """Open or begin a file.

        Args:
            path: The file.
            whose: Hashes of model, build, plan, settings and reductions.

        Raises:
            ModelError: it belongs to other runs or another process, or is no such file.
        """
        self.path, self.runs = path, 0
        self._file = AppendLog(path, ENSEMBLE_FILE, whose, CURES)

    def close(self) -> None:
        """Let others have the file."""
        self._file.close()

    def block_results(self, job: Job, left: Collection[Block]) -> Iterator[BlockResult]:
        """The blocks that are in the file; what was cut off behind them is removed.

        Args:
            job: What the blocks are of.
            left: Blocks that are not computed yet; it shrinks meanwhile.

        Raises:
            ModelError: a block is not one of this job's.
        """
        for content in self._file.contents():
            try:
                block_result = _block_result(unpacked(content))
                _check(block_result, job, left)
            except (ValueError, KeyError, TypeError, IndexError, RecursionError) as error:
                raise ModelError(
                    f"checkpoint {self.path} holds a block that is none of these runs: {error}. "
                    "Name another file, or remove it to begin anew"
                ) from None
            self.runs += len(block_result.x)
            yield block_result

    def add(self, block_result: BlockResult) -> None:
        """Put a finished block on the disk.

        Raises:
            SolveError: there is no room for it.
        """
        self._file.add(packed(_arrays(block_result)))
        self.runs += len(block_result.x)


def _arrays(block_result: BlockResult) -> dict[str, Any]:
    """A block as arrays by name."""
    arrays: dict[str, Any] = {
        "first": np.array(block_result.first),
        "x": block_result.x,
        "status": block_result.status,
        "numbers": block_result.numbers,
        "messages": text(block_result.messages),
        "names": text(list(block_result.parts)),
    }
    for k, parts in enumerate(block_result.parts.values()):
        arrays |= {f"part {k} {name}": value for name, value in parts.items()}
    return arrays


def _block_result(arrays: dict[str, Any]) -> BlockResult:
    names = json.loads(arrays["names"].tobytes())
    parts: dict[str, dict[str, Any]] = {name: {} for name in names}
    for key, value in arrays.items():
        word, _, label = key.partition(" ")
        if word == "part":
            k, _, name = label.partition(" ")
            parts[names[int(k)]][name] = value
    messages = json.loads(arrays["messages"].tobytes())
    if not isinstance(messages, dict) or not isinstance(names, list):
        raise ValueError("it has no messages")
    first = arrays["first"]
    if first.dtype.kind != "i" or first.size != 1:
        raise ValueError("it has no place")
    return BlockResult(
        int(first),
        arrays["x"],
        arrays["status"],
        arrays["numbers"],
        {int(k): message for k, message in messages.items()},
        parts,
    )


def _check(block_result: BlockResult, job: Job, left: Collection[Block]) -> None:
    """Refuse what no block of a job is.

    Raises:
        ValueError: it is elsewhere, or has arrays of another size or kind.
    """
    count, nx = len(block_result.x), job.model.nx
    times = 0 if job.over.times is None else len(job.over.times)
    if (block_result.first, block_result.last) not in left:
        raise ValueError(f"it has runs {block_result.first} to {block_result.last - 1}")
    _array("x", block_result.x, (count, nx))
    _array("numbers", block_result.numbers, (count, len(NUMBERS)))
    status = block_result.status
    statuses = status.tolist() if status.dtype.kind == "U" and status.shape == (count,) else [""]
    if not all(isinstance(word, str) and WORD.fullmatch(word) for word in statuses):
        raise ValueError("its status is none")
    for k, message in block_result.messages.items():
        if not block_result.first <= k < block_result.last or not isinstance(message, str):
            raise ValueError("a message is of none of its runs")
        message.encode()
    if list(block_result.parts) != list(job.reductions):
        raise ValueError("it keeps other reductions")
    for name, reduction in job.reductions.items():
        parts, shapes = block_result.parts[name], reduction.shapes(count, times, nx)
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
