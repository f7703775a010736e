"""Kinds of URDF joints and the places of their frames."""

from __future__ import annotations

from collections.abc import Sequence

from ....elements.joints.fixed import Fixed
from ....elements.joints.free import Free
from ....elements.joints.joint import Joint as JointElement
from ....elements.joints.planar import Planar
from ....elements.joints.prismatic import Prismatic
from ....elements.joints.revolute import Revolute
from ....errors import ModelError, near
from ..angles import snap_all, snap_axis
from ..document import Element

TYPES = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")
# those that have an axis, and those that must have limits
AXIAL = ("revolute", "continuous", "prismatic", "planar")
LIMITED = ("revolute", "prismatic")
Origin = tuple[list[float], list[float]]


def kind_of(element: Element, snap: bool, snaps: list[str], tag: str = "axis") -> JointElement:
    """The joint element of a <joint>.

    Args:
        tag: Of its axis.

    Raises:
        ModelError: an unknown type or an axis without direction.
    """
    kind = element.text("type")
    if kind not in TYPES:
        raise ModelError(f"{element.where}: type '{kind}' is unknown." + near(kind, TYPES))
    if kind == "fixed":
        return Fixed()
    if kind == "floating":
        return Free()
    family = {"prismatic": Prismatic, "planar": Planar}
    element_kind: JointElement = family.get(kind, Revolute)(axis_of(element, tag, snap, snaps))
    return element_kind


def omissions(element: Element) -> list[str]:
    """Sentences on what a <joint> leaves to a default although a user will want to say it."""
    kind, said = element.text("type"), []
    if kind in AXIAL and element.child("axis") is None:
        said.append("no <axis>; x is taken, as URDF says")
    if kind in LIMITED and element.child("limit") is None:
        said.append(f"no <limit>, which URDF requires of a {kind} joint; it moves without limits")
    return said


def axis_of(element: Element, tag: str, snap: bool, snaps: list[str]) -> tuple[float, ...]:
    """The direction of <axis> or a tag like it, x where it is missing.

    Raises:
        ModelError: it is zero.
    """
    axis = element.child(tag)
    direction: Sequence[float] = [1.0, 0.0, 0.0] if axis is None else axis.numbers("xyz", 3)
    if not any(direction):
        raise ModelError(f"{element.where}: its {tag} is zero; give for example xyz='0 0 1'")
    if axis is not None and snap:
        direction = snap_axis(axis.text("xyz").split(), direction, element.where, snaps)
    if sum(x != 0 for x in direction) == 1:
        direction = [float((x > 0) - (x < 0)) for x in direction]
    return tuple(direction)


def origin_of(
    element: Element, who: str, snap: bool, snaps: list[str], tag: str = "origin"
) -> Origin:
    """Position and roll, pitch, yaw of <origin>; pictures need no snapping."""
    origin = element.child(tag)
    if origin is None:
        return [0.0] * 3, [0.0] * 3
    xyz = origin.numbers("xyz", 3, "0 0 0")
    rpy = origin.numbers("rpy", 3, "0 0 0")
    if snap and any(rpy):
        rpy = snap_all(origin.text("rpy").split(), rpy, who, snaps)
    return xyz, rpy
