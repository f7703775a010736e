"""Results of an ensemble."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arguments import checked
from ...arrays import Array, Booleans
from ...errors import ArgumentError, ModelError, SolveError, SolveWarning, counted, near, warn
from ...records import dataclass
from ...runtime.trajectory.solver_info import EVENT, FINISHED
from ...runtime.trajectory.trajectory import TrajectoryRecord
from .collection import UNFINISHED, Gathered, PartResults
from .job import Job, entries
from .lane_runner import NUMBERS
from .sensitivity import NO_DERIVATIVE, RunSensitivities
from .share import Share


@dataclass(frozen=True)
class Request:
    """The request that an ensemble answers, as its file states it.

    Attributes:
        model: Its name.
        entries: Names of the entries of a state.
        counts: How many of them are coordinates, and how many speeds; None where an older file
            does not say.
        start, end: Of every run [s].
        times: Output times (nt,) [s].
        names: What was varied.
        method, settings, reason: The integrator, its tolerances in words, and why it.
        lanes: Side by side.
        varied: Name -> values (runs,) or (runs, n): what the runs differ by.
        axes: Reduction -> names of its axes, as :attr:`.Reduction.axes` says them.
        share: Which part of the runs it is.
    """

    model: str
    entries: tuple[str, ...]
    counts: tuple[int, int] | None
    start: float
    end: float
    times: Array = field(repr=False)
    names: tuple[str, ...]
    method: str
    settings: str
    reason: str
    lanes: int
    varied: Mapping[str, Array] = field(repr=False)
    axes: Mapping[str, tuple[str, ...]]
    share: Share | None = None

    @classmethod
    def of(cls, job: Job, share: Share) -> Request:
        """The request of a part of a job."""
        model, times = job.model, job.over.times
        columns = [c for c in job.varied.columns if len(c.values) == job.varied.runs]
        varied: dict[str, Array] = {}
        for c in columns:
            # a joint may have both its coordinates and its speeds varied
            name = c.name if c.name not in varied else f"{c.name}.{c.block}"
            values = c.values[share.first : share.last]
            varied[name] = values[:, 0] if values.shape[1] == 1 else values
        return cls(
            model=model.name,
            entries=entries(model),
            counts=(model.nq, model.nu),
            start=job.over.start,
            end=job.over.end,
            times=np.empty(0) if times is None else times,
            names=job.varied.names,
            method=job.how.method.name,
            settings=job.how.description,
            reason=job.how.reason,
            lanes=job.width,
            varied=varied,
            axes={name: one.axes for name, one in job.reductions.items()},
            share=share,
        )


@dataclass(frozen=True, eq=False)
class EnsembleRecord:
    """Many runs of one model. ``print(ensemble)`` tells how they went.

    Attributes:
        request: What was asked for.
        final: State at the end of every run (runs, nx); where one broke down, its last good state.
        results: Reductions by name: (runs, ...) per run, (nt,) over runs, or bins.
        codes, status_names: Status of every run as an index in words; see ``status``.
        numbers: (runs, 4): end time [s], steps, rejections, evaluations.
        messages: What happened to the first thousand runs that did not reach their end, or that
            miss far more than their tolerance is worth.
        seconds: What it took.
        executor: Who computed it.
        restored: How many runs came from a checkpoint.
        saved_message: What is kept of an interrupted one, in words.
        source: What runs are computed again from; None for an ensemble of a file.
        part_results: What a part is joined with others by.
    """

    request: Request = field(repr=False)
    final: Array = field(repr=False)
    results: Mapping[str, Any] = field(repr=False)
    codes: NDArray[np.int8] = field(repr=False)
    status_names: tuple[str, ...] = field(repr=False)
    numbers: Array = field(repr=False)
    messages: Mapping[int, str] = field(repr=False)
    seconds: float
    executor: str
    restored: int = 0
    saved_message: str = field(default="", repr=False)
    source: Job | None = field(default=None, repr=False)
    part_results: PartResults | None = field(default=None, repr=False)

    @classmethod
    def of(
        cls,
        gathered: Gathered,
        request: Request,
        seconds: float,
        executor: str,
        restored: int,
        saved_message: str = "",
        source: Job | None = None,
        part_results: PartResults | None = None,
    ) -> EnsembleRecord:
        """The result of what was gathered."""
        g = gathered
        return cls(
            request=request,
            final=g.x,
            results=g.results(),
            codes=g.codes,
            status_names=tuple(g.status_names),
            numbers=g.numbers,
            messages=g.messages,
            seconds=seconds,
            executor=executor,
            restored=restored,
            saved_message=saved_message,
            source=source,
            part_results=part_results,
        )

    def __len__(self) -> int:
        return len(self.final)

    def __repr__(self) -> str:
        return _summary(self)

    @property
    def job(self) -> Job:
        """The request together with the model.

        Raises:
            ModelError: the ensemble comes from a file, which holds no model.
        """
        if self.source is None:
            raise ModelError(
                "an ensemble of a file has no model to compute a run again: call model.ensemble "
                "with what it was made with"
            )
        return self.source

    def __getitem__(self, name: str) -> Any:
        """A reduction by its name, or last values of a coordinate or speed (runs,).

        Raises:
            ModelError: neither.
        """
        if name in self.results:
            return self.results[name]
        names = self.request.entries
        if name not in names:
            names_available = [*self.results, *names]
            raise ModelError(f"ensemble['{name}']: it was not kept.{near(name, names_available)}")
        return self.final[:, names.index(name)]

    @property
    def sensitivity(self) -> RunSensitivities:
        """Name -> (runs, nt, nx): what states at output times change by, as it was asked for.

        (runs, nt, nx, k) of what consists of several numbers, such as ``"x0"``. NaN behind the end
        of a run, and of runs that broke down. ``of("tip")`` is what an output changes by.
        """

        def again(k: int) -> TrajectoryRecord:
            return self.job.motion(k, None)

        return RunSensitivities(self.results, self.t, len(self), again)

    @property
    def t(self) -> Array:
        """Output times (nt,) [s]."""
        return self.request.times

    @property
    def q(self) -> Array:
        """Last coordinates (runs, nq)."""
        return self.final[:, : self._counts[0]]

    @property
    def u(self) -> Array:
        """Last speeds (runs, nu)."""
        nq, nu = self._counts
        return self.final[:, nq : nq + nu]

    @property
    def _counts(self) -> tuple[int, int]:
        """Numbers of coordinates and speeds."""
        if self.request.counts is None:
            raise ModelError(
                "this older file does not say which entries are coordinates: ensemble['elbow'] "
                "and ensemble.final have them by name and place"
            )
        return self.request.counts

    @property
    def status(self) -> NDArray[np.str_]:
        """Status of every run:

        ``finished``, or the reason why it stopped; ``not_run`` after an interruption.
        """
        return np.array(self.status_names)[self.codes]

    @property
    def part(self) -> tuple[int, int] | None:
        """``(k, n)``: part k of n of an ensemble that was divided; else None."""
        share = self.request.share
        return None if share is None or share.undivided else (share.number, share.count)

    @property
    def success(self) -> bool:
        """True when all runs reached their end."""
        return bool(self.finished.all())

    @property
    def finished(self) -> Booleans:
        """Mask of the runs that reached their end, or one that an event made, (runs,)."""
        return np.isin(self.status, (FINISHED, EVENT, NO_DERIVATIVE))

    @property
    def done(self) -> int:
        """Number of runs that came to an end of any kind."""
        return int(np.isin(self.status, UNFINISHED, invert=True).sum())

    @property
    def interrupted(self) -> bool:
        """True when Ctrl-C came before all runs were done."""
        return self.done < len(self)

    @property
    def varied(self) -> Mapping[str, Array]:
        """Name -> values (runs,), or (runs, n) for several entries: what the runs differ by."""
        return self.request.varied

    @property
    def statistics(self) -> dict[str, Array]:
        """Per run (runs,): end time ``t`` [s], ``steps``, ``rejections``, ``evaluations``."""
        return {name: self.numbers[:, k] for k, name in enumerate(NUMBERS)}

    @checked
    def message(self, i: int) -> str:
        """Outcome of a run as a sentence.

        Raises:
            ModelError: the ensemble comes from a file, which has no sentence about that run.
        """
        stored = self.messages.get(i % len(self))
        return stored or str(run(self, i).message)


def _summary(ensemble: EnsembleRecord) -> str:
    """Summary of all runs as text."""
    request = ensemble.request
    counts = Counter(dict(enumerate(np.bincount(ensemble.codes).tolist())))
    names = ", ".join(request.names) or "nothing"
    lanes = f", {request.lanes} lanes" if request.lanes > 1 else ""
    lines = [
        f"ensemble of {request.model}: {counted(len(ensemble), 'run')} from {request.start:g} s to "
        f"{request.end:g} s",
        *_part(request.share),
        f"  varied: {names}",
        f"  {request.method}, {request.settings}; {ensemble.executor}{lanes}",
        *([f"  auto: {request.reason}"] if request.reason else []),
    ]
    width = max(map(len, ensemble.status_names))
    for code, count in counts.most_common():
        first = int(np.argmax(ensemble.codes == code))
        message = ensemble.messages.get(first, "")
        line = f"  {ensemble.status_names[code]:{width}} {count:9d}"
        if count:
            lines.append(f"{line}   first run {first}: {message}" if message else line)
    begun = np.isfinite(ensemble.numbers[:, 0])
    if begun.any():
        steps, rejections, evaluations = ensemble.numbers[begun, 1:].mean(axis=0)
        lines.append(
            f"  per run {steps:.1f} steps, {rejections:.1f} rejections, {evaluations:.0f} "
            f"evaluations; {_speed(ensemble)}"
        )
    lines.append(f"  kept: {', '.join(['final', *ensemble.results])}")
    return "\n".join(lines)


def _part(share: Share | None) -> list[str]:
    """The part of all runs that an ensemble is, as a line."""
    if share is None or share.undivided:
        return []
    return [f"  {share}: runs {share.first} to {share.last - 1} of {share.runs}"]


def _speed(ensemble: EnsembleRecord) -> str:
    """Computing time; runs taken from a checkpoint count as nothing."""
    computed = ensemble.done - ensemble.restored
    rate = f", {computed / max(ensemble.seconds, 1e-9):.3g} runs per second" if computed else ""
    before = f", {ensemble.restored} runs from the checkpoint" if ensemble.restored else ""
    return f"{ensemble.seconds:.3g} s{rate}{before}"


@checked
def run(ensemble: EnsembleRecord, i: int, times: Sequence[float] | None = None) -> TrajectoryRecord:
    """One run again, with everything between its steps: the same bits, as a motion.

    Args:
        i: Its number; negative ones count from the end.
        times: Output times instead [s].

    Raises:
        ArgumentError: there is no such run. ModelError: the ensemble comes from a file.
    """
    if not -len(ensemble) <= i < len(ensemble):
        raise ArgumentError(f"run({i}): there are runs 0 to {len(ensemble) - 1}")
    return ensemble.job.motion(
        i % len(ensemble), None if times is None else np.asarray(times, float)
    )


def reported(ensemble: EnsembleRecord, missed: Mapping[int, str], check: bool) -> EnsembleRecord:
    """The result; with warnings of runs that did not reach their end, or cannot account for it.

    Args:
        ensemble: Of all runs, with as many messages as are kept.
        missed: What finished runs miss, whether it is kept or not.
        check: Whether to raise instead.

    Raises:
        SolveError: with ``check``.
    """
    failed = len(ensemble) - int(ensemble.finished.sum())
    alone = ensemble.status == NO_DERIVATIVE
    counted = ensemble.finished & ~alone
    messages = {k: text for k, text in ensemble.messages.items() if counted[k]}
    missing = {**messages, **missed}
    said = []
    if failed and ensemble.interrupted:
        said += [
            f"interrupted when {ensemble.done} of {len(ensemble)} runs were done; "
            f"{ensemble.saved_message}"
        ]
    elif failed:
        first = int(np.argmin(ensemble.finished))
        why = ensemble.message(first)
        said += [f"{failed} of {len(ensemble)} runs did not reach their end; run {first}: {why}"]
    if alone.any():
        first = int(np.argmax(alone))
        why = ensemble.message(first)
        said += [f"{alone.sum()} of {len(ensemble)} runs have no sensitivities; run {first}: {why}"]
    if missing:
        first = min(missing)
        said += [
            f"at least {len(missing)} of {len(ensemble)} runs miss far more than their tolerance "
            f"is worth; run {first}: {missing[first]}"
        ]
    if said and check:
        raise SolveError("; ".join(said))
    for text in said:
        warn(text, SolveWarning)
    return ensemble
