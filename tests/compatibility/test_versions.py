"""Files of a newer cardan are refused by one message: who wrote them, and the cure."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

import cardan as cd
from cardan import version
from cardan.analyses.ensembles import file_schema
from cardan.api import saved_model
from cardan.runtime import formats
from cardan.runtime.trajectory import storage
from compatibility.write import FILES, scene

NEWER = "9.8.7"


def newer(form: version.Format) -> version.Format:
    return form._replace(version=form.version + 1)


def a_run(path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[], object]:
    contents = formats.load(FILES / "run_2_pendulum.nc", version.RUN, ("title", *storage.NOTES))
    file = path / "run.nc"
    with monkeypatch.context() as patch:
        patch.setattr(formats, "VERSION", NEWER)
        formats.save(file, newer(version.RUN), contents, "")
    return lambda: cd.load_motion(file)


def an_ensemble(path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[], object]:
    contents = formats.load(
        FILES / "ensemble_1.nc", version.ENSEMBLE, ("title", *file_schema.NOTES)
    )
    file = path / "runs.nc"
    with monkeypatch.context() as patch:
        patch.setattr(formats, "VERSION", NEWER)
        formats.save(file, newer(version.ENSEMBLE), contents, "")
    return lambda: cd.load_ensemble(file)


def a_model(path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[], object]:
    folder = path / "model"
    cd.derive(scene()).export(folder, ["rhs"], language="c")
    manifest = json.loads((folder / "manifest.json").read_text("utf-8"))
    del manifest["digest"]
    text = json.dumps({**manifest, "schema": version.MANIFEST.version + 1, "cardan": NEWER})
    (folder / "manifest.json").write_text(text, "utf-8")
    return lambda: cd.load_model(folder)


def a_pickle(path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[], object]:
    function, (_, _, *content) = saved_model.reduced(cd.compile(scene(), functions=["rhs"]))
    return lambda: function(version.PICKLE.version + 1, NEWER, *content)


FILES_OF: dict[str, tuple[Callable[..., Callable[[], object]], version.Format]] = {
    "run": (a_run, version.RUN),
    "ensemble": (an_ensemble, version.ENSEMBLE),
    "model": (a_model, version.MANIFEST),
    "pickle": (a_pickle, version.PICKLE),
}


@pytest.mark.parametrize("kind", FILES_OF)
def test_a_newer_file_is_refused(
    kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write, form = FILES_OF[kind]
    read = write(tmp_path, monkeypatch)
    with pytest.raises(cd.ModelError) as refused:
        read()
    told = str(refused.value)
    where, _, rest = told.partition(" was written by ")
    assert where
    assert f"{where} was written by {rest}" == form.refusal(where, form.version + 1, NEWER)


def test_a_newer_scene_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "scene.yaml"
    file.write_text("cardan: 3\nbodies: {a: {mass: 1}}\n", "utf-8")
    with pytest.raises(cd.ModelError, match=r"scene\.yaml:1:9: .*scene format 3; this is cardan 0"):
        cd.load(file)


def test_every_format_that_is_written_is_read() -> None:
    for form in version.FORMATS:
        assert form.reads(form.version)
        assert form.reads(form.oldest)
        assert not form.reads(form.version + 1)
        assert not form.reads("1")
        assert not form.reads(None)
        # a name may only change from a version that is still read
        assert all(form.oldest <= older < form.version for older in form.renamed)


def test_names_follow_several_versions() -> None:
    renamed = {1: {"joints.*.kind": "type"}, 2: {"joints.*.type": "element", "a": "b"}}
    form = version.Format("scene", "cardan", 3, 1, "", renamed)
    assert form.today(("joints", "elbow", "kind"), 1) == "element"
    assert form.today(("joints", "elbow", "kind"), 2) == "kind"
    assert form.today(("joints", "elbow", "type"), 2) == "element"
    assert form.today(("joints", "elbow", "deep", "kind"), 1) == "kind"
    data = {"a": 1, "joints": [{"kind": "revolute"}], "other": {"a": 2}}
    assert form.translated(data, (), 1) == {
        "b": 1,
        "joints": [{"element": "revolute"}],
        "other": {"a": 2},
    }


def test_the_version_is_that_of_the_package() -> None:
    import tomllib

    project = tomllib.loads((FILES.parents[2] / "pyproject.toml").read_text("utf-8"))["project"]
    assert cd.__version__ == version.VERSION == project["version"]
