"""Stability over two parameters: where paths of equilibria lose it, line by line.

Source: H. Ziegler, Principles of Structural Stability (1968), chapter 4 (stability maps).
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Count, LockedValues, checked
from ...arrays import Array
from ...errors import ModelError, SolveError, SolveWarning, counted
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ..simulation.progress import showing
from .continuation import POINTS, continuation
from .record import ContinuationRecord
from .special_points import EVENT

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class ChartPoint(NamedTuple):
    """A point of a chart.

    Attributes:
        kind: ``"fold"``, ``"branch point"`` or ``"Hopf point"``.
        along, across: The two parameters there.
        frequency: Of the oscillation that begins at a Hopf point [rad/s], else NaN.
    """

    kind: str
    along: float
    across: float
    frequency: float


@dataclass(frozen=True, repr=False, eq=False)
class StabilityChartRecord:
    """Boundaries at which equilibria lose their stability, over two parameters.

    Attributes:
        model: The model.
        along, across: Names of the parameters.
        values: Of the one across (n,).
        paths: The path along the other one at each of them; None where there is none.
        points: Where stability changes.
    """

    model: LoadedModel
    along: str
    across: str
    values: Array
    paths: Sequence[ContinuationRecord | None] = field(repr=False)
    points: Sequence[ChartPoint] = ()

    def line(self, kind: str, number: int = 1) -> tuple[Array, Array]:
        """The points of a kind that come as number 1, 2, ... on their paths.

        Returns:
            The parameter across (n,) and the one along (n,), NaN where there is none.
        """
        rows = [[p for p in self.points if p.kind == kind and p.across == x] for x in self.values]
        along = [row[number - 1].along if len(row) >= number else np.nan for row in rows]
        return self.values, np.array(along)

    @checked
    def plot(self, file: str | Path | None = None) -> Figure:
        """Draw the chart, stable parts shaded, as a Matplotlib figure; written to a file if given.

        Raises:
            ModelError: a file that is not a picture.
            ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
        """
        from ...view.plot import done, empty

        figure = empty((7, 5))
        axis = figure.subplots()
        for x, path in zip(self.values, self.paths, strict=True):
            if path is None:
                continue
            at, stable = path[self.along], path.main.stable
            for k in range(len(at) - 1):
                if stable[k] and stable[k + 1]:
                    axis.plot([x, x], at[k : k + 2], color="0.85", linewidth=6, zorder=0)
        for kind in dict.fromkeys(point.kind for point in self.points):
            number = 1
            while not np.isnan((line := self.line(kind, number))[1]).all():
                label = kind if number == 1 else None
                axis.plot(*line, "o-", markersize=3, label=label, linewidth=1.2)
                number += 1
        axis.set(xlabel=self.across, ylabel=self.along)
        if self.points:
            axis.legend()
        return done(figure, self.model.name, file)

    def __repr__(self) -> str:
        name, low, high = self.across, self.values[0], self.values[-1]
        lines = [f"stability chart of '{self.model.name}' over {self.along} and {self.across}"]
        for kind in dict.fromkeys(point.kind for point in self.points):
            of_kind = [point for point in self.points if point.kind == kind]
            least = min(of_kind, key=lambda point: point.along)
            lines.append(
                f"  {counted(len(of_kind), kind)} for {name} = {low:.6g} ... {high:.6g}; "
                f"the lowest at {self.along} = {least.along:.8g}, {name} = {least.across:.6g}"
            )
        return "\n".join(lines) if self.points else f"{lines[0]}: stability does not change"


@checked
def stability_chart(
    model: LoadedModel,
    along: Mapping[str, object],
    across: Mapping[str, object],
    *,
    q: Mapping[str, ArrayLike] | ArrayLike | None = None,
    locked: LockedValues | None = None,
    u: Mapping[str, object] | None = None,
    inputs: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    t: float = 0.0,
    points: Count = POINTS,
    progress: bool | Callable[[float], None] | None = None,
) -> StabilityChartRecord:
    """Boundaries at which equilibria lose their stability, over two parameters.

    ``model.stability_chart({"P": (0, 10)}, {"damping": np.linspace(0, 1, 20)})`` follows the
    equilibria over P at every value of the damping.

    Args:
        model: The compiled model.
        along: Parameter, input or speed -> (start, end), as ``model.continuation`` takes it; a
            speed is one of those in ``u``.
        across: Parameter -> values (n,).
        q, locked, u, inputs, parameters, t, points: As ``model.continuation`` takes them.
        progress: Show a bar; by default where standard error is a terminal.

    Returns:
        The chart; after Ctrl-C with the paths that were found.

    Raises:
        ModelError: unknown names, or none. SolveError: no equilibrium at any start.
    """
    if len(along) != 1 or len(across) != 1:
        raise ModelError("stability_chart: one name along, one across, such as {'P': (0, 10)}")
    (name, span), (other, column) = next(iter(along.items())), next(iter(across.items()))
    values = np.atleast_1d(np.asarray(column, dtype=np.float64))
    if values.ndim != 1 or not len(values):
        raise ModelError(f"stability_chart: {other}: give values (n,), such as [0, 0.5, 1]")
    speeds = {} if name in (*model.parameters, *model.inputs, "t") else {name: span}
    swept = None if speeds else {name: span}
    paths, marks, failed = list[ContinuationRecord | None](), list[ChartPoint](), ""
    with showing(progress, f"stability chart of '{model.name}'") as show:
        try:
            for k, value in enumerate(values):
                show(k / len(values))
                there = {**(parameters or {}), other: float(value)}
                moving = {**(u or {}), **speeds} or None
                try:
                    with warnings.catch_warnings():
                        warnings.simplefilter("ignore", SolveWarning)
                        path = continuation(
                            model, swept, q=q, locked=locked, u=moving, inputs=inputs,
                            parameters=there, t=t, points=points, progress=False,
                        )  # fmt: skip
                except SolveError as error:
                    paths.append(None)
                    failed = str(error)
                    continue
                paths.append(path)
                marks += [
                    ChartPoint(p.kind, p.values[name], float(value), p.frequency)
                    for p in path.points
                    if p.kind != EVENT
                ]
        except KeyboardInterrupt:
            if not paths:
                raise
    if not any(path is not None for path in paths):
        raise SolveError(failed)
    return StabilityChartRecord(model, name, other, values[: len(paths)], paths, marks)
