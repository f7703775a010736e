"""The sweep of ``kernels/sensitivity/tangent.c`` forward over the steps of a run."""

from __future__ import annotations

from collections.abc import Sequence
from typing import final

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ...schema.blocks import DIRECTIONS
from ...schema.records import Tangent
from ...schema.request import Request
from ..simulation.run import Runner
from .steps import CLOSING, MOST_STAGES, StepsAgain, powers_at, segment_at

# over elements: entries of a state per column, from which on columns one by one, at factors that
# they share, cost less than a derivative
FEW = 1
# the same where stages of an implicit method follow each other
FEW_IN_STAGES = 3
# changes up to which they cost less one by one in joint coordinates
FEW_OF_TREES = 2
WIDE = 8  # CARDAN_SIDE_BY_SIDE of tangent.h


@dataclass(frozen=True)
class Directions:
    """Directions of change, one in each row.

    Attributes:
        start: Of the start as it was named, along the speeds: (k, 2 nu + nz).
        p: Of the parameters (k, np).
        r: Of inputs that are constant (k, nr).
        coefficients: Of tabulated inputs: of their coefficients (k, segments, 4).
    """

    start: Array
    p: Array
    r: Array
    coefficients: Array

    @property
    def moved(self) -> list[int]:
        """Parameters that change along some direction."""
        return [int(k) for k in np.flatnonzero((self.p != 0).any(axis=0))]


@final
class Tangents(StepsAgain):
    """Changes of a motion along directions.

    Attributes:
        directions: What changes.
        by_s: Changes of the modes (k, ns) since the last event.
    """

    def __init__(
        self, runner: Runner, directions: Directions, model: LoadedModel | None = None
    ) -> None:
        """Args:
        runner: What took the steps.
        directions: What changes.
        model: Its model with the parameters of the run, where these are others than its own.
        """
        super().__init__(runner)
        self.model = model = runner.model if model is None else model
        record, k = Tangent(), len(directions.start)
        self.record, self.directions = record, directions
        self.by_s = np.zeros((k, model.ns))
        # the C has columns of single names in alphabetical order, behind those of blocks
        names = list(model.parameters)
        # one column of C for each parameter that changes: all of a large robot would cost more
        named = sorted(names[k] for k in directions.moved)
        self._named = tuple(named)
        self._check_names()
        by_named = directions.p[:, [names.index(name) for name in named]]
        # what runs project onto constraints by is differentiated like every step
        closing = runner.closing
        # few changes are found one by one, others by all columns of a derivative
        few = FEW_IN_STAGES if self.steps.kind else FEW
        pushed = few * k < model.nx if model.manifest.absolute else k <= FEW_OF_TREES
        record.pushed, row = int(pushed), "jvp" if pushed else "derivative"
        keys = {"rates": (row, self.request("rhs"))}
        keys |= {name: (row, self.request(name)) for name in closing.functions if name in CLOSING}
        functions = dict(zip(keys, model._load(list(keys.values())), strict=True))
        self.call(record, functions)
        record.columns, record.named = k, len(named)
        record.segments, record.wide = directions.coefficients.shape[1], -(-k // WIDE) * WIDE
        # parameter by parameter: in which columns it changes
        which, columns = np.nonzero(by_named.T)
        longest = max(function.entry.output_size for function in functions.values())
        read = model.nx + model.ns + model.nr
        rooms = {
            "named_ends": np.cumsum(np.bincount(which, minlength=len(named))),
            "named_columns": columns, "named_changes": by_named.T[which, columns],
            "by_input": directions.r,
            "by_coefficients": directions.coefficients,
            "by_s": self.by_s, "before": np.zeros(model.nx * record.wide),
            "moved": np.zeros((read + 1) * record.wide), "along": np.zeros(read + len(named) + 1),
            "changed": np.zeros(model.nx * record.wide),
            "rising": np.zeros(MOST_STAGES * model.nx * record.wide), "out": np.zeros(longest),
            "coupled": np.zeros(max(self.steps.stages, k) * model.nx),
        }  # fmt: skip
        for name, room in rooms.items():
            setattr(record, name, self.pointer(_filled(room)))
        if self.steps.kind and model.manifest.absolute and not pushed:
            self.steps.jacobians = self.pointer(np.zeros(self.steps.stages * model.nx**2))
        if self.by_s.size:
            record.by_s = self.pointer(self.by_s)

    def _check_names(self) -> None:
        """Refuse parameters that nothing can be differentiated by alone.

        Raises:
            ModelError: there is one.
        """
        for name in self._named:
            if name in DIRECTIONS:
                raise ModelError(
                    f"gradient: parameter '{name}' of '{self.model.name}' is called as the block "
                    f"'{name}' of all functions is, and cannot be told from it: rename it"
                )

    def request(self, function: str, time: bool = False) -> str:
        """Derivative of a function along state, modes, inputs and parameters that change."""
        blocks = [*["t"] * time, *self.sizes()]
        return str(Request(function, None, (*blocks, *self._named)))

    def over(self, rows: Array, first: Array) -> Array:
        """Changes (count, k, nx) at rows (count, width) from those at the first one (k, nx).

        Raises:
            SolveError: a function has no value at a stage of a step, or derivatives grow beyond
                all use.
        """
        changes = np.zeros((len(rows), *first.shape))
        changes[0] = first
        self.record.changes = changes.ctypes.data
        self.swept(rows, self.runner.library.cardan_tangent_sweep, self.record)
        # columns by parameters begin with nothing: from the end of the first step on
        self.check_growth(changes[min(1, len(changes) - 1)], changes[-1], rows[:, 0])
        return changes

    def input_changes(self, t: float) -> Array:
        """Changes of the inputs (k, nr) at a time, as they are before it."""
        changes, start = self.directions.r.copy(), 0
        for one in self.runner.signals.tabulated:
            segment = start + segment_at(one, t)[0]
            changes[:, one.input] = self.directions.coefficients[:, segment] @ powers_at(one, t)[0]
            start += len(one.coefficients)
        return changes

    def along(
        self, function: str, at: dict[str, object], times: Array, x: Array, s: Array, r: Array
    ) -> Array:
        """Changes (k, size) of the result of a function.

        Args:
            function: Which.
            at: Its arguments by letter.
            times, x, s, r: Changes of the time (k,), the state, modes and inputs.
        """
        from ...schema.request import reads

        request, model = self.request(function, time=True), self.model
        names = list(model.parameters)
        named = self.directions.p[:, [names.index(name) for name in self._named]]
        v = np.hstack([times[:, None], x, s, r, named])
        values = tuple({**at, "v": v}[one] for one in reads("jvp", request))
        return np.asarray(model._evaluate(("jvp", request), values, None, None))


def _filled(room: Array) -> Array:
    """An array that has an address, contiguous."""
    return np.ascontiguousarray(room) if room.size else np.zeros(1)


def directions_of(model: LoadedModel, segments: int, count: int) -> Directions:
    """Directions that change nothing yet."""
    start = np.zeros((count, 2 * model.nu + model.nz))
    p, r = np.zeros((count, len(model.parameters))), np.zeros((count, model.nr))
    return Directions(start, p, r, np.zeros((count, segments, 4)))


def columns_of(sizes: Sequence[int]) -> list[slice]:
    """Where parts of these sizes are, one after the other."""
    ends = np.cumsum(sizes)
    return [slice(int(end - size), int(end)) for end, size in zip(ends, sizes, strict=True)]
