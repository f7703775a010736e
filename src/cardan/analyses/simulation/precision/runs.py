"""Measure speed against error: every integrator on one motion, from rough to fine."""

from __future__ import annotations

import math
import time
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ....arguments import Inputs, checked
from ....arrays import Array
from ....errors import CodegenError, DerivationError, ModelError, SolveWarning, near
from ....runtime.models.loaded_model import LoadedModel
from ....runtime.trajectory.trajectory import TrajectoryRecord
from ....schema.integrators import INTEGRATORS, Integrator
from ...mechanisms.redundancy import undetermined
from ..method_choice import JACOBIAN
from ..simulate import simulate
from ..times import span
from .reference_runs import OutOfTime, reference
from .work_precision import Point, PrecisionRecord

Show = Callable[[str, float], None]

TOLERANCES = tuple(10.0**-k for k in range(2, 13))
ROUGH = TOLERANCES[:7]  # of methods of order 2: more would take for ever
STEPS = tuple(100 * 4**k for k in range(7))  # of a fixed step
RATIO = 1e-3  # atol over rtol
LONGER, SOON = 10, 0.1  # times its patience that a reference takes; share of it to judge by
OUTPUTS = 41  # times at which errors are looked at
REPEATS, WORTH = 5, 50.0  # runs of which the least time counts; up to so many ms of them
BEYOND = 3.0  # times the doubt of the reference: smaller errors tell nothing more


@checked
def precision(
    model: LoadedModel,
    t: float | ArrayLike,
    methods: Sequence[str] | None = None,
    patience: float = 5.0,
    show: Show | None = None,
    *,
    x0: ArrayLike | None = None,
    q: Any = None,
    u: Any = None,
    z: Any = None,
    inputs: Inputs | None = None,
    events: Mapping[str, object] | None = None,
) -> PrecisionRecord:
    """Run every integrator that applies at tolerances from rough to fine.

    Args:
        model: The compiled model.
        t: End, or ``(start, end)`` [s].
        methods: Names; all integrators by default.
        patience: Longest time for one run [s]; a method stops where it would take more.
        show: Called with what is being run and the fraction done.
        x0, q, u, z, inputs, events: Of the motion, as ``simulate`` takes them.

    Returns:
        What was measured; Ctrl-C ends measuring and keeps what there is.

    Raises:
        ModelError: an unknown method or name. SolveError: no reference can be computed.
    """
    for name in methods or ():
        if name not in INTEGRATORS:
            raise ModelError(f"method '{name}' does not exist.{near(name, list(INTEGRATORS))}")
    if not (math.isfinite(patience) and patience > 0):
        raise ModelError(f"patience={patience:g}: it must be a positive time [s]")
    over = span(t)
    start = {"x0": x0, "q": q, "u": u, "z": z, "inputs": inputs, "events": events}
    bench = Bench(model, np.linspace(over.start, over.end, OUTPUTS), patience, start)
    chosen = {name: INTEGRATORS[name] for name in methods or INTEGRATORS}
    points: list[Point] = []
    left_out: dict[str, str] = {}
    stopped = False
    said = show or (lambda what, fraction: None)
    said("reference", 0.0)
    # two methods that agree make the reference that errors are measured against
    description = bench.refer()
    try:
        for k, (name, method) in enumerate(chosen.items()):
            same = twin(model, method)
            if same and same in chosen:
                left_out[name] = f"the same as {same}: no joint here turns by a quaternion"
                continue
            for point, why in bench.sweep(method):
                if why:
                    left_out[name] = why
                if point is not None:
                    points.append(point)
                    said(point.description, (k + 0.5) / len(chosen))
    except KeyboardInterrupt:
        stopped = True
    ends = (over.start, over.end)
    reactions = undetermined(model, bench.start, over.start)
    return PrecisionRecord(
        model.name, ends, tuple(points), description, bench.doubt, left_out, stopped, reactions
    )


def twin(model: LoadedModel, method: Integrator) -> str:
    """The method that a Lie group method is where nothing turns by quaternions, "" of others."""
    if not method.charted or model.manifest.quaternions:
        return ""
    candidates = (n for n, m in INTEGRATORS.items() if m.kernel == method.kernel and not m.charted)
    return next(candidates, "")


