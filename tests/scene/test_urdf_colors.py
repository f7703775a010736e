"""Colors of URDF materials reach the shapes of the scene and of the manifest."""

from __future__ import annotations

import pytest

import cardan as cd
from cardan.scene.files.urdf import from_text

LINK = """<robot name="painted">
<material name="steel"><color rgba="0.5 0.5 0.6 1"/></material>
<material name="wood"><texture filename="wood.png"/></material>
<link name="base">{}</link>
<link name="arm"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial>
<visual><geometry><sphere radius="1"/></geometry>
<material name="leaf"><color rgba="0 0.5 0 0.25"/></material></visual></link>
<joint name="hinge" type="continuous"><parent link="base"/><child link="arm"/></joint></robot>"""
BOX = '<visual><geometry><box size="1 2 3"/></geometry>{}</visual>'
MATERIALS = {
    '<material name="steel"/>': (0.5, 0.5, 0.6, 1),
    # of a link that comes later in the file
    '<material name="leaf"/>': (0, 0.5, 0, 0.25),
    '<material name="steel"><color rgba="1 0 0 1"/></material>': (1, 0, 0, 1),
    '<material name=""><color rgba="1.5 -1 0 1"/></material>': (1, 0, 0, 1),
    '<material name="wood"/>': None,
    '<material name="unknown"/>': None,
    "<material/>": None,
    "": None,
}


@pytest.mark.parametrize("material", MATERIALS)
def test_materials_color_shapes(material: str) -> None:
    scene = from_text(LINK.format(BOX.format(material)))
    assert scene.bodies["base"].shapes[0].color == MATERIALS[material]


def test_colors_are_in_the_manifest_for_every_kind_of_shape() -> None:
    forms = '<sphere radius="1"/>', '<cylinder radius="1" length="2"/>', '<mesh filename="a.stl"/>'
    steel = '<material name="steel"/>'
    visuals = "".join(f"<visual><geometry>{one}</geometry>{steel}</visual>" for one in forms)
    rows = cd.compile(from_text(LINK.format(visuals))).manifest.shapes
    assert [row.kind for row in rows] == ["sphere", "cylinder", "mesh", "sphere"]
    assert [tuple(row.color or ()) for row in rows] == [(0.5, 0.5, 0.6, 1)] * 3 + [
        (0, 0.5, 0, 0.25)
    ]


@pytest.mark.parametrize("color", ["1 0 0", "red", "nan 0 0 1", "1 0 0 1 1", ""])
def test_colors_that_are_none_are_refused(color: str) -> None:
    material = f'<material name="odd"><color rgba="{color}"/></material>'
    with pytest.raises(cd.ModelError, match="rgba"):
        from_text(LINK.format(BOX.format(material)))
