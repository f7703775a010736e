"""Faults of files that strangers or disks hand over."""

from __future__ import annotations

import errno
import json
import os
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import cardan as cd
from cardan.analyses.simulation.files.saved_record import record_of
from cardan.runtime.build import cache, cache_folder, file_trust, object_file
from cardan.schema.records import POINTER, Run
from cardan.schema.seal import sealed
from hostile.harness import campaign
from hostile.kinds import RUNS, double, run, stepper
from hostile.mutations import Mutant

# numbers of the record that are sizes, which a file of a stepper once held
SIZES = ("n", "nx", "nq", "nr", "ns", "signal_count", "tick_count", "stages", "dense_rows", "rates")
# from the model, its method and settings
FROM_MODEL = (
    *("nq", "nu", "nz", "nx", "n", "nr", "ns", "nlam", "signal_count", "quaternion_count"),
    *("bounded_count", "sampled", "charted", "positions", "rates", "ne", "watched", "tick_count"),
    *("stages", "dense_rows", "jumps", "rtol", "atol", "max_step", "on_grid", "pass_capacity"),
)
# what belongs to a process, or to the room that rows have there
OF_PROCESS = (
    *("capacity", "count", "log_capacity", "log_count", "stop_count", "next_stop"),
    *("time_count", "next_time", "budget", "stop", "pass_count"),
)


def _changed(kind: Any, change: Callable[[dict[str, Any]], None], folder: Path) -> str:
    """The verdict on a good file after a change of its parts, its hashes made anew."""

    def draw(drawn: Any, kind: Any, content: bytes, number: int) -> Mutant:
        parts = kind.unpack(content)
        change(parts)
        made = kind.pack(parts)
        return Mutant("changed", lambda path: path.write_bytes(made) and None, True, (("head",),))

    tally = campaign(type(kind)(**{**vars(kind), "draw": draw}), 1, 0, folder)
    return str(next(iter(tally.counts)))


@pytest.mark.parametrize("size", SIZES)
def test_e2_sizes_in_a_steppers_file_do_not_reach_c(size: str, tmp_path: Path) -> None:
    """Every number of the record was written into that of the kernels: most ended in a crash."""

    def change(parts: dict[str, Any]) -> None:
        parts["head"]["record"][size] = 1000

    assert _changed(stepper("DOP853", tmp_path / "good"), change, tmp_path) == "refused"


def test_e2_a_steppers_file_holds_no_sizes(tmp_path: Path) -> None:
    """The sizes of a run come from its model."""
    kind = stepper("DOP853", tmp_path / "good")
    assert kind.unpack is not None
    head = kind.unpack(kind.file.read_bytes())["head"]
    assert not set(SIZES) & set(head["record"])


def test_e2_every_number_of_the_record_is_saved_or_follows_from_the_model() -> None:
    """A new field of the record must be told apart: state that is saved, or a size that is not."""
    numbers = [field[0] for field in Run._fields_ if field[1] is not POINTER]
    runner = double().stepper()._runner
    saved = record_of(runner)
    assert sorted([*saved, *FROM_MODEL, *OF_PROCESS]) == sorted(numbers)


@pytest.mark.parametrize("name", ["next_stop", "next_time", "where"])
def test_e2_places_in_the_file_of_a_run_are_checked(name: str, tmp_path: Path) -> None:
    """They were written into the record of the kernels: crashes, and runs without an end."""

    def change(parts: dict[str, Any]) -> None:
        head = parts["records"][-1]["head"]
        head[name] = [10**6] * len(head[name]) if name == "where" else 10**6

    kind = run("dense", tmp_path / "good")
    assert "inputs" in RUNS["dense"][1]
    assert _changed(kind, change, tmp_path) == "refused"


def test_e2_a_changed_digit_in_a_steppers_file_is_found(tmp_path: Path) -> None:
    """A state that was changed on the disk gave other results without a word."""
    kind = stepper("DOP853", tmp_path / "good")
    data = kind.file.read_bytes()
    at = data.index(json.dumps("key").encode()) + 10
    (tmp_path / "bad.npz").write_bytes(
        data[:at] + b"0123456789"[data[at] % 10 :][:1] + data[at + 1 :]
    )
    with pytest.raises(cd.ModelError, match=r"bad\.npz is (not a checkpoint|damaged)"):
        kind.read(tmp_path / "bad.npz")


# the cache

ANSWER = "#include <stdlib.h>\nint answer(void) { return %d; }\n"


