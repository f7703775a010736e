"""Cassie from the SDF of example-robot-data: 26 joints on 23 links, four loops."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import cardan as cd
from mechanisms.robots import folder

FILE = folder() / "cassie_description" / "robots" / "cassie_v2.sdf"
CLOSED = 1e-10
SIDES = ("left", "right")


def load(base: str = "fixed", **options: str) -> cd.Scene:
    return cd.load(FILE, base=base, packages=folder().parents[1], **options)


@pytest.fixture(scope="module")
def model() -> cd.CompiledModel:
    return cd.compile(load())


def test_it_is_all_there() -> None:
    scene = load()
    root = ET.parse(FILE).getroot().find("model")
    assert root is not None
    links, joints = root.findall("link"), root.findall("joint")
    assert (len(links), len(joints)) == (23, 26)
    assert list(scene.bodies) == [link.get("name") for link in links]
    assert set(scene.joints) == {"base", *(joint.get("name") for joint in joints)}
    total = sum(float(link.findtext("inertial/mass") or 0) for link in links)
    assert sum(body.mass for body in scene.bodies.values()) == pytest.approx(total, rel=1e-15)
    # springs of shins and heels act, and damping of all joints but the balls
    springs = [name for name in scene.forces if name.endswith(".spring")]
    assert springs == [
        f"{side}-{name}.spring"
        for side in SIDES
        for name in ("knee-shin-joint", "tarsus-spring-joint")
    ]
    assert "joints left-pitch-rod-joint, right-pitch-rod-joint (ball): damping does not act" in (
        scene.notes
    )
    # 23 pictures are found
    assert not any("mesh" in note for note in scene.notes)


def test_links_are_where_the_file_has_them(model: cd.CompiledModel) -> None:
    """All coordinates zero; angles are snapped by at most half a unit of their last digit."""
    root = ET.parse(FILE).getroot().find("model")
    assert root is not None
    for link in root.findall("link"):
        numbers = np.array((link.findtext("pose") or "").split(), dtype=float)
        pose = model.pose(str(link.get("name")), np.zeros(model.nq))
        np.testing.assert_allclose(pose[:3, 3], numbers[:3], atol=1e-15)
        turn = Rotation.from_euler("xyz", numbers[3:]).as_matrix()
        # -1.57 is a rounded quarter turn
        np.testing.assert_allclose(pose[:3, :3], turn, atol=1e-3)
    np.testing.assert_allclose(model.constraints(np.zeros(model.nq)), 0, atol=1e-15)


def test_its_freedoms(model: cd.CompiledModel) -> None:
    """Four loops are cut at their balls; those of the feet are planar, with a redundant row."""
    balls = {
        f"{side}-{name}" for side in SIDES for name in ("pitch-rod-joint", "plantar-foot-joint")
    }
    assert {cut.name for cut in model.manifest.cuts} == balls
    assert (model.nq, model.nlam) == (22, 10)
    q = model.assemble().q
    assert np.linalg.matrix_rank(model.constraint_jacobian(q)) == 10
    # zero is outside the limits of cranks and feet; all else stays there
    moved = {name for name, x in zip(model.coordinates, q, strict=True) if abs(x) > 1e-9}
    assert moved == {
        f"{side}-{name}"
        for side in SIDES
        for name in ("tarsus-crank-joint", "crank-rod-joint", "foot-op")
    }


def test_many_states_are_those_of_single_ones(model: cd.CompiledModel) -> None:
    """The C of lanes has runs of zeros in the matrix of these loops."""
    q = np.broadcast_to(model.assemble().q, (64, model.nq))
    u = model.close_velocity(q, np.random.default_rng(1).uniform(-1, 1, (64, model.nu)))
    u = u[:, : model.nu]
    model.prepare("forward_dynamics", batch=True)
    udot = model.forward_dynamics(q, u)
    single = np.array([model.forward_dynamics(*row) for row in zip(q, u, strict=True)])
    np.testing.assert_allclose(udot, single, rtol=1e-12, atol=1e-10)


@pytest.mark.parametrize(("base", "limits"), [("fixed", "stop"), ("free", "note")])
def test_it_swings_with_its_loops_closed(base: str, limits: str) -> None:
    robot = cd.compile(load(base, limits=limits))
    motion = robot.simulate(10.0, q={"left-knee-op": -0.8})
    assert motion.success, motion.message
    drift = np.abs(robot.constraints(motion.q)).max()
    print(f"{base}: {drift:.1e} m, {len(motion.t)} steps")
    assert drift < CLOSED
    # it swings
    assert np.ptp(motion["left-knee-op"]) > 0.5
    # what the ledger cannot account for, of hundreds of joules
    assert np.abs(motion.energy_residual).max() < 1e-2
    if base == "free":
        # springs and dampers are inner forces: the center of mass falls freely
        com = np.array([robot.com(q) for q in motion.q])
        height = com[0, 2] + motion.t * (com[-1, 2] - com[0, 2] + 9.81 / 2 * 100) / 10
        np.testing.assert_allclose(com[:, 2], height - 9.81 / 2 * motion.t**2, atol=1e-4)
