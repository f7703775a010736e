"""Sections: events at which laps of a motion begin and end."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, ModelError, brief, near
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ..simulation.events import DIRECTIONS, EventTable, event_table_of
from .flow import Flow, Passage
from .named_states import named_state, state_names

NAME = "section"  # of what is no event of the model


@dataclass(frozen=True, eq=False)
class Section:
    """The event that ends a lap.

    Attributes:
        name: As in ``motion.events``.
        event_table: All events of the runs.
        numbers: Which of them it is.
        holds: What the state (nx,) before it must fulfill.
        crossing: Which of those that do ends a lap.
    """

    name: str
    event_table: EventTable
    numbers: tuple[int, ...]
    holds: Callable[[Array], bool]
    crossing: int

    def counter(self, start: float, resolution: float) -> Callable[[Passage], bool]:
        """What says that an event ends a lap that begins at a time; one for each run."""
        left = self.crossing

        def ends(passage: Passage) -> bool:
            nonlocal left
            there = passage.t - start > resolution and passage.fired[list(self.numbers)].any()
            if not there or not self.holds(passage.x):
                return False
            left -= 1
            return left == 0

        return ends

    def value(self, flow: Flow, t: float, x: Array, s: Array) -> float:
        """What passes zero at the section."""
        number, model = self.numbers[0], self.event_table.model
        if number < model:
            return float(flow.event_values(x, s, t)[number])
        return self.event_table.watch(t, x)[number - model]


def section_of(model: LoadedModel, section: object, where: object, crossing: int) -> Section:
    """The section that a caller names.

    Args:
        model: The model.
        section: Name of an event of the model, also without its last part; or what ``simulate``
            watches for: a function of t and x, ``("elbow", 0.5)``, with a direction
            ``(("elbow", 0.5), "up")``.
        where: What must hold before it: name -> (low, high), or a function of the named state.
        crossing: Which of the events at which that holds ends a lap.

    Raises:
        ModelError: an unknown name. ArgumentError: conditions of another kind.
    """
    if crossing < 1:
        raise ModelError(f"cycle: crossing={crossing}: they are counted from 1")
    holds = _holds(model, where)
    if not isinstance(section, str):
        table = event_table_of(model, {NAME: _watched(section)})
        return Section(NAME, table, tuple(range(table.model, len(table.rows))), holds, crossing)
    table = event_table_of(model, None)
    names = [str(row["name"]) for row in table.rows]
    numbers = tuple(k for k, name in enumerate(names) if section in (name, name.rpartition(".")[0]))
    if not numbers:
        raise ModelError(
            f"cycle: there is no event '{section}' that a lap could end at.{near(section, names)}"
        )
    return Section(section, table, numbers, holds, crossing)


def _watched(section: object) -> tuple[object, ...]:
    """The same as ``events=`` of a run takes it: noted alone."""
    if isinstance(section, tuple) and len(section) == 2 and section[1] in (*DIRECTIONS,):
        return section[0], "mark", section[1]
    return section, "mark"


def _holds(model: LoadedModel, where: object) -> Callable[[Array], bool]:
    """The condition as a function of a state (nx,)."""
    if where is None:
        return lambda x: True
    if callable(where):
        return lambda x: bool(where(named_state(model, x)))
    if not isinstance(where, Mapping):
        raise ArgumentError(
            f"cycle: where={brief(where)}; give name -> (low, high), or a function of the named "
            "state"
        )
    names, ranges = state_names(model), list[tuple[int, float, float]]()
    for name, limits in where.items():
        if name not in names:
            raise ModelError(f"cycle: where: there is no '{name}'.{near(name, names)}")
        if np.shape(limits) != (2,):
            raise ArgumentError(f"cycle: where: '{name}': {brief(limits)}; give (low, high)")
        ranges.append((names.index(name), float(limits[0]), float(limits[1])))
    return lambda x: all(low <= x[k] <= high for k, low, high in ranges)
