"""Surfaces of components, and their modes as pages and pictures."""

from __future__ import annotations

import dataclasses
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan import solids as fem
from cardan.solids import reduced as from_meshes
from cardan.superelements.coarsening import coarsened
from cardan.view.superelements import BALL, LARGEST
from cardan.view.surfaces import outline
from solids.meshes import KINDS, block
from superelements.components import BAR, beam
from superelements.test_storage import forged
from table import each
from view.unpacked import data_of

STEEL = cd.material(E=210e9, nu=0.3, rho=7850)
ENDS = {"root": [11, 12, 13, 14], "tip": [51, 52, 53, 54]}


def bar(kind: str = "hex8", **options: Any) -> Any:
    """A reduced block of solids, both ends interfaces."""
    mesh = block(kind, (4, 1, 1), (0.4, 0.1, 0.1))
    x = mesh.points[:, 0]
    ends = {"a": np.flatnonzero(x < 1e-9), "b": np.flatnonzero(x > 0.4 - 1e-9)}
    return cd.superelement.from_mesh(mesh, STEEL, ends, **{"modes": 4, **options})


def satellite() -> Any:
    """Two beams at a hub, whose ends lie beside its origin."""
    scene = cd.Scene("satellite", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=300, inertia=(400, 400, 400))
    scene.joint("free", cd.Free(), scene.ground, hub)
    tube = cd.section.tube(0.03, 0.028)
    scene.beam("left", hub.at(1, 0, 0), (5, 1, 2), tube, STEEL, elements=4, base=hub)
    scene.beam("right", hub.at(-1, 0, 0), (-5, 0, 0), tube, STEEL, elements=6, base=hub)
    return cd.superelement.from_beams(
        scene, ["left", "right"], {"hub": "hub", "tip": "left.end"}, bodies=["hub"], modes=3
    )


def rigid(points: np.ndarray) -> np.ndarray:
    """Displacements (points, 3, 6) of a rigid body, by hand."""
    turns = np.stack([np.cross(axis, points) for axis in np.eye(3)], axis=2)
    return np.concatenate([np.tile(np.eye(3), (len(points), 1, 1)), turns], axis=2)


def saved(path: Path, record: Any) -> Any:
    record.save(path / "beam.npz")
    return cd.superelement.load(path / "beam.npz")


def test_every_way_to_a_component_gives_one_that_can_be_drawn(tmp_path: Path) -> None:
    scene = cd.Scene("boom", gravity=(0, 0, 0))
    scene.beam("boom", (0, 0, 0), (1, 0, 0), cd.section.tube(0.03, 0.028), STEEL, elements=4)
    records = [bar(), satellite(), beam(modes=2), scene.reduce("boom", modes=2, report=False)]
    records += [cd.superelement.read(BAR).reduce(ENDS, modes=1), saved(tmp_path, bar())]
    for record in records:
        assert isinstance(record, cd.superelement.Superelement)
        page = pickle.loads(pickle.dumps(record)).animate(1, tmp_path / "mode.html")
        assert drawn(page)[1]["name"] == "component"


@each("kind", KINDS)
def test_the_surface_of_a_mesh_is_its_outside(kind: str) -> None:
    record = bar(kind)
    points, triangles = record.surface_points, record.surface.triangles
    a, b, c = points[triangles].transpose(1, 0, 2)
    assert np.einsum("ij,ij->", a, np.cross(b, c)) / 6 == pytest.approx(4e-3)
    nodes = record.surface.nodes
    np.testing.assert_array_equal(points, record.dofs.positions[nodes])
    moved = record.displacements(np.eye(record.n)).reshape(record.n, -1, 3)
    np.testing.assert_allclose(record.surface_displacements(np.eye(record.n)), moved[:, nodes])


@each("make", [bar, satellite, beam])
def test_surfaces_follow_rigid_motions(make: Any) -> None:
    """By coordinates of rigid motions, points move as those of a rigid body do."""
    record = make()
    moved = record.surface_displacements(record.rigid_motions().T)
    exact = rigid(record.surface_points)
    # a planar component moves in its plane
    chosen = [0, 1, 5] if make is beam else range(6)
    for k in chosen:
        np.testing.assert_allclose(moved[k], exact[:, :, k], atol=1e-9)


