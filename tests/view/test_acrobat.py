"""The acrobat of the demo: meshes as their script makes them, colors, masses."""

from __future__ import annotations

import zlib
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.view import meshes
from view import acrobat_meshes

URDF = acrobat_meshes.FOLDER.with_suffix(".urdf")
FILES = sorted(acrobat_meshes.FOLDER.glob("*.obj"))


@pytest.mark.parametrize("name", [path.stem for path in FILES])
def test_meshes_are_what_the_script_makes(name: str, tmp_path: Path) -> None:
    acrobat_meshes.make(tmp_path, name)
    (made,), (kept,) = (
        meshes.read(folder / f"{name}.obj") for folder in (tmp_path, acrobat_meshes.FOLDER)
    )
    assert made.triangles.shape == kept.triangles.shape
    # other machines round the fourth digit otherwise
    np.testing.assert_allclose(
        np.sort(made.vertices, axis=0), np.sort(kept.vertices, axis=0), atol=3e-4
    )


def test_meshes_are_small() -> None:
    sizes = [len(zlib.compress(path.read_bytes(), 9)) for path in FILES]
    assert sum(sizes) < 150_000


def moments(*names: str) -> tuple[float, float]:
    """Volume of closed meshes [m^3] and height of their common center [m]."""
    volume = moment = 0.0
    for name in names:
        (part,) = meshes.read(acrobat_meshes.FOLDER / f"{name}.obj")
        a, b, c = np.moveaxis(part.vertices[part.triangles].astype(float), 1, 0)
        volumes = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6
        volume += volumes.sum()
        moment += volumes @ (a + b + c)[:, 2] / 4
    return volume, moment / volume


def test_legs_have_the_masses_of_the_model_at_the_density_of_water() -> None:
    scene = cd.load(URDF)
    for body, names in (("left_thigh", ["thigh"]), ("left_shin", ["shin", "foot"])):
        volume, height = moments(*names)
        assert 1000 * volume == pytest.approx(scene.bodies[body].mass, rel=0.15)
        assert height == pytest.approx(scene.bodies[body].com[2], abs=0.03)


def test_every_mesh_is_shown_in_its_color_from_the_package() -> None:
    scene = cd.load(URDF)
    assert not [note for note in scene.notes if "mesh" in note]
    rows = cd.compile(scene).manifest.shapes
    assert {row.file for row in rows if row.kind == "mesh"} == {
        str(path.resolve()) for path in FILES
    }
    assert all(row.color is not None for row in rows)
    assert len({tuple(row.color or ()) for row in rows}) == 8
