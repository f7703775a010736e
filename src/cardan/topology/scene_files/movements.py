"""Joints of a scene as joints of URDF, in a row where they have several coordinates."""

from __future__ import annotations

from typing import NamedTuple

from ...elements.joints.joint import Reversed
from ..system import Joint
from .numeric_scene import NumericScene

# kind of a joint -> that of its <joint>, and the quantity that is its axis
SINGLE = {
    "revolute": ("turn", "axis"),
    "gear": ("turn", "axis"),
    "prismatic": ("slide", "axis"),
    "planar": ("planar", "normal"),
}
AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


class Movement(NamedTuple):
    """One <joint> of those that stand for a joint.

    Attributes:
        name: Of the <joint>.
        kind: ``"turn"`` or ``"slide"``, whose types depend on limits; else its type.
        axis: Its direction; none of fixed and floating ones.
    """

    name: str
    kind: str
    axis: tuple[float, ...] = ()


def movements_of(joint: Joint, scene: NumericScene) -> tuple[tuple[Movement, ...], tuple[str, ...]]:
    """The joints that stand for a joint, from the inner body to the outer one.

    Args:
        joint: Of the tree.
        scene: Its scene in numbers.

    Returns:
        The joints, and what they do not say.
    """
    element, name = joint.element, joint.name
    if element.kind == "free":
        angles = getattr(element, "rotation", "quaternion") != "quaternion"
        losses = ("its angles; programs have their own coordinates for it",) if angles else ()
        return (Movement(name, "floating"),), losses
    # a joint that is told backward is another one, unless its kind has a line
    single = None if isinstance(element, Reversed) else SINGLE.get(element.kind)
    if single is not None:
        kind, quantity = single
        axis = scene.numbers(joint.data[quantity][2]).tolist()
        return (Movement(name, kind, tuple(axis)),), ()
    if steps := element.steps():
        row = [
            Movement(
                f"{name}.{step.component}",
                "slide" if step.slides else "turn",
                scene.direction(step.axis),
            )
            for step in steps
        ]
        return tuple(row), ()
    if element.kind == "spherical" and not isinstance(element, Reversed):
        loss = (
            "its coordinates; three joints about x, y, z stand for it, which are singular where "
            "the second is at a quarter turn"
        )
        return tuple(Movement(f"{name}.{x}", "turn", axis) for x, axis in AXES.items()), (loss,)
    return (Movement(name, "fixed"),), ("its motion; it is fixed in the file",)
