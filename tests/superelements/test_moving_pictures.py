"""Superelements in motion: what is drawn of them, and their stress, by independent NumPy."""

from __future__ import annotations

import dataclasses
import hashlib
import json
import pickle
import re
import shutil
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.number_file import packed, unpacked
from cardan.schema.fields import Misfit
from cardan.schema.seal import sealed, unsealed
from cardan.superelements import moving_surface as surfaces
from cardan.superelements.moving_surface import FILE, surface_of_arrays
from solids.meshes import block
from superelements.corotational import Corotational
from superelements.moving import free, soft_brick, state_of
from superelements.moving import reference as by_numpy
from superelements.rotations import exponential, rotation
from table import each
from view.unpacked import data_of

RUBBER = cd.material(E=5e6, nu=0.4, rho=1100)
SIZE = (0.4, 0.05, 0.02)


@cache
def link(stressed: bool = True) -> Any:
    """A soft bar of solids with stress at its nodes, both ends interfaces."""
    mesh = block("hex8", (6, 2, 2), SIZE)
    x = mesh.points[:, 0]
    ends = {"root": np.flatnonzero(x < 1e-9), "tip": np.flatnonzero(x > SIZE[0] - 1e-9)}
    stress = {"stress": range(0, len(mesh.points), 2)} if stressed else {}
    return cd.superelement.from_mesh(mesh, RUBBER, ends, modes=3, **stress)


@cache
def arm(frame: str = "root", stressed: bool = True) -> Any:
    """A hinge, the bar, and a load at its tip."""
    scene = cd.Scene("arm")
    hub = scene.body("hub", mass=1.0, inertia=(0.01, 0.01, 0.01))
    scene.joint("base", cd.Revolute("y"), scene.ground, hub)
    bar = scene.superelement("link", link(stressed), {"root": hub.at(0.05, 0, 0)}, frame=frame)
    load = scene.body("load", mass=0.02, inertia=(1e-5, 1e-5, 1e-5))
    scene.joint("wrist", cd.Fixed(), bar.at("tip"), load)
    return cd.compile(scene)


@cache
def swing(frame: str = "root", stressed: bool = True) -> Any:
    return arm(frame, stressed).simulate(
        np.linspace(0, 0.2, 5), u={"base": 4.0}, method="GeneralizedAlpha", rtol=1e-4
    )


def coordinates(motion: Any, record: Any, frame: str) -> np.ndarray:
    """Coordinates (nt, n) of the record, by the names of joints; those of the frame are 0."""
    z = np.zeros((len(motion), record.n))
    for k, label in enumerate(record.labels):
        name, _, last = label.partition(".")
        if name != frame:
            q = f"link.{label}" if last else f"link.{label.replace(' ', '')}"
            z[:, k] = motion[q]
    return z


def places(motion: Any, record: Any, frame: str) -> np.ndarray:
    """Positions x0 + R0 (X + Psi z) of points of the surface (nt, points, 3)."""
    moved = record.surface_displacements(coordinates(motion, record, frame))
    pose = motion.pose("link.axes")
    local = record.surface_points + moved
    return np.einsum("tij,tpj->tpi", pose[:, :3, :3], local) + pose[:, None, :3, 3]


@pytest.fixture(autouse=True)
def _in_a_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


@each("frame", ["root", "tip", "mean", "chord"])
def test_points_are_those_of_the_reference_at_any_state(frame: str) -> None:
    """Axes and coordinates by the NumPy reference, which takes frames from nodes alone."""
    model, element, record = free(frame), by_numpy(frame), soft_brick()
    rng = np.random.default_rng(7)
    q = element.start(exponential(rng.normal(size=3)), rng.normal(size=3))
    q = element.moved(q, 0.05 * rng.normal(size=element.n_speeds))
    place, _ = state_of(model, frame, q, np.zeros(element.n_speeds))
    p0, x0, shift, turn = element.frame(q)
    eta = element.split(q)[2]
    z = np.concatenate([*(np.concatenate(both) for both in zip(shift, turn, strict=True)), eta])
    local = record.surface_points + record.surface_displacements(z)
    exact = local @ rotation(p0).T + x0
    found = model.superelement("boom", place)
    np.testing.assert_allclose(found.positions, exact, atol=1e-12)
    assert np.abs(found.displacements).max() > 0.02
    assert isinstance(element, Corotational)