def test_lines_of_beams_begin_where_the_beams_do() -> None:
    record = satellite()
    ends = record.surface_points[record.surface.lines]
    assert len(ends) == 10
    np.testing.assert_allclose(ends[0, 0], [1, 0, 0], atol=1e-12)
    np.testing.assert_allclose(ends[3, 1], [5, 1, 2], atol=1e-12)
    np.testing.assert_allclose(ends[4, 0], [-1, 0, 0], atol=1e-12)
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    assert lengths[:4].sum() == pytest.approx(np.sqrt(21.0))
    assert lengths[4:].sum() == pytest.approx(4.0)


def test_triangles_and_lines_may_be_given_by_numbers_of_nodes() -> None:
    matrices = cd.superelement.read(BAR)
    nodes = matrices.reduce(ENDS, modes=1)
    assert len(nodes.surface_points) == 20
    drawn = matrices.reduce(ENDS, modes=1, lines=[[11, 21], [21, 31]], triangles=[[11, 12, 13]])
    ids = drawn.dofs.ids[drawn.surface.nodes]
    assert ids.tolist() == [11, 12, 13, 21, 31]
    assert ids[drawn.surface.lines].tolist() == [[11, 21], [21, 31]]
    for values, message in (
        ({"lines": [[11, 99]]}, "lines: there is no node 99"),
        ({"lines": [11, 12]}, r"lines=.*shape \(2,\); give node numbers \(lines, 2\)"),
        ({"triangles": [[11, 12]]}, r"triangles=.*\(triangles, 3\)"),
        ({"triangles": [[11, 12, 12.5]]}, r"triangles=.*give node numbers"),
        ({"triangles": [[11, 12, np.nan]]}, r"triangles=.*give node numbers"),
        ({"lines": "left"}, "lines='left': give"),
        ({"lines": np.full((200_001, 2), 11)}, "at most 200000 are drawn"),
    ):
        with pytest.raises((cd.ModelError, cd.ArgumentError, cd.SolveError), match=message):
            matrices.reduce(ENDS, modes=1, **values)


def test_large_meshes_are_coarsened_to_some_of_their_nodes(monkeypatch: Any) -> None:
    fine = block("hex8", (12, 12, 12))
    rows = coarsened(fine.points, fine.triangles, 400)
    assert 150 < len(rows) <= 400
    a, b, c = fine.points[rows].transpose(1, 0, 2)
    # corners are cut, by less than the edge of a cell
    assert np.einsum("ij,ij->", a, np.cross(b, c)) / 6 == pytest.approx(1.0, abs=0.15)
    monkeypatch.setattr(from_meshes, "MOST_TRIANGLES", 30)
    record = bar("hex20")
    assert 8 <= len(record.surface.triangles) <= 30
    assert len(record.surface.nodes) < len(record.dofs.positions)


def test_surfaces_are_saved_and_those_of_version_1_are_all_nodes(tmp_path: Path) -> None:
    for record in (bar(), satellite()):
        again = saved(tmp_path, record)
        for field in dataclasses.fields(record.surface):
            np.testing.assert_array_equal(
                getattr(again.surface, field.name), getattr(record.surface, field.name)
            )

    def older(arrays: dict[str, Any], about: dict[str, Any]) -> None:
        about["superelement"] = 1
        for name in ("nodes", "arms", "triangles", "lines"):
            del arrays[f"surface_{name}"]

    record = cd.superelement.load(forged(tmp_path, older))
    assert len(record.surface.nodes) == len(record.dofs.positions)
    assert not len(record.surface.lines)


@each(
    "name, value",
    [
        ("surface_nodes", [10**6]),
        ("surface_triangles", [[0, 1, -1]]),
        ("surface_triangles", [[0, 1, 10**6]]),
        ("surface_triangles", [[0.0, 1.0, 2.0]]),
        ("surface_lines", [[0, 1, 2]]),
        ("surface_lines", np.zeros((200_001, 2), int)),
        ("surface_arms", [[0.0, 0.0, np.nan]]),
    ],
)
def test_forged_surfaces_are_refused(tmp_path: Path, name: str, value: Any) -> None:
    saved(tmp_path, bar())
    file = forged(tmp_path, lambda arrays, about: arrays.update({name: np.array(value)}))
    with pytest.raises(cd.ModelError, match=r"is not a superelement of cardan.*'surface"):
        cd.superelement.load(file)


