"""Motors: inputs that push joints."""

from __future__ import annotations

from collections.abc import Mapping

from ....elements.forces.joint_force import JointForce
from ....errors import ModelError, near
from ...scene import SceneRecord
from ..document import Element
from .ignored import Unread
from .joints import Hinge


def add(
    scene: SceneRecord, element: Element, name: str, hinges: Mapping[str, Hinge], unread: Unread
) -> None:
    """A <motor> on a joint with one coordinate becomes an input times its gear.

    Args:
        name: Where it has none. An input is not called like a joint, whose coordinate has the
            name: ``hip`` is ``hip.motor`` then.

    Raises:
        ModelError: its joint does not exist.
    """
    raw = element.raw
    joint = raw.get("joint")
    if raw.tag != "motor" or joint is None:
        unread.element(raw, "actuator")
        return
    if joint not in hinges:
        listed = near(joint, hinges).replace(" Known:", " Joints:")
        raise ModelError(f"{element.where}: joint '{joint[:80]}' does not exist.{listed}")
    if not hinges[joint].single:
        unread.element(raw, f"{hinges[joint].kind} joint")
        return
    unread.attributes(raw)
    name = raw.get("name") or name
    if name in scene.joints or name == "t":
        name += ".motor"
    gear = element.several("gear", 1, 6, "1")[0]
    control = scene.input(name)
    scene.force(name, JointForce(joint, gear * control if gear != 1 else control))
