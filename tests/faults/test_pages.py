"""Faults of pages: of long chains, of far, small, short and late things, of arguments."""

from __future__ import annotations

import json
import math
import os
import re
import warnings
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import cardan as cd
from cardan.view import meshes
from cardan.view.solids import bodies
from view.unpacked import data_of


def chain(count: int, length: float = 1.0) -> cd.Scene:
    """Rods that hang on each other."""
    scene = cd.Scene("chain", gravity=(0, 0, -9.81))
    rod, parent = cd.inertia.rod(1.0, length, axis="z"), scene.ground
    for k in range(count):
        body = scene.body(f"rod{k}", mass=1, com=(0, 0, -length / 2), inertia=rod)
        scene.joint(f"pin{k}", cd.Revolute("y"), parent, body)
        parent = body.at(0, 0, -length)
    return scene


def test_the_energy_of_a_long_chain_is_compiled() -> None:
    """A step with more than 128 parameters as they are looped over tables that nothing wrote."""
    motion = cd.compile(chain(140)).simulate(1e-3, q={"pin0": 1.0}, rtol=1e-3)
    assert motion.energy.potential[0] == pytest.approx(-9.81 * math.cos(1.0) * 140**2 / 2)


def test_bodies_of_a_tree_are_placed_without_c_of_every_pose(tmp_path: Path) -> None:
    """Every body had C of its own: 7 minutes for 300 of them."""
    model = cd.compile(chain(6))
    motion = model.simulate(0.5, q={"pin0": 1.0})
    motion.animate(tmp_path / "page.html")
    assert "pose" not in {name for name, _ in model._functions}
    for body in bodies(motion)[0]:
        np.testing.assert_allclose(body.poses, motion.pose(body.name), rtol=0, atol=1e-12)


def test_bodies_of_a_path_stand_by_the_parameters_of_every_row(tmp_path: Path) -> None:
    scene = cd.Scene("boom", gravity=(0, 0, -9.81))
    span = scene.parameter("l", 1.0)
    boom = scene.body("boom", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.1))
    load = scene.body("load", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.1))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, boom)
    scene.joint("pin", cd.Revolute("y"), boom.at(0, 0, -span), load)
    path = cd.compile(scene).statics(l=(1, 2))
    data = data_of(path.animate(tmp_path / "page.html").html)
    at = data["poses"].reshape(len(path.rows), -1, 7)[:, 1, :3]
    np.testing.assert_allclose(np.linalg.norm(at, axis=1), path.values["l"], rtol=1e-4)


def test_a_sweep_forth_and_back_plays(tmp_path: Path) -> None:
    """Its page ran from 0 to 0."""
    model = cd.compile(chain(1))
    there = np.linspace(0, 1, 11)
    sweep = model.sweep("pin0", np.concatenate([there, there[::-1]]))
    data = data_of(sweep.animate(tmp_path / "page.html").html)
    np.testing.assert_allclose(data["t"][:, 0], np.arange(22), atol=1e-6)
    assert data["abscissa"] == {"name": "row", "unit": ""}
    once = data_of(model.sweep("pin0", there).animate(tmp_path / "page.html").html)
    assert once["abscissa"] == {"name": "pin0", "unit": "rad"}


def test_a_satellite_turns_as_exactly_as_a_robot(tmp_path: Path) -> None:
    """Quaternions were rounded in the steps that are left of 7000 km: a degree."""
    scene = cd.Scene("satellite", gravity=(0, 0, 0))
    body = scene.body("body", mass=100, inertia=(10, 12, 15), shape=cd.shape.box(1, 1, 2))
    scene.joint("fly", cd.Free(), scene.ground, body)
    motion = cd.compile(scene).simulate(
        20.0, q={"fly": [1, 0, 0, 0, 7e6, 0, 0]}, u={"fly": [0, 0, 0.1, 0, 7500, 0]}
    )
    data = data_of(motion.animate(tmp_path / "page.html").html)
    exact = motion.resample(data["t"][:, 0]).pose("body")
    turned = Rotation.from_quat(data["poses"][:, 3:]).as_matrix()
    np.testing.assert_allclose(turned, exact[:, :3, :3], rtol=0, atol=5e-5)
    # 150 km in 28 bits, and a step of the time that the page rounds to
    np.testing.assert_allclose(data["poses"][:, :3], exact[:, :3, 3], rtol=0, atol=2e-3)


