"""The <constraint> of URDF that closes a loop, as it was proposed to urdfdom.

    <constraint name="C" type="revolute">
      <parent link="coupler"/>
      <parent_origin xyz="0.25 0 0" rpy="0 0 0"/>
      <parent_axis xyz="0 0 1"/>
      <child link="rocker"/>
      <child_origin xyz="0.2 0 0" rpy="0 0 0"/>
      <child_axis xyz="0 0 1"/>
    </constraint>

Two frames, one on each link, are joined. The proposal leaves types and missing elements open: types
are those of a <loop_joint>; a missing origin is that of the link; a missing child axis is the
parent axis, and a missing parent axis is x. Where the two axes of a joint with one axis differ, the
joint holds one along the other. A universal joint turns about the parent axis, then about the child
axis.

Source: F. Finkbeiner, "Add constraints to describe closed loops", pull requests 264 of
ros/urdfdom and 108 of ros/urdfdom_headers, 2026.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ....elements.joints.joint import Joint as JointElement
from ....elements.joints.universal import Universal
from ....errors import ModelError
from ....spatial.numbers import UPRIGHT, Rows, product, transposed, unit, upright_to
from ...body import Body
from ...scene import SceneRecord
from ..document import Element, place
from ..pose import Pose
from ..robot import frame_at
from .kinds import axis_of, origin_of
from .loops import ends_of, kind_of_loop, pose_of, remark

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement

# joints that turn about their axis: how the frames are turned about it does not matter
TURNS = ("revolute", "continuous", "cylindrical", "planar")


def close(
    scene: SceneRecord, root: XmlElement, file: str, bodies: Mapping[str, Body], snap: bool
) -> None:
    """Make the <constraint>s of a robot.

    Args:
        bodies: By the name of their link.

    Raises:
        ModelError: an end that is missing or no link, a link joined to itself, an unknown type, or
            axes that do not fit together.
    """
    for raw in root.findall("constraint"):
        where = place(raw, file)
        name = Element(raw, f"{where}: <constraint>").text("name")
        element = Element(raw, f"{where}: constraint '{name[:80]}'")
        if raw.find("predecessor") is not None or raw.find("successor") is not None:
            raise ModelError(
                f"{element.where}: <predecessor> and <successor> are not read; give <parent "
                "link=.../>, <parent_origin/>, <parent_axis/> and the same of the <child>"
            )
        ends = ends_of(element, ("parent", "child"), bodies)
        kind, turn = _kind(element, snap, scene.snaps)
        one, two = (
            pose_of(origin_of(element, element.where, snap, scene.snaps, f"{role}_origin"))
            for role in ("parent", "child")
        )
        two = Pose(product(two.rotation, turn), two.position)
        frames = [frame_at(bodies[link], pose) for link, pose in zip(ends, (one, two), strict=True)]
        if name in scene.joints:
            raise ModelError(f"{element.where}: a joint has this name; rename one of them")
        scene.joint(name, kind, frames[0], frames[1], cut=True)
        scene.origins["joint", name] = where
        remark(scene, element, "parent_axis")


def _kind(element: Element, snap: bool, snaps: list[str]) -> tuple[JointElement, Rows]:
    """The joint element, and how the frame on the child is turned to bring the axes together."""
    name = element.text("type")
    first = axis_of(element, "parent_axis", snap, snaps)
    second = (
        axis_of(element, "child_axis", snap, snaps)
        if element.child("child_axis") is not None
        else None
    )
    if name == "universal":
        if second is None:
            raise ModelError(f"{element.where}: a universal joint needs <child_axis xyz=.../> too")
        return Universal(first, second), UPRIGHT
    kind = kind_of_loop(element, snap, snaps, "parent_axis")
    if second is None or not {"axis", "normal"} & set(kind.quantities()):
        return kind, UPRIGHT
    one, other = unit(first), unit(second)
    if max(abs(a - b) for a, b in zip(one, other, strict=True)) < 1e-14:
        return kind, UPRIGHT
    if name not in TURNS:
        raise ModelError(
            f"{element.where}: parent_axis and child_axis of a {name} joint differ, which leaves "
            "open how it is turned about them; make them equal and turn an origin (rpy)"
        )
    return kind, product(upright_to(other), transposed(upright_to(one)))
