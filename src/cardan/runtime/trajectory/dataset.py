"""A run as tables with names and units, as a pandas table and as an xarray data set."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ...arrays import Array
from ...errors import CardanError
from ...records import dataclass
from ...schema.rows import column
from .histories import computed

if TYPE_CHECKING:
    from .trajectory import TrajectoryRecord

# letter of a block -> its name
TABLES = {"q": "coordinates", "u": "speeds", "r": "inputs", "z": "internal_states", "s": "modes"}


@dataclass(frozen=True, eq=False)
class HistoryTable:
    """Histories of one kind.

    Attributes:
        name: Of the kind, such as ``"coordinates"``.
        names, units: Of the columns; a unit may be "".
        values: (nt, n).
    """

    name: str
    names: tuple[str, ...]
    units: tuple[str, ...]
    values: Array


def tables(motion: TrajectoryRecord) -> Iterator[HistoryTable]:
    """Coordinates, speeds, inputs, states and outputs of a run, as far as it has some."""
    manifest = motion.manifest
    for letter, name in TABLES.items():
        if rows := manifest.block(letter):
            names, units = column(rows, "name"), column(rows, "unit")
            values = getattr(motion, letter)
            yield HistoryTable(name, tuple(names), tuple(unit or "" for unit in units), values)
    available = "outputs" in motion.stored or "outputs" in manifest.available
    if manifest.outputs and available:
        names, units = column(manifest.outputs, "name"), column(manifest.outputs, "unit")
        values = computed(motion, "outputs", "the outputs")
        yield HistoryTable("outputs", tuple(names), tuple(unit or "" for unit in units), values)


def to_pandas(motion: TrajectoryRecord) -> Any:
    """A ``pandas.DataFrame``: a row for every time, a column for every history.

    Columns are coordinates, speeds, inputs, internal states, modes and outputs, by the names that
    ``motion[name]`` takes. The index is the time ``t`` [s]; at an event two rows may have one time.
    ``frame.attrs["units"]`` has the unit of every column, and of ``t``; ``frame.attrs`` also says
    model, method and status.

    Raises:
        ModuleNotFoundError: pandas is not installed (extra ``data``).
    """
    try:
        import pandas
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(
            "to_pandas needs pandas, which is not installed: pip install 'cardan[data]'"
        ) from error
    every = [*tables(motion)]
    names = [name for table in every for name in table.names]
    values = np.hstack([np.zeros((len(motion), 0)), *(table.values for table in every)])
    frame = pandas.DataFrame(values, index=pandas.Index(motion.t, name="t"), columns=names)
    units = {"t": "s"}
    for table in every:
        units |= dict(zip(table.names, table.units, strict=True))
    frame.attrs |= {"units": units, **_about(motion)}
    return frame


def _about(motion: TrajectoryRecord) -> dict[str, str]:
    info = motion.solver_info
    return {"model": motion.manifest.name, "method": info.method, "status": motion.status}


def to_xarray(motion: TrajectoryRecord) -> Any:
    """An ``xarray.Dataset`` with named coordinates, speeds, inputs and energies.

    Raises:
        ModuleNotFoundError: xarray is not installed (extra ``data``).
    """
    try:
        import xarray
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(
            "to_xarray needs xarray, which is not installed: pip install 'cardan[data]'"
        ) from error
    manifest = motion.manifest
    names = {letter: column(manifest.block(letter), "name") for letter in "qurzs"}
    data = xarray.Dataset(
        {
            "q": (("time", "coordinate"), motion.q),
            "u": (("time", "speed"), motion.u),
            "r": (("time", "input"), motion.r),
            "work": (("time", "source"), motion.work_done, {"units": "J"}),
        },
        coords={
            "time": ("time", motion.t, {"units": "s"}),
            "coordinate": names["q"],
            "speed": names["u"],
            "input": names["r"],
            "source": list(motion.sources or ()),
        },
        attrs=_about(motion),
    )
    for key, dimension, values in (("z", "internal_state", motion.z), ("s", "mode", motion.s)):
        if names[key]:
            data[key] = (("time", dimension), values)
            data = data.assign_coords({dimension: names[key]})
    for letter, dimension in (("q", "coordinate"), ("u", "speed"), ("r", "input")):
        units = column(manifest.block(letter), "unit")
        data = data.assign_coords({f"{dimension}_unit": (dimension, units)})
    try:
        energy = motion.energy
    except CardanError:
        # a model compiled without 'energy' has none to add
        return data
    for name, values in zip(("kinetic", "potential"), energy, strict=False):
        data[name] = ("time", values, {"units": "J"})
    return data
