"""Values of SDF: the text of inner elements, and poses."""

from __future__ import annotations

import math

from ....errors import ModelError
from ....spatial.numbers import UPRIGHT, Rows, Vector, of_quaternion, of_sequence
from ..angles import RESIDUE, snap_all
from ..document import Element
from ..pose import HERE, Pose

FORMATS = ("euler_rpy", "quat_xyzw")
# what the arithmetic of poses leaves of a 0, beside lengths of a meter
DUST = 16 * RESIDUE


class Item(Element):
    """An element of SDF: ``<mass>1</mass>`` says what URDF writes as an attribute."""

    __slots__ = ()

    def word(self, name: str) -> str | None:
        """The text of an inner element, or an attribute; None where both are missing."""
        inner = self.raw.find(name)
        return self.raw.get(name) if inner is None else (inner.text or "").strip()

    def lacks(self, name: str) -> str:
        return f"{self.where}: <{self.raw.tag}> lacks <{name}>"

    def flag(self, name: str, default: bool = False) -> bool:
        """A value that is true or false.

        Raises:
            ModelError: neither.
        """
        word = self.text(name, str(default)).lower()
        if word not in ("true", "false", "1", "0"):
            raise ModelError(f"{self.where}: <{name}> is {word[:40]!r}; write true or false")
        return word in ("true", "1")


def pose_of(item: Item, snap: bool, snaps: list[str], who: str = "") -> Pose:
    """The <pose> of an element, seen from the frame that it is relative to.

    Raises:
        ModelError: wrong counts, numbers or formats.
    """
    pose = item.child("pose")
    if pose is None or not (pose.raw.text or "").strip():
        return HERE
    texts = (pose.raw.text or "").split()
    form = pose.text("rotation_format", "euler_rpy")
    if form not in FORMATS:
        raise ModelError(
            f"{item.where}: rotation_format='{form[:40]}' is none of {', '.join(FORMATS)}"
        )
    entries = item.numbers("pose", 6 if form == "euler_rpy" else 7)
    x, y, z = entries[:3]
    if form == "quat_xyzw":
        qx, qy, qz, qw = entries[3:]
        if not math.hypot(*entries[3:]) > 1e-14:
            raise ModelError(f"{item.where}: the quaternion of its pose has length 0")
        return Pose(of_quaternion(qw, qx, qy, qz), (x, y, z))
    angles = entries[3:]
    if pose.flag("degrees"):
        angles = [math.radians(angle) for angle in angles]
    elif snap and any(angles):
        angles = snap_all(texts[3:], angles, who or item.where, snaps)
    return Pose(of_sequence("xyz", angles), (x, y, z))


def swept(pose: Pose) -> Pose:
    """A pose without the residues of its arithmetic."""
    limit = DUST * max(1.0, *map(abs, pose.position))
    x, y, z = (0.0 if abs(entry) <= limit else entry for entry in pose.position)
    return Pose(swept_rows(pose.rotation), (x, y, z))


def swept_rows(rotation: Rows) -> Rows:
    """A rotation whose entries near 0 and 1 are exact; the very same axes are ``UPRIGHT``."""
    rows = [[_swept(entry) for entry in row] for row in rotation]
    return UPRIGHT if rows == UPRIGHT else rows


def swept_axis(axis: Vector) -> Vector:
    """A unit vector whose entries near 0 and 1 are exact."""
    x, y, z = (_swept(entry) for entry in axis)
    return x, y, z


def _swept(entry: float) -> float:
    nearest = float(round(entry))
    return nearest if abs(entry - nearest) <= DUST else entry
