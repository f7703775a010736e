"""The search of a fit: Gauss-Newton steps until nodes meet and nothing changes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, SolveWarning, counted, warn
from ...records import dataclass
from ..simulation.progress import showing
from ..simulation.simulate import simulate
from .estimate import UNKNOWN, Condensed, Solved, solved
from .nodes import speed_places
from .record import FitRecord
from .shooting import Shooting, Shots

CLOSED = 1e-8  # gaps between nodes that are none
EXACT = 1e-10  # of the units of the unknowns: a step that changes nothing
FLAT = 1e-12  # of the cost: a step that improves nothing
HUBER = 1.345  # in standard deviations: beyond, residuals count by their size alone
TURN, PART = 1.0, 0.5  # largest step of a coordinate [rad], and of a parameter, as a part of it
HALVINGS = 12
PRESENT = 1e-4  # of a combination of length 1: parts that belong to it
STILL = 12  # iterations without a better point
BETTER, SHRINKS = 1e-6, 0.9  # of the cost, and of the step: what counts as better
NO_PROGRESS = (
    "nothing better was found after iteration {}, which is kept. The model may miss something, or "
    "the first values are far off: compare fit.plot() with the measurements"
)


@dataclass(frozen=True)
class _Point:
    """Unknowns with what they miss."""

    values: Array
    shots: Shots

    @property
    def states(self) -> Array:
        return self.shots.states

    @property
    def residuals(self) -> Array:
        return self.shots.residuals

    @property
    def gap(self) -> float:
        return float(np.abs(self.shots.gaps).max(initial=0.0))


@dataclass
class _Best:
    """The best point so far, and since when nothing has become better.

    Attributes:
        point: It.
        cost: Its sum of squares.
        iteration: The iteration that led to it.
        size: The smallest step so far.
        since: The last iteration with a better point, or a smaller step.
    """

    point: _Point
    cost: float = np.inf
    iteration: int = 0
    size: float = np.inf
    since: int = 0

    def look(self, point: _Point, cost: float, iteration: int) -> None:
        """Take another point, if it is better."""
        if cost < (1 - BETTER) * self.cost:
            self.since = iteration
        if cost < self.cost:
            self.point, self.cost, self.iteration = point, cost, iteration

    def stands_still(self, iteration: int, size: float) -> bool:
        """True if the search has found nothing better for long, and its steps do not shrink."""
        if size < SHRINKS * self.size:
            self.size, self.since = size, iteration
        return iteration - self.since >= STILL


class Search:
    """The search for the minimum."""

    def __init__(self, shooting: Shooting, limits: Array, loss: str, values: Array) -> None:
        self.shooting, self.limits, self.loss = shooting, limits, loss
        # of parameters: what they begin with, so that one which becomes small may grow again
        self.units = np.where(values != 0, np.abs(values), 1.0)
        self.free = shooting.free
        self._text = "first runs"

    def run(
        self,
        states: Array,
        values: Array,
        most: int,
        progress: bool | Callable[[float], None] | None,
    ) -> FitRecord:
        """The fit from first nodes and parameters.

        Raises:
            ArgumentError: no more samples than unknowns.
        """
        converged, interrupted, iterations = False, False, 0
        message = f"not converged after {most} iterations"
        with showing(progress, self.shooting.model.name, self._stage) as show:
            self.shooting.watch.show = lambda: show(min(0.99, iterations / most))
            point = self._first(states, values)
            best = _Best(point)
            for iterations in range(1, most + 1):
                try:
                    problem, step = self._step(point)
                    best.look(point, self._cost(point, problem), iterations - 1)
                    self._text = f"iteration {iterations}, cost {best.cost / 2:.4g}"
                    point, size, change = self._along(point, problem, step)
                    show(min(0.99, iterations / most))
                except KeyboardInterrupt:
                    message = f"interrupted in iteration {iterations}; what was found is kept"
                    interrupted = True
                    break
                if size <= EXACT or (change <= FLAT and point.gap <= CLOSED):
                    converged, message = True, f"converged after {counted(iterations, 'iteration')}"
                    break
                if size == np.inf:
                    message = f"the motion breaks down along the step of iteration {iterations}"
                    break
                if best.stands_still(iterations, size):
                    message = f"no progress: {NO_PROGRESS.format(best.iteration)}"
                    break
            if not (converged or interrupted or size == np.inf):
                best.look(point, self._cost(point, self._step(point)[0]), iterations)
        end = point if converged else best.point
        return self._fit(end, converged, interrupted, message, iterations)

    def _first(self, states: Array, values: Array) -> _Point:
        """Start of the search.

        Raises:
            ArgumentError: no more samples than unknowns.
        """
        point = self._point(states, values)
        count, unknowns = len(point.residuals), len(self._names())
        if count <= unknowns:
            raise ArgumentError(
                f"fit: {count} samples cannot determine {unknowns} unknowns. Name fewer, or give "
                "more samples"
            )
        return point

    def _cost(self, point: _Point, problem: Condensed) -> float:
        """Sum of squares of what residuals would be if all segments met, to first order."""
        return float(np.sum(self._weights(point.residuals) * problem.residuals**2))

    def _stage(self) -> str:
        """How the search stands, beside its bar."""
        return self._text

    def _point(self, states: Array, values: Array) -> _Point:
        return _Point(values, self.shooting.every(states, values))

    def _weights(self, residuals: Array) -> Array:
        if self.loss == "linear":
            return np.ones(len(residuals))
        deviation = np.median(np.abs(residuals)) / 0.6745 or 1.0
        return np.minimum(1.0, HUBER * deviation / np.maximum(np.abs(residuals), 1e-300))

    def _step(self, point: _Point, units: Array | None = None) -> tuple[Condensed, Solved]:
        problem = point.shots.problem
        fixed = np.zeros(self.shooting.unknowns, dtype=bool)
        weights = self._weights(point.residuals)
        units = np.concatenate([np.ones(len(self.free)), self.units if units is None else units])
        while True:
            result = solved(problem, units, fixed, weights)
            step = result.step[len(self.free) :]
            low, high = self.limits.T
            at_low, at_high = point.values <= low, point.values >= high
            pushed = (at_low & (step < 0)) | (at_high & (step > 0))
            if not pushed.any():
                return problem, result
            # at a bound: it stays there, and the others are found anew
            fixed[len(self.free) :] |= pushed

    def _along(
        self, point: _Point, problem: Condensed, step: Solved
    ) -> tuple[_Point, float, float]:
        """The next point, the size of the step and the part by which the cost fell."""
        # increments of every node, with what closes the gaps to it
        moves = problem.nodes @ step.step + problem.offsets
        change = step.step[len(self.free) :]
        units = self.units
        far = max(
            float(np.abs(moves).max(initial=0.0)) / TURN / 10,
            float(np.abs(moves[:, : self.shooting.model.nu]).max(initial=0.0)) / TURN,
            float(np.abs(change / units).max(initial=0.0)) / PART,
        )
        part = min(1.0, 1.0 / far) if far > 0 else 1.0
        size = max(
            float(np.abs(moves).max(initial=0.0)), float(np.abs(change / units).max(initial=0.0))
        )
        # a step that leads where no motion exists is shortened
        before = self._merit(point)
        for _ in range(HALVINGS):
            values = np.clip(point.values + part * change, *self.limits.T)
            states = self.shooting.moved(point.states, part * moves)
            try:
                there = self._point(states, values)
            except (SolveError, ModelError):
                part /= 2
                continue
            # steps are limited by their length alone: costs of motions that do not hold together
            # yet say little, and shorter steps because of them would take very many
            fallen = before - self._merit(there)
            return there, size * part, abs(fallen) / max(before, 1e-300)
        return point, np.inf, 0.0

    def _merit(self, point: _Point) -> float:
        weighted = self._weights(point.residuals) * point.residuals**2
        return float(np.sum(weighted) + np.sum(point.shots.gaps**2))

    def _fit(
        self, point: _Point, converged: bool, interrupted: bool, message: str, iterations: int
    ) -> FitRecord:
        shooting, samples = self.shooting, self.shooting.samples
        # the last problem once more: its covariance is that at the answer
        sizes = np.maximum(self.units, np.abs(point.values))
        _, last = self._step(point, sizes)
        residuals = point.residuals
        freedom = len(residuals) - len(last.step)
        variance = float(residuals @ residuals) / freedom
        names = tuple(self._names())
        values = dict(zip(shooting.parameters, map(float, point.values), strict=True))
        model = shooting.model.with_parameters(values)
        # in one run, as somebody would simulate it
        t = samples.t
        motion = simulate(
            model, (float(t[0]), float(t[-1])), x0=point.states[0], inputs=shooting.inputs,
            method=shooting.method, rtol=shooting.rtol, progress=False,
        )  # fmt: skip
        by_channel = self._by_channel(residuals)
        with np.errstate(invalid="ignore"):
            covariance = variance * last.covariance
        # what is known to less than its size is as good as unknown
        hardly = last.determined[last.deviations * np.sqrt(variance) > UNKNOWN]
        untold = tuple(
            self._combination(names, one, point.values, sizes) for one in (*last.untold, *hardly)
        )
        if untold or not converged:
            said = "; ".join(", ".join(one) for one in untold)
            warn(
                f"fit of '{model.name}': {message}"
                + (f"; the data cannot determine combinations of {said}" if said else ""),
                SolveWarning,
            )
        return FitRecord(
            model=model,
            parameters=values,
            start=point.states[0],
            names=names,
            values=self._values(point.states[0]) | values,
            standard_errors=dict(zip(names, np.sqrt(np.diag(covariance)).tolist(), strict=True)),
            covariance=covariance,
            t=t,
            measured=dict(zip(samples.formulas, samples.values.T, strict=True)),
            residuals=by_channel,
            sigma=float(np.sqrt(variance)),
            freedom=freedom,
            at_bounds=tuple(n for n, x in zip(names, last.fixed, strict=True) if x),
            durbin_watson={name: _durbin_watson(x) for name, x in by_channel.items()},
            undetermined=untold,
            motion=motion,
            segments=len(point.states),
            cost=float(residuals @ residuals) / 2,
            iterations=iterations,
            converged=converged,
            interrupted=interrupted,
            message=message,
        )

    def _combination(
        self, names: tuple[str, ...], direction: Array, values: Array, units: Array
    ) -> dict[str, float]:
        """A combination by name: changes of starts, and of parameters as parts of their values."""
        sizes = np.where(values != 0, np.abs(values), 1.0)
        parts = direction.copy()
        parts[len(self.free) :] *= units / sizes
        parts /= np.linalg.norm(parts)
        return {name: float(x) for name, x in zip(names, parts, strict=True) if abs(x) > PRESENT}

    def _values(self, x: Array) -> dict[str, float]:
        """Values of the unknown starts by name; nan along rotations in space, which have none."""
        names, places = self._names()[: len(self.free)], speed_places(self.shooting.model)
        entries = [places.index(k) if k in places else -1 for k in self.free]
        return {n: float(x[k]) if k >= 0 else np.nan for n, k in zip(names, entries, strict=True)}

    def _names(self) -> list[str]:
        model = self.shooting.model
        entries = [f"q0 along {name}" for name in model.speeds]
        for k, place in enumerate(speed_places(model)[: model.nq]):
            if place >= 0:
                entries[place] = f"q0.{model.coordinates[k]}"
        entries += [f"u0.{name}" for name in model.speeds]
        entries += [f"z0.{name}" for name in model.internals]
        return [*(entries[k] for k in self.free), *self.shooting.parameters]

    def _by_channel(self, residuals: Array) -> dict[str, Array]:
        """Residuals in the units of the channels (nt,)."""
        samples = self.shooting.samples
        full = np.full(samples.values.shape, np.nan)
        full[samples.present] = residuals
        full *= samples.noise
        return {name: full[:, k] for k, name in enumerate(samples.formulas)}


def _durbin_watson(residuals: Array) -> float:
    """Source: J. Durbin, G. S. Watson, Biometrika 37 (1950), 409-428."""
    present = residuals[np.isfinite(residuals)]
    size = float(present @ present)
    return float(np.sum(np.diff(present) ** 2) / size) if size > 0 else 2.0