def drawn(page: Any) -> tuple[Any, Any]:
    """Data of a page, and its only surface."""
    data = data_of(page.html)
    return data, data["surfaces"][0]


def test_a_page_has_the_shape_of_the_mode(tmp_path: Path) -> None:
    record = bar()
    data, surface = drawn(record.animate(2, tmp_path / "mode.html"))
    modes = record.modes(["a", "b"])
    exact = modes.displacements[:, 1].reshape(-1, 3)
    moved = surface["shapes"].reshape(-1, 3) * surface["amplitudes"].max()
    factor = (moved * exact).sum() / (exact**2).sum()
    points = surface["points"].reshape(-1, 3)
    # rounded to 1e-5 of the size of the bar
    np.testing.assert_allclose(points, record.surface_points, atol=4e-6)
    np.testing.assert_allclose(moved, exact * factor, atol=1e-6)
    largest = np.linalg.norm(exact, axis=1).max() * factor
    assert largest == pytest.approx(LARGEST * 0.4, rel=1e-3)
    assert data["scale"]["most"] == pytest.approx(largest, rel=1e-3)
    assert (data["scale"]["kind"], data["scale"]["unit"]) == ("displacement", "mm")
    # one period, as slow as one can follow
    period = 2 * np.pi / modes.frequencies[1]
    assert data["t"][-1, 0] == pytest.approx(period, rel=1e-6)
    assert 0.4 < period / data["rate"] < 2.0
    assert data["name"] == f"mode 2, all interfaces fixed, {modes.frequencies[1]:.6g} rad/s"
    assert [body["name"] for body in data["bodies"]] == ["a", "b"]
    assert data["bodies"][0]["solids"][0]["r"] == pytest.approx(BALL * 0.4)


def test_static_shapes_and_free_modes(tmp_path: Path) -> None:
    record = bar()
    data, surface = drawn(
        record.animate("b.rx", tmp_path / "m.html", which="static", scale=0.1, color=None)
    )
    assert data["name"] == "static shape by 1 rad of b.rx"
    assert data["scale"] is None
    # the end turns rigidly by 0.1 rad about the x axis through its middle
    end = abs(record.surface_points[:, 0] - 0.4) < 1e-9
    arm = record.surface_points[end] - [0.4, 0.05, 0.05]
    moved = surface["shapes"].reshape(-1, 3)[end] * surface["amplitudes"].max()
    np.testing.assert_allclose(moved, 0.1 * np.cross([1.0, 0, 0], arm), atol=8e-6)
    # its mark turns with it
    row = int(np.argmax(surface["amplitudes"][:, 0]))
    x, y, z, w = data["poses"][row].reshape(-1, 7)[1, 3:]
    assert 2 * np.arctan2(abs(x), abs(w)) == pytest.approx(0.1, rel=1e-3)
    assert abs(y) + abs(z) < 1e-4
    free = record.modes()
    data, surface = drawn(record.animate(1, tmp_path / "m.html", which="free"))
    assert data["name"] == f"mode 1, all interfaces free, {free.frequencies[0]:.6g} rad/s"
    clamped = record.modes(["a"])
    data, surface = drawn(record.animate(1, tmp_path / "m.html", locked=["a"]))
    assert data["name"] == f"mode 1, a fixed, {clamped.frequencies[0]:.6g} rad/s"
    third = record.animate(3, tmp_path / "m.html", which="static")
    assert drawn(third)[0]["name"] == "static shape by 1 m of a.z"


