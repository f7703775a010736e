"""Sensitivities along motions: forward, at every time."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from pathlib import Path
from typing import final

import numpy as np
from numpy.typing import NDArray

from ...arguments import Inputs, Times, checked
from ...arrays import Array
from ...errors import ModelError, SolveError, near
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.trajectory.solver_info import EVENT
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ...schema.integrators import INTEGRATORS
from ..simulation.driving import RunSetup, driven, reported, runner_of
from ..simulation.settings import Start
from ..simulation.signals import signals
from ..simulation.spare_runners import rewind
from ..simulation.times import Span
from .differentiable import check_complete, exact_method, refuse, row_behind, rows_of
from .jumps import event_instants
from .output_sensitivities import ChangingStates, changes_of
from .start import named_start
from .tangent import Directions, Tangents, columns_of, directions_of
from .tangent_jumps import TangentJumps
from .unknowns import Unknowns, start_blocks, start_places, unknowns


@dataclass(frozen=True, eq=False)
class Sensitivities(Mapping[str, Array]):
    """What a motion changes by: ``motion.sensitivity["m"]``, (nt, nx) along ``motion.t``.

    Of what consists of several numbers, such as ``"x0"`` or the values of an input, (nt, nx, k). At
    an event the last entry before it is at its time, the first one behind it: times do not move.
    Outputs and other histories: :meth:`of`.

    Attributes:
        names: What it is differentiated by.
    """

    names: tuple[str, ...]
    _changes: Array = field(repr=False)
    _parts: dict[str, tuple[slice, bool]] = field(repr=False)
    _rows: Array = field(repr=False)
    _tangents: Tangents = field(repr=False)
    _modes: tuple[tuple[int, Array], ...] = field(repr=False)

    def __getitem__(self, name: str) -> Array:
        return self._part(name, self._changes)

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)

    def _part(self, name: str, changes: Array) -> Array:
        if name not in self._parts:
            raise ModelError(f"sensitivity: '{name}' was not asked for.{near(name, self.names)}")
        place, single = self._parts[name]
        part = np.moveaxis(changes[:, place], 1, -1)
        return part[..., 0] if single else part

    @checked
    def at(self, t: Times) -> dict[str, Array]:
        """The same at times (m,) inside the motion, by name: (m, nx), or (m, nx, k).

        Raises:
            SolveError: a time outside of the motion.
        """
        changes = self.states_at(np.atleast_1d(np.asarray(t, dtype=np.float64)))[1]
        return {name: self._part(name, changes) for name in self.names}

    @checked
    def of(self, what: str | tuple[str, str], t: Times | None = None) -> dict[str, Array]:
        """What a history, a formula or a function changes by: outputs, energies, forces.

        ``motion.sensitivity.of("tip")["m"]`` is what ``motion["tip"]`` changes by per unit of m,
        through the state and directly.

        Args:
            what: A name that the motion has, such as ``"tip"``, ``"energy"`` or ``"elbow.force"``;
                a formula in names of the model, such as ``"(hand.x - 0.4)^2"``; or a function as
                :meth:`derivative` takes it, such as ``"com"`` or ``("pose", "hand")``.
            t: Times (m,) inside the motion [s]; by default those of the motion.

        Returns:
            By name of what the motion is differentiated by: (m, ...) of the shape of the history,
            (m, ..., k) of what consists of k numbers. In units of the history per unit of that.

        Raises:
            ModelError, DerivationError: no such name, formula or function. ArgumentError: a
                function of more than the state. SolveError: a time outside of the motion.
        """
        times = None if t is None else np.atleast_1d(np.asarray(t, dtype=np.float64))
        changes = changes_of(self._tangents.model, what, self._changing(times))
        return {name: self._part(name, changes) for name in self.names}

    def _changing(self, times: Array | None) -> ChangingStates:
        """States with their changes at times (m,), or at those of the motion."""
        tangents, rows, model = self._tangents, self._rows, self._tangents.model
        first = 1 + tangents.runner.n
        r, s = np.split(rows[:, first:], [model.nr], axis=1)
        s, modes = s[:, : model.ns], np.empty((len(rows), *self._modes[0][1].shape))
        for begin, by_s in self._modes:
            modes[begin:] = by_s
        if times is None:
            times, x, by_x = rows[:, 0], rows[:, 1 : 1 + model.nx], self._changes
        else:
            x, by_x = self.states_at(times)
            places = self._row_before(times)
            s, modes = s[places], modes[places]
            r = np.array([tangents.inputs_at(at)[0] for at in times])
        by_r = np.array([tangents.input_changes(at) for at in times])
        by_r = by_r.reshape(*by_x.shape[:2], model.nr)
        parameters, directions = list(model.parameters), tangents.directions
        moved = directions.moved
        names = tuple(parameters[k] for k in moved)
        r = r.reshape(len(times), model.nr)
        by_p = directions.p[:, moved]
        return ChangingStates(times, x, r, s, by_x, by_r, modes, names, by_p)

    def states_at(self, times: Array) -> tuple[Array, Array]:
        """States (m, nx) at times inside the motion, and their changes (m, k, nx).

        Raises:
            SolveError: a time outside of the motion.
        """
        rows, first, last = self._rows, self._rows[0, 0], self._rows[-1, 0]
        sign, nx = 1.0 if last >= first else -1.0, self._changes.shape[2]
        outside = (times - first) * sign < 0
        if (outside | ((last - times) * sign < 0)).any():
            raise SolveError(f"sensitivity: the motion goes from {first:g} s to {last:g} s")
        places = self._row_before(times)
        states, changes = rows[places, 1 : 1 + nx], self._changes[places]
        for k, (time, row) in enumerate(zip(times, places, strict=True)):
            if time != rows[row, 0]:
                # one step from the row before, as long as it takes
                step = np.vstack([rows[row], rows[row]])
                step[1, 0] = time
                self._tangents.by_s[:] = next(s for at, s in reversed(self._modes) if at <= row)
                over = self._tangents.pass_at(float(time))
                if over is None:
                    changes[k] = self._inside(step, self._changes[row])
                    states[k] = step[1, 1 : 1 + nx]
                else:
                    states[k], changes[k] = self._within_pass(over, float(time))
        return states, changes

    def _row_before(self, times: Array) -> NDArray[np.intp]:
        """Numbers of the last rows that are not behind times (m,)."""
        sign = 1.0 if self._rows[-1, 0] >= self._rows[0, 0] else -1.0
        return np.searchsorted(sign * self._rows[:, 0], sign * times, side="right") - 1

    def _within_pass(self, over: tuple[float, float, int], time: float) -> tuple[Array, Array]:
        """State (nx,) and changes (k, nx) within a step over a place where branches meet."""
        tangents, nx = self._tangents, self._changes.shape[2]
        sign = np.sign(over[1])
        # its end may have been moved to a stop beside it
        ends = [sign * over[0], sign * (over[0] + over[1] * (1 - 1e-9))]
        first, last = np.searchsorted(sign * self._rows[:, 0], ends)
        rows = self._rows[[first, first, last]].copy()
        rows[1, 0] = time
        changes = tangents.over(rows, self._changes[first])[1]
        return tangents.state_within(over, time, rows[0, 1 : 1 + nx]), changes

    def _inside(self, step: Array, first: Array) -> Array:
        """Changes at the end of a step, whose state is filled in."""
        tangents = self._tangents
        changes = tangents.over(step, first)[1]
        step[1, 1 : 1 + tangents.model.nx] = tangents.rooms["end"]
        if tangents.runner.closing.rates:
            # speeds are projected at the positions there
            changes = tangents.over(step, first)[1]
        return np.asarray(changes)


def differentiated(
    setup: RunSetup,
    names: str | Sequence[str],
    state: Mapping[str, object],
    inputs: Inputs | None,
    checkpoint: str | Path | None,
    check: bool,
    progress: bool | Callable[[float], None] | None,
) -> TrajectoryRecord:
    """A motion with its sensitivities.

    Args:
        setup: The run.
        names: What it is differentiated by.
        state: x0, q, u and z as they were given.
        inputs, checkpoint, check, progress: As ``simulate`` takes them.

    Raises:
        ModelError, ArgumentError, SolveError: as :func:`.gradient.gradient`.
    """
    if checkpoint is not None:
        raise ModelError("sensitivity= goes without checkpoint=")
    if setup.over.times is not None:
        raise ModelError(
            "sensitivity= goes with an end time or a pair: motion.sensitivity.at(times) gives it "
            "at any times"
        )
    runs = SensitiveRuns(setup, names, inputs)
    return runs.run(setup.over, setup.begin, state, check, progress)


@final
class SensitiveRuns:
    """Runs of a model with their sensitivities, one after the other: they differ by their start.

    Attributes:
        setup: Of the first one.
        names: What they are differentiated by.
        runner: What takes their steps.
    """

    def __init__(
        self,
        setup: RunSetup,
        names: str | Sequence[str],
        inputs: Inputs | None,
        directions: Directions | None = None,
    ) -> None:
        """Args:
        setup: Of the first one.
        names: What they are differentiated by.
        inputs: As ``simulate`` takes them.
        directions: Of parameters and inputs, where runs have columns; else one for each number.

        Raises:
            ModelError, ArgumentError: what has no gradient.
        """
        how = setup.how
        if setup.case is not None:
            # the method was left open
            how = replace(how, method=INTEGRATORS[exact_method(setup.model)])
        self.setup = setup = replace(setup, how=how, case=None)
        listed = unknowns(setup.model, names, {str(k): v for k, v in (inputs or {}).items()})
        refuse(setup.model, setup.how, setup.input_signals, listed)
        self.names, self._unknowns = listed.names, listed
        self.runner = runner_of(setup.model, setup.how, setup.input_signals, setup.event_table)
        self._parts: dict[str, tuple[slice, bool]] = {}
        if directions is None:
            directions, self._parts = _directions(setup, listed)
        self._tangents = Tangents(self.runner, directions)

    @property
    def steps(self) -> int:
        """Steps of the last run, or so far of the one that is under way."""
        return int(self.runner.record.steps)

    def run(
        self,
        over: Span,
        begin: Start,
        state: Mapping[str, object],
        check: bool = False,
        progress: bool | Callable[[float], None] | None = False,
        dense: bool = True,
        columns: Array | None = None,
    ) -> TrajectoryRecord:
        """A motion with its sensitivities.

        Args:
            over, begin: When and where it begins, and its end.
            state: x0, q, u and z as they were given.
            check, progress: As ``simulate`` takes them.
            dense: Keep what tells states between steps.
            columns: Of the start along the speeds (k, 2 nu + nz); by default those of the names.

        Raises:
            SolveError: it is not complete, or has no derivative. KeyboardInterrupt: by Ctrl-C.
        """
        motion = self.drive(over, begin, progress, dense)
        if motion.status == "interrupted":
            raise KeyboardInterrupt
        along = self.along(motion, over, begin, state, columns)
        return replace(reported(motion, check), sensitivity=along)

    def drive(
        self,
        over: Span,
        begin: Start,
        progress: bool | Callable[[float], None] | None = False,
        dense: bool = True,
    ) -> TrajectoryRecord:
        """A motion alone, however it ends; the arguments are those of :meth:`run`."""
        rewind(self.runner)
        return driven(self.runner, over, begin, progress, dense=dense)

    def along(
        self,
        motion: TrajectoryRecord,
        over: Span,
        begin: Start,
        state: Mapping[str, object],
        columns: Array | None = None,
    ) -> Sensitivities:
        """Changes along the motion that was driven last.

        Args:
            motion: What :meth:`drive` gave.
            over, begin, state, columns: As :meth:`run` takes them.

        Raises:
            SolveError: it is not complete, or has no derivative.
        """
        check_complete(motion, self.runner)
        setup = replace(self.setup, over=over, begin=begin)
        model, log, tangents = setup.model, motion.event_log, self._tangents
        directions = tangents.directions
        tangents.by_s[:] = 0.0
        wide = bool(directions.moved)
        named = named_start(setup, tangents, state, log.s[0], self._unknowns, wide)
        by_r = tangents.input_changes(setup.over.start)
        by_p = directions.p if directions.moved else np.zeros((len(by_r), 0))
        starts = directions.start if columns is None else columns
        first = named.forward(starts, by_r, by_p)
        jumps = TangentJumps(tangents, setup.event_table, setup.over.start)
        rows, changes = rows_of(motion, self.runner), list[Array]()
        modes, start = [(0, tangents.by_s.copy())], 0
        instants = event_instants(log.log, setup.event_table, model.nx, model.ns)
        # where an event ends the run, times do not move
        for at in instants[: -1 if motion.solver_info.status == EVENT else None]:
            behind = row_behind(motion.t, len(rows), at)
            # where modes alone change, one row stands for both sides
            one_row = behind == start or motion.t[behind - 1] != at.t
            part = tangents.over(rows[start : behind + one_row], first)
            # at its time before it; the row behind it begins the next part
            changes.append(part[: behind - start])
            first, start = jumps.push(at, part[-1]), behind
            modes.append((behind, tangents.by_s.copy()))
        changes.append(tangents.over(rows[start:], first))
        along = np.concatenate(changes)
        return Sensitivities(self.names, along, self._parts, rows, tangents, tuple(modes))


def _directions(
    setup: RunSetup, listed: Unknowns
) -> tuple[Directions, dict[str, tuple[slice, bool]]]:
    """Directions of everything by name, and which belong to which name."""
    model, tabulated = setup.model, setup.input_signals.tabulated
    names, places = list(model.parameters), start_places(model) | start_blocks(model)
    tables = {name: listed.table(name) for name in listed.names if name in model.inputs}
    by_name = columns_by_name(model, listed)
    sizes = [1 if size is None else size for size in by_name.values()]
    columns = columns_of(sizes)  # a unit of every number that is wanted, one after the other
    directions = directions_of(model, sum(len(one.coefficients) for one in tabulated), sum(sizes))
    for name, column in zip(listed.names, columns, strict=True):
        table = tables.get(name)
        if name in places:
            directions.start[column, places[name]] = np.eye(column.stop - column.start)
        elif name == "p":
            directions.p[column] = np.eye(len(names))
        elif name in names:
            directions.p[column, names.index(name)] = 1.0
        elif table is None:
            directions.r[column, model.inputs.index(name)] = 1.0
        else:
            directions.coefficients[column] = _coefficients(setup, name, table[0])
    parts = zip(columns, (size is None for size in by_name.values()), strict=True)
    return directions, dict(zip(listed.names, parts, strict=True))


def columns_by_name(model: LoadedModel, listed: Unknowns) -> dict[str, int | None]:
    """How many numbers everything by name consists of; None of what is a number itself."""
    blocks, result = start_blocks(model), dict[str, int | None]()
    places = start_places(model) | blocks
    for name in listed.names:
        table = listed.table(name) if name in model.inputs else None
        if name in places:
            size = places[name].stop - places[name].start
            result[name] = None if size == 1 and name not in blocks else size
        elif name == "p":
            result[name] = len(model.parameters)
        else:
            result[name] = None if table is None else len(table[0])
    return result


def _coefficients(setup: RunSetup, name: str, times: Array) -> Array:
    """Coefficients (n, segments, 4) of all tabulated inputs per unit of each value of one."""
    tabulated, result = setup.input_signals.tabulated, []
    span = (float(times[0]), float(times[-1]))
    for unit in np.eye(len(times)):
        rows = signals(setup.model.manifest.inputs, {name: (times, unit)}, None, span).tabulated
        by_input = {one.input: one.coefficients for one in rows}
        every = [by_input.get(x.input, 0 * x.coefficients) for x in tabulated]
        result.append(np.concatenate(every))
    return np.array(result)
