"""Scenes with superelements as people look at them, and as parts of other scenes."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import cardan as cd
from cardan.topology import build
from superelements.components import brick
from topology.numbers_of import frame_pose


@cache
def record() -> cd.superelement.Superelement:
    return brick(modes=3)


def robot() -> cd.Scene:
    """A flexible link between a hinge and a tool."""
    scene = cd.Scene("robot")
    link = scene.superelement("link", record())
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, link.at("root"))
    tool = scene.body("tool", 5.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("elbow", cd.Revolute("y"), link.at("tip").at(0.1, 0, 0, name="flange"), tool)
    return scene


def clamped() -> cd.Scene:
    scene = cd.Scene("clamped")
    scene.superelement("arm", record(), {"root": scene.ground.at(0, 0, 1)}, frame="root")
    return scene


def test_the_summary_lists_them() -> None:
    text = str(robot())
    assert "model 'robot': 1 body, 2 joints, 1 superelement" in text
    heads, row = (line.split() for line in text.splitlines() if line.startswith(("super", "link")))
    assert heads == ["superelement", "mass", "[kg]", "method", "modes", "frame", "interfaces"]
    mass = f"{record().properties.mass:.6g}"
    assert row == ["link", mass, "craig_bampton", "3", "mean", "root,", "tip"]
    assert "root = ground.at1, tip" in str(clamped())
    page = robot()._repr_html_()
    assert "craig_bampton" in page
    assert "link.tip" in page


def test_the_graph_leads_through_them() -> None:
    graph = robot().graph
    assert str(graph) == (
        "ground\n"
        "└─ link.root  [shoulder: revolute]\n"
        "   └─ link.frame  [link.root: elastic]\n"
        "      ├─ link.tip  [link.tip: elastic]\n"
        "      │  └─ tool  [elbow: revolute]\n"
        "      └─ link.modes  [link: modal]"
    )
    assert graph.svg().count('stroke-width="6"') == 2
    thick = [line for line in graph.dot().splitlines() if "penwidth" in line]
    assert [line.split("[")[0].strip() for line in thick] == [
        '"link.frame" -> "link.root"',
        '"link.frame" -> "link.tip"',
    ]
    assert "arm.tip  [arm.tip: elastic]" in str(clamped().graph)


def test_blocks_of_the_mass_matrix_are_those_of_the_element() -> None:
    """Its mass couples all of its coordinates; the tool does not move with the modes."""
    graph = robot().graph
    pattern = np.array(graph.mass_pattern.entries)
    names = list(graph.mass_pattern.columns)
    zeros = {(names[i], names[j]) for i, j in np.argwhere(pattern == 0)}
    assert zeros == {("elbow", "link"), ("link", "elbow")}


def test_included_twice() -> None:
    scene = cd.Scene("pair")
    left = scene.include(robot(), "left")
    scene.include(robot(), "right", at=scene.ground.at(0, 2, 1))
    scene.include(clamped(), "far", at=scene.ground.at(3, 0, 0))
    assert [*scene.superelements] == ["left.link", "right.link", "far.arm"]
    assert left.bodies["link.tip"] is scene.nodes["left.link.tip"].body
    assert scene.superelements["far.arm"].joined == {"root": "far.ground.at1"}
    system = build(scene)
    assert [part.name for part in system.superelements] == ["left.link", "right.link", "far.arm"]
    single = build(robot())
    for name, offset in (("left", (0, 0, 0)), ("right", (0, 2, 1))):
        pose = frame_pose(system, f"{name}.flange")[:3, 3]
        np.testing.assert_allclose(pose, frame_pose(single, "flange")[:3, 3] + offset, atol=1e-12)
    other = cd.Scene("taken")
    other.body("left.link.tip")
    with pytest.raises(cd.ModelError, match=r"interface 'left\.link\.tip': the name is taken"):
        other.include(robot(), "left")
    assert not other.superelements
