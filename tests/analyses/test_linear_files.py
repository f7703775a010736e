"""Linear models and reduced components as files."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat

import cardan as cd
from cardan.analyses.linear.linear_file import FORMATS, NOTES
from cardan.number_file import packed, unpacked
from cardan.runtime import formats
from cardan.runtime.formats.contents import Contents
from cardan.version import LINEAR
from full_disk import full_disk
from superelements.test_moving_pictures import link


@pytest.fixture(scope="module")
def linear() -> cd.LinearModel:
    model = cd.compile(cd.examples["cart_pole"])
    return model.linearize(q={"pole": np.pi}, inputs=["push", "rail"], outputs=["pole", "rail.u"])


@pytest.fixture(scope="module")
def driven() -> cd.LinearModel:
    """Without inputs; with loops."""
    return cd.compile(cd.examples["trolley"]).linearize()


@pytest.mark.parametrize("ending", [".npz", ".nc"])
def test_linear_models_come_back(
    linear: cd.LinearModel, driven: cd.LinearModel, tmp_path: Path, ending: str
) -> None:
    for one in (linear, driven):
        again = cd.load_linear(one.save(tmp_path / f"model{ending}"))
        assert type(again) is type(one)
        for field in dataclasses.fields(one):
            mine, theirs = getattr(one, field.name), getattr(again, field.name)
            if field.name == "choice":
                assert [x.tolist() for x in theirs] == [np.asarray(x).tolist() for x in mine]
            elif isinstance(mine, np.ndarray):
                assert theirs.shape == mine.shape
                np.testing.assert_array_equal(theirs, mine)
            else:
                assert theirs == mine, field.name
        assert repr(again) == repr(one)
        np.testing.assert_array_equal(again.eigenvalues, one.eigenvalues)


def test_units_are_those_of_the_model(linear: cd.LinearModel) -> None:
    assert dict(zip(linear.states, linear.state_units, strict=True)) == {
        "rail": "m", "pole": "rad", "rail.u": "m/s", "pole.u": "rad/s",
    }  # fmt: skip
    assert linear.inputs == ("push", "rail")
    assert linear.input_units[1] == "N"
    assert linear.output_units == ("rad", "m/s")


def test_increments_along_speeds_have_units() -> None:
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=1, com=(0, 0, -1), inertia=(0.1, 0.2, 0.3))
    scene.joint("ball", cd.Spherical(), scene.ground, body)
    linear = cd.compile(scene).linearize()
    assert linear.states[0].startswith("along ")
    assert linear.state_units == ("rad", "rad", "rad", "rad/s", "rad/s", "rad/s")


def test_matlab_files_have_matrices_names_and_units(
    linear: cd.LinearModel, driven: cd.LinearModel, tmp_path: Path
) -> None:
    read = loadmat(linear.save(tmp_path / "model.mat"), simplify_cells=True)
    for name in "ABCD":
        np.testing.assert_array_equal(read[name], getattr(linear, name))
    assert read["states"].tolist() == [*linear.states]
    assert read["state_units"].tolist() == [*linear.state_units]
    # without inputs B has no columns, and is there
    read = loadmat(driven.save(tmp_path / "driven.mat"))
    assert read["B"].shape == driven.B.shape
    with pytest.raises(cd.ModelError, match="its format is neither netCDF-3 nor NumPy archive"):
        cd.load_linear(tmp_path / "model.mat")


def test_json_has_all_of_it(linear: cd.LinearModel, tmp_path: Path) -> None:
    read = json.loads(linear.save(tmp_path / "model.json").read_text("ascii"))
    assert read["arrays"]["A"]["values"] == linear.A.tolist()
    assert read["arrays"]["outputs"]["values"] == [*linear.outputs]
    assert read["about"]["name"] == "cart_pole"


def test_what_is_no_linear_model_is_refused(linear: cd.LinearModel, tmp_path: Path) -> None:
    with pytest.raises(cd.ModelError, match=r"linear models are written to files that end in"):
        linear.save(tmp_path / "model.csv")
    path = linear.save(tmp_path / "model.npz")
    with pytest.raises(cd.ModelError, match="is not a run of cardan"):
        cd.load_motion(path)
    with pytest.raises(cd.ModelError, match="there is no such file"):
        cd.load_linear(tmp_path / "none.npz")
    before = path.read_bytes()
    arrays = unpacked(before)
    path.write_bytes(packed({**arrays, "A": arrays["A"] + 1}))
    with pytest.raises(cd.ModelError, match="its hash differs"):
        cd.load_linear(path)
    path.write_bytes(before)
    with full_disk(1000), pytest.raises(cd.ModelError, match="Make room"):
        linear.save(path)
    assert path.read_bytes() == before


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"n": 1}, "has shape|damaged"),
        ({"states": ["a"]}, "has shape"),
        ({"independent_speeds": [0, 99]}, "independent speeds are damaged"),
        ({"input_units": []}, "units are damaged"),
        ({"name": 3}, "name"),
    ],
)
def test_parts_that_do_not_fit_are_refused(
    linear: cd.LinearModel, tmp_path: Path, change: dict[str, object], words: str
) -> None:
    path = linear.save(tmp_path / "model.npz")
    contents = formats.load(path, cd.version.LINEAR, ("title", "about"))
    about = {**json.loads(contents.notes["about"]), **change}
    changed = formats.Contents(contents.variables, {**contents.notes, "about": json.dumps(about)})
    formats.save(path, cd.version.LINEAR, changed, "")
    with pytest.raises(cd.ModelError, match=words):
        cd.load_linear(path)


def test_reduced_components_for_other_programs(tmp_path: Path) -> None:
    record = link()
    read = loadmat(record.save(tmp_path / "link.mat"), simplify_cells=True)
    for name in "MCK":
        np.testing.assert_array_equal(read[name], getattr(record, name))
    assert read["coordinates"].tolist() == [*record.labels]
    assert read["interfaces"].tolist() == ["root", "tip"]
    # frequencies with all interfaces fixed, from the matrices that were written
    inner = slice(record.n_boundary, None)
    omega = np.sqrt(np.linalg.eigvals(np.linalg.solve(read["M"][inner, inner],
                                                      read["K"][inner, inner])).real)  # fmt: skip
    np.testing.assert_allclose(np.sort(omega), np.sort(read["frequencies"]), rtol=1e-6)
    again = cd.superelement.load(record.save(tmp_path / "link.npz"))
    np.testing.assert_array_equal(again.K, record.K)
    with pytest.raises(cd.ModelError, match=r"superelements are written to files that end in"):
        record.save(tmp_path / "link.nc")


def test_files_without_rates_of_the_states_are_read(linear: cd.LinearModel, tmp_path: Path) -> None:
    contents = formats.load(linear.save(tmp_path / "model.npz"), LINEAR, NOTES)
    earlier = {name: x for name, x in contents.variables.items() if name != "xdot"}
    path = tmp_path / "earlier.npz"
    formats.save(path, LINEAR, Contents(earlier, contents.notes), "", FORMATS)
    again = cd.load_linear(path)
    assert np.isnan(again.xdot).all()
    np.testing.assert_array_equal(again.A, linear.A)
