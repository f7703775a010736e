"""Motions as files of other programs: read back by trimesh, mcap, pandas, h5netcdf and by hand."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial.transform import Rotation

import cardan as cd
from cardan.runtime import formats
from cardan.view import motion_files
from full_disk import full_disk
from superelements.test_moving_pictures import swing

ODD = "lower: [b] /c, </script> \u00e9 \U0001f600"
UP = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
TIMES = (0.4321, 1.7113, 3.97531)


def arm() -> cd.Scene:
    """Two links with a stop, an input, a sampled controller, an output and odd names."""
    scene = cd.Scene("arm </script>", gravity=(0, 0, -9.81))
    rod = cd.inertia.rod(1.0, 1.0, axis="z")
    shape = [
        cd.shape.box(0.1, 0.1, 1.0, position=(0, 0, -0.5), color=(1, 0, 0, 0.5)),
        cd.shape.cylinder(0.05, 0.3, axis="y"),
        cd.shape.capsule(0.02, 0.2, axis="x"),
        cd.shape.sphere(0.1, position=(0, 0, -1)),
    ]
    upper = scene.body("upper", mass=1, com=(0, 0, -0.5), inertia=rod, shape=shape)
    lower = scene.body(ODD, mass=1, com=(0, 0, -0.5), inertia=rod)
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -1), lower)
    hand = lower.at(0, 0, -1, rotation=("XYZ", 0.1, 0.2, 0.3), name="hand")
    scene.force("stop", cd.Stop("elbow", upper=0.5, restitution=0.5))
    scene.force("motor", cd.JointForce("shoulder", scene.input("drive", 0.3)))
    scene.force("spring", cd.SpringDamper(scene.ground.at(1, 0, 0), hand, 3.0, 0.1, 1.0))
    scene.output("height of hand", hand.position()[2], unit="m")
    return scene


@pytest.fixture(scope="module")
def motion() -> cd.Trajectory:
    return cd.compile(arm()).simulate(4.0, q={"shoulder": 1.0}, rtol=1e-9)


def beam() -> cd.Trajectory:
    scene = cd.Scene("bent", gravity=(0, 0, -9.81))
    steel = cd.material(E=2e9, nu=0.3, rho=2000)
    tip = scene.body("tip", mass=0.2, pose=(1, 0, 0))
    scene.beam("rod", scene.ground, tip, cd.section.rectangle(0.02, 0.01), steel, elements=4)
    return cd.compile(scene).simulate(0.2)


class Gltf:
    """A reader of glTF that shares nothing with the writer."""

    def __init__(self, path: Path) -> None:
        data = path.read_bytes()
        magic, version, size = struct.unpack("<4sII", data[:12])
        assert (magic, version, size) == (b"glTF", 2, len(data))
        length, kind = struct.unpack("<I4s", data[12:20])
        assert kind == b"JSON"
        self.json = json.loads(data[20 : 20 + length])
        rest = data[20 + length :]
        (length, kind) = struct.unpack("<I4s", rest[:8])
        assert kind == b"BIN\0"
        assert len(rest) == 8 + length
        self.block = rest[8:]

    def array(self, number: int) -> np.ndarray:
        entry = self.json["accessors"][number]
        view = self.json["bufferViews"][entry["bufferView"]]
        assert view["byteOffset"] % 4 == 0
        kind = {5126: "<f4", 5123: "<u2", 5125: "<u4"}[entry["componentType"]]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}[entry["type"]]
        count = entry["count"] * width
        values = np.frombuffer(self.block, kind, count, view["byteOffset"]).reshape(-1, width)
        if "min" in entry:
            np.testing.assert_array_equal(values.min(axis=0), entry["min"])
            np.testing.assert_array_equal(values.max(axis=0), entry["max"])
        return values

    def node(self, name: str) -> int:
        (number,) = (k for k, one in enumerate(self.json["nodes"]) if one["name"] == name)
        return number

    def tracks(self, node: int) -> Iterator[tuple[str, np.ndarray, np.ndarray]]:
        """Path, times and keys (n, 3, k)."""
        (animation,) = self.json["animations"]
        for channel in animation["channels"]:
            if channel["target"]["node"] == node:
                sampler = animation["samplers"][channel["sampler"]]
                assert sampler["interpolation"] == "CUBICSPLINE"
                t = self.array(sampler["input"])[:, 0]
                assert (np.diff(t) > 0).all()
                keys = self.array(sampler["output"]).reshape(len(t), 3, -1)
                yield channel["target"]["path"], t, keys

    def pose(self, name: str, at: float) -> np.ndarray:
        """Pose of a node below the root at a time."""
        number = self.node(name)
        values = {path: np.array(self.json["nodes"][number].get(path, ())) for path in PARTS}
        for path, t, keys in self.tracks(number):
            # a key has a slope before it and one behind it
            k = int(np.clip(np.searchsorted(t, at) - 1, 0, len(t) - 2))
            ends, slopes = keys[k : k + 2, 1], [keys[k, 2], keys[k + 1, 0]]
            values[path] = CubicHermiteSpline(t[k : k + 2], ends, slopes)(at)
        pose = np.eye(4)
        pose[:3, :3] = Rotation.from_quat(values["rotation"]).as_matrix()
        pose[:3, 3] = values["translation"]
        return pose


PARTS = ("translation", "rotation")


def test_bodies_go_where_the_motion_goes(motion: cd.Trajectory, tmp_path: Path) -> None:
    file = Gltf(motion.save(tmp_path / "arm.glb"))
    impacts = [event.t for event in motion.events]
    assert impacts
    fixed = file.json["nodes"][file.node("hand")]
    place = np.eye(4)
    place[:3, :3] = Rotation.from_quat(fixed["rotation"]).as_matrix()
    place[:3, 3] = fixed["translation"]
    for t in (*TIMES, impacts[0] - 1e-3, impacts[0] + 1e-3):
        exact = motion.resample([t])
        for name in ("upper", ODD):
            np.testing.assert_allclose(file.pose(name, t), exact.pose(name)[0], atol=5e-6)
        np.testing.assert_allclose(file.pose(ODD, t) @ place, exact.pose("hand")[0], atol=1e-5)


def test_quaternions_do_not_jump(tmp_path: Path) -> None:
    scene = cd.Scene("top", gravity=(0, 0, 0))
    body = scene.body("body", mass=1, inertia=(0.1, 0.2, 0.3))
    scene.joint("free", cd.Free(), scene.ground, body)
    spin = cd.compile(scene).simulate(3.0, u={"free": (0.1, 20.0, 0.1, 0, 0, 0)})
    file = Gltf(spin.save(tmp_path / "top.glb"))
    for path, _, keys in file.tracks(file.node("body")):
        if path == "rotation":
            assert np.abs(np.diff(keys[:, 1], axis=0)).max() < 0.3
    for t in TIMES[:2]:
        np.testing.assert_allclose(
            file.pose("body", t), spin.resample([t]).pose("body")[0], atol=1e-5
        )


def test_gravity_says_what_is_up(tmp_path: Path) -> None:
    for gravity, axis in (((0, 0, -9.81), 2), ((0, -9.81, 0), 1), ((9.81, 0, 0), 0)):
        scene = cd.Scene("drop", gravity=gravity)
        ball = scene.body("ball", mass=1, inertia=(1, 1, 1))
        scene.joint("free", cd.Free(), scene.ground, ball)
        file = Gltf(cd.compile(scene).simulate(0.5).save(tmp_path / "drop.glb"))
        root = Rotation.from_quat(file.json["nodes"][0]["rotation"])
        up = np.zeros(3)
        up[axis] = -np.sign(gravity[axis])
        np.testing.assert_allclose(root.apply(up), [0, 1, 0], atol=1e-7)


def test_trimesh_reads_solids_in_place(motion: cd.Trajectory, tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    scene: Any = trimesh.load(motion.save(tmp_path / "arm.glb"))
    nodes = scene.graph.nodes
    assert {"upper", ODD, "hand", "ground", "spring"} <= set(nodes)
    pose, _ = scene.graph["hand"]
    np.testing.assert_allclose(pose[:3, 3], UP @ motion.pose("hand")[0, :3, 3], atol=1e-6)
    shapes = [scene.graph[n] for n in scene.graph.nodes_geometry if n.startswith("upper")]
    # a box of 0.1 x 0.1 x 1 beside round solids: closed, and seen from outside
    volumes = [scene.geometry[name].volume for _, name in shapes]
    expected = 0.01 + np.pi * (0.05**2 * 0.3 + 0.02**2 * 0.2 + 4 / 3 * (0.1**3 + 0.02**3))
    # facets lie inside of what is round
    assert 0.97 * expected < sum(volumes) < expected
    assert all(scene.geometry[name].is_winding_consistent for _, name in shapes)


def test_a_beam_is_a_skin_over_its_sections(tmp_path: Path) -> None:
    bent = beam()
    file = Gltf(bent.save(tmp_path / "bent.glb"))
    node = file.json["nodes"][file.node("rod")]
    skin = file.json["skins"][node["skin"]]
    (primitive,) = file.json["meshes"][node["mesh"]]["primitives"]
    vertices, joints, weights = (
        file.array(primitive["attributes"][name]) for name in ("POSITION", "JOINTS_0", "WEIGHTS_0")
    )
    np.testing.assert_allclose(weights.sum(axis=1), 1, atol=1e-6)
    inverses = file.array(skin["inverseBindMatrices"]).reshape(-1, 4, 4).swapaxes(1, 2)
    names = [file.json["nodes"][k]["name"] for k in skin["joints"]]
    root = np.eye(4)
    root[:3, :3] = UP
    for t in (0.0, 0.0777, 0.2):
        sections = [file.pose(name, t) for name in names]
        np.testing.assert_allclose(sections, bent.resample([t]).sections("rod")[0], atol=1e-6)
        moved = [root @ pose @ inverse for pose, inverse in zip(sections, inverses, strict=True)]
        points = np.einsum("nk,nkij,nj->ni", weights, np.array(moved)[joints],
                           np.hstack([vertices, np.ones((len(vertices), 1))]))[:, :3]  # fmt: skip
        # corners of 20 x 10 mm around both ends
        for end in bent.resample([t]).line("rod")[0, [0, -1]]:
            nearest = np.sort(np.linalg.norm(points - UP @ end, axis=1))[:8]
            np.testing.assert_allclose(nearest, np.hypot(0.01, 0.005), atol=1e-5)


def test_superelements_move_by_their_shapes(tmp_path: Path) -> None:
    run = swing()
    file = Gltf(run.save(tmp_path / "swing.glb"))
    number = file.node("link")
    mesh = file.json["meshes"][file.json["nodes"][number]["mesh"]]
    (primitive,) = mesh["primitives"]
    base = file.array(primitive["attributes"]["POSITION"])
    targets = np.stack([file.array(target["POSITION"]) for target in primitive["targets"]])
    (weights,) = (keys for path, _, keys in file.tracks(number) if path == "weights")
    assert np.abs(weights[:, 1]).max() == pytest.approx(1)
    record = run.superelement("link")
    places = record.positions[-1]
    local = base + np.tensordot(weights[-1, 1], targets, 1)
    pose = file.pose("link", float(run.t[-1]))
    there = local @ pose[:3, :3].T + pose[:3, 3]
    # every vertex is a point of the surface, and every point of it is one
    distances = np.linalg.norm(there[:, None] - places[None], axis=-1)
    assert distances.min(axis=1).max() < 1e-6
    assert distances.min(axis=0).max() < 1e-6


def test_single_rows_stand_still(motion: cd.Trajectory, tmp_path: Path) -> None:
    file = Gltf(motion.resample([1.0]).save(tmp_path / "one.glb"))
    assert "animations" not in file.json


@pytest.mark.parametrize("ending", motion_files.FORMATS)
def test_a_motion_in_which_nothing_moves(ending: Any, tmp_path: Path) -> None:
    scene = cd.Scene("fixed")
    scene.joint("weld", cd.Fixed(), scene.ground, scene.body("block", mass=1.0))
    path = cd.compile(scene).simulate(1.0).save(tmp_path / f"still{ending.endings[0]}")
    assert path.stat().st_size > 0


def test_mcap_has_frames_and_histories(motion: cd.Trajectory, tmp_path: Path) -> None:
    reader = pytest.importorskip("mcap.reader")
    rows: dict[str, list[Any]] = {}
    with motion.save(tmp_path / "arm.mcap").open("rb") as stream:
        read = reader.make_reader(stream)
        for schema, channel, message in read.iter_messages():
            assert schema.encoding == "jsonschema"
            assert channel.message_encoding == "json"
            rows.setdefault(channel.topic, []).append((message.log_time, json.loads(message.data)))
    topics = {"/tf", "/tf_static", "/coordinates", "/speeds", "/inputs", "/outputs", "/energy"}
    assert topics | {"/events", "/modes"} == set(rows)
    for k, t in enumerate(motion.t):
        at, values = rows["/coordinates"][k]
        assert at == round(t * 1e9)
        assert values == {"shoulder": motion["shoulder"][k], "elbow": motion["elbow"][k]}
        transforms = {row["child_frame_id"]: row for row in rows["/tf"][k][1]["transforms"]}
        lower = transforms[ODD]
        assert lower["parent_frame_id"] == "ground"
        assert lower["timestamp"] == {"sec": at // 10**9, "nsec": at % 10**9}
        pose = motion.pose(ODD)[k]
        np.testing.assert_allclose([*lower["translation"].values()], pose[:3, 3], atol=1e-12)
        R = Rotation.from_quat([*lower["rotation"].values()]).as_matrix()
        np.testing.assert_allclose(R, pose[:3, :3], atol=1e-12)
    (_, fixed), *more = rows["/tf_static"]
    assert not more
    hand = next(row for row in fixed["transforms"] if row["child_frame_id"] == "hand")
    assert hand["parent_frame_id"] == ODD
    assert [*hand["translation"].values()] == pytest.approx([0, 0, -1])
    assert len(rows["/events"]) == len(motion.events)


def test_mcap_of_beams_has_their_sections(tmp_path: Path) -> None:
    reader = pytest.importorskip("mcap.reader")
    bent = beam()
    with bent.save(tmp_path / "bent.mcap").open("rb") as stream:
        messages = reader.make_reader(stream).iter_messages(topics=["/tf"])
        last = json.loads([*messages][-1][2].data)
    names = {row["child_frame_id"]: row for row in last["transforms"]}
    end = [*names["rod.section4"]["translation"].values()]
    np.testing.assert_allclose(end, bent.line("rod")[-1, -1], atol=1e-12)


def test_pandas_reads_tables_with_units(motion: cd.Trajectory, tmp_path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    table = pandas.read_csv(motion.save(tmp_path / "arm.csv"), float_precision="round_trip")
    for name, unit in (("shoulder", "rad"), ("elbow.u", "rad/s"), ("height of hand", "m")):
        assert table[f"{name} [{unit}]"].tolist() == motion[name].tolist()
    assert table["t [s]"].tolist() == motion.t.tolist()
    pose = motion.pose(ODD)
    assert table[f"{ODD}.pose.px [m]"].tolist() == pose[:, 0, 3].tolist()
    frame = motion.to_pandas()
    assert frame.index.tolist() == motion.t.tolist()
    for name in ("shoulder", "elbow.u", "drive", "stop", "height of hand"):
        assert frame[name].tolist() == motion[name].tolist()
    units = frame.attrs["units"]
    assert set(units) == {"t", *frame.columns}
    assert (units["t"], units["elbow.u"], units["height of hand"]) == ("s", "rad/s", "m")
    assert frame.attrs["model"] == "arm </script>"


def test_h5netcdf_reads_what_it_wrote(motion: cd.Trajectory, tmp_path: Path) -> None:
    h5netcdf = pytest.importorskip("h5netcdf")
    pytest.importorskip("h5py")
    path = motion.save(tmp_path / "arm.nc4")
    with h5netcdf.File(path) as file:
        np.testing.assert_array_equal(file["q"][:], motion.q)
        assert json.loads(file["q"].attrs["names"]) == ["shoulder", "elbow"]
        assert file["time"].attrs["units"] == "s"
    with pytest.raises(cd.ModelError, match=r"netCDF-4 is written only, and \.nc"):
        cd.load_motion(path)


def test_json_says_names_and_units(motion: cd.Trajectory, tmp_path: Path) -> None:
    read = json.loads(motion.save(tmp_path / "arm.json").read_text("ascii"))
    q = read["arrays"]["q"]
    assert q["values"] == motion.q.tolist()
    assert (q["axes"], q["names"], q["units"]) == (
        ["time", "coordinate"], ["shoulder", "elbow"], ["rad", "rad"],
    )  # fmt: skip
    assert read["manifest"]["name"] == "arm </script>"


WRITTEN = [ending for one in motion_files.FORMATS for ending in one.endings if ending]


@pytest.mark.parametrize("ending", WRITTEN)
def test_a_full_disk_leaves_the_old_file(
    motion: cd.Trajectory, tmp_path: Path, ending: str
) -> None:
    path = tmp_path / f"run{ending}"
    motion.save(path)
    before = path.read_bytes()
    with full_disk(1000), pytest.raises(cd.ModelError, match="Make room or name another place"):
        motion.save(path)
    assert path.read_bytes() == before
    assert [*tmp_path.iterdir()] == [path]


@pytest.mark.parametrize("ending", WRITTEN)
def test_runs_of_files_are_written_too(motion: cd.Trajectory, tmp_path: Path, ending: str) -> None:
    again = cd.load_motion(motion.save(tmp_path / "run.nc"))
    assert again.save(tmp_path / f"again{ending.upper()}").stat().st_size > 1000


def test_unknown_endings_have_near_names(motion: cd.Trajectory, tmp_path: Path) -> None:
    with pytest.raises(cd.ModelError, match=r"\.mcap \(MCAP\)\. Did you mean \.glb\?"):
        motion.save(tmp_path / "arm.gbl")
    with pytest.raises(cd.ModelError, match=r"is not a regular file|cannot be written"):
        motion.save(tmp_path)
    assert not [*tmp_path.iterdir()]


def test_missing_packages_name_their_extra(
    motion: cd.Trajectory, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(formats, "find_spec", lambda package: None)
    for ending, extra in (("mcap", "mcap"), ("nc4", "data")):
        with pytest.raises(ModuleNotFoundError, match=rf"pip install 'cardan\[{extra}\]'"):
            motion.save(tmp_path / f"run.{ending}")
    monkeypatch.setitem(__import__("sys").modules, "pandas", None)
    with pytest.raises(ModuleNotFoundError, match=r"pip install 'cardan\[data\]'"):
        motion.to_pandas()


def test_what_moves_too_fast_is_said(tmp_path: Path) -> None:
    scene = cd.Scene("rotor", gravity=(0, 0, 0))
    body = scene.body("disk", mass=1, inertia=(0.1, 0.1, 0.2))
    scene.joint("spin", cd.Revolute("z"), scene.ground, body)
    motion = cd.compile(scene).simulate(10.0, u={"spin": 1e5})
    with pytest.warns(cd.errors.ModelWarning, match="moves so fast that"):
        motion.save(tmp_path / "rotor.glb")
