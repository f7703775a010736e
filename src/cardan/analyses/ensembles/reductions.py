"""Reductions of the histories of runs: numbers per run, and statistics over runs.

A reduction sees one block of runs at a time. Statistics of blocks are merged in the order of the
blocks, so that they have the same bits whoever computed which block, and when.
Source: T. F. Chan, G. H. Golub, R. J. LeVeque, Algorithms for computing the sample variance, 1983.
"""

from __future__ import annotations

import math
import re
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field
from typing import Any, NoReturn

import numpy as np

from ...arrays import Array, Booleans, Integers
from ...errors import ArgumentError, FunctionError, ModelError, brief, near
from ...records import dataclass

Parts = dict[str, Array]
FREE = -1  # in a shape: any axes from here on

OVER_TIME: dict[str, Callable[[Array], Array]] = {
    "max": lambda y: y.max(axis=1),
    "min": lambda y: y.min(axis=1),
    "range": lambda y: y.max(axis=1) - y.min(axis=1),
    "rms": lambda y: np.sqrt(np.square(y).mean(axis=1)),
    "last": lambda y: y[:, -1],
    "mean": lambda y: y.mean(axis=1),
}
OVER_RUNS = ("mean", "variance", "deviation", "min", "max")
USUAL = {"mean": "runs", "variance": "runs", "deviation": "runs"}
NUMBER = r"([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)"
HISTOGRAM = re.compile(rf"histogram of (.+) from {NUMBER} to {NUMBER} in (\d+)")
SPOKEN = re.compile(r"(\w+) of (.+?)(?: over (time|runs))?")
FORMS = (
    "'states', 'max of elbow' (max, min, range, rms, last, mean ... over time: one number per "
    "run), 'mean of elbow' (mean, variance, deviation, min, max ... over runs: one per output "
    "time), 'histogram of elbow from -1 to 1 in 50', or name=function(t, x)"
)


@dataclass(frozen=True)
class Histories:
    """Histories of a block of runs.

    Attributes:
        t: Output times (nt,).
        x: States (runs, nt, nx); NaN where a run had ended before.
        completed: Which runs reached their end, (runs,).
        ended: Which ended before, as an event wanted it, (runs,).
        of: ``of(name)``: history of a coordinate, speed, input or output (runs, nt).
        sensitivity: What states change by, by name: (runs, nt, nx, ...); NaN likewise.
    """

    t: Array
    x: Array
    completed: Booleans
    ended: Booleans
    of: Callable[[str], Array]
    sensitivity: Mapping[str, Array] = field(default_factory=dict)


class Reduction(ABC):
    """One thing that is kept.

    Attributes of members: ``per_run``: whether it has a value for every run; ``axes``: names of
    the axes of the result, ``run``, ``time``, ``entry`` or ``bin``; others follow those.
    """

    per_run: bool
    axes: tuple[str, ...]

    @abstractmethod
    def phrase(self) -> str:
        """The words that :func:`reductions` reads it from; none of a function."""

    @abstractmethod
    def part(self, block: Histories) -> Parts:
        """Contribution of a block."""

    @abstractmethod
    def shapes(self, runs: int, times: int, nx: int) -> dict[str, tuple[int, ...]]:
        """Shapes of the arrays of a part of so many runs; those behind ``FREE`` are free."""

    def merged(self, one: Parts, other: Parts) -> Parts:
        """Two parts as one; the blocks of the second follow those of the first."""
        raise AssertionError("values per run are not merged")

    def result(self, parts: Parts) -> Any:
        """The user's result from all parts."""
        return parts["value"]


@dataclass(frozen=True)
class States(Reduction):
    """The histories themselves (runs, nt, nx)."""

    per_run = True
    axes = ("run", "time", "entry")

    def phrase(self) -> str:
        """Same as :meth:`Reduction.phrase`."""
        return "states"

    def shapes(self, runs: int, times: int, nx: int) -> dict[str, tuple[int, ...]]:
        """Same as :meth:`Reduction.shapes`."""
        return {"value": (runs, times, nx)}

    def part(self, block: Histories) -> Parts:
        """States."""
        return {"value": block.x}


