"""Kinematic analysis: a mechanism that is driven through given values of a coordinate."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import LockedValues, checked
from ...arrays import Array, Integers
from ...errors import ArgumentError, ModelError, SolveError, counted, near
from ...records import dataclass
from ...runtime.calls.evaluation import State
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.models.named_rotations import component
from ...runtime.trajectory.solver_info import FINISHED
from ..simulation.progress import Show
from ..statics.snap import Snap
from .assemble import assemble_by_constraints
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
            drive loses hold of the mechanism. By strain energy the lowest eigenvalue of the
            stiffness on what constraints and drivers allow [J], infinite where they allow nothing.
        status: ``"finished"``, ``"singular"`` where the mechanism could not follow, or
            ``"interrupted"``.
        message: The same as a sentence.
        energy: Strain energy (n,) [J]; empty where it was not asked to be least, as is what
            follows. Then udot is empty (n, 0).
        holding_forces: Name of what is driven or held -> force that this takes (n,) [N, N m]:
            the derivative of the energy by it; also ``sweep["D.holding_force"]``.
        n_negative: Independent directions (n,) in which the energy falls: 0 at a minimum.
        snaps: Jumps to other minima, in their order.
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
    energy: Array = field(default_factory=lambda: np.zeros(0))
    holding_forces: Mapping[str, Array] = field(default_factory=dict)
    n_negative: Integers = field(default_factory=lambda: np.zeros(0, dtype=np.intp))
    snaps: Sequence[Snap] = ()

    @property
    def minimum(self) -> list[bool]:
        """True where the strain energy is least, for every position found by it."""
        return [not negative for negative in self.n_negative.tolist()]

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
            places = self.model._layout.slots[letter]
            place = places.get(name.removesuffix(ending)) if name.endswith(ending) else None
            if place is None and ending == ".udot" and name.endswith(ending):
                place = places.get(f"{name.removesuffix(ending)}.u")
            if place is not None and values.shape[1]:
                columns = values[:, place]
                return columns[:, 0] if columns.shape[1] == 1 else columns
        forces = {f"{n}.holding_force": values for n, values in self.holding_forces.items()}
        if name in forces:
            return forces[name]
        names = [*self.model.coordinates, *self.model.speeds, *forces]
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
        if not len(self):
            return lines[0]
        worst, count = int(np.argmin(self.quality)), counted(len(self), "position")
        at = f"{self.quality[worst]:.3g}, at {first[worst]:.6g}"
        if not len(self.energy):
            lines.append(f"  {count}; smallest singular value of the driven constraints {at}")
            return "\n".join(lines)
        ends = f"{self.energy.min():.6g} ... {self.energy.max():.6g} J"
        lines.append(f"  {count} by strain energy, {ends}; lowest stiffness {at}")
        if self.n_negative.any():
            lines.append(f"  {counted(int(np.sum(self.n_negative > 0)), 'position')} not a minimum")
        return "\n".join([*lines, *(f"  {snap!r}" for snap in self.snaps)])


def sweep_by_constraints(
    model: LoadedModel,
    driver: str | Mapping[str, ArrayLike],
    values: ArrayLike | None,
    *,
    rate: float,
    acceleration: float,
    locked: LockedValues | None,
    start: Mapping[str, ArrayLike] | ArrayLike | None,
    branch: Mapping[str, object] | None,
    t: float,
    r: State | None,
    show: Show,
) -> SweepRecord:
    """Positions that constraints and drivers alone determine.

    Args:
        model: The compiled model.
        driver, values, rate, acceleration, locked, start, branch, t, r: As ``sweep`` takes them.
        show: Called with the part that is done.
    """
    moved = [name for name in model.inputs if f"{name}.rate" in model.inputs]
    drivers = driver_values(driver, values, [*model.coordinates, *moved], model)
    refuse_nodes(model, "sweep")
    m, table = Mechanism(model, t, r), np.stack([*drivers.values()], axis=1)
    locked_targets = locked_values(m, locked)
    drive = Drive(m, list(drivers), locked_targets)
    at = drive.at(table[0])
    first = {n: float(c[0]) for n, c in drivers.items() if n not in drive.inputs}
    begin = assemble_by_constraints(
        model, first | locked_targets, start=start, branch=branch, t=t, r=at.r
    )
    drive.check(at, begin.q)
    rows, status, message = _follow(drive, begin.q, table, show)
    places = [drive.at(row) for row in table[: len(rows)]]
    return SweepRecord(
        model,
        {name: column[: len(rows)] for name, column in drivers.items()},
        np.array([place.t for place in places]),
        np.array([place.inputs for place in places]).reshape(len(rows), model.nr),
        *_motion(drive, rows, table, rate, acceleration),
        status=status,
        message=message,
    )


def driver_values(
    driver: object, values: object, names: Sequence[str], model: LoadedModel
) -> dict[str, Array]:
    """Name -> values of all drivers, checked.

    Args:
        driver, values: As ``sweep`` takes them.
        names: What can be driven.
        model: For messages.
    """
    named: Mapping[str, object] = driver if isinstance(driver, Mapping) else {str(driver): values}
    if isinstance(driver, Mapping) == (values is not None) or not named:
        raise ArgumentError(
            "sweep: driver= is a coordinate and values= its values, or it is {coordinate: values}"
        )
    columns: dict[str, Array] = {}
    for name, column in named.items():
        if name not in names:
            part = component(model.manifest, name)
            if part:
                raise ModelError(f"sweep: {part}")
            raise ModelError(f"sweep: there is no coordinate '{name}'.{near(name, [*names])}")
        array = np.array(column, dtype=np.float64)
        if array.ndim != 1 or len(array) == 0:
            raise ArgumentError(f"sweep: the values of '{name}' have shape {array.shape}, not (n,)")
        if not np.isfinite(array).all():
            raise SolveError(f"sweep: the values of '{name}' must be finite")
        columns[name] = array
    if len({len(column) for column in columns.values()}) > 1:
        raise ArgumentError("sweep: all drivers need the same number of values")
    return columns


def _follow(drive: Drive, q: Array, table: Array, show: Show) -> tuple[list[Array], str, str]:
    """Positions at the rows of a table, each from the one before; status and message."""
    rows = [q]
    try:
        for before, after in pairwise(table):
            rows.append(drive.go(rows[-1], before, after))
            show(len(rows) / len(table))
    except Stuck as stuck:
        return rows, "singular", str(stuck)
    except KeyboardInterrupt:
        return rows, "interrupted", "interrupted; what was computed is kept"
    return rows, FINISHED, "reached all values"


def _motion(
    drive: Drive, rows: list[Array], table: Array, rate: float, acceleration: float
) -> tuple[Array, Array, Array, Array]:
    """q, u, udot and the quality of the drive at all positions."""
    model = drive.m.model
    dynamic = "forward_dynamics" in model.manifest.available
    slopes = driver_slopes(table)
    u, udot, quality = [], [], []
    for q, values, slope in zip(rows, table, slopes, strict=False):
        m = drive.at(values, rate * slope, acceleration * slope)
        u.append(speeds(m, q, drive.speeds(rate * slope), np.zeros(model.nu)))
        if dynamic:
            udot.append(accelerations(m, q, u[-1], drive.speeds(acceleration * slope)))
        quality.append(drive.rank_margin(m, q)[0])
    rates = np.array(udot) if dynamic else np.zeros((len(rows), 0))
    return np.array(rows), np.array(u), rates, np.array(quality)


def driver_slopes(table: Array) -> Array:
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
