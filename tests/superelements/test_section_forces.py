"""Forces and moments in beams of superelements: closed forms, and the beams of compiled scenes."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd

TUBE, CARBON = cd.section.tube(0.03, 0.028), cd.material(E=90e9, nu=0.3, rho=1600)
LENGTH = 2.0
FORCE, MOMENT = np.array([10.0, 2.0, -3.0]), np.array([0.5, 0.1, 0.2])


@cache
def boom() -> Any:
    """A straight boom along an axis of its own, its sections turned about it."""
    scene = cd.Scene("boom", gravity=(0, 0, 0))
    end = LENGTH * np.array([2.0, 3.0, 6.0]) / 7
    scene.beam("boom", (0, 0, 0), tuple(end), TUBE, CARBON, elements=4, up=(1, 0, 0))
    return scene, cd.superelement.from_beams(scene, "boom", modes=3)


def axes() -> Any:
    """Of the sections: along the beam, then as ``up`` directs them."""
    along, up = np.array([2.0, 3.0, 6.0]) / 7, np.array([1.0, 0, 0])
    third = up - (up @ along) * along
    third /= np.linalg.norm(third)
    return np.array([along, np.cross(third, along), third])


def test_a_cantilever_has_its_closed_form() -> None:
    """N and Q are the load, M = M_L + (L - x) e1 x F, at every section."""
    _, record = boom()
    R = axes()
    z = np.zeros(record.n)
    load = np.concatenate([R.T @ FORCE, R.T @ MOMENT])
    z[6:12] = np.linalg.solve(record.K[6:12, 6:12], load)
    found = record.section_forces(z, "boom")
    np.testing.assert_allclose(found.s, LENGTH * np.array([0, 1, 1, 2, 2, 3, 3, 4]) / 4)
    size = np.abs(FORCE).max() * LENGTH
    np.testing.assert_allclose(found.force, [FORCE] * 8, atol=1e-8 * size)
    expected = MOMENT + (LENGTH - found.s)[:, None] * np.cross([1.0, 0, 0], FORCE)
    np.testing.assert_allclose(found.moment, expected, atol=1e-8 * size)
    assert "4 elements" in repr(found)
    assert record.stress_names[:6] == tuple(
        f"boom 1 {x}" for x in ("N", "Qy", "Qz", "Mx", "My", "Mz")
    )


LOADS = 1e-3 * np.array([0.3, -0.5, 0.8])


def portal(curved: bool) -> cd.Scene:
    """Two beams that meet beside the center of a body."""
    scene = cd.Scene("portal", gravity=(0, 0, 0))
    knee = scene.body("knee", mass=0.5, inertia=(1e-3, 1e-3, 1e-3), pose=(1.0, 0.2, 0.1))
    line = {"line": cd.arc(through=(0.6, 0.5, 0.3))} if curved else {}
    scene.beam("bow", scene.ground, knee.at(-0.05, 0, 0), TUBE, CARBON, elements=5, **line)
    scene.beam("arm", knee.at(0.04, 0, 0), (1.9, -0.3, 0.4), TUBE, CARBON, elements=3)
    return scene


def loaded(scene: cd.Scene, place: Any) -> Any:
    for name, kind in (("push", cd.Force), ("twist", cd.Torque)):
        scene.force(name, kind(place, tuple(LOADS)))
    return cd.compile(scene)


def reduced(curved: bool) -> Any:
    ends = {"root": "bow.start", "tip": "arm.end"}
    return cd.superelement.from_beams(
        portal(curved), ["bow", "arm"], ends, bodies=["knee"], modes=2
    )


def test_they_are_those_of_the_beams_of_a_compiled_scene() -> None:
    """At rest under small loads, of beams that end beside the center of a body."""
    model = loaded(portal(False), "arm.end")
    rest = model.equilibrium()
    scene = cd.Scene("short", gravity=(0, 0, 0))
    body = scene.superelement("portal", reduced(False), {"root": scene.ground}, frame="root")
    short = loaded(scene, body.at("tip"))
    shape = short.superelement("portal", short.equilibrium().q)
    for name in ("bow", "arm"):
        found, expected = shape.section_forces(name), model.beam(name, rest.q)
        np.testing.assert_allclose(found.s, expected.s, rtol=1e-12)
        # deflections of 1e-5 m turn the loads
        for one in ("force", "moment"):
            here, there = getattr(found, one), getattr(expected, one)
            np.testing.assert_allclose(here, there, atol=1e-4 * np.abs(there).max())


def test_sections_of_curved_beams_are_in_equilibrium() -> None:
    """Sizes of force and moment everywhere are those of statics: F and M + (tip - x) x F."""
    record = reduced(True)
    z = np.zeros(record.n)
    z[6:12] = np.linalg.solve(record.K[6:12, 6:12], np.concatenate([LOADS, LOADS]))
    nodes, tip = np.split(record.surface_points, [6]), np.array([1.9, -0.3, 0.4])
    for name, points in zip(("bow", "arm"), nodes, strict=True):
        found = record.section_forces(z, name)
        x = np.repeat(points, 2, axis=0)[1:-1]
        for values, expected in (
            (found.force, np.broadcast_to(LOADS, x.shape)),
            (found.moment, LOADS + np.cross(tip - x, LOADS)),
        ):
            sizes = np.linalg.norm(expected, axis=1)
            np.testing.assert_allclose(np.linalg.norm(values, axis=1), sizes, rtol=1e-7)


def test_along_motions_and_in_files(tmp_path: Path) -> None:
    _, record = boom()
    record.save(tmp_path / "boom.npz")
    again = cd.superelement.load(tmp_path / "boom.npz")
    z = np.random.default_rng(4).normal(size=(2, record.n))
    one, other = record.section_forces(z, "boom"), again.section_forces(z, "boom")
    np.testing.assert_array_equal(one.moment, other.moment)
    assert one.force.shape == (2, 8, 3)
    scene = cd.Scene("shaken", gravity=(0, 0, -9.81))
    scene.superelement("boom", again, {"start": scene.ground}, frame="start")
    motion = cd.compile(scene).simulate([0, 0.01, 0.02], method="GeneralizedAlpha", step=1e-3)
    shape = motion.superelement("boom")
    along = shape.section_forces("boom")
    full = np.zeros((3, record.n))
    full[:, 6:] = shape.z
    expected = record.section_forces(full, "boom")
    np.testing.assert_allclose(along.moment, expected.moment, rtol=1e-9, atol=1e-12)
    assert np.abs(along.moment[-1]).max() > 1e-3
    motion.save(tmp_path / "run.npz")
    loaded = cd.load_motion(tmp_path / "run.npz").superelement("boom").section_forces("boom")
    np.testing.assert_array_equal(loaded.force, along.force)


def test_beams_that_there_are_not() -> None:
    _, record = boom()
    with pytest.raises(cd.ModelError, match=r"no beam 'bom'.*Did you mean 'boom'"):
        record.section_forces(np.zeros(record.n), "bom")
    K = np.array([[1.0, -1.0], [-1.0, 1.0]])
    bar = cd.superelement.reduce(
        np.eye(2), K, [[0, 0, 0], [1, 0, 0]], {"a": 0}, dofs=[(0, "x"), (1, "x")], modes=1
    )
    with pytest.raises(cd.ModelError, match="not of beams"):
        bar.section_forces(np.zeros(bar.n), "boom")
