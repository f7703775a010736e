"""Sensitivities of the runs of an ensemble: what is asked for, how they are kept and handed out."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field

import numpy as np

from ...arguments import Inputs, checked
from ...arrays import Array
from ...errors import ModelError, SolveError, collected_warnings, near
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ..gradients.differentiable import refuse
from ..gradients.sensitivities import Sensitivities, columns_by_name
from ..gradients.unknowns import Unknowns, unknowns
from ..simulation.settings import Settings
from ..simulation.signals import Signals
from .reductions import Histories, Parts, Reduction, reread

PREFIX = "sensitivity to "
PHRASE = re.compile(rf"{PREFIX}(.+)(?: in (\d{{1,9}}) columns| alone)", re.DOTALL)
NO_DERIVATIVE = "no_derivative"  # status of a run that is complete and has no sensitivities


@dataclass(frozen=True)
class SensitivityRequest:
    """What all runs are differentiated by.

    Attributes:
        names: As they were given.
        tables: Inputs that were given as ``(times, values)``, by name.
    """

    names: tuple[str, ...]
    tables: Mapping[str, object] = field(repr=False)

    def unknowns(self, model: LoadedModel) -> Unknowns:
        """The same, checked."""
        return unknowns(model, self.names, self.tables)


@dataclass(frozen=True)
class SensitivityHistories(Reduction):
    """What the states of every run change by, (runs, nt, nx), or (runs, nt, nx, columns)."""

    name: str
    columns: int | None
    per_run = True
    axes = ("run", "time", "entry")

    def phrase(self) -> str:
        """Same as :meth:`.Reduction.phrase`."""
        columns = "alone" if self.columns is None else f"in {self.columns} columns"
        return f"{PREFIX}{self.name} {columns}"

    def shapes(self, runs: int, times: int, nx: int) -> dict[str, tuple[int, ...]]:
        """Same as :meth:`.Reduction.shapes`."""
        columns = () if self.columns is None else (self.columns,)
        return {"value": (runs, times, nx, *columns)}

    def part(self, block: Histories) -> Parts:
        """Same as :meth:`.Reduction.part`."""
        return {"value": block.sensitivity[self.name]}


@dataclass(frozen=True, eq=False)
class RunSensitivities(Mapping[str, Array]):
    """Sensitivities of many runs: ``runs.sensitivity["m"]``, (runs, nt, nx) at ``runs.t``.

    Attributes:
        results: Reductions of the ensemble, these among them.
    """

    results: Mapping[str, object] = field(repr=False)
    # output times, the number of runs, and what computes one of them again
    _t: Array = field(repr=False)
    _count: int = field(repr=False)
    _run: Callable[[int], TrajectoryRecord] = field(repr=False)

    def __getitem__(self, name: str) -> Array:
        try:
            return np.asarray(self.results[PREFIX + name])
        except KeyError:
            raise ModelError(
                f"sensitivity: '{name}' was not asked for.{near(name, list(self))}"
            ) from None

    def __iter__(self) -> Iterator[str]:
        return (name.removeprefix(PREFIX) for name in self.results if name.startswith(PREFIX))

    def __len__(self) -> int:
        return sum(1 for _ in self)

    @checked
    def of(self, what: str | tuple[str, str]) -> dict[str, Array]:
        """What a history, a formula or a function changes by in every run, at ``runs.t``.

        ``runs.sensitivity.of("tip")["m"]`` is (runs, nt). Every run is computed again for it, one
        after the other.

        Args:
            what: As of one motion: a name such as ``"tip"`` or ``"energy"``, a formula, or a
                function such as ``("pose", "hand")``.

        Returns:
            By name: (runs, nt, ...), (runs, nt, ..., k) of what consists of k numbers. NaN behind
            the end of a run, and of runs without sensitivities.

        Raises:
            ModelError: nothing was asked for, or the ensemble comes from a file. SolveError: no run
                has sensitivities.
        """
        if not len(self):
            raise ModelError(
                "sensitivity: nothing was asked for: call model.ensemble with sensitivity="
            )
        result: dict[str, Array] = {}
        with collected_warnings():  # the runs have warned before
            for k in range(self._count):
                motion = self._run(k)
                if not isinstance(motion.sensitivity, Sensitivities):
                    continue
                sign = 1.0 if self._t[-1] >= self._t[0] else -1.0
                inside = self._t[sign * (self._t - motion.t[-1]) <= 0]
                for name, values in motion.sensitivity.of(what, inside).items():
                    if name not in result:
                        shape = self._count, len(self._t), *values.shape[1:]
                        result[name] = np.full(shape, np.nan)
                    result[name][k, : len(inside)] = values
        if not result:
            raise SolveError("sensitivity: no run has sensitivities; runs.message(0) says why")
        return result


def requested(
    names: str | Sequence[str],
    model: LoadedModel,
    how: Settings,
    input_signals: Signals,
    inputs: Inputs | None,
) -> tuple[SensitivityRequest | None, dict[str, Reduction]]:
    """The request and how its answers are kept; None and nothing without names.

    Raises:
        ModelError, ArgumentError: what has no derivative.
    """
    if not names:
        return None, {}
    tabulated = {model.inputs[one.input] for one in input_signals.tabulated}
    tables = {str(k): v for k, v in (inputs or {}).items() if k in tabulated}
    listed = unknowns(model, names, tables)
    refuse(model, how, input_signals, listed)
    columns = columns_by_name(model, listed)
    histories: dict[str, Reduction] = {
        PREFIX + name: SensitivityHistories(name, columns[name]) for name in listed.names
    }
    return SensitivityRequest(listed.names, tables), histories


def reread_all(phrases: Mapping[str, str]) -> dict[str, Reduction]:
    """Reductions by name, from their phrases, sensitivities among them.

    Raises:
        ModelError: words that mean nothing.
    """
    result: dict[str, Reduction] = {}
    for name, phrase in phrases.items():
        match = PHRASE.fullmatch(phrase)
        if match is None:
            result |= reread({name: phrase})
        else:
            columns = None if match[2] is None else int(match[2])
            result[name] = SensitivityHistories(match[1], columns)
    return result
