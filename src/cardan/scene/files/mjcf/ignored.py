"""Elements of a file that the model does not act on, by name."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import unread

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement

# actuators that are read, and what is read of each
ACTUATORS = ("motor", "position", "velocity", "general")
_ACTUATOR = {
    *("joint", "jointinparent", "gear", "ctrlrange", "ctrllimited", "forcerange", "forcelimited")
}
# attributes that are read, by element; "class" and "name" are everywhere
READ = {
    "mujoco": {"model"},
    "option": {"gravity"},
    "compiler": {
        *("angle", "eulerseq", "coordinate", "autolimits", "inertiafromgeom"),
        *("inertiagrouprange", "settotalmass"),
    },
    "body": {"childclass"},
    "frame": {"childclass"},
    "inertial": {"mass", "diaginertia", "fullinertia"},
    "geom": {"type", "size", "fromto", "mass", "density", "group", "mesh", "rgba"},
    "site": set(),
    "joint": {
        *("type", "axis", "ref", "range", "limited", "damping", "stiffness", "springref"),
        *("armature", "frictionloss"),
    },
    "freejoint": set(),
    "connect": {"body1", "body2", "anchor", "site1", "site2", "active"},
    "weld": {"body1", "body2", "relpose", "site1", "site2", "active"},
    "equality joint": {"joint1", "joint2", "polycoef", "active"},
    "motor": _ACTUATOR,
    "position": _ACTUATOR | {"kp", "kv", "timeconst", "dampratio"},
    "velocity": _ACTUATOR | {"kv"},
    "general": _ACTUATOR | {"gaintype", "gainprm", "biastype", "biasprm", "dyntype"},
}
POSE_ATTRIBUTES = {"pos", "quat", "axisangle", "xyaxes", "zaxis", "euler"}
PLACES = ("body", "frame", "inertial", "geom", "site")
EVERYWHERE = {"name", "class", "pos"}


def attributes_read(kind: str) -> set[str]:
    """Attributes that are read of an element."""
    return READ[kind] | EVERYWHERE | (POSE_ATTRIBUTES if kind in PLACES else set())


class Unread(unread.Unread):
    """Counts attributes that are passed over as well."""

    def attributes(self, raw: XmlElement, kind: str | None = None) -> None:
        """An element is read: what of it is not?"""
        kind = kind or raw.tag
        read = attributes_read(kind)
        for name in raw.attrib:
            if name not in read:
                self.counts[f"{kind} {name}="] += 1
