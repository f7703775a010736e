"""The compiled model as an object: names, parameters, states, saving, pickling, reports."""

from __future__ import annotations

import json
import pickle
import subprocess
import sys
from contextlib import contextmanager

import numpy as np
import pytest

from cardan.analyses.simulation.precision import report as reports
from cardan.api.compiled_model import CompiledModel
from cardan.api.saved_model import load
from cardan.errors import BuildError, ModelError
from cardan.runtime.models.saved_models import digest, parts, restore
from runtime import pendulum

pytestmark = pytest.mark.usefixtures("cache_directory")


def test_what_it_is(model):
    assert repr(model).startswith("CompiledModel('pendulum', by hand: 1 body, 1 coordinate")
    assert (model.nq, model.nu, model.nx, model.nr, model.nlam) == (1, 1, 2, 0, 0)
    assert model.coordinates == ("swing",)
    assert model.speeds == ("swing.u",)
    assert model.bodies == ("bob",)
    assert model.frames == ("ground", "bob", "tip")
    assert model.limits == {"swing": {"lower": -3.0, "upper": 3.0}}
    assert "int rhs(" in model.source["rhs"]
    assert model.operations["rhs"] == {"mul": 2}


def test_parameters(model):
    assert dict(model.parameters) == {"m": 2.0, "l": 0.5, "g": 9.81}
    assert "l" in repr(model.parameters)
    assert "m/s^2" in repr(model.parameters)
    with pytest.raises(KeyError, match="does not exist"):
        model.parameters["gg"]
    longer = model.with_parameters({"l": 1.0}, g=10.0)
    assert longer.parameters["l"] == 1.0
    assert model.parameters["l"] == 0.5
    assert np.allclose(longer.forward_dynamics([0.3], [0.0]), -10 * np.sin(0.3), rtol=1e-15)
    assert np.allclose(model.forward_dynamics([0.3], [0.0]), -9.81 / 0.5 * np.sin(0.3), rtol=1e-15)
    assert longer._function("rhs").code is model._function("rhs").code


def test_states(model):
    x = model.random_state(np.random.default_rng(0), (200,))
    q, u = model.split(x)
    assert x.shape == (200, 2)
    assert np.all(np.abs(q) <= 3.0)
    assert q.max() > 2.5
    assert np.all(np.abs(u) <= 1.0)
    assert np.array_equal(model.random_state(7), model.random_state(7))
    assert np.array_equal(model.initial(q={"swing": 0.3}), [0.3, 0.0])


def test_functions_are_provided_on_demand(tmp_path):
    folder = pendulum.write(tmp_path / "model", ["forward_dynamics"])
    asked = []

    def provide(keys):
        asked.extend(keys)
        pendulum.write(folder, ["forward_dynamics", "energy", "pose__bob"])
        return [name if of is None else f"{name}__{of}" for name, of in keys]

    model = CompiledModel(folder, provide)
    model.forward_dynamics([0.1], [0.0])
    model.energy([0.1], [0.0])
    model.pose("bob", [0.1])
    model.pose("bob", [0.2])
    assert asked == [("forward_dynamics", None), ("energy", None), ("pose", "bob")]


def test_saved_model_is_checked(directory):
    manifest = json.loads((directory / "manifest.json").read_text())
    (directory / "rhs.c").write_text((directory / "rhs.c").read_text() + "\n")
    with pytest.raises(BuildError, match=r"rhs\.c is not the text its manifest speaks of"):
        load(directory).rhs(0.0, [0.1, 0.2])
    manifest["sha256"] = {"energy.c": "0" * 64}
    (directory / "manifest.json").write_text(json.dumps(manifest))
    with pytest.raises(ModelError, match=r"energy\.c is not the file"):
        load(directory)
    manifest["abi"] = 3
    (directory / "manifest.json").write_text(json.dumps(manifest))
    with pytest.raises(ModelError, match="C interface format 3; this is cardan"):
        load(directory)
    with pytest.raises(ModelError, match=r"manifest\.json is missing"):
        load(directory / "elsewhere")


def test_manifest_may_not_point_outside(directory):
    manifest = json.loads((directory / "manifest.json").read_text())
    manifest["functions"]["rhs"]["file"] = "../rhs.c"
    (directory / "manifest.json").write_text(json.dumps(manifest))
    with pytest.raises(ModelError, match="not the name of a file"):
        load(directory).rhs(0.0, [0.1, 0.2])


