"""Frames placed from frames: poses, files, parts, long chains."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import cardan as cd


def nested() -> cd.Scene:
    """A tool on a flange on an arm; the length of the arm is a parameter."""
    scene = cd.Scene("nested", gravity=(0, 0, -9.81))
    length = scene.parameter("length", 0.8)
    arm = scene.body("arm", mass=1.0, com=(0.4, 0, 0), inertia=(0.01, 0.05, 0.05))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, arm)
    flange = arm.at(length, 0, 0.1, rotation=("XYZ", 0.3, -0.5, 0.2), name="flange")
    flange.at(0, 0, 0.25, rotation=("xyz", 0.0, 0.7, 0.0), name="tool")
    return scene


def matrix(R: Rotation, p: tuple[float, ...]) -> np.ndarray:
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = R.as_matrix(), p
    return pose


def check(model: cd.CompiledModel, length: float) -> None:
    flange = matrix(Rotation.from_euler("XYZ", (0.3, -0.5, 0.2)), (length, 0, 0.1))
    tool = flange @ matrix(Rotation.from_euler("xyz", (0, 0.7, 0)), (0, 0, 0.25))
    arm = matrix(Rotation.from_euler("y", 0.4), (0, 0, 0))
    assert model.pose("tool", [0.4]) == pytest.approx(arm @ tool, abs=1e-14)


def test_a_frame_is_placed_from_a_frame() -> None:
    model = cd.compile(nested())
    check(model, 0.8)
    check(model.with_parameters({"length": 1.1}), 1.1)
    absolute = cd.compile(nested(), coordinates="absolute")
    state = absolute.initial(q={"hinge": 0.4})
    moved = absolute.pose("tool", absolute.split(state)[0])
    assert moved == pytest.approx(model.pose("tool", [0.4]), abs=1e-12)


def test_files_and_parts_keep_it(tmp_path: Path) -> None:
    nested().save(tmp_path / "scene.yaml")
    assert "body: flange" in (tmp_path / "scene.yaml").read_text()
    check(cd.compile(cd.load(tmp_path / "scene.yaml")), 0.8)
    whole = cd.Scene("whole", gravity=(0, 0, -9.81))
    whole.include(nested(), prefix="left")
    assert whole.frames["left.tool"].base is whole.frames["left.flange"]


def test_a_frame_of_a_file_stands_behind_its_own(tmp_path: Path) -> None:
    text = """
cardan: 2
name: order
bodies: {arm: {mass: 1.0, inertia: [1, 1, 1]}}
frames:
  flange: {body: arm, at: [1, 0, 0]}
  tool: {body: flange, at: [0, 0, 1]}
joints: {hinge: {type: revolute, parent: ground, child: arm, axis: y}}
"""
    (tmp_path / "order.yaml").write_text(text)
    model = cd.compile(cd.load(tmp_path / "order.yaml"))
    assert model.pose("tool", [0.0])[:3, 3] == pytest.approx([1, 0, 1])
    (tmp_path / "order.yaml").write_text(text.replace("body: arm,", "body: tool,"))
    with pytest.raises(cd.ModelError, match="'tool' does not exist"):
        cd.load(tmp_path / "order.yaml")


def test_chains_may_be_long() -> None:
    scene = cd.Scene("long")
    frame = scene.body("body", mass=1.0, inertia=(1, 1, 1)).at(0, 0, 0)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, scene.bodies["body"])
    for _ in range(3000):
        frame = frame.at(0.001, 0, 0)
    last = frame.at(0, 0, 0, name="last")
    assert last.body.name == "body"
    assert cd.compile(scene).pose("last", [0.0])[0, 3] == pytest.approx(3.0, abs=1e-10)
