"""Solver info of a run."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from itertools import chain

from ...arrays import Array
from ...records import dataclass

FINISHED, EVENT = "finished", "event"


class NamedValues(Mapping[str, float]):
    """Numbers by their names, which are put together when the first is asked for: of a large model
    that takes longer than a step."""

    def __init__(self, names: Sequence[Sequence[str]], values: Array) -> None:
        """Names in blocks that follow each other, and the numbers of all."""
        self._names = tuple(names)
        self._values = values

    @cached_property
    def _entries(self) -> dict[str, float]:
        names = chain.from_iterable(self._names)
        return dict(zip(names, self._values.tolist(), strict=True))

    def __getitem__(self, name: str) -> float:
        return self._entries[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._entries)

    def __len__(self) -> int:
        return len(self._entries)

    def __repr__(self) -> str:
        return repr(self._entries)


@dataclass(frozen=True)
class SolverInfo:
    """Method, settings, status and statistics of a run.

    Attributes:
        method: Integrator.
        settings: Its tolerances or step, as words to print.
        initial: Initial value of every coordinate, speed, internal state and input, by name.
        defaulted: Those that the caller did not give.
        status: ``finished``, ``event`` (one ended the run), ``interrupted``, ``function_failed``,
            ``event_storm``, ``chatter``, ``step_too_small``, ``step_too_long``,
            ``singular_rotation``, ``not_solved``, ``not_finite``, ``not_closed``,
            ``model_failed`` or ``too_large``.
        message: The same as a sentence, with time and coordinate.
        reason: Why this method, or what another one would do better.
        statistics: steps, rejections, evaluations, milliseconds.
        warning: What the run misses far beyond its tolerance, "" where it keeps to it.
    """

    method: str
    settings: str
    initial: Mapping[str, float]
    defaulted: tuple[str, ...]
    status: str
    message: str
    statistics: dict[str, float]
    reason: str = ""
    warning: str = ""