def test_pickle_holds_source_and_no_binary(model, tmp_path):
    model = model.with_parameters(l=1.25)
    expected = model.forward_dynamics([0.3], [0.0])
    content = pickle.dumps(model)
    assert b"\x7fELF" not in content
    assert b"int forward_dynamics(" in content
    file = tmp_path / "model.pickle"
    file.write_bytes(content)
    code = (
        "import pickle, sys; model = pickle.load(open(sys.argv[1], 'rb'));"
        "print(model.parameters['l'], model.forward_dynamics([0.3], [0.0])[0].hex())"
    )
    answer = subprocess.run(
        [sys.executable, "-c", code, str(file)], capture_output=True, text=True, check=True
    )
    assert answer.stdout.split() == ["1.25", expected[0].hex()]


def named_outside(files):
    files["../evil.c"] = ""


def with_a_binary(files):
    files["evil.so"] = ""


def with_other_code(files):
    files["rhs.c"] += "/* more */"


def without_a_file(files):
    del files["rhs.c"]


def without_json(files):
    files["manifest.json"] = "{"


@contextmanager
def edited_manifest(files):
    manifest = json.loads(files["manifest.json"])
    # who edits a manifest leaves out the hash that finds damage
    manifest.pop("digest", None)
    yield manifest
    files["manifest.json"] = json.dumps(manifest)


def of_another_version(files):
    with edited_manifest(files) as manifest:
        manifest["abi"] = 7


def with_absurd_sizes(files):
    with edited_manifest(files) as manifest:
        manifest["functions"]["rhs"]["work_size"] = 2**62


def with_a_symbol_that_is_none(files):
    with edited_manifest(files) as manifest:
        manifest["functions"]["rhs(); system"] = manifest["functions"].pop("rhs")


HARMS = {
    named_outside: "cannot hold a file",
    with_a_binary: "cannot hold a file",
    with_other_code: r"rhs\.c is not the file its manifest speaks of",
    without_a_file: r"rhs\.c is not the file",
    without_json: "is not JSON",
    of_another_version: "C interface format 7; this is cardan",
    with_absurd_sizes: "work_size' is",
    with_a_symbol_that_is_none: "not a name in C",
}


@pytest.mark.parametrize("harm", HARMS)
def test_harmed_pickle_is_refused_before_anything_is_written(model, cache_directory, harm):
    files, values, reproducible, stated = parts(model)
    there = sorted(cache_directory.rglob("*"))
    files = dict(files)
    harm(files)
    with pytest.raises(ModelError, match=r"not those it was made of|cannot hold a file"):
        restore(CompiledModel, files, values, reproducible, stated)
    # who changes the texts can change their hash too
    with pytest.raises(ModelError, match=HARMS[harm]):
        restore(CompiledModel, files, values, reproducible, digest(files))
    assert sorted(cache_directory.rglob("*")) == there


def test_pickle_with_other_than_its_parameters_is_refused(model):
    files, values, reproducible, stated = parts(model)
    with pytest.raises(ModelError, match="one value per parameter"):
        restore(CompiledModel, files, values[1:], reproducible, stated)
    with pytest.raises(ModelError, match="holds no texts"):
        restore(CompiledModel, {"manifest.json": b""}, values, reproducible, stated)


def test_report_measures_every_function(model, capsys):
    report = model.report()
    rows = {row.function: row for row in report.rows}
    assert set(rows) == set(pendulum.FUNCTIONS)
    printed = capsys.readouterr().out
    assert "frame_jacobian__tip" in printed
    # what a notebook shows of it besides
    assert repr(report) == f"Report('pendulum': {len(rows)} functions)"
    assert all(0 < row.state_ns < row.python_ns for row in report.rows)
    # three roundings: sine, product, difference
    assert 0 < rows["forward_dynamics"].error < 4e-16
    assert rows["energy"].error is None


def test_report_without_mpmath_says_so(model, monkeypatch, capsys):
    monkeypatch.setattr(reports.importlib.util, "find_spec", lambda name: None)
    report = model.report()
    assert "pip install mpmath" in report.note
    assert "pip install mpmath" in capsys.readouterr().out
    assert all(row.error is None for row in report.rows)
