"""Scene files and tables that are pipes, devices, folders or links to them."""

from __future__ import annotations

from pathlib import Path

import pytest

import cardan as cd
from cardan.analyses.identification.data import read
from hostile.harness import Kind, specials
from hostile.mutations import SPECIAL

SCENE = """cardan: 2
bodies: {arm: {mass: 1.0, inertia: [0.1, 0.1, 0.1], com: [0.5, 0, 0]}}
joints: {hinge: {type: revolute, axis: z, parent: ground, child: arm}}
"""
ROBOT = """<robot name="r"><link name="base"/><link name="arm"><inertial><mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="j" type="continuous">
<parent link="base"/><child link="arm"/><axis xyz="0 0 1"/></joint>
</robot>"""
MODEL = """<sdf version="1.7"><model name="m"><link name="arm"/><joint name="j" type="continuous">
<parent>world</parent><child>arm</child></joint></model></sdf>"""
TABLE = "t,hinge\n0.0,0.0\n0.1,0.2\n"


READERS = {
    "scene.yaml": (SCENE, cd.load),
    "robot.urdf": (ROBOT, cd.load),
    "robot.xml": (ROBOT, cd.load),
    "robot.sdf": (MODEL, cd.load),
    "table.csv": (TABLE, read),
}


@pytest.mark.parametrize("name", READERS)
def test_e5_pipes_and_devices_as_scenes_and_tables_are_refused(name: str, tmp_path: Path) -> None:
    """A pipe given as scene hung, a link to /dev/zero ate all memory."""
    text, reads = READERS[name]
    (tmp_path / "good").mkdir()
    (tmp_path / "good" / name).write_text(text)
    kind = Kind(name, tmp_path / "good" / name, reads, lambda found: repr(found).encode())
    tally = specials(kind, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)
    assert tally.counts == {"refused": len(SPECIAL)}
