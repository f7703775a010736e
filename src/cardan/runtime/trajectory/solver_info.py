"""Solver info of a run."""

from __future__ import annotations

from ...records import dataclass

FINISHED, EVENT = "finished", "event"


@dataclass(frozen=True)
class SolverInfo:
    """Method, settings, status and statistics of a run.

    Attributes:
        method: Integrator.
        settings: Its tolerances or step, as words to print.
        initial: Named initial value of every coordinate and speed.
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
    initial: dict[str, float]
    defaulted: tuple[str, ...]
    status: str
    message: str
    statistics: dict[str, float]
    reason: str = ""
    warning: str = ""
