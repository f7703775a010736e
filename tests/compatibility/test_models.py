"""Models that were kept give the results they gave, or are refused; a stale cache is not used."""

from __future__ import annotations

import ctypes
import json
import lzma
import pickle
import shutil
import subprocess
import tarfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan import version
from cardan.codegen import fingerprint as fingerprints
from codegen.running import SPEED, STRICT, Inputs, compilers, pointer
from compatibility.write import FILES, STORED, of_model, of_motion, scene


def same(found: dict[str, Any], name: str) -> None:
    """Numbers are those of a file, to 1e-12 of the largest."""
    expected = np.load(FILES / name)
    for key, values in found.items():
        scale = np.abs(expected[key]).max(initial=1e-300)
        np.testing.assert_allclose(values, expected[key], rtol=1e-12, atol=1e-12 * scale)


def read_or_refused(form: version.Format, name: str, read: Callable[[], Any]) -> Any:
    """What a file of today's format holds; None for one of another, refused as it should be."""
    if form.reads(int(name.split("_")[1].split(".")[0])):
        return read()
    with pytest.raises(cd.CardanError) as refused:
        read()
    assert "written by cardan 0." in str(refused.value)
    assert form.cure in str(refused.value)
    return None


def unpacked(name: str, target: Path) -> Path:
    target.mkdir(mode=0o700)
    with tarfile.open(FILES / name) as file:
        file.extractall(target, filter="data")
    target.chmod(0o700)
    return target


def kept(pattern: str) -> list[Any]:
    """Names of files, of every version."""
    return [pytest.param(path.name, id=path.name) for path in sorted(FILES.glob(pattern))]


@pytest.mark.parametrize("name", kept("pickle_*_model.xz"))
def test_a_model_of_a_pickle(name: str) -> None:
    content = lzma.decompress((FILES / name).read_bytes())
    model = read_or_refused(version.PICKLE, name, lambda: pickle.loads(content))
    if model is not None:
        same(of_model(model), "model.npz")


@pytest.mark.parametrize("name", kept("pickle_*_motion.xz"))
def test_a_motion_of_a_pickle(name: str) -> None:
    content = lzma.decompress((FILES / name).read_bytes())
    motion = read_or_refused(version.PICKLE, name, lambda: pickle.loads(content))
    if motion is not None:
        found = of_motion(motion)
        for key in STORED:
            np.testing.assert_array_equal(found[key], np.load(FILES / "motion.npz")[key])
        same(found, "motion.npz")


def test_a_pickle_names_nothing_that_may_move() -> None:
    """But what a pickle is read by, and NumPy's arrays."""
    named = set()

    class Reader(pickle.Unpickler):
        def find_class(self, module: str, name: str) -> Any:
            named.add((module, name))
            return super().find_class(module, name)

    with lzma.open(max(FILES.glob("pickle_*_motion.xz"))) as file:
        Reader(file).load()
    ours = {one for one in named if not one[0].startswith("numpy")}
    assert ours == {("cardan", "_unpickled_model"), ("cardan", "_unpickled_motion")}


@pytest.mark.parametrize("name", kept("model_*.tar.xz"))
def test_a_folder_of_a_model(name: str, tmp_path: Path) -> None:
    folder = unpacked(name, tmp_path / "model")
    model = read_or_refused(version.MANIFEST, name, lambda: cd.load_model(folder))
    if model is not None:
        same(of_model(model), "model.npz")


@pytest.mark.parametrize("name", kept("export_*.tar.xz"))
def test_an_export_is_opened(name: str, tmp_path: Path) -> None:
    folder = unpacked(name, tmp_path / "exported")
    model = read_or_refused(version.MANIFEST, name, lambda: cd.load_model(folder))
    if model is not None:
        same(of_model(model), "model.npz")


@pytest.mark.skipif(not compilers(), reason="needs a C compiler")
@pytest.mark.parametrize("name", kept("export_*.tar.xz"))
def test_an_export_compiles_alone(name: str, tmp_path: Path) -> None:
    """With the headers that it brought, whatever those of today are."""
    folder = unpacked(name, tmp_path / "exported")
    sources = sorted(str(path) for path in folder.glob("*.c") if path.name != "example.c")
    compiler = next(iter(compilers().values()))
    command = [*compiler, *STRICT, *SPEED, "-shared", "-fPIC", f"-I{folder}"]
    subprocess.run([*command, *sources, "-o", str(tmp_path / "all.so"), "-lm"], check=True)
    library = ctypes.CDLL(str(tmp_path / "all.so"))
    manifest = json.loads((folder / "manifest.json").read_text("utf-8"))
    entry = manifest["functions"]["forward_dynamics"]
    out, work = np.zeros(entry["output_size"]), np.zeros(entry["work_size"] + 1)
    w, p = (
        np.zeros(entry["prepared_size"] + 1),
        np.array([row["default"] for row in manifest["parameters"]]),
    )
    library.prepare_forward_dynamics(pointer(p), pointer(w))
    given = {"t": [0.0], "q": [0.3, -0.2], "u": [0.5, 1.5], "tau": [0.0, 0.0], "r": [0.0]}
    given |= {"s": [row["default"] for row in manifest["s"]] or [0.0], "z": [0.0]}
    arrays = {block: np.array(values, dtype=float) for block, values in given.items()}
    blocks = Inputs(**{block: pointer(array) for block, array in arrays.items()}, w=pointer(w))
    assert library.forward_dynamics(ctypes.byref(blocks), pointer(out), pointer(work)) == 0
    same({"forward_dynamics": out}, "model.npz")


def contents(folder: Path) -> dict[str, bytes]:
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.name != ".lock"
    }


def test_a_cache_of_another_cardan_is_not_used(
    cache_directory: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its models are of other source: none is opened, none is changed."""
    # the working tree that wrote the cache is another one since
    monkeypatch.setattr(fingerprints, "source_state", lambda: [("other.py", 1, 1)])
    unpacked("cache.tar.xz", cache_directory)
    (old,) = (cache_directory / "models").iterdir()
    before = contents(old)
    equations = cd.derive(scene())
    assert old.name != fingerprints.fingerprint(equations)[:32]
    model = cd.compile(equations)
    assert model.directory != old
    same(of_model(model), "model.npz")
    assert contents(old) == before


def of_another_source(folder: Path) -> None:
    """The folder of a model whose functions are others."""
    file = folder / "rhs.c"
    file.write_text(file.read_text("utf-8").replace("sin", "cos"), "utf-8")


def of_another_format(folder: Path) -> None:
    manifest = json.loads((folder / "manifest.json").read_text("utf-8"))
    del manifest["digest"]
    (folder / "manifest.json").write_text(json.dumps({**manifest, "schema": 0, "abi": 0}), "utf-8")


def cut_off(folder: Path) -> None:
    file = folder / "manifest.json"
    file.write_bytes(file.read_bytes()[:1000])


@pytest.mark.parametrize("change", [of_another_source, of_another_format, cut_off])
def test_a_stale_model_in_the_place_of_a_new_one_is_written_anew(
    cache_directory: Path, change: Callable[[Path], None]
) -> None:
    unpacked("cache.tar.xz", cache_directory)
    (old,) = (cache_directory / "models").iterdir()
    equations = cd.derive(scene())
    place = old.with_name(fingerprints.fingerprint(equations)[:32])
    shutil.move(old, place)
    change(place)
    model = cd.compile(equations)
    assert model.directory == place
    same(of_model(model), "model.npz")
    assert json.loads((place / "manifest.json").read_text("utf-8"))["abi"] == version.ABI.version
