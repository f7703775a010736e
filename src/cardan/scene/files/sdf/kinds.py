"""Kinds of SDF joints, their axes and what acts along them."""

from __future__ import annotations

import math
from collections.abc import Callable

from ....elements.joints.fixed import Fixed
from ....elements.joints.joint import Joint as JointElement
from ....elements.joints.prismatic import Prismatic
from ....elements.joints.revolute import Revolute
from ....elements.joints.screw import Screw
from ....elements.joints.spherical import Spherical
from ....elements.joints.universal import Universal
from ....errors import ModelError, near
from ....records import dataclass
from ....spatial.numbers import Rows, Vector, rotated, unit
from .values import Item, swept_axis

TYPES = ("revolute", "continuous", "prismatic", "screw", "universal", "revolute2", "ball", "fixed")
# joints with one coordinate: limits, springs and friction act on these
SINGLE = ("revolute", "continuous", "prismatic", "screw")
AXES = {"universal": 2, "revolute2": 2, "ball": 0, "fixed": 0}
# what SDF means by no limit
UNLIMITED = 1e16
# axis rotations from the frame it is expressed in to that of the joint
Turn = Callable[[Item], Rows]


def type_of(item: Item) -> str:
    """The type of a <joint>.

    Raises:
        ModelError: an unknown one.
    """
    kind = item.raw.get("type") or ""
    if kind == "gearbox":
        raise ModelError(
            f"{item.where}: type 'gearbox' is not read; couple two joints by <mimic> in the <axis> "
            "of one of them"
        )
    if kind not in TYPES:
        raise ModelError(f"{item.where}: type '{kind[:40]}' is unknown." + near(kind, TYPES))
    return kind


def kind_of(item: Item, kind: str, turn: Turn) -> JointElement:
    """The joint element of a <joint>.

    Args:
        turn: R from the axes that an <axis> is expressed in to those of the joint.

    Raises:
        ModelError: an axis without direction, or a screw without pitch.
    """
    axes = [_axis(item, tag, turn) for tag in ("axis", "axis2")[: AXES.get(kind, 1)]]
    if kind == "fixed":
        return Fixed()
    if kind == "ball":
        return Spherical()
    if kind in ("universal", "revolute2"):
        return Universal(*axes)
    if kind == "prismatic":
        return Prismatic(axes[0])
    return Screw(axes[0], _pitch(item)) if kind == "screw" else Revolute(axes[0])


def _axis(item: Item, tag: str, turn: Turn) -> Vector:
    """Direction of an <axis> in axes of the joint; z where it is missing."""
    axis = item.child(tag)
    if axis is None:
        if tag == "axis2":
            raise ModelError(f"{item.where}: a joint of this type needs <axis2> too")
        return (0.0, 0.0, 1.0)
    direction = axis.numbers("xyz", 3, "0 0 1")
    if not math.hypot(*direction) > 1e-14:
        raise ModelError(f"{item.where}: its {tag} is zero; give for example <xyz>0 0 1</xyz>")
    x, y, z = swept_axis(unit(rotated(turn(axis), unit(direction))))
    return x, y, z


def _pitch(item: Item) -> float:
    """Displacement of a screw per angle [m/rad]."""
    lead, old = item.word("screw_thread_pitch"), item.word("thread_pitch")
    if lead is not None:
        return item.number("screw_thread_pitch") / (2 * math.pi)
    if old is None:
        raise ModelError(f"{item.where}: a screw needs <screw_thread_pitch>, meters per turn")
    threads = item.number("thread_pitch")
    if threads == 0:
        raise ModelError(f"{item.where}: thread_pitch is 0; give <screw_thread_pitch>")
    # the older word counts radians per meter, and of a left-handed screw
    return -1 / threads


@dataclass(frozen=True)
class AxisData:
    """Numbers of an <axis>.

    Attributes:
        limits: As :meth:`Scene.joint` takes them.
        damping, friction, stiffness, reference: [N m s/rad], [N m], [N m/rad], [rad]; of a slide in
            N and m.
    """

    limits: dict[str, float]
    damping: float
    friction: float
    stiffness: float
    reference: float

    @property
    def named(self) -> list[str]:
        """Names of the entries that are not zero or empty."""
        values = {"limit": self.limits, "damping": self.damping, "friction": self.friction}
        values["spring_stiffness"] = self.stiffness
        return [name for name, value in values.items() if value]


def data_of(axis: Item | None, endless: bool) -> AxisData:
    """Limits and dynamics of an <axis>.

    Args:
        endless: Its position has no limits.
    """
    limit = None if axis is None else axis.child("limit")
    dynamics = None if axis is None else axis.child("dynamics")
    names = {"lower": "lower", "upper": "upper", "speed": "velocity", "effort": "effort"}
    limits: dict[str, float] = {}
    for key, name in names.items():
        value = None if limit is None else limit.optional(name)
        # a negative speed or effort means: without limit
        rate = key in ("speed", "effort")
        absent = value is None or abs(value) >= UNLIMITED or (rate and value < 0)
        if value is not None and not absent and (rate or not endless):
            limits[key] = value
    if dynamics is None:
        return AxisData(limits, 0.0, 0.0, 0.0, 0.0)
    return AxisData(
        limits,
        dynamics.number("damping", "0"),
        dynamics.number("friction", "0"),
        dynamics.number("spring_stiffness", "0"),
        dynamics.number("spring_reference", "0"),
    )
