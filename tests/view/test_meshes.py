"""Meshes of files: shapes with known volume, hostile files, reduction and packing."""

from __future__ import annotations

import importlib.metadata
import importlib.util
import struct
import time
from pathlib import Path

import numpy as np
import pytest

from cardan.errors import ModelError
from cardan.view import meshes
from cardan.view.mesh_files import part as part_module

CORNERS = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
TRIANGLES = [t for a, b, c, d in FACES for t in ((a, b, c), (a, c, d))]


def volume(part: meshes.Part) -> float:
    """Volume inside triangles, by tetrahedra with the origin."""
    a, b, c = np.moveaxis(part.vertices[part.triangles].astype(float), 1, 0)
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def area(part: meshes.Part) -> float:
    a, b, c = np.moveaxis(part.vertices[part.triangles].astype(float), 1, 0)
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


def binary_stl(
    rows: list[tuple[int, int, int]], corners: list[tuple[float, float, float]]
) -> bytes:
    body = b"".join(
        struct.pack("<12fH", 0, 0, 0, *(x for k in row for x in corners[k]), 0) for row in rows
    )
    return b"solid header of a binary file".ljust(80) + struct.pack("<I", len(rows)) + body


def text_stl() -> bytes:
    facets = [
        "facet normal 0 0 0\n outer loop\n"
        + "".join(f"  vertex {' '.join(map(str, CORNERS[k]))}\n" for k in row)
        + " endloop\nendfacet\n"
        for row in TRIANGLES
    ]
    return ("solid cube\n" + "".join(facets) + "endsolid cube\n").encode()


def obj(negative: bool = False) -> bytes:
    shift = -8 if negative else 1
    lines = [f"v {x} {y} {z}" for x, y, z in CORNERS]
    lines += ["f " + " ".join(f"{k + shift}/1/1" for k in face) for face in FACES]
    return "\n".join(lines).encode()


HEAD = '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">'
NUMBERS = " ".join(f"{x} {y} {z}" for x, y, z in CORNERS)
QUADS = " ".join(f"{k} 0" for face in FACES for k in face)
RED = '<instance_material symbol="paint" target="#red"/>'
CUBE_NODE = f"""<node id="cube"><instance_geometry url="#g"><bind_material><technique_common>
{RED}</technique_common></bind_material></instance_geometry></node>"""


def dae(nodes: str, points: str = NUMBERS, p: str = QUADS, library: str = "") -> bytes:
    """A cube of four inputs, in decimeters, instanced by the nodes."""
    return f"""<?xml version="1.0"?>{HEAD}<asset><unit meter="0.1"/></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><phong><diffuse>
<color>1 0.5 0 1</color></diffuse></phong></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="red"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="s"><float_array id="a" count="24">{points}</float_array><technique_common>
<accessor source="#a" count="8" stride="3"/></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#s"/></vertices>
<polylist material="paint" count="6"><input semantic="VERTEX" source="#v" offset="0"/>
<input semantic="NORMAL" source="#s" offset="1"/><vcount>4 4 4 4 4 4</vcount><p>{p}</p></polylist>
</mesh></geometry></library_geometries>{library}
<library_visual_scenes><visual_scene id="w">{nodes}</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#w"/></scene></COLLADA>""".encode()


def written(tmp_path: Path, name: str, content: bytes) -> Path:
    path = tmp_path / name
    path.write_bytes(content)
    return path


CUBES = {
    "binary.stl": binary_stl(TRIANGLES, CORNERS),
    "text.STL": text_stl(),
    "cube.obj": obj(),
    "negative.obj": obj(negative=True),
}


@pytest.mark.parametrize("name", CUBES)
def test_a_cube_has_twelve_triangles_and_its_volume(name: str, tmp_path: Path) -> None:
    (part,) = meshes.read(written(tmp_path, name, CUBES[name]))
    assert part.vertices.shape == (8, 3)
    assert part.triangles.shape == (12, 3)
    assert part.color is None
    assert volume(part) == 8
    assert part.vertices.dtype == np.float32
    assert part.triangles.dtype == np.uint32


def test_collada_nodes_place_scale_and_mirror(tmp_path: Path) -> None:
    """Unit, nested nodes, a mirror, a rotation, a matrix and a node that is used twice."""
    nodes = f"""<node><translate>10 0 0</translate><rotate>0 0 1 90</rotate>
<scale>-1 2 1</scale>{CUBE_NODE}</node><node><matrix>1 0 0 0 0 1 0 -9 0 0 1 0 0 0 0 1</matrix>
<instance_node url="#cube"/></node>"""
    (part,) = meshes.read(written(tmp_path, "cube.dae", dae(nodes)))
    assert part.color == (1, 0.5, 0)
    assert len(part.triangles) == 24
    assert volume(part) == pytest.approx(0.016 + 0.008)
    np.testing.assert_allclose(part.vertices.min(axis=0), (-0.1, -1, -0.1), atol=1e-7)
    # after the rotation the doubled edge lies along x
    np.testing.assert_allclose(part.vertices.max(axis=0), (1.2, 0.1, 0.1), atol=1e-7)


