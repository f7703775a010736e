"""Runs of files say the same as the runs that were saved, or say what they lack."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from mechanisms import flexible
from view.unpacked import data_of


def scene() -> cd.Scene:
    """A pendulum at a driven pivot, with a spring whose stiffness is a parameter."""
    scene = cd.Scene("swing", gravity=(0, 0, -9.81))
    k = scene.parameter("k", 50.0, unit="N/m")
    cart = scene.body("cart", mass=1.0)
    bob = scene.body("bob", mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.1))
    scene.joint("drive", cd.Prismatic("x"), scene.ground, cart, prescribed=0.1 * cd.t**2)
    scene.joint("pivot", cd.Revolute("y"), cart, bob)
    spring = cd.SpringDamper(bob.at(0, 0, -1), scene.ground.at(1, 0, -1), stiffness=k)
    scene.force("spring", spring)
    scene.output("height", bob.at(0, 0, -1).position()[2], unit="m")
    return scene


NAMES = ("pivot", "pivot.u", "height", "spring.force", "drive.driving_force")


@pytest.fixture(scope="module")
def model() -> cd.CompiledModel:
    return cd.compile(scene())


@pytest.fixture(scope="module")
def motion(model: cd.CompiledModel) -> cd.Trajectory:
    return model.simulate(1.0, q={"pivot": 0.5}, parameters={"k": 20.0})


@pytest.mark.parametrize("ending", [".nc", ".npz"])
def test_the_parameters_of_a_run_are_those_it_had(
    model: cd.CompiledModel, motion: cd.Trajectory, tmp_path: Path, ending: str
) -> None:
    """Forces of a run with k = 20 were those of the model's own k = 50."""
    same = model.with_parameters({"k": 20.0}).simulate(1.0, q={"pivot": 0.5})
    np.testing.assert_array_equal(motion.x, same.x)
    path = motion.save(tmp_path / f"run{ending}")
    for again in (cd.load_motion(path, model), cd.load_motion(path)):
        for name in NAMES:
            np.testing.assert_array_equal(again[name], motion[name])
    loaded = cd.load_motion(path, model)
    np.testing.assert_array_equal(loaded["pivot.force"], motion["pivot.force"])
    assert loaded.model is not None
    assert loaded.model.parameters["k"] == 20.0
    assert model.parameters["k"] == 50.0
    # and once more, from a run without its model
    again = cd.load_motion(cd.load_motion(path).save(tmp_path / f"again{ending}"), model)
    np.testing.assert_array_equal(again["spring.force"], motion["spring.force"])


def test_a_model_with_other_parameters_is_refused(motion: cd.Trajectory, tmp_path: Path) -> None:
    path = motion.save(tmp_path / "run.nc")
    other = scene()
    other.force("push", cd.Force("bob", (other.parameter("more", 1.0), 0, 0)))
    with pytest.raises(cd.ModelError, match="run of another model: its parameters"):
        cd.load_motion(path, cd.compile(other))


def test_what_a_file_does_not_hold_is_asked_of_the_model(
    motion: cd.Trajectory, tmp_path: Path
) -> None:
    stored = cd.load_motion(motion.save(tmp_path / "run.nc"))
    with pytest.raises(cd.ModelError, match=r"reaction of 'pivot' needs the model.*load_motion"):
        stored["pivot.force"]
    with pytest.raises(cd.ModelError, match=r"spring\.force.*needs the model"):
        stored.resample([0.1, 0.2])["spring.force"]


def test_tables_have_a_name_for_every_column(motion: cd.Trajectory, tmp_path: Path) -> None:
    with motion.save(tmp_path / "run.csv").open(newline="") as file:
        rows = list(csv.reader(file))
    heads, values = rows[0], np.array(rows[1:], dtype=float)
    assert len(set(heads)) == len(heads)
    plain = [head.partition(" [")[0] for head in heads]
    for name in NAMES:
        np.testing.assert_array_equal(values[:, plain.index(name)], motion[name])
    np.testing.assert_array_equal(
        values[:, heads.index("drive.motion.work [J]")], motion.work["drive.motion"]
    )
    np.testing.assert_array_equal(
        values[:, heads.index("bob.pose.pz [m]")], motion.pose("bob")[:, 2, 3]
    )


def test_pages_of_files_have_the_energies(motion: cd.Trajectory, tmp_path: Path) -> None:
    stored = cd.load_motion(motion.save(tmp_path / "run.nc"))
    assert stored.dense is not None
    data: Any = data_of(stored.animate(tmp_path / "page.html", plots="energy").html)
    (energy,) = data["histories"]
    total = next(c for c in energy["curves"] if c["name"] == "total")["y"][:, 0]
    expected = np.interp(data["t"][:, 0], motion.t, motion.energy.total)
    np.testing.assert_allclose(total, expected, atol=2e-3 * np.abs(expected).max())
    usual: Any = data_of(stored.animate(tmp_path / "usual.html").html)
    assert "J" in [history["unit"] for history in usual["histories"]]


def test_units_of_forces_are_shown(motion: cd.Trajectory, tmp_path: Path) -> None:
    names = ["spring.force", "drive.driving_force", "pivot.moment", "pivot.u"]
    data: Any = data_of(motion.animate(tmp_path / "page.html", plots=names).html)
    found = [(history["name"], history["unit"]) for history in data["histories"]]
    assert found == [("forces", "N"), ("torques", "N*m"), ("angular speeds", "rad/s")]


def test_pages_of_beams_of_files_say_what_they_lack(tmp_path: Path) -> None:
    model = cd.compile(flexible.bend45(elements=2))
    stored = cd.load_motion(model.simulate(0.01).save(tmp_path / "beam.nc"))
    for show, said in (
        ("reactions", "reactions of joints needs the model"),
        ("stress", "stress of beam 'bend' needs the model"),
        ("strain", "strain of beam 'bend' needs the model"),
    ):
        with pytest.raises(cd.ModelError, match=said):
            stored.animate(tmp_path / "page.html", show=show)
    with pytest.raises(cd.ModelError, match="section of beam 'bend' has no Young's modulus"):
        model.simulate(0.01).animate(tmp_path / "page.html", show="stress")


def test_colors_without_beams_are_refused(motion: cd.Trajectory, tmp_path: Path) -> None:
    with pytest.raises(cd.ModelError, match="'swing' has no beams and no superelements"):
        motion.animate(tmp_path / "page.html", show="stress")
    with pytest.raises(cd.ArgumentError, match="only one of stress, strain"):
        motion.animate(tmp_path / "page.html", show=["stress", "strain"])