@each("frame", ["root", "mean"])
def test_a_motion_has_points_and_stress(frame: str) -> None:
    motion, record = swing(frame), link()
    found = motion.superelement("link")
    assert np.abs(found.displacements).max() > 1e-3
    np.testing.assert_allclose(found.positions, places(motion, record, frame), atol=1e-13)
    # interfaces stand where their bodies do: the mean of the nodes of a rigid face
    face = np.flatnonzero(record.surface_points[:, 0] > SIZE[0] - 1e-9)
    tip = motion.pose("link.tip")[:, :3, 3]
    np.testing.assert_allclose(found.positions[:, face].mean(axis=1), tip, atol=1e-10)
    z = coordinates(motion, record, frame)
    stress = record.stresses(z).reshape(len(motion), -1, 6)
    nodes = record.surface.nodes[found.stressed]
    ids = {name.split()[0]: k for k, name in enumerate(record.stress_names[::6])}
    rows = [ids[str(one)] for one in record.dofs.ids[nodes]]
    np.testing.assert_allclose(found.stress, stress[:, rows], rtol=1e-9, atol=1e-6)
    mises = cd.superelement.mesh.von_mises(stress[:, rows])
    np.testing.assert_allclose(found.von_mises, mises, rtol=1e-9, atol=1e-6)
    np.testing.assert_allclose(found.largest_stress, mises.max(axis=1), rtol=1e-9, atol=1e-6)
    last = motion.model.superelement("link", motion.q[-1])
    np.testing.assert_allclose(last.positions, found.positions[-1], atol=1e-15)
    assert "displacements up to" in repr(last)
    assert "stress up to" in repr(last)


@each("frame", ["root", "mean"])
def test_pages_have_the_points_and_the_colors(frame: str) -> None:
    motion, record = swing(frame), link()
    exact = places(motion, record, frame)
    largest = motion.superelement("link").largest_stress.max()
    for show, kind in ((None, "stress"), ("displacement", "displacement")):
        data = data_of(motion.animate("arm.html", show=show).html)
        (one,) = data["surfaces"]
        assert (one["name"], one["kind"], data["scale"]["kind"]) == ("link", kind, kind)
        shapes = one["shapes"].reshape(len(one["shapes"]), -1, 3)
        local = one["points"] + np.tensordot(one["amplitudes"], shapes, 1)
        x, y, z, w = one["places"][:, 3:].T
        turn = np.array([w, x, y, z]).T
        turn /= np.linalg.norm(turn, axis=1, keepdims=True)
        for i in range(len(exact)):
            placed = local[i] @ rotation(turn[i]).T + one["places"][i, :3]
            np.testing.assert_allclose(placed, exact[i], atol=3e-5)
        if kind == "stress":
            assert data["scale"]["most"] == pytest.approx(largest, rel=1e-12)
            stresses = one["stresses"].reshape(len(shapes), -1, 6)
            mises = cd.superelement.mesh.von_mises(np.tensordot(one["amplitudes"], stresses, 1))
            np.testing.assert_allclose(
                mises, motion.superelement("link").von_mises, atol=2e-4 * largest
            )
            assert data["scale"]["name"] == "von Mises stress"
        else:
            moved = np.linalg.norm(motion.superelement("link").displacements, axis=-1)
            assert data["scale"]["most"] == pytest.approx(moved.max(), rel=1e-12)
            found = np.linalg.norm(local - one["points"], axis=-1)
            np.testing.assert_allclose(found, moved, atol=2e-4 * moved.max())


def test_bodies_without_mass_are_not_drawn() -> None:
    data = data_of(swing().animate("arm.html").html)
    assert [body["name"] for body in data["bodies"]] == [
        "hub",
        "link.tip",
    ]  # the load is fixed there
    # the hub has an arm to the interface, and none to where the tip would be
    hub = next(body for body in data["bodies"] if body["name"] == "hub")
    ends = [np.linalg.norm(one["b"]) for one in hub["solids"] if "b" in one]
    assert max(ends) == pytest.approx(0.05)
    followed = data_of(swing("mean").animate("arm.html", follow="link.axes").html)
    assert followed["follow"] == 2  # the superelement, counted behind two bodies
    assert data_of(swing().animate("arm.html", follow="link").html)["follow"] == 2
    with pytest.raises(cd.ArgumentError, match=r"there is no such body\. .*Did you mean 'link'"):
        swing().animate("arm.html", follow="lnk")


