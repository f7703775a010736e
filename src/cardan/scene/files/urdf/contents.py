"""Elements and attributes of URDF that are read; what else a file contains is named in a note."""

from __future__ import annotations

from collections.abc import Mapping

from ..unread import Content

_MOTION = ("limit", "dynamics", "mimic")
_LINK = Content(("link",))
_PLACE = Content(("xyz", "rpy"))
_AXIS = Content(("xyz",))

# by the name of the element, which means the same wherever it stands
CONTENTS: Mapping[str, Content] = {
    "robot": Content(
        ("name", "version"), ("link", "joint", "loop_joint", "constraint", "material")
    ),
    "link": Content(("name",), ("inertial", "visual")),
    "inertial": Content((), ("origin", "mass", "inertia")),
    "origin": _PLACE,
    "mass": Content(("value",)),
    "inertia": Content(("ixx", "ixy", "ixz", "iyy", "iyz", "izz")),
    "visual": Content(("name",), ("origin", "geometry", "material")),
    "geometry": Content((), ("box", "cylinder", "sphere", "capsule", "mesh")),
    "box": Content(("size",)),
    "cylinder": Content(("radius", "length")),
    "capsule": Content(("radius", "length")),
    "sphere": Content(("radius",)),
    "mesh": Content(("filename", "scale")),
    "material": Content(("name",), ("color",)),
    "color": Content(("rgba",)),
    "joint": Content(("name", "type"), ("origin", "parent", "child", "axis", *_MOTION)),
    "parent": _LINK,
    "child": _LINK,
    "axis": _AXIS,
    "limit": Content(("lower", "upper", "velocity", "effort")),
    "dynamics": Content(("damping", "friction")),
    "mimic": Content(("joint", "multiplier", "offset", "reference")),
    "loop_joint": Content(
        ("name", "type"), ("link1", "link2", "origin", "axis", "axis2", *_MOTION)
    ),
    "link1": _LINK,
    "link2": Content(("link",), ("origin",)),
    "axis2": _AXIS,
    "constraint": Content(
        ("name", "type"),
        (
            *("parent", "parent_origin", "parent_axis", "child", "child_origin", "child_axis"),
            *_MOTION,
        ),
    ),
    "parent_origin": _PLACE,
    "parent_axis": _AXIS,
    "child_origin": _PLACE,
    "child_axis": _AXIS,
}