@pytest.mark.parametrize("length", [1.6e-6, 4e-7])
def test_micromechanisms_are_drawn_to_scale(length: float, tmp_path: Path) -> None:
    """Solids were rounded to a micrometer, places of the plain page to ten."""
    motion = cd.compile(chain(2, length)).simulate(1e-3, q={"pin0": 1.0})
    for page in ("3d", "plain"):
        html = motion.animate(tmp_path / "page.html", page=page).html
        data = data_of(html) if page == "3d" else _plain(html)
        assert data["bodies"][0]["solids"][0]["b"][2] == pytest.approx(-length)
    elbow = np.array([row[9:] for row in data["bodies"][1]["pose"]])
    np.testing.assert_allclose(np.linalg.norm(elbow, axis=1), length, rtol=1e-4)


def _plain(html: str) -> dict[str, object]:
    found = re.search(r'id="data">(.*?)</script>', html, re.S)
    assert found
    contents: dict[str, object] = json.loads(found[1])
    return contents


def test_short_motions_are_slow_enough_to_be_seen(tmp_path: Path) -> None:
    """20 microseconds passed in a flash: the slowest play was 0.001."""
    motion = cd.compile(chain(1)).simulate(2e-5, u={"pin0": 1e4})
    rate = data_of(motion.animate(tmp_path / "page.html").html)["rate"]
    assert 1 < 2e-5 / rate < 10


def test_outputs_without_a_number_leave_gaps(tmp_path: Path) -> None:
    """The whole page was refused, because of places that were all finite."""
    scene = chain(1)
    scene.output("root", scene.q("pin0") ** 0.5)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cd.SolveWarning)
        motion = cd.compile(scene).simulate(2.0, q={"pin0": 0.5})
        data = data_of(motion.animate(tmp_path / "page.html", plots="root").html)
    curve = data["histories"][0]["curves"][0]
    angle = motion.resample(data["t"][:, 0])["pin0"]
    there = np.setdiff1d(np.arange(len(angle)), curve["gaps"])
    assert np.all(angle[curve["gaps"]] < 1e-6)
    np.testing.assert_allclose(curve["y"][there, 0], np.sqrt(angle[there]), atol=1e-3)


def test_small_swings_about_large_values_are_no_stairs(tmp_path: Path) -> None:
    """Curves were rounded to a ten thousandth of their largest value, not of what they span."""
    motion = cd.compile(chain(1)).simulate(2.0, q={"pin0": 200 * math.pi + 0.01})
    data = data_of(motion.animate(tmp_path / "page.html", plots="pin0").html)
    exact = motion.resample(data["t"][:, 0])["pin0"]
    np.testing.assert_allclose(data["histories"][0]["curves"][0]["y"][:, 0], exact, atol=2e-6)


@pytest.mark.parametrize("fps", [0.0, -60.0])
def test_pictures_per_second_are_positive(fps: float, tmp_path: Path) -> None:
    """Two pictures were drawn, without a word."""
    motion = cd.compile(chain(1)).simulate(0.1)
    with pytest.raises(cd.ArgumentError, match=r"fps=.*such as 60"):
        motion.animate(tmp_path / "page.html", fps=fps)


def test_words_of_titles_and_bodies_that_are_followed(tmp_path: Path) -> None:
    """A name of a file that is no UTF-8 gave a UnicodeEncodeError; the ground was suggested."""
    motion = cd.compile(chain(1)).simulate(0.1)
    title = os.fsdecode(b"run \xff.urdf")
    assert "<h1>run ?.urdf</h1>" in motion.animate(tmp_path / "page.html", title=title).html
    with pytest.raises(cd.ArgumentError) as told:
        motion.animate(tmp_path / "page.html", follow="ground")
    assert (
        str(told.value)
        == "follow='ground': there is no such body. Known: rod0. Did you mean 'rod0'?"
    )


def test_links_in_a_circle_are_no_material(tmp_path: Path) -> None:
    """Before Python 3.13 they were a RuntimeError."""
    (tmp_path / "circle.mtl").symlink_to("circle.mtl")
    mesh = tmp_path / "part.obj"
    mesh.write_text("mtllib circle.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    (part,) = meshes.read(mesh)
    assert part.color is None


def test_meshes_of_the_smallest_and_largest_numbers_do_not_overflow(tmp_path: Path) -> None:
    mesh = tmp_path / "part.obj"
    mesh.write_text("v 0 0 0\nv 1e-40 0 0\nv 0 1e-40 0\nf 1 2 3\n")
    (part,) = meshes.read(mesh)
    assert meshes.encoded(part).positions.max() == meshes.STEPS