POLYGONS = {
    "triangles": ("<p>0 2 3 0 3 1</p>", 4.0),
    "polygons": ("<p>0 2 3 1</p><p>4 5 7 6</p>", 8.0),
    "trifans": ("<p>0 2 3 1</p>", 4.0),
    "tristrips": ("<p>0 2 1 3</p>", 4.0),
}


@pytest.mark.parametrize("kind", POLYGONS)
def test_collada_polygons_of_every_kind(kind: str, tmp_path: Path) -> None:
    p, expected = POLYGONS[kind]
    text = dae(CUBE_NODE).decode()
    begin, end = text.index("<polylist"), text.index("</polylist>")
    one = f'<{kind} count="1"><input semantic="VERTEX" source="#v" offset="0"/>{p}</{kind}>'
    content = (text[:begin] + one + text[end + len("</polylist>") :]).encode()
    (part,) = meshes.read(written(tmp_path, "face.dae", content))
    assert area(part) == pytest.approx(0.01 * expected)
    a, b, c = np.moveaxis(part.vertices[part.triangles].astype(float), 1, 0)
    below = a[:, 2] < 0
    assert np.all(np.cross(b - a, c - a)[below, 2] < 0)  # both triangles face down


def test_obj_colors_come_from_the_material_file_below_the_folder(tmp_path: Path) -> None:
    faces = [f"usemtl {'red' if k % 2 else 'blue'}\nf 1 2 3\nf 2 3 4" for k in range(4)]
    corners = "\n".join(f"v {x} {y} {z}" for x, y, z in CORNERS)
    inner = tmp_path / "robot"
    (inner / "materials").mkdir(parents=True)
    kinds = b"newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n"
    (inner / "materials" / "m.mtl").write_bytes(kinds)
    (tmp_path / "out.mtl").write_bytes(kinds)
    text = "mtllib {}\n" + corners + "\n" + "\n".join(faces)
    path = written(inner, "a.obj", text.format("materials/m.mtl").encode())
    assert {part.color for part in meshes.read(path)} == {(1, 0, 0), (0, 0, 1)}
    for outside in ("../out.mtl", str(tmp_path / "out.mtl"), "absent.mtl", "materials"):
        path.write_bytes(text.format(outside).encode())
        assert [part.color for part in meshes.read(path)] == [None]


def _circular() -> bytes:
    inner = '<node id="loop"><instance_node url="#loop"/></node>'
    return dae(inner)


def _exploding() -> bytes:
    """Every node uses the next one twice: two to the power of forty cubes."""
    levels = "".join(
        f'<node id="n{k}"><instance_node url="#n{k + 1}"/><instance_node url="#n{k + 1}"/></node>'
        for k in range(40)
    )
    library = f'<library_nodes>{levels}<node id="n40">{CUBE_NODE}</node></library_nodes>'
    return dae('<node><instance_node url="#n0"/></node>', library=library)


