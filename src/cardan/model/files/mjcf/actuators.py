"""Motors: inputs that push joints."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ....elements.forces.joint_force import JointForce
from ....errors import ModelError, near
from ...model import Model
from ..document import Element
from .joints import Hinge
from .unread import Unread


def motors(
    scene: Model, actuators: Sequence[Element], hinges: Mapping[str, Hinge], unread: Unread
) -> None:
    """Every <motor> on a joint with one coordinate becomes an input times its gear.

    Raises:
        ModelError: its joint does not exist.
    """
    for number, element in enumerate(actuators):
        raw = element.raw
        joint = raw.get("joint")
        if raw.tag != "motor" or joint is None:
            unread.element(raw, "actuator")
            continue
        if joint not in hinges:
            listed = near(joint, hinges).replace(" Known:", " Joints:")
            raise ModelError(f"{element.where}: joint '{joint[:80]}' does not exist.{listed}")
        if not hinges[joint].single:
            unread.element(raw, f"{hinges[joint].kind} joint")
            continue
        unread.attributes(raw)
        name = raw.get("name") or f"motor{number}"
        gear = element.several("gear", 1, 6, "1")[0]
        control = scene.input(name)
        scene.force(name, JointForce(joint, gear * control if gear != 1 else control))
