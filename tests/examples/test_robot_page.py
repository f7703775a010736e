"""docs/robot_files.md is true: its loop closes, its lists are complete."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

import cardan as cd
from cardan.scene.files.mjcf.ignored import READ
from cardan.scene.files.mjcf.masses import SIZES
from cardan.scene.files.sdf.kinds import TYPES as SDF_TYPES
from cardan.scene.files.urdf import from_text
from cardan.scene.files.urdf.loops import TYPES
from scene.test_urdf_loops import robot

PAGE = Path(__file__).parents[2] / "docs" / "robot_files.md"
TEXT = PAGE.read_text(encoding="utf-8")


def test_the_loop_of_the_page_closes_both_ways() -> None:
    block, constraint = re.findall(r"```xml\n(.*?)```", TEXT, re.DOTALL)
    inside = re.search(r"`(<link2 .*?</link2>)`", TEXT)
    assert inside is not None
    drawn = cd.compile(from_text(robot(block)))
    np.testing.assert_allclose(drawn.closure(np.zeros(3)), 0, atol=1e-15)
    scene = from_text(robot(block.replace('<link2 link="rocker"/>', inside.group(1))))
    assert scene.joints["C"].child.coordinates == (0.2, 0.0, 0.0)
    scene = from_text(robot(constraint))
    assert scene.joints["C"].kind == cd.Revolute((0, 0, 1))
    assert scene.joints["C"].child.coordinates == (0.2, 0.0, 0.0)


def test_types_and_elements_are_listed() -> None:
    words = set(re.findall(r"[a-z]+2?", TEXT))
    assert words >= set(TYPES) | set(SDF_TYPES)
    assert words >= set(SIZES)
    for element, attributes in READ.items():
        if element not in ("mujoco", "equality joint"):
            assert words >= {element}, element
        if element in ("joint", "compiler"):
            assert words >= attributes - {"type", "limited", "coordinate", "frictionloss"}, element
