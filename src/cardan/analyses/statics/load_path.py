"""Quantities that a load path changes: parameters, inputs, locked coordinates and time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, brief, near
from ...records import dataclass
from ..systems.dynamic_system import DynamicSystem
from .static_problem import Load

SPEED = "speed"
TIME = "t"


@dataclass(frozen=True, eq=False)
class Loading:
    """Loads along a path from 0 to 1.

    Attributes:
        system: What is loaded.
        base: What stays.
        swept: Name -> values (n,), evenly over the path; n is 2 for a range.
        kinds: Name -> ``"parameter"``, ``"input"``, ``"locked"``, ``"speed"`` or ``"t"``.
        stations: Where rows are wanted (n,), None for wherever steps end.
    """

    system: DynamicSystem
    base: Load
    swept: Mapping[str, Array]
    kinds: Mapping[str, str]
    stations: Array | None

    def values(self, s: float) -> dict[str, float]:
        """Swept values at a place of the path; beyond its ends straight on."""
        return {name: _interpolated(column, s) for name, column in self.swept.items()}

    def at(self, s: float) -> Load:
        """The load at a place of the path."""
        load, r = self.base, self.base.r.copy()
        parameters, locked = dict(load.parameters or {}), dict(load.locked)
        t, u = load.t, None if load.u is None else dict(load.u)
        for name, value in self.values(s).items():
            kind = self.kinds[name]
            if kind == "parameter":
                parameters[name] = value
            elif kind == "input":
                r[self.system.inputs.index(name)] = value
            elif kind == "locked":
                locked[name] = value
            elif kind == SPEED:
                u = {**(u or {}), name: value}
            else:
                t = value
        return replace(load, t=t, r=r, parameters=parameters or None, locked=locked, u=u)


def _interpolated(column: Array, s: float) -> float:
    """The value at a place of a path with evenly spaced values, continued beyond its ends."""
    if 0 < s < 1:
        return float(np.interp(s, np.linspace(0, 1, len(column)), column))
    first, last = (0, 1) if s <= 0 else (-2, -1)
    slope = (len(column) - 1) * (column[last] - column[first])
    return float(column[first] + s * slope if s <= 0 else column[last] + (s - 1) * slope)


def loading(
    system: DynamicSystem, kind_of: Mapping[str, str], base: Load, swept: Mapping[str, object],
    locked: Mapping[str, object], said: str, speeds: Mapping[str, object] | None = None,
) -> Loading:  # fmt: skip
    """A load path out of what a user wrote.

    Args:
        system: What is loaded.
        kind_of: Name -> kind of everything that can be swept.
        base: What stays.
        swept: Name -> (start, end) or values (n,).
        locked: Coordinate -> the same.
        said: The analysis, for messages.
        speeds: Speed of a steady motion -> the same.

    Raises:
        ModelError: nothing is swept, or an unknown name.
        ArgumentError: values of a wrong shape or different numbers of them.
        SolveError: values that are not finite.
    """
    if not (swept or locked or speeds):
        raise ModelError(
            f"{said}: say what is swept, from where to where, such as {said}(P=(0, 10)). "
            f"{near('', kind_of).strip()}"
        )
    columns, kinds = dict[str, Array](), dict[str, str]()
    for name, values in swept.items():
        if name not in kind_of:
            raise ModelError(
                f"{said}: there is no parameter or input '{name}' to sweep; coordinates are "
                f"swept by locked={{'...': (0, 1)}}.{near(name, kind_of)}"
            )
        columns[name], kinds[name] = column(f"{said}: {name}", values), kind_of[name]
    for name, values in locked.items():
        system.place(name)
        if name in columns:
            raise ModelError(f"{said}: '{name}' is swept and held: leave one out")
        columns[name], kinds[name] = column(f"{said}: {name}", values), "locked"
    for name, values in (speeds or {}).items():
        columns[name], kinds[name] = column(f"{said}: u: {name}", values), SPEED
    counts = {name: len(column) for name, column in columns.items()}
    if len(set(counts.values())) > 1:
        said = ", ".join(f"'{name}' has {n}" for name, n in counts.items())
        raise ArgumentError(f"{said}: all that is swept goes together: {said} values")
    n = next(iter(counts.values()))
    base = replace(base, prescribed=tuple(locked))
    return Loading(system, base, columns, kinds, None if n == 2 else np.linspace(0, 1, n))


def column(name: str, values: object, count: int = 2) -> Array:
    """Values of one name, checked; two of them are the ends of ``count``.

    Raises:
        ModelError: they are not numbers in a row.
    """
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        array = np.zeros(())
    if array.ndim != 1 or len(array) < 2:
        raise ArgumentError(f"{name}={brief(values)}: give (start, end), or values (n,)")
    if not np.isfinite(array).all():
        raise SolveError(f"{name}={brief(values)}: they must be finite")
    return array if len(array) > 2 else np.linspace(array[0], array[1], count)
