"""Joints that close loops, an extension of URDF.

    <loop_joint name="C" type="revolute">
      <link1 link="coupler"/>
      <link2 link="rocker"/>
      <origin xyz="0.25 0 0" rpy="0 0 0"/>
      <axis xyz="0 0 1"/>
    </loop_joint>

It joins two links of the tree. Its frame on link1 is given by <origin> like that of any joint, and
<axis> in that frame. Its frame on link2 is the one that coincides with it in the reference
configuration, all coordinates zero; where the loop is not closed there, an <origin> inside
<link2> says where the frame is on link2. Types are those of a <joint>, without floating, and
spherical (or ball), cylindrical and universal with a second direction <axis2>.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ....elements.joints.cylindrical import Cylindrical
from ....elements.joints.joint import Joint as JointElement
from ....elements.joints.spherical import Spherical
from ....elements.joints.universal import Universal
from ....errors import ModelError, near
from ....spatial.numbers import of_sequence
from ...body import Body
from ...scene import SceneRecord
from ..document import Element, place
from ..pose import HERE, Pose
from ..robot import frame_at
from .graph import Edge, check_link
from .kinds import AXIAL, Origin, axis_of, kind_of, origin_of
from .kinds import TYPES as PLAIN

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement

TYPES = (*(kind for kind in PLAIN if kind != "floating"), "spherical", "ball", "cylindrical",
         "universal")  # fmt: skip
PASSED_OVER = ("limit", "dynamics", "mimic")


def close(
    scene: SceneRecord,
    root: XmlElement,
    file: str,
    bodies: Mapping[str, Body],
    drawn: Mapping[str, Pose],
    snap: bool,
) -> None:
    """Make the <loop_joint>s of a robot.

    Args:
        bodies: By the name of their link.
        drawn: Poses of links in the reference configuration.

    Raises:
        ModelError: an end that is missing or no link, a link joined to itself, an unknown type.
    """
    for raw in root.findall("loop_joint"):
        where = place(raw, file)
        name = Element(raw, f"{where}: <loop_joint>").text("name")
        element = Element(raw, f"{where}: loop joint '{name[:80]}'")
        ends = ends_of(element, ("link1", "link2"), bodies)
        kind = kind_of_loop(element, snap, scene.snaps)
        one = pose_of(origin_of(element, element.where, snap, scene.snaps))
        second = raw.find("link2")
        assert second is not None
        inner = Element(second, f"{element.where} link2")
        if inner.child("origin") is None:
            two = drawn[ends[1]].inverse().then(drawn[ends[0]]).then(one)
        else:
            two = pose_of(origin_of(inner, inner.where, snap, scene.snaps))
        frames = [frame_at(bodies[link], pose) for link, pose in zip(ends, (one, two), strict=True)]
        if name in scene.joints:
            raise ModelError(f"{element.where}: a joint has this name; rename one of them")
        scene.joint(name, kind, frames[0], frames[1], cut=True)
        scene.origins["joint", name] = where
        remark(scene, element)


def remark(scene: SceneRecord, element: Element, tag: str = "axis") -> None:
    """Note what of a joint that closes a loop does not act, and a missing axis.

    Args:
        tag: Of its axis.
    """
    if element.text("type") in (*AXIAL, "cylindrical", "universal") and element.child(tag) is None:
        scene.notes.append(f"{element.where}: no <{tag}>; x is taken")
    skipped = [tag for tag in PASSED_OVER if element.child(tag) is not None]
    if skipped:
        scene.notes.append(f"{element.where}: {', '.join(skipped)} does not act on it")


def ends_of(
    element: Element, roles: tuple[str, str], bodies: Mapping[str, Body]
) -> tuple[str, str]:
    """The links that a joint joins.

    Raises:
        ModelError: one is missing or does not exist, or both are the same.
    """
    links = []
    for role in roles:
        end = element.child(role)
        if end is None:
            raise ModelError(f"{element.where}: <{role} link=.../> is missing")
        links.append(end.text("link"))
        check_link(element.where, role, links[-1], bodies)
    if links[0] == links[1]:
        raise ModelError(f"{element.where}: it joins link '{links[0]}' to itself")
    return links[0], links[1]


def kind_of_loop(element: Element, snap: bool, snaps: list[str], tag: str = "axis") -> JointElement:
    """The joint element of a joint that closes a loop.

    Args:
        tag: Of its axis.

    Raises:
        ModelError: an unknown type, or an axis that is missing or zero.
    """
    kind = element.text("type")
    if kind not in TYPES:
        raise ModelError(f"{element.where}: type '{kind[:40]}' closes no loop." + near(kind, TYPES))
    if kind in ("spherical", "ball"):
        return Spherical()
    if kind in PLAIN:
        return kind_of(element, snap, snaps, tag)
    axis = axis_of(element, tag, snap, snaps)
    if kind == "cylindrical":
        return Cylindrical(axis)
    if element.child("axis2") is None:
        raise ModelError(f"{element.where}: a universal joint needs <axis2 xyz=.../> too")
    return Universal(axis, axis_of(element, "axis2", snap, snaps))


def reference(base: str, edges: list[Edge], origins: Mapping[str, Origin]) -> dict[str, Pose]:
    """Poses of all links where all coordinates are zero, in axes of the root.

    Args:
        origins: Position and roll, pitch, yaw by name of the joint.
    """
    outboard: dict[str, list[Edge]] = {}
    for edge in edges:
        outboard.setdefault(edge.parent, []).append(edge)
    drawn, stack = {base: HERE}, [base]
    while stack:
        link = stack.pop()
        for edge in outboard.get(link, ()):
            drawn[edge.child] = drawn[link].then(pose_of(origins[edge.name]))
            stack.append(edge.child)
    return drawn


def pose_of(origin: Origin) -> Pose:
    """The pose of an <origin>."""
    (x, y, z), rpy = origin
    return Pose(of_sequence("xyz", rpy), (x, y, z))
