"""Viscous damping in a joint."""

from __future__ import annotations

from typing import ClassVar

from ...records import dataclass
from ..formulas import Lines
from ..quantity import JointName, Units, Value
from .force import Action, ForceElement, JointLoad, Places


@dataclass(frozen=True)
class JointDamper(ForceElement):
    """Viscous damping along all speeds of a joint: ``force = -damping u``.

    Args:
        joint: Name of the joint.
        damping: [N m s/rad] for turning, [N s/m] for sliding.

    Raises:
        ModelError: no finite number or expression.

    Source: R. E. Roberson and R. Schwertassek, Dynamics of Multibody Systems, 1988, section 12.1.
    """

    kind: ClassVar[str] = "joint_damper"
    units: ClassVar[Units] = {"damping": "N*m*s/rad|N*s/m"}
    joint: JointName
    damping: Value

    def linear(self) -> tuple[str, ...]:
        return ("damping",)

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        motion, data, joints = at.motion, at.data, at.joints
        joint = joints["joint"]
        drag = -(motion.u(joint) * data["damping"][0])
        return () if drag.is_zero else (Action(joint_loads=(JointLoad(joint, drag),)),)

    def formulas(self, at: Places) -> Lines:
        return (("force along the joint, c the damping", "tau = -(c * u)"),)
