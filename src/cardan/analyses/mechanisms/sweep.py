"""Kinematic analysis: a mechanism that is driven through given values of a coordinate."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import LockedValues, checked
from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, SolveWarning, counted, near, warn
from ...runtime.calls.evaluation import State
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.models.named_rotations import component
from ...runtime.trajectory.solver_info import FINISHED
from .assemble import assemble
from .consistent_rates import accelerations, speeds
from .drive import Drive, Stuck
from .mechanism import Mechanism, refuse_nodes
from .targets import locked_values

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FASTEST = 1e100  # of a driver: its square is a number too


@dataclass(frozen=True, repr=False, eq=False)
class SweepRecord:
    """Positions, speeds and accelerations of a driven mechanism.

    ``sweep["D"]``, ``sweep["D.u"]`` and ``sweep["D.udot"]`` are histories (n,) by name.

    Attributes:
        model: The model.
        drivers: Name -> values (n,) of what is driven.
        t, r: Times (n,) [s] and inputs (n, nr) of the positions.
        q, u, udot: (n, nq), (n, nu), (n, nu); udot is empty (n, 0) without ``forward_dynamics``.
        quality: Smallest singular value of the driven constraints, without units (n,): 0 where the
            drive loses hold of the mechanism.
        status: ``"finished"``, or ``"singular"`` where the mechanism could not follow.
        message: The same as a sentence.
    """

    model: LoadedModel
    drivers: Mapping[str, Array]
    t: Array
    r: Array
    q: Array
    u: Array
    udot: Array
    quality: Array
    status: str
    message: str

    @property
    def success(self) -> bool:
        """True when all values were reached."""
        return self.status == FINISHED

    @property
    def values(self) -> Array:
        """Values of the first driver (n,)."""
        return next(iter(self.drivers.values()))

    def __len__(self) -> int:
        return len(self.q)

    def __getitem__(self, name: str) -> Array:
        """History of a coordinate, of a speed ``D.u`` or of an acceleration ``D.udot``.

        Raises:
            ModelError: no such name.
        """
        if name in self.drivers and name not in self.model.coordinates:
            return self.drivers[name]
        blocks = ((".udot", "u", self.udot), (".u", "u", self.u), ("", "q", self.q))
        for ending, letter, values in blocks:
            places = self.model.manifest.slots(letter)
            place = places.get(name.removesuffix(ending)) if name.endswith(ending) else None
            if place is None and ending == ".udot" and name.endswith(ending):
                place = places.get(f"{name.removesuffix(ending)}.u")
            if place is not None and values.shape[1]:
                columns = values[:, place]
                return columns[:, 0] if columns.shape[1] == 1 else columns
        names = [*self.model.coordinates, *self.model.speeds]
        raise ModelError(f"sweep['{name}']: there is no such history.{near(name, names)}")

    @checked
    def pose(self, frame: str) -> Array:
        """Transforms (n, 4, 4) from frame axes to ground axes."""
        return self.model.pose(frame, self.q)

    def __repr__(self) -> str:
        names = " and ".join(f"'{name}'" for name in self.drivers)
        first = self.values
        span = f"{first[0]:g} to {first[-1]:g}" if len(first) else "no values"
        lines = [f"sweep of {names} of '{self.model.name}', {span}: {self.message}"]
        if len(self):
            worst = int(np.argmin(self.quality))
            lines.append(
                f"  {counted(len(self), 'position')}; smallest singular value of the driven "
                f"constraints {self.quality[worst]:.3g}, at {first[worst]:.6g}"
            )
        return "\n".join(lines)


@checked
def sweep(
    model: LoadedModel,
    driver: str | Mapping[str, ArrayLike],
    values: ArrayLike | None = None,
    *,
    rate: float = 1.0,
    acceleration: float = 0.0,
    locked: LockedValues | None = None,
    start: Mapping[str, ArrayLike] | ArrayLike | None = None,
    branch: Mapping[str, object] | None = None,
    t: float = 0.0,
    r: State | None = None,
    check: bool = False,
) -> SweepRecord:
    """Drive a mechanism through given values and keep its branch.

    Args:
        model: The compiled model.
        driver: Coordinate that is driven, or several with their values: they go together.
        values: Of the one driver (n,).
        rate, acceleration: Derivatives of the driver over time, for speeds and accelerations; of
            several drivers those of the first, the others follow in proportion.
        locked: Further coordinates or frames that keep a value, as ``assemble`` takes them.
        start: Coordinates near those of the first position; branch: as ``assemble`` takes it.
        t, r: Time [s] and inputs, where something is prescribed.
        check: Raise where the mechanism cannot follow, instead of warning.

    Returns:
        The positions reached, each next to the one before.

    Raises:
        ModelError: unknown names, a first position that cannot be assembled, freedoms left.
        ArgumentError: values of a wrong shape. SolveError: values that are not finite; with
            ``check``, a mechanism that cannot follow.
    """
    for word, value in (("rate", rate), ("acceleration", acceleration)):
        if not abs(value) <= FASTEST:
            raise SolveError(f"sweep: {word}={value:g}; it must be finite, up to {FASTEST:g}")
    drivers = _drivers(model, driver, values)
    refuse_nodes(model, "sweep")
    m, table = Mechanism(model, t, r), np.stack([*drivers.values()], axis=1)
    locked_targets = locked_values(m, locked)
    drive = Drive(m, list(drivers), locked_targets)
    at = drive.at(table[0])
    first = {n: float(c[0]) for n, c in drivers.items() if n not in drive.inputs}
    begin = assemble(model, first | locked_targets, start=start, branch=branch, t=t, r=at.r)
    drive.check(at, begin.q)
    rows, message = _follow(drive, begin.q, table)
    places = [drive.at(row) for row in table[: len(rows)]]
    record = SweepRecord(
        model,
        {name: column[: len(rows)] for name, column in drivers.items()},
        np.array([place.t for place in places]),
        np.array([place.inputs for place in places]).reshape(len(rows), model.nr),
        *_motion(drive, rows, table, rate, acceleration),
        status=FINISHED if message is None else "singular",
        message=message or "reached all values",
    )
    if message is not None:
        if check:
            raise SolveError(message)
        warn(message, SolveWarning)
    return record


def _drivers(model: LoadedModel, driver: Any, values: Any) -> dict[str, Array]:
    """Name -> values of all drivers, checked."""
    named = driver if isinstance(driver, Mapping) else {driver: values}
    if isinstance(driver, Mapping) == (values is not None) or not named:
        raise ArgumentError(
            "sweep: driver= is a coordinate and values= its values, or it is {coordinate: values}"
        )
    columns: dict[str, Array] = {}
    for name, column in named.items():
        moved = [name for name in model.inputs if f"{name}.rate" in model.inputs]
        if name not in model.coordinates and name not in moved:
            names = [*model.coordinates, *moved]
            part = component(model.manifest, name)
            if part:
                raise ModelError(f"sweep: {part}")
            raise ModelError(f"sweep: there is no coordinate '{name}'.{near(name, names)}")
        array = np.asarray(column, dtype=np.float64)
        if array.ndim != 1 or len(array) == 0:
            raise ArgumentError(f"sweep: the values of '{name}' have shape {array.shape}, not (n,)")
        if not np.isfinite(array).all():
            raise SolveError(f"sweep: the values of '{name}' must be finite")
        columns[name] = array
    if len({len(column) for column in columns.values()}) > 1:
        raise ArgumentError("sweep: all drivers need the same number of values")
    return columns


def _follow(drive: Drive, q: Array, table: Array) -> tuple[list[Array], str | None]:
    """Positions at the rows of a table, each from the one before; why it ends early."""
    rows = [q]
    for before, after in pairwise(table):
        try:
            rows.append(drive.go(rows[-1], before, after))
        except Stuck as stuck:
            return rows, str(stuck)
    return rows, None


def _motion(
    drive: Drive, rows: list[Array], table: Array, rate: float, acceleration: float
) -> tuple[Array, Array, Array, Array]:
    """q, u, udot and the quality of the drive at all positions."""
    model = drive.m.model
    dynamic = "forward_dynamics" in model.manifest.available
    slopes = _slopes(table)
    u, udot, quality = [], [], []
    for q, values, slope in zip(rows, table, slopes, strict=False):
        m = drive.at(values, rate * slope, acceleration * slope)
        u.append(speeds(m, q, drive.speeds(rate * slope), np.zeros(model.nu)))
        if dynamic:
            udot.append(accelerations(m, q, u[-1], drive.speeds(acceleration * slope)))
        quality.append(drive.rank_margin(m, q)[0])
    rates = np.array(udot) if dynamic else np.zeros((len(rows), 0))
    return np.array(rows), np.array(u), rates, np.array(quality)


def _slopes(table: Array) -> Array:
    """Change of every driver for one of the first (n, drivers)."""
    if table.shape[1] == 1 or len(table) == 1:
        return np.ones_like(table)
    changes = np.gradient(table, axis=0)
    first = changes[:, :1]
    return np.divide(changes, first, out=np.zeros_like(changes), where=first != 0)


@checked
def plot(
    sweep: SweepRecord, path: str | Path | None = None, names: Sequence[str] | None = None
) -> Figure:
    """Histories over the driver as a Matplotlib figure, written to ``path`` if given.

    Raises:
        ModelError: unknown names, or a path that is not a picture file.
        ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
    """
    from ...view.plot import checked_names, plot_over

    names = checked_names(names) if names is not None else [*sweep.model.coordinates]
    curves = {name: sweep[name] for name in names}
    return plot_over(sweep.model.name, next(iter(sweep.drivers)), sweep.values, curves, path)