BOMB = '<!DOCTYPE x [<!ENTITY a "1 1 1"><!ENTITY b "&a;&a;&a;&a;">]>' + HEAD + "&b;</COLLADA>"
LONG = b"9" * 3_000_000
HOSTILE = {
    "empty.stl": b"",
    "empty.obj2": b"",
    "empty.dae": b"",
    "no_extension": b"solid",
    "short.stl": binary_stl(TRIANGLES, CORNERS)[:-7],
    "counts.stl": b"\0" * 80 + b"\xff\xff\xff\xff" + b"\0" * 500,
    "nan.stl": binary_stl([(0, 1, 2)], [(float("nan"), 0, 0), (1, 0, 0), (0, 1, 0)]),
    "far.stl": binary_stl([(0, 1, 2)], [(1e30, 0, 0), (1, 0, 0), (0, 1, 0)]),
    "cut.stl": text_stl()[:-40],
    "words.stl": text_stl().replace(b"vertex 1", b"vertex one", 1),
    "inf.stl": text_stl().replace(b"vertex 1", b"vertex 1e999", 1),
    "line.stl": b"solid\nvertex " + LONG + b" 1 2\nendsolid",
    "photo.stl": b"\x89PNG\r\n" + bytes(range(256)) * 4,
    "row.obj": obj() + b"\nf 1 2 9",
    "zero.obj": obj() + b"\nf 0 1 2",
    "back.obj": obj() + b"\nf -9 1 2",
    "word.obj": obj() + b"\nf one two three",
    "nan.obj": obj().replace(b"v -1", b"v nan", 1),
    "two.obj": b"v 1 2\n" + obj(),
    "line.obj": b"f " + b"1 " * 3_000_000,
    "digits.obj": obj() + b"\nf 1 2 " + LONG[:50_000],
    "bomb.dae": BOMB.encode(),
    "cut.dae": dae(CUBE_NODE)[:-30],
    "other.dae": b"<robot/>",
    "nodes.dae": b"<a>" * 100_000,
    "loop.dae": _circular(),
    "exploding.dae": _exploding(),
    "nan.dae": dae(CUBE_NODE, points=NUMBERS.replace("-1", "nan", 1)),
    "few.dae": dae(CUBE_NODE, points="1 2 3"),
    "words.dae": dae(CUBE_NODE, points=NUMBERS.replace("-1", "one", 1)),
    "row.dae": dae(CUBE_NODE, p=QUADS.replace("7 0", "8 0", 1)),
    "huge.dae": dae(CUBE_NODE, p=QUADS.replace("7 0", "1e300 0", 1)),
    "negative.dae": dae(CUBE_NODE, p=QUADS.replace("7 0", "-1 0", 1)),
    "odd.dae": dae(CUBE_NODE, p=QUADS + " 1"),
    "missing.dae": dae(CUBE_NODE.replace("#g", "#h")),
    "matrix.dae": dae(f"<node><matrix>1 2 3</matrix>{CUBE_NODE}</node>"),
    "inf.dae": dae(f"<node><scale>1e999 1 1</scale>{CUBE_NODE}</node>"),
    "unit.dae": dae(CUBE_NODE).replace(b'meter="0.1"', b'meter="-1"'),
    "count.dae": dae(CUBE_NODE).replace(b'count="8"', b'count="4294967296"'),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_files_are_refused_by_name(name: str, tmp_path: Path) -> None:
    path = written(tmp_path, name, HOSTILE[name])
    before = time.perf_counter()
    with pytest.raises(ModelError, match=name.split(".")[0]) as caught:
        meshes.read(path)
    assert time.perf_counter() - before < 10
    assert len(str(caught.value)) < 400


def test_what_is_no_regular_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "folder.stl").mkdir()
    with pytest.raises(ModelError, match=r"folder\.stl.*directory"):
        meshes.read(tmp_path / "folder.stl")
    with pytest.raises(ModelError, match=r"absent\.obj"):
        meshes.read(tmp_path / "absent.obj")
    with pytest.raises(ModelError, match=r"\.glb.*STL, OBJ and DAE"):
        meshes.read(written(tmp_path, "robot.glb", b"glTF"))


def test_too_many_triangles_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(part_module, "MOST_TRIANGLES", 11)
    for name, content in CUBES.items():
        with pytest.raises(ModelError, match="12 triangles"):
            meshes.read(written(tmp_path, name, content))
    monkeypatch.setattr(meshes, "LARGEST_FILE", 100)
    with pytest.raises(ModelError, match="at most"):
        meshes.read(written(tmp_path, "large.stl", CUBES["binary.stl"]))


def test_files_without_triangles_have_no_parts(tmp_path: Path) -> None:
    flat = binary_stl([(0, 0, 1)], CORNERS)
    for name, content in (("empty.obj", b""), ("flat.stl", flat), ("empty.dae", dae(""))):
        assert meshes.read(written(tmp_path, name, content)) == []


def sphere(n: int, color: tuple[float, float, float] | None = None) -> meshes.Part:
    """A unit sphere of 4 n (n - 1) triangles, closed, with poles that are vertices."""
    polar, around = np.meshgrid(np.linspace(0, np.pi, n + 1), np.arange(2 * n) * np.pi / n)
    points = np.stack(
        [np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar)], axis=-1
    )
    points[:, 0], points[:, -1] = (0, 0, 1), (0, 0, -1)
    k, i = (grid.ravel() for grid in np.meshgrid(np.arange(2 * n), np.arange(n)))
    here, there = k * (n + 1) + i, (k + 1) % (2 * n) * (n + 1) + i
    rows = np.concatenate(
        [np.stack([here, here + 1, there + 1], 1), np.stack([here, there + 1, there], 1)]
    )
    return part_module.merged(points.reshape(-1, 3), rows, color)


@pytest.mark.parametrize("share", [0.5, 0.25, 0.05])
def test_a_reduced_sphere_stays_a_sphere(share: float) -> None:
    part = sphere(80, (1, 0, 0))
    most = int(share * len(part.triangles))
    small = meshes.reduced(part, most)
    assert 0.8 * most < len(small.triangles) <= most
    assert small.color == part.color
    assert len(np.unique(small.triangles)) == len(small.vertices)
    # chords of the triangles that are left, 4 pi over their number each
    sagitta = 4 * np.pi / most
    radii = np.linalg.norm(small.vertices, axis=1)
    assert np.all(np.abs(radii - 1) < sagitta)
    assert volume(small) == pytest.approx(4 / 3 * np.pi, rel=2 * sagitta)


