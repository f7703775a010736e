"""What came out of an ensemble."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import ArgumentError, ModelError, near
from ...runtime.conduct import EVENT, FINISHED
from ...runtime.trajectory import Trajectory
from .crew import NUMBERS
from .gathered import UNFINISHED, Gathered
from .job import Job, entries

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Ensemble:
    """Many runs of one model. ``print(ensemble)`` tells how they went.

    Attributes:
        job: What was asked for.
        final: State at the end of every run (runs, nx); where one broke down, its last good state.
        results: Reductions by name: (runs, ...) per run, (nt,) over runs, or bins.
        codes, words: Status of every run as an index in words; see ``status``.
        numbers: (runs, 4): end time [s], steps, rejections, evaluations.
        messages: What happened to the first thousand runs that did not reach their end.
        seconds: What it took.
        hands: Who computed it.
        restored: How many runs came from a checkpoint.
        kept: What is kept of an interrupted one, in words.
    """

    job: Job = field(repr=False)
    final: Array = field(repr=False)
    results: Mapping[str, Any] = field(repr=False)
    codes: NDArray[np.int8] = field(repr=False)
    words: tuple[str, ...] = field(repr=False)
    numbers: Array = field(repr=False)
    messages: Mapping[int, str] = field(repr=False)
    seconds: float
    hands: str
    restored: int = 0
    kept: str = field(default="", repr=False)

    @classmethod
    def of(
        cls, gathered: Gathered, seconds: float, hands: str, restored: int, kept: str
    ) -> Ensemble:
        """The result of what was gathered."""
        g = gathered
        messages = dict(sorted(g.messages.items()))
        return cls(
            job=g.job,
            final=g.x,
            results=g.results(),
            codes=g.codes,
            words=tuple(g.words),
            numbers=g.numbers,
            messages=messages,
            seconds=seconds,
            hands=hands,
            restored=restored,
            kept=kept,
        )

    def __len__(self) -> int:
        return len(self.final)

    def __repr__(self) -> str:
        return _summary(self)

    def __getitem__(self, name: str) -> Any:
        """A reduction by its name, or last values of a coordinate or speed (runs,).

        Raises:
            ModelError: neither.
        """
        if name in self.results:
            return self.results[name]
        names = entries(self.job.model)
        if name not in names:
            known = [*self.results, *names]
            raise ModelError(f"ensemble['{name}']: it was not kept.{near(name, known)}")
        return self.final[:, names.index(name)]

    @property
    def t(self) -> Array:
        """Output times (nt,) [s]."""
        times = self.job.over.times
        return np.empty(0) if times is None else times

    @property
    def q(self) -> Array:
        """Last coordinates (runs, nq)."""
        return self.final[:, : self.job.model.nq]

    @property
    def u(self) -> Array:
        """Last speeds (runs, nu)."""
        nq, nu = self.job.model.nq, self.job.model.nu
        return self.final[:, nq : nq + nu]

    @property
    def status(self) -> NDArray[np.str_]:
        """Of every run: ``finished``, or what stopped it; ``not_run`` after an interruption."""
        return np.array(self.words)[self.codes]

    @property
    def success(self) -> bool:
        """Whether all runs reached their end."""
        return bool(self.finished.all())

    @property
    def finished(self) -> NDArray[np.bool_]:
        """Which runs reached their end, or one that an event made, (runs,)."""
        return np.isin(self.status, (FINISHED, EVENT))

    @property
    def done(self) -> int:
        """How many runs came to an end, of whatever kind."""
        return int(np.isin(self.status, UNFINISHED, invert=True).sum())

    @property
    def interrupted(self) -> bool:
        """Whether Ctrl-C came before all runs were done."""
        return self.done < len(self)

    @cached_property
    def varied(self) -> dict[str, Array]:
        """Name -> values (runs,), or (runs, n) for several entries: what the runs differ by."""
        columns = [c for c in self.job.varied.columns if len(c.values) == len(self)]
        return {c.name: c.values[:, 0] if c.values.shape[1] == 1 else c.values for c in columns}

    @property
    def statistics(self) -> dict[str, Array]:
        """Per run (runs,): end time ``t`` [s], ``steps``, ``rejections``, ``evaluations``."""
        return {name: self.numbers[:, k] for k, name in enumerate(NUMBERS)}

    def run(self, i: int, times: Any = None) -> Trajectory:
        """One run again, with everything between its steps: the same bits, as a motion.

        Args:
            i: Its number; negative ones count from the end.
            times: Output times instead [s].

        Raises:
            ArgumentError: there is no such run.
        """
        if not -len(self) <= i < len(self):
            raise ArgumentError(f"run({i}): there are runs 0 to {len(self) - 1}")
        return self.job.motion(i % len(self), None if times is None else np.asarray(times, float))

    def message(self, i: int) -> str:
        """What happened to a run, as a sentence."""
        known = self.messages.get(i % len(self))
        return known or str(self.run(i).message)

    def to_xarray(self) -> Any:
        """Data set with the dimensions run, entry, time.

        Raises:
            ModuleNotFoundError: xarray is missing.
        """
        from .stored import to_xarray

        return to_xarray(self)

    def save(self, path: str | Path) -> Path:
        """Write everything but the model as netCDF, through SciPy alone.

        Raises:
            ModelError: a variable too large for the format, or a directory that does not exist.
        """
        from .stored import save

        return save(self, Path(path))


def _summary(ensemble: Ensemble) -> str:
    """How the runs went."""
    job = ensemble.job
    counts = Counter(dict(enumerate(np.bincount(ensemble.codes).tolist())))
    names = ", ".join(job.varied.names) or "nothing"
    lanes = f", {job.width} lanes" if job.width > 1 else ""
    lines = [
        f"ensemble of {job.model.name}: {len(ensemble)} runs from {job.over.start:g} s to "
        f"{job.over.end:g} s",
        f"  varied: {names}",
        f"  {job.how.method.name}, {job.how.words}; {ensemble.hands}{lanes}",
        *([f"  auto: {job.how.reason}"] if job.how.reason else []),
    ]
    width = max(map(len, ensemble.words))
    for code, count in counts.most_common():
        first = int(np.argmax(ensemble.codes == code))
        told = ensemble.messages.get(first, "")
        line = f"  {ensemble.words[code]:{width}} {count:9d}"
        if count:
            lines.append(f"{line}   first run {first}: {told}" if told else line)
    begun = np.isfinite(ensemble.numbers[:, 0])
    if begun.any():
        steps, rejections, evaluations = ensemble.numbers[begun, 1:].mean(axis=0)
        lines.append(
            f"  per run {steps:.1f} steps, {rejections:.1f} rejections, {evaluations:.0f} "
            f"evaluations; {_speed(ensemble)}"
        )
    lines.append(f"  kept: {', '.join(['final', *ensemble.results])}")
    return "\n".join(lines)


def _speed(ensemble: Ensemble) -> str:
    """What it took; runs that a checkpoint had took nothing."""
    computed = ensemble.done - ensemble.restored
    rate = f", {computed / max(ensemble.seconds, 1e-9):.3g} runs per second" if computed else ""
    before = f", {ensemble.restored} runs from the checkpoint" if ensemble.restored else ""
    return f"{ensemble.seconds:.3g} s{rate}{before}"
