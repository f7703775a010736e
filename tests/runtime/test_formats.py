"""Runs and ensembles in every format: read again where that is said, and a new one is one file."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat

import cardan as cd
from cardan.number_file import packed, unpacked
from cardan.runtime import formats
from cardan.runtime.formats.contents import FileFormat
from cardan.view import motion_files
from mechanisms import ZOO

READ = [one.endings[0] for one in formats.FORMATS if one.parse is not None]


@pytest.fixture(scope="module")
def motion() -> cd.Trajectory:
    return cd.compile(ZOO["spherical_quaternion"].build()).simulate(np.linspace(0.0, 0.2, 5))


@pytest.fixture(scope="module")
def runs() -> cd.Ensemble:
    model = cd.compile(ZOO["double_pendulum"].build())
    name = model.coordinates[0]
    return model.ensemble(0.1, q={name: [0.1, 0.2, 0.3]}, reduce=[f"max of {name}"])


@pytest.mark.parametrize("ending", READ)
def test_runs_come_back(motion: cd.Trajectory, tmp_path: Path, ending: str) -> None:
    path = motion.save(tmp_path / f"run{ending}")
    back = cd.load_motion(path)
    np.testing.assert_array_equal(back.x, motion.x)
    np.testing.assert_array_equal(back.t, motion.t)
    frame = motion.manifest["frames"][-1]["name"]
    # rotations by coordinates are rounded anew
    np.testing.assert_allclose(back.pose(frame), motion.pose(frame), rtol=0, atol=1e-14)
    assert back.save(tmp_path / f"again{ending}").read_bytes() == path.read_bytes()


@pytest.mark.parametrize("ending", READ)
def test_ensembles_come_back(runs: cd.Ensemble, tmp_path: Path, ending: str) -> None:
    back = cd.load_ensemble(runs.save(tmp_path / f"runs{ending}"))
    np.testing.assert_array_equal(back.final, runs.final)
    (name,) = runs.results
    np.testing.assert_array_equal(back.results[name], runs.results[name])
    assert list(back.status) == list(runs.status)


@pytest.mark.parametrize("ending", READ)
def test_a_changed_number_is_found(motion: cd.Trajectory, tmp_path: Path, ending: str) -> None:
    path = motion.save(tmp_path / f"run{ending}")
    data = bytearray(path.read_bytes())
    value = motion.q[2, 1]
    number = next(
        coded
        for coded in (np.array(value, dtype=order).tobytes() for order in (">f8", "<f8"))
        if coded in data
    )
    data[data.index(number) + 3] ^= 1
    path.write_bytes(data)
    with pytest.raises(cd.ModelError, match=r"its hash differs|holds no arrays"):
        cd.load_motion(path)


@pytest.mark.parametrize("ending", READ)
def test_files_cut_short_are_refused(motion: cd.Trajectory, tmp_path: Path, ending: str) -> None:
    whole = motion.save(tmp_path / f"run{ending}").read_bytes()
    for share in (0.1, 0.5, 0.9):
        path = tmp_path / f"part{ending}"
        path.write_bytes(whole[: int(share * len(whole))])
        with pytest.raises(cd.ModelError, match="not a run of cardan"):
            cd.load_motion(path)


def test_archives_are_those_of_numpy(motion: cd.Trajectory, tmp_path: Path) -> None:
    with np.load(motion.save(tmp_path / "run.npz")) as found:
        np.testing.assert_array_equal(found["q"], motion.q)


def test_archives_that_say_nothing_of_themselves(tmp_path: Path) -> None:
    np.savez(tmp_path / "own.npz", q=np.zeros(3))
    with pytest.raises(cd.ModelError, match="it has no 'about'"):
        cd.load_motion(tmp_path / "own.npz")
    np.savez(tmp_path / "other.npz", about='{"attributes": {"a": [1]}, "variables": {}}')
    with pytest.raises(cd.ModelError, match="its texts are damaged"):
        cd.load_motion(tmp_path / "other.npz")


def test_numbers_without_an_axis_are_refused(motion: cd.Trajectory, tmp_path: Path) -> None:
    with np.load(motion.save(tmp_path / "run.npz")) as found:
        arrays = dict(found)
    about = json.loads(str(arrays["about"]))
    about["variables"]["time"]["dimensions"] = []
    np.savez(tmp_path / "flat.npz", **{**arrays, "time": 1.0, "about": json.dumps(about)})
    with pytest.raises(cd.ModelError, match="what is said about 'time' is damaged"):
        cd.load_motion(tmp_path / "flat.npz")


def test_no_name_is_reserved() -> None:
    found = unpacked(packed({"file": np.arange(3.0), "args": np.zeros(())}))
    assert found["file"].tolist() == [0.0, 1.0, 2.0]
    assert sorted(found) == ["args", "file"]


def test_tables_have_the_names_and_units_of_the_model(
    motion: cd.Trajectory, runs: cd.Ensemble, tmp_path: Path
) -> None:
    with motion.save(tmp_path / "run.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["t [s]"]) for row in rows] == motion.t.tolist()
    for name in motion.model.coordinates:
        # quaternions have no unit
        assert [float(row[name]) for row in rows] == motion[name].tolist()
    for name in motion.model.speeds:
        assert [float(row[f"{name} [rad/s]"]) for row in rows] == motion[name].tolist()
    with runs.save(tmp_path / "runs.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    (name,) = runs.results
    assert [float(row[name]) for row in rows] == runs.results[name].tolist()
    assert [row["status"] for row in rows] == list(runs.status)
    with pytest.raises(cd.ModelError, match="its format is neither netCDF-3 nor NumPy archive"):
        cd.load_motion(tmp_path / "run.csv")


def test_matlab_reads_arrays_names_and_units(
    motion: cd.Trajectory, runs: cd.Ensemble, tmp_path: Path
) -> None:
    read = loadmat(motion.save(tmp_path / "run.mat"), squeeze_me=True)
    assert read["t"].tolist() == motion.t.tolist()
    assert np.array_equal(read["q"].reshape(motion.q.shape), motion.q)
    assert np.atleast_1d(read["q_names"]).tolist() == list(motion.model.coordinates)
    assert len(np.atleast_1d(read["q_units"])) == len(motion.model.coordinates)
    read = loadmat(runs.save(tmp_path / "runs.mat"), squeeze_me=True)
    (name,) = runs.results
    assert runs.results[name].tolist() in [np.atleast_1d(x).tolist() for x in read.values()]
    assert read["status"].tolist() == list(runs.status)
    with pytest.raises(cd.ModelError, match="its format is neither netCDF-3 nor NumPy archive"):
        cd.load_motion(tmp_path / "run.mat")


def test_a_new_format_is_one_file(
    motion: cd.Trajectory, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def written(path, attributes, variables):
        path.write_text(" ".join(sorted(variables)))

    one = FileFormat("list", (".list",), written)
    monkeypatch.setattr(motion_files, "FORMATS", (*motion_files.FORMATS, one))
    monkeypatch.setattr(formats, "FORMATS", (*formats.FORMATS, one))
    assert "time" in motion.save(tmp_path / "run.list").read_text().split()
