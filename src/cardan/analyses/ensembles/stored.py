"""An ensemble as netCDF, and as an xarray data set."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ... import __version__
from ...errors import ModelError
from ...runtime.storage import ENDINGS, LIMIT, replaced
from .job import entries
from .reductions import Bins

if TYPE_CHECKING:
    from .result import Ensemble

Variables = dict[str, tuple[tuple[str, ...], Any, dict[str, str]]]


def variables(ensemble: Ensemble) -> Variables:
    """Name -> (dimensions, values, attributes)."""
    model, t = ensemble.job.model, ensemble.t
    names = json.dumps(entries(model))
    found: Variables = {
        "final": (("run", "entry"), ensemble.final, {"names": names}),
        "status": (("run",), ensemble.codes.astype(float), {"words": json.dumps(ensemble.words)}),
    }
    for name, values in ensemble.statistics.items():
        found[name] = (("run",), values, {"units": "s"} if name == "t" else {})
    for name, values in ensemble.varied.items():
        found[f"varied {name}"] = _shaped(f"varied {name}", values, len(ensemble), len(t))
    if len(t):
        found["time"] = (("time",), t, {"units": "s"})
    for name, value in ensemble.results.items():
        if isinstance(value, Bins):
            found[name] = ((f"bins of {name}",), value.counts.astype(float), {})
            found[f"edges of {name}"] = ((f"edges of {name}",), value.edges, {})
        else:
            found[name] = _shaped(name, np.asarray(value), len(ensemble), len(t))
    return found


def _shaped(name: str, values: Any, runs: int, times: int) -> tuple[tuple[str, ...], Any, Any]:
    """Values with names for their axes: runs first, then times, as far as lengths say so."""
    dimensions: list[str] = []
    for k, size in enumerate(values.shape):
        known = "run" if k == 0 and size == runs else "time" if size == times else ""
        dimensions.append(known if known not in dimensions[-1:] and known else f"{name} axis {k}")
    return tuple(dimensions), values, {}


def to_xarray(ensemble: Ensemble) -> Any:
    """As :meth:`Ensemble.to_xarray`."""
    try:
        import xarray
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(
            "to_xarray needs xarray, which is not installed: pip install 'cardan[data]'"
        ) from error
    found = variables(ensemble)
    times = {"time": found.pop("time")} if "time" in found else {}
    model = ensemble.job.model
    coordinates = {"entry": list(entries(model)), **times}
    data = xarray.Dataset(found, coordinates, {"model": model.name})
    data["status"] = ("run", ensemble.status)
    return data


def save(ensemble: Ensemble, path: Path) -> Path:
    """As :meth:`Ensemble.save`; a file with its name is replaced in one step."""
    from scipy.io import netcdf_file

    if path.suffix not in ENDINGS:
        raise ModelError(f"{path}: ensembles are written as netCDF, whose files end in .nc")
    if not path.parent.is_dir():
        raise ModelError(f"{path}: the directory {path.parent} does not exist")
    found = variables(ensemble)
    for name, (_, values, _) in found.items():
        if values.nbytes > LIMIT:
            raise ModelError(
                f"{path}: '{name}' takes {values.nbytes / 1e9:.1f} GB, netCDF-3 holds 2 GB in one "
                "variable. Keep reductions instead of states"
            )
    with replaced(path) as new, netcdf_file(new, "w", version=2) as file:
        file.title = f"ensemble of {ensemble.job.model.name}".encode("ascii", "replace")
        file.source = f"cardan {__version__}".encode()
        file.messages = json.dumps(dict(ensemble.messages)).encode("ascii")
        for name, (dimensions, values, attributes) in found.items():
            for dimension, size in zip(dimensions, values.shape, strict=True):
                if dimension not in file.dimensions and size:
                    file.createDimension(dimension, size)
            variable = file.createVariable(name, "f8", dimensions)
            variable[:] = values
            for key, text in attributes.items():
                setattr(variable, key, text.encode("ascii", "backslashreplace"))
    return path