def test_stress_colors_the_nodes_that_have_it(tmp_path: Path) -> None:
    record = bar("hex20", stress=np.arange(12))
    shape = record.modes(["a", "b"]).shapes[:, 0]
    data, surface = drawn(
        record.animate(1, tmp_path / "m.html", color="stress", scale=1e-3, title="Bar <1>")
    )
    exact = fem.von_mises(1e-3 * record.stresses(shape).reshape(-1, 6))
    known = surface["stressed"].ravel().astype(int)
    np.testing.assert_array_equal(record.surface.nodes[known], np.arange(12))
    stress = surface["stresses"].reshape(-1, 6) * surface["amplitudes"].max()
    np.testing.assert_allclose(fem.von_mises(stress), exact, atol=1e-3 * exact.max())
    assert data["scale"]["most"] == pytest.approx(exact.max(), rel=1e-3)
    assert data["scale"]["kind"] == "stress"
    with pytest.raises(cd.ModelError, match=r"has no stress at nodes that are drawn.*stress="):
        bar().animate(1, tmp_path / "m.html", color="stress")
    named = beam(modes=2, stress=np.eye(2, 51), stress_names=["0 xx", "pipe xx"])
    with pytest.raises(cd.ModelError, match="has no stress at nodes"):
        named.plot(color="stress")


def test_a_picture_has_the_colors_of_the_shape(tmp_path: Path) -> None:
    viridis = pytest.importorskip("matplotlib").colormaps["viridis"]
    record = bar("tet10", stress=np.arange(40))
    for options in ({}, {"which": "free", "color": "stress"}, {"which": "static", "color": None}):
        figure = record.plot(1, tmp_path / "mode.png", **options)
        assert (tmp_path / "mode.png").stat().st_size > 10_000
        faces = figure.axes[0].collections[0]
        assert len(faces.get_facecolor()) == len(record.surface.triangles)
    figure = record.plot(1)
    shape = record.surface_displacements(record.modes(["a", "b"]).shapes[:, 0])
    assert figure.axes[1].get_ylabel() == "displacement [m]"
    assert figure.axes[1].get_ylim()[1] == pytest.approx(LARGEST * 0.4)
    # green rises with the value; triangles are sorted by their distance
    size = np.linalg.norm(shape, axis=1)[record.surface.triangles].mean(axis=1)
    greens = np.sort(figure.axes[0].collections[0].get_facecolor()[:, 1])
    largest = np.linalg.norm(shape, axis=1).max()
    np.testing.assert_allclose(greens, np.sort(viridis(size / largest)[:, 1]), atol=1e-9)
    for other in (beam(modes=2), satellite()):
        assert other.plot(1, which="free").axes[0].collections


def test_edges_of_the_undeformed_surface_are_those_of_a_block() -> None:
    mesh = block("hex8", (4, 2, 2), (0.4, 0.1, 0.1))
    edges = outline(mesh.points, mesh.triangles)
    lengths = np.linalg.norm(np.diff(mesh.points[edges], axis=1)[:, 0], axis=1)
    assert lengths.sum() == pytest.approx(4 * (0.4 + 0.1 + 0.1))
    # a triangle alone has three
    assert len(outline(mesh.points, mesh.triangles[:1])) == 3


@each(
    "arguments, message",
    [
        ({"mode": 0}, "mode=0: the component has 4 modes; give a number from 1 to 4"),
        ({"mode": 5}, "mode=5: the component has 4 modes"),
        ({"mode": "a.x"}, "mode='a.x': the component has 4 modes"),
        ({"mode": 13, "which": "static"}, "the component has 12 static shapes"),
        ({"mode": "a.q", "which": "static"}, "there is no static shape 'a.q'"),
        ({"mode": True}, "mode"),
        ({"mode": 1.5}, "mode"),
        ({"which": "all"}, "which='all': there are no such shapes.*fixed"),
        ({"locked": ["c"]}, "there is no interface 'c'"),
        ({"locked": ["a"], "which": "free"}, "locked=.* of which='fixed' only"),
        ({"color": "strain"}, "color='strain': there is no such color.*stress"),
        ({"scale": float("nan")}, "scale"),
        ({"scale": 1e300}, "scale"),
    ],
)
def test_what_cannot_be_drawn_is_refused(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises((cd.ModelError, cd.ArgumentError, cd.SolveError), match=message):
        bar().plot(**arguments)


def test_a_component_without_modes_shows_its_static_shapes(tmp_path: Path) -> None:
    record = bar(method="guyan", modes=None)
    with pytest.raises(cd.ModelError, match="'guyan' left no mode; which='static'"):
        record.plot(1)
    assert record.animate(1, tmp_path / "m.html", which="static").path