def test_colors_that_there_are_not() -> None:
    plain = swing(stressed=False)
    assert data_of(plain.animate("a.html").html)["scale"]["kind"] == "displacement"
    with pytest.raises(cd.ModelError, match="no beams and no superelements with stress"):
        plain.animate("a.html", show="stress")
    with pytest.raises(cd.ModelError, match="no beams to color"):
        plain.animate("a.html", show="strain")
    with pytest.raises(cd.ModelError, match="Reduce its mesh with stress="):
        _ = plain.superelement("link").stress
    with pytest.raises(cd.ModelError, match=r"no superelement 'lnk'\. .*Did you mean 'link'"):
        plain.superelement("lnk")
    with pytest.raises(cd.ArgumentError, match=r"q has shape \(3,\)"):
        arm().superelement("link", np.zeros(3))


def test_equilibria_paths_modes_and_the_plain_page() -> None:
    model = arm()
    rest = model.equilibrium(q={"base": 1.2})
    page = data_of(rest.animate("rest.html").html)
    assert page["surfaces"][0]["places"].shape == (1, 7)
    assert page["scale"]["kind"] == "stress"
    shaken = data_of(model.modes(x=rest).animate(0, "mode.html").html)
    assert "stress" not in shaken["layers"]
    amplitudes = shaken["surfaces"][0]["amplitudes"]
    assert np.ptp(amplitudes, axis=0).max() > 0.1
    text = swing().animate("plain.html", page="plain").html
    edges = json.loads(re.search(r"\n?(\{\"t\":.*?\})</script>", text, re.S)[1])["beams"]  # type: ignore[index]
    exact = places(swing(), link(), "root")
    assert len(edges) > 12
    for edge in edges[:4]:
        for row, ends in enumerate(np.reshape(edge["path"], (-1, 2, 3))):
            for end in ends:
                assert np.linalg.norm(exact[row] - end, axis=1).min() < 1e-4


@pytest.mark.parametrize("ending", ["nc", "npz"])
def test_a_saved_motion_draws_the_same(ending: str) -> None:
    for motion in (swing(), swing("mean"), swing(stressed=False)):
        motion.save(f"run.{ending}")
        again = cd.load_motion(f"run.{ending}")
        again.save(f"again.{ending}")
        copies = [again, cd.load_motion(f"again.{ending}"), pickle.loads(pickle.dumps(again))]
        show = "displacement" if not len(motion.superelement("link").stressed) else "stress"
        expected = data_of(motion.animate("a.html", show=show).html)["surfaces"]
        for copy in copies:
            assert copy.model is None
            found = data_of(copy.animate("b.html", show=show).html)["surfaces"]
            for name, values in expected[0].items():
                np.testing.assert_array_equal(found[0][name], values, err_msg=name)
            one, other = copy.superelement("link"), motion.superelement("link")
            np.testing.assert_array_equal(one.positions, other.positions)
            np.testing.assert_array_equal(one.stressed, other.stressed)
        assert not [name for name in again.scene if name.startswith("pose")]


def test_large_surfaces_are_coarsened(monkeypatch: pytest.MonkeyPatch) -> None:
    record, rows = link(), tuple(range(6, link().n))
    monkeypatch.setattr(surfaces, "MOST_NUMBERS", 1)
    surfaces.moving_surface.cache_clear()
    few = surfaces.moving_surface(record, rows)
    assert 8 <= len(few.points) <= 100 < len(record.surface_points) + 60
    again = surface_of_arrays(few.arrays(), len(rows))
    # points that stay are points of the component, and move as they do
    chosen = [int(np.argmin(np.linalg.norm(record.surface_points - x, axis=1))) for x in few.points]
    np.testing.assert_array_equal(again.points, record.surface_points[chosen])
    shapes = record.surface_basis[chosen][..., 6:].transpose(2, 0, 1)
    np.testing.assert_array_equal(again.shapes, shapes)
    surfaces.moving_surface.cache_clear()


