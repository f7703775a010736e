"""Motions from which inertial parameters can be told as well as possible.

Source: Swevers, Ganseman, Tukel, De Schutter and Van Brussel, Optimal Robot Excitation and
Identification, IEEE Trans. Robotics and Automation 13 (1997); Gautier and Khalil, Exciting
Trajectories for the Identification of Base Inertial Parameters of Robots, Int. J. Robotics
Research 11 (1992), for the condition of the regressor as a measure.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...arguments import Count, Seed, Times, checked
from ...arrays import Array
from ...errors import ArgumentError, SolveError, near
from ...records import dataclass
from ..mechanisms.actuation import named_speeds
from ..simulation.progress import showing
from .base_parameters import REQUIRED, Base, base_parameters, circuits, needed
from .data import is_plain, named_columns, write
from .fourier import Limits, Series, feasible

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ...runtime.models.loaded_model import LoadedModel

CRITERIA = ("condition", "determinant")
# samples per harmonic at which the regressor is judged
SAMPLES = 12
# limits of joints that have none: a turn, and speeds of a robot of human size
TURN, FAST = np.pi, 2.0
LONGEST = 1e9  # period [s]
MOST_SAMPLES = 10**7  # that a motion is told by
STEP = 1e-6  # of the free numbers, for derivatives
FLAT = 1e-4  # relative change of the measure below which the search ends


@dataclass(frozen=True, repr=False, eq=False)
class ExcitationRecord:
    """A periodic motion of all joints.

    Attributes:
        model: Whose joints move.
        series: Coefficients of the motion.
        limits: Those that it keeps.
        base: The base parameters it is meant to tell.
        before, condition: Condition of the scaled base regressor, at the best motion by chance and
            at this one.
    """

    model: LoadedModel
    series: Series
    limits: Limits
    base: Base = field(repr=False)
    before: float
    condition: float

    @property
    def period(self) -> float:
        """Period of the motion [s]."""
        return self.series.period

    @property
    def harmonics(self) -> int:
        """Number of harmonics of the series: ``identify(..., period=, harmonics=)`` takes both."""
        return int(self.series.a.shape[-1])

    @checked
    def at(self, t: Times) -> tuple[Array, Array, Array]:
        """q, u and udot (m, nu) at times (m,)."""
        return self.series.at(np.atleast_1d(np.asarray(t, dtype=float)))

    @checked
    def motion(self, rate: float = 100.0, periods: Count = 1) -> dict[str, Array]:
        """Samples as ``t q u udot``, for ``model.torques`` and as a table.

        Args:
            rate: Samples per second [Hz]. periods: How many.
        """
        samples = rate * self.period * periods
        if not 1 <= samples <= MOST_SAMPLES:
            raise ArgumentError(
                f"motion: rate={rate:g} Hz over {periods} times {self.period:g} s are "
                f"{samples:.3g} samples; give a rate and periods of 1 to {MOST_SAMPLES}"
            )
        count = round(samples)
        t = np.arange(count) / rate
        return dict(zip(("t", "q", "u", "udot"), (t, *self.at(t)), strict=True))

    @checked
    def save(self, path: str | Path, rate: float = 100.0, periods: Count = 1) -> Path:
        """Write samples as comma-separated values: ``t``, ``elbow``, ``elbow.u``, ``elbow.udot``.

        Returns:
            The path.
        """
        blocks = self.motion(rate, periods)
        return write(Path(path), named_columns(self.model, blocks["t"], blocks))

    def __repr__(self) -> str:
        t = np.linspace(0, self.period, 4000)
        q, u, udot = self.at(t)
        lines = [
            f"'{self.model.name}': motion of {self.period:g} s, {self.harmonics} harmonics, for "
            f"{len(self.base)} base parameters",
            f"condition of the regressor {self.before:.4g} -> {self.condition:.4g}",
        ]
        width = max(len(name) for name in self.model.coordinates)
        for k, name in enumerate(self.model.coordinates):
            lines.append(
                f"  {name:{width}}  {q[:, k].min():8.3f} ... {q[:, k].max():7.3f}   speed to "
                f"{np.abs(u[:, k]).max():.3f}, acceleration to {np.abs(udot[:, k]).max():.3f}"
            )
        return "\n".join(lines)


@checked
def excitation(
    model: LoadedModel,
    period: float = 10.0,
    *,
    harmonics: Count = 5,
    position: Mapping[str, tuple[float, float]] | None = None,
    speed: Mapping[str, float] | float | None = None,
    acceleration: Mapping[str, float] | float | None = None,
    criterion: str = "condition",
    starts: Count = 20,
    steps: int = 30,
    seed: Seed = 0,
    progress: bool | Callable[[float], None] | None = None,
) -> ExcitationRecord:
    """A periodic motion within limits at which the base regressor is well conditioned.

    Args:
        model: A tree of joints with one coordinate each.
        period: Of the motion [s].
        harmonics: Of its Fourier series.
        position: Coordinate -> (lower, upper), in place of the limits of the joint; by default a
            turn where a joint has none.
        speed, acceleration: Most of every joint, or by name; by default the limits of the joint,
            2 rad/s or m/s where it has none, and any acceleration.
        criterion: ``"condition"`` of the regressor with columns scaled to length 1, or
            ``"determinant"``: -log det of the information per parameter.
        starts: Motions by chance, of which the best is improved.
        steps: Of the search.
        seed: Of the motions by chance: the same seed finds the same motion.
        progress: As for ``simulate``.

    Raises:
        ArgumentError: limits or words that do not exist.
        SolveError: joints that are not moved one by one: loops, a free base, ball joints.
    """
    needed(model, "excitation", REQUIRED)
    _refuse(model)
    if criterion not in CRITERIA:
        raise ArgumentError(f"criterion='{criterion}' does not exist.{near(criterion, CRITERIA)}")
    if not 1 / LONGEST <= period <= LONGEST:
        raise ArgumentError(f"excitation: period={period:g}: give seconds, up to {LONGEST:g}")
    limits = _limits(model, position or {}, speed, acceleration)
    search = _Search(model, base_parameters(model), limits, period, harmonics, criterion)
    rng = np.random.default_rng(seed)
    by_chance = rng.normal(size=(starts, model.nu, 2 * harmonics + 2))
    # wide motions in the middle to begin with
    by_chance[..., -2], by_chance[..., -1] = 1.5, 0.3 * by_chance[..., -1]
    values = search.measures(by_chance)
    start = by_chance[int(np.argmin(values))]
    with showing(progress, "excitation") as show:
        improved = search.improved(start, steps, show)
    before, after = (search.condition(x) for x in (start, improved))
    series = feasible(improved, period, harmonics, limits)
    return ExcitationRecord(model, series, limits, search.base, before, after)


def _refuse(model: LoadedModel) -> None:
    """Motions of a Fourier series per joint are possible.

    Raises:
        SolveError: they are not.
    """
    if circuits(model):
        raise SolveError(
            f"excitation: model '{model.name}' has loops, whose joints do not move one by one. "
            "Sweep its drivers through motions of your own and give these to identify(...)"
        )
    if not model.nu or not is_plain(model):
        wide = [row.name for row in model.manifest.joints if (row.q or (0, 0))[1] > 1]
        raise SolveError(
            f"excitation: model '{model.name}' has coordinates that are not angles or lengths of "
            f"driven joints{' (' + ', '.join(wide) + ')' if wide else ''}. Excite the joints of a "
            "free or ball-jointed robot with its base fixed: load(..., base='fixed')"
        )


def _limits(model: LoadedModel, position: Any, speed: Any, acceleration: Any) -> Limits:
    """Limits of every joint.

    Raises:
        ArgumentError: unknown names, empty ranges, a sliding joint without any.
    """
    units = [row.unit for row in model.manifest.coordinates]
    limits = [model.limits.get(name, {}) for name in model.coordinates]
    # None becomes NaN
    lower = np.array([x.get("lower") for x in limits], dtype=float)
    upper = np.array([x.get("upper") for x in limits], dtype=float)
    for name, (low, high) in position.items():
        (k,) = named_speeds(model, [name])
        lower[k], upper[k] = low, high
    # unlimited angles take one turn; slides have no such natural range
    for k, name in enumerate(model.coordinates):
        if not np.isnan(lower[k] + upper[k]):
            continue
        if units[k] == "rad":
            lower[k], upper[k] = -TURN, TURN
        else:
            raise ArgumentError(
                f"excitation: joint '{name}' slides and has no limits; give "
                f"position={{'{name}': (lower, upper)}}"
            )
    if np.any(lower >= upper):
        k = int(np.argmax(lower >= upper))
        raise ArgumentError(f"excitation: limits of '{model.coordinates[k]}' leave no room")
    speeds = [limit.get("speed") or FAST for limit in limits]
    return Limits(
        lower,
        upper,
        _most(model, "speed", speed, speeds),
        _most(model, "acceleration", acceleration, [np.inf] * model.nu),
    )


def _most(model: LoadedModel, word: str, named: object, usual: list[float]) -> Array:
    largest = np.array(usual, dtype=float)
    if isinstance(named, Mapping):
        for name, value in named.items():
            largest[named_speeds(model, [name])] = value
    elif named is not None:
        largest[:] = named
    if not np.all(largest > 0):
        raise ArgumentError(f"excitation: {word}= wants positive numbers")
    return largest


@dataclass(frozen=True)
class _Search:
    """Motions by free numbers, and what they are worth."""

    model: LoadedModel
    base: Base
    limits: Limits
    period: float
    harmonics: int
    criterion: str

    def information(self, numbers: Array) -> Array:
        """Y_bᵀ Y_b over a period (..., nb, nb), every row relative to the force of its joint."""
        count = SAMPLES * self.harmonics
        t = self.period * np.arange(count) / count
        q, u, udot = feasible(numbers, self.period, self.harmonics, self.limits).at(t)
        rows = self.base.regressor(self.model.regressor(q, u, udot)) / self._efforts[:, None]
        flat = rows.reshape(*numbers.shape[:-2], -1, len(self.base))
        return np.asarray(np.swapaxes(flat, -1, -2) @ flat)

    @property
    def _efforts(self) -> Array:
        limits = (self.model.limits.get(name, {}) for name in self.model.coordinates)
        return np.array([limit.get("effort") or 1.0 for limit in limits])

    def measures(self, numbers: Array) -> Array:
        """Quantities to be minimized (...)."""
        matrix = self.information(numbers)
        if self.criterion == "determinant":
            return np.asarray(-np.linalg.slogdet(matrix)[1] / len(self.base))
        if not np.isfinite(matrix).all():
            raise SolveError(
                "excitation: motions with this period, and these limits of speed and acceleration, "
                "have no regressor in numbers: give limits nearer to 1"
            )
        try:
            values = np.linalg.eigvalsh(_scaled(matrix))
        except np.linalg.LinAlgError as problem:
            raise SolveError(
                "excitation: the regressor within these limits of position, speed and acceleration "
                "is too small or too large to be judged: give limits nearer to 1"
            ) from problem
        least = np.maximum(values[..., 0], 1e-15 * values[..., -1])
        return np.asarray(0.5 * np.log(values[..., -1] / least))

    def condition(self, numbers: Array) -> float:
        """Condition number of the scaled regressor."""
        values = np.linalg.eigvalsh(_scaled(self.information(numbers)))
        return float(np.sqrt(values[-1] / max(values[0], 1e-15 * values[-1])))

    def slope(self, x: Array) -> tuple[float, Array]:
        """Measure and its derivatives at flat numbers."""
        shape = (self.model.nu, 2 * self.harmonics + 2)
        ends = np.vstack([x, x + STEP * np.eye(len(x))]).reshape(-1, *shape)
        values = self.measures(ends)
        return float(values[0]), (values[1:] - values[0]) / STEP

    def improved(self, start: Array, steps: int, show: Callable[[float], None]) -> Array:
        """Better numbers near a start; never worse ones."""
        from scipy.optimize import minimize

        if steps < 1:
            return start
        done = [0]

        def report_progress(_: object) -> None:
            done[0] += 1
            show(min(1.0, done[0] / steps))

        minimum = minimize(
            self.slope,
            start.ravel(),
            jac=True,
            method="L-BFGS-B",
            callback=report_progress,
            options={"maxiter": steps, "ftol": FLAT},
        )
        better = minimum.x.reshape(start.shape)
        return better if self.measures(better) < self.measures(start) else start


def _scaled(matrix: Array) -> Array:
    """With columns of length 1."""
    sizes = np.sqrt(np.einsum("...ii->...i", matrix))
    return np.asarray(matrix / (sizes[..., :, None] * sizes[..., None, :]))


@checked
def plot(excitation: ExcitationRecord, path: str | Path | None = None) -> Figure:
    """Positions and speeds over a period as a Matplotlib figure, written to ``path``."""
    from ...view.plot import plot_over

    t = np.linspace(0, excitation.period, 400)
    q, u, udot = excitation.at(t)
    curves = {"q": q, "u": u, "udot": udot}
    return plot_over(f"excitation of {excitation.model.name}", "t [s]", t, curves, path)
