"""Poses of beam sections against closed forms: twist, bending, rigid rotation, a curved line."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import cardan as cd

Array = NDArray[np.float64]
SHAFT = cd.section.general(EA=1e4, GA=1e4, GJ=2.0, EI=3.0, rhoA=1, rhoI=1e-2)


def shaft(torque: float, **options: object) -> cd.Scene:
    """A clamped shaft of length 1.5 along x with a moment along it at the end."""
    scene = cd.Scene("shaft", gravity=(0, 0, 0))
    beam = scene.beam("shaft", scene.ground, (1.5, 0, 0), SHAFT, elements=6, **options)
    scene.force("twist", cd.Torque(beam.end, (torque, 0, 0)))
    return scene


def about(axis: str, angles: Array) -> Array:
    """Rotations (n, 3, 3) about an axis of the ground."""
    k = "xyz".index(axis)
    i, j = (k + 1) % 3, (k + 2) % 3
    R = np.zeros((len(angles), 3, 3))
    R[:, k, k] = 1
    R[:, i, i] = R[:, j, j] = np.cos(angles)
    R[:, j, i], R[:, i, j] = np.sin(angles), -np.sin(angles)
    return R


def test_a_twisted_shaft_turns_by_torque_times_length_over_stiffness(tmp_path: Path) -> None:
    model = cd.compile(shaft(0.4, up=(0, 1, 1)))
    rest = model.equilibrium()
    s = np.linspace(0, 1.5, 7)
    # e3 begins along up, e2 = e3 x e1
    first = np.array([[1, 0, 0], [0, np.sqrt(0.5), np.sqrt(0.5)], [0, -np.sqrt(0.5), np.sqrt(0.5)]])
    expected = about("x", 0.4 * s / 2.0) @ first
    at_rest = rest.sections("shaft")
    assert at_rest.shape == (7, 4, 4)
    np.testing.assert_allclose(at_rest[:, :3, :3], expected, atol=1e-9)
    np.testing.assert_allclose(at_rest[:, :3, 3], np.outer(s, [1, 0, 0]), atol=1e-9)
    np.testing.assert_array_equal(at_rest[:, 3], np.tile([0, 0, 0, 1], (7, 1)))
    # at rest it stays, in the run, resampled, and in what a file says of it without the model
    motion = model.simulate(0.02, x0=rest, step=5e-3)
    sections = motion.sections("shaft")
    assert sections.shape == (len(motion), 7, 4, 4)
    np.testing.assert_allclose(
        sections[:, :, :3, :3], expected[None] + 0 * sections[:, :, :3, :3], atol=1e-8
    )
    np.testing.assert_array_equal(motion.line("shaft"), sections[..., :3, 3])
    motion.save(tmp_path / "run.nc")
    read = cd.load_motion(tmp_path / "run.nc")
    assert read.model is None
    np.testing.assert_array_equal(read.sections("shaft"), sections)
    with pytest.raises(cd.ModelError, match=r"beam .shift. does not exist.*shaft"):
        motion.sections("shift")


@pytest.mark.parametrize("plane", [None, "y"])
def test_sections_of_a_rolled_up_beam_follow_its_circle(plane: str | None) -> None:
    """The moment M bends a beam of unit length and stiffness into an arc of angle M s."""
    scene = cd.Scene("roll", gravity=(0, 0, 0))
    moment = scene.parameter("M", 0.0, unit="N m")
    unit = cd.section.general(EA=1e4, GA=1e4, GJ=1, EI=1, rhoA=1, rhoI=1e-2)
    beam = scene.beam("beam", scene.ground, (1, 0, 0), unit, elements=5)
    scene.force("moment", cd.Torque(beam.end, (0, moment, 0)))
    options = {} if plane is None else {"plane": plane}
    path = cd.compile(scene, coordinates="absolute", **options).statics(M=[0, 1.0, 3.0])
    sections = path.sections("beam")
    assert sections.shape == (len(path["M"]), 6, 4, 4)
    for M, row in zip(path["M"], sections, strict=True):
        angles = M * np.linspace(0, 1, 6)
        np.testing.assert_allclose(row[:, :3, :3], about("y", angles), atol=1e-9)
        x = np.sin(angles) / M if M else np.linspace(0, 1, 6)
        np.testing.assert_allclose(row[:, 0, 3], x, atol=1e-8)


def test_rigid_rotation_turns_all_sections_alike() -> None:
    scene = cd.Scene("arm", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1, inertia=(1, 1, 1))
    scene.joint("pin", cd.Revolute("y"), scene.ground, hub)
    scene.beam("arm", hub.at(0.1, 0, 0), (1.1, 0, 0.3), SHAFT, elements=4)
    model = cd.compile(scene)
    before, after = (model.equilibrium(locked={"pin": x}).sections("arm") for x in (0.0, 0.9))
    turned = np.eye(4)
    turned[:3, :3] = about("y", np.array([0.9]))[0]
    np.testing.assert_allclose(after, turned @ before, atol=1e-9)
    np.testing.assert_allclose(
        before[0, :3, 0], np.array([1, 0, 0.3]) / np.hypot(1, 0.3), atol=1e-12
    )


def test_sections_of_an_arc_have_its_tangents_and_the_direction_up() -> None:
    """Sections of a quarter of a circle at named nodes too, which other beams begin at."""
    scene = cd.Scene("arc", gravity=(0, 0, 0))
    line = cd.arc(center=(0, 0, 0))
    ring = scene.beam("ring", (1, 0, 0), (0, 1, 0), SHAFT, elements=6, line=line, up=(0, 0, 1))
    scene.joint("clamp", cd.Fixed(), scene.ground, ring.start)
    spoke = scene.beam("spoke", ring.at(0.5), (0.1, 0.1, 0), SHAFT, elements=2)
    scene.joint("end", cd.Fixed(), spoke.end, scene.body("knob", mass=1, inertia=(1, 1, 1)))
    rest = cd.compile(scene).equilibrium()
    angles = np.linspace(0, np.pi / 2, 7)
    sections = rest.sections("ring")
    tangents = np.stack([-np.sin(angles), np.cos(angles), 0 * angles], axis=1)
    np.testing.assert_allclose(sections[:, :3, 0], tangents, atol=1e-9)
    np.testing.assert_allclose(sections[:, :3, 2], np.tile([0, 0, 1], (7, 1)), atol=1e-9)
    # the spoke begins on a node of the ring, with axes of its own
    inward = rest.sections("spoke")[:, :3, 0]
    np.testing.assert_allclose(
        inward, np.tile([-np.sqrt(0.5), -np.sqrt(0.5), 0], (3, 1)), atol=1e-9
    )


def test_extreme_stress_at_nodes_is_that_beside_them() -> None:
    """A cantilever with a load at its tip: stress P (L - s) h / 2 / I, largest of both sides."""
    scene = cd.Scene("cantilever", gravity=(0, 0, 0))
    steel = cd.material(E=2e11, nu=0.3, rho=7800)
    bar = cd.section.rectangle(0.01, 0.02)
    beam = scene.beam("bar", scene.ground, (1, 0, 0), bar, steel, elements=8)
    scene.force("load", cd.Force(beam.end, (0, 0, -1.0)))
    model = cd.compile(scene)
    at_rest = model.beam("bar", model.equilibrium().q).extreme_at_nodes
    expected = (1 - np.linspace(0, 1, 9)) * 0.01 / (0.01 * 0.02**3 / 12)
    np.testing.assert_allclose(at_rest, expected, atol=2e-6 * expected[0])
    # the load comes on at once: it swings to twice that, and higher modes add some
    motion = model.simulate(0.1, step=2e-3)
    stress, both = (getattr(motion.beam("bar"), f"extreme{end}") for end in ("_at_nodes", ""))
    assert stress.shape == motion.sections("bar").shape[:2]
    np.testing.assert_array_equal(stress[:, 3], both[:, 5:7].max(axis=1))
    np.testing.assert_array_equal(stress[:, [0, -1]], both[:, [0, -1]])
    assert 1.7 * expected[0] < stress.max() < 2.6 * expected[0]
