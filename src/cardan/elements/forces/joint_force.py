"""A generalized force along a joint."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from ...errors import ModelError, counted
from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines
from ..quantity import JointName, Quantity, Rows
from ..validation import number, vector
from .force import Action, ForceElement, JointLoad, Places


@dataclass(frozen=True)
class JointForce(ForceElement):
    """A force along the speeds of a joint: a motor, a muscle, a measured characteristic.

    Args:
        joint: Name of the joint.
        force: One value per speed of the joint, a bare one where it has one: [N m] for turning,
            [N] for sliding. Numbers, parameters, expressions, or a table of measured data such as
            ``cd.table(angles, torques)(scene.q("knee"))``.

    Raises:
        ModelError: values that are not finite numbers or expressions.

    Source: Kane and Levinson, Dynamics: Theory and Applications, section 4.6.
    """

    kind: ClassVar[str] = "joint_force"
    joint: JointName
    force: Rows

    def __post_init__(self) -> None:
        several = isinstance(self.force, Sequence) or hasattr(self.force, "tolist")
        if several and not isinstance(self.force, str):
            entries = vector("joint_force", "force", self.force)
        else:
            entries = (number("joint_force", "force", self.force),)
        object.__setattr__(self, "force", entries)

    def quantities(self) -> dict[str, Quantity]:
        labels = tuple(str(i + 1) for i in range(len(self.force)))
        value = self.force[0] if len(self.force) == 1 else self.force
        return {"force": Quantity(value, "", labels=labels if len(labels) > 1 else ())}

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        motion, data, joints = at.motion, at.data, at.joints
        joint, force = joints["joint"], data["force"]
        speeds = motion.u(joint).rows
        if force.rows * force.columns != speeds:
            raise ModelError(
                f"joint_force on joint '{self.joint}': force has "
                f"{counted(len(self.force), 'value')} for a joint of {counted(speeds, 'speed')}; "
                f"give {speeds}"
            )
        column = Matrix(motion.graph, speeds, 1, force.nodes)
        return (Action(joint_loads=(JointLoad(joint, column),)),)

    def formulas(self, at: Places) -> Lines:
        return (("force along the joint", "tau = f"),)