@pytest.fixture
def cache_directory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where the cache is to be, below a folder of its own; nothing is remembered of another one."""
    place = tmp_path / "above" / "cache"
    monkeypatch.setenv("CARDAN_CACHE", str(place))
    monkeypatch.setattr(cache_folder, "_SCRATCH", {})
    for remembered in (cache_folder._usable, cache_folder._temporary):
        remembered.cache_clear()
    return place


def _source(path: Path, answer: int = 42) -> Path:
    path.write_text(ANSWER % answer)
    return path


def _answer(built: object_file.Object) -> int:
    return int(built.load().answer())


def _planted(place: Path, tmp_path: Path) -> object_file.Object:
    """Another object, whole, under the name of one of the cache."""
    good = cache.build([_source(tmp_path / "good.c")])
    other = cache.build([_source(tmp_path / "other.c", 13)])
    content = other.path.read_bytes()
    other.path.unlink()
    good.path.unlink()
    (place.parent / "planted").write_bytes(content)
    return good


def test_e4_an_object_below_a_folder_of_others_does_not_run(
    cache_directory: Path, tmp_path: Path
) -> None:
    """The folder above the cache was not looked at: whoever may write there replaced the cache."""
    good = _planted(cache_directory, tmp_path)
    cache_directory.parent.chmod(0o777)
    shutil.copy(cache_directory.parent / "planted", good.path)
    with pytest.warns(cd.errors.BuildWarning, match=r"others may write to .*above"):
        built = cache.build([tmp_path / "good.c"])
    assert built.path.parent != cache_directory
    assert _answer(built) == 42


def test_e4_a_folder_that_becomes_writable_is_noticed_by_the_next_load(
    cache_directory: Path, tmp_path: Path
) -> None:
    """The folder was looked at once in a process."""
    built = cache.build([_source(tmp_path / "good.c")])
    cache_directory.parent.chmod(0o777)
    with pytest.raises(cd.BuildError, match=r"others may write to .*above now"):
        built.load()


def test_e4_the_sticky_bit_keeps_others_out(cache_directory: Path, tmp_path: Path) -> None:
    """Folders such as /tmp stay usable: what others put there replaces nothing."""
    cache_directory.parent.mkdir(mode=0o1777)
    cache_directory.parent.chmod(0o1777)
    assert cache.build([_source(tmp_path / "good.c")]).path.parent == cache_directory


@pytest.mark.parametrize("harm", ["link", "writable", "another user", "pipe", "folder"])
def test_e4_objects_that_others_may_have_made_are_made_again(
    harm: str, cache_directory: Path, tmp_path: Path
) -> None:
    """Owners, modes and links of the objects in the cache were not looked at."""
    good = _planted(cache_directory, tmp_path)
    planted = cache_directory.parent / "planted"
    if harm == "link":
        good.path.symlink_to(planted)
    elif harm in ("writable", "another user"):
        shutil.copy(planted, good.path)
        good.path.chmod(0o666)
        if harm == "another user":
            if os.geteuid():
                pytest.skip("only the superuser can give a file away")
            good.path.chmod(0o600)
            os.chown(good.path, 12345, 12345)
    elif harm == "pipe":
        os.mkfifo(good.path)
    else:
        good.path.mkdir()
    if harm == "folder":
        # it is not removed with what may be in it
        with pytest.raises(cd.BuildError, match=r"Is a directory.*run cardan doctor --prune --all"):
            cache.build([tmp_path / "good.c"])
        return
    built = cache.build([tmp_path / "good.c"])
    assert _answer(built) == 42
    assert built.fresh


def test_e4_links_on_the_way_are_followed_and_looked_at(
    cache_directory: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A link to a good folder does not help if others may replace the link."""
    (tmp_path / "real").mkdir()
    (tmp_path / "open").mkdir()
    (tmp_path / "open" / "way").symlink_to(tmp_path / "real")
    (tmp_path / "fine").symlink_to(tmp_path / "real")
    assert file_trust.exposed(tmp_path / "fine") == ""
    (tmp_path / "open").chmod(0o777)
    assert (
        file_trust.exposed(tmp_path / "open" / "way") == f"others may write to {tmp_path / 'open'}"
    )


def test_e7_a_cache_that_was_removed_is_made_again(cache_directory: Path, tmp_path: Path) -> None:
    """The advice was to make room by pruning what was not there."""
    cache.build([_source(tmp_path / "good.c")])
    shutil.rmtree(cache_directory)
    built = cache.build([tmp_path / "good.c"])
    assert built.path.parent == cache_directory
    assert _answer(built) == 42


def test_e7_the_cure_fits_what_the_system_says(cache_directory: Path, tmp_path: Path) -> None:
    """A cache that was removed between compiling and publishing was said to be full."""
    made = cache.compiled([_source(tmp_path / "good.c")])
    shutil.rmtree(cache_directory)
    with pytest.raises(cd.BuildError, match=r"was removed while this process ran: do the same"):
        made.published()
    assert "Make room" in cache_folder.cure(OSError(errno.ENOSPC, "No space left on device"))
    assert cache.build([tmp_path / "good.c"]).fresh


# manifests


def _pendulum() -> cd.Scene:
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, rod)
    return scene