class Bench:
    """One motion that is run again and again."""

    def __init__(
        self, model: LoadedModel, times: Array, patience: float, start: dict[str, Any]
    ) -> None:
        self._model, self._times, self._patience, self._start = model, times, patience, start
        self._reference: Array = np.empty(0)
        self.doubt = 0.0

    @property
    def start(self) -> Array:
        """Coordinates (nq,) where the reference begins."""
        first: Array = self._reference[0]
        return first

    def refer(self) -> str:
        """Compute the reference by two methods; says what it is.

        Raises:
            SolveError: no method reaches the end.
        """
        derived = JACOBIAN in self._model.manifest.available
        # the reference may take longer than what it judges
        allowed = LONGER * self._patience

        def run(spent: float = 0.0, rtol: float = 0.0, **how: object) -> TrajectoryRecord:
            if rtol:
                how |= {"rtol": rtol, "atol": RATIO * rtol}
            motion = self._run(allowed - spent, SOON, **how)
            if motion.status == "interrupted":
                raise KeyboardInterrupt
            return motion

        solution = reference(run, self._times, self._distance, derived, allowed)
        self._reference, self.doubt = solution.q, solution.doubt
        return solution.description

    def sweep(self, method: Integrator) -> Iterator[tuple[Point | None, str]]:
        """Points of a method from rough to fine, and why it goes no further."""
        length = abs(self._times[-1] - self._times[0])
        values = [length / n for n in STEPS] if not method.adaptive else list(TOLERANCES)
        if method.adaptive and method.order < 4:
            values = list(ROUGH)
        for value in values:
            how = {"rtol": value, "atol": RATIO * value} if method.adaptive else {"step": value}
            setting = next(iter(how))
            try:
                point = self._point(method.name, setting, value, how)
            except (ModelError, DerivationError, CodegenError) as refused:
                yield None, str(refused)
                return
            except OutOfTime:
                yield None, f"{setting} {value:.2g} takes more than {self._patience:g} s"
                return
            yield point, ""
            if 0 < point.error < BEYOND * self.doubt:
                return

    def _point(self, name: str, setting: str, value: float, how: dict[str, float]) -> Point:
        """The least time of some runs, which are all alike.

        Raises:
            KeyboardInterrupt: somebody stopped it.
        """
        least, spent = math.inf, 0.0
        for _ in range(REPEATS):
            motion = self._run(self._patience, method=name, **how)
            if motion.status == "interrupted":
                raise KeyboardInterrupt
            milliseconds = motion.statistics["milliseconds"]
            least, spent = min(least, milliseconds), spent + milliseconds
            if spent > WORTH:
                break
        statistics = motion.statistics
        looked = statistics.get("looked", 0)
        return Point(
            name,
            setting,
            value,
            motion.status,
            self._error(motion) if motion.success else math.inf,
            least,
            int(statistics["steps"]),
            int(statistics["evaluations"]),
            statistics.get("limited", 0) / looked if looked else 0.0,
        )

    def _run(self, allowed: float, soon: float = 1.0, **how: Any) -> TrajectoryRecord:
        """One run.

        Args:
            allowed: Time [s].
            soon: Share of it after which what is done tells whether it is enough.
            how: As ``simulate`` takes it.

        Raises:
            OutOfTime: it takes more than is allowed.
        """
        begun: list[float] = []

        def watch(done: float) -> None:
            now = time.perf_counter()
            # what is derived and compiled before the first steps does not count
            begun[:] = begun or [now]
            spent = now - begun[0]
            if spent > allowed or (spent > soon * allowed and spent > allowed * done):
                raise OutOfTime

        with warnings.catch_warnings():
            # how a run ends stands in its status
            warnings.simplefilter("ignore", SolveWarning)
            return simulate(self._model, self._times, progress=watch, **how, **self._start)

    def _error(self, motion: TrajectoryRecord) -> float:
        """Largest error of a coordinate."""
        return self._distance(motion.q, self._reference)

    def _distance(self, q: Array, other: Array) -> float:
        """Largest difference of a coordinate; quaternions of either sign are one."""
        if len(q) != len(other):
            return math.inf
        aligned = q.copy()
        for first in self._model.manifest.quaternions:
            four = slice(first, first + 4)
            along = (aligned[:, four] * other[:, four]).sum(axis=1)
            aligned[:, four] *= np.where(along < 0, -1.0, 1.0)[:, None]
        return float(np.abs(aligned - other).max(initial=0.0))
