"""Saved motions, pages and checkpoints: what is saved comes back, what is damaged is refused."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.version import RUN
from full_disk import full_disk


@cache
def _door(coordinates: str) -> cd.CompiledModel:
    scene = cd.Scene("door", gravity=(0, 0, -9.81))
    leaf = scene.body("leaf", mass=2.0, com=(0.4, 0, 0), inertia=(0.1, 0.1, 0.15))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, leaf)
    scene.output("height", leaf.at(0.8, 0, 0).position()[2])
    return cd.compile(scene, coordinates=coordinates)


@cache
def _run(coordinates: str) -> cd.Trajectory:
    return _door(coordinates).simulate(0.5, q={"hinge": 0.3})


def _page(path: Path) -> dict[str, Any]:
    text = path.read_text("utf-8")
    found: dict[str, Any] = json.JSONDecoder().raw_decode(text[text.index('{"t":') :])[0]
    return found


def _shown(page: dict[str, Any]) -> np.ndarray:
    return np.array([body["pose"] for body in page["bodies"]])


def test_e1_a_motion_in_absolute_coordinates_is_saved(tmp_path: Path) -> None:
    """``save`` of a run in absolute coordinates raised KeyError: 'scene'."""
    motion = _run("absolute")
    back = cd.load_motion(motion.save(tmp_path / "run.nc"))
    np.testing.assert_array_equal(back.x, motion.x)
    assert repr(back) == repr(motion)
    np.testing.assert_allclose(back.pose("leaf"), motion.pose("leaf"), rtol=0, atol=1e-15)
    # a pose that is not in the file follows from the coordinates of the node
    fine = np.linspace(0, 0.5, 50)
    there, here = (one.resample(fine).pose("leaf") for one in (motion, back))
    # one is projected onto the hinge, the other is not: as far as the run is closed in between
    np.testing.assert_allclose(here, there, rtol=0, atol=1e-6)


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_e3_a_loaded_run_with_dense_output_is_animated(coordinates: str, tmp_path: Path) -> None:
    """``animate`` of a loaded run asked for the model, although the poses were in the file."""
    motion = _run(coordinates)
    back = cd.load_motion(motion.save(tmp_path / "run.nc"))
    motion.animate(tmp_path / "there.html", page="plain")
    back.animate(tmp_path / "here.html", page="plain")
    there, here = _page(tmp_path / "there.html"), _page(tmp_path / "here.html")
    assert here["t"] == there["t"]
    # pages hold five decimals; rounding may fall to either side
    np.testing.assert_allclose(_shown(here), _shown(there), rtol=0, atol=1.1e-5)
    assert [b["solids"] for b in here["bodies"]] == [b["solids"] for b in there["bodies"]]


def test_e3_a_long_run_without_its_model_has_a_short_page(tmp_path: Path) -> None:
    """Without a model every row of a run with output times went into the page."""
    motion = _door("relative").simulate(np.linspace(0, 5, 20_001), q={"hinge": 0.3})
    back = cd.load_motion(motion.save(tmp_path / "run.nc"))
    page = _page(back.animate(tmp_path / "page.html", page="plain").saved())
    assert 100 < len(page["t"]) <= 1500
    # the poses are those of the times that are shown
    rows = np.searchsorted(motion.t, np.array(page["t"]) - 1e-5)
    height = motion.pose("leaf")[rows, 0, 0]
    np.testing.assert_allclose(_shown(page)[0, :, 0], height, rtol=0, atol=2e-3)


def _endless(name: str) -> dict[str, Any]:
    """A pattern of as many rows as nobody has time for."""
    row = {"name": name, "unit": "", "joint": name, "body": name, "kind": "free"}
    return {"listed": [], "runs": [{"count": 10**15, "pattern": [row], "values": ""}]}


CHANGES: dict[str, Callable[[dict[str, Any]], Any]] = {
    "no coordinates": lambda notes: notes["manifest"].pop("coordinates"),
    "a row is a number": lambda notes: notes["manifest"].__setitem__("frames", [3]),
    "a joint beyond q": lambda notes: notes["manifest"]["joints"][0].__setitem__("q", [1, 10**9]),
    "a quaternion beyond q": lambda notes: notes["manifest"].__setitem__("quaternions", [7]),
    "follows itself": lambda notes: notes["manifest"]["joints"][0].__setitem__(
        "coupled", {"leader": "hinge"}
    ),
    "endless rows": lambda notes: notes["manifest"].__setitem__("coordinates", _endless("x")),
    "endless joints": lambda notes: notes["manifest"].__setitem__("joints", _endless("hinge")),
    "endless frames": lambda notes: notes["manifest"].__setitem__("frames", _endless("ground")),
    "no steps": lambda notes: notes["conduct"]["statistics"].pop("steps"),
    "a word more": lambda notes: notes["conduct"].__setitem__("x", 1),
    "scene of texts": lambda notes: notes["scene"].__setitem__("mass", ["x"]),
    "a tree of nothing": lambda notes: notes["manifest"].__setitem__("scene", {"x": 1}),
    "no frames": lambda notes: notes["scene"].__setitem__("frame_rotation", [1.0]),
    "sources": lambda notes: notes.__setitem__("sources", ["a", "b", "c"]),
}


@pytest.mark.parametrize("change", CHANGES)
def test_e3_what_does_not_fit_is_refused(change: str, tmp_path: Path) -> None:
    """A damaged file ended in KeyError, TypeError and others; also one whose hash is right."""
    from cardan.runtime import formats
    from cardan.runtime.formats.contents import Contents
    from cardan.runtime.trajectory import storage

    path = _run("relative").save(tmp_path / "run.nc")
    held = formats.load(path, RUN, ("title", *storage.NOTES))
    notes = {k: json.loads(v) for k, v in held.notes.items() if k != "title"}
    CHANGES[change](notes)
    told = {k: json.dumps(v) for k, v in notes.items()} | {"title": held.notes["title"]}
    formats.save(path, RUN, Contents(held.variables, told), "")
    with pytest.raises(cd.ModelError, match=re.escape(str(path))):
        cd.load_motion(path)


def test_e3_a_changed_number_is_found(tmp_path: Path) -> None:
    """One digit of a saved state changed went unseen."""
    path = _run("relative").save(tmp_path / "run.nc")
    data = bytearray(path.read_bytes())
    number = np.array(_run("relative").q[3, 0], dtype=">f8").tobytes()
    data[data.index(number) + 5] ^= 1
    path.write_bytes(data)
    with pytest.raises(cd.ModelError, match="its hash differs"):
        cd.load_motion(path)


def _stepper(path: Path) -> Any:
    stepper = _door("relative").stepper(q={"hinge": 0.3})
    stepper.step(0.01)
    return stepper.save(path)


def _ensemble(path: Path) -> Any:
    return _door("relative").ensemble(0.1, q={"hinge": np.linspace(0, 1, 200)}).save(path)


def _table(path: Path) -> Any:
    from cardan.analyses.identification.data import write

    return write(path, {"t": np.arange(1000.0)})


WRITERS: dict[str, Callable[[Path], Any]] = {
    "run.nc": lambda path: _run("relative").save(path),
    "page.html": lambda path: _run("relative").animate(path),
    "curves.png": lambda path: _run("relative").plot(path),
    "stepper.ckpt": _stepper,
    "ensemble.nc": _ensemble,
    "table.csv": _table,
}


@pytest.mark.parametrize("name", WRITERS)
def test_e7_a_full_disk_is_told_and_the_old_file_kept(name: str, tmp_path: Path) -> None:
    """A full disk ended in a bare OSError without the name of the file, or left half a file."""
    (tmp_path / "before").mkdir()
    # what is compiled, and kept, is compiled with room
    WRITERS[name](tmp_path / "before" / name)
    path = tmp_path / "now" / name
    path.parent.mkdir()
    path.write_text("what was there")
    with full_disk(1000), pytest.raises(cd.ModelError) as told:
        WRITERS[name](path)
    assert str(path) in str(told.value)
    assert "cannot be written: File too large. Make room" in str(told.value)
    assert path.read_text() == "what was there"
    assert [one.name for one in path.parent.iterdir()] == [name]
    # with room, the same call replaces it
    WRITERS[name](path)
    assert path.stat().st_size > 1000
    assert [one.name for one in path.parent.iterdir()] == [name]


@pytest.mark.parametrize("name", WRITERS)
def test_e7_what_is_no_file_is_not_replaced(name: str, tmp_path: Path) -> None:
    """A device or a folder with the name was replaced, or ended in a bare OSError."""
    path = tmp_path / name
    path.mkdir()
    with pytest.raises(cd.ModelError, match="is not a regular file"):
        WRITERS[name](path)
    path.rmdir()
    # a link stays one: what it leads to is replaced
    (tmp_path / "there").write_text("old")
    path.symlink_to("there")
    WRITERS[name](path)
    assert path.is_symlink()
    assert (tmp_path / "there").stat().st_size > 1000