@dataclass(frozen=True)
class OverTime(Reduction):
    """A number of the history of every run."""

    kind: str
    name: str
    per_run = True
    axes = ("run",)

    def phrase(self) -> str:
        """Same as :meth:`Reduction.phrase`."""
        return f"{self.kind} of {self.name} over time"

    def shapes(self, runs: int, times: int, nx: int) -> dict[str, tuple[int, ...]]:
        """Same as :meth:`Reduction.shapes`."""
        return {"value": (runs,)}

    def part(self, block: Histories) -> Parts:
        """NaN for a run that broke down; of one that an event ended: up to there."""
        y = block.of(self.name)
        value = OVER_TIME[self.kind](y)
        for k in np.flatnonzero(block.ended):
            finite = y[k : k + 1, np.isfinite(y[k])]
            value[k] = OVER_TIME[self.kind](finite)[0] if finite.size else np.nan
        return {"value": value}


@dataclass(frozen=True)
class UserFunction(Reduction):
    """A user function of states (runs, nt, nx) -> (runs, ...)."""

    name: str
    function: Callable[[Array, Array], Any]
    per_run = True
    axes = ("run",)

    def phrase(self) -> str:
        """Same as :meth:`Reduction.phrase`."""
        return ""

    def shapes(self, runs: int, times: int, nx: int) -> dict[str, tuple[int, ...]]:
        """Same as :meth:`Reduction.shapes`."""
        return {"value": (runs, FREE)}

    def part(self, block: Histories) -> Parts:
        """Values of the function.

        Raises:
            ArgumentError: it does not give one value per run. FunctionError: it raised.
        """
        try:
            value = np.asarray(self.function(block.t, block.x), dtype=np.float64)
        except Exception as problem:
            raise FunctionError(
                f"reduce: the function of '{self.name}' raised for states {block.x.shape}: "
                f"{type(problem).__name__}: {problem}"
            ) from problem
        if value.shape[:1] != block.x.shape[:1]:
            raise ArgumentError(
                f"reduce: '{self.name}' of states {block.x.shape} gave an array of shape "
                f"{value.shape}; its first axis must be that of the runs, {len(block.x)} long"
            )
        return {"value": value}


@dataclass(frozen=True)
class OverRuns(Reduction):
    """A statistic at every output time, of the runs that reached their end."""

    kind: str
    name: str
    per_run = False
    axes = ("time",)

    def phrase(self) -> str:
        """Same as :meth:`Reduction.phrase`."""
        return f"{self.kind} of {self.name} over runs"

    def shapes(self, runs: int, times: int, nx: int) -> dict[str, tuple[int, ...]]:
        """Same as :meth:`Reduction.shapes`."""
        return {"count": (1,), **dict.fromkeys(("mean", "squares", "min", "max"), (times,))}

    def part(self, block: Histories) -> Parts:
        """Number of runs, mean, sum of squares about it, least and largest value."""
        y = block.of(self.name)[block.completed]
        mean = y.mean(axis=0) if len(y) else np.zeros(y.shape[1])
        return {
            "count": np.array([float(len(y))]),
            "mean": mean,
            "squares": np.square(y - mean).sum(axis=0),
            "min": y.min(axis=0, initial=np.inf),
            "max": y.max(axis=0, initial=-np.inf),
        }

    def merged(self, one: Parts, other: Parts) -> Parts:
        """Moments of both about the common mean."""
        count = one["count"] + other["count"]
        share = other["count"] / np.maximum(count, 1.0)
        difference = other["mean"] - one["mean"]
        return {
            "count": count,
            "mean": one["mean"] + difference * share,
            "squares": one["squares"] + other["squares"] + difference**2 * one["count"] * share,
            "min": np.minimum(one["min"], other["min"]),
            "max": np.maximum(one["max"], other["max"]),
        }

    def result(self, parts: Parts) -> Any:
        """The statistic (nt,); NaN if no run reached its end."""
        count = parts["count"][0]
        if not count:
            return np.full_like(parts["mean"], np.nan)
        if self.kind not in ("variance", "deviation"):
            return parts[self.kind]
        variance = parts["squares"] / (count - 1) if count > 1 else 0 * parts["squares"]
        return variance if self.kind == "variance" else np.sqrt(variance)


@dataclass(frozen=True)
class Bins:
    """A histogram.

    Attributes:
        counts: Runs in every bin, (n,).
        edges: Where bins begin and end, (n + 1,).
        below, above: Runs outside.
    """

    counts: Integers
    edges: Array
    below: int
    above: int