HOSTILE: list[tuple[str, Any, str]] = [
    ("triangles", lambda x: np.where(x == x.max(), 10**6, x), "'triangles'.*points that do not"),
    ("triangles", lambda x: x - 1, "points that do not exist"),
    ("triangles", lambda x: x + 0.5, "'triangles' of its surface names"),
    ("triangles", lambda x: x[:, :2], r"'triangles' of its surface has shape"),
    ("triangles", lambda x: np.zeros((300_000, 3)), "has shape"),
    ("points", lambda x: np.where(x == x.max(), np.nan, x), "'points'.*entries that are not numb"),
    ("points", lambda x: 1e200 * np.ones_like(x), "entries that are not numbers"),
    ("points", lambda x: np.vstack([x, x]), "'shapes' of its surface has shape"),
    ("points", lambda x: x.astype(str), "entries that are not numbers"),
    ("shapes", lambda x: x[:-1], "'shapes' of its surface has shape"),
    ("shapes", lambda x: np.where(x == x.max(), np.inf, x), "entries that are not numbers"),
    ("stressed", lambda x: x * 0, "two stresses at one point"),
    ("stresses", lambda x: x[:, 1:], "'stresses' of its surface has shape"),
    ("stresses", lambda x: x * np.nan, "entries that are not numbers"),
]


@each("name, change, message", HOSTILE)
def test_hostile_surfaces_are_refused(name: str, change: Any, message: str) -> None:
    surface = surfaces.moving_surface(link(), tuple(range(6, link().n)))
    arrays = dict(surface.arrays())
    arrays[name] = change(arrays[name])
    with pytest.raises(ValueError, match=message):
        surface_of_arrays(arrays, link().n - 6)


def test_hostile_files_of_models_and_runs_are_refused(tmp_path: Path) -> None:
    good = tmp_path / "good"
    shutil.copytree(arm().directory, good)
    assert cd.CompiledModel(good).superelement("link", np.zeros(arm().nq)).stress.shape[1] == 6
    arrays = unpacked((good / FILE).read_bytes())
    assert packed(arrays) == (good / FILE).read_bytes()
    for name, values, message in (
        ("surface_triangles_0", arrays["surface_triangles_0"] + 999, "points that do not exist"),
        ("surface_points_0", np.nan * arrays["surface_points_0"], "not numbers"),
        ("surface_shapes_0", arrays["surface_shapes_0"][1:], "has shape"),
    ):
        folder = tmp_path / name
        shutil.copytree(good, folder)
        content = packed({**arrays, name: values})
        (folder / FILE).write_bytes(content)
        with pytest.raises(cd.ModelError, match="not the file its manifest speaks of"):
            cd.CompiledModel(folder).superelement("link", np.zeros(arm().nq))
        manifest = folder / "manifest.json"
        parts = {**unsealed(manifest.read_bytes())}
        parts["sha256"][FILE] = hashlib.sha256(content).hexdigest()
        manifest.write_text(sealed(parts), "utf-8")
        with pytest.raises(cd.ModelError, match=message):
            cd.CompiledModel(folder).superelement("link", np.zeros(arm().nq))
    (good / FILE).unlink()
    with pytest.raises(cd.ModelError, match="Compile the model again"):
        cd.CompiledModel(good).superelement("link", np.zeros(arm().nq))


@each("name, change, message", HOSTILE)
def test_hostile_surfaces_in_files_of_runs_are_refused(
    name: str, change: Any, message: str
) -> None:
    swing().save("good.npz")
    run = cd.load_motion("good.npz")
    key = f"surface_{name}_0"
    values = change(run.numbers[key])
    if values.dtype.kind == "U":
        return  # texts are no numbers of a run
    dataclasses.replace(run, numbers={**run.numbers, key: values}).save("forged.npz")
    with pytest.raises(cd.ModelError, match=message):
        cd.load_motion("forged.npz")


def test_manifests_with_superelements_that_are_nowhere() -> None:
    row = arm().manifest.superelements[0]
    for change in ({"frame": "nowhere"}, {"q": [*row.q, 10**6]}):
        with pytest.raises(Misfit, match="superelement 'link' is nowhere"):
            arm().manifest.replaced(superelements=[row.replaced(**change)]).fit(False)


def test_equations_count_the_operations_of_superelements() -> None:
    scene = cd.Scene("flying")
    bar = scene.superelement("bar", link())
    scene.joint("free", cd.Free(), scene.ground, bar.at("root"))
    counts = cd.derive(scene).operations["superelement__balance"]
    n = 6 + 6 + 3
    assert (counts["mul"], counts["add"]) == (17 * n * n, 17 * n * n)
    assert counts.total == counts.blocks["superelement"]["mul"] * 2