def _resealed(file: Path, size: str, value: int) -> None:
    """Another size of ``rhs`` in a manifest, with its hash made anew."""
    data = json.loads(file.read_bytes())
    del data["digest"]
    data["functions"]["rhs"][size] = value
    file.write_text(sealed(data))


@pytest.mark.parametrize("size", ["prepared_size", "work_size", "output_size"])
def test_e2_sizes_of_a_manifest_are_compared_with_the_object(size: str, tmp_path: Path) -> None:
    """A digit of ``prepared_size`` in a cached manifest led to a crash or a broken heap."""
    model = cd.compile(_pendulum())
    model.simulate(0.1)
    shutil.copytree(model.directory, tmp_path / "model")
    _resealed(tmp_path / "model" / "manifest.json", size, 1000)
    with pytest.raises((cd.BuildError, cd.ModelError), match=r"rhs|outputs"):
        cd.load_model(tmp_path / "model").simulate(0.1)


def test_e2_a_changed_digit_in_a_manifest_is_found(tmp_path: Path) -> None:
    """The manifest had no hash of its own."""
    model = cd.compile(_pendulum())
    model.simulate(0.1)
    shutil.copytree(model.directory, tmp_path / "model")
    file = tmp_path / "model" / "manifest.json"
    text = file.read_text()
    assert '"default": -9.81' in text
    file.write_text(text.replace('"default": -9.81', '"default": -9.71'))
    with pytest.raises(cd.ModelError, match=r"manifest\.json is not a manifest, or is damaged"):
        cd.load_model(tmp_path / "model")


@pytest.mark.parametrize("file", ["manifest.json", "functions.json"])
def test_e7_a_damaged_folder_in_the_cache_is_written_anew(file: str, tmp_path: Path) -> None:
    """A damaged manifest was refused where a damaged object is compiled anew."""
    model = cd.compile(_pendulum(), directory=tmp_path / "model")
    good = model.simulate(0.1, q={"hinge": 1.0}).x
    content = (tmp_path / "model" / file).read_bytes()
    (tmp_path / "model" / file).write_bytes(content[: len(content) // 2])
    again = cd.compile(_pendulum(), directory=tmp_path / "model")
    assert again.simulate(0.1, q={"hinge": 1.0}).x.tobytes() == good.tobytes()


def test_e7_a_models_folder_that_was_removed_is_written_anew(tmp_path: Path) -> None:
    """What was not loaded yet ended in the advice to make room."""
    model = cd.compile(_pendulum(), directory=tmp_path / "model")
    model.simulate(0.1)
    shutil.rmtree(tmp_path / "model")
    assert model.momentum([0.5], [0.1]).shape == (6,)


# beams in scene files

BEAM = """cardan: 2
bodies: {arm: {mass: 1.0, inertia: [0.1, 0.1, 0.1], com: [0.5, 0, 0]}}
joints: {hinge: {type: revolute, axis: z, parent: ground, child: arm}}
beams:
  b: {start: arm, section: {circle: {radius: 0.01}}, material: {E: 7e10, nu: 0.3, rho: 2700}, %s}
"""
ABSURD = {
    "end: [1, 0, 0], elements: 6e10": r"scene\.yaml:5.*60000000000\.0 elements; a beam has at most",
    "end: [1, 0, 0], elements: 1e300": r"scene\.yaml:5.*elements; a beam has at most 100000",
    "end: [1e200, 0, 0], elements: 2": r"beam 'b': a point of its line is 1e\+200 m away",
    "end: [1, 0, 0], elements: 2, line: {spline: {points: [[0,0,0],[1e300,0,0],[1,0,0]]}}": (
        r"beam 'b': a point of its line is 1e\+300 m away"
    ),
}


@pytest.mark.parametrize("beam", ABSURD)
def test_e6_absurd_beams_are_refused_with_their_place(beam: str, tmp_path: Path) -> None:
    """They ended in a MemoryError, or in errors of NumPy and SciPy."""
    (tmp_path / "scene.yaml").write_text(BEAM % beam)
    with pytest.raises(cd.ModelError, match=ABSURD[beam]):
        cd.derive(cd.load(tmp_path / "scene.yaml"))


def test_e3_damage_does_not_make_an_early_version_of_a_file(tmp_path: Path) -> None:
    """Where the word of the version was damaged too, the hash of an ensemble was not asked for."""
    scene = cd.Scene("one")
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    path = tmp_path / "runs.nc"
    cd.compile(scene).ensemble(0.1, q={"pivot": [0.1, 0.2]}).save(path)
    good = path.read_bytes()
    assert good.count(b"cardan_ensemble") == 1
    path.write_bytes(good[:-1] + b"\x55")
    with pytest.raises(cd.ModelError, match="its hash differs"):
        cd.load_ensemble(path)
    path.write_bytes(path.read_bytes().replace(b"cardan_ensemble", b"cardan_ensemxle"))
    with pytest.raises(cd.ModelError, match="its hash differs"):
        cd.load_ensemble(path)
