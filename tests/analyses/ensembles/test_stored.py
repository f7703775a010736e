"""Ensembles in files and as xarray data sets: labels, texts, names without blanks."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd

REDUCE: dict[str, Any] = {
    "states": "states",
    "max of elbow": "max of elbow",
    "mean of elbow": "mean of elbow",
    "spread": "histogram of elbow from -0.1 to 0.1 in 2",
    "Größe, α": lambda t, x: x[:, :3, :1],
}


@pytest.fixture
def runs(double: cd.CompiledModel) -> cd.Ensemble:
    """As many runs as output times, and as entries of a state."""
    assert double.nx == 4
    return double.ensemble(
        np.linspace(0, 0.2, 4),
        q={"elbow": [-1.0, 0.0, 0.5, 1.0]},
        u={"elbow": [0.0, 1.0, 2.0, 3.0]},
        reduce=REDUCE,
    )


def test_what_is_read_is_what_was_saved(runs: cd.Ensemble, tmp_path: Path) -> None:
    back = cd.load_ensemble(runs.save(tmp_path / "runs.nc"))
    assert repr(back) == repr(runs)
    assert list(back.results) == list(runs.results) == list(REDUCE)
    for name, value in runs.results.items():
        if name != "spread":
            np.testing.assert_array_equal(back[name], value)
    counts, own = runs["spread"], back["spread"]
    assert counts.below + counts.above > 0
    assert (own.below, own.above) == (counts.below, counts.above)
    np.testing.assert_array_equal(own.counts, counts.counts)
    # both of a joint, each by its name
    assert list(runs.varied) == list(back.varied) == ["elbow", "elbow.u"]
    assert back.varied["elbow.u"].tolist() == [0.0, 1.0, 2.0, 3.0]
    assert back.status.tolist() == ["finished"] * 4
    with pytest.raises(cd.ModelError, match="has no model to compute a run again"):
        back.run(0)
    with pytest.raises(cd.ModelError, match="Did you mean 'elbow'"):
        back["elbo"]


def test_a_data_set_has_labels(runs: cd.Ensemble, tmp_path: Path) -> None:
    """Axes were told by their lengths: here all lengths are 4."""
    xarray = pytest.importorskip("xarray")
    for data in (runs.to_xarray(), xarray.open_dataset(runs.save(tmp_path / "runs.nc"))):
        assert data["states"].dims == ("run", "time", "entry")
        assert data["final"].dims == ("run", "entry")
        assert data["max_of_elbow"].dims == ("run",)
        assert data["mean_of_elbow"].dims == ("time",)
        assert not [name for name in data.variables if " " in str(name)]
        assert data["status"].values.tolist() == ["finished"] * 4
        elbow = data["states"].sel(entry="elbow").isel(time=-1)
        np.testing.assert_array_equal(elbow, runs["elbow"])
        assert [*data["entry"].values] == ["shoulder", "elbow", "shoulder.u", "elbow.u"]
    assert runs.to_xarray()["Gr__e___"].attrs["name"] == "Größe, α"


def test_a_data_set_goes_into_a_bucket(runs: cd.Ensemble) -> None:
    """By zarr, piece by piece, here in memory."""
    xarray = pytest.importorskip("xarray")
    for needed in ("zarr", "fsspec"):
        pytest.importorskip(needed)
    data = runs.to_xarray()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # zarr says that texts are new in its format
        data.to_zarr("memory://bucket/runs.zarr", mode="w")
        again = xarray.open_zarr("memory://bucket/runs.zarr")
    np.testing.assert_array_equal(again["states"].values, runs["states"])


def test_what_is_no_ensemble(runs: cd.Ensemble, tmp_path: Path) -> None:
    motion = runs.run(0).save(tmp_path / "run.nc")
    with pytest.raises(cd.ModelError, match="is not an ensemble that cardan can read"):
        cd.load_ensemble(motion)
    with pytest.raises(cd.ModelError, match="is not a run of cardan"):
        cd.load_motion(runs.save(tmp_path / "runs.nc"))
    with pytest.raises(cd.ModelError, match="there is no such file"):
        cd.load_ensemble(tmp_path / "none.nc")
    with pytest.raises(cd.ModelError, match="files that end in one of"):
        runs.save(tmp_path / "runs.h5")
