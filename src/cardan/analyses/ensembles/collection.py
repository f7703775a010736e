"""Blocks of runs put together: values by number of the run, statistics in the order of blocks."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Mapping
from dataclasses import field, replace
from typing import Any

import numpy as np

from ...arrays import Array, Booleans
from ...errors import ArgumentError, ModelError, counted
from ...records import dataclass
from .energy_check import EnergyCheck
from .job import BlockResult, Job, Sizes
from .lane_runner import NUMBERS
from .reductions import Parts, States

MOTION = re.compile(r"\bmotion\.(?=\w)")
NUMBER = re.compile(r"-?\d[-+.\de]*")
MESSAGES = 1000  # that are kept as text; the others are told by run(i)
UNFINISHED = ("not_run", "interrupted")
LESS = "Keep less: reduce='max of ...', 'mean of ...', or fewer runs at once"
SHARE = 0.5  # of the memory of the machine that states may take


@dataclass(frozen=True)
class PartResults:
    """What an ensemble of a part has to be joined with the others.

    Attributes:
        whose: Hashes of model, build, plan, settings and reductions, by name.
        sizes: Of the answers.
        block_results: In the order of runs.
        checks: Of energy, once all runs were done; None before.
        source: What the runs of the whole are computed again from.
    """

    whose: Mapping[str, str]
    sizes: Sizes
    block_results: tuple[BlockResult, ...] = field(repr=False)
    checks: tuple[EnergyCheck, ...] | None
    source: Job = field(repr=False)


class Gathered:
    """Room for the answers of all runs.

    Attributes:
        x: Last states (runs, nx).
        codes: Status per run as an index in ``status_names``.
        numbers: (runs, 4).
        per_run: Reductions with a value per run.
    """

    def __init__(self, sizes: Sizes) -> None:
        """Make room.

        Args:
            sizes: Of the answers.

        Raises:
            ModelError: there is none for so many states.
        """
        runs = sizes.runs
        self.sizes, self.done = sizes, 0
        _refuse_too_much(sizes)
        self.x = _room((runs, sizes.nx))
        self.status_names = ["not_run", "finished"]
        self.codes = np.zeros(runs, dtype=np.int8)
        self.numbers = np.zeros((runs, len(NUMBERS)))
        self.numbers[:, 0] = np.nan
        # a message speaks of the motion of a single run: that of an ensemble is run(k)
        self._texts: dict[int, str] = {}
        self.warnings: dict[int, list[str]] = {}
        self.per_run: dict[str, Array] = {}
        self._merged: dict[str, Parts] = {}
        # statistics of blocks whose predecessors are still to come
        self._early: dict[int, tuple[int, dict[str, Parts]]] = {}
        self._next = 0

    def add(self, block_result: BlockResult) -> BlockResult:
        """A block; returns the same, with arrays that are those of the answers."""
        here = slice(block_result.first, block_result.last)
        self.x[here], self.numbers[here] = block_result.x, block_result.numbers
        for word in np.unique(block_result.status).tolist():
            if word not in self.status_names:
                self.status_names.append(word)
            self.codes[here][block_result.status == word] = self.status_names.index(word)
        self.add_messages(block_result.messages)
        self.warnings |= block_result.warnings
        self.done += int(np.isin(block_result.status, UNFINISHED, invert=True).sum())
        partial: dict[str, Parts] = {}
        for name, reduction in self.sizes.reductions.items():
            parts = block_result.parts[name]
            if not reduction.per_run:
                partial[name] = parts
                continue
            value = parts["value"]
            if name not in self.per_run:
                shape = (self.sizes.runs, *value.shape[1:])
                self.per_run[name] = _room(shape)
            if value.shape[1:] != self.per_run[name].shape[1:]:
                raise ArgumentError(
                    f"reduce: '{name}' has shape {value.shape[1:]} for run {block_result.first}, "
                    f"{self.per_run[name].shape[1:]} for others; it must be the same for all"
                )
            self.per_run[name][here] = value
        self._early[block_result.first] = block_result.last, partial
        # merged in order of runs, whichever thread was first: sums have the same bits
        while self._next in self._early:
            self._merge(self._next)
        shared = {name: {"value": values[here]} for name, values in self.per_run.items()}
        return replace(
            block_result,
            x=self.x[here],
            numbers=self.numbers[here],
            parts={**block_result.parts, **shared},
        )

    @property
    def finished(self) -> Booleans:
        """Mask of the runs that reached their end (runs,)."""
        done: Booleans = self.codes == self.status_names.index("finished")
        return done

    def add_messages(self, messages: Mapping[int, str]) -> None:
        """Keep what is to be said of runs, by their numbers: of the first ones."""
        self._texts |= messages
        if len(self._texts) > 2 * MESSAGES:
            self._texts = self._first_texts()

    def _first_texts(self) -> dict[int, str]:
        return {k: self._texts[k] for k in sorted(self._texts)[:MESSAGES]}

    @property
    def messages(self) -> dict[int, str]:
        """What is to be said of the first runs, by their numbers."""
        texts = self._first_texts()
        return {k: MOTION.sub(f"runs.run({k}).", text) for k, text in texts.items()}

    def merged_warnings(self) -> list[str]:
        """One message for all warnings that differ in numbers only."""
        alike: dict[str, list[tuple[int, str]]] = {}
        for k in sorted(self.warnings):
            for text in dict.fromkeys(self.warnings[k]):
                alike.setdefault(NUMBER.sub("", text), []).append((k, text))
        runs = self.sizes.runs
        return [
            f"{len(same)} of {counted(runs, 'run')}: {same[0][1]} (run {same[0][0]}"
            f"{', the first' if len(same) > 1 else ''})"
            for same in alike.values()
        ]

    def _merge(self, first: int) -> None:
        self._next, parts = self._early.pop(first)
        for name, part in parts.items():
            before = self._merged.get(name)
            merged = part if before is None else self.sizes.reductions[name].merged(before, part)
            self._merged[name] = merged

    def results(self) -> Mapping[str, Any]:
        """Every reduction by name; of what was computed."""
        # after an interruption there are gaps
        for first in sorted(self._early):
            self._merge(first)
        results: dict[str, Any] = {}
        for name, reduction in self.sizes.reductions.items():
            if reduction.per_run and name in self.per_run:
                results[name] = self.per_run[name]
            elif name in self._merged:
                results[name] = reduction.result(self._merged[name])
        return results


def _room(shape: tuple[int, ...]) -> Array:
    """Room for values of all runs, NaN as long as there are none.

    Raises:
        ModelError: this process may not have so much memory.
    """
    try:
        return np.full(shape, np.nan)
    except MemoryError:
        raise ModelError(
            f"what is kept of {shape[0]} runs takes {8 * math.prod(shape) / 1e9:.3g} GB, which "
            f"this process has no memory for. {LESS}"
        ) from None


def _refuse_too_much(sizes: Sizes) -> None:
    """Refuse to keep more states than the memory can hold, before anything is computed."""
    # what has an entry of the state at every time: these, and their sensitivities
    histories = sum(
        math.prod(one.shapes(1, sizes.times, sizes.nx)["value"])
        for one in sizes.reductions.values()
        if one.axes == States.axes
    )
    size = 8 * sizes.runs * (sizes.nx + histories)
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    if size > SHARE * memory:
        raise ModelError(
            f"the states of {sizes.runs} runs at {sizes.times + 1} times take {size / 1e9:.3g} GB, "
            f"this machine has {memory / 1e9:.3g} GB. {LESS}"
        )
