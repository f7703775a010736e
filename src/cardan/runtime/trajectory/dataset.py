"""A run as an xarray data set."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ...errors import CardanError
from ...schema.rows import column

if TYPE_CHECKING:
    from .trajectory import TrajectoryRecord


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
        attrs={
            "model": manifest.name,
            "method": motion.solver_info.method,
            "status": motion.status,
        },
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