def test_a_reduced_cube_keeps_edges_and_corners() -> None:
    """Faces of 20 x 20 squares come down to few triangles of exactly the same cube."""
    n = 20
    steps = np.linspace(-1, 1, n + 1)
    s, t = (grid.ravel() for grid in np.meshgrid(steps, steps, indexing="ij"))
    i, j = (grid.ravel() for grid in np.meshgrid(np.arange(n), np.arange(n), indexing="ij"))
    k = i * (n + 1) + j
    square = np.concatenate(
        [np.stack([k, k + n + 1, k + n + 2], 1), np.stack([k, k + n + 2, k + 1], 1)]
    )
    points, rows = [], []
    for axis in range(3):
        for side in (-1, 1):
            plane = np.insert(np.stack([s, t], 1), axis, side, axis=1)
            outward = side * (-1 if axis == 1 else 1)
            rows.append((square if outward > 0 else square[:, ::-1]) + len(points) * len(s))
            points.append(plane)
    part = part_module.merged(np.concatenate(points), np.concatenate(rows))
    assert volume(part) == pytest.approx(8, rel=1e-6)
    small = meshes.reduced(part, len(part.triangles) // 10)
    assert volume(small) == pytest.approx(8, rel=1e-5)
    np.testing.assert_allclose(np.abs(small.vertices).max(axis=1), 1, atol=1e-5)
    # an open sheet keeps its border
    sheet = part_module.merged(points[0], square)
    assert area(meshes.reduced(sheet, 100)) == pytest.approx(4, rel=1e-5)


def test_small_parts_stay_as_they_are_and_tiny_targets_end() -> None:
    part = sphere(10)
    assert meshes.reduced(part, 10**6) is part
    for most in (0, 1, 3):
        assert len(meshes.reduced(part, most).triangles) <= most


def test_packed_positions_are_within_half_a_step() -> None:
    part = sphere(20, (0, 1, 0))
    packed = meshes.encoded(part)
    assert packed.positions.dtype == packed.triangles.dtype == np.uint16
    unpacked = packed.low + packed.positions * (packed.size / 65535)
    np.testing.assert_allclose(unpacked, part.vertices, atol=2 / 65535 * 0.51)
    np.testing.assert_array_equal(packed.triangles, part.triangles)
    assert packed.color == part.color
    assert meshes.encoded(sphere(200)).triangles.dtype == np.uint32
    # a flat part has a box without height
    flat = part_module.merged([(0, 0, 5), (1, 0, 5), (0, 1, 5)], [(0, 1, 2)])
    assert meshes.encoded(flat).positions[:, 2].tolist() == [0, 0, 0]


def robots() -> Path:
    try:
        files = importlib.metadata.files("example-robot-data") or []
    except importlib.metadata.PackageNotFoundError:
        files = []
    for entry in files:
        if str(entry).endswith("panda_description/urdf/panda.urdf"):
            return Path(str(entry.locate())).resolve().parents[2]
    pytest.skip("example-robot-data is not installed")


def test_meshes_of_panda_have_the_published_size() -> None:
    folder = robots() / "panda_description" / "meshes"
    parts = {path.stem: meshes.read(path) for path in (folder / "visual").glob("*.dae")}
    count = sum(len(part.triangles) for group in parts.values() for part in group)
    # 134,924 triangles, of which some have no area
    assert 0.99 * 134_924 < count <= 134_924
    assert {part.color for part in parts["link0"]} >= {(1, 1, 1)}
    # what collides is close around what is seen
    for path in (folder / "collision").glob("*.stl"):
        (hull,) = meshes.read(path)
        seen = np.concatenate([part.vertices for part in parts[path.stem]])
        np.testing.assert_allclose(hull.vertices.min(0), seen.min(0), atol=0.02)
        np.testing.assert_allclose(hull.vertices.max(0), seen.max(0), atol=0.02)


def test_files_read_as_by_trimesh() -> None:
    if not all(importlib.util.find_spec(name) for name in ("trimesh", "collada")):
        pytest.skip("trimesh and pycollada are not installed")
    import trimesh

    folder = robots() / "panda_description" / "meshes"
    for path in (folder / "visual" / "link0.dae", folder / "collision" / "link5.stl"):
        mesh = trimesh.load(path, force="mesh")
        whole = part_module.merged(mesh.vertices, mesh.faces)
        parts = meshes.read(path)
        corners = np.concatenate([part.vertices for part in parts])
        np.testing.assert_allclose([corners.min(0), corners.max(0)], mesh.bounds, atol=1e-6)
        assert sum(map(area, parts)) == pytest.approx(mesh.area, rel=1e-5)
        assert sum(map(volume, parts)) == pytest.approx(volume(whole), rel=1e-5)
