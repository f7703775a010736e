"""Joints of several coordinates that are prescribed: chains of joints with one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, TypeGuard

from ..elements.joints.joint import Joint as JointElement
from ..elements.joints.joint import Step
from ..elements.joints.prismatic import Prismatic
from ..elements.joints.revolute import Revolute
from ..errors import ModelError
from .frame import Place

if TYPE_CHECKING:
    from .connections import Joint
    from .scene import SceneRecord


def several(motion: object) -> TypeGuard[Sequence[object]]:
    """True when ``prescribed=`` says a value for each of several coordinates."""
    return isinstance(motion, Sequence) and not isinstance(motion, str)


def chain(
    scene: SceneRecord,
    name: str,
    kind: JointElement,
    ends: tuple[Place | str, Place | str],
    motion: Sequence[object],
    further: Mapping[str, object],
) -> Joint:
    """The joints ``<name>.<coordinate>`` and bodies without mass between them, all or none.

    Args:
        scene: The model.
        name, kind, ends: Of the joint that is meant.
        motion: A value for each of its coordinates; None for one that moves freely.
        further: Other arguments of the joint, which must be None.

    Returns:
        The last of the joints, whose child is the child.

    Raises:
        ModelError: the kind is not a turning and sliding one after the other, or another number.
    """
    who = f"joint '{name}' ({kind.kind})"
    for key, value in further.items():
        if value is not None:
            raise ModelError(
                f"{who}: {key}= does not go with prescribed= for several coordinates; make a chain "
                "of joints with one coordinate each"
            )
    names = [component.name for component in kind.coordinates]
    if not kind.steps():
        raise ModelError(
            f"{who}: prescribed= moves the coordinates of universal, cylindrical and planar "
            'joints, and of spherical and free ones in angles, such as cd.Free("ZYX"); else make '
            "a chain of joints with one coordinate each"
        )
    if len(motion) != len(names):
        raise ModelError(
            f"{who}: prescribed= has {len(motion)} values; give {len(names)}, for "
            f"{', '.join(names)}; None where it moves freely"
        )
    before = dict(scene.bodies), dict(scene.joints)
    try:
        return _build_chain(scene, name, kind.steps(), ends, dict(zip(names, motion, strict=True)))
    except ModelError:
        scene.bodies, scene.joints = before
        raise


def _build_chain(
    scene: SceneRecord,
    name: str,
    steps: Sequence[Step],
    ends: tuple[Place | str, Place | str],
    motion: Mapping[str, object],
) -> Joint:
    place = ends[0]
    for k, step in enumerate(steps):
        step_name = f"{name}.{step.component}"
        child_of_step = ends[1] if k == len(steps) - 1 else scene.body(step_name)
        element = Prismatic(step.axis) if step.slides else Revolute(step.axis)
        joint = scene.joint(
            step_name, element, place, child_of_step, prescribed=motion[step.component]
        )
        place = child_of_step
    return joint
