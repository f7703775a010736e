"""Speed against error of the integrators on one motion: the numbers, a table, a recommendation."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ....arguments import checked
from ....records import dataclass
from ....schema.integrators import INTEGRATORS

if TYPE_CHECKING:
    from rich.table import Table

GOALS = (1e-3, 1e-6, 1e-9)  # errors for which a method is recommended
STIFF = 0.5  # share of steps that stability limits, from which on it matters


@dataclass(frozen=True)
class Point:
    """One method at one setting.

    Attributes:
        method: Its name.
        setting: What was varied, ``rtol`` or ``step``, and
        value: its number.
        status: How the run ended.
        error: Largest error of a coordinate at the output times, in their units; inf where the
            run did not reach its end.
        milliseconds: Least of some runs [ms].
        steps, evaluations: Steps, and right-hand sides with all that stands for them.
        limited: Share of its steps that stability limited, of those that were looked at.
    """

    method: str
    setting: str
    value: float
    status: str
    error: float
    milliseconds: float
    steps: int
    evaluations: int
    limited: float = 0.0

    @property
    def description(self) -> str:
        """Method and setting, as one passes them."""
        return f"{self.method}, {self.setting}={self.value:.2g}"


@dataclass(frozen=True)
class PrecisionRecord:
    """Speed against error of every integrator that applies.

    Attributes:
        model: Name of the model.
        span: Start and end of the motion [s].
        points: What was measured, method by method from rough to fine.
        reference: What errors are taken from, in words.
        doubt: By how much two references differ: smaller errors mean nothing.
        left_out: Method -> why it was not measured, or not to the end.
        interrupted: Whether somebody stopped the measuring.
        undetermined: Reactions that the constraints do not determine where the motion begins.
    """

    model: str
    span: tuple[float, float]
    points: tuple[Point, ...]
    reference: str
    doubt: float
    left_out: dict[str, str] = field(default_factory=dict)
    interrupted: bool = False
    undetermined: tuple[str, ...] = ()

    def best(self, error: float) -> tuple[Point, ...]:
        """The quickest setting of each method that keeps an error, the quickest method first."""
        quickest: dict[str, Point] = {}
        for point in self.points:
            accurate = max(point.error, self.doubt) <= error
            fastest = quickest.get(point.method)
            if accurate and (fastest is None or point.milliseconds < fastest.milliseconds):
                quickest[point.method] = point
        return tuple(sorted(quickest.values(), key=lambda point: point.milliseconds))

    @property
    def still(self) -> bool:
        """True when nothing moves from the start: no run has an error."""
        return bool(self.points) and not any(point.error for point in self.points)

    @property
    def recommendation(self) -> str:
        """Recommended method for every error level, with reasons."""
        return "\n".join(self._sentences())

    def _sentences(self) -> Iterator[str]:
        if self.still:
            yield "nothing moves from this start, so that there is no error: give another q or u"
            return
        for goal in GOALS:
            fastest = self.best(goal)
            if not fastest:
                yield f"for an error of {goal:.0e}: nothing that was measured reaches it"
                continue
            first = fastest[0]
            sentence = (
                f"for an error of {goal:.0e}: {first.description}: {first.milliseconds:.3g} ms, "
                f"{first.evaluations} evaluations, error {first.error:.0e}"
            )
            if len(fastest) > 1:
                ratio = fastest[1].milliseconds / first.milliseconds
                sentence += f"; next {fastest[1].description}: {ratio:.3g}x the time"
            yield sentence
        yield from self._reasons()

    def _reasons(self) -> Iterator[str]:
        """Strengths of the recommended methods, and a remark on stiffness."""
        chosen = dict.fromkeys(fastest[0].method for goal in GOALS if (fastest := self.best(goal)))
        for name in chosen:
            yield f"{name}: {INTEGRATORS[name].applies}"
        stiff = [point for point in self.points if point.limited > STIFF]
        if stiff:
            most = max(stiff, key=lambda point: point.limited)
            yield (
                f"the motion is stiff: stability limited {100 * most.limited:.0f} % of the steps "
                f"of {most.description}"
            )

    def table(self) -> Table:
        """The table for the terminal; a motion at rest has one setting of each method."""
        from rich.table import Table

        first, last = self.span
        title = f"{self.model}: {first:g} s to {last:g} s"
        table = Table(title=title, caption=f"errors from {self.reference}")
        for name in ("method", "setting"):
            table.add_column(name, no_wrap=True)
        for name in ("error", "ms", "steps", "evaluations"):
            table.add_column(name, justify="right", no_wrap=True)
        before = ""
        loosest = {point.method: point for point in reversed(self.points)}
        points = [p for p in self.points if not self.still or loosest[p.method] is p]
        for point in points:
            done = point.status == "finished"
            table.add_row(
                point.method if point.method != before else "",
                f"{point.setting} {point.value:.2g}",
                f"{point.error:.1e}" if done else point.status,
                f"{point.milliseconds:.3g}",
                str(point.steps),
                str(point.evaluations),
            )
            before = point.method
        return table


@checked
def plot(precision: PrecisionRecord, path: str | Path | None = None) -> Any:
    """Draw time over error, a line per method.

    Args:
        path: Picture file, or None.

    Returns:
        The Matplotlib figure.

    Raises:
        ModuleNotFoundError: Matplotlib is not installed.
    """
    from ....view.plot import plot_lines

    lines = {}
    for method in dict.fromkeys(point.method for point in precision.points):
        points = [p for p in precision.points if p.method == method and 0 < p.error < float("inf")]
        lines[method] = ([p.error for p in points], [p.milliseconds for p in points])
    title = f"{precision.model}: {precision.span[0]:g} s to {precision.span[1]:g} s"
    if precision.still:
        title += "\nnothing moves from this start: there is no error to draw"
    return plot_lines(title, "largest error of a coordinate", "time [ms]", lines, path)