@dataclass(frozen=True)
class Histogram(Reduction):
    """Number of runs that end with a value in each bin."""

    name: str
    low: float
    high: float
    bins: int
    per_run = False
    axes = ("bin",)

    def phrase(self) -> str:
        """Same as :meth:`Reduction.phrase`."""
        return f"histogram of {self.name} from {self.low!r} to {self.high!r} in {self.bins}"

    def shapes(self, runs: int, times: int, nx: int) -> dict[str, tuple[int, ...]]:
        """Same as :meth:`Reduction.shapes`."""
        return {"value": (self.bins + 2,)}

    def part(self, block: Histories) -> Parts:
        """Counts."""
        y = block.of(self.name)[block.completed, -1]
        counts, _ = np.histogram(y, self.bins, (self.low, self.high))
        outside = [(y < self.low).sum(), (y > self.high).sum()]
        return {"value": np.concatenate([counts, outside]).astype(np.float64)}

    def merged(self, one: Parts, other: Parts) -> Parts:
        """Counts of both."""
        return {"value": one["value"] + other["value"]}

    def result(self, parts: Parts) -> Any:
        """The counts with their bins."""
        counts = parts["value"].astype(np.intp)
        edges = np.linspace(self.low, self.high, self.bins + 1)
        return Bins(counts[:-2], edges, int(counts[-2]), int(counts[-1]))


def reductions(
    requested: str | Sequence[str] | Mapping[str, object] | None,
    histories: Sequence[str],
    listed: bool,
) -> dict[str, Reduction]:
    """Reductions by name.

    Args:
        requested: Words; several; or name -> words or a function of (t, x).
        histories: Names that have histories.
        listed: Whether the user gave output times: then the states there are kept by default.

    Raises:
        ModelError: words that mean nothing, an unknown name. ArgumentError: not a reduction.
    """
    if requested is None:
        requested = ["states"] if listed else []
    if isinstance(requested, str):
        requested = [requested]
    if not isinstance(requested, Iterable):
        raise ArgumentError(f"reduce={brief(requested)}: it may be {FORMS}")
    rows = requested if isinstance(requested, Mapping) else {str(word): word for word in requested}
    reductions: dict[str, Reduction] = {}
    for name, what in rows.items():
        if callable(what):
            reductions[name] = UserFunction(name, what)
        elif not isinstance(what, str):
            raise ArgumentError(f"reduce: '{name}' is {brief(what)}; it may be {FORMS}")
        elif what != "final":
            # the last states are kept anyway
            reductions[name] = _read(what, histories)
    return reductions


def reread(phrases: Mapping[str, str]) -> dict[str, Reduction]:
    """Reductions by name, to put parts of them together, from their phrases.

    Raises:
        ModelError: words that mean nothing.
    """
    return {
        name: _read(phrase, None) if phrase else UserFunction(name, _elsewhere)
        for name, phrase in phrases.items()
    }


def _elsewhere(t: Array, x: Array) -> NoReturn:
    raise AssertionError("what a function gave is read, not computed again")


def _read(phrase: str, histories: Sequence[str] | None) -> Reduction:
    text = " ".join(phrase.split())
    if text == "states":
        return States()
    histogram, spoken = HISTOGRAM.fullmatch(text), SPOKEN.fullmatch(text)
    if histogram:
        name, low, high, bins = histogram.groups()
        return _histogram(phrase, _checked_name(phrase, name, histories), low, high, int(bins))
    if not spoken or spoken[1] not in (*OVER_TIME, *OVER_RUNS):
        raise ModelError(f"reduce: '{phrase}' is not a reduction: it may be {FORMS}")
    kind, name, axis = spoken.groups()
    axis = axis or USUAL.get(kind, "time")
    if kind not in (OVER_TIME if axis == "time" else OVER_RUNS):
        raise ModelError(f"reduce: '{phrase}': there is no {kind} over {axis}. It may be {FORMS}")
    name = _checked_name(phrase, name, histories)
    return OverTime(kind, name) if axis == "time" else OverRuns(kind, name)


def _checked_name(phrase: str, name: str, histories: Sequence[str] | None) -> str:
    if histories is not None and name not in histories:
        raise ModelError(
            f"reduce: '{phrase}': there is no history '{name}'.{near(name, histories)}"
        )
    return name


def _histogram(phrase: str, name: str, low: str, high: str, bins: int) -> Histogram:
    try:
        ends = float(low), float(high)
    except ValueError:
        ends = math.nan, math.nan
    if not (math.isfinite(ends[0]) and ends[0] < ends[1] < math.inf and 1 <= bins <= 1_000_000):
        raise ModelError(
            f"reduce: '{phrase}': bins go from a lower to a higher number, in 1 or more"
        )
    return Histogram(name, *ends, bins)
